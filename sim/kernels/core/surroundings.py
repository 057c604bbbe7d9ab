"""The table of what acts on a body besides springs and gravity: walls, wind, fillings, contact."""

from __future__ import annotations

from .contacts import Contacts
from .table import Floats, Indices, Rows, Table


class Surroundings(Table):
    """Read-only. W walls, K waves of gusts, L loops with a filling."""

    present: bool  # anything is in this table
    step: float  # s, of an explicit method with a fixed step, for which walls are softened; 0 for others
    mass: Floats  # (slots,) kg
    # Walls
    walls: Rows  # (W, 8), see the WALL_ constants
    # Wind
    air_friction: float  # kg/px, where there is wind; `State.air` is then zero
    wind_x: float  # px/s, the mean wind
    wind_y: float
    waves: Rows  # (K, 6), see the WAVE_ constants
    # Fillings
    loop_start: Indices  # (L + 1,) where the masses of each loop start in `loop`
    loop: Indices  # slots of the masses of all loops, each in the order in which its area is positive
    fillings: Rows  # (L, 4), see the FILLING_ constants
    contact: Contacts


WALL_X, WALL_Y, WALL_NORMAL_X, WALL_NORMAL_Y = 0, 1, 2, 3
"""In a row of `walls`: a point of the surface, px, and the unit vector to the free side."""
WALL_HARDNESS, WALL_FRICTION, WALL_SLIP, WALL_LOSS = 4, 5, 6, 7
"""In a row of `walls`: hardness, 1/(px s²), coefficient of friction, slip speed, px/s, and the factor of the
speed in the damping, s/px."""
WALL_ROW = 8
"""Length of a row of `walls`."""

WAVE_X, WAVE_Y, WAVE_U, WAVE_V, WAVE_PHASE, WAVE_RATE = 0, 1, 2, 3, 4, 5
"""In a row of `waves`: wave vector, 1/px, amplitude, px/s, phase at time zero, and its rate, 1/s."""
WAVE_ROW = 6
"""Length of a row of `waves`."""

FILLING_GAS, FILLING_PRESSURE, FILLING_OUTSIDE, FILLING_AREA = 0, 1, 2, 3
"""In a row of `fillings`: 1 for a gas and 0 for a liquid, its pressure or bulk modulus, the pressure outside,
kg/s², and the area, px²."""
FILLING_ROW = 4
"""Length of a row of `fillings`."""
