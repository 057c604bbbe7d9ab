"""Vectorised angles."""

from __future__ import annotations

import math

from ..jit import FUSED, kernel

_EIGHTH = math.tan(math.pi / 8.0)
"""The largest tangent for which the series below is short."""


@kernel(forceinline=True, fastmath=FUSED)
def angle_of(x, y):
    """Return the angle of a vector, atan2(y, x), to 5e-16; 0 for a zero vector.

    There are no branches and no calls, so loops of it are vectorised. The vector is mirrored into the first
    eighth of a turn and, from the middle of that, rotated back by an eighth. The tangent of the remaining
    angle is at most tan(pi/8), where twenty terms of the Taylor series leave 1e-17.
    """
    width, height = abs(x), abs(y)
    flat = height <= width  # not NaN either
    less, more = (height, width) if flat else (width, height)
    more = 1e-300 if more < 1e-300 else more
    beyond = less > _EIGHTH * more
    t = (less - more if beyond else less) / (less + more if beyond else more)
    s = t * t
    # By Horner's rule.
    series = 1.0 / 39.0
    series = 1.0 / 37.0 - s * series
    series = 1.0 / 35.0 - s * series
    series = 1.0 / 33.0 - s * series
    series = 1.0 / 31.0 - s * series
    series = 1.0 / 29.0 - s * series
    series = 1.0 / 27.0 - s * series
    series = 1.0 / 25.0 - s * series
    series = 1.0 / 23.0 - s * series
    series = 1.0 / 21.0 - s * series
    series = 1.0 / 19.0 - s * series
    series = 1.0 / 17.0 - s * series
    series = 1.0 / 15.0 - s * series
    series = 1.0 / 13.0 - s * series
    series = 1.0 / 11.0 - s * series
    series = 1.0 / 9.0 - s * series
    series = 1.0 / 7.0 - s * series
    series = 1.0 / 5.0 - s * series
    series = 1.0 / 3.0 - s * series
    angle = (0.25 * math.pi if beyond else 0.0) + (t - t * s * series)
    angle = angle if flat else 0.5 * math.pi - angle
    return math.copysign(math.pi - angle if x < 0.0 else angle, y)
