"""The inverse of a square root, in less time than a root and a division take."""

from __future__ import annotations

import numpy as np

from .jit import kernel

_ONE = np.float32(1.0)

LEAST = 1e-37
"""Next to the least number that single precision has in full."""


@kernel(inline="always")
def inverse_root(square):
    """1 / sqrt(square) to 3e-16 of it, from 1e-37 to 1e38; below that finite, at most 6e18.

    A processor has one unit for roots and divisions, slow in double precision and twice as quick in single.
    One step of third order (Householder's) takes the 23 good bits of that to all 53, but for the last one. It
    takes longer from beginning to end, though, and so pays only where many are on their way at once.

    It goes by the rules of the kernel that it is inlined into. Under `FAST` the processor may approximate
    the single-precision part in its own way.
    """
    return inverse_root_from_least(max(square, LEAST))


@kernel(inline="always")
def inverse_root_from_least(square):
    """`inverse_root` of what is `LEAST` at least."""
    seed = np.float64(_ONE / np.sqrt(np.float32(square)))
    off = 1.0 - square * seed * seed
    return seed + seed * off * (0.5 + 0.375 * off)
