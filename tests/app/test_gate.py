"""Who may connect, and that nothing is served without the gate."""

import http.client
import logging
import socket
import sys
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest
import viser
import websockets.asyncio.server
import websockets.datastructures
import websockets.exceptions
from websockets.exceptions import InvalidStatus

from app.gate import address, gate
from app.gate.address import authorities, own_authorities, public_address
from app.gate.gate import Gate, GatedServer, GateError, PortBusy, exposure, open_server, page_addresses
from app.pages.sandbox.assets import page_files
from tests.app.hostile import HANDSHAKE, Sandbox, answer, eventually, own, served, status
from tests.app.inside import only_page, viser_infra

LOGGER = logging.getLogger(gate.__name__)


def is_listening(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port), timeout=5).close()
    except ConnectionRefusedError:
        return False
    return True


def body(port: int, headers: dict[str, str], path: str = "/") -> tuple[int, str]:
    """The status of an answer, and its text."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    connection.request("GET", path, headers=headers)
    response = connection.getresponse()
    text = response.read().decode()
    connection.close()
    return response.status, text


def test_the_page_is_served_and_cannot_be_framed(sandbox: Sandbox) -> None:
    code, headers = answer(sandbox.port, [("Host", f"localhost:{sandbox.port}")])
    assert code == 200
    assert headers["X-Frame-Options"] == "DENY"
    assert headers["Content-Security-Policy"] == "frame-ancestors 'none'"
    assert headers["X-Content-Type-Options"] == "nosniff"


def test_what_is_kept_of_a_class_s_pages_on_the_way_has_nothing_of_the_class() -> None:
    """Browsers and proxies may keep them: all that is told of a class goes by the connection."""
    with served(files=page_files()) as server:
        port = server.get_port()
        host = {"Host": f"localhost:{port}"}
        asked = ("ABCD", "ABCD&as=desk", "ABCD&as=wall", "EFGH&as=seat")
        pages = {body(port, host, f"/?room={room}") for room in asked}
        checks = {body(port, host, f"/check?room={code}") for code in ("ABCD", "EFGH")}
        for path in ("/?room=ABCD&as=desk", "/check?room=ABCD"):
            _, headers = answer(port, list(host.items()), path)
            assert headers["Cache-Control"] == "no-cache"
            assert headers["Referrer-Policy"] == "no-referrer"
    # Whatever was asked for, the same came.
    for (code, _), *others in (pages, checks):
        assert code == 200
        assert not others


@pytest.mark.parametrize("host", ["localhost", "LOCALHOST", "127.0.0.1", "[::1]"])
def test_the_page_may_connect_by_every_name_of_this_machine(sandbox: Sandbox, host: str) -> None:
    assert status(sandbox.port, own(sandbox.port, host)) == 101


@pytest.mark.parametrize(
    "hosts",
    [
        ["evil.example:{port}"], ["evil.example"], ["127.0.0.2:{port}"],
        ["localhost.evil.example:{port}"], ["127.0.0.1:{port}", "127.0.0.1:{port}"],
        ["127.0.0.1:{port}", "evil.example"], ["0.0.0.0:{port}"], [""], [],
    ],
)  # fmt: skip
def test_a_foreign_host_is_refused(sandbox: Sandbox, hosts: list[str]) -> None:
    user = sandbox.user()
    named = [host.format(port=sandbox.port, wrong=sandbox.port ^ 1) for host in hosts]
    headers = [("Host", host) for host in named]
    assert status(sandbox.port, headers) == 421
    origin = [("Origin", f"http://{named[0]}")] if named else []
    assert status(sandbox.port, [*headers, *origin, *HANDSHAKE]) == 421
    assert sandbox.refuses("host", 2)
    assert user.works()


@pytest.mark.parametrize(
    "origins",
    [
        ["http://evil.example"], ["http://127.0.0.1"], ["http://127.0.0.1:{wrong}"],
        ["http://localhost:{port}"], ["https://127.0.0.1:{port}"],
        ["http://127.0.0.1:{port}.evil.example"], ["http://127.0.0.1:{port}", "http://evil.example"],
        ["http://127.0.0.1:{port}", "http://127.0.0.1:{port}"],
        ["http://127.0.0.1:{port}, http://evil.example"], ["null"], [""], [],
    ],
)  # fmt: skip
def test_a_foreign_page_may_not_connect(sandbox: Sandbox, origins: list[str]) -> None:
    user = sandbox.user()
    headers = [("Origin", o.format(port=sandbox.port, wrong=sandbox.port ^ 1)) for o in origins]
    assert status(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}"), *headers, *HANDSHAKE]) == 403
    assert sandbox.refuses("origin")
    assert user.works()


@pytest.mark.parametrize("upgrade", [["h2c"], ["websocket, h2c"], ["WebSocket"], ["websocket", "websocket"]])
def test_a_muddled_upgrade_is_refused(sandbox: Sandbox, upgrade: list[str]) -> None:
    headers = [header for header in own(sandbox.port) if header[0] != "Upgrade"]
    assert status(sandbox.port, [*headers, *(("Upgrade", value) for value in upgrade)]) == 400
    assert sandbox.refuses("upgrade")


@pytest.mark.parametrize(
    "query", ["websocket=ws://evil.example", "playbackPath=//evil.example", "%77ebsocket"]
)
@pytest.mark.parametrize("path", ["/", "/index.html", "//evil.example/"])
def test_a_link_cannot_make_the_page_obey_another_server(sandbox: Sandbox, query: str, path: str) -> None:
    code, headers = answer(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}")], f"{path}?{query}")
    assert (code, headers["Location"]) == (307, "./")


@pytest.mark.parametrize(
    "path",
    [
        "/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%5c..%5cx", "//etc/passwd", "/C:/x",
        "/%00", "/" + "a" * 5000, "http://evil.example/", "*", "/package.json",
    ],
)  # fmt: skip
def test_nothing_but_the_page_is_served(sandbox: Sandbox, path: str) -> None:
    assert status(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}")], path) == 404
    assert sandbox.refuses("path")


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS", "HEAD", "nonsense"])
def test_other_methods_are_refused(sandbox: Sandbox, method: str) -> None:
    user = sandbox.user()
    assert status(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}")], method=method) in (0, 400, 405)
    assert user.works()


def test_requests_that_make_no_sense_leave_no_trace(
    sandbox: Sandbox, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    # viser adds a filter of its own, but only with the first page it serves.
    own_filters = [each for each in LOGGER.filters if getattr(each, "__module__", "") == gate.__name__]
    monkeypatch.setattr(LOGGER, "filters", own_filters)
    for nonsense in (b"\0\1\2\r\n\r\n", b"GET / HTTP/9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\r\n\r\n"):
        with socket.create_connection(("127.0.0.1", sandbox.port), timeout=20) as connection:
            connection.sendall(nonsense)
            while connection.recv(4096):
                pass
    assert not caplog.records
    assert sandbox.user().works()


def test_tabs_are_limited(sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "MAX_TABS", 3)
    first, *others = [sandbox.user() for _ in range(3)]
    with pytest.raises(InvalidStatus) as refused:
        sandbox.page()
    assert refused.value.response.status_code == 503
    assert b"room for 3 pages" in refused.value.response.body
    assert all(user.works() for user in (first, *others))
    first.page.close()
    eventually(lambda: status(sandbox.port, own(sandbox.port)) == 101)


def test_a_handshake_that_fails_takes_no_place(sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "MAX_TABS", 1)
    without_key = [header for header in own(sandbox.port) if header[0] != "Sec-WebSocket-Key"]
    for _ in range(3):
        assert status(sandbox.port, without_key) == 400
    eventually(lambda: status(sandbox.port, own(sandbox.port)) == 101)


def test_a_busy_port_is_reported_with_the_next_free_one(sandbox: Sandbox) -> None:
    with pytest.raises(PortBusy) as busy:
        open_server("127.0.0.1", sandbox.port)
    assert busy.value.port == sandbox.port
    assert busy.value.next_free != sandbox.port
    assert str(busy.value) == (
        f"Port {sandbox.port} is already in use; the next free one is {busy.value.next_free}."
    )
    server = open_server("127.0.0.1", busy.value.next_free)
    assert server.get_port() == busy.value.next_free
    server.stop()


@pytest.mark.parametrize(("host", "port"), [("host.invalid", 0), ("192.0.2.1", 0), ("127.0.0.1", 70000)])
def test_an_impossible_address_is_one_sentence(host: str, port: int) -> None:
    with pytest.raises(GateError, match=r"^[^\n]+\.$"):
        open_server(host, port)


def test_every_address_of_the_machine_is_served_by_its_own_names_only() -> None:
    with served("0.0.0.0", extra_hosts=["Rope.example", "localhost:9000"]) as server:
        port = server.get_port()
        for host in (f"127.0.0.1:{port}", f"rope.example:{port}", f"{socket.gethostname()}:{port}"):
            assert status(port, [("Host", host), ("Origin", f"http://{host}"), *HANDSHAKE]) == 101
        assert status(port, [("Host", "localhost:9000")]) == 200
        for host in (f"evil.example:{port}", f"192.0.2.1:{port}", "rope.example:9000", f"0.0.0.0:{port}"):
            assert status(port, [("Host", host)]) == 421


@pytest.mark.parametrize("host", ["localhost:9000", "127.0.0.1:9000", "[::1]:9000", "localhost"])
def test_a_tunnel_may_end_at_any_port_of_this_machine(sandbox: Sandbox, host: str) -> None:
    origin = ("Origin", f"http://{host}")
    assert status(sandbox.port, [("Host", host)]) == 200
    assert status(sandbox.port, [("Host", host), origin, *HANDSHAKE]) == 101
    # Another program's page on this machine has another port.
    assert status(sandbox.port, [("Host", host), ("Origin", "http://localhost:3000"), *HANDSHAKE]) == 403
    assert status(sandbox.port, [("Host", f"localhost:{sandbox.port}"), origin, *HANDSHAKE]) == 403


SCHOOL = "https://school.example/lab/"


@pytest.fixture
def behind() -> Iterator[GatedServer]:
    """A server that is reached through a proxy."""
    with served(public_url="HTTPS://School.example/lab", files=page_files()) as server:
        yield server


def test_a_proxy_may_pass_on_its_own_name_or_the_server_s(behind: GatedServer) -> None:
    port = behind.get_port()
    for host in ("school.example", "school.example:443", f"127.0.0.1:{port}", "localhost:8080"):
        for path in ("/", "/lab/", "/lab/index.html", "/s", "/lab/s"):
            assert status(port, [("Host", host)], path) == 200
        headers = [("Host", host), ("Origin", "https://school.example"), *HANDSHAKE]
        assert status(port, headers, "/lab/at/" + 32 * "a") == 101


@pytest.mark.parametrize(
    ("host", "origin"),
    [
        ("school.example", "http://school.example"),
        ("school.example", "https://school.example:8443"),
        ("school.example", "https://evil.example"),
        ("school.example", "null"),
        ("127.0.0.1", "http://school.example"),
    ],
)
def test_a_proxy_s_page_is_taken_at_its_word(behind: GatedServer, host: str, origin: str) -> None:
    assert status(behind.get_port(), [("Host", host), ("Origin", origin), *HANDSHAKE]) == 403
    assert status(behind.get_port(), [("Host", "evil.example"), ("Origin", origin), *HANDSHAKE]) == 421
    assert status(behind.get_port(), [("Host", "school.example:8443")]) == 421


def test_a_refusal_names_the_remedy(sandbox: Sandbox) -> None:
    code, text = body(sandbox.port, {"Host": "school.example"})
    assert code == 421
    assert "start it with --allow-host school.example" in text
    assert "--public-url https://school.example/" in text
    here = f"127.0.0.1:{sandbox.port}"
    code, text = body(sandbox.port, {"Host": here, "X-Softrod-Origin": "https://school.example"}, "/reach")
    assert code == 403
    assert "start softrod with --public-url https://school.example/" in text
    assert body(sandbox.port, {"Host": here, "X-Softrod-Origin": f"http://{here}"}, "/reach") == (200, "")
    # What is no address is not repeated.
    for name in ("<script>", "a b", "x" * 300):
        code, text = body(sandbox.port, {"Host": name})
        assert (code, name in text) == (421, False)
        code, text = body(sandbox.port, {"Host": here, "X-Softrod-Origin": name}, "/reach")
        assert (code, name in text) == (403, False)


NO_URLS = (
    "school.example", "ftp://school.example", "https://", "https://.../", "https://a/?b", "https://a/#b",
    "https://a/../b/", "https://a//b", "https://a:0/", "https://a:99999/", "https://user:word@a/",
)  # fmt: skip
NO_NAMES = ("http://laptop.local", "a/b", "", "a:0", "a:99999", "*", "a b", "...")


@pytest.mark.parametrize(
    ("option", "given"),
    [*(("public-url", {"public_url": url}) for url in NO_URLS)]
    + [("allow-host", {"extra_hosts": [name]}) for name in NO_NAMES],
)
def test_what_is_no_address_or_name_is_one_sentence(option: str, given: dict[str, Any]) -> None:
    with pytest.raises(GateError, match=rf"^--{option}: [^\n]+\.$"), served(**given):
        pass


def test_a_proxy_is_an_exposure() -> None:
    said = exposure("127.0.0.1", public_address(SCHOOL))
    assert said is not None
    assert SCHOOL in said
    assert "Only pages with #owner= in their address can change your scenes." in said
    assert "There is no password" in said


def test_public_addresses_are_as_browsers_write_them() -> None:
    found = public_address("https://School.example:443/lab")
    assert (found.url, found.origin, found.folder) == (SCHOOL, "https://school.example", "/lab/")
    assert public_address("http://[2001:db8::1]:8080").url == "http://[2001:db8::1]:8080/"
    # Browsers leave out HTTP's own port.
    assert authorities("laptop.local:80", 8080) == {"laptop.local", "laptop.local:80"}


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has 127.0.0.2 from the start")
def test_the_address_that_a_request_came_in_at_is_its_own() -> None:
    with served("0.0.0.0") as server:
        # 127.0.0.2 stands in for the address of a network card.
        host = [("Host", f"127.0.0.2:{server.get_port()}")]
        assert status(server.get_port(), host, address="127.0.0.2") == 200
        assert status(server.get_port(), host, address="127.0.0.1") == 421


def test_every_address_that_can_be_typed_is_printed_and_let_in(monkeypatch: pytest.MonkeyPatch) -> None:
    class Probe(socket.socket):
        """Knows two networks, whatever machine this is."""

        def connect(self, address: Any) -> None:
            if not address[0].startswith(("192.168.", "10.")):
                raise OSError("no route")
            self._own = "192.168.1.7" if address[0].startswith("192.168.") else "10.0.0.4"

        def getsockname(self) -> Any:
            return self._own, 1234

    monkeypatch.setattr(address, "interfaces", dict)
    monkeypatch.setattr(socket, "socket", Probe)
    monkeypatch.setattr(
        socket, "getaddrinfo", lambda *_, **__: [(socket.AF_INET, 1, 6, "", ("127.0.1.1", 0))]
    )
    typed = page_addresses("0.0.0.0", 8080)
    assert typed == ["http://127.0.0.1:8080", "http://10.0.0.4:8080", "http://192.168.1.7:8080"]
    known = own_authorities("0.0.0.0", "0.0.0.0", 8080, ())
    assert {address.removeprefix("http://") for address in typed} <= known
    assert page_addresses("127.0.0.1", 8080) == ["http://127.0.0.1:8080"]
    assert page_addresses("::", 8080) == ["http://[::1]:8080"]


def test_the_network_that_others_are_in_goes_before_tunnels_and_containers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A laptop with a VPN and containers, whose hotspot leads nowhere."""
    names = {
        "127.0.0.1": "lo",
        "172.17.0.1": "docker0",
        "10.8.0.2": "tun0",
        "10.42.0.1": "wlan0",
    }
    monkeypatch.setattr(address, "interfaces", lambda: names)

    class Probe(socket.socket):
        def connect(self, _: Any) -> None:
            """Everything goes through the tunnel."""

        def getsockname(self) -> Any:
            return "10.8.0.2", 1234

    monkeypatch.setattr(socket, "socket", Probe)
    monkeypatch.setattr(socket, "getaddrinfo", lambda *_, **__: [])
    assert address.local_addresses() == ["10.42.0.1", "10.8.0.2", "172.17.0.1"]


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has an interface of this name")
def test_the_system_names_its_interfaces() -> None:
    assert address.interfaces()["127.0.0.1"] == "lo"


