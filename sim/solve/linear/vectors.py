"""Sums over flat vectors that skip the padding.

A solution that overflows must not leave a NaN in a slot without a mass, where nothing would overwrite it.
"""

from __future__ import annotations

from ...engine.jit import FAST, kernel


@kernel(forceinline=True, fastmath=FAST)
def dot(masses, one, other):
    """Return the scalar product of two flat vectors."""
    slots, total = one.size // 2, 0.0
    for i in range(1, masses + 1):
        total += one[i] * other[i]
    for j in range(slots + 1, slots + masses + 1):
        total += one[j] * other[j]
    return total


@kernel(forceinline=True, fastmath=FAST)
def add_multiple(masses, factor, vector, out):
    """Compute out += factor * vector."""
    slots = out.size // 2
    for i in range(1, masses + 1):
        out[i] += factor * vector[i]
    for j in range(slots + 1, slots + masses + 1):
        out[j] += factor * vector[j]
