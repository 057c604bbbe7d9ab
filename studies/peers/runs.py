"""What an engine at one setting is asked to do, and how its time and its errors are measured."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from .heaps import Pile
from .plain import Floats
from .scenes import HEAP_SECONDS, HEAPS, SECONDS

FRAME = 1.0 / 60.0
"""A heap is looked at so often, s, as a game does."""

LONGEST = 0.5
"""Seconds of computing for a simulated one beyond which an engine's finer settings are not tried."""

FINE = 3e-4
"""Error, px, beyond which finer settings are not tried."""

PATIENCE = 5.0
"""Seconds of computing after which a run is given up, where it can be."""

SHORT = 0.2
"""Seconds of computing; what takes longer is timed once only."""


class Failed(Exception):
    """A run came to no end; the text says why."""


class Runner(Protocol):
    """An engine at one setting, ready to go."""

    def restart(self) -> None:
        """Go back to the start; not timed."""
        ...

    def advance(self) -> None:
        """Simulate `SECONDS` of a path, or a `FRAME` of a heap; timed.

        Raises:
            Failed: it cannot.
        """
        ...

    def positions(self) -> Floats:
        """(n, 2) where the masses are, px; not timed."""
        ...


@dataclass(frozen=True)
class Ladder:
    """An engine's method, and its settings from coarse to fine.

    Attributes:
        engine: its name.
        method: of it; with what else is set.
        values: settings.
        text: a setting for people.
        make: makes a runner of one, machine code and all; not timed.
        whole: whether all settings are tried, however exact the one before was.
    """

    engine: str
    method: str
    values: Sequence[float]
    text: Callable[[float], str]
    make: Callable[[float], Runner]
    whole: bool = False


@dataclass
class Point:
    """What came of one setting.

    Attributes:
        scene, engine, method, setting: which.
        value: the setting as a number.
        seconds: of processor time for a simulated second, the least of the runs.
        error: of ropes and nets, the largest distance of a mass from where it should be in the end, px.
        overlap: of heaps, the deepest that a mass was closer to another ring than it may, px.
        inside: of heaps, masses that are inside other rings in the end.
        speed: of heaps, the root mean square of the speeds in the end, px/s.
        runs: how often it was timed.
        failure: why there is no result, or empty.
    """

    scene: str
    engine: str
    method: str
    setting: str
    value: float
    seconds: float = math.inf
    error: float = math.nan
    overlap: float = math.nan
    inside: float = math.nan
    speed: float = math.nan
    runs: int = 0
    failure: str = ""


def measure(
    scene: str, ladders: Iterable[Ladder], right: Floats | None, repeats: int
) -> Iterator[tuple[list[Point], str]]:
    """Try all settings on a scene; then time what is short again and again, one after the other.

    Args:
        scene: its name.
        ladders: what is tried.
        right: (n, 2) where the masses should be in the end; None for heaps.
        repeats: how often what is short is timed.

    Yields:
        The points so far, and what comes next.
    """
    points: list[Point] = []
    ready: list[tuple[Point, Runner]] = []
    go = _heap if scene in HEAPS else _path
    for ladder in ladders:
        for value in ladder.values:
            yield points, f"{ladder.engine}, {ladder.method}, {ladder.text(value)}"
            point = Point(scene, ladder.engine, ladder.method, ladder.text(value), value)
            points.append(point)
            runner = None
            try:
                runner = ladder.make(value)
                go(point, runner, right)
            except (Failed, ArithmeticError, RuntimeError, ValueError) as error:
                point.failure = " ".join(str(error).split()) or type(error).__name__
                if runner is None or point.seconds > LONGEST:
                    break
                continue
            if point.seconds <= SHORT:
                ready.append((point, runner))
            if point.seconds > LONGEST or (point.error <= FINE and not ladder.whole):
                break
    for number in range(1, repeats):
        yield points, f"repeat {number} of {repeats - 1}"
        for point, runner in ready:
            go(point, runner, right)


def _path(point: Point, runner: Runner, right: Floats | None) -> None:
    runner.restart()
    gc.collect(0)
    began = time.process_time()
    try:
        runner.advance()
    finally:
        point.seconds = min(point.seconds, (time.process_time() - began) / SECONDS)
    point.runs += 1
    if right is not None and point.runs == 1:
        point.error = float(np.hypot(*(runner.positions() - right).T).max())
        if not math.isfinite(point.error):
            raise Failed("ran away")


def _heap(point: Point, runner: Runner, right: Floats | None) -> None:
    runner.restart()
    pile = Pile(point.scene)
    seconds, frames = 0.0, round(HEAP_SECONDS / FRAME)
    for frame in range(frames):
        began = time.process_time()
        runner.advance()
        seconds += time.process_time() - began
        if seconds > PATIENCE * HEAP_SECONDS:
            raise Failed(f"not done after {seconds:.0f} s")
        if point.runs == 0 and (frame % pile.EVERY == 0 or frame >= frames - 2):
            pile.look(runner.positions())
    point.seconds = min(point.seconds, seconds / HEAP_SECONDS)
    if point.runs == 0:
        point.overlap, point.inside, point.speed = pile.deepest, pile.inside(), pile.speed(FRAME)
    point.runs += 1
