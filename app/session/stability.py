"""Looks at the stability limit of a session's body now and then, in a small share of its time."""

from __future__ import annotations

import math
import time

import sim
from sim.motion.stability import Look, StabilityEstimate

from .hand import FRAME

_EVERY, _SHARE = 0.25, 0.02
"""Seconds between two looks, at least; and the share of a frame's budget that they may take."""

_LOOK_SHARE = 0.1
"""Share of a frame's budget that a look may take: that at a large body goes on over many frames."""


class StabilityWatch:
    """Keeps an estimate of the stability limit.

    Attributes:
        estimate: the last look's.
    """

    def __init__(self) -> None:
        self.forget()
        self._of = -1  # revision at the last look

    def forget(self) -> None:
        """Another body: nothing is known of it."""
        self.estimate = StabilityEstimate(math.inf, None)
        self._look: Look | None = None
        self._spent = 0.0  # seconds of computing that the present look has taken
        self._due = 0.0

    def look_soon(self) -> None:
        """Look as soon as may be: something has changed."""
        self._due = 0.0

    def set(self, estimate: StabilityEstimate, revision: int) -> None:
        """The estimate is this one, whatever a look would find, until the revision changes."""
        self.estimate, self._look, self._of = estimate, None, revision

    @property
    def is_looking(self) -> bool:
        """Whether `estimate` is still to be that of the present body."""
        return self._look is not None

    def tick(
        self, simulation: sim.Simulation, revision: int, running: bool, now: float, budget: float
    ) -> None:
        """Begin or go on with a look, if it is time, for a share of the frame, but by one part at least.

        Args:
            simulation: the body.
            revision: of its settings.
            running: whether the clock runs; while it stands, only what its user changes can move the limit.
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
