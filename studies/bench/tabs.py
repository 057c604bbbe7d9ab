"""Many pages at once, each with a body in motion: frames a second of each, and whether its clock keeps up."""

from __future__ import annotations

import asyncio
import math
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from rich.console import Console
from rich.table import Table
from websockets.asyncio.client import connect

import sim
from app.features.gallery.messages import OpenScene
from app.features.hands import messages as hands
from app.wire import from_page
from sim import Scene
from sim.store.files import encode_scene

from .client import CAMERA, FRAME_TIME, Decoder, is_frame, options_of, saying, state_of
from .serving import Served, served, warm

MASSES = 200
SETTLE, SPAN = 4.0, 6.0
"""Seconds until it is measured, and for how long."""

CLOTHS = (20, 70, 105)
"""Masses along the sides of the cloths that another page has."""

STEER_EVERY = 0.05
"""Seconds between two reports of the pointer, which leads the rope's end in a circle."""


@dataclass
class Visitor:
    """What one page saw.

    Attributes:
        arrivals: wall time of each frame, s.
        times: simulated time of each frame, s.
        bytes: received.
        paused: wall time at which the page was told that it is paused, s.
    """

    arrivals: list[float] = field(default_factory=list)
    times: list[float] = field(default_factory=list)
    bytes: int = 0
    paused: float = math.inf

    def within(self, begin: float, end: float) -> tuple[float, float, float]:
        """(frames a second, longest gap in s, simulated seconds per second) of a span of wall time."""
        inside = [i for i, at in enumerate(self.arrivals) if begin <= at <= end]
        if len(inside) < 2:
            return 0.0, end - begin, 0.0
        at = [self.arrivals[i] for i in inside]
        gaps = [b - a for a, b in zip([begin, *at], [*at, end], strict=True)]
        passed = self.times[inside[-1]] - self.times[inside[0]]
        return len(at) / (end - begin), max(gaps), passed / (at[-1] - at[0])


async def _visit(
    port: int,
    visitor: Visitor,
    number: int,
    stop: asyncio.Event,
    scene: str = "",
    press: asyncio.Event | None = None,
) -> None:
    """Be a page until told to stop: go on to another scene, lead the driven mass, press Pause when told."""
    address = f"127.0.0.1:{port}"
    decoder = Decoder()
    async with connect(f"ws://{address}", **options_of(address)) as connection:
        await connection.send(decoder.encode(CAMERA))
        drawn = asyncio.Event()

        async def say(message: from_page.FromPage) -> None:
            await connection.send(decoder.encode(saying(message)))

        async def steer() -> None:
            await drawn.wait()
            if scene:
                await say(OpenScene(scene))
                await asyncio.sleep(1.0)
            await say(from_page.Perform("follow"))
            pressed = False
            while not stop.is_set():
                if press is not None and press.is_set() and not pressed:
                    pressed = True
                    await say(from_page.Perform("pause"))
                angle = 2.0 * time.monotonic() + number
                await say(hands.At(((0, 0.6 * math.cos(angle), 1.0 + 0.6 * math.sin(angle)),)))
                await asyncio.sleep(STEER_EVERY)

        steering = asyncio.create_task(steer())
        while not stop.is_set():
            try:
                data: Any = await asyncio.wait_for(connection.recv(), 0.5)
            except TimeoutError:
                continue
            visitor.bytes += len(data)
            for message in decoder.decode(data):
                state = state_of(message)
                if is_frame(message):
                    visitor.arrivals.append(time.monotonic())
                    visitor.times.append(float(message["numbers"][FRAME_TIME]))
                elif state is not None:
                    drawn.set()
                    is_asked = press is not None and press.is_set()
                    if is_asked and not state.get("playing") and visitor.paused == math.inf:
                        visitor.paused = time.monotonic()
        await steering


