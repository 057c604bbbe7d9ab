"""`softrod bench edit`: the time of an edit of one part of a large body and of its undo."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from typing import Any

from msgspec.structs import replace
from rich.console import Console
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

import sim
from app.pages.sandbox.tab import Tab
from app.server.serve import serving
from app.server.ticker import BUDGET
from app.session import commands
from app.session.hand import FRAME
from sim import Moment, Scene
from sim.edit.build import add_springs, extend, positions_of, remove
from sim.edit.edit import Edit, Selection
from sim.edit.values import number, set_number

from ..reporting.report import Table
from .client import CAMERA, Decoder, options_of

WIDE = 50
"""Masses along the upper side of the cloth, which has 9899 springs and 4898 joints."""

HIGH = 51
"""Masses along its left side."""


def cloth() -> Scene:
    """Return a cloth with both diagonals, and joints along its threads, held at two corners."""
    body = sim.Cloth(
        columns=WIDE, rows=HIGH, width=10.0 * (WIDE - 1), height=10.0 * (HIGH - 1), start=(0.0, 0.0),
        stiffness=1e4, shear_stiffness=1e4, damping=1.0, angular_stiffness=100.0, mass=0.1, radius=2.0,
    )  # fmt: skip
    euler = sim.Integrator(method="symplectic_euler", dt=1e-3)
    scene = sim.validate(Scene(name="cloth", bodies=(body,), gravity=(0.0, 500.0), integrator=euler))
    return replace(scene, bodies=())  # its parts are edited one by one


def _setting(kind: str, field: str, value: float) -> Callable[[Moment, int], Edit]:
    of = number(kind, field)
    return lambda moment, i: set_number(moment.scene, of, [len(getattr(moment.scene, kind)) // 2], value + i)


def _remove(**parts: int) -> Callable[[Moment, int], Edit]:
    gone = Selection(**{kind: frozenset({index}) for kind, index in parts.items()})
    return lambda moment, _: remove(moment.scene, gone)


def _add_spring(moment: Moment, _: int) -> Edit:
    return add_springs(moment.scene, [(0, len(moment.scene.masses) - 1)], positions_of(moment))


def _add_mass(moment: Moment, _: int) -> Edit:
    return extend(moment.scene, len(moment.scene.masses) - 1, (700.0, 700.0), positions_of(moment))


EDITS: dict[str, Callable[[Moment, int], Edit]] = {
    "a spring's stiffness": _setting("linear_springs", "stiffness", 2e4),
    "a spring's rest length": _setting("linear_springs", "rest_length", 11.0),
    "a joint's rest angle": _setting("angular_springs", "rest_angle", 1.0),
    "a spring removed": _remove(springs=5000),
    "a spring added": _add_spring,
    "a mass removed": _remove(masses=1200),
    "a mass added": _add_mass,
}
"""Each makes an edit of a moment, a different one for each number."""


def _at_once(work: Callable[..., Any], /, *arguments: Any, **options: Any) -> Future[Any]:
    done: Future[Any] = Future()
    done.set_result(work(*arguments, **options))
    return done


@contextmanager
def _tab(scene: Scene) -> Iterator[Tab]:
    """Yield a page's tab, detached from the ticker."""
    with serving(scene, "127.0.0.1", 0) as (server, ticker, _):
        address = f"127.0.0.1:{server.get_port()}"
        connection = connect(f"ws://{address}", **options_of(address))
        connection.send(Decoder().encode(CAMERA))

        def drain() -> None:
            try:
                for _ in connection:
                    pass
            except ConnectionClosed:
                pass

        threading.Thread(target=drain, daemon=True).start()
        while (
            not (tabs := [tab for tab in ticker.tabs.values() if isinstance(tab, Tab)]) or not tabs[0].session
        ):
            time.sleep(0.01)
        ticker.stop()
        yield tabs[0]
        connection.close()


def _frame(tab: Tab) -> None:
    """Do a whole frame; heavy work is done at once."""
    tab.frame(BUDGET * FRAME, _at_once)
    if tab.session is not None and tab.session.is_heavy:
        tab.frame(BUDGET * FRAME, _at_once)
    tab.client.flush()


def edit_times(tab: Tab, make: Callable[[Moment, int], Edit], repeats: int) -> tuple[float, ...]:
    """Return the shortest times, s: an edit in the session, the frame after it, its undo, the frame after."""
    session, best = tab.session, [math.inf] * 4
    assert session is not None
    for i in range(repeats):
        change = commands.Change(lambda moment, _, i=i: make(moment, i))
        times = []
        for command in (change, commands.Undo()):
            session.post(command)
            began = time.perf_counter()
            session.drain()
            applied = time.perf_counter()
            _frame(tab)
            times += [applied - began, time.perf_counter() - applied]
        best = [min(pair) for pair in zip(best, times, strict=True)]
    return tuple(best)


def select_time(tab: Tab, parts: Selection, repeats: int) -> float:
    """Return the shortest time, s, of selecting some parts, with the frame after that."""
    session, best = tab.session, math.inf
    assert session is not None
    for selection in (Selection(), parts) * repeats:
        session.post(commands.Select(lambda *_, selection=selection: selection))
        began = time.perf_counter()
        session.drain()
        _frame(tab)
        if selection is parts:
            best = min(best, time.perf_counter() - began)
    return best


def bench_edit(console: Console, repeats: int) -> None:
    """Measure, and print."""
    rows = []
    with _tab(cloth()) as tab:
        assert tab.session is not None
        tab.session.post(commands.Play(False))
        for _ in range(5):
            _frame(tab)
        for name, make in EDITS.items():
            times = edit_times(tab, make, repeats)
            part = max(sum(times[:2]), sum(times[2:])) / FRAME
            rows.append((name, *(f"{1e3 * t:.1f}" for t in times), f"{100.0 * part:.0f} %"))
        scene = tab.session.scene
        every = (scene.masses, scene.linear_springs, scene.angular_springs)
        whole = Selection(*(frozenset(range(len(parts))) for parts in every))
        one, all_ = (select_time(tab, p, repeats) for p in (Selection(springs=frozenset({5000})), whole))
    console.print(Table(("ms", "edit", "page", "undo", "page", "of a frame"), rows))
    console.print(f"selecting a spring: {1e3 * one:.1f} ms, with the page; everything: {1e3 * all_:.1f} ms")
