"""`softrod bench growth`: the cost of a step as the body grows."""

from __future__ import annotations

import math
import time

import msgspec
from rich.console import Console

import sim
from sim import Anchor, AngularSpring, Integrator, LinearSpring, Mass, Scene
from sim.scene.types import ForceLaw

from ..reporting.report import Table

SIZES = (10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000)
"""Masses. The largest are more than a scene's file may have."""

WORK = 1_500_000
"""Masses times steps of one timed run."""

EULER = Integrator(method="symplectic_euler", dt=1e-6)
VERLET = Integrator(method="velocity_verlet", dt=1e-6)
RODAS = Integrator(method="rodas4", dt=1.0)

COLUMNS: dict[str, tuple[Integrator, ForceLaw, bool]] = {
    "Euler, chain": (EULER, "tutorial", True),
    "Euler, general": (EULER, "tutorial", False),
    "Verlet, chain": (VERLET, "conservative", True),
    "Verlet, general": (VERLET, "conservative", False),
    "RODAS 4, chain": (RODAS, "conservative", True),
    "RODAS 4, general": (RODAS, "conservative", False),
}
"""The tutorial's step, and those of the explicit and the implicit method of `auto`: by the path for chains,
and by that for any topology."""


class _Large(sim.Simulation):
    """A simulation of a scene that is too large for a file."""

    def _with_overrides(self, scene: Scene) -> Scene:
        return scene


def rod(masses: int, chain: bool) -> Scene:
    """Return a rod of so many masses, horizontal, held at one end and bent a little.

    If it is not to be recognised as a chain, its first spring points the other way.
    """
    spacing = 10.0
    ends = [(i, i + 1) for i in range(masses - 1)]
    if not chain:
        ends[0] = (1, 0)
    return Scene(
        name="rod",
        masses=tuple(Mass(position=(spacing * i, math.sin(0.7 * i))) for i in range(masses)),
        linear_springs=tuple(
            LinearSpring(a=a, b=b, stiffness=1e4, damping=40.0, rest_length=spacing) for a, b in ends
        ),
        angular_springs=tuple(
            AngularSpring(a=j, b=j + 1, stiffness=1e4, rest_angle=180.0 if j == 0 and not chain else 0.0)
            for j in range(masses - 2)
        ),
        anchors=(Anchor(mass=0),),
        gravity=(0.0, 2000.0),
        air_friction=0.002,
        air_law="tutorial",
    )


def step_costs(masses: int, repeats: int) -> dict[str, float]:
    """Return ns per mass and step, the lowest of repeats in turns, for each of the columns."""
    steps = max(3, WORK // (10 * masses))
    ready = {}
    for name, (integrator, law, chain) in COLUMNS.items():
        scene = msgspec.structs.replace(rod(masses, chain), integrator=integrator, force_law=law)
        simulation = ready[name] = _Large(scene)
        simulation.step(1, attempts=2)
        simulation.stats()
    best = dict.fromkeys(ready, math.inf)
    for _ in range(repeats):
        for name, simulation in ready.items():
            adaptive = COLUMNS[name][0] is RODAS
            began = time.perf_counter()
            simulation.step(1000 if adaptive else steps, attempts=max(3, steps // 10) if adaptive else None)
            seconds = time.perf_counter() - began
            if simulation.divergence is not None:
                raise RuntimeError(f"the rod ran away: {simulation.divergence}")
            stats = simulation.stats()
            best[name] = min(best[name], seconds / (masses * (stats.steps + stats.rejected)) * 1e9)
    return best


def bench_growth(console: Console, repeats: int) -> None:
    """Measure, and print ns per mass and step for each size."""
    rows = []
    for masses in SIZES:
        costs = step_costs(masses, repeats)
        rows.append((str(masses), *(f"{costs[name]:.1f}" for name in COLUMNS)))
    console.print(Table(("masses", *COLUMNS), rows, title="ns per mass and step"))
