"""How much simulated time a frame gets, and how well the clock keeps up.

Simulated time is owed as wall time passes. What the machine cannot compute in time is dropped and counted as
lag: the clock falls behind, and the next frame owes no more than its own share.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

import sim
from sim.motion.solver import SolverStats

LONGEST_FRAME = 0.1
"""Seconds of wall time that one frame can owe. After a longer silence, of a stalled machine or a suspended
laptop, the body continues from where it was instead of leaping."""

HEAVY_UNIT = 0.004
"""Seconds of one step, or one attempt at a step, beyond which a body is heavy."""

LARGE = 2000
"""Masses and springs beyond which a scene counts as heavy before the cost of its steps is known."""

_FIRST_ATTEMPTS = 1000
"""Attempts of an adaptive method before their cost is known."""

_MAX_ATTEMPTS = 1_000_000
"""Attempts at most: a log cannot have more."""

_PIECE = 0.7
"""Part of a frame's remaining budget that is planned at once, since the cost of steps may change any time."""
_REST = 0.1
"""Part of a frame's budget that may be left unused."""

_WINDOW = 1.0
"""Seconds over which the rates are averaged."""


@dataclass(frozen=True)
class Rates:
    """How well the clock keeps up, over the last second.

    Attributes:
        real_time_factor: simulated seconds per second.
        steps_per_second: steps of the method done per second.
        rejected_per_second: rejected attempts per second.
        solver_ms: time in the solver per frame, ms.
        behind: simulated seconds that the clock has lost since it was started.
        losing: simulated seconds that it has lost in the last second.
    """

    real_time_factor: float = 0.0
    steps_per_second: float = 0.0
    rejected_per_second: float = 0.0
    solver_ms: float = 0.0
    behind: float = 0.0
    losing: float = 0.0


class Costs:
    """The measured cost of a body's steps, from which follows how many of them fit a budget."""

    def __init__(self) -> None:
        self._step = self._attempt = 0.0
        self._learnt = 0  # pieces
        self._kind: tuple[object, ...] = ()

    @property
    def unit(self) -> float:
        """Seconds of what cannot be divided: one step, or one attempt at one; 0 if unknown."""
        return self._attempt or self._step

    def attempts(self, budget: float) -> int:
        """Attempts of an adaptive method that fit a budget of seconds."""
        if not self._attempt:
            return _FIRST_ATTEMPTS
        return int(min(max(budget / self._attempt, 1.0), _MAX_ATTEMPTS))

    def affordable(self, budget: float) -> int:
        """Time steps that fit a budget of seconds, by their cost so far; 20000 at first."""
        return int(budget / self._step) if self._step else 20_000

    def move(
        self,
        simulation: sim.Simulation,
        steps: int,
        budget: float,
        step: Callable[[int, int], int] | None = None,
    ) -> int:
        """Step a body, as far as a budget of seconds allows; see `spend`.

        Args:
            simulation: the body.
            steps: time steps.
            budget: seconds of computing.
            step: does the steps; None for `Simulation.step`.

        Returns:
            The time steps that were done.
        """
        moved = step or simulation.step

        def go(n: int, attempts: int) -> tuple[int, int]:
            before = simulation.work
            done = moved(n, attempts)
            return done, 0 if simulation.divergence is not None else simulation.work - before

        self.reset_for(simulation.scene)
        return self.spend(budget, steps, go)

    def reset_for(self, scene: sim.Scene) -> None:
        """Forget the costs if the steps of this scene may cost something else."""
        counts = map(len, (scene.masses, scene.linear_springs, scene.angular_springs, scene.fillings))
        kind = scene.integrator.method, scene.contact is not None, *counts
        if kind != self._kind:
            self._kind, self._learnt = kind, 0
            self._step = self._attempt = 0.0

    def spend(
        self,
        budget: float,
        steps: int,
        go: Callable[[int, int], tuple[int, int]],
        clock: Callable[[], float] = time.perf_counter,
    ) -> int:
        """Do the steps of a frame as far as its budget allows.

        They are done in pieces, planned by the costs so far. There is always one, so that a body too heavy
        for the budget still moves. A piece is limited by attempts, not by time steps: hands lead masses to
        the end of the frame.

        Args:
            budget: seconds of computing.
            steps: time steps.
            go: does some time steps with at most so many attempts. Returns the steps done and the attempts
                (see `SolverStats.work`); both are 0 at the end of the motion.
            clock: seconds.

        Returns:
            The time steps that were done.
        """
        done, began = 0, clock()
        before = began
        left = budget
        while done < steps:
            did, work = go(steps - done, self.attempts(_PIECE * left) if self._learnt else 1)
            now = clock()
            self.learn(did, now - before, work)
            done, before, left = done + did, now, budget - (now - began)
            if not (did or work) or left < max(_REST * budget, self.unit):
                break
        return done

    def learn(self, steps: int, seconds: float, work: int) -> None:
        """Take the cost of a piece of a frame into account.

        Args:
            steps: time steps done.
            seconds: what they took.
            work: attempts of the method; see `SolverStats`.
        """
        # The first piece also makes tables: its cost counts only until there is a second one.
        average = _cautious if self._learnt > 1 else lambda _, now: now
        self._learnt += 1
        if steps:
            self._step = average(self._step, seconds / steps)
        if work:
            self._attempt = average(self._attempt, seconds / work)


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
        self._lost = 0.0
        self._frames: deque[tuple[float, float, int, int, float, float]] = deque()

    def restart(self) -> None:
        """Owe nothing, and forget the rates, as after a pause."""
        self._last = None
        self._owed = 0.0
        self.behind = 0.0
        self._frames.clear()

    def grant(self, now: float, dt: float, longest: float = LONGEST_FRAME) -> int:
        """Time steps that this frame should do.

        Args:
            now: wall time, s.
            dt: time step, s.
            longest: seconds of wall time that it can owe.
        """
        elapsed = 0.0 if self._last is None else max(0.0, now - self._last)
        self._last = now
        self._lost = max(0.0, elapsed - longest) * self.speed
        self.behind += self._lost
        self._owed += min(elapsed, longest) * self.speed
        steps = int(self._owed / dt + 1e-9)
        self._owed -= steps * dt
        return steps

    def record(
        self, now: float, dt: float, steps: int, seconds: float, stats: SolverStats, missed: int
    ) -> None:
        """Take a frame into account.

        Args:
            now: wall time, s.
            dt: time step, s.
            steps: time steps done.
            seconds: of computing.
            stats: of the method.
            missed: time steps that were granted and not done.
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


def is_large(scene: sim.Scene) -> bool:
    """Whether a scene is heavy by its size alone."""
    return len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs) > LARGE


def smoothed(before: float, now: float) -> float:
    """A running average of costs, which starts with the first one."""
    return now if not before else 0.8 * before + 0.2 * now


def _cautious(before: float, now: float) -> float:
    """A running average of costs that rises at once."""
    return max(now, smoothed(before, now))
