"""A fast inverse square root."""

from __future__ import annotations

import numpy as np

from ..jit import kernel

_ONE = np.float32(1.0)
"""1 in single precision."""

MIN_SQUARE = 1e-37
"""Just above the smallest normal number of single precision, 1.2e-38. Doubled,
`test_inverse_roots_are_right_to_the_last_bit_but_one` fails."""


@kernel(inline="always")
def inverse_root(square):
    """Return 1 / sqrt(square), to a relative 3e-16 from 1e-37 to 1e38; for smaller arguments a finite number
    below 6e18.

    A processor has one unit for roots and divisions, which is slow in double precision and twice as fast in
    single precision. One step of Householder's third-order method improves the 23 accurate bits of single
    precision to all but the last of the 53. Its latency is longer, so it pays off only where many roots are
    computed in parallel.

    The fast-math flags are those of the kernel that it is inlined into. Under `FAST` the processor may
    approximate the single-precision part.
    """
    return inverse_root_from_min(max(square, MIN_SQUARE))


@kernel(inline="always")
def inverse_root_from_min(square):
    """Return `inverse_root` of a number of at least `MIN_SQUARE`."""
    seed = np.float64(_ONE / np.sqrt(np.float32(square)))
    off = 1.0 - square * seed * seed
    return seed + seed * off * (0.5 + 0.375 * off)
