"""LU factors of a chain's matrix, whose rows are eliminated from both ends at once.

Each row waits for the one before it, so that elimination from one end would leave the processor idle most of
the time. Two rows, one from each end, are eliminated together (van der Vorst, "Large tridiagonal and block
tridiagonal linear systems on vector and parallel computers", Parallel Computing 5, 1987), as the two numbers
of a vector.

`Matrix.blocks` holds the factors in pairs of rows: row p, and row n + 1 - p of n, which does not exist for
the first two pairs. In the middle, where rows are left over, the second row of a pair is an empty one. The
two rows that are eliminated last have eliminated rows on both sides.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..core.jit import kernel
from ..core.lanes import whole_eights
from .band import CHUNK, L1, L2, PARTS, U1, U2, D, at, begin, hand_on, part, put, put_empty_row, put_rows
from .blocks import minus, times

_LOWER2, _LOWER1, _INVERSE, _TO1, _TO2 = 0, 8, 16, 24, 32
"""Offsets in a pair of the blocks of its rows. With the pivot D of a row, they are D^-1 L2, D^-1 L1 and D^-1
for forward substitution, and D^-1 U1 and D^-1 U2 for back substitution. A block is four numbers for each of
the two rows, which alternate."""

_PAIR = 40
"""Number of floats in a pair."""
_BEFORE = 2
"""Number of pairs of zeros before the first."""

_REST = 12
"""Number of floats after the last pair: the three blocks that couple the last two rows to those behind
them."""

_SHORT = 8
"""Number of masses below which all rows are eliminated from one end."""

_ORDERED = {"contract", "nsz"}
"""Fast-math flags for sums whose last terms are available last: they keep the order in which they are
written."""

_ZERO = (0.0, 0.0, 0.0, 0.0)
"""The zero block."""


def room_for(masses: int) -> tuple[int, int]:
    """Lengths of `Matrix.blocks` and `Matrix.parts` for a chain."""
    return _PAIR * (_BEFORE + _meeting.py_func(masses)[1] + 2) + _REST, 2 * PARTS


def inverse_pivots(blocks: NDArray[np.float64], masses: int) -> NDArray[np.float64]:
    """(masses, 4) the inverse of the pivot of each row, in order."""
    paired, meet = _meeting.py_func(masses)
    pairs = blocks[_BEFORE * _PAIR : -_REST].reshape(-1, _PAIR)[:, _INVERSE:_TO1].reshape(-1, 4, 2)
    return np.concatenate((pairs[: meet + 2, :, 0], pairs[2:paired, :, 1][::-1]))


@kernel(forceinline=True)
def _meeting(n):
    """(number of pairs with two rows, first of the two rows that are eliminated last)."""
    paired = n // 2 if n >= _SHORT else 0
    return paired, n - max(paired, 2)


@kernel(internal=True, fastmath=_ORDERED)
def factorise_chain(body, state, matrix, q, v, a, g, definite):
    """`implicit.factorise_matrix` of a chain."""
    n, blocks = body.masses, matrix.blocks
    near, far = matrix.parts[:PARTS], matrix.parts[PARTS:]
    begin(near, -2)
    begin(far, CHUNK)
    paired, meet = _meeting(n)
    check = 0.0, 0.0
    for first in range(0, meet + 2, CHUNK):
        count, pairs = min(CHUNK, meet + 2 - first), min(CHUNK, max(paired - first, 0))
        # `np.int64` instead of constants, for which numba would compile separate copies of `put_rows`.
        put_rows(
            body, state, q, v, a, g, definite, first, np.int64(0), whole_eights(count), np.int64(0), near
        )
        if pairs > 0:
            # From this end, the rows are two behind the springs whose derivatives are computed with them.
            start = CHUNK - whole_eights(pairs)
            put_rows(
                body, state, q, v, a, g, definite, n - first - CHUNK, start, np.int64(CHUNK), np.int64(2), far
            )
        if first == 0:
            put_empty_row(far, CHUNK)
            put_empty_row(far, CHUNK + 1)
        for k in range(pairs):
            check = _eliminate(blocks, first + k, near, far, k, check)
        for k in range(pairs, count):
            put_empty_row(far, CHUNK + 1 - k)
            if first + k >= meet:
                _join(blocks, paired, near, k, first + k > meet)
            check = _eliminate(blocks, first + k, near, far, k, check)
        hand_on(near, CHUNK - 2, -2)
        hand_on(far, 0, CHUNK)
    return 0.0 * (check[0] + check[1]) == 0.0


@kernel(forceinline=True, fastmath=_ORDERED)
def _eliminate(blocks, p, near, far, k, check):
    """Eliminate pair p, whose rows are k rows from the ends of the chunks.

    Returns:
        `check` plus the entries of the inverse pivots, which is finite unless a pivot is singular.
    """
    i, o = _index(p), CHUNK + 1 - k
    last, older = i - np.uint64(_PAIR), i - np.uint64(2 * _PAIR)
    # Upper blocks are those towards the middle; in rows of the far end these are below the diagonal.
    lower2 = _beside(part(near, at(L2, k)), part(far, at(U2, o)))
    lower1 = _minus(
        _beside(part(near, at(L1, k)), part(far, at(U1, o))), lower2, _pair(blocks, _of(older, _TO1))
    )
    diagonal = _minus(
        _beside(part(near, at(D, k)), part(far, at(D, o))), lower2, _pair(blocks, _of(older, _TO2))
    )
    diagonal = _minus(diagonal, lower1, _pair(blocks, _of(last, _TO1)))
    upper1 = _minus(
        _beside(part(near, at(U1, k)), part(far, at(L1, o))), lower1, _pair(blocks, _of(last, _TO2))
    )
    upper2 = _beside(part(near, at(U2, k)), part(far, at(L2, o)))
    xx, xy, yx, yy = diagonal
    factor = _quotient((1.0, 1.0), _less_product(_product(xx, yy), xy, yx))
    # The next pair waits for this one, which waits for the division. So little is left to do after that.
    _put_pair(blocks, _of(i, _TO1), _divided(diagonal, factor, upper1))
    _put_pair(blocks, _of(i, _TO2), _divided(diagonal, factor, upper2))
    opposite = _product((-1.0, -1.0), factor)
    inverse = _product(factor, yy), _product(opposite, xy), _product(opposite, yx), _product(factor, xx)
    _put_pair(blocks, _of(i, _INVERSE), inverse)
    _put_pair(blocks, _of(i, _LOWER2), _times(inverse, lower2))
    _put_pair(blocks, _of(i, _LOWER1), _times(inverse, lower1))
    return _sum_of(check, _sum_of(_sum_of(inverse[0], inverse[1]), _sum_of(inverse[2], inverse[3])))


@kernel(forceinline=True, fastmath=_ORDERED)
def _join(blocks, paired, near, k, second):
    """Eliminate, from the first or second of the last two rows, the rows behind it."""
    i, o = _index(paired - 1), _index(paired - 2)
    rest = np.uint64(blocks.size - _REST)
    upper1, upper2, diagonal = part(near, at(U1, k)), part(near, at(U2, k)), part(near, at(D, k))
    if second:
        upper1 = _less(upper1, upper2, _one(blocks, _of(o, _TO1 + 1)))
        diagonal = _less(
            _less(diagonal, upper2, _one(blocks, _of(o, _TO2 + 1))),
            upper1,
            _one(blocks, _of(i, _TO1 + 1)),
        )
        put(near, at(L1, k), _less(part(near, at(L1, k)), upper1, _one(blocks, _of(i, _TO2 + 1))))
        _put_rest(blocks, rest + np.uint64(4), upper1)
        _put_rest(blocks, rest + np.uint64(8), upper2)
        upper1 = _ZERO
    else:
        upper1 = _less(upper1, upper2, _one(blocks, _of(i, _TO1 + 1)))
        diagonal = _less(diagonal, upper2, _one(blocks, _of(i, _TO2 + 1)))
        _put_rest(blocks, rest, upper2)
    put(near, at(D, k), diagonal)
    put(near, at(U1, k), upper1)
    put(near, at(U2, k), _ZERO)


# Arithmetic on pairs of numbers, as tuples, which LLVM turns into vector instructions.


@kernel(forceinline=True, fastmath=_ORDERED)
def _product(a, b):
    """a b."""
    return a[0] * b[0], a[1] * b[1]


@kernel(forceinline=True, fastmath=_ORDERED)
def _quotient(a, b):
    """a / b."""
    return a[0] / b[0], a[1] / b[1]


@kernel(forceinline=True, fastmath=_ORDERED)
def _sum_of(a, b):
    """a + b."""
    return a[0] + b[0], a[1] + b[1]


@kernel(forceinline=True, fastmath=_ORDERED)
def _plus_product(a, b, c):
    """a + b c."""
    return a[0] + b[0] * c[0], a[1] + b[1] * c[1]


@kernel(forceinline=True, fastmath=_ORDERED)
def _less_product(a, b, c):
    """a - b c."""
    return a[0] - b[0] * c[0], a[1] - b[1] * c[1]


@kernel(forceinline=True)
def _index(p):
    """The index of pair p in `Matrix.blocks`."""
    return np.uint64(_PAIR * (p + _BEFORE))


@kernel(inline="always")
def _of(i, kind):
    """The index of a kind of blocks of the pair at index i; inlined for the same reason as `at`."""
    return i + np.uint64(kind)


@kernel(forceinline=True)
def _pair(blocks, j):
    one = np.uint64(1)
    k, m, o = j + np.uint64(2), j + np.uint64(4), j + np.uint64(6)
    return (
        (blocks[j], blocks[j + one]),
        (blocks[k], blocks[k + one]),
        (blocks[m], blocks[m + one]),
        (blocks[o], blocks[o + one]),
    )


@kernel(forceinline=True)
def _put_pair(blocks, j, pair):
    one = np.uint64(1)
    k, m, o = j + np.uint64(2), j + np.uint64(4), j + np.uint64(6)
    blocks[j], blocks[j + one] = pair[0]
    blocks[k], blocks[k + one] = pair[1]
    blocks[m], blocks[m + one] = pair[2]
    blocks[o], blocks[o + one] = pair[3]


@kernel(forceinline=True)
def _one(blocks, j):
    """The block of one row of a pair, whose first number is at index j."""
    return blocks[j], blocks[j + np.uint64(2)], blocks[j + np.uint64(4)], blocks[j + np.uint64(6)]


@kernel(forceinline=True)
def _put_rest(blocks, i, block):
    for k in range(4):
        blocks[i + np.uint64(k)] = block[k]


@kernel(forceinline=True)
def _rest(blocks, k):
    i = np.uint64(blocks.size - _REST + 4 * k)
    return blocks[i], blocks[i + np.uint64(1)], blocks[i + np.uint64(2)], blocks[i + np.uint64(3)]


@kernel(forceinline=True)
def _beside(a, b):
    """Two blocks as one block of pairs."""
    return (a[0], b[0]), (a[1], b[1]), (a[2], b[2]), (a[3], b[3])


@kernel(forceinline=True)
def _minus(a, b, c):
    """a - b c for blocks of pairs."""
    return (
        _less_product(_less_product(a[0], b[0], c[0]), b[1], c[2]),
        _less_product(_less_product(a[1], b[0], c[1]), b[1], c[3]),
        _less_product(_less_product(a[2], b[2], c[0]), b[3], c[2]),
        _less_product(_less_product(a[3], b[2], c[1]), b[3], c[3]),
    )


@kernel(forceinline=True, fastmath=_ORDERED)
def _less(a, b, c):
    """a - b c for blocks."""
    return minus(a, times(b, c))


@kernel(forceinline=True)
def _divided(diagonal, factor, b):
    """The inverse of a block of pairs times another one; `factor` is 1 / its determinant."""
    xx, xy, yx, yy = diagonal
    return (
        _product(factor, _less_product(_product(yy, b[0]), xy, b[2])),
        _product(factor, _less_product(_product(yy, b[1]), xy, b[3])),
        _product(factor, _less_product(_product(xx, b[2]), yx, b[0])),
        _product(factor, _less_product(_product(xx, b[3]), yx, b[1])),
    )


@kernel(forceinline=True)
def _times(a, b):
    """a b for blocks of pairs."""
    return (
        _plus_product(_product(a[0], b[0]), a[1], b[2]),
        _plus_product(_product(a[0], b[1]), a[1], b[3]),
        _plus_product(_product(a[2], b[0]), a[3], b[2]),
        _plus_product(_product(a[2], b[1]), a[3], b[3]),
    )


@kernel(noalias=True, forceinline=True, fastmath=_ORDERED)
def solve_chain(body, matrix, b):
    """`implicit.solve_matrix` of a chain."""
    n, r = body.masses, matrix.blocks
    x, y = b[: b.size // 2], b[b.size // 2 :]
    paired, meet = _meeting(n)
    alone = min(2, paired)
    near, far = _ZERO, _ZERO  # the last two results, from both ends
    for p in range(alone):
        near = _forwards(r, p, 0, x, y, p + 1, near)
    for p in range(alone, paired):
        near = _forwards(r, p, 0, x, y, p + 1, near)
        far = _forwards(r, p, 1, x, y, n + 2 - p, far)
    x[meet + 1], y[meet + 1] = _taken(x[meet + 1], y[meet + 1], _rest(r, 0), far[0], far[1])
    x1, y1 = _taken(x[meet + 2], y[meet + 2], _rest(r, 2), far[2], far[3])
    x[meet + 2], y[meet + 2] = _taken(x1, y1, _rest(r, 1), far[0], far[1])
    for p in range(paired, meet + 2):
        near = _forwards(r, p, 0, x, y, p + 1, near)
    near = _ZERO
    for p in range(meet + 1, paired - 1, -1):
        near = _backwards(r, p, 0, x, y, p + 1, near)
    far = x[meet + 2], y[meet + 2], x[meet + 1], y[meet + 1]
    for p in range(paired - 1, alone - 1, -1):
        near = _backwards(r, p, 0, x, y, p + 1, near)
        far = _backwards(r, p, 1, x, y, n + 2 - p, far)
    for p in range(alone - 1, -1, -1):
        near = _backwards(r, p, 0, x, y, p + 1, near)


@kernel(forceinline=True, fastmath=_ORDERED)
def _forwards(r, p, lane, x, y, m, last):
    m, i = np.uint64(m), _index(p)
    x1, y1, x2, y2 = last
    inverse = _one(r, _of(i, _INVERSE + lane))
    to_x, to_y = inverse[0] * x[m] + inverse[1] * y[m], inverse[2] * x[m] + inverse[3] * y[m]
    to_x, to_y = _taken(to_x, to_y, _one(r, _of(i, _LOWER2 + lane)), x2, y2)
    to_x, to_y = _taken(to_x, to_y, _one(r, _of(i, _LOWER1 + lane)), x1, y1)
    x[m], y[m] = to_x, to_y
    return to_x, to_y, x1, y1


@kernel(forceinline=True, fastmath=_ORDERED)
def _backwards(r, p, lane, x, y, m, last):
    m, i = np.uint64(m), _index(p)
    x1, y1, x2, y2 = last
    to_x, to_y = _taken(x[m], y[m], _one(r, _of(i, _TO2 + lane)), x2, y2)
    to_x, to_y = _taken(to_x, to_y, _one(r, _of(i, _TO1 + lane)), x1, y1)
    x[m], y[m] = to_x, to_y
    return to_x, to_y, x1, y1


@kernel(forceinline=True, fastmath=_ORDERED)
def _taken(x, y, block, x1, y1):
    """(x, y) minus a block times (x1, y1)."""
    return x - block[0] * x1 - block[1] * y1, y - block[2] * x1 - block[3] * y1
