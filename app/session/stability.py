"""Estimates the stability limit of a session's body now and then, in a small share of each frame."""

from __future__ import annotations

import math
import time

import sim
from sim.motion.stability import LimitEstimate, StabilityEstimate

from .hand import FRAME

_EVERY = 0.25
"""Seconds between two estimates, at least."""
_SHARE = 0.02
"""Share of all frames' budget that estimates may take: after an expensive one the next comes later."""

_LOOK_SHARE = 0.1
"""Share of one frame's budget that an estimate may take: that of a large body takes many frames."""


class StabilityWatch:
    """Keeps an estimate of the stability limit up to date.

    Attributes:
        estimate: the last one.
    """

    def __init__(self) -> None:
        self.forget()
        self._of = -1  # revision of the last estimate

    def forget(self) -> None:
        """Forget the estimate: it is of another body."""
        self.estimate = StabilityEstimate(math.inf, None)
        self._look: LimitEstimate | None = None
        self._spent = 0.0  # seconds of computing for the estimate under way
        self._due = 0.0

    def look_soon(self) -> None:
        """Estimate again in the next frame: something has changed."""
        self._due = 0.0

    def set(self, estimate: StabilityEstimate, revision: int) -> None:
        """Set the estimate, until the revision changes."""
        self.estimate, self._look, self._of = estimate, None, revision

    @property
    def is_looking(self) -> bool:
        """Whether an estimate of the present body is under way."""
        return self._look is not None

    def tick(
        self, simulation: sim.Simulation, revision: int, running: bool, now: float, budget: float
    ) -> None:
        """Begin or continue an estimate if one is due, by at least one part.

        Args:
            simulation: the body.
            revision: of its settings.
            running: whether the clock runs; if not, only changes by the user can move the limit.
            now: wall time, s.
            budget: seconds of computing of a frame.
        """
        if self._look is None:
            if now < self._due or not (running or self._of != revision):
                return
            self._of, self._spent = revision, 0.0
            self._look = simulation.stability_in_parts()
        began = time.perf_counter()
        try:
            next(self._look)
            while time.perf_counter() - began < _LOOK_SHARE * budget:
                next(self._look)
        except StopIteration as end:
            self._look, self.estimate = None, end.value
        self._spent += time.perf_counter() - began
        if self._look is None and self._of == revision:
            self._due = now + max(_EVERY, self._spent / (_SHARE * budget / FRAME))
