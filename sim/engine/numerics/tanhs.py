"""Vectorised hyperbolic tangents."""

from __future__ import annotations

import math

from ..bits import bits, from_bits
from ..jit import FUSED, kernel

_LN2_HIGH, _LN2_LOW = float.fromhex("0x1.62e42feep-1"), float.fromhex("0x1.a39ef35793c76p-33")
"""The logarithm of 2 in two parts. The first ends with many zeros, so that its multiples are exact."""

_SHIFT = 1.5 * 2.0**52
"""A float of this size has no fractional digits, so the last bits of its pattern are an integer."""

_ONE = 20.0
"""Argument from which the hyperbolic tangent is 1 in double precision. Halved,
`test_hyperbolic_tangents_are_right_to_the_last_digits` fails."""


@kernel(forceinline=True, fastmath=FUSED)
def tanh(x):
    """Return tanh(x), to a relative error of 1e-15.

    There are no branches and no calls, so loops of it are vectorised. With y = 2 |x| = n ln 2 + r, where |r|
    is at most ln 2 / 2, the result is e / (e + 2) with e = exp(y) - 1 = 2ⁿ (exp(r) - 1) + 2ⁿ - 1. Fourteen
    terms of the Taylor series leave 1e-17 of exp(r) - 1.
    """
    size = abs(x)
    y = 2.0 * (_ONE if size > _ONE else size)
    shifted = y * (1.0 / math.log(2.0)) + _SHIFT
    n = shifted - _SHIFT
    power = from_bits((bits(shifted) + 1023) << 52)  # 2ⁿ
    r = y - n * _LN2_HIGH - n * _LN2_LOW
    # By Horner's rule.
    series = 1.0 + r * (1.0 / 14.0)
    series = 1.0 + r * (1.0 / 13.0) * series
    series = 1.0 + r * (1.0 / 12.0) * series
    series = 1.0 + r * (1.0 / 11.0) * series
    series = 1.0 + r * (1.0 / 10.0) * series
    series = 1.0 + r * (1.0 / 9.0) * series
    series = 1.0 + r * (1.0 / 8.0) * series
    series = 1.0 + r * (1.0 / 7.0) * series
    series = 1.0 + r * (1.0 / 6.0) * series
    series = 1.0 + r * (1.0 / 5.0) * series
    series = 1.0 + r * (1.0 / 4.0) * series
    series = 1.0 + r * (1.0 / 3.0) * series
    series = 1.0 + r * (1.0 / 2.0) * series
    e = power * (r * series) + (power - 1.0)
    return math.copysign(e / (e + 2.0), x)
