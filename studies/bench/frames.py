"""`softrod bench frames`: time and error of frames of 1/60 s for a rod led in a circle, and their time where
the rod's end is torn to and fro.

The rods are the same one in more and more pieces: length, weight and stiffness of the whole do not change.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from rich.console import Console

import sim
from sim import Integrator, Scene
from sim.scene.makers import fine_rope
from sim.scene.types import Circle, Method

from ..reporting.report import Table

SIZES = (12, 100, 1000, 3000, 10_000)
"""Masses."""

FRAMES = 60
TOLERANCE = 0.1
"""Tolerance of `auto`, px."""

TORN = 500.0
"""Distance over which the end of a rod is torn to and fro, px."""

REFERENCE: tuple[Method, float] = ("rodas5p", 1e-3)
"""Reference: method, and tolerance in px."""


def rod(masses: int, integrator: Integrator, circle: Circle | None = None) -> Scene:
    """Return the tutorial's rope in so many pieces, under the tutorial's law."""
    return fine_rope(masses, circle=circle, force_law="tutorial", integrator=integrator)


def led_rod(masses: int, method: Method, tolerance: float) -> Scene:
    """Return the rod, its first mass led in a circle twice a second."""
    integrator = Integrator(method=method, dt=1.0 / FRAMES, tolerance=tolerance)
    return rod(masses, integrator, Circle(radius=200.0, frequency=2.0, ramp=0.1))


@dataclass(frozen=True)
class Frames:
    """Results of a run.

    Attributes:
        path: (frames, n, 2) px.
        seconds: (frames,) of computing.
        steps, rejected: of all frames.
    """

    path: NDArray[np.float64]
    seconds: NDArray[np.float64]
    steps: int
    rejected: int


Act = Callable[[sim.Simulation, int], None]
"""Acts on a simulation before the frame of a number."""


def tear(simulation: sim.Simulation, frame: int) -> None:
    """Point to and fro with the first mass in hand, ten times a second."""
    simulation.follow(0, (100.0 + TORN * (frame // (FRAMES // 10) % 2), 100.0))


def run_frames(simulation: sim.Simulation, act: Act = lambda simulation, frame: None) -> Frames:
    """Run from the start, frame by frame.

    Raises:
        RuntimeError: the body ran away.
    """
    simulation.reset()
    simulation.stats()
    path, seconds = [], []
    for frame in range(FRAMES):
        began = time.perf_counter()
        act(simulation, frame)
        simulation.step()
        seconds.append(time.perf_counter() - began)
        path.append(simulation.positions)
    if simulation.divergence is not None:
        raise RuntimeError(f"the rod ran away: {simulation.divergence}")
    stats = simulation.stats()
    return Frames(np.array(path), np.array(seconds), stats.steps, stats.rejected)


def errors(path: NDArray[np.float64], reference: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the (frames,) largest distance of a mass from the reference, px."""
    return np.hypot(*np.moveaxis(path - reference, -1, 0)).max(axis=1)


def behind(seconds: NDArray[np.float64]) -> float:
    """Return the largest delay of the clock, s, if frames take so long."""
    late = latest = 0.0
    for spent in seconds:
        late = max(0.0, late + float(spent) - 1.0 / FRAMES)
        latest = max(latest, late)
    return latest


def bench_frames(console: Console, repeats: int) -> None:
    """Measure, and print ms per frame and errors for each size; of each frame the fastest of the repeats."""
    _bench_circle(console, repeats)
    console.print()
    _bench_torn(console, repeats)


def _bench_torn(console: Console, repeats: int) -> None:
    rows = []
    for masses in SIZES:
        integrator = Integrator(dt=1.0 / FRAMES, tolerance=TOLERANCE)
        simulation = sim.Simulation(rod(masses, integrator))
        runs = [run_frames(simulation, tear) for _ in range(repeats + 1)][1:]
        seconds = np.min([run.seconds for run in runs], axis=0)
        hand = abs(runs[0].path[:, 0, 0] - [100.0 + TORN * (i // (FRAMES // 10) % 2) for i in range(FRAMES)])
        times = (f"{1e3 * s:.3g}" for s in (np.median(seconds), seconds.max()))
        rows.append((str(masses), *times, f"{FRAMES * behind(seconds):.2g}", f"{hand.max():.0f}"))
    headings = ("masses", "ms, median", "worst", "clock behind, frames", "hand behind, px")
    title = f"Torn by {TORN:g} px ten times a second, auto at {TOLERANCE:g} px"
    console.print(Table(headings, rows, "r", title))


def _bench_circle(console: Console, repeats: int) -> None:
    rows = []
    for masses in SIZES:
        simulation = sim.Simulation(led_rod(masses, "auto", TOLERANCE))
        runs = [run_frames(simulation) for _ in range(repeats + 1)][1:]
        ms = 1e3 * np.min([run.seconds for run in runs], axis=0)
        reference = run_frames(sim.Simulation(led_rod(masses, *REFERENCE)))
        off = errors(runs[0].path, reference.path)
        times = (f"{each:.3g}" for each in (np.median(ms), ms.max(), ms[1:].max()))
        steps = str(runs[0].steps), str(runs[0].rejected)
        rows.append((str(masses), *times, *steps, f"{off[-1]:.2g}", f"{off.max():.2g}"))
    headings = (
        "masses",
        "ms, median",
        "worst",
        "worst but the first",
        "steps",
        "rejected",
        "error at the end, px",
        "at any frame",
    )
    reference = f"{REFERENCE[0]} at {REFERENCE[1]:g} px"
    title = f"{FRAMES} frames of 1/60 s, auto at {TOLERANCE:g} px, compared with {reference}"
    console.print(Table(headings, rows, "r", title))
