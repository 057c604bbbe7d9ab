"""How a body is moved on by whole time steps: by the tutorial's kernels, or by any other method."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from .driving import bounded, offset
from .hand import LONGEST_GLIDE, NO_GLIDES, Glides, Hands
from .kernels import guard
from .kernels.chain import run_chain
from .kernels.general import run_general, run_held
from .kernels.tables import NO_JOINTS, SCALE_MAX, SCALE_MIN, TUTORIAL, Drive, Live, Motion, Work
from .methods import METHODS
from .scene import MAX_COORDINATE, MAX_SPEED, RUNAWAY_SPEED, Scene
from .solver import UNLIMITED, Effort, Solver
from .system import System

Targets = dict[int, tuple[float, float]]
"""Where masses that are led are to be at the end of a call, by place, px."""


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
    place: int = -1


_HALTS = 16
"""Steps in a time step of a body of which all masses are held, if books are kept and steps are free."""


class EulerStepper:
    """Symplectic Euler, step by step as the tutorial has it; also for the stable spring."""

    def __init__(self, scene: Scene, system: System, live: Live, work: Work) -> None:
        self._scene, self._system, self._live, self._work = scene, system, live, work
        self._kept = np.zeros((5, live.x.size))
        self._start, self._dt = 0.0, scene.integrator.dt
        self._steps = 0
        self._led: Targets = {}
        self._effort = Effort()
        circles = {int(system.mass_place[a.mass]): a.circle for a in scene.anchors if a.circle is not None}
        self._circle = circles
        self._hand = 0.0 if scene.force_law == "tutorial" else 1.0

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._start + self._steps * self._dt

    def begin(self, time: float) -> None:
        """The state in `live` is that of a time, s, and has come from elsewhere."""
        self._start, self._steps = time, 0
        self._stop_led()

    def step(self, steps: int, targets: Targets, presses: Presses, all_held: bool) -> Outcome:
        """Do some steps; fewer when the body runs away."""
        body, live = self._system.body, self._live
        self._stop_led()
        self._led = targets
        motion = self._motion(steps, targets, presses)
        self._effort.steps += steps
        self._effort.forces += steps
        progress = guard.new_progress()
        if all_held:
            # However fast they are led, they do not run away.
            run_held(body, live, motion, self._kept, progress, steps, MAX_COORDINATE, MAX_SPEED)
        else:
            plain = body.law in (NO_JOINTS, TUTORIAL) and not body.twisted
            run = run_chain if body.chain and plain else run_general
            run(
                body, live, self._work, motion, self._kept, progress, self._dt, steps,
                self._scene.air_friction > 0.0, MAX_COORDINATE, RUNAWAY_SPEED,
            )  # fmt: skip
        done, _, what, place = (int(p) for p in progress)
        self._steps += done
        return Outcome(done, what, place)

    def _stop_led(self) -> None:
        for place in self._led:
            self._live.vx[place] = self._live.vy[place] = 0.0
        self._led = {}

    def effort(self) -> Effort:
        """What was done since the last call of this."""
        effort, self._effort = self._effort, Effort()
        return effort

    def close_books(self) -> None:
        """Nothing to do: the tutorial's kernels keep no books."""

    def _motion(self, steps: int, targets: Targets, presses: Presses) -> Motion:
        live, t = self._live, self.time
        duration = steps * self._dt
        places = sorted({*targets, *self._circle})
        rows = []
        for m in places:
            circle = self._circle.get(m)
            ox, oy = offset(circle, t)
            x, y = live.x[m] - ox, live.y[m] - oy
            tx, ty = x, y
            if m in targets:
                ex, ey = offset(circle, t + duration)
                tx, ty = targets[m][0] - ex, targets[m][1] - ey
            radius, omega, ramp = (
                (circle.radius, math.tau * circle.frequency, circle.ramp) if circle else (0.0, 0.0, 1.0)
            )
            vx, vy = (bounded((to - at) / duration) * self._hand for to, at in ((tx, x), (ty, y)))
            rows.append((x, y, tx, ty, vx, vy, radius, omega, ramp))
        columns = np.array(rows, float).reshape(-1, 9).T.copy()
        return Motion(
            bool(places) or presses != NO_PRESSES,
            np.array(places, np.int64),
            *columns,
            start=t,
            dt=self._dt,
            length_factor=presses.factor,
            angle_step=presses.angle,
        )


