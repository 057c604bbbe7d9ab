"""`softrod bench tabs`: many pages at once, each with a body in motion, and whether their clocks keep up."""

from __future__ import annotations

import asyncio
import math
import tempfile
import time
from pathlib import Path

from msgspec.structs import replace
from rich.console import Console

import sim
from app.features.gallery.messages import OpenScene
from app.wire import from_page
from sim import Scene

from ..reporting.report import Table
from .pages import SETTLE, SPAN, Crowd, Visitor, connected, measure_crowd
from .serving import Served, served, warm

MASSES = 200

CLOTHS = (20, 70, 90)
"""Masses along the sides of the cloths that another page has; the last nearly fills the file of a scene."""


async def _visit(
    port: int,
    visitor: Visitor,
    number: int,
    stop: asyncio.Event,
    scene: str = "",
    pause: asyncio.Event | None = None,
) -> float:
    """Be a page until stopped: open another scene, lead the driven mass, press Pause when that is asked.

    Returns:
        Wall time at which the page was told that it is paused, s; infinite if it never was.
    """
    async with connected(port) as page:
        drawn = asyncio.Event()

        async def steer() -> None:
            await drawn.wait()
            if scene:
                await page.say(OpenScene(scene))
                await asyncio.sleep(1.0)
            await page.lead(number, stop)

        async def press_pause() -> None:
            if pause is not None:
                await pause.wait()
                await page.say(from_page.Perform("pause"))

        async def end() -> None:
            await stop.wait()
            page.cut()

        tasks = [asyncio.create_task(each) for each in (steer(), press_pause(), end())]
        paused = math.inf
        async for told in page.hear():
            visitor.note(told, page)
            if told["tell"] == "pageState":
                drawn.set()
                if pause is not None and pause.is_set() and not told.get("playing"):
                    paused = min(paused, time.monotonic())
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        return paused


async def visit_all(server: Served, pages: int) -> Crowd:
    """Measure many pages at once."""
    visitors = [Visitor() for _ in range(pages)]
    stop = asyncio.Event()
    tasks = []
    for number, visitor in enumerate(visitors):
        tasks.append(asyncio.create_task(_visit(server.port, visitor, number, stop)))
        await asyncio.sleep(0.1)
    crowd = await measure_crowd(visitors, server.used)
    stop.set()
    await asyncio.gather(*tasks)
    return crowd


def bench_tabs(console: Console, repeats: int) -> None:
    """Many pages of a rope of 200 masses whose ends are led in circles."""
    rows = []
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for pages in (1, 10, 20, 30, 50):
            crowds = []
            for _ in range(repeats):
                with served("softrod", MASSES, cache) as server:
                    crowds.append(asyncio.run(visit_all(server, pages)))
            best = max(crowds, key=lambda crowd: crowd.fewest)
            cells = f"{best.rate:.1f}", f"{best.fewest:.1f}", f"{1e3 * best.gap:.0f}", f"{best.clock:.2f}"
            rows.append((str(pages), *cells, f"{100 * best.share:.0f}", f"{best.traffic:.0f}"))
    headings = "frames/s", "fewest", "longest gap, ms", "slowest clock", "server, % of a core", "kB/s"
    console.print(Table(("pages", *headings), rows, "r"))
    bench_neighbour(console)


def bench_neighbour(console: Console) -> None:
    """What a page with a rope notices of another page's heavy cloth, and how soon that one answers."""
    rows = []
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for side in CLOTHS:
            scene = Path(cache) / "cloth.json"
            sim.save_scene(cloth(side), scene)
            with served("softrod", str(scene), cache) as server:
                rate, *delays = asyncio.run(_next_to_a_cloth(server.port))
            rows.append((f"{side * side} masses", f"{rate:.1f}", *(f"{1e3 * s:.0f}" for s in delays)))
    headings = "next to a cloth of", "frames/s", "longest gap, ms", "its page pauses in, ms"
    console.print(Table(headings, rows))


async def _next_to_a_cloth(port: int) -> tuple[float, float, float]:
    """Measure a page with a rope while another has a cloth.

    Returns:
        Frames per second and longest gap (s) of the rope's page, and seconds until that of the cloth pauses.
    """
    stop, pause = asyncio.Event(), asyncio.Event()
    rope, heavy = Visitor(), Visitor()
    of_cloth = asyncio.create_task(_visit(port, heavy, 1, stop, pause=pause))
    await asyncio.sleep(SETTLE)
    of_rope = asyncio.create_task(_visit(port, rope, 0, stop, scene="tutorial-3.3"))
    await asyncio.sleep(2.0 * SETTLE)
    begin = time.monotonic()
    await asyncio.sleep(SPAN)
    end = time.monotonic()
    pause.set()
    await asyncio.sleep(1.0)
    stop.set()
    paused, _ = await asyncio.gather(of_cloth, of_rope)
    rate, gap, _ = rope.within(begin, end)
    return rate, gap, paused - end


def cloth(side: int) -> Scene:
    """Return a square cloth of so many masses a side, held at two corners, by an implicit method."""
    width = 500.0 * (1.0 - 1.0 / side)
    body = sim.Cloth(
        columns=side, rows=side, width=width, height=width, start=(50.0, 50.0), diagonals=False,
        stiffness=1e4, damping=4.0, mass=1.0, radius=2.0,
    )  # fmt: skip
    implicit = sim.Integrator(method="generalized_alpha", dt=1.0 / 60.0)
    scene = sim.validate(Scene(name="cloth", bodies=(body,), gravity=(0.0, 981.0), integrator=implicit))
    return replace(scene, bodies=(), angular_springs=())
