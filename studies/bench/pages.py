"""Many pages without a browser, side by side in one event loop, and how well a server keeps up with them."""

from __future__ import annotations

import asyncio
import contextlib
import math
import time
from collections.abc import AsyncIterator, Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import WebSocketException

from app.features.hands import messages as hands
from app.wire import from_page
from app.wire.line import unbatched

from .client import CAMERA, FRAME_TIME, Decoder, is_frame, options_of, saying

SETTLE = 4.0
"""Seconds from the last page's coming until it is measured."""

SPAN = 6.0
"""Seconds for which it is measured."""

STEER_EVERY = 0.05
"""Seconds between two reports of the pointer, which leads a body's end in a circle."""


class Connection:
    """A page's connection.

    Attributes:
        told: the last message of each kind, by its tag.
        bytes: received.
    """

    def __init__(self, connection: ClientConnection) -> None:
        self._connection, self._decoder = connection, Decoder()
        self.told: dict[str, dict[str, Any]] = {}
        self.bytes = 0

    async def begin(self) -> None:
        """Send what a page of viser sends first."""
        await self._connection.send(self._decoder.encode(CAMERA))

    async def say(self, message: from_page.FromPage) -> None:
        """Send a message, unless the connection has ended."""
        with contextlib.suppress(WebSocketException):
            await self._connection.send(self._encoded(message))

    def _encoded(self, message: from_page.FromPage) -> str | bytes:
        return self._decoder.encode(saying(message))

    def _messages(self, data: bytes) -> list[tuple[str, NDArray[np.float32] | None]]:
        """The texts and numbers of what has arrived."""
        messages = self._decoder.decode(data)
        return [
            (message["text"], message["numbers"] if is_frame(message) else None)
            for message in messages
            if message.get("type") == "SoftrodMessage"
        ]

    async def hear(self) -> AsyncIterator[dict[str, Any]]:
        """Yield what the page is told until the connection ends: frames, and messages by their tags."""
        try:
            async for data in self._connection:
                assert isinstance(data, bytes)
                self.bytes += len(data)
                for text, numbers in self._messages(data):
                    if numbers is not None and text.startswith('{"tell":"frame"'):
                        yield {"tell": "frame", "time": float(numbers[FRAME_TIME])}
                    else:
                        told = msgspec.json.decode(text)
                        self.told[told["tell"]] = told
                        yield told
        except WebSocketException:
            return

    async def lead(self, number: int, stop: asyncio.Event) -> None:
        """Take the driven mass in hand, and lead it in a circle."""
        await self.say(from_page.Perform("follow"))
        while not stop.is_set():
            angle = 2.0 * time.monotonic() + number
            await self.say(hands.At(((0, 0.6 * math.cos(angle), 1.0 + 0.6 * math.sin(angle)),)))
            await asyncio.sleep(STEER_EVERY)

    def cut(self) -> None:
        """Cut the connection without a word to the other end."""
        self._connection.transport.abort()


class LineConnection(Connection):
    """The connection of a page of a class, which is none of viser's."""

    async def begin(self) -> None:
        """Say nothing: the server begins."""

    def _encoded(self, message: from_page.FromPage) -> str | bytes:
        return msgspec.json.encode(message).decode()

    def _messages(self, data: bytes) -> list[tuple[str, NDArray[np.float32] | None]]:
        return [(letter.text, letter.numbers) for letter in unbatched(data)]


@contextlib.asynccontextmanager
async def connected(port: int, path: str = "", source: str = "127.0.0.1") -> AsyncIterator[Connection]:
    """Connect a page.

    Args:
        port: of the server on this machine.
        path: of the WebSocket, with its slash and its query.
        source: address of this machine that it connects from, by which the server tells visitors apart.

    Raises:
        OSError, WebSocketException: no server answers, or the gate refuses.
    """
    address = f"127.0.0.1:{port}"
    here = {"local_addr": (source, 0)}
    async with connect(f"ws://{address}{path}", **here, **options_of(address)) as connection:
        page = (LineConnection if path.startswith("/line/") else Connection)(connection)
        await page.begin()
        yield page


@dataclass
class Visitor:
    """What one page saw.

    Attributes:
        arrivals: wall time of each frame, s.
        times: simulated time of each frame, s.
        bytes: received.
    """

    arrivals: list[float] = field(default_factory=list)
    times: list[float] = field(default_factory=list)
    bytes: int = 0

    def note(self, told: dict[str, Any], page: Connection) -> None:
        """Count a message, and the time of a frame."""
        self.bytes += page.bytes
        page.bytes = 0
        if told["tell"] == "frame":
            self.arrivals.append(time.monotonic())
            self.times.append(told["time"])

    def within(self, begin: float, end: float) -> tuple[float, float, float]:
        """Return frames per second, longest gap (s) and simulated time per wall time, within a span of it."""
        inside = [i for i, at in enumerate(self.arrivals) if begin <= at <= end]
        if len(inside) < 2:
            return 0.0, end - begin, 0.0
        at = [self.arrivals[i] for i in inside]
        gaps = [b - a for a, b in zip([begin, *at], [*at, end], strict=True)]
        passed = self.times[inside[-1]] - self.times[inside[0]]
        return len(at) / (end - begin), max(gaps), passed / (at[-1] - at[0])


@dataclass(frozen=True)
class Crowd:
    """How a server kept up with many pages.

    Attributes:
        fewest: frames per second of the slowest page.
        rate: frames per second in the mean.
        gap: longest time between two frames of a page, s.
        clock: simulated seconds per second of the slowest page.
        share: processor time of the server per second.
        traffic: kB/s for each page.
    """

    fewest: float
    rate: float
    gap: float
    clock: float
    share: float
    traffic: float


async def measure_crowd(visitors: Sequence[Visitor], used: Callable[[], float]) -> Crowd:
    """Wait until all has settled, and measure for a while.

    Args:
        visitors: of the pages, which are connected.
        used: returns the processor time that the server has used so far, s.
    """
    await asyncio.sleep(SETTLE)
    for visitor in visitors:
        visitor.bytes = 0
    begin, before = time.monotonic(), used()
    await asyncio.sleep(SPAN)
    end, after = time.monotonic(), used()
    rates, gaps, clocks = zip(*(visitor.within(begin, end) for visitor in visitors), strict=True)
    traffic = sum(visitor.bytes for visitor in visitors) / len(visitors) / (end - begin) / 1e3
    share = (after - before) / (end - begin)
    return Crowd(min(rates), sum(rates) / len(rates), max(gaps), min(clocks), share, traffic)