def test_a_network_address_is_an_exposure_and_this_machine_alone_is_none() -> None:
    for host in ("127.0.0.1", "localhost", "::1", "127.8.8.8"):
        assert exposure(host) is None
    for host in ("0.0.0.0", "::", "192.0.2.1", "host.invalid", ""):
        assert "no password" in (exposure(host) or ""), host


@pytest.mark.parametrize(
    ("host", "public", "said", "unsaid"),
    [
        ("127.0.0.1", None, "Only this computer", "not encrypted"),
        ("0.0.0.0", None, "the traffic is not encrypted", "Only this computer"),
        ("127.0.0.1", "http://school.example/", "the traffic is not encrypted", "Only this computer"),
        ("127.0.0.1", SCHOOL, "can take a seat", "not encrypted"),
    ],
)
def test_what_a_class_exposes(host: str, public: str | None, said: str, unsaid: str) -> None:
    text = address.class_exposure(host, None if public is None else public_address(public))
    assert said in text
    assert unsaid not in text


def test_nothing_is_served_before_the_gate_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate.Gate, "open", lambda self, server: None)
    with served() as server:
        assert status(server.get_port(), own(server.get_port())) == 503


def test_another_version_of_viser_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(viser, "__version__", "1.2.0")
    with pytest.raises(GateError, match=r"1\.1\.1 is needed, but 1\.2\.0"):
        open_server("127.0.0.1", 0)


