"""Gases and liquids in closed loops of masses.

The force on each mass is the excess pressure times the gradient of the loop's area (the shoelace formula). So
the forces of a loop have no sum and no torque, and are the gradient of an energy that depends on the area
alone.
"""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.surroundings import FILLING_AREA, FILLING_GAS, FILLING_OUTSIDE, FILLING_PRESSURE

SMALLEST = 0.01
"""Area of a gas, as a fraction of its own area, below which its pressure grows linearly."""


@kernel(forceinline=True)
def neighbours(around, loop, i):
    """The slots of the masses before and after the i-th of all masses in loops, which is in that loop."""
    first, behind = around.loop_start[loop], around.loop_start[loop + 1]
    before = around.loop[i - 1] if i > first else around.loop[behind - 1]
    after = around.loop[i + 1] if i + 1 < behind else around.loop[first]
    return before, after


@kernel(fastmath=FAST)
def area_of(around, loop, x, y):
    """The area of a loop, px²."""
    start = around.loop[around.loop_start[loop]]
    x0, y0, twice = x[start], y[start], 0.0  # differences of coordinates lose no digits far from the origin
    for i in range(around.loop_start[loop], around.loop_start[loop + 1]):
        m = around.loop[i]
        _, n = neighbours(around, loop, i)
        twice += (x[m] - x0) * (y[n] - y0) - (x[n] - x0) * (y[m] - y0)
    return 0.5 * twice


@kernel(fastmath=FAST)
def pressure_at(filling, area):
    """The pressure of a filling beyond that outside, kg/s², and its derivative by the area."""
    size, strength = filling[FILLING_AREA], filling[FILLING_PRESSURE]
    if filling[FILLING_GAS] == 0.0:
        return strength * (1.0 - area / size), -strength / size
    least = SMALLEST * size
    if area > least:
        inside = strength * size / area
        return inside - filling[FILLING_OUTSIDE], -inside / area
    return (
        strength * size * (2.0 - area / least) / least - filling[FILLING_OUTSIDE],
        -strength * size / (least * least),
    )


@kernel(fastmath=FAST)
def energy_at(filling, area):
    """The energy of a filling, kg px²/s², zero at its own area."""
    size, strength = filling[FILLING_AREA], filling[FILLING_PRESSURE]
    off = area - size
    if filling[FILLING_GAS] == 0.0:
        return 0.5 * strength * off * off / size
    least = SMALLEST * size
    if area > least:
        return filling[FILLING_OUTSIDE] * off - strength * size * math.log(area / size)
    below = (area - least) / least
    return filling[FILLING_OUTSIDE] * off - strength * size * (
        math.log(SMALLEST) + below - 0.5 * below * below
    )


@kernel(fastmath=FAST)
def press_from_inside(around, x, y, fx, fy):
    """Add the forces of all fillings on the masses around them."""
    for k in range(around.fillings.shape[0]):
        pressure, _ = pressure_at(around.fillings[k], area_of(around, k, x, y))
        for i in range(around.loop_start[k], around.loop_start[k + 1]):
            m = around.loop[i]
            before, after = neighbours(around, k, i)
            fx[m] += 0.5 * pressure * (y[after] - y[before])
            fy[m] += 0.5 * pressure * (x[before] - x[after])


@kernel(fastmath=FAST)
def energy_of_fillings(around, x, y):
    """The energy of all fillings, kg px²/s²."""
    energy = 0.0
    for k in range(around.fillings.shape[0]):
        energy += energy_at(around.fillings[k], area_of(around, k, x, y))
    return energy
