"""How much simulated time a frame gets, and what the page says of it.

Time is owed as it passes on the wall. Where the machine cannot pay it all, the rest is dropped and counted
as lag: the clock falls behind, and the next frame is not asked for more than its own share.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

LONGEST_FRAME = 0.1
"""Seconds of wall time that one frame can owe; after a longer silence (a stalled machine, a suspended
laptop) the body goes on from where it was instead of leaping."""

_WINDOW = 1.0
"""Seconds over which the rates are averaged."""


@dataclass(frozen=True)
class Rates:
    """How well the clock keeps up, over the last second.

    Attributes:
        real_time_factor: simulated seconds per second.
        steps_per_second: steps done per second.
        solver_ms: time in the solver per frame, ms.
        behind: simulated seconds that the clock has lost since it was started.
        losing: simulated seconds that it lost in the last second.
    """

    real_time_factor: float = 0.0
    steps_per_second: float = 0.0
    solver_ms: float = 0.0
    behind: float = 0.0
    losing: float = 0.0


class Pacer:
    """Grants steps against the wall clock and a budget of computing time."""

    def __init__(self) -> None:
        self.speed = 1.0
        self.behind = 0.0
        self._last: float | None = None
        self._owed = 0.0
        self._step_cost = 0.0
        self._lost = 0.0
        self._frames: deque[tuple[float, float, int, float, float]] = deque()

    def restart(self) -> None:
        """Owe nothing and forget the rates, as after a pause."""
        self._last = None
        self._owed = 0.0
        self.behind = 0.0
        self._frames.clear()

    def grant(self, now: float, dt: float, budget: float) -> int:
        """Steps that this frame may do.

        Args:
            now: wall time, s.
            dt: time step, s.
            budget: seconds of computing that the frame may take.
        """
        elapsed = 0.0 if self._last is None else max(0.0, now - self._last)
        self._last = now
        lost = max(0.0, elapsed - LONGEST_FRAME) * self.speed
        self._owed += min(elapsed, LONGEST_FRAME) * self.speed
        wanted = int(self._owed / dt + 1e-9)
        # One step always, so that a body too heavy for the budget still moves, and its cost is measured.
        affordable = max(1, int(budget / self._step_cost)) if self._step_cost else max(1, min(wanted, 64))
        steps = min(wanted, affordable)
        self._owed -= steps * dt
        if wanted > steps:
            # A fraction of a step stays owed; the whole ones are lost.
            rest = math.fmod(self._owed, dt)
            lost += self._owed - rest
            self._owed = rest
        self.behind += lost
        self._lost = lost
        return steps

    def record(self, now: float, dt: float, steps: int, seconds: float) -> None:
        """Note what a frame did: steps done and seconds they took."""
        if steps:
            cost = seconds / steps
            self._step_cost = cost if not self._step_cost else 0.8 * self._step_cost + 0.2 * cost
        self._frames.append((now, steps * dt, steps, seconds, self._lost))
        while self._frames and self._frames[0][0] < now - _WINDOW:
            self._frames.popleft()

    def rates(self, now: float) -> Rates:
        """The rates over the last second, or since the restart."""
        if len(self._frames) < 2:
            return Rates(behind=self.behind)
        # The first frame's work was done before the window began.
        span = max(now - self._frames[0][0], 1e-3)
        simulated = sum(frame[1] for frame in self._frames) - self._frames[0][1]
        steps = sum(frame[2] for frame in self._frames) - self._frames[0][2]
        busy = sum(frame[3] for frame in self._frames) / len(self._frames)
        losing = sum(frame[4] for frame in self._frames)
        return Rates(simulated / span, steps / span, busy * 1e3, self.behind, losing)
