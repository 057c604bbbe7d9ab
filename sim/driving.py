"""What drives a body from outside: masses that are led or go round, and held keys."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from .hand import NO_GLIDE, Glides
from .kernels.controls import circle_at
from .kernels.tables import CONTROL_SCALE, CONTROL_SHIFT, Drive, Floats, Live
from .scene import MAX_SPEED, Circle

_SHY = 1.0 - 1e-15
"""A hand that goes to the very edge of what a scene may have must not pass it by a rounding error."""


def new_drive(
    q: Floats,
    live: Live,
    circles: Mapping[int, Circle],
    hand: float,
    t: float,
    until: float,
    targets: Mapping[int, tuple[float, float]],
    growth: float,
    turn: float,
    glides: Glides,
) -> Drive:
    """How masses move and keys act from one time to another.

    Args:
        q: positions now, flat.
        live: with what keys have done until now.
        circles: that masses go round on, by place.
        hand: as in `Drive`, of masses that are led straight.
        t, until: now, and the time when targets are to be reached, s.
        targets: where masses that are led straight are to be then, px, by place.
        growth, turn: what keys do to rest lengths and angles per second, see `Drive`.
        glides: how gentle hands move, by place.
    """
    duration = max(until - t, 1e-300)
    places = sorted({*targets, *glides, *circles})
    rows = []
    for m in places:
        circle = circles.get(m)
        x, y = q[m], q[q.size // 2 + m]
        ox, oy = offset(circle, t)
        glide = glides.get(m, NO_GLIDE)
        vx, vy = glide.vx, glide.vy
        if m in targets:
            ex, ey = offset(circle, until)
            vx = _SHY * bounded((targets[m][0] - ex - (x - ox)) / duration)
            vy = _SHY * bounded((targets[m][1] - ey - (y - oy)) / duration)
        radius, omega, ramp = (
            (circle.radius, math.tau * circle.frequency, circle.ramp) if circle else (0.0, 0.0, 1.0)
        )
        # The tutorial's hand, which is always as fast as the pointer, counts as standing still.
        seen = 1.0 if m in glides else hand
        rows.append((x - ox, y - oy, vx, vy, *glide[2:], seen, radius, omega, ramp))
    columns = np.array(rows, float).reshape(-1, 12).T.copy()
    pressed = growth != 0.0 or turn != 0.0
    return Drive(
        moving=bool(places) or pressed,
        pressed=pressed,
        start=t,
        mass=np.array(places, np.int64),
        x=columns[0],
        y=columns[1],
        vx=columns[2],
        vy=columns[3],
        ax=columns[4],
        ay=columns[5],
        jx=columns[6],
        jy=columns[7],
        hand=columns[8],
        radius=columns[9],
        omega=columns[10],
        ramp=columns[11],
        scale=float(live.controls[CONTROL_SCALE]),
        shift=float(live.controls[CONTROL_SHIFT]),
        growth=float(growth),
        turn=float(turn),
    )


def bounded(speed: float) -> float:
    """A speed with which a mass may be led, px/s; what is led faster gets there by a jump."""
    return min(max(speed, -MAX_SPEED), MAX_SPEED)


def offset(circle: Circle | None, time: float) -> tuple[float, float]:
    """How far an anchor is off its place at a time, px: on its circle, if it has one."""
    if circle is None:
        return 0.0, 0.0
    x, y, _, _ = circle_at(time, circle.radius, math.tau * circle.frequency, circle.ramp)
    return x, y
