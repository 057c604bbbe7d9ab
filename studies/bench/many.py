"""`softrod bench many`: many small bodies, and what a simulation of one takes besides physics."""

from __future__ import annotations

import time
from collections.abc import Callable

import msgspec
import numpy as np
from rich.console import Console
from rich.table import Table

import sim
from sim import Integrator, Scene
from sim.scene.types import Method

ROPES, MASSES = 1000, 12
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
"""What errors are measured against: method, and step in s. It is within 1e-8 px of `rodas5p` at 1e-8 px."""
CHECKED = 100
"""From one rope of which the error is measured to the next."""

CALLS = 2000
"""Of `step`, for the time of one."""


def ropes(integrator: Integrator, count: int = ROPES) -> list[Scene]:
    """Ropes that differ in stiffness and in the mass of their parts, and swing down from the side."""
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


def one_by_one(scenes: list[Scene]) -> list[np.ndarray]:
    """The ends of all, by a `Simulation` of each."""
    ends = []
    for scene in scenes:
        simulation = sim.Simulation(scene)
        simulation.advance(SECONDS)
        ends.append(simulation.positions)
    return ends


def together(scenes: list[Scene]) -> list[np.ndarray]:
    """The same by `run_many`."""
    return [run.positions for run in sim.run_many(scenes, SECONDS)]


def errors(scenes: list[Scene], ends: list[np.ndarray]) -> float:
    """The largest distance of a mass from where it should be, px, in some of the scenes."""
    method, dt = REFERENCE
    exact = Integrator(method=method, dt=dt)
    some = [msgspec.structs.replace(scene, integrator=exact) for scene in scenes[::CHECKED]]
    return max(
        float(np.hypot(*(end - there).T).max())
        for end, there in zip(ends[::CHECKED], one_by_one(some), strict=True)
    )


def fastest(call: Callable[[], object], repeats: int) -> float:
    """Seconds of processor time."""
    best = np.inf
    for _ in range(repeats):
        before = time.process_time()
        call()
        best = min(best, time.process_time() - before)
    return best


def bench_many(console: Console, repeats: int) -> None:
    """Print what takes how long."""
    table = Table(title=f"{ROPES} ropes of {MASSES} masses, {SECONDS:g} s each; ms of processor time")
    for name in ("method", "step, ms", "a Simulation of each", "run_many", "ratio", "error, px"):
        table.add_column(name, justify="left" if name == "method" else "right")
    for method, dt in METHODS:
        scenes = ropes(Integrator(method=method, dt=dt))
        with console.status(f"compiling {method}"):  # minutes where nothing is on the disk
            together(scenes[:8])
            one_by_one(scenes[:8])
        each = many = np.inf
        for _ in range(repeats):  # in turns, so that both have the same machine
            each = min(each, fastest(lambda scenes=scenes: one_by_one(scenes), 1))
            many = min(many, fastest(lambda scenes=scenes: together(scenes), 1))
        off = errors(scenes, together(scenes))
        table.add_row(
            method,
            f"{1e3 * dt:g}",
            f"{1e3 * each:.0f}",
            f"{1e3 * many:.1f}",
            f"{each / many:.1f}",
            f"{off:.2g}",
        )
    console.print(table)
    table = Table(title="A rope of 12 besides its physics; µs of processor time")
    for name in ("method", "Simulation(scene)", "step", "positions", "both"):
        table.add_column(name, justify="left" if name == "method" else "right")
    for method in ("symplectic_euler", "auto"):
        scenes = ropes(Integrator(method=method), 100)
        simulation = sim.Simulation(scenes[0])
        simulation.step(10)
        of_many = fastest(lambda scenes=scenes: [sim.Simulation(scene) for scene in scenes], repeats)
        calls: tuple[Callable[[], object], ...] = (
            lambda s=simulation: [s.step(1) for _ in range(CALLS)],
            lambda s=simulation: [s.positions for _ in range(CALLS)],
            lambda s=simulation: [(s.step(1), s.positions) for _ in range(CALLS)],
        )
        of_calls = [fastest(call, repeats) / CALLS for call in calls]
        table.add_row(method, f"{1e4 * of_many:.0f}", *(f"{1e6 * seconds:.2f}" for seconds in of_calls))
    console.print(table)
