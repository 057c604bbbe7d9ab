"""A run of a contender at one setting, and what is measured of it."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sim.solve.registry import METHODS

Floats = NDArray[np.float64]
Clock = Callable[[], float]

WALL = (time.perf_counter,)
"""The clock for engines that use one thread."""

OF_ALL_THREADS = (time.process_time, time.perf_counter)
"""The clocks for engines that may use several. Linux counts what another thread computes only at ticks, some
milliseconds apart, so that processor time alone may be far too short."""


SOFTROD = "softrod"
"""Name of softrod among the engines."""

FRAME = 1.0 / 60.0
"""Interval at which a page or a game looks at a body, s."""

SECONDS = 1.0
"""Simulated time of a run, s; heaps of rings have a time of their own."""

PATIENCE = 5.0
"""Seconds of computing per simulated second after which a run is given up, where it can be interrupted."""


class Failed(Exception):
    """A run did not reach its end; the text says why."""


FAILURES = (Failed, ArithmeticError, RuntimeError, ValueError)
"""Errors by which an engine or a solver gives up."""


def reason(error: Exception) -> str:
    """Return the text of an error in one line."""
    return " ".join(str(error).split()) or type(error).__name__


class Runner:
    """A contender at one setting, ready to run: tables, matrix patterns and machine code are made before.

    Attributes:
        frames: calls of `advance` that make up the run.
    """

    frames = 1

    def restart(self) -> None:
        """Go back to the start; not timed."""

    def advance(self) -> None:
        """Simulate one frame; timed.

        Raises:
            Failed: it cannot.
        """
        raise NotImplementedError

    def positions(self) -> Floats:
        """Return the (n, 2) positions after a frame, px; not timed."""
        raise NotImplementedError


@dataclass(frozen=True)
class Trial:
    """Result of one run.

    Attributes:
        path: (frames, n, 2) px; None where the run failed.
        seconds: of computing.
        failure: why there is no path, or empty.
    """

    path: Floats | None
    seconds: float
    failure: str = ""


def run(runner: Runner, clocks: Sequence[Clock] = WALL, limit: float = math.inf) -> Trial:
    """Run from the start to the end.

    Args:
        runner: what runs.
        clocks: measure the computing; the one that goes farthest counts.
        limit: seconds of computing after which the run is given up, between two frames.
    """
    seconds = 0.0
    path = []
    gc.collect(0)
    try:
        runner.restart()
        for _ in range(runner.frames):
            began = [clock() for clock in clocks]
            try:
                runner.advance()
            finally:
                seconds += max(clock() - then for clock, then in zip(clocks, began, strict=True))
            if seconds > limit:
                raise Failed(f"not done after {seconds:.0f} s")
            path.append(runner.positions())
        whole = np.array(path)
        if not np.isfinite(whole).all():
            raise Failed("ran away")
    except FAILURES as error:
        return Trial(None, seconds, reason(error))
    return Trial(whole, seconds)


def distance(one: Floats, other: Floats) -> float:
    """Return the largest distance between two positions of a mass, px."""
    return float(np.sqrt(((one - other) ** 2).sum(-1)).max())


@dataclass
class Point:
    """Results of one setting of one method on one scene.

    Attributes:
        scene, engine, method: names; softrod's methods as in `METHODS`.
        setting: time step, rate or tolerance, for people.
        value: the setting as a number.
        seconds: of computing for a simulated second, in one call; the shortest of the repeats.
        error: largest distance of a mass from the reference at the end, px; infinite where the run failed,
            NaN in heaps, which have no reference.
        path_error: the same at any frame, or NaN where only the end is compared.
        framed_seconds: as `seconds`, in a call per frame, or NaN where that is not timed.
        framed_error: as `error`, after a call per frame, or NaN.
        overlap: of heaps, the deepest that a mass came into another ring, px.
        inside: of heaps, masses that are inside other rings at the end.
        speed: of heaps, root mean square of the speeds at the end, px/s.
        runs: turns of timing.
        failure: why it failed, or empty.
    """

    scene: str
    engine: str
    method: str
    setting: str
    value: float
    seconds: float = math.inf
    error: float = math.nan
    path_error: float = math.nan
    framed_seconds: float = math.nan
    framed_error: float = math.nan
    overlap: float = math.nan
    inside: float = math.nan
    speed: float = math.nan
    runs: int = 0
    failure: str = ""

    @property
    def name(self) -> str:
        """The name of the method in options and tables: "rk4", "scipy_bdf"."""
        return option_name(self.engine, self.method)

    @property
    def label(self) -> str:
        """The name of the method for people."""
        return method_label(self.engine, self.method)


def option_name(engine: str, method: str) -> str:
    """Return the name of a method as `--integrators` takes it."""
    return method if engine == SOFTROD else f"{engine}_{method}".lower()


def method_label(engine: str, method: str) -> str:
    """Return the name of a method for people."""
    return METHODS[method].label if engine == SOFTROD and method in METHODS else method


def best(points: Sequence[Point], error: float) -> Point | None:
    """Return the fastest point that ends within an error, px."""
    return min((p for p in points if p.error <= error), key=lambda p: p.seconds, default=None)


def auto_at(points: Sequence[Point], error: float) -> Point | None:
    """Return the point of softrod's `auto` with an error as its tolerance, px."""
    of_auto = (p for p in points if p.engine == SOFTROD and p.method == "auto")
    return next((p for p in of_auto if p.value == error), None)


def milliseconds(seconds: float | None) -> str:
    """Return a time in ms with three digits; empty where there is none."""
    return "" if seconds is None or not math.isfinite(seconds) else f"{1e3 * seconds:#.3g}".rstrip(".")
