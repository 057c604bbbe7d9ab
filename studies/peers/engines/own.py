"""softrod itself: all of its methods on ropes and nets, those that have contact on heaps."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import msgspec

import sim
from sim import Scene
from sim.methods.registry import METHODS
from sim.motion.solver import Solver
from sim.motion.stability import largest_step

from ..plain import Floats
from ..runs import FRAME, Failed, Ladder
from ..scenes import HEAPS, MANY, PATHS, SECONDS

NAME = "softrod"

TOLERANCES = (10.0, 1.0, 0.1, 0.01, 0.001)
"""px, of methods that keep to one."""

BEYOND = (1.02, 1.1, 1.2, 1.5, 2.0, 3.0, 4.0, 8.0, 16.0, 32.0)
"""Steps of explicit methods, as parts of the least number of stable ones."""

FREE = tuple(60.0 * 2.0**i for i in range(8))
"""Steps a second of methods that are always stable."""

HEAP_STEPS = (960.0, 1440.0, 1920.0, 3840.0, 7680.0)
"""Steps a second of methods with a fixed step, of heaps."""

ATTEMPTS = 400_000
"""Steps after which a method that chooses them is given up."""


def missing() -> str:
    """See `engines`."""
    return ""


def ladders(name: str) -> list[Ladder]:
    """See `engines`."""
    if name in HEAPS:
        scene = HEAPS[name]()
        steps = [
            _fixed(scene, method, HEAP_STEPS, FRAME) for method in ("velocity_verlet", "symplectic_euler")
        ]
        return [_adaptive(scene, "auto", TOLERANCES[:4], FRAME), *steps]
    if name == MANY:
        from . import many

        return many.ladders_of_softrod()
    if name not in PATHS:
        return []
    scene = PATHS[name].make()
    made = [
        _adaptive(scene, method, TOLERANCES, SECONDS) for method, info in METHODS.items() if info.adaptive
    ]
    for method, info in METHODS.items():
        if method == "stable_spring":
            continue  # it makes springs softer than they are
        if not info.adaptive and info.limit is not None:
            least = SECONDS / largest_step(scene, method)
            made.append(_fixed(scene, method, [least * part for part in BEYOND], SECONDS))
        elif not info.adaptive:
            made.append(_fixed(scene, method, FREE, SECONDS))
    return made


def _adaptive(scene: Scene, method: str, tolerances: Sequence[float], duration: float) -> Ladder:
    def make(tolerance: float) -> _Run:
        frame = sim.Integrator(method=METHODS[method].name, dt=FRAME, tolerance=tolerance)
        return _Run(scene, frame, round(duration / FRAME))

    return Ladder(
        NAME, METHODS[method].label, tolerances, lambda value: f"{value:g} px", make, method == "auto"
    )


def _fixed(scene: Scene, method: str, rates: Sequence[float], duration: float) -> Ladder:
    def make(rate: float) -> _Run:
        steps = max(1, round(rate * duration))
        if duration / steps < 1e-6:
            raise Failed("steps of less than a millionth of a second")
        return _Run(scene, sim.Integrator(method=METHODS[method].name, dt=duration / steps), steps)

    text: Callable[[float], str] = lambda rate: f"{round(rate)} steps/s"  # noqa: E731
    return Ladder(NAME, METHODS[method].label, rates, text, make)


class _Run:
    """See `Runner`."""

    def __init__(self, scene: Scene, integrator: sim.Integrator, steps: int) -> None:
        self._steps = steps
        self._simulation = sim.Simulation(msgspec.structs.replace(scene, integrator=integrator))
        solver = self._simulation._stepper.solver
        if METHODS[integrator.method].implicit and isinstance(solver, Solver):
            _ = solver.matrix
        self._simulation.step(1, ATTEMPTS // 1000)  # machine code

    def restart(self) -> None:
        self._simulation.reset()

    def advance(self) -> None:
        done = self._simulation.step(
            self._steps, ATTEMPTS if METHODS[self._simulation.method].adaptive else None
        )
        if self._simulation.divergence is not None:
            raise Failed("ran away")
        if done < self._steps:
            raise Failed(f"not done after {ATTEMPTS} steps")

    def positions(self) -> Floats:
        return self._simulation.positions
