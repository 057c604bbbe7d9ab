"""Who is compared: softrod's methods, in one call and frame by frame as on the page, and other solvers."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Protocol

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim import Scene
from sim.methods.registry import METHODS
from sim.motion.solver import Solver

from . import others
from .equations import Equations

Points = NDArray[np.float64]

FRAMES = 60
"""Times at which a path is looked at, per second."""

DURATION = 1.0
"""Simulated time of a run, s."""

SAMPLES = round(DURATION * FRAMES)

ATTEMPTS = 300_000
"""Steps of softrod's error-controlled methods, kept or not, after which a run counts as failed."""

PATIENCE = 5.0
"""Seconds after which a run by another solver is given up."""


@dataclass(frozen=True)
class Trial:
    """What came of a setting.

    Attributes:
        path: (frames, n, 2) px, the last of them at the end; None where it failed.
        seconds: of computing.
        failure: why there is no path, or empty.
    """

    path: Points | None
    seconds: float
    failure: str = ""


class Contender(Protocol):
    """A method at one step or tolerance, ready to go; what can be made beforehand is made before any clock
    starts: tables, patterns of matrices, machine code."""

    def in_one_call(self) -> Trial:
        """Do all of it in one call, with one frame at the end."""
        ...

    def frame_by_frame(self) -> Trial:
        """Do it with a look at every frame."""
        ...


class Ours:
    """One of softrod's methods on a scene.

    Args:
        scene: a valid scene.
        method: its name.
        value: time step, s, or tolerance, px. A step is rounded so that a whole number of them makes a frame.
    """

    def __init__(self, scene: Scene, method: str, value: float) -> None:
        info = METHODS[method]
        self._steps = 1 if info.adaptive else max(1, round(1.0 / FRAMES / value))
        integrator = sim.Integrator(
            method=info.name,
            dt=1.0 / FRAMES / self._steps,
            tolerance=value if info.adaptive else sim.Integrator().tolerance,
        )
        self._simulation = sim.Simulation(msgspec.structs.replace(scene, integrator=integrator))
        solver = self._simulation._stepper.solver
        if info.implicit and isinstance(solver, Solver):
            _ = solver.matrix

    def in_one_call(self) -> Trial:
        """All of it by one call of `Simulation.step`."""
        return self._go(1)

    def frame_by_frame(self) -> Trial:
        """A call for each frame, each going on from what the one before left."""
        return self._go(SAMPLES)

    def _go(self, calls: int) -> Trial:
        simulation, steps = self._simulation, self._steps * SAMPLES // calls
        simulation.reset()
        path = np.empty((calls, len(simulation.scene.masses), 2))
        seconds, left = 0.0, ATTEMPTS
        for call in range(calls):
            began = time.perf_counter()
            done = simulation.step(steps, max(left, 1))
            seconds += time.perf_counter() - began
            if simulation.divergence is not None:
                return Trial(None, seconds, f"{simulation.divergence.quantity} out of range")
            if done < steps:
                return Trial(None, seconds, f"not done after {ATTEMPTS} steps")
            if METHODS[simulation.method].adaptive:
                stats = simulation.stats()
                left -= stats.steps + stats.rejected
            path[call] = simulation.positions
        return Trial(path, seconds)


class Theirs:
    """Another solver on a scene's equations; `value` is its absolute tolerance, see `others`."""

    def __init__(self, equations: Equations, solver: str, value: float) -> None:
        self._equations, self._value = equations, value
        self.solve = others.solver(solver, equations)
        self._derivative = equations.derivative_into()

    def in_one_call(self) -> Trial:
        """All of it, with no look before the end."""
        return self._go(np.array([DURATION]), self._derivative)

    def frame_by_frame(self) -> Trial:
        """All of it in one call, and where the solver says it was at every frame; given up after a while."""
        deadline = time.perf_counter() + PATIENCE

        def watched(t: float, y: others.Floats, out: others.Floats) -> None:
            if time.perf_counter() > deadline:
                raise others.Failed(f"not done after {PATIENCE:g} s")
            self._derivative(t, y, out)

        return self._go(np.linspace(0.0, DURATION, SAMPLES + 1)[1:], watched)

    def _go(self, times: Points, derivative: others.Derivative) -> Trial:
        began = time.perf_counter()
        try:
            found = self.solve(self._value, times, derivative)
        except (others.Failed, ArithmeticError, RuntimeError, ValueError) as error:
            return Trial(
                None, time.perf_counter() - began, " ".join(str(error).split()) or type(error).__name__
            )
        seconds = time.perf_counter() - began
        path = np.array([self._equations.positions(t, y) for t, y in zip(times, found, strict=True)])
        if not np.isfinite(path).all():
            return Trial(None, seconds, "not a finite number")
        return Trial(path, seconds)


def distance(one: Points, other: Points) -> float:
    """The largest distance between two positions of a mass, px."""
    return float(np.sqrt(((one - other) ** 2).sum(-1)).max())


@dataclass(frozen=True)
class Reference:
    """What two methods agree on.

    Attributes:
        path: (frames, n, 2) px.
        doubt: how far they are apart at most, px; infinite where one of them has not arrived.
    """

    path: Points
    doubt: float


REFERENCES = ("adams", "rodas5p")
"""Methods of very different kinds."""


def reference(scene: Scene, tolerances: tuple[float, ...], good: float) -> Reference:
    """The path of `REFERENCES`' first method, at the first tolerance at which both agree to `good`, px, or
    else at the one at which they agree best.

    Raises:
        sim.InputError: neither arrives.
    """
    best: Reference | None = None
    for tolerance in tolerances:
        paths = [Ours(scene, method, tolerance).frame_by_frame().path for method in REFERENCES]
        arrived = [path for path in paths if path is not None]
        if not arrived:
            continue
        found = Reference(arrived[0], distance(*arrived) if len(arrived) == 2 else np.inf)
        if best is None or found.doubt < best.doubt:
            best = found
        if best.doubt <= good:
            break
    if best is None:
        raise sim.InputError(f"{scene.name}: no method gets to the end of {DURATION:g} s at tight tolerances")
    return best
