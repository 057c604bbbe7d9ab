"""The force laws of joints: torque and energy as functions of the deflection.

Let V be the angle from spring A to spring B, r the rest angle and V - r the deflection. A joint has the
torque K |A||B| f(V - r). If the law has an energy, that is K |A||B| F(V - r), where f is the derivative of F.
Since the energy grows with the lengths of the springs, there is then also a pull along them.

A law is a row in `LAWS` and a case in `terms`; all kernels read it from there. The two sine laws need no
trigonometric functions, since |A||B| sin(V - r) and |A||B| cos(V - r) are products of the vectors. Kernels
have this algebra for them as well, and the tests compare it with `terms`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..core.jit import FAST, kernel

NO_JOINTS, TUTORIAL, CONSERVATIVE, ANGLE = 0, 1, 2, 3
"""Values of `Body.law`: a body without joints, and the three force laws."""


_HALVINGS = 50
"""Number of halvings in `deflection_at`: to rounding."""


class Law(NamedTuple):
    """Properties of a law, apart from its terms."""

    code: int  # in `Body.law`
    label: str  # for people


LAWS = {
    "tutorial": Law(TUTORIAL, "Tutorial"),
    "conservative": Law(CONSERVATIVE, "Conservative"),
    "angle": Law(ANGLE, "Angle law"),
}
"""The laws, by their names in scenes."""


@kernel(forceinline=True, fastmath=FAST)
def terms(law, deflection):
    """f, F and f' at a deflection (radians): torque, energy and stiffness for K |A||B| = 1.

    The tutorial's law has the energy of the conservative one, of which it is not the gradient. NaN for an
    unknown law.
    """
    if law == ANGLE:
        return deflection, 0.5 * deflection * deflection, 1.0
    if law in (TUTORIAL, CONSERVATIVE):
        half = math.sin(0.5 * deflection)
        return math.sin(deflection), 2.0 * half * half, math.cos(deflection)
    return np.nan, np.nan, np.nan


SINE_LAWS = (TUTORIAL, CONSERVATIVE, NO_JOINTS)
"""The laws whose torque is the sine of the deflection; and a body without joints."""


@kernel(forceinline=True)
def is_sine(law):
    """Whether a law's torque is the sine of the deflection, or there are no joints."""
    return law in SINE_LAWS


@kernel(fastmath=FAST)
def deflection_at(law, torque, most):
    """The deflection between 0 and `most` (radians) at which a law reaches a torque, for K |A||B| = 1.

    By bisection, from the law's terms. The torque must be passed between 0 and `most`.
    """
    low, high = 0.0, most
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if abs(terms(law, middle)[0]) < torque:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
