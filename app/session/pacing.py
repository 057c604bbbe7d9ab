"""How much simulated time a frame gets, and what the page says of it.

Time is owed as it passes on the wall. Where the machine cannot pay it all, the rest is dropped and counted
as lag: the clock falls behind, and the next frame is not asked for more than its own share.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

import sim
from sim.motion.solver import SolverStats

LONGEST_FRAME = 0.1
"""Seconds of wall time that one frame can owe; after a longer silence (a stalled machine, a suspended
laptop) the body goes on from where it was instead of leaping."""

HEAVY_UNIT = 0.004
"""Seconds of one step, or one attempt at a step, from which on a body is heavy."""

LARGE = 2000
"""Masses and springs from which on a scene counts as heavy before anything is known of its steps."""

_FIRST_ATTEMPTS = 1000
"""Steps that it may try before anything is known of what they cost."""

_MAX_ATTEMPTS = 1_000_000
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


class Costs:
    """What the steps of a body cost, and so how many of them a budget of computing time is enough for."""

    def __init__(self) -> None:
        self._step = self._attempt = 0.0
        self._learnt = 0  # pieces
        self._kind: tuple[object, ...] = ()

    @property
    def unit(self) -> float:
        """Seconds of what cannot be divided: one step, or one attempt at one; 0 is not known."""
        return self._attempt or self._step

    def attempts(self, budget: float) -> int:
        """How many steps a method that chooses them itself may try in a budget of seconds."""
        if not self._attempt:
            return _FIRST_ATTEMPTS
        return int(min(max(budget / self._attempt, 1.0), _MAX_ATTEMPTS))

    def affordable(self, budget: float) -> int:
        """Steps of the clock that a budget of seconds is enough for, by their cost so far; 20000 at first."""
        return int(budget / self._step) if self._step else 20_000

    def move(
        self,
        simulation: sim.Simulation,
        steps: int,
        budget: float,
        step: Callable[[int, int], int] | None = None,
    ) -> int:
        """Move a body by some time steps, as far as a budget of seconds allows; see `spend`.

        Args:
            simulation: the body.
            steps: time steps.
            budget: seconds of computing.
            step: what moves it; None for `Simulation.step`.

        Returns:
            The time steps that were done.
        """
        moved = step or simulation.step

        def go(n: int, attempts: int) -> tuple[int, int]:
            before = simulation.work
            done = moved(n, attempts)
            return done, 0 if simulation.divergence is not None else simulation.work - before

        self.look_at(simulation.scene)
        return self.spend(budget, steps, go)

    def look_at(self, scene: sim.Scene) -> None:
        """Forget what steps cost, if those of this scene may cost something else."""
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

        They are done in pieces, by what steps cost until then. There is always one, so that a body too heavy
        for the budget still moves. Each piece may go to the end of the frame, where hands lead masses to, but
        for the number of steps that it may try.

        Args:
            budget: seconds of computing.
            steps: time steps.
            go: does some time steps, as far as it gets by so many steps of the method. Returns how many it
                did, and what it tried, see `SolverStats.work`; nothing of either at the end of the motion.
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
        """Note what a piece of a frame cost.

        Args:
            steps: time steps done.
            seconds: what they took.
            work: what the method tried for them, see `SolverStats`.
        """
        # The first piece makes tables, too: what it cost counts only until there is a second one.
        believed = _believed if self._learnt > 1 else lambda _, now: now
        self._learnt += 1
        if steps:
            self._step = believed(self._step, seconds / steps)
        if work:
            self._attempt = believed(self._attempt, seconds / work)


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
        """Owe nothing and forget the rates, as after a pause."""
        self._last = None
        self._owed = 0.0
        self.behind = 0.0
        self._frames.clear()

    def grant(self, now: float, dt: float, longest: float = LONGEST_FRAME) -> int:
        """Steps that this frame should do.

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


def is_large(scene: sim.Scene) -> bool:
    """Whether a scene is heavy by its size alone."""
    return len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs) > LARGE


def smoothed(before: float, now: float) -> float:
    """A running average of costs, of which the first counts as it is."""
    return now if not before else 0.8 * before + 0.2 * now


def _believed(before: float, now: float) -> float:
    """A running average of costs that believes at once what is dearer."""
    return max(now, smoothed(before, now))
