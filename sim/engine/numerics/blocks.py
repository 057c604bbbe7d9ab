"""2×2 blocks of matrices: tuples (xx, xy, yx, yy)."""

from __future__ import annotations

from ..jit import FAST, kernel


@kernel(forceinline=True, fastmath=FAST)
def times(a, b):
    """Return the product of two blocks."""
    return (
        a[0] * b[0] + a[1] * b[2],
        a[0] * b[1] + a[1] * b[3],
        a[2] * b[0] + a[3] * b[2],
        a[2] * b[1] + a[3] * b[3],
    )


@kernel(forceinline=True, fastmath=FAST)
def minus(a, b):
    """Return the difference of two blocks."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]


@kernel(forceinline=True, fastmath=FAST)
def plus(a, b):
    """Return the sum of two blocks."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]


@kernel(forceinline=True, fastmath=FAST)
def inverted(a):
    """Return the inverse of a block; infinities if it is singular."""
    factor = 1.0 / (a[0] * a[3] - a[1] * a[2])
    return a[3] * factor, -a[1] * factor, -a[2] * factor, a[0] * factor


@kernel(forceinline=True, fastmath=FAST)
def outer(factor, a, b):
    """Return factor a bᵀ, for two vectors."""
    x, y = factor * a[0], factor * a[1]
    return x * b[0], x * b[1], y * b[0], y * b[1]


@kernel(forceinline=True, fastmath=FAST)
def from_left(vector, block):
    """Return vectorᵀ block."""
    return vector[0] * block[0] + vector[1] * block[2], vector[0] * block[1] + vector[1] * block[3]


@kernel(forceinline=True, fastmath=FAST)
def scaled(factor, block):
    """Return a block times a number."""
    return factor * block[0], factor * block[1], factor * block[2], factor * block[3]


@kernel(forceinline=True, fastmath=FAST)
def add_block(blocks, target, sign, block):
    """Add a block, times a sign, to block number `target` of a flat array of blocks."""
    i = 4 * target
    blocks[i] += sign * block[0]
    blocks[i + 1] += sign * block[1]
    blocks[i + 2] += sign * block[2]
    blocks[i + 3] += sign * block[3]
