"""`softrod bench ensemble`: many ropes at once, a lane of a vector each, and the same ropes one by one."""

from __future__ import annotations

from collections.abc import Callable

from rich.console import Console
from rich.table import Table

import sim
from sim.ensemble import LANES, Member, run_ensemble

from . import fastest

MASSES, STEPS = 12, 60_000
STEP = 1e-6
"""s; a tiny step: the arithmetic is the same, and the body stays put."""
NAMES = ("one by one", "ensemble, 1 thread", "ensemble, 2 threads")


def contenders(method: str, law: str) -> dict[str, Callable[[], None]]:
    """Two batches of ropes under the tutorial's constants, all different, in three ways."""
    scenes = [
        sim.rope(MASSES, length=290.0 + i, direction=(1.0, 0.1 * i), force_law=law)  # type: ignore[arg-type]
        for i in range(2 * LANES)
    ]
    members = [Member(scene, STEP, (STEPS,)) for scene in scenes]
    simulations = [sim.Simulation(scene, dt=STEP, integrator=method) for scene in scenes]

    def one_by_one() -> None:
        for simulation in simulations:
            if simulation.step(STEPS) != STEPS:
                raise RuntimeError(f"the body ran away: {simulation.divergence}")

    return {
        NAMES[0]: one_by_one,
        NAMES[1]: lambda: _run(members, method, 1),
        NAMES[2]: lambda: _run(members, method, 2),
    }


def _run(members: list[Member], method: str, threads: int) -> None:
    if len(dict(run_ensemble(members, method, threads))) != len(members):
        raise RuntimeError("a body is missing")


def bench_ensemble(console: Console, repeats: int) -> None:
    """Measure, and print ns per mass and step and the ratios that matter."""
    table = Table("method", "law", *NAMES, "one / ensemble, per core", "one / ensemble, two cores", box=None)
    for method in ("symplectic_euler", "velocity_verlet", "rk4"):
        for law in ("tutorial", "conservative"):
            times = fastest(contenders(method, law), repeats)
            work = 2 * LANES * MASSES * STEPS
            one, alone, both = (times[name] for name in NAMES)
            ns = [f"{1e9 * seconds / work:.2f}" for seconds in (one, alone, both)]
            table.add_row(method, law, *ns, f"{one / alone:.2f}", f"{one / both:.2f}")
    console.print(f"{2 * LANES} ropes of {MASSES} masses, ns per mass and step")
    console.print(table)
