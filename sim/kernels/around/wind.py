"""Wind: air that moves, against which the air friction of the scene acts.

Gusts are waves of velocity across their own direction, so that the air is not compressed, which the mean wind
carries along: a wave with the wave vector k adds its amplitude times sin(k . x - k . w t + phase) to the mean
wind w (Kraichnan 1970, Taylor 1938).
"""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.surroundings import WAVE_PHASE, WAVE_RATE, WAVE_U, WAVE_V, WAVE_X, WAVE_Y


@kernel(fastmath=FAST)
def wind_at(around, t, x, y):
    """Velocity of the air at a point and a time, and its derivatives by position.

    Returns:
        u, v (px/s), du/dx, du/dy, dv/dx, dv/dy (1/s).
    """
    u, v = around.wind_x, around.wind_y
    ux, uy, vx, vy = 0.0, 0.0, 0.0, 0.0
    for k in range(around.waves.shape[0]):
        wave = around.waves[k]
        angle = wave[WAVE_X] * x + wave[WAVE_Y] * y + wave[WAVE_PHASE] + wave[WAVE_RATE] * t
        sine, cosine = math.sin(angle), math.cos(angle)
        u += wave[WAVE_U] * sine
        v += wave[WAVE_V] * sine
        ux += wave[WAVE_U] * cosine * wave[WAVE_X]
        uy += wave[WAVE_U] * cosine * wave[WAVE_Y]
        vx += wave[WAVE_V] * cosine * wave[WAVE_X]
        vy += wave[WAVE_V] * cosine * wave[WAVE_Y]
    return u, v, ux, uy, vx, vy


@kernel(fastmath=FAST)
def blow(body, state, x, y, vx, vy, ax, ay):
    """Add the accelerations of free masses by the friction of moving air."""
    around, t = body.surroundings, state.clock[0]
    for i in range(1, body.masses + 1):
        drag = around.air_friction * state.inverse_mass[i]
        if drag > 0.0:
            u, v, _, _, _, _ = wind_at(around, t, x[i], y[i])
            u, v = vx[i] - u, vy[i] - v
            ax[i] -= drag * u * abs(u)
            ay[i] -= drag * v * abs(v)


@kernel(fastmath=FAST)
def power_of_wind(body, state, x, y, vx, vy):
    """The power of the friction of moving air on free masses, kg px²/s³."""
    around, t, power = body.surroundings, state.clock[0], 0.0
    for i in range(1, body.masses + 1):
        if around.air_friction > 0.0 and state.inverse_mass[i] > 0.0:
            u, v, _, _, _, _ = wind_at(around, t, x[i], y[i])
            u, v = vx[i] - u, vy[i] - v
            power -= around.air_friction * (u * abs(u) * vx[i] + v * abs(v) * vy[i])
    return power
