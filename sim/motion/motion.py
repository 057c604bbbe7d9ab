"""A body on its way: one owner of its tables, its state and its clock, which moves it by whole time steps."""

from __future__ import annotations

import copy
import math
from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from ..compiling.compiler import is_ready, needed_by
from ..engine.tables import SCALE_MAX, SCALE_MIN, Indices, PrescribedMotion
from ..model.stable_spring import clamp_stiffness
from ..model.state import (
    Carried,
    carried_by,
    fill_in,
    new_scratch,
    new_state,
    put_masses,
    whole_without_broken,
)
from ..model.system import System, build_system
from ..scene.numbers import MAX_SPEED, RUNAWAY_SPEED
from ..scene.types import Scene
from ..solve.registry import METHODS
from ..solve.steps import guard
from .checkpoint import MotionMemory, Words, writable
from .driving import Driver
from .hands import LONGEST_PART, NO_MOTIONS, HandMotions, Hands
from .plain import PlainSolver
from .solver import UNLIMITED, Solver

Targets = dict[int, tuple[float, float]]
"""Positions, px, of led masses at the end of a call, by slot."""


class KeyRates(NamedTuple):
    """The effect of held keys on all rest lengths and rest angles.

    Attributes:
        factor: factor of the rest lengths, per time step.
        angle: degrees added to the rest angles, per time step.
    """

    factor: float = 1.0
    angle: float = 0.0


NO_KEY_RATES = KeyRates()
"""No key is held."""


def key_rates_of(scene: Scene, keys: frozenset[str]) -> KeyRates:
    """The effect of held keys in one time step of a scene."""
    if not keys or scene.arrow_keys is None:
        return NO_KEY_RATES
    rates, dt = scene.arrow_keys, scene.integrator.dt
    intervals = dt / rates.interval
    # Limited to the whole range of scales and to one full turn, beyond which nothing changes.
    most = math.log(SCALE_MAX / SCALE_MIN)
    if intervals * math.log(rates.rest_length_factor) < most:
        growth = rates.rest_length_factor**intervals
    else:
        growth = SCALE_MAX / SCALE_MIN
    length = (growth if "up" in keys else 1.0) / (growth if "down" in keys else 1.0)
    turn = math.remainder(rates.rest_angle_step * intervals, 360.0)
    return KeyRates(length, turn * (("right" in keys) - ("left" in keys)))


class Outcome(NamedTuple):
    """The result of a call.

    Attributes:
        steps: number of whole time steps done.
        status: guard.GOOD, or what is wrong with the state after the next step.
        mass_index: slot of the mass at which it was found, or -1.
    """

    steps: int
    status: int = guard.GOOD
    mass_index: int = -1


_HALTS = 16
"""Parts of a time step in which a body whose masses are all held moves, if an energy balance is kept. Doubled
or halved, no test fails."""


