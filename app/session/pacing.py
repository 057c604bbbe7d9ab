"""How much simulated time a frame gets, and what the page says of it.

Time is owed as it passes on the wall. Where the machine cannot pay it all, the rest is dropped and counted
as lag: the clock falls behind, and the next frame is not asked for more than its own share.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from sim import Scene
from sim.motion.solver import SolverStats

LONGEST_FRAME = 0.1
"""Seconds of wall time that one frame can owe; after a longer silence (a stalled machine, a suspended
laptop) the body goes on from where it was instead of leaping."""

HEAVY_UNIT = 0.004
"""Seconds of one step, or one attempt at a step, from which on a body is heavy."""

LARGE = 2000
"""Masses and springs from which on a scene counts as heavy before anything is known of its steps."""

_FEWEST_ATTEMPTS = 8
"""Steps that a method may try in any frame, as far as `_LATE` allows: a body too heavy for the budget still
moves."""
_LATE = 0.05
"""Seconds by which these may exceed the budget. One step may always be tried."""

_MOST_ATTEMPTS = 1_000_000
"""Steps that it may try at most: what a log may say."""

_PIECE = 0.7
"""What is left of a frame's budget that is planned at once: what steps cost may change at any moment."""
_REST = 0.1
"""What may be left of a frame's budget."""

_WINDOW = 1.0
"""Seconds over which the rates are averaged."""


@dataclass(frozen=True)
class Rates:
    """How well the clock keeps up, over the last second.

    Attributes:
        real_time_factor: simulated seconds per second.
        steps_per_second: steps of the method done per second.
        rejected_per_second: steps tried in vain per second.
        solver_ms: time in the solver per frame, ms.
        behind: simulated seconds that the clock has lost since it was started.
        losing: simulated seconds that it lost in the last second.
    """

    real_time_factor: float = 0.0
    steps_per_second: float = 0.0
    rejected_per_second: float = 0.0
    solver_ms: float = 0.0
    behind: float = 0.0
    losing: float = 0.0


class Pacer:
    """Grants steps against the wall clock and a budget of computing time.

    Args and attributes:
        speed: simulated seconds per second.

    Attributes:
        behind: simulated seconds that the clock has lost since it was started.
    """

    def __init__(self, speed: float = 1.0) -> None:
        self.speed = speed
        self.behind = 0.0
        self._last: float | None = None
        self._owed = 0.0
        self._step_cost = 0.0
        self._lost = 0.0
        self._attempt_cost = 0.0
        self._frames: deque[tuple[float, float, int, int, float, float]] = deque()

    @property
    def unit_cost(self) -> float:
        """Seconds of what cannot be divided: one step, or one attempt at one."""
        return self._attempt_cost or self._step_cost

    def restart(self) -> None:
        """Owe nothing and forget the rates, as after a pause."""
        self._last = None
        self._owed = 0.0
        self.behind = 0.0
        self._frames.clear()

    def grant(self, now: float, dt: float) -> int:
        """Steps that this frame should do.

        Args:
            now: wall time, s.
            dt: time step, s.
        """
        elapsed = 0.0 if self._last is None else max(0.0, now - self._last)
        self._last = now
        self._lost = max(0.0, elapsed - LONGEST_FRAME) * self.speed
        self.behind += self._lost
        self._owed += min(elapsed, LONGEST_FRAME) * self.speed
        steps = int(self._owed / dt + 1e-9)
        self._owed -= steps * dt
        return steps

    def piece(self, steps: int, left: float, adaptive: bool) -> tuple[int, int]:
        """What of a frame should be done next, by what steps have cost until now.

        Args:
            steps: time steps of the frame that are left.
            left: seconds of its budget that are left.
            adaptive: whether the method chooses its own steps, so that it may stop within a time step.

        Returns:
            Time steps, and the steps that the method may try for them. There are always some, so that a body
            too heavy for the budget still moves.
        """
        planned = _PIECE * left
        if not adaptive:
            steps = min(steps, max(1, int(planned / self._step_cost)) if self._step_cost else 1)
        return steps, self.attempts(planned)

    def is_over(self, left: float, budget: float) -> bool:
        """Whether a frame with so many seconds left of its budget does no more."""
        return left < max(_REST * budget, self.unit_cost)

    def attempts(self, budget: float) -> int:
        """How many steps a method that chooses them itself may try in a budget of seconds."""
        return attempts_within(budget, self._attempt_cost)

    def affordable(self, budget: float) -> int:
        """Steps of the clock that a budget of seconds is enough for, by their cost so far; 20000 at first."""
        return int(budget / self._step_cost) if self._step_cost else 20_000

    def learn(self, steps: int, seconds: float, work: int) -> None:
        """Note what a piece of a frame cost.

        Args:
            steps: time steps done.
            seconds: what they took.
            work: what the method tried for them, see `SolverStats`.
        """
        if steps:
            self._step_cost = _believed(self._step_cost, seconds / steps)
        if work:
            self._attempt_cost = _believed(self._attempt_cost, seconds / work)

    def record(
        self, now: float, dt: float, steps: int, seconds: float, stats: SolverStats, missed: int
    ) -> None:
        """Note what a frame did.

        Args:
            now: wall time, s.
            dt: time step, s.
            steps: time steps done.
            seconds: what they took.
            stats: what the method did for them.
            missed: time steps that were granted and not reached.
        """
        self.behind += missed * dt
        lost = self._lost + missed * dt
        self._frames.append((now, steps * dt, stats.steps, stats.rejected, seconds, lost))
        while self._frames and self._frames[0][0] < now - _WINDOW:
            self._frames.popleft()

    def rates(self, now: float) -> Rates:
        """The rates over the last second, or since the restart."""
        if len(self._frames) < 2:
            return Rates(behind=self.behind)
        # The first frame's work was done before the window began.
        span = max(now - self._frames[0][0], 1e-3)
        sums = [sum(column) for column in zip(*self._frames, strict=True)]
        simulated, steps, rejected = (sums[i] - self._frames[0][i] for i in (1, 2, 3))
        busy, losing = sums[4] / len(self._frames), sums[5]
        return Rates(
            simulated / span, steps / span, rejected / span, busy * 1e3, behind=self.behind, losing=losing
        )


def is_large(scene: Scene) -> bool:
    """Whether a scene is heavy by its size alone."""
    return len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs) > LARGE


def attempts_within(budget: float, cost: float) -> int:
    """Steps that may be tried in a budget of seconds, of which each takes `cost` seconds; 0 is not known."""
    if not cost:
        return _FEWEST_ATTEMPTS
    fewest = max(1, min(_FEWEST_ATTEMPTS, int(_LATE / cost)))
    return int(min(max(budget / cost, fewest), _MOST_ATTEMPTS))


def smoothed(before: float, now: float) -> float:
    """A running average of costs, of which the first counts as it is."""
    return now if not before else 0.8 * before + 0.2 * now


def _believed(before: float, now: float) -> float:
    """A running average of costs that believes at once what is dearer."""
    return max(now, smoothed(before, now))
