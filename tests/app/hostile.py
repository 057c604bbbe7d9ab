"""A client that speaks to the server as its page does, or as no page would."""

import queue
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

import msgpack
import viser
import zstandard
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.typing import Origin, Subprotocol

from app.gate.gate import GatedServer, open_server
from tests.app.inside import uuid_of

T = TypeVar("T")

PATIENCE = 30.0
"""Seconds to wait for what must happen; only a server that hangs makes a test wait this long."""

HANDSHAKE = [
    ("Upgrade", "websocket"),
    ("Connection", "Upgrade"),
    ("Sec-WebSocket-Key", "AAAAAAAAAAAAAAAAAAAAAA=="),
    ("Sec-WebSocket-Version", "13"),
    ("Sec-WebSocket-Protocol", f"viser-v{viser.__version__}"),
]

CAMERA: dict[str, Any] = {
    "type": "ViewerCameraMessage",
    "wxyz": [1, 0, 0, 0.0],
    "position": [0.0, 0.0, -5],
    "fov": 0.75,
    "near": 0.01,
    "far": 1000,
    "image_height": 600,
    "image_width": 800,
    "look_at": [0, 0, 0],
    "up_direction": [0, -1, 0],
}


def pack(value: Any) -> bytes:
    """Encode a value as the page does."""
    packed = msgpack.packb(value)
    assert packed is not None
    return packed


def eventually(condition: Callable[[], T | None]) -> T:
    """Wait until the condition gives something, and return that."""
    deadline = time.monotonic() + PATIENCE
    while not (result := condition()):
        assert time.monotonic() < deadline, "it never happened"
        time.sleep(0.005)
    return result


@contextmanager
def served(host: str = "127.0.0.1", **options: Any) -> Iterator[GatedServer]:
    """A server behind its gate, at any free port."""
    server = open_server(host, 0, **options)
    try:
        yield server
    finally:
        server.stop()


def own(port: int, host: str = "127.0.0.1") -> list[tuple[str, str]]:
    """The headers with which a page of the server connects."""
    return [("Host", f"{host}:{port}"), ("Origin", f"http://{host}:{port}"), *HANDSHAKE]


def status(port: int, headers: list[tuple[str, str]], path: str = "/", **options: str) -> int:
    """The status with which a request of exactly these headers is answered; 0 if it is not answered."""
    return answer(port, headers, path, **options)[0]


def answer(
    port: int,
    headers: list[tuple[str, str]],
    path: str = "/",
    *,
    method: str = "GET",
    address: str = "127.0.0.1",
) -> tuple[int, dict[str, str]]:
    """The status and the headers with which a request of exactly these headers is answered."""
    lines = [f"{method} {path} HTTP/1.1", *(f"{name}: {value}" for name, value in headers), "", ""]
    with socket.create_connection((address, port), timeout=PATIENCE) as connection:
        connection.sendall("\r\n".join(lines).encode())
        head = b""
        while b"\r\n\r\n" not in head:
            chunk = connection.recv(4096)
            if not chunk:
                return 0, {}
            head += chunk
    first, *rest = head.partition(b"\r\n\r\n")[0].decode().split("\r\n")
    return int(first.split()[1]), dict(line.split(": ", 1) for line in rest)


class HostilePage:
    """A connection such as viser's page makes, and what the server has for it."""

    def __init__(self, port: int, path: str = "", source: str = "127.0.0.1") -> None:
        self.messages: list[dict[str, Any]] = []
        self.signs = 0  # of life: batches without a message
        self.socket = connect(
            f"ws://127.0.0.1:{port}{path}",
            origin=Origin(f"http://127.0.0.1:{port}"),
            subprotocols=[Subprotocol(HANDSHAKE[-1][1])],
            compression=None,
            max_size=None,
            open_timeout=60.0,  # a machine may be busy
            proxy=None,
            source_address=(source, 0),
        )
        self.port = self.socket.local_address[1]
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        try:
            for data in self.socket:
                assert isinstance(data, bytes)
                size, compressed = struct.unpack_from("<QQ", data)
                packed = zstandard.decompress(data[16 : 16 + compressed], max_output_size=size)
                batch = msgpack.unpackb(packed)["messages"]
                self.messages += batch
                self.signs += not batch
        except (ConnectionClosed, OSError):
            pass

    def send(self, *messages: dict[str, Any]) -> None:
        """Send messages as the page encodes them."""
        for message in messages:
            self.send_raw(pack(message))

    def send_raw(self, data: bytes | str) -> None:
        """Send bytes as a binary frame, text as a text frame."""
        self.socket.send(data)

    def received(self, message_type: str) -> list[dict[str, Any]]:
        """What the server has sent of this type."""
        return [message for message in list(self.messages) if message["type"] == message_type]

    def named(self, name: str) -> list[dict[str, Any]]:
        """What the server has sent of the node of that name."""
        return [message for message in list(self.messages) if message.get("name") == name]

    def is_cut(self) -> bool:
        """Whether the connection comes to its end."""
        self._reader.join(PATIENCE)
        return not self._reader.is_alive()

    def close(self) -> None:
        """Leave."""
        self.socket.close()