def test_a_viser_that_passes_by_the_gate_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    ports: list[int] = []
    real_serve = websockets.asyncio.server.serve

    def passing_by(handler: Any, host: str, port: int, **options: Any) -> Any:
        ports.append(port)
        return real_serve(handler, host, port, **options)

    shadow = SimpleNamespace(
        asyncio=SimpleNamespace(server=SimpleNamespace(serve=passing_by)),
        exceptions=websockets.exceptions,
        datastructures=websockets.datastructures,
    )
    monkeypatch.setattr(viser_infra, "websockets", shadow)
    with pytest.raises(GateError, match="by way of the gate"):
        open_server("127.0.0.1", 0)
    assert ports
    assert not any(is_listening(port) for port in ports)


def test_websockets_is_left_as_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    real_serve = websockets.asyncio.server.serve
    server = open_server("127.0.0.1", 0)
    assert websockets.asyncio.server.serve is real_serve
    server.stop()

    def failing(self: object, **options: object) -> None:
        assert websockets.asyncio.server.serve is not real_serve
        raise RuntimeError("viser failed")

    monkeypatch.setattr(viser.ViserServer, "__init__", failing)
    with pytest.raises(RuntimeError, match="viser failed"):
        open_server("127.0.0.1", 0)
    assert websockets.asyncio.server.serve is real_serve


def test_a_stopped_server_leaves_its_port(sandbox: Sandbox) -> None:
    assert is_listening(sandbox.port)
    sandbox.server.stop()
    assert not is_listening(sandbox.port)


def test_a_page_is_of_this_machine_only_if_no_other_can_connect_and_no_proxy_is_between() -> None:
    for extra, loopback in (([], True), (["school.example"], False)):
        with served(extra_hosts=extra) as server:
            assert server.gate.loopback == loopback

    def is_local(loopback: bool, *headers: tuple[str, str]) -> bool:
        gate = Gate(frozenset(), {}, loopback=loopback)
        request = SimpleNamespace(path="/", headers=websockets.datastructures.Headers(headers))
        only_page(gate, 7, request)
        assert not gate.visit(8).is_local  # it has gone
        return gate.visit(7).is_local

    assert is_local(True, ("Host", "127.0.0.1:8080"))
    assert not is_local(False, ("Host", "127.0.0.1:8080"))
    for name in ("X-Forwarded-For", "forwarded", "X-Real-IP", "Via"):
        assert not is_local(True, ("Host", "127.0.0.1:8080"), (name, ""))
