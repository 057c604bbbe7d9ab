"""Moves any body by `sim.forces.reference` alone, until the kernels of its method are compiled."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from ..engine.tables import (
    CONTROL_SCALE,
    CONTROL_SHIFT,
    SCALE_MAX,
    SCALE_MIN,
    LeadParameters,
    PrescribedMotion,
    State,
)
from ..forces.reference import Physics, Vectors, euler_step, verlet_step
from ..model.state import update_rest_state
from ..model.system import System
from ..scene.numbers import MAX_COORDINATE, RUNAWAY_SPEED
from ..scene.types import Scene
from ..solve.registry import METHODS
from ..solve.steps import guard
from .solver import UNLIMITED, SolverStats
from .stability import damped_limit

_SAFETY = 0.2
"""Step of Verlet relative to the estimated stability limit, which is for a body near its rest lengths.
Doubled or halved, no test fails."""


class PlainSolver:
    """Has the interface of a `Solver`. Uses symplectic Euler for methods of order 1, otherwise velocity
    Verlet. Nothing yields or breaks.

    Args:
        scene: a valid scene.
        system: its tables.
        state: positions, velocities and parameters that change.

    Attributes:
        time: simulated time, s.
        index: slot of the mass at which something is wrong.
        fastest: largest velocity component of a good state, px/s.
        work: steps tried since the last call of `stats`.
    """

    def __init__(self, scene: Scene, system: System, state: State) -> None:
        self.time, self.index, self.work = 0.0, -1, 0
        self.fastest = RUNAWAY_SPEED
        self._state = state
        method, dt = METHODS[scene.integrator.method], scene.integrator.dt
        # Euler takes the scene's step. Verlet stands in for methods that may handle longer steps than it
        # does.
        self._euler = method.order == 1
        self._longest = dt if self._euler else min(dt, _SAFETY * damped_limit(system))
        self._a: Vectors | None = None  # of the present state
        self.system = system

    @property
    def system(self) -> System:
        """The tables; without the springs that were broken when it started."""
        return self._system

    @system.setter
    def system(self, system: System) -> None:
        self._system, self._body = system, system.body
        around = system.body.environment
        # Its steps are fixed, whatever those of the method are: they soften hard walls and contact.
        softening = around.replaced(step=self._longest)
        self._physics = Physics(system.body.replaced(environment=softening), self._state)

    def load(self, time: float) -> None:
        """Start from the state in `state`, at a time (s)."""
        self.time, self._a = time, None

    @property
    def tracks_energy(self) -> bool:
        """Whether it keeps an energy balance: never."""
        return False

    def invalidate(self) -> None:
        """Note that the state, or what acts on it, was changed from outside."""
        self._a = None

    def stats(self) -> SolverStats:
        """Counts of steps since the last call."""
        stats, self.work = SolverStats(steps=self.work, forces=self.work, work=self.work), 0
        return stats

    def run(self, until: float, drive: PrescribedMotion, attempts: int = UNLIMITED) -> int:
        """Advance to a time (s), or by at most `attempts` steps.

        If a body runs away under Verlet, it stops without an error, since its own method may be stable.

        Returns:
            guard.GOOD, or what is wrong with the state after the next step.
        """
        state, span = self._state, until - self.time
        steps = max(1, math.ceil(span / self._longest - 1e-6))
        h = self._longest if self._euler else span / steps
        x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
        a = self._a
        if a is None:
            self._drive_to(drive, self.time, x, v)
            a = self._physics.accelerations(x, v)
        for _ in range(min(steps, attempts)):
            before = x, v, state.controls.copy()
            t = self.time + h
            lead = partial(self._drive_to, drive, t)
            if self._euler:
                # Hands and keys come first, as in the tutorial; circles go on with the masses.
                x, v = x.copy(), v.copy()
                self._drive_to(drive, t, x, v, self.time)
                x, v = euler_step(self._physics, x, v, h)
            else:
                x, v, a = verlet_step(self._physics, x, v, a, h, lead)
            lead(x, v)  # the step has moved them
            self.work += 1
            status = self._verdict(x, v)
            if status != guard.GOOD:
                x, v, state.controls[:] = before
                update_rest_state(self._body, state)
                self._keep(x, v, None)
                return status if self._euler else guard.GOOD
            self._physics.update_friction_history(x, v)
            self.time = t
        if self.time > until - 1e-9 * span:
            self.time = until
        self._keep(x, v, None if self._euler else a)
        return guard.GOOD

    def _keep(self, x: Vectors, v: Vectors, a: Vectors | None) -> None:
        state, self._a = self._state, a
        state.x[:], state.y[:], state.vx[:], state.vy[:] = x.real, x.imag, v.real, v.imag

    def _drive_to(
        self, drive: PrescribedMotion, t: float, x: Vectors, v: Vectors, round_at: float | None = None
    ) -> None:
        """Set the held masses in x and v, and rest lengths and angles, to their state at time t.

        Those on circles are set to where they are at `round_at`, if given.
        """
        if not drive.moving:
            return
        if round_at is None:
            round_at = t
        since = t - drive.start
        led = min(since, drive.duration)
        lead = LeadParameters(*drive.rows.T)
        speed, acceleration, jerk = lead.vx + 1j * lead.vy, lead.ax + 1j * lead.ay, lead.jx + 1j * lead.jy
        fade = np.exp(-round_at / lead.ramp)
        turn = np.exp(1j * lead.omega * (round_at - lead.ramp * (1.0 - fade)))
        # i r - i r exp(ip) = r (sin p, 1 - cos p), see `Circle`.
        circle, rate = 1j * lead.radius * (1.0 - turn), lead.radius * lead.omega * (1.0 - fade) * turn
        along = lead.along_x + 1j * lead.along_y
        on_rail = along != 0.0
        circle = np.where(on_rail, along * (along.conjugate() * circle).real, circle)
        rate = np.where(on_rail, along * (along.conjugate() * rate).real, rate)
        x[drive.mass] = (
            lead.x + 1j * lead.y + circle
            + led * (speed + led * (0.5 * acceleration + led / 6.0 * jerk))
        )  # fmt: skip
        v[drive.mass] = lead.hand * (speed + since * (acceleration + 0.5 * since * jerk)) + rate
        if drive.timed:
            self._state.clock[0] = t
        if drive.pressed:
            controls = self._state.controls
            scale = drive.scale * math.exp(drive.growth * since)
            controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
            controls[CONTROL_SHIFT] = 180.0 - (180.0 - (drive.shift + drive.turn * since)) % 360.0
        if drive.pressed or self._body.muscles.present:
            update_rest_state(self._body, self._state)

    def _verdict(self, x: Vectors, v: Vectors) -> int:
        far = np.maximum(abs(x.real), abs(x.imag))
        fast = np.maximum(abs(v.real), abs(v.imag))
        with np.errstate(invalid="ignore"):
            for status, bad in (
                (guard.BAD_NUMBER, ~(np.isfinite(far) & np.isfinite(fast))),
                (guard.BAD_POSITION, far > MAX_COORDINATE),
                (guard.BAD_SPEED, fast > self.fastest),
            ):
                if bad.any():
                    self.index = int(np.argmax(bad))
                    return status
        return guard.GOOD
