"""`softrod bench heap`: rings that fall into a box and onto each other."""

from __future__ import annotations

import math
import time

import msgspec
import numpy as np
from rich.console import Console

import sim
from sim import Integrator, Scene, Simulation
from sim.scene.surroundings import Contact, Wall

from ..reporting.report import Table

RINGS = (10, 84, 250)
"""Numbers of rings."""
FRAME = 1.0 / 60.0
"""Length of a frame, s."""

FRAMES = 300
"""Frames that are timed."""

METHODS = {
    "auto, 0.1 px": Integrator(method="auto", dt=FRAME, tolerance=0.1),
    "Verlet, 0.26 ms": Integrator(method="velocity_verlet", dt=FRAME / 64.0),
    "Euler, 0.26 ms": Integrator(method="symplectic_euler", dt=FRAME / 64.0),
}

_RADIUS = 12.0
"""Of a ring, px."""

_MASSES = 12
"""Of a ring."""

_MIN_ABREAST = 10
"""Rings in a row at least."""

_MAX_HIGH = 8
"""Rows, if there are enough rings for that."""


def heap(rings: int) -> Scene:
    """Return a scene of so many rings of 12 masses above a box that is open at the top."""
    rng = np.random.default_rng(1)
    abreast = max(_MIN_ABREAST, rings // _MAX_HIGH)
    bodies = []
    for i in range(rings):
        middle = np.array((20.0 + 30.0 * (i % abreast), -20.0 - 32.0 * (i // abreast)))
        x, y = (middle + rng.uniform(-2.0, 2.0, 2)).tolist()
        ring = sim.Polygon(
            sides=_MASSES, circumradius=_RADIUS, center=(x, y), mass=0.1,
            stiffness=12000.0, damping=20.0, angular_stiffness=2000.0, angular_damping=5.0,
        )  # fmt: skip
        bodies.append(ring)
    box = ((0.0, 0.0), (0.0, -1.0)), ((0.0, 0.0), (1.0, 0.0)), ((30.0 * abreast + 10.0, 0.0), (-1.0, 0.0))
    return sim.validate(
        Scene(
            name="heap",
            bodies=tuple(bodies),
            gravity=(0.0, 1000.0),
            walls=tuple(Wall(point=point, normal=normal, restitution="constant") for point, normal in box),
            contact=Contact(
                distance=4.0, stiffness=2000.0, friction=0.4, bounciness=0.3, restitution="constant"
            ),
        )
    )


def times(scene: Scene, frames: int, repeats: int) -> tuple[list[float], int, float]:
    """Let a scene fall for some frames.

    Returns:
        Processor time of each frame, s, the shortest of all repeats; the number of steps attempted; and the
        root mean square of the speeds at the end, px/s.
    """
    simulation, steps = Simulation(scene), max(round(FRAME / scene.integrator.dt), 1)
    simulation.step()  # loads the kernels
    best, attempts = [math.inf] * frames, 0
    for _ in range(repeats):
        simulation.reset()
        simulation.stats()
        for i in range(frames):
            began = time.process_time()
            simulation.step(steps)
            best[i] = min(best[i], time.process_time() - began)
        if simulation.divergence is not None:
            raise RuntimeError(f"the heap ran away: {simulation.divergence}")
        stats = simulation.stats()
        attempts = stats.steps + stats.rejected
    return best, attempts, float(np.sqrt((simulation.velocities**2).sum(1).mean()))


def bench_heap(console: Console, repeats: int) -> None:
    """Measure, and print processor time per simulated time: of all, and of the slowest quarter second."""
    rows = []
    quarter = round(0.25 / FRAME)
    for rings in RINGS:
        for name, integrator in METHODS.items():
            scene = msgspec.structs.replace(heap(rings), integrator=integrator)
            best, attempts, speed = times(scene, FRAMES, repeats)
            parts = [sum(best[i : i + quarter]) for i in range(0, len(best), quarter)]
            shares = sum(best) / (FRAME * FRAMES), max(parts) / (FRAME * quarter)
            steps = f"{attempts / (FRAME * FRAMES):.0f}"
            rows.append((str(len(scene.masses)), name, steps, *(f"{n:.3f}" for n in shares), f"{speed:.2g}"))
    headings = ("masses", "method", "steps per s", "all", "slowest 1/4 s", "px/s in the end")
    title = "processor time / simulated time, falling and settling, 5 s"
    console.print(Table(headings, rows, "rl", title))