class FlowStepper:
    """Any other method, from one whole time step to a later one."""

    def __init__(self, scene: Scene, system: System, live: Live, work: Work) -> None:
        self._dt, self._live = scene.integrator.dt, live
        self._adaptive = METHODS[scene.integrator.method].adaptive
        self.solver = Solver(scene, system, live, work)
        self._led: Targets = {}
        self._undisturbed: Drive | None = None  # what drives the body while nobody does
        self._goal = 0.0

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self.solver.time

    def begin(self, time: float) -> None:
        """The state in `live` is that of a time, s, and has come from elsewhere."""
        self.solver.load(time)
        self._goal = time
        if self._undisturbed is not None and self._undisturbed.mass.size:
            self._undisturbed = None  # circles start from where the masses are now

    def step(
        self, steps: int, hands: Hands, presses: Presses, all_held: bool, attempts: int = UNLIMITED
    ) -> Outcome:
        """Go on by some time steps; by fewer when the attempts run out or the body runs away."""
        # A short body's frame takes less than a microsecond: what is always the same is not asked anew.
        solver, dt, targets = self.solver, self._dt, hands.targets
        until = self._goal + steps * dt
        if targets or self._led:
            solver.stop(self._led)
            solver.touch()
            self._undisturbed = None
            self._led = targets
        if hands.gentle:
            self._undisturbed = None
            what = self._glide(until, hands, presses, attempts)
        else:
            if presses != NO_PRESSES:
                self._undisturbed = None
            drive = self._undisturbed
            if drive is None:
                drive = self._drive(until, targets, presses)
                if not targets and presses == NO_PRESSES:
                    self._undisturbed = drive
            if all_held and drive.moving and self._adaptive and solver.ledger.active:
                what = self._halt(until, drive, min(_HALTS * steps, attempts), attempts)
            else:
                what = solver.run(until, drive, attempts)
        time = solver.time
        if targets and time == until:
            self._put(targets)
        done = int((time - self._goal) / dt + 1e-6)
        self._goal += done * dt
        return Outcome(done) if what == guard.GOOD else Outcome(done, what, solver.place)

    def _drive(self, until: float, targets: Targets, presses: Presses, glides: Glides = NO_GLIDES) -> Drive:
        growth, turn = math.log(presses.factor) / self._dt, presses.angle / self._dt
        return self.solver.drive(until, targets, growth, turn, glides)

    def _halt(self, until: float, drive: Drive, halts: int, attempts: int) -> int:
        """Go on with so many halts: no error of a free mass makes steps short enough for the books."""
        solver, start = self.solver, self.solver.time
        last = solver.tries + attempts
        for i in range(1, halts):
            solver.run(start + (until - start) * i / halts, drive, last - solver.tries)
        return solver.run(until, drive, last - solver.tries)

    def _glide(self, until: float, hands: Hands, presses: Presses, attempts: int) -> int:
        """Go on in parts that are short enough for gentle hands."""
        solver, start = self.solver, self.solver.time
        last, what = solver.tries + attempts, guard.GOOD
        parts = max(1, math.ceil((until - start) / LONGEST_GLIDE - 1e-6))
        for i in range(1, parts + 1):
            began, end = solver.time, until - (until - start) * (parts - i) / parts
            glides = {place: hand.glide(end - began) for place, hand in hands.gentle.items()}
            drive = self._drive(until, hands.targets, presses, glides)
            what = solver.run(end, drive, last - solver.tries)
            for place, hand in hands.gentle.items():
                hand.go_on(glides[place], solver.time - began)
            if what != guard.GOOD or solver.time < end:
                break
        there = {place: hand.goal for place, hand in hands.gentle.items() if hand.is_there}
        self._put(there)
        solver.stop(there)
        return what

    def _put(self, targets: Targets) -> None:
        """Put masses where they were led, to the last digit, which the way there has rounded."""
        for place, (x, y) in targets.items():
            self.solver.flow.q[place], self.solver.flow.q[self.solver.places + place] = x, y
            self._live.x[place], self._live.y[place] = x, y

    def effort(self) -> Effort:
        """What was done since the last call of this."""
        return self.solver.effort()

    def leave_dead_end(self) -> None:
        """Do a step of last resort, whether it is needed or not."""
        until = self._goal + self._dt
        self.solver.rescue(until, self.solver.drive(until, {}, 0.0, 0.0))

    def close_books(self) -> None:
        """What changes the energy is of no interest any more."""
        self.solver.close_ledger()


Stepper = EulerStepper | FlowStepper


def stepper_for(scene: Scene, system: System, live: Live, work: Work) -> Stepper:
    """What the scene's method asks for."""
    kind = EulerStepper if METHODS[scene.integrator.method].kind == "euler" else FlowStepper
    return kind(scene, system, live, work)
