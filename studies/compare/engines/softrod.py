"""softrod: all methods on ropes and nets, those that suit contact on heaps."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import msgspec

import sim
from sim import Scene
from sim.motion.solver import Solver
from sim.motion.stability import largest_step
from sim.scene.types import Method
from sim.solve.registry import METHODS

from ..measure import Contender, ladder, steps, tolerances
from ..runs import FRAME, SECONDS, SOFTROD, Failed, Floats, Runner
from ..scenes import HEAP_SECONDS

TOLERANCES = (10.0, 1.0, 0.1, 0.01, 0.001)
"""px, of methods with error control."""

BEYOND = (1.02, 1.1, 1.2, 1.5, 2.0, 3.0, 4.0, 8.0, 16.0, 32.0)
"""Steps of explicit methods, in parts of the smallest number of stable ones."""

UNLIMITED_RATES = tuple(60.0 * 2.0**i for i in range(8))
"""Steps per second of methods that are always stable."""

HEAP_RATES = (960.0, 1440.0, 1920.0, 3840.0, 7680.0)
"""Steps per second in heaps, of methods with a fixed step."""

MAX_ATTEMPTS = 400_000
"""Steps of a method with error control, accepted or not, after which a run is given up."""

MAX_STEPS = 300_000
"""Steps of a method with a fixed step in a run of `softrod study`; with more, a run is refused."""

LONGEST = 0.2
"""Seconds of a run beyond which `softrod study` tries no finer settings."""


class SoftrodRun(Runner):
    """A method of softrod on a scene.

    Args:
        scene: a valid scene.
        integrator: method, step and tolerance.
        steps: steps per frame.
        frames: calls.
    """

    def __init__(self, scene: Scene, integrator: sim.Integrator, steps: int, frames: int = 1) -> None:
        self._steps, self.frames = steps, frames
        self._adaptive = METHODS[integrator.method].adaptive
        self._simulation = sim.Simulation(msgspec.structs.replace(scene, integrator=integrator))
        solver = self._simulation._motion.solver
        if METHODS[integrator.method].implicit and isinstance(solver, Solver):
            _ = solver.matrix  # its pattern is found once
        self._simulation.step(1, MAX_ATTEMPTS // 1000)  # loads machine code
        self._attempts = MAX_ATTEMPTS

    def restart(self) -> None:
        """Go back to the start."""
        self._simulation.reset()
        self._simulation.stats()
        self._attempts = MAX_ATTEMPTS

    def advance(self) -> None:
        """Simulate one frame by one call."""
        done = self._simulation.step(self._steps, self._attempts if self._adaptive else None)
        if (divergence := self._simulation.divergence) is not None:
            raise Failed(f"{divergence.quantity} out of range")
        if done < self._steps:
            raise Failed(f"not done after {MAX_ATTEMPTS} steps")

    def positions(self) -> Floats:
        """Return the positions after a frame, and count its attempts."""
        if self._adaptive:
            stats = self._simulation.stats()
            self._attempts = max(1, self._attempts - stats.steps - stats.rejected)
        return self._simulation.positions


def run_at(scene: Scene, method: str, value: float, frames: int = 1, duration: float = SECONDS) -> SoftrodRun:
    """Prepare a run of a method.

    Args:
        scene: a valid scene.
        method: its name.
        value: tolerance, px, or time step, s, which is rounded so that a whole number of steps makes a frame
            of a page.
        frames: calls.
        duration: s.

    Raises:
        Failed: it would take more than `MAX_STEPS` fixed steps.
    """
    info = METHODS[method]
    per_frame = 1 if info.adaptive else max(1, round(FRAME / value))
    if per_frame * round(duration / FRAME) > MAX_STEPS:
        raise Failed(f"more than {MAX_STEPS} steps")
    tolerance = value if info.adaptive else sim.Integrator().tolerance
    integrator = sim.Integrator(method=info.name, dt=FRAME / per_frame, tolerance=tolerance)
    return SoftrodRun(scene, integrator, round(duration / FRAME) * per_frame // frames, frames)


def studied(scene: Scene, method: str, errors: Sequence[float]) -> Contender:
    """Return a method as `softrod study` tries it: with hindsight, but for `auto`, which gets the error."""
    adaptive = METHODS[method].adaptive
    is_auto = method == "auto"
    return Contender(
        SOFTROD,
        method,
        tolerances(errors, LONGEST, errors if is_auto else ()) if adaptive else steps(errors, LONGEST),
        (lambda value: f"tolerance {value:.2g}") if adaptive else (lambda value: f"dt {1e3 * value:.2g} ms"),
        lambda value: run_at(scene, method, value),
        lambda value: run_at(scene, method, value, round(SECONDS / FRAME)),
        times_frames=is_auto,
    )


def paths(scene: Scene) -> list[Contender]:
    """All methods on a rope or a net."""
    made = [_adaptive(scene, method, TOLERANCES, 1) for method, info in METHODS.items() if info.adaptive]
    for method, info in METHODS.items():
        if info.adaptive or method == "stable_spring":  # which makes springs softer than they are
            continue
        rates: Sequence[float] = UNLIMITED_RATES
        if info.limit is not None:
            rates = [SECONDS / largest_step(scene, method) * part for part in BEYOND]
        made.append(_fixed(scene, info.name, rates, SECONDS, 1))
    return made


def heaps(scene: Scene) -> list[Contender]:
    """The methods that suit contact, frame by frame."""
    frames = round(HEAP_SECONDS / FRAME)
    fixed: tuple[Method, ...] = ("velocity_verlet", "symplectic_euler")
    return [
        _adaptive(scene, "auto", TOLERANCES[:4], frames, HEAP_SECONDS),
        *(_fixed(scene, method, HEAP_RATES, HEAP_SECONDS, frames) for method in fixed),
    ]


def _adaptive(
    scene: Scene, method: str, values: Sequence[float], frames: int, duration: float = SECONDS
) -> Contender:
    return Contender(
        SOFTROD,
        method,
        ladder(values, whole=method == "auto"),
        lambda value: f"{value:g} px",
        lambda value: run_at(scene, method, value, frames, duration),
    )


def _fixed(scene: Scene, method: Method, rates: Sequence[float], duration: float, frames: int) -> Contender:
    def make(rate: float) -> Runner:
        per_frame = max(1, round(rate * duration / frames))
        dt = duration / frames / per_frame
        if dt < 1e-6:
            raise Failed("steps of less than a millionth of a second")
        return SoftrodRun(scene, sim.Integrator(method=method, dt=dt), per_frame, frames)

    text: Callable[[float], str] = lambda rate: f"{round(rate)} steps/s"  # noqa: E731
    return Contender(SOFTROD, method, ladder(rates), text, make)
