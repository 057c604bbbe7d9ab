"""Wind: air that moves, against which the air friction of the scene acts.

Gusts are waves of velocity across their own direction, so that the air is not compressed, which the mean wind
carries along: a wave with the wave vector k adds its amplitude times sin(k . x - k . w t + phase) to the mean
wind w (Kraichnan 1970, Taylor 1938).
"""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.sines import sine
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


@kernel(fastmath=FAST, noalias=True)
def _add_wave(wave, t, x, y, u, v):
    """Add the velocity of the air in one wave at each mass."""
    kx, ky, phase = wave[WAVE_X], wave[WAVE_Y], wave[WAVE_PHASE] + wave[WAVE_RATE] * t
    along_x, along_y = wave[WAVE_U], wave[WAVE_V]
    for i in range(x.size):
        s = sine(kx * x[i] + ky * y[i] + phase)
        u[i] += along_x * s
        v[i] += along_y * s


@kernel(fastmath=FAST, noalias=True)
def _drag(friction, inverse_mass, u, v, vx, vy, ax, ay):
    """Add the accelerations by the friction of air that moves with the velocities u, v at the masses."""
    for i in range(u.size):
        drag, past_x, past_y = friction * inverse_mass[i], vx[i] - u[i], vy[i] - v[i]
        ax[i] -= drag * past_x * abs(past_x)
        ay[i] -= drag * past_y * abs(past_y)


@kernel(fastmath=FAST)
def blow(body, state, scratch, x, y, vx, vy, ax, ay):
    """Add the accelerations of free masses by the friction of moving air.

    The velocity of the air at each mass replaces the forces in `scratch`, which are no longer needed.
    """
    around, t, end = body.surroundings, state.clock[0], body.masses + 1
    u, v = scratch.fx[1:end], scratch.fy[1:end]
    u[:] = around.wind_x
    v[:] = around.wind_y
    for k in range(around.waves.shape[0]):
        _add_wave(around.waves[k], t, x[1:end], y[1:end], u, v)
    inverse_mass = state.inverse_mass[1:end]
    _drag(around.air_friction, inverse_mass, u, v, vx[1:end], vy[1:end], ax[1:end], ay[1:end])


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
