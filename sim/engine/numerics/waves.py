"""The waves of muscles, see `forces.muscles`; a row is a `forces.muscles.Row`."""

from __future__ import annotations

import math

from ..jit import kernel

AMPLITUDE, RATE, PHASE, PULSE = 0, 1, 2, 3
"""Columns of a row: the amplitude; the rate of the phase, 1/s; the phase at time zero; 1 for a pulse, 0 for a
sine."""
SHARPNESS = 4.0
"""Exponent of a pulse exp(SHARPNESS (sin p - 1)), which is above one half for a fifth of the time. Doubled or
halved, `test_the_work_of_quick_muscles_is_that_of_all_their_waves` fails."""


@kernel(forceinline=True)
def wave(row, t):
    """Return the amplitude times the wave, at time t."""
    size = math.sin(row[RATE] * t + row[PHASE])
    return row[AMPLITUDE] * (math.exp(SHARPNESS * (size - 1.0)) if row[PULSE] > 0.0 else size)


@kernel(forceinline=True)
def wave_rate(row, t):
    """Return the rate of the wave, 1/s."""
    p = row[RATE] * t + row[PHASE]
    rate = row[AMPLITUDE] * row[RATE] * math.cos(p)
    if row[PULSE] > 0.0:
        rate *= SHARPNESS * math.exp(SHARPNESS * (math.sin(p) - 1.0))
    return rate
