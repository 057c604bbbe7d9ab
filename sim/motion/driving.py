"""What drives a body from outside: masses that are led or move on circles, and held keys."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from ..engine.tables import CONTROL_SCALE, CONTROL_SHIFT, LeadParameters, PrescribedMotion, State
from ..forces.all import TERMS
from ..forces.rails import ways_of
from ..model.system import System
from ..scene.numbers import MAX_SPEED
from ..scene.types import Circle, Scene
from .hands import NO_MOTION, NO_MOTIONS, HandMotions

_SAFETY = 1.0 - 1e-15
"""Factor that keeps a hand which moves to the edge of the allowed range from passing it by a rounding
error."""


class Driver:
    """Makes the table of how the held masses of a scene move and what held keys do.

    Args:
        scene: a valid scene.
        system: its tables.
        state: the positions, and the present scale of rest lengths and shift of rest angles.
    """

    def __init__(self, scene: Scene, system: System, state: State) -> None:
        self._state = state
        self._circles = {
            int(system.mass_index[a.mass]): a.circle for a in scene.anchors if a.circle is not None
        }
        self._rails = ways_of(system.body)
        muscular = system.body.muscles.present
        self._timed = muscular or any(term.depends_on_time(system.body) for term in TERMS)
        self._hand = 0.0 if scene.force_law == "tutorial" else 1.0
        self._last: tuple[tuple[float, ...], PrescribedMotion] | None = None

    def drive(
        self,
        t: float,
        until: float,
        targets: Mapping[int, tuple[float, float]],
        growth: float = 0.0,
        turn: float = 0.0,
        motions: HandMotions = NO_MOTIONS,
    ) -> PrescribedMotion:
        """How masses move and keys act from one time to another.

        Without targets and hands it is kept, for bodies that start from the same place again and again.

        Args:
            t, until: the present time, and the time at which targets are to be reached, s.
            targets: positions, px, to which masses are led in straight lines, by slot.
            growth, turn: what keys do to rest lengths and angles per second, see `PrescribedMotion`.
            motions: motions of rate-limited hands, by slot.
        """
        state = self._state
        if targets or motions:
            return self._new(t, until, targets, growth, turn, motions)
        places = [each[m] for m in self._circles for each in (state.x, state.y)]
        key = (t, growth, turn, *state.controls.tolist(), *places)
        if self._last is None or self._last[0] != key:
            self._last = key, self._new(t, until, targets, growth, turn, motions)
        return self._last[1]

    def _new(
        self,
        t: float,
        until: float,
        targets: Mapping[int, tuple[float, float]],
        growth: float,
        turn: float,
        motions: HandMotions,
    ) -> PrescribedMotion:
        state, duration = self._state, max(until - t, 1e-300)
        indices = sorted({*targets, *motions, *self._circles})
        pressed = growth != 0.0 or turn != 0.0
        rows = []
        for m in indices:
            circle = self._circles.get(m)
            x, y = state.x[m], state.y[m]
            rail = self._rails.get(m, (0.0, 0.0))
            ox, oy = offset(circle, t, rail)
            motion = motions.get(m, NO_MOTION)
            vx, vy = motion.vx, motion.vy
            if m in targets:
                ex, ey = offset(circle, until, rail)
                vx = _SAFETY * bounded((targets[m][0] - ex - (x - ox)) / duration)
                vy = _SAFETY * bounded((targets[m][1] - ey - (y - oy)) / duration)
            radius, omega, ramp = (
                (circle.radius, math.tau * circle.frequency, circle.ramp) if circle else (0.0, 0.0, 1.0)
            )
            # Under the tutorial's law, the damping treats a directly led mass as being at rest.
            seen = 1.0 if m in motions else self._hand
            led = x - ox, y - oy, vx, vy, *motion[2:], seen
            rows.append(LeadParameters(*led, radius, omega, ramp, *rail))
        return PrescribedMotion(
            moving=bool(indices) or pressed or self._timed,
            pressed=pressed,
            timed=self._timed,
            start=t,
            duration=duration if targets else math.inf,
            mass=np.array(indices, np.int64),
            rows=np.array(rows, float).reshape(-1, len(LeadParameters._fields)),
            scale=float(state.controls[CONTROL_SCALE]),
            shift=float(state.controls[CONTROL_SHIFT]),
            growth=float(growth),
            turn=float(turn),
        )


def bounded(speed: float) -> float:
    """A velocity component, px/s, limited to the allowed range; a mass that is led faster jumps."""
    return min(max(speed, -MAX_SPEED), MAX_SPEED)


NO_RAIL = 0.0, 0.0
"""Direction that stands for no rail."""


def offset(circle: Circle | None, time: float, rail: tuple[float, float] = NO_RAIL) -> tuple[float, float]:
    """Displacement, px, of an anchor on a circle at a time (s), along a rail if there is one; zero if it has
    no circle."""
    if circle is None:
        return 0.0, 0.0
    phase = math.tau * circle.frequency * (time - circle.ramp * (1.0 - math.exp(-time / circle.ramp)))
    return _along(rail, circle.radius * math.sin(phase), circle.radius * (1.0 - math.cos(phase)))


def velocity(circle: Circle, time: float, rail: tuple[float, float] = NO_RAIL) -> tuple[float, float]:
    """Velocity, px/s, of an anchor on a circle at a time (s), along a rail if there is one."""
    fade = math.exp(-time / circle.ramp)
    omega = math.tau * circle.frequency
    phase, speed = omega * (time - circle.ramp * (1.0 - fade)), circle.radius * omega * (1.0 - fade)
    return _along(rail, speed * math.cos(phase), speed * math.sin(phase))


def _along(rail: tuple[float, float], x: float, y: float) -> tuple[float, float]:
    if rail == NO_RAIL:
        return x, y
    way = rail[0] * x + rail[1] * y
    return rail[0] * way, rail[1] * way