class User:
    """A page, and the handles that the server has made for it alone."""

    def __init__(self, page: HostilePage, client: viser.ClientHandle) -> None:
        self.page = page
        self.client = client
        self.events: queue.Queue[tuple[str, Any]] = queue.Queue()
        gui, scene = client.gui, client.scene
        self.text = gui.add_text("text", "")
        self.number = gui.add_number("number", 1.5)
        self.slider = gui.add_slider("slider", 0.0, 10.0, 0.1, 5.0)
        self.checkbox = gui.add_checkbox("checkbox", False)
        self.vector = gui.add_vector3("vector", (0.0, 0.0, 0.0))
        self.button = gui.add_button("button")
        self.command = gui.add_command("command")
        self.gizmo = scene.add_transform_controls("/gizmo")
        for name in ("text", "number", "slider", "checkbox", "vector"):
            getattr(self, name).on_update(self._recorder(name, lambda event: event.target.value))
        self.button.on_click(self._recorder("button", lambda event: event.client_id))
        self.command.on_trigger(self._recorder("command", lambda event: event.client_id))
        self.gizmo.on_update(self._recorder("gizmo", lambda event: tuple(event.target.position)))

    def _recorder(self, name: str, value: Callable[[Any], Any]) -> Callable[[Any], Any]:
        async def record(event: Any) -> None:
            self.events.put((name, value(event)))

        return record

    def owner(self) -> str:
        """The name of this client's part of the scene, as its page echoes it."""
        return eventually(lambda: self.page.named("/gizmo"))[0]["owner"]

    def update(self, element: Any, value: Any) -> dict[str, Any]:
        """The message with which a page sets a GUI element."""
        return {"type": "GuiUpdateMessage", "uuid": uuid_of(element), "updates": {"value": value}}

    def works(self) -> bool:
        """Whether a value that the page sends still reaches its callback."""
        ping = f"ping {time.monotonic()}"
        self.page.send(self.update(self.text, ping))
        return self.next_event() == ("text", ping)

    def next_event(self) -> tuple[str, Any]:
        """The next callback that ran for this client."""
        return self.events.get(timeout=PATIENCE)

    def is_quiet(self) -> bool:
        """Whether nothing has reached a callback but a ping sent now; later messages do not overtake."""
        return self.works() and self.events.empty()


class Sandbox:
    """A server behind its gate, and its users."""

    def __init__(self) -> None:
        self.server: GatedServer = open_server("127.0.0.1", 0)
        self.port = self.server.get_port()
        self.pages: list[HostilePage] = []
        self._clients: queue.Queue[viser.ClientHandle] = queue.Queue()

        @self.server.on_client_connect
        async def _(client: viser.ClientHandle) -> None:
            self._clients.put(client)

    def page(self) -> HostilePage:
        """A connection that has said nothing yet."""
        page = HostilePage(self.port)
        self.pages.append(page)
        return page

    def user(self) -> User:
        """A page that has reported its camera, as every page does first."""
        page = self.page()
        page.send(CAMERA)
        return User(page, self._clients.get(timeout=PATIENCE))

    def refuses(self, reason: Any, count: int = 1) -> bool:
        """Whether the gate comes to count refusals for this reason, and no others."""
        refused = self.server.gate.refused
        eventually(lambda: refused[reason] >= count)
        return dict(refused) == {reason: count}

    def clear(self) -> None:
        """Part with all users, and forget what was refused."""
        for page in self.pages:
            page.close()
        eventually(lambda: not self.server.get_clients())
        self.pages.clear()
        self.server.gate.refused.clear()

    def close(self) -> None:
        """Stop everything."""
        for page in self.pages:
            page.close()
        self.server.stop()