async def visit_all(server: Served, pages: int) -> tuple[list[Visitor], float, float, float]:
    """The visitors, the span that was measured, and the server's share of a core."""
    visitors = [Visitor() for _ in range(pages)]
    stop = asyncio.Event()
    tasks = []
    for number, visitor in enumerate(visitors):
        tasks.append(asyncio.create_task(_visit(server.port, visitor, number, stop)))
        await asyncio.sleep(0.1)
    await asyncio.sleep(SETTLE)
    for visitor in visitors:
        visitor.bytes = 0
    begin, before = time.monotonic(), server.used()
    await asyncio.sleep(SPAN)
    end, after = time.monotonic(), server.used()
    stop.set()
    await asyncio.gather(*tasks)
    return visitors, begin, end, (after - before) / (end - begin)


def bench_tabs(console: Console, repeats: int) -> None:
    """Many pages of a rope of 200 masses whose ends are led in circles."""
    table = Table(
        "pages", "frames/s", "fewest", "longest gap, ms", "slowest clock", "server, % of a core", "kB/s",
        box=None,
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for pages in (1, 10, 20, 30, 50):
            best: tuple[float, ...] | None = None
            for _ in range(repeats):
                with served("softrod", MASSES, cache) as server:
                    visitors, begin, end, share = asyncio.run(visit_all(server, pages))
                seen = [visitor.within(begin, end) for visitor in visitors]
                rates, gaps, clocks = zip(*seen, strict=True)
                size = sum(visitor.bytes for visitor in visitors) / pages / (end - begin) / 1e3
                row = (min(rates), sum(rates) / pages, max(gaps), min(clocks), share, size)
                best = row if best is None else max(best, row)
            assert best is not None
            fewest, rate, gap, clock, share, size = best
            table.add_row(
                str(pages), f"{rate:.1f}", f"{fewest:.1f}", f"{1e3 * gap:.0f}", f"{clock:.2f}",
                f"{100 * share:.0f}", f"{size:.0f}",
            )  # fmt: skip
    console.print(table)
    bench_neighbour(console)


def bench_neighbour(console: Console) -> None:
    """What a page with a rope notices of another page's heavy cloth, and how soon that one answers."""
    table = Table("beside a cloth of", "frames/s", "longest gap, ms", "its page pauses in, ms", box=None)
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for side in CLOTHS:
            scene = Path(cache) / "cloth.json"
            scene.write_bytes(encode_scene(cloth(side)))
            with served("softrod", str(scene), cache) as server:
                rate, gap, answer = asyncio.run(_beside(server.port))
            table.add_row(f"{side * side} masses", f"{rate:.1f}", f"{1e3 * gap:.0f}", f"{1e3 * answer:.0f}")
    console.print(table)


async def _beside(port: int) -> tuple[float, float, float]:
    """(frames a second and longest gap of a page that goes on to a rope, seconds until the other pauses)."""
    stop, answered = asyncio.Event(), asyncio.Event()
    rope, heavy = Visitor(), Visitor()
    tasks = [asyncio.create_task(_visit(port, heavy, 1, stop, press=answered))]
    await asyncio.sleep(SETTLE)
    tasks.append(asyncio.create_task(_visit(port, rope, 0, stop, scene="tutorial-3.3")))
    await asyncio.sleep(2.0 * SETTLE)
    begin = time.monotonic()
    await asyncio.sleep(SPAN)
    end = time.monotonic()
    answered.set()
    await asyncio.sleep(1.0)
    stop.set()
    await asyncio.gather(*tasks)
    rate, gap, _ = rope.within(begin, end)
    return rate, gap, heavy.paused - end


def cloth(side: int) -> Scene:
    """A square cloth of so many masses a side, held at two corners, by an implicit method."""
    width = 500.0 * (1.0 - 1.0 / side)
    body = sim.Cloth(
        columns=side, rows=side, width=width, height=width, start=(50.0, 50.0), diagonals=False,
        stiffness=1e4, damping=4.0, mass=1.0, radius=2.0,
    )  # fmt: skip
    implicit = sim.Integrator(method="generalized_alpha", dt=1.0 / 60.0)
    scene = sim.validate(Scene(name="cloth", bodies=(body,), gravity=(0.0, 981.0), integrator=implicit))
    return replace(scene, bodies=(), angular_springs=())
