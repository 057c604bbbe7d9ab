"""Where held masses are at any time, and what held keys have done until then."""

from __future__ import annotations

import math

from .controls import refresh
from .jit import kernel
from .tables import CONTROL_SCALE, CONTROL_SHIFT, SCALE_MAX, SCALE_MIN


@kernel()
def drive_to(body, live, drive, t, q, v):
    """Put the held masses where they are at time t, in q and v, and set rest lengths and angles."""
    places = q.size // 2
    since = t - drive.start
    for i in range(drive.mass.size):
        m = drive.mass[i]
        x, y = drive.x[i] + drive.vx[i] * since, drive.y[i] + drive.vy[i] * since
        vx, vy = drive.vx[i] * drive.hand, drive.vy[i] * drive.hand
        if drive.radius[i] > 0.0:
            fade = math.exp(-t / drive.ramp[i])
            phase = drive.omega[i] * (t - drive.ramp[i] * (1.0 - fade))
            rate = drive.omega[i] * (1.0 - fade)
            sine, cosine = math.sin(phase), math.cos(phase)
            x += drive.radius[i] * sine
            y += drive.radius[i] * (1.0 - cosine)
            vx += drive.radius[i] * cosine * rate
            vy += drive.radius[i] * sine * rate
        q[m], q[places + m] = x, y
        v[m], v[places + m] = vx, vy
    if drive.pressed:
        scale = drive.scale * math.exp(drive.growth * since)
        live.controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
        shift = drive.shift + drive.turn * since
        live.controls[CONTROL_SHIFT] = 180.0 - (180.0 - shift) % 360.0
        refresh(body, live)
