"""How far a body can be foretold: two others that come apart, in the time that a frame leaves."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.predictability import MANY, Shadow, factor_of, growth_within, verdict

from .companion import Companion
from .pacing import smoothed

SPAN = 1.0
"""Simulated seconds whose growth is told."""

WINDOW = 1.6 * SPAN
"""Simulated seconds that are kept for that."""

_LATE = 0.1
"""Simulated seconds that it may be late; then it goes on from where the body is."""


class ShadowMoment(NamedTuple):
    """What tells how errors grow, at a moment that is past.

    Attributes:
        hair: (4, n) the direction in which two bodies came apart, see `sim.analysis.predictability.Shadow`.
        level: natural logarithm of how much they had by then.
    """

    hair: NDArray[np.float64]
    level: float


class PredictabilityMeter(Companion):
    """Tells how fast errors grow in the motion of a session's body.

    Args:
        simulation: the body.
        wait: whether its steps may wait for the compiler.

    Attributes:
        shadow: the two bodies.
    """

    name, span = "predictability", WINDOW

    def __init__(self, simulation: sim.Simulation, wait: bool = True) -> None:
        self.shadow = Shadow(simulation, wait)
        super().__init__(self.shadow.pair)
        self._step_cost = 0.0
        self._owed = 0
        self._seen = 0.0  # simulated seconds that were followed, s
        self._samples: deque[tuple[float, float]] = deque([(0.0, 0.0)])
        self._scene = simulation.scene

    def adapt(self, simulation: sim.Simulation) -> None:
        """Go on from where the body is now."""
        self.shadow.place(simulation)
        self._owed = 0

    def begin(self, simulation: sim.Simulation) -> None:
        """Forget what was, as for another motion."""
        self.adapt(simulation)
        self._samples = deque([(self._seen, self.shadow.level)])

    def capture(self) -> ShadowMoment:
        """What there is to come back to."""
        return ShadowMoment(self.shadow.hair, self.shadow.level)

    def go_back(self, past: Sequence[tuple[float, ShadowMoment]], simulation: sim.Simulation) -> None:
        """See `Companion`."""
        if not past:
            self.begin(simulation)
            return
        self._seen, last = past[-1]
        self.shadow.place(simulation, last.hair)
        self.shadow.level, self._owed = last.level, 0
        self._samples = deque((at, moment.level) for at, moment in past)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Go on by what the body has just done, as far as there is time."""
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
        """By how much the logarithm of an error has grown in the last second; None if it is not known."""
        times, levels = zip(*self._samples, strict=True)
        return None if self.shadow.held else growth_within(times, levels, SPAN)

    @property
    def is_chaotic(self) -> bool:
        """Whether errors grow too fast for any tolerance."""
        return self.growth is not None and factor_of(self.growth / SPAN) >= MANY

    @property
    def verdict(self) -> str:
        """What the growth means, in words; empty if it is not known."""
        return "" if self.growth is None else verdict(self._scene, factor_of(self.growth / SPAN))
