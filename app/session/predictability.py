"""How predictable a body is: how fast two copies of it diverge, stepped in what time a frame has left."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.predictability import MANY, STILL, TwinTrajectory, factor_of, growth_within, horizon
from sim.solve.registry import METHODS

from ..words import decimal, say
from .companions import Companion
from .pacing import smoothed

SPAN = 1.0
"""Simulated seconds over which growth is reported."""

WINDOW = 1.6 * SPAN
"""Simulated seconds of samples stored for that."""

_LATE = 0.1
"""Simulated seconds that the copies may lag; beyond, they start from the body again."""


class ShadowMoment(NamedTuple):
    """A meter at a past moment.

    Attributes:
        hair: (4, n) direction in which the copies differed, see `sim.analysis.predictability.TwinTrajectory`.
        level: natural logarithm of the growth of their difference up to then.
    """

    hair: NDArray[np.float64]
    level: float


class PredictabilityMeter(Companion):
    """Measures how fast errors grow in the motion of a session's body.

    Args:
        simulation: the body.
        wait: whether its steps may wait for the compiler.

    Attributes:
        shadow: the two copies.
    """

    name, span = "predictability", WINDOW

    def __init__(self, simulation: sim.Simulation, wait: bool = True) -> None:
        self.shadow = TwinTrajectory(simulation, wait)
        super().__init__(self.shadow.pair)
        self._step_cost = 0.0
        self._owed = 0
        self._seen = 0.0  # simulated seconds that the copies have followed
        self._samples: deque[tuple[float, float]] = deque([(0.0, 0.0)])
        self._scene = simulation.scene

    def adapt(self, simulation: sim.Simulation) -> None:
        self.shadow.place(simulation)
        self._owed = 0

    def begin(self, simulation: sim.Simulation) -> None:
        self.adapt(simulation)
        self._samples = deque([(self._seen, self.shadow.level)])

    def capture(self) -> ShadowMoment:
        return ShadowMoment(self.shadow.hair, self.shadow.level)

    def go_back(self, past: Sequence[tuple[float, ShadowMoment]], simulation: sim.Simulation) -> None:
        if not past:
            self.begin(simulation)
            return
        self._seen, last = past[-1]
        self.shadow.place(simulation, last.hair)
        self.shadow.level, self._owed = last.level, 0
        self._samples = deque((at, moment.level) for at, moment in past)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Step the copies as far as the budget allows, and note how far apart they are."""
        self._owed += steps
        if not self._owed or simulation.divergence is not None:
            return
        began = time.perf_counter()
        affordable = max(1, int(budget / self._step_cost)) if self._step_cost else self._owed
        steps = min(self._owed, affordable)
        arrived = self.shadow.step(steps, self.costs.attempts(0.5 * budget))
        self._owed -= steps
        if arrived:
            self._seen += steps * simulation.dt
            self._samples.append((self._seen, self.shadow.level))
            while self._samples[0][0] < self._seen - WINDOW:
                self._samples.popleft()
        if not arrived or self._owed * simulation.dt > _LATE or (self.shadow.due and not self._owed):
            self.adapt(simulation)
        took = time.perf_counter() - began
        self._step_cost = smoothed(self._step_cost, took / steps)
        self.costs.learn(0, took, sum(body.work for body in self.bodies))
        self._count(took)
        self._scene = simulation.scene

    @property
    def growth(self) -> float | None:
        """Growth of the logarithm of an error over the last `SPAN`; None if unknown."""
        times, levels = zip(*self._samples, strict=True)
        return None if self.shadow.held else growth_within(times, levels, SPAN)

    @property
    def is_chaotic(self) -> bool:
        """Whether errors grow too fast for any tolerance."""
        return self.growth is not None and factor_of(self.growth / SPAN) >= MANY

    @property
    def verdict(self) -> str:
        """What the growth means, in a sentence; empty if unknown."""
        return "" if self.growth is None else verdict(self._scene, factor_of(self.growth / SPAN))


def verdict(scene: sim.Scene, per_second: float) -> str:
    """What a growth of errors means for a scene's tolerance or time step, in a sentence.

    `sim.analysis.predictability` says it in English.

    Args:
        scene: the scene.
        per_second: the factor by which errors grow per second.
    """
    adaptive, factor = METHODS[scene.integrator.method].adaptive, decimal(f"{per_second:.2g}")
    if per_second >= MANY:
        seconds = decimal(f"{horizon(scene, per_second):.2g}")
        if adaptive:
            return say("session-errors-lost", factor=factor, seconds=seconds)
        return say("session-errors-lost.step", factor=factor, seconds=seconds)
    grows = per_second >= STILL
    if not adaptive:
        return say("session-errors-step.grow", factor=factor) if grows else say("session-errors-step")
    tolerance = decimal(f"{scene.integrator.tolerance:g} {scene.view.unit}")
    if grows:
        return say("session-errors-kept.grow", factor=factor, tolerance=tolerance)
    return say("session-errors-kept", tolerance=tolerance)
