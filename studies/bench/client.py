"""A page without a browser: a WebSocket client that reads what the server sends, as viser's page does.

What a browser adds (shaders, drawing) is the same whatever is served, and is not measured.
"""

from __future__ import annotations

import socket
import ssl
import time
from collections import deque
from typing import Any

import msgspec
import numpy as np
import viser
import zstandard
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from app.wire.messages import FromPage

FRAME_TIME = 2
"""Index of the time among the numbers of a frame, see `stage.plan.encode_frame`."""

FRAME_PLACES = 7
"""Index of the first position among them."""

CAMERA: dict[str, Any] = {
    "type": "ViewerCameraMessage",
    "wxyz": [0.0, 0.0, 1.0, 0.0],
    "position": [0.0, 0.0, 62.0],
    "fov": 0.1,
    "near": 1.0,
    "far": 2000.0,
    "image_height": 760,
    "image_width": 930,
    "look_at": [0.0, 0.0, 0.0],
    "up_direction": [0.0, 1.0, 0.0],
}


def options_of(address: str) -> dict[str, Any]:
    """Return the arguments of a connection, as in the page."""
    return {
        "origin": Origin(f"http://{address}"),
        "subprotocols": [Subprotocol(f"viser-v{viser.__version__}")],
        "compression": None,
        "max_size": None,
    }


def is_frame(message: dict[str, Any]) -> bool:
    """Whether a message says where the masses are."""
    return str(message.get("text", "")).startswith('{"tell":"frame"')


def saying(message: FromPage) -> dict[str, Any]:
    """Return a page's message, as it is sent."""
    return {"type": "SoftrodMessage", "text": msgspec.json.encode(message).decode()}


def state_of(message: dict[str, Any]) -> dict[str, Any] | None:
    """Return the page's state, if a message has it; flags that are left out are off."""
    text = str(message.get("text", ""))
    return msgspec.json.decode(text) if text.startswith('{"tell":"pageState"') else None


class Decoder:
    """Reads and writes viser's messages."""

    def __init__(self) -> None:
        self._unpack = zstandard.ZstdDecompressor()
        self.encode = msgspec.msgpack.Encoder().encode

    def decode(self, data: bytes) -> list[dict[str, Any]]:
        """Return the messages of a batch, with the numbers of softrod's frames in place."""
        # viser 1.1.1, infra/_infra.py: two lengths, compressed msgpack, then raw arrays.
        size = int.from_bytes(data[8:16], "little")
        payload = msgspec.msgpack.decode(self._unpack.decompress(data[16 : 16 + size]))
        messages: list[dict[str, Any]] = payload["messages"]
        lengths: list[int] = payload.get("binaryBufferLengths") or []
        for message in messages:
            if is_frame(message):
                index: int = message["numbers"]["__binary_index"]
                # Each array begins at a multiple of eight bytes.
                before = sum(-(-length // 8) * 8 for length in lengths[:index])
                start = -(-(16 + size) // 8) * 8 + before
                message["numbers"] = np.frombuffer(data, np.float32, lengths[index] // 4, start)
        return messages


class Page:
    """A connected client; a context manager.

    Args:
        port: of the server, or of a proxy in front of it.
        patience: seconds within which it must be possible to connect.
        path: of the WebSocket, without a leading slash.
        tls: with it, the connection is by TLS.
        name: of this machine then.

    Attributes:
        bytes: received so far.
        messages: of the scene and the panel, received so far.
    """

    def __init__(
        self,
        port: int,
        patience: float = 60.0,
        path: str = "",
        tls: ssl.SSLContext | None = None,
        name: str = "localhost",
    ) -> None:
        self._address = f"127.0.0.1:{port}" if tls is None else f"{name}:{port}"
        self._port = port
        self._path, self._tls = path, tls
        self._patience = patience
        self._decoder = Decoder()
        self._unread: deque[dict[str, Any]] = deque()
        self.bytes = 0
        self.messages = 0

    def __enter__(self) -> Page:
        deadline = time.monotonic() + self._patience
        options = options_of(self._address)
        if self._tls is not None:
            options |= {"origin": Origin(f"https://{self._address}"), "ssl": self._tls}
        scheme = "ws" if self._tls is None else "wss"
        while True:
            try:
                here = socket.create_connection(("127.0.0.1", self._port))
                self._connection: ClientConnection = connect(
                    f"{scheme}://{self._address}/{self._path}", sock=here, **options
                )
                break
            except (OSError, ConnectionClosed):
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.002)
        self.send(CAMERA)
        return self

    def __exit__(self, *_: object) -> None:
        self._connection.close()

    def send(self, message: dict[str, Any]) -> None:
        """Send one message, as the page does."""
        self._connection.send(self._decoder.encode(message))

    def receive(self, timeout: float) -> list[dict[str, Any]]:
        """Return the messages of the next batch; none after the timeout."""
        try:
            data = self._connection.recv(timeout=timeout, decode=False)
        except TimeoutError:
            return []
        self.bytes += len(data)
        messages = self._decoder.decode(data)
        self.messages += len(messages)
        return messages

    def wait_for(self, wanted: Any, timeout: float = 60.0) -> dict[str, Any]:
        """Return the first message for which `wanted(message)` holds.

        Raises:
            TimeoutError: none came.
        """
        deadline = time.monotonic() + timeout
        while True:
            # The rest of a batch stays for the next call.
            while self._unread:
                message = self._unread.popleft()
                if wanted(message):
                    return message
            left = deadline - time.monotonic()
            if left <= 0.0:
                raise TimeoutError("the server did not send the expected message")
            self._unread.extend(self.receive(left))

    def read_for(self, seconds: float) -> None:
        """Read and count whatever comes, and drop it."""
        self._unread.clear()
        deadline = time.monotonic() + seconds
        while (left := deadline - time.monotonic()) > 0:
            self.receive(left)
