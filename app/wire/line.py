"""Lines: connections of softrod's own pages, which are none of viser's.

Letters travel in batches, each in one WebSocket message: of each letter the bytes of its text and the count
of its numbers (two unsigned 32-bit integers), the text padded to four bytes, and the numbers, all
little-endian. A page sends the JSON of one message in a text frame; an empty one asks for a sign of life,
which is an empty batch.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import struct
import threading
from collections.abc import Callable, Collection, Iterable

import numpy as np
from websockets.asyncio.server import ServerConnection, broadcast
from websockets.exceptions import ConnectionClosed

from .carrier import Letter
from .messages import FromPage, read

MAX_WAITING = 2000
"""Letters that may wait for a page that is slow; it is cut when there are more."""

_HEAD = struct.Struct("<II")
_numbers = itertools.count(-1, -1)


def batch(letters: Iterable[Letter]) -> bytes:
    """Encode letters for one WebSocket message."""
    parts: list[bytes] = []
    for text, numbers, _ in letters:
        data = text.encode()
        count = 0 if numbers is None else numbers.size
        parts += (_HEAD.pack(len(data), count), data, bytes(-len(data) % 4))
        if numbers is not None:
            parts.append(numbers.astype("<f4", copy=False).tobytes())
    return b"".join(parts)


def unbatched(data: bytes) -> list[Letter]:
    """Decode what `batch` has made; the letters have no keys."""
    letters, at = [], 0
    while at < len(data):
        size, count = _HEAD.unpack_from(data, at)
        text = data[at + 8 : at + 8 + size].decode()
        at += 8 + size + (-size % 4)
        numbers = np.frombuffer(data, "<f4", count, at) if count else None
        letters.append(Letter(text, numbers, ""))
        at += 4 * count
    return letters


class Line:
    """One page's connection.

    Args:
        connection: the WebSocket.
        loop: that it belongs to.

    Attributes:
        number: its own, negative, since viser's pages have positive ones.
        receive: called with every message of the page, on the event loop, where nothing may block.
    """

    def __init__(self, connection: ServerConnection, loop: asyncio.AbstractEventLoop) -> None:
        self.number = next(_numbers)
        self.receive: Callable[[FromPage], None] = lambda _: None
        self._connection, self._loop = connection, loop
        self._waiting: dict[str, Letter] = {}
        self._lock = threading.Lock()

    def post(self, letter: Letter) -> None:
        """Have a letter sent with the next `flush`; any thread may call."""
        with self._lock:
            self._waiting.pop(letter.key, None)  # a later letter also comes later
            self._waiting[letter.key] = letter

    @property
    def waits(self) -> bool:
        """True if letters wait."""
        return bool(self._waiting)

    async def listen(self, heard: Callable[[], None]) -> None:
        """Receive the page's messages until its connection ends; `heard` is called before each."""
        with contextlib.suppress(ConnectionClosed):
            async for text in self._connection:
                heard()
                if isinstance(text, str) and (said := read(text)) is not None:
                    self.receive(said)

    def _send(self) -> None:
        """Send what waits, unless the page has not received what was sent before; on the event loop."""
        transport = self._connection.transport
        if transport.is_closing() or transport.get_write_buffer_size():
            if len(self._waiting) > MAX_WAITING:
                transport.abort()
            return
        with self._lock:
            letters, self._waiting = self._waiting, {}
        if letters:
            broadcast((self._connection,), batch(letters.values()))


def flush(lines: Collection[Line]) -> None:
    """Send what waits for some pages of one server; any thread may call."""
    loop = next((line._loop for line in lines), None)
    if loop is None or loop.is_closed():
        return

    def send() -> None:
        for line in lines:
            line._send()

    loop.call_soon_threadsafe(send)


def send_at_once(lines: Collection[Line], letter: Letter) -> None:
    """Send a letter, encoded once, to several pages of one server; any thread may call.

    Pages that are gone, or have not yet received what was sent before, are left out.
    """
    found = tuple(lines)
    if not found or found[0]._loop.is_closed():
        return
    data = batch((letter,))

    def send() -> None:
        transports = ((line, line._connection.transport) for line in found)
        ready = [
            line._connection
            for line, transport in transports
            if not (transport.is_closing() or transport.get_write_buffer_size() or line.waits)
        ]
        broadcast(ready, data)

    found[0]._loop.call_soon_threadsafe(send)
