"""Vectors between masses, their lengths, and the angles between them."""

from __future__ import annotations

import math

import numpy as np

from ..jit import FAST, kernel
from .angles import angle_of


@kernel(forceinline=True, fastmath=FAST)
def from_to(flat, a, b):
    """Return the difference of a flat vector between slots a and b: for positions, the vector from a to b."""
    # With unsigned indices numba omits its test for negative ones, which count from the end.
    y, a, b = np.uint64(flat.size // 2), np.uint64(a), np.uint64(b)
    return flat[b] - flat[a], flat[y + b] - flat[y + a]


@kernel(forceinline=True, fastmath=FAST)
def length_of(x, y, softening):
    """Return the length of a spring's vector, never quite zero."""
    return math.sqrt(x * x + y * y + softening)


@kernel(forceinline=True, fastmath=FAST)
def inverse_of(x, y, softening):
    """Return 1 / the length of a spring's vector."""
    return 1.0 / length_of(x, y, softening)


@kernel(forceinline=True, fastmath=FAST)
def deflection(cross, dot, rest):
    """Return angle minus rest angle, wrapped into [-pi, pi], from the products of the springs."""
    off = angle_of(dot, cross) - rest
    off = off - 2.0 * math.pi if off > math.pi else off
    return off + 2.0 * math.pi if off < -math.pi else off