class Motion:
    """A body on its way: its tables and state, who holds its masses, what moves it, and the clock.

    It moves by whole time steps, which it counts.

    Args:
        scene: a valid scene; it stays the same.
        wait: whether it may wait until kernels are compiled; otherwise NumPy moves the body until then.
        carried: the motion to go on from; None for the scene's start.
        time, steps, controls: see `begin`.
        hands: of another motion of the same masses, whose hold is taken over.
        damageable: whether its tables have room for damage, also if `carried` has none.

    Attributes:
        state: positions, velocities and parameters that change; `begin` says from what they follow.
        scratch: scratch arrays of the kernels.
        hands: who holds and leads masses.
        solver: what moves the body.
        steps: time steps done since the scene's start.
    """

    def __init__(
        self,
        scene: Scene,
        wait: bool,
        carried: Carried | None = None,
        time: float = 0.0,
        steps: int = 0,
        controls: tuple[float, float] | None = None,
        hands: Hands | None = None,
        damageable: bool = False,
    ) -> None:
        self.scene, self._wait = scene, wait
        system = build_system(scene, damageable or (carried is not None and carried.damage is not None))
        if scene.integrator.method == "stable_spring":
            body = clamp_stiffness(system.body, system.inverse_mass, system.held, scene.integrator.dt)
            system = replace(system, body=body)
        self._whole = system  # with what has broken
        self.state, self.scratch = new_state(system), new_scratch(system)
        self._dt, self._adaptive = scene.integrator.dt, METHODS[scene.integrator.method].adaptive
        self.solver = self._new_solver()
        self.hands = Hands(system, self.state, self._adaptive)
        self._driver = Driver(scene, system, self.state)
        # The drive of the last call, unless it had targets or hands, and the keys in it.
        self._kept: PrescribedMotion | None = None
        self._key_rates = NO_KEY_RATES
        if hands is not None:
            self.hands.take_over(hands)
        if carried is None:
            self.go_to_start()
        else:
            self.begin(carried, time, steps, controls)

    def _new_solver(self) -> Solver | PlainSolver:
        if self._wait or is_ready(self._needed):
            return Solver(self.scene, self._whole, self.state, self.scratch, self._wait)
        return PlainSolver(self.scene, self._whole, self.state)

    @property
    def _needed(self) -> tuple[str, ...]:
        """Names of the compiled entry points without which NumPy moves the body."""
        return needed_by(self.scene.integrator.method, self._whole.body)

    def take_compiled(self) -> bool:
        """Go on with the kernels of the method if they are ready by now; whether it does."""
        if isinstance(self.solver, PlainSolver) and is_ready(self._needed):
            time, system = self.time, self.system
            self.solver = self._new_solver()  # the state is in the same arrays
            self.solver.system = system
            self._origin, self._begins, self._steady, self._led = (time, self.steps), True, None, {}
        return isinstance(self.solver, Solver)

    @property
    def system(self) -> System:
        """The tables, without what has broken."""
        return self.solver.system

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._origin[0] if self._begins else self.solver.time

    def _after(self, steps: int) -> float:
        """The time after some more steps, s; the same to the last bit however they are grouped."""
        time, begun = self._origin
        return time + (self.steps - begun + steps) * self._dt

    def begin(
        self,
        carried: Carried,
        time: float,
        steps: int,
        controls: tuple[float, float] | None = None,
        slots: slice | Indices | None = None,
    ) -> None:
        """Begin from a motion at a time.

        Args:
            carried: the motion.
            time: s.
            steps: those done until then.
            controls: what keys did, rest length scale and degrees; None for the scene's own.
            slots: of the masses in the rows of `carried`; None if these are in the scene's order.
        """
        state, whole = self.state, self._whole
        controls = controls or (self.scene.rest_length_scale, 0.0)
        slots = whole.mass_index if slots is None else slots
        held = self.hands.held
        system = fill_in(state, whole, self.scene, carried, slots, controls, time, held)
        self._all_held = bool(held.all())
        if whole.body.limits.present:
            self.solver.system = system
        # Time, s, and steps at which the method began anew, or is to with the next step.
        self._origin, self.steps, self._begins = (time, steps), steps, True
        self._led: Targets = {}
        # The solver and the drive, where nothing but the body changed in the last call.
        self._steady: tuple[Solver, PrescribedMotion] | None = None

    def carried(self) -> Carried:
        """The present motion, to go on from it."""
        return carried_by(self.state, self.system)

    def remembered(self) -> MotionMemory:
        """All that decides how it goes on, to the last bit; its kernels must be there."""
        assert isinstance(self.solver, Solver)
        hands = self.hands
        return MotionMemory(
            damageable=self.damageable,
            state=Words.of(writable(self.state.arrays())),
            solver=self.solver.remembered(self._begins),
            origin=self._origin,
            begins=self._begins,
            steps=self.steps,
            drive=self._kept,
            key_rates=self._key_rates,
            led=dict(self._led),
            grabbed=frozenset(hands.grabbed),
            targets=dict(hands.targets),
            limited=copy.deepcopy(hands.limited),
        )

    def remember(self, memory: MotionMemory) -> None:
        """Go on as the motion of the same scene did that had remembered this; its kernels must be there."""
        assert isinstance(self.solver, Solver)
        hands = self.hands
        memory.state.put_into(writable(self.state.arrays()))
        hands.grabbed, hands.targets = set(memory.grabbed), dict(memory.targets)
        hands.limited = copy.deepcopy(dict(memory.limited))
        if self._whole.body.limits.present:
            self.solver.system = whole_without_broken(self._whole, self.state)
        self.solver.remember(memory.solver)
        self._all_held = bool(hands.held.all())
        self._origin, self._begins, self.steps = memory.origin, memory.begins, memory.steps
        self._kept, self._key_rates = memory.drive, KeyRates(*memory.key_rates)
        self._led, self._steady = dict(memory.led), None

    @property
    def damageable(self) -> bool:
        """Whether its tables have room for damage."""
        return bool(self._whole.body.limits.present)

    def go_to_start(self) -> None:
        """Begin as the scene does."""
        pose, masses = self.scene.pose, slice(1, self._whole.body.masses + 1)
        self.hands.clear()
        carried = Carried(self._whole.start, pose and pose.damage, pose and pose.grips)
        self.begin(carried, 0.0, 0, slots=masses)

    def hold(self) -> None:
        """Say what forces do to each mass: nothing where it is held."""
        held = self.hands.held
        self._all_held = bool(held.all())
        put_masses(self.state, self.system, self.scene, held)
        self.begin_anew()

    def begin_anew(self) -> None:
        """Let the method begin anew with the next step: the state, or what acts on it, was changed."""
        self._origin, self._begins, self._steady = (self.time, self.steps), True, None

    def _load(self) -> None:
        """Let the method begin."""
        self.solver.load(self.time)
        self._begins = False
        if self._kept is not None and (self._kept.mass.size or self._kept.pressed):
            self._kept = None  # circles and keys start from where the masses are now

    def go_on(self, steps: int, attempts: int) -> int:
        """Advance by some time steps as the last call of `step` did, in a third of its time.

        It is for a call without keys, and does nothing where hands lead a mass.

        Returns:
            -1 if it got there. Otherwise the attempts that are left for `step`, which has to be called, and
            goes on from where the body is now.
        """
        if self._steady is None or self.hands.targets or self.hands.limited:
            return attempts
        solver, drive = self._steady
        time, begun = self._origin
        left = solver.go_on(time + (self.steps - begun + steps) * self._dt, drive, attempts)
        if left < 0:
            self.steps += steps
        return left

    def step(self, steps: int, rates: KeyRates, attempts: int = UNLIMITED) -> Outcome:
        """Advance by some time steps; by fewer if the attempts run out or the body runs away."""
        hands, all_held = self.hands, self._all_held
        if self._begins:
            self._load()
        # A frame of a short body takes less than a microsecond, so what does not change is kept.
        solver, targets = self.solver, hands.targets
        until = self._after(steps)
        # A body whose masses are all held cannot run away, however fast they are led.
        solver.fastest = MAX_SPEED if self._adaptive or all_held else RUNAWAY_SPEED
        if targets or self._led:
            self._stop(self._led)
            solver.invalidate()
            self._kept = None
            self._led = targets
        if hands.limited:
            self._kept = self._steady = None
            status = self._lead_limited(until, rates, attempts)
        else:
            drive = self._kept
            if drive is None or rates != self._key_rates:
                drive = self._drive(until, targets, rates)
                if not targets:
                    self._kept, self._key_rates = drive, rates
            self._steady = None
            if all_held and drive.moving and self._adaptive and solver.tracks_energy:
                status = self._substeps(until, drive, min(_HALTS * steps, attempts), attempts)
            else:
                status = solver.run(until, drive, attempts)
                settled = drive is self._kept and rates is NO_KEY_RATES and not all_held
                if settled and isinstance(solver, Solver):
                    self._steady = solver, drive
        time = solver.time
        if targets and time == until:
            self._put(targets)
        passed = time - self._after(0) + 4e-16 * abs(time)  # times are rounded
        done = int(passed / self._dt + 1e-6)
        self.steps += done
        hands.settle(done == steps or status != guard.GOOD)
        return Outcome(done) if status == guard.GOOD else Outcome(done, status, solver.index)

    def _drive(
        self, until: float, targets: Targets, rates: KeyRates, motions: HandMotions = NO_MOTIONS
    ) -> PrescribedMotion:
        growth, turn = math.log(rates.factor) / self._dt, rates.angle / self._dt
        return self._driver.drive(self.solver.time, until, targets, growth, turn, motions)

    def _substeps(self, until: float, drive: PrescribedMotion, halts: int, attempts: int) -> int:
        """Advance in parts: without free masses, no error would make steps short enough for the balance."""
        solver, start = self.solver, self.solver.time
        last = solver.work + attempts
        for i in range(1, halts):
            solver.run(start + (until - start) * i / halts, drive, last - solver.work)
        return solver.run(until, drive, last - solver.work)

    def _lead_limited(self, until: float, rates: KeyRates, attempts: int) -> int:
        """Advance in parts that are short enough for rate-limited hands."""
        hands, solver, start = self.hands, self.solver, self.solver.time
        last, status = solver.work + attempts, guard.GOOD
        parts = max(1, math.ceil((until - start) / LONGEST_PART - 1e-6))
        for i in range(1, parts + 1):
            began, end = solver.time, until - (until - start) * (parts - i) / parts
            motions = {index: hand.next_motion(end - began) for index, hand in hands.limited.items()}
            drive = self._drive(until, hands.targets, rates, motions)
            status = solver.run(end, drive, last - solver.work)
            for index, hand in hands.limited.items():
                hand.go_on(motions[index], solver.time - began)
            if status != guard.GOOD or solver.time < end:
                break
        there = {index: hand.goal for index, hand in hands.limited.items() if hand.is_there}
        self._put(there)
        self._stop(there)
        return status

    def _put(self, targets: Targets) -> None:
        """Set masses exactly to the positions to which they were led, without rounding errors."""
        for index, (x, y) in targets.items():
            self.state.x[index], self.state.y[index] = x, y

    def _stop(self, indices: Iterable[int]) -> None:
        """Set the velocities of masses that are no longer led to zero."""
        for index in indices:
            self.state.vx[index] = self.state.vy[index] = 0.0
