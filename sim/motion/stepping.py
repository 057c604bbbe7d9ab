"""How a body is moved on by whole time steps, whatever leads its masses and whichever keys are held."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from ..body.system import System
from ..kernels.core.tables import SCALE_MAX, SCALE_MIN, Drive, State
from ..kernels.integrators import guard
from ..methods.registry import METHODS
from ..scene.types import MAX_SPEED, RUNAWAY_SPEED, Scene
from .drag import LONGEST_PART, NO_MOTIONS, HandMotions, Hands
from .driving import Driver
from .plain import PlainSolver
from .solver import UNLIMITED, Solver, SolverStats

Targets = dict[int, tuple[float, float]]
"""Where masses that are led are to be at the end of a call, by index, px."""


class Presses(NamedTuple):
    """What held keys do to all rest lengths and rest angles.

    Attributes:
        factor: of the rest lengths, per time step.
        angle: degrees added to the rest angles, per time step.
    """

    factor: float = 1.0
    angle: float = 0.0


NO_PRESSES = Presses()


def presses_of(scene: Scene, keys: frozenset[str]) -> Presses:
    """What the keys held do in one time step of a scene."""
    if not keys or scene.arrow_keys is None:
        return NO_PRESSES
    rates, dt = scene.arrow_keys, scene.integrator.dt
    intervals = dt / rates.interval
    # However fast the keys: more than the whole range of scales, or than a full turn, is no more.
    most = math.log(SCALE_MAX / SCALE_MIN)
    if intervals * math.log(rates.rest_length_factor) < most:
        growth = rates.rest_length_factor**intervals
    else:
        growth = SCALE_MAX / SCALE_MIN
    length = (growth if "up" in keys else 1.0) / (growth if "down" in keys else 1.0)
    turn = math.remainder(rates.rest_angle_step * intervals, 360.0)
    return Presses(length, turn * (("right" in keys) - ("left" in keys)))


class Outcome(NamedTuple):
    """How a call went.

    Attributes:
        steps: whole time steps done.
        what: guard.GOOD, or what is wrong with the state that would come next.
        place: the mass that shows it.
    """

    steps: int
    what: int = guard.GOOD
    mass_index: int = -1


_HALTS = 16
"""Steps in a time step of a body of which all masses are held, if books are kept and steps are free."""


class Stepper:
    """A method, from one whole time step to a later one."""

    def __init__(self, scene: Scene, system: System, state: State, solver: Solver | PlainSolver) -> None:
        self._dt, self._state = scene.integrator.dt, state
        self._adaptive = METHODS[scene.integrator.method].adaptive
        self._driver = Driver(scene, system, state)
        self.solver = solver
        self._led: Targets = {}
        self._undisturbed: Drive | None = None  # what drives the body while nobody does
        self._origin, self._done = 0.0, 0  # the time, s, when the state came from elsewhere; steps since then

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self.solver.time

    def _after(self, steps: int) -> float:
        """The time after some more steps, s; the same to the last digit however they are grouped."""
        return self._origin + (self._done + steps) * self._dt

    def begin(self, time: float) -> None:
        """The state in `state` is that of a time, s, and has come from elsewhere."""
        self.solver.load(time)
        self._origin, self._done = time, 0
        if self._undisturbed is not None and self._undisturbed.mass.size:
            self._undisturbed = None  # circles start from where the masses are now

    def step(
        self, steps: int, hands: Hands, presses: Presses, all_held: bool, attempts: int = UNLIMITED
    ) -> Outcome:
        """Go on by some time steps; by fewer when the attempts run out or the body runs away."""
        # A short body's frame takes less than a microsecond: what is always the same is not asked anew.
        solver, targets = self.solver, hands.targets
        until = self._after(steps)
        # However fast masses are led, a body all of whose masses are held does not run away.
        solver.fastest = MAX_SPEED if self._adaptive or all_held else RUNAWAY_SPEED
        if targets or self._led:
            self._stop(self._led)
            solver.touch()
            self._undisturbed = None
            self._led = targets
        if hands.limited:
            self._undisturbed = None
            what = self._lead_limited(until, hands, presses, attempts)
        else:
            if presses != NO_PRESSES:
                self._undisturbed = None
            drive = self._undisturbed
            if drive is None:
                drive = self._drive(until, targets, presses)
                if not targets and presses == NO_PRESSES:
                    self._undisturbed = drive
            if all_held and drive.moving and self._adaptive and solver.keeps_books:
                what = self._halt(until, drive, min(_HALTS * steps, attempts), attempts)
            else:
                what = solver.run(until, drive, attempts)
        time = solver.time
        if targets and time == until:
            self._put(targets)
        done = int((time - self._after(0)) / self._dt + 1e-6)
        self._done += done
        return Outcome(done) if what == guard.GOOD else Outcome(done, what, solver.index)

    def _drive(
        self, until: float, targets: Targets, presses: Presses, motions: HandMotions = NO_MOTIONS
    ) -> Drive:
        growth, turn = math.log(presses.factor) / self._dt, presses.angle / self._dt
        return self._driver.drive(self.solver.time, until, targets, growth, turn, motions)

    def _halt(self, until: float, drive: Drive, halts: int, attempts: int) -> int:
        """Go on with so many halts: no error of a free mass makes steps short enough for the books."""
        solver, start = self.solver, self.solver.time
        last = solver.tries + attempts
        for i in range(1, halts):
            solver.run(start + (until - start) * i / halts, drive, last - solver.tries)
        return solver.run(until, drive, last - solver.tries)

    def _lead_limited(self, until: float, hands: Hands, presses: Presses, attempts: int) -> int:
        """Go on in parts that are short enough for rate-limited hands."""
        solver, start = self.solver, self.solver.time
        last, what = solver.tries + attempts, guard.GOOD
        parts = max(1, math.ceil((until - start) / LONGEST_PART - 1e-6))
        for i in range(1, parts + 1):
            began, end = solver.time, until - (until - start) * (parts - i) / parts
            motions = {index: hand.next_motion(end - began) for index, hand in hands.limited.items()}
            drive = self._drive(until, hands.targets, presses, motions)
            what = solver.run(end, drive, last - solver.tries)
            for index, hand in hands.limited.items():
                hand.go_on(motions[index], solver.time - began)
            if what != guard.GOOD or solver.time < end:
                break
        there = {index: hand.goal for index, hand in hands.limited.items() if hand.is_there}
        self._put(there)
        self._stop(there)
        return what

    def _put(self, targets: Targets) -> None:
        """Put masses where they were led, to the last digit, which the way there has rounded."""
        for index, (x, y) in targets.items():
            self._state.x[index], self._state.y[index] = x, y

    def _stop(self, slots: Iterable[int]) -> None:
        """Some held masses are led no more."""
        for index in slots:
            self._state.vx[index] = self._state.vy[index] = 0.0

    def stats(self) -> SolverStats:
        """What was done since the last call of this."""
        return self.solver.stats()
