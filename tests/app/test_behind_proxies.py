"""Two servers behind one proxy, as a school runs them: a room stays on its server, and a page works."""

from __future__ import annotations

import http.client
import re
import secrets
import ssl
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

import msgspec
import pytest
from websockets.exceptions import InvalidStatus

import sim
from app.classroom import kept
from app.classroom.live import Class, Classes
from app.server.serve import serving
from app.wire.from_page import Who
from studies.bench.client import Page, is_frame
from tests.app.hostile import eventually
from tests.app.line_page import LinePage
from tests.browser.wires import certified
from tests.proxies import FOLDERS, Kind, Proxy

PUPILS = 3


@dataclass
class School:
    """The proxy, and what is behind it, by its folders; `name`: what it is called."""

    proxy: Proxy
    tls: ssl.SSLContext
    rooms: dict[str, Class]

    name: str = "localhost"

    def page(self, folder: str, query: str) -> Page:
        path = f"{folder[1:]}at/{secrets.token_hex(16)}?{query}"
        return Page(self.proxy.port, path=path, tls=self.tls, name=self.name)

    def seat(self, folder: str, query: str, who: Who) -> tuple[str, str]:
        """The name that a new page has in its class, and its problem."""
        host = f"{self.name}:{self.proxy.port}"
        page = LinePage(self.proxy.port, query, host, secrets.token_hex(16), folder, self.tls).begin()
        page.say(msgspec.json.encode(who).decode())
        found = eventually(lambda: [one for one in page.told("seat") if one["name"] or one["problem"]])[-1]
        page.close()
        return found["name"], found["problem"]

    def get(self, path: str, **headers: str) -> tuple[int, str]:
        connection = http.client.HTTPSConnection("localhost", self.proxy.port, timeout=20, context=self.tls)
        connection.request("GET", path, headers={"Host": f"{self.name}:{self.proxy.port}", **headers})
        response = connection.getresponse()
        text = response.read().decode()
        connection.close()
        return response.status, text


def _trusting(certificate: Path | str) -> ssl.SSLContext:
    """A context for the pages here, which trusts a certificate.

    A page reads in a thread of its own. In TLS 1.3 a server sends tickets after the handshake, and before
    Python 3.13 a read of these beside a write may wait for ever.
    """
    context = ssl.create_default_context(cafile=certificate)
    context.maximum_version = ssl.TLSVersion.TLSv1_2
    return context


@pytest.fixture(params=get_args(Kind))
def school(
    request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[School]:
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path / "classes")
    certificate, key = certified(tmp_path)
    proxy = Proxy(request.param, tmp_path, certificate, key)
    ports: list[int] = []
    rooms: dict[str, Class] = {}
    with ExitStack() as stack:
        for folder in FOLDERS:
            classes = Classes()
            rooms[folder] = classes.begin((sim.load_scene("lesson-hooke"),))
            server, *_ = stack.enter_context(
                serving(sim.rope(), "127.0.0.1", 0, public_url=proxy.url(folder), classes=classes)
            )
            ports.append(server.get_port())
        stack.enter_context(proxy.leading(*ports))
        yield School(proxy, _trusting(certificate), rooms)


def test_each_room_is_on_its_server_and_stays_there(school: School) -> None:
    names: dict[str, str] = {}
    for folder, room in school.rooms.items():
        query = f"room={room.room.code}"
        status, page = school.get(f"{folder}?{query}")
        assert status == 200
        script = re.search(r'src="(softrod/\w+/pages/classroom/main.js)"', page)
        assert script is not None
        assert school.get(folder + script[1])[0] == 200
        for i in range(PUPILS):
            names[folder + str(i)] = school.seat(folder, query, Who(f"{folder[1]}{i:031x}"))[0]
    assert [len(room.room.seats) for room in school.rooms.values()] == [PUPILS, PUPILS]
    # A reload, and an outage, are new connections.
    for folder, room in school.rooms.items():
        for i in range(PUPILS):
            who = Who(f"{folder[1]}{i:031x}")
            assert school.seat(folder, f"room={room.room.code}", who)[0] == names[folder + str(i)]
    assert [len(room.room.seats) for room in school.rooms.values()] == [PUPILS, PUPILS]
    # A room is in its folder only.
    here, there = FOLDERS
    assert "There is no class" in school.seat(here, f"room={school.rooms[there].room.code}", Who("f" * 32))[1]


@pytest.mark.parametrize("kind", get_args(Kind))
def test_a_page_works_with_the_option_and_says_which_one_it_lacks(kind: Kind, tmp_path: Path) -> None:
    """By TLS, in a folder, under a name that is not the machine's own."""
    certificate, key = certified(tmp_path)
    proxy = Proxy(kind, tmp_path, certificate, key)
    name = "school.example"
    known, unknown = FOLDERS
    with ExitStack() as stack:
        servers = [
            stack.enter_context(serving(sim.rope(), "127.0.0.1", 0, public_url=url))[0]
            for url in (proxy.url(known, name), None)
        ]
        stack.enter_context(proxy.leading(*(server.get_port() for server in servers)))
        school = School(proxy, _trusting(certificate), {}, name)
        site = proxy.url("", name)
        origin = {"X-Softrod-Origin": site}

        status, page = school.get(f"{known}s")  # as of a link to a scene
        script = re.search(r'src="(softrod/\w+/pages/sandbox/main.js)"', page)
        assert status == 200
        assert script is not None
        assert school.get(known + script[1])[0] == 200
        with school.page(known, "scene=ring") as moving:
            moving.wait_for(is_frame)
        assert school.get(f"{known}reach", **origin) == (200, "")
        assert not servers[0].gate.advice

        # nginx goes by the server's own name, so that there is a page; a browser does not tell that why it is
        # refused, so it asks. Caddy passes the visitor's name on.
        refusal = 403 if kind == "nginx" else 421
        assert school.get(unknown)[0] == (200 if kind == "nginx" else refusal)
        with pytest.raises(InvalidStatus) as refused, school.page(unknown, ""):
            pass
        assert refused.value.response.status_code == refusal
        status, said = school.get(f"{unknown}reach", **origin)
        assert status == refusal
        assert f"--public-url {site}/ (and the folder, if the page is in one)" in " ".join(said.split())
        assert servers[1].gate.advice == [said.strip()]
