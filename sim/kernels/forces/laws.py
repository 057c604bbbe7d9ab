"""The force laws of joints: how torque and energy follow from the deflection.

With V the angle from spring A to spring B, r the rest angle and f a function of the deflection V - r, a joint
has the torque K |A||B| f(V - r). Where the law has an energy, that is K |A||B| F(V - r), with f the slope
of F; since it grows with the lengths, it also pulls along the springs.

A law is a row in `LAWS` and a case in `terms`; all kernels read it from there. The two laws of the sine need
no trigonometry, since |A||B| sin(V - r) and |A||B| cos(V - r) are products of the vectors: for these, kernels
have that algebra as well, and the tests hold it against `terms`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..core.jit import FAST, kernel

NO_JOINTS, TUTORIAL, CONSERVATIVE, ANGLE = 0, 1, 2, 3
"""Values of `Body.law`."""


class Law(NamedTuple):
    """What is known of a law beside its terms."""

    code: int  # in `Body.law`
    label: str  # for people
    has_energy: bool  # whether it is the gradient of its energy


LAWS = {
    "tutorial": Law(TUTORIAL, "Tutorial", False),
    "conservative": Law(CONSERVATIVE, "Conservative", True),
    "angle": Law(ANGLE, "Angle itself", True),
}
"""By the names that scenes have."""


@kernel(forceinline=True, fastmath=FAST)
def terms(law, deflection):
    """f, F and f' at a deflection (radians): torque, energy and stiffness for K |A||B| = 1.

    The tutorial's law has the sine's energy, of which it is not the gradient. Not numbers for an unknown law.
    """
    if law == ANGLE:
        return deflection, 0.5 * deflection * deflection, 1.0
    if law in (TUTORIAL, CONSERVATIVE):
        half = math.sin(0.5 * deflection)
        return math.sin(deflection), 2.0 * half * half, math.cos(deflection)
    return np.nan, np.nan, np.nan


@kernel(forceinline=True)
def is_sine(law):
    """Whether a law's torque is the sine of the deflection, or there are no joints."""
    return law in (TUTORIAL, CONSERVATIVE, NO_JOINTS)
