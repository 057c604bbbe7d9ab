"""What drives a body from outside: masses that are led or go round, and held keys."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from ..body.system import System
from ..kernels.core.tables import CONTROL_SCALE, CONTROL_SHIFT, Drive, State
from ..scene.types import MAX_SPEED, Circle, Scene
from .drag import NO_MOTION, NO_MOTIONS, HandMotions

_SHY = 1.0 - 1e-15
"""A hand that goes to the very edge of what a scene may have must not pass it by a rounding error."""


class Driver:
    """Says how the held masses of a scene move, and what held keys do, from now until later.

    Args:
        scene: a valid scene.
        system: its tables.
        state: positions, and what keys have done until now.
    """

    def __init__(self, scene: Scene, system: System, state: State) -> None:
        self._state = state
        self._still: Drive | None = None
        self._circles = {
            int(system.mass_index[a.mass]): a.circle for a in scene.anchors if a.circle is not None
        }
        self._hand = 0.0 if scene.force_law == "tutorial" else 1.0

    def drive(
        self,
        t: float,
        until: float,
        targets: Mapping[int, tuple[float, float]],
        growth: float = 0.0,
        turn: float = 0.0,
        motions: HandMotions = NO_MOTIONS,
    ) -> Drive:
        """How masses move and keys act from one time to another.

        Args:
            t, until: now, and the time when targets are to be reached, s.
            targets: where masses that are led straight are to be then, px, by index.
            growth, turn: what keys do to rest lengths and angles per second, see `Drive`.
            motions: how rate-limited hands move, by index.
        """
        state, duration = self._state, max(until - t, 1e-300)
        slots = sorted({*targets, *motions, *self._circles})
        pressed = growth != 0.0 or turn != 0.0
        if not slots and not pressed and self._still is not None:
            return self._still  # the same whenever it is
        rows = []
        for m in slots:
            circle = self._circles.get(m)
            x, y = state.x[m], state.y[m]
            ox, oy = offset(circle, t)
            motion = motions.get(m, NO_MOTION)
            vx, vy = motion.vx, motion.vy
            if m in targets:
                ex, ey = offset(circle, until)
                vx = _SHY * bounded((targets[m][0] - ex - (x - ox)) / duration)
                vy = _SHY * bounded((targets[m][1] - ey - (y - oy)) / duration)
            radius, omega, ramp = (
                (circle.radius, math.tau * circle.frequency, circle.ramp) if circle else (0.0, 0.0, 1.0)
            )
            # The tutorial's hand, which is always as fast as the pointer, counts as standing still.
            seen = 1.0 if m in motions else self._hand
            rows.append((x - ox, y - oy, vx, vy, *motion[2:], seen, radius, omega, ramp))
        columns = np.array(rows, float).reshape(-1, 12).T.copy()
        names = ("x", "y", "vx", "vy", "ax", "ay", "jx", "jy", "hand", "radius", "omega", "ramp")
        drive = Drive(
            moving=bool(slots) or pressed,
            pressed=pressed,
            start=t,
            duration=duration if targets else math.inf,
            mass=np.array(slots, np.int64),
            scale=float(state.controls[CONTROL_SCALE]),
            shift=float(state.controls[CONTROL_SHIFT]),
            growth=float(growth),
            turn=float(turn),
            **dict(zip(names, columns, strict=True)),
        )
        if not drive.moving:
            self._still = drive
        return drive


def bounded(speed: float) -> float:
    """A speed with which a mass may be led, px/s; what is led faster gets there by a jump."""
    return min(max(speed, -MAX_SPEED), MAX_SPEED)


def offset(circle: Circle | None, time: float) -> tuple[float, float]:
    """How far an anchor is off its place at a time, px: on its circle, if it has one."""
    if circle is None:
        return 0.0, 0.0
    phase = math.tau * circle.frequency * (time - circle.ramp * (1.0 - math.exp(-time / circle.ramp)))
    return circle.radius * math.sin(phase), circle.radius * (1.0 - math.cos(phase))
