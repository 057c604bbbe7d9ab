"""Where held masses are at any time, and what held keys have done until then."""

from __future__ import annotations

import math

from .controls import circle_at, refresh
from .jit import kernel
from .tables import CONTROL_SCALE, CONTROL_SHIFT, SCALE_MAX, SCALE_MIN


@kernel(forceinline=True)
def hand_speed(drive, i, t):
    """The velocity at time t with which the mass of a number is led by hand, px/s."""
    since = t - drive.start
    return (
        drive.vx[i] + since * (drive.ax[i] + 0.5 * since * drive.jx[i]),
        drive.vy[i] + since * (drive.ay[i] + 0.5 * since * drive.jy[i]),
    )


@kernel(forceinline=True)
def drive_to(body, live, drive, t, q, v):
    """Put the held masses where they are at time t, in q and v, and set rest lengths and angles."""
    places = q.size // 2
    since = t - drive.start
    for i in range(drive.mass.size):
        m = drive.mass[i]
        x = drive.x[i] + since * (drive.vx[i] + since * (0.5 * drive.ax[i] + since / 6.0 * drive.jx[i]))
        y = drive.y[i] + since * (drive.vy[i] + since * (0.5 * drive.ay[i] + since / 6.0 * drive.jy[i]))
        vx, vy = hand_speed(drive, i, t)
        vx, vy = vx * drive.hand[i], vy * drive.hand[i]
        if drive.radius[i] > 0.0:
            dx, dy, du, dv = circle_at(t, drive.radius[i], drive.omega[i], drive.ramp[i])
            x, y, vx, vy = x + dx, y + dy, vx + du, vy + dv
        q[m], q[places + m] = x, y
        v[m], v[places + m] = vx, vy
    if drive.pressed:
        scale = drive.scale * math.exp(drive.growth * since)
        live.controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
        shift = drive.shift + drive.turn * since
        live.controls[CONTROL_SHIFT] = 180.0 - (180.0 - shift) % 360.0
        refresh(body, live)
