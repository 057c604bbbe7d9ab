"""The waves of muscles, see `forces.muscles`; a row is a `forces.muscles.Row`, `steer` that of a state."""

from __future__ import annotations

import math

from ..jit import kernel

AMPLITUDE, RATE, PHASE, KIND, STEER = 0, 1, 2, 3, 4
"""Columns of a row: the amplitude; the rate of the phase, 1/s; the phase at time zero; one of the kinds
below; and the index in `State.steer` of the keys that work the muscle, or -1."""
SINE, PULSE, STEADY = 0.0, 1.0, 2.0
"""Kinds of waves."""
SHARPNESS = 4.0
"""Exponent of a pulse exp(SHARPNESS (sin p - 1)), which is above one half for a fifth of the time. Doubled or
halved, `test_the_work_of_quick_muscles_is_that_of_all_their_waves` fails."""


KEYS = 2
"""Number of pairs of keys."""
EFFORTS, SINCE = KEYS, 2 * KEYS
"""Where `State.steer` has the efforts of the pairs of keys at the time of the last change of keys, and that
time; see `effort`."""
RISE = 0.05
"""Time constant of an effort, s; that of muscles is of this size (Zajac 1989). Doubled or halved,
`test_a_muscle_pulls_while_its_key_is_held` fails."""


@kernel(forceinline=True)
def effort(steer, k, t):
    """Return the effort of the k-th pair of keys at time t: -1..1."""
    goal = steer[k]
    return goal + (steer[EFFORTS + k] - goal) * math.exp(-max(t - steer[SINCE], 0.0) / RISE)


@kernel(forceinline=True)
def wave(row, steer, t):
    """Return the amplitude times the wave, at time t."""
    size, rate = row[AMPLITUDE], row[RATE]
    if row[STEER] >= 0.0:
        e = effort(steer, int(row[STEER]), t)
        if row[KIND] == STEADY:
            return e * size
        size, rate = abs(e) * size, math.copysign(rate, e)
    sine = math.sin(rate * t + row[PHASE])
    return size * (math.exp(SHARPNESS * (sine - 1.0)) if row[KIND] == PULSE else sine)


@kernel(forceinline=True)
def wave_rate(row, steer, t):
    """Return the rate of the wave, 1/s."""
    size, rate, growth = row[AMPLITUDE], row[RATE], 0.0
    if row[STEER] >= 0.0:
        k = int(row[STEER])
        e = effort(steer, k, t)
        growth = size * (steer[k] - e) / RISE
        if row[KIND] == STEADY:
            return growth
        growth = -growth if e < 0.0 else growth
        size, rate = abs(e) * size, math.copysign(rate, e)
    sine, slope = math.sin(rate * t + row[PHASE]), rate * math.cos(rate * t + row[PHASE])
    if row[KIND] == PULSE:
        sine = math.exp(SHARPNESS * (sine - 1.0))
        slope *= SHARPNESS * sine
    return size * slope + growth * sine
