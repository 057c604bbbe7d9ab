"""`softrod bench many`: many small bodies, and what a simulation of one takes besides physics."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence

import msgspec
import numpy as np
from rich.console import Console

import sim
from sim import Integrator, Scene
from sim.scene.types import Method

from ..reporting.report import Table
from . import fastest

ROPES = 1000

MASSES = 12
"""Of a rope."""

SECONDS = 1.0
"""Simulated time of each."""

METHODS: tuple[tuple[Method, float], ...] = (
    ("symplectic_euler", 0.0025),
    ("velocity_verlet", 0.0025),
    ("rk4", 0.01),
    ("auto", 0.0025),
)
"""Methods, and the time step of each, s."""

REFERENCE: tuple[Method, float] = ("rk4", 1e-4)
"""Reference: method, and step in s. It is within 1e-8 px of `rodas5p` at 1e-8 px."""

CHECK_EVERY = 100
"""One rope in so many is compared with the reference."""

CALLS = 2000
"""Calls of `step` that are timed together."""


def ropes(integrator: Integrator, count: int = ROPES) -> list[Scene]:
    """Return ropes that differ in stiffness and in their masses, and swing down from the side."""
    return [
        sim.rope(
            MASSES,
            stiffness=5000.0 + 10.0 * k,
            mass=0.5 + k / ROPES,
            gravity=(0.0, 500.0),
            integrator=integrator,
        )
        for k in range(count)
    ]


def simulate_each(scenes: Sequence[Scene]) -> list[np.ndarray]:
    """Return the (n, 2) positions of all at the end, px, by a `Simulation` for each."""
    ends = []
    for scene in scenes:
        simulation = sim.Simulation(scene)
        simulation.advance(SECONDS)
        ends.append(simulation.positions)
    return ends


def simulate_together(scenes: Sequence[Scene]) -> list[np.ndarray]:
    """Return the same by `run_many`."""
    return [run.positions for run in sim.run_many(scenes, SECONDS)]


def errors(scenes: list[Scene], ends: list[np.ndarray]) -> float:
    """Return the largest distance of a mass from the reference, px, in some of the scenes."""
    method, dt = REFERENCE
    exact = Integrator(method=method, dt=dt)
    some = [msgspec.structs.replace(scene, integrator=exact) for scene in scenes[::CHECK_EVERY]]
    return max(
        float(np.hypot(*(end - there).T).max())
        for end, there in zip(ends[::CHECK_EVERY], simulate_each(some), strict=True)
    )


def bench_many(console: Console, repeats: int) -> None:
    """Print what takes how long."""
    rows = []
    for method, dt in METHODS:
        scenes = ropes(Integrator(method=method, dt=dt))
        with console.status(f"compiling {method}"):  # minutes where no machine code is stored
            simulate_together(scenes[:8])
            simulate_each(scenes[:8])
        contenders = {
            "each": lambda scenes=scenes: simulate_each(scenes),
            "together": lambda scenes=scenes: simulate_together(scenes),
        }
        each, together = fastest(contenders, repeats, time.process_time).values()
        off = errors(scenes, simulate_together(scenes))
        times = f"{1e3 * each:.0f}", f"{1e3 * together:.1f}", f"{each / together:.1f}"
        rows.append((method, f"{1e3 * dt:g}", *times, f"{off:.2g}"))
    headings = ("method", "step, ms", "a Simulation of each", "run_many", "ratio", "error, px")
    title = f"{ROPES} ropes of {MASSES} masses, {SECONDS:g} s each; ms of processor time"
    console.print(Table(headings, rows, title=title))
    headings = ("method", "Simulation(scene)", "step", "positions", "both")
    rows = [_call_costs(method, repeats) for method in ("symplectic_euler", "auto")]
    console.print(Table(headings, rows, title="A rope of 12 besides its physics; µs of processor time"))


def _call_costs(method: Method, repeats: int) -> tuple[str, ...]:
    """A row of what a simulation of one rope takes besides physics."""
    scenes = ropes(Integrator(method=method), 100)
    simulation = sim.Simulation(scenes[0])
    simulation.step(10)
    contenders: dict[str, Callable[[], object]] = {
        "made": lambda: [sim.Simulation(scene) for scene in scenes],
        "step": lambda: [simulation.step(1) for _ in range(CALLS)],
        "positions": lambda: [simulation.positions for _ in range(CALLS)],
        "both": lambda: [(simulation.step(1), simulation.positions) for _ in range(CALLS)],
    }
    made, *calls = fastest(contenders, repeats, time.process_time).values()
    return method, f"{1e6 * made / len(scenes):.0f}", *(f"{1e6 * seconds / CALLS:.2f}" for seconds in calls)
