"""The matrix of an implicit step on a chain, factorised in one pass.

The matrix is a I - g Jv - Jx, with Jx and Jv the derivatives of the accelerations by positions and by
velocities: velocity is eliminated, so there are two unknowns a mass. On a chain it has five diagonals of two
by two blocks, and is factorised without pivoting between blocks. `matrix.blocks` then holds D^-1 L2, D^-1 L1
and D^-1 of every row, with D the pivot, which is what solving forwards reads, and after those of all rows
D^-1 U1 and D^-1 U2, for solving backwards.

Rows have to be eliminated one after the other. All that comes before, the derivatives of the forces and the
rows that follow from them, is done for many springs at a time, in loops that are vectorised.
"""

from __future__ import annotations

import numpy as np

from .blocks import from_to, joint_blocks, length_of, minus, plus, scaled, spring_block, times
from .jit import FAST, kernel
from .tables import ANGLE, CONSERVATIVE, TUTORIAL

LOWER, UPPER = 12, 8
"""Numbers of each row in `Matrix.blocks` that belong to its lower and to its upper part."""

_CHUNK, _VECTOR = 16, 8
"""Springs whose derivatives are taken before their rows are eliminated, and how many of them are a vector."""
_STRIDE = _VECTOR + _CHUNK
"""Of each kind of number there is room for a chunk, and before it for the end of the chunk before."""

_OWN, _AA, _AB, _BA, _BB, _KINDS = 0, 4, 8, 12, 16, 20
"""The derivatives of the tension of a spring by its own vector; those that the joint between it and the next
spring adds, as `joint_blocks` names them; and how many numbers these are."""
_L2, _L1, _D, _U1, _U2, _ALL = 44, 48, 52, 56, 60, 64
"""The five blocks of the row of the mass that each spring begins at. They are 4 kB from what they are built
from: LLVM does not vectorise a loop that might load, a little later, parts of what it stored."""

PARTS = _ALL * _STRIDE
"""Numbers in `Matrix.parts`: of each kind in turn, those of all springs of a chunk side by side."""

_ZERO = (0.0, 0.0, 0.0, 0.0)

_ORDERED = {"contract", "nsz"}
"""For sums that wait for what their last terms hold: those are added last, as written."""


@kernel(inner=True, fastmath=FAST)
def factorise_chain(body, live, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v; false if a pivot is singular."""
    n, parts = body.masses, matrix.parts
    for kind in range(_KINDS):
        _hand_on(parts, kind, 0.0, 0.0)
    rows = _ZERO, _ZERO, _ZERO, _ZERO  # of the last row: D^-1 U1 and D^-1 U2; and of the one before it
    check = 0.0
    for first in range(0, n, _CHUNK):
        springs = min(_CHUNK, (n - 2 - first + _VECTOR) // _VECTOR * _VECTOR)
        _derive_springs(body, live, q, v, g, definite, first, springs, parts)
        if body.joints:
            if definite:
                _derive_joints(body, live, q, v, g, CONSERVATIVE, True, True, first, springs, parts)
            elif body.law == TUTORIAL and not body.twisted:
                _derive_joints(body, live, q, v, g, TUTORIAL, False, False, first, springs, parts)
            elif body.law == CONSERVATIVE and not body.twisted:
                _derive_joints(body, live, q, v, g, CONSERVATIVE, False, False, first, springs, parts)
            else:
                _derive_joints(body, live, q, v, g, body.law, True, False, first, springs, parts)
        # There is no spring n - 1, nor a joint before it.
        for s in range(max(n - 2, first), min(n, first + _CHUNK)):
            for kind in range(_AA if s == n - 2 else _OWN, _KINDS):
                parts[_at(kind, s - first)] = 0.0
        count = min(_CHUNK, n - first)
        _build_rows(live, v, a, g, first, (count + _VECTOR - 1) // _VECTOR * _VECTOR, parts)
        for k in range(count):
            rows, size = _eliminate(matrix, first + 1 + k, k, rows)
            check += 0.0 * size  # infinities become NaN
        if first + _CHUNK < n:
            for kind in range(_KINDS):
                _hand_on(parts, kind, parts[_at(kind, _CHUNK - 2)], parts[_at(kind, _CHUNK - 1)])
    return check == 0.0


@kernel(forceinline=True)
def _at(kind, k):
    """Where `Matrix.parts` has a number of the chunk's spring k; -1 and -2 are of the chunk before."""
    return np.uint64(_STRIDE * kind + _VECTOR + k)


@kernel(forceinline=True)
def _hand_on(parts, kind, last_but_one, last):
    parts[_at(kind, -2)], parts[_at(kind, -1)] = last_but_one, last


@kernel(forceinline=True, fastmath=FAST)
def _derive_springs(body, live, q, v, g, definite, first, springs, parts):
    for k in range(springs):
        s = np.uint64(first + k)
        one, other = first + k + 1, first + k + 2
        vector, rate = from_to(q, one, other), from_to(v, one, other)
        length = length_of(vector[0], vector[1], body.softening)
        block = spring_block(
            body.stiffness[s], body.damping[s], live.pull[s], length, vector, rate, g, definite
        )
        _put(parts, _OWN, k, block)


@kernel(forceinline=True, fastmath=FAST)
def _derive_joints(body, live, q, v, g, law, twisted, definite, first, springs, parts):
    """The law, whether joints have damping, and `definite`, are constants where it is called: a loop each."""
    soft = body.softening
    for k in range(springs):
        place, other, third = np.uint64(first + k + 1), first + k + 2, first + k + 3
        vector, after = from_to(q, place, other), from_to(q, other, third)
        rate, rate_after, damping, rest = (0.0, 0.0), (0.0, 0.0), 0.0, 0.0
        if twisted:
            rate, rate_after = from_to(v, place, other), from_to(v, other, third)
            damping = body.couple_damping[place]
        if law == ANGLE:
            rest = live.couple_rest[place]
        aa, ab, ba, bb = joint_blocks(
            law,
            body.couple_size[place],
            live.couple_cos[place],
            live.couple_sin[place],
            rest,
            damping,
            vector,
            after,
            length_of(vector[0], vector[1], soft),
            length_of(after[0], after[1], soft),
            soft,
            rate,
            rate_after,
            g,
            definite,
        )
        _put(parts, _AA, k, aa)
        _put(parts, _AB, k, ab)
        _put(parts, _BA, k, ba)
        _put(parts, _BB, k, bb)


@kernel(forceinline=True, fastmath=FAST)
def _put(parts, kind, k, block):
    parts[_at(kind, k)] = block[0]
    parts[_at(kind + 1, k)] = block[1]
    parts[_at(kind + 2, k)] = block[2]
    parts[_at(kind + 3, k)] = block[3]


@kernel(forceinline=True, fastmath=FAST)
def _part(parts, kind, k):
    return parts[_at(kind, k)], parts[_at(kind + 1, k)], parts[_at(kind + 2, k)], parts[_at(kind + 3, k)]


@kernel(forceinline=True, fastmath=FAST)
def _build_rows(live, v, a, g, first, count, parts):
    """From how each spring answers to its own vector and to those of the two beside it."""
    places = v.size // 2
    for k in range(count):
        m = np.uint64(first + k + 1)
        w, drag = live.inverse_mass[m], 2.0 * live.air[m] * g
        last_back, back = _part(parts, _BA, k - 2), _part(parts, _BA, k - 1)
        last_ahead, ahead = _part(parts, _AB, k - 1), _part(parts, _AB, k)
        last_own, own = _whole(parts, k - 1), _whole(parts, k)
        diagonal = scaled(-w, minus(plus(last_own, own), plus(last_ahead, back)))
        diagonal = (
            diagonal[0] + a + drag * abs(v[m]),
            diagonal[1],
            diagonal[2],
            diagonal[3] + a + drag * abs(v[np.uint64(places) + m]),
        )
        _put(parts, _L2, k, scaled(w, last_back))
        _put(parts, _L1, k, scaled(w, minus(last_own, plus(last_back, back))))
        _put(parts, _D, k, diagonal)
        _put(parts, _U1, k, scaled(w, minus(own, plus(last_ahead, ahead))))
        _put(parts, _U2, k, scaled(w, ahead))


@kernel(forceinline=True, fastmath=FAST)
def _whole(parts, k):
    """How a spring answers to its own vector, with what the joints at both its ends add."""
    return plus(_part(parts, _OWN, k), plus(_part(parts, _AA, k), _part(parts, _BB, k - 1)))


@kernel(forceinline=True, fastmath=FAST)
def _eliminate(matrix, m, k, rows):
    """Eliminate from the row of mass m, the chunk's k-th, the masses before it; also some size of D^-1."""
    parts, blocks = matrix.parts, matrix.blocks
    p1, p2, pp1, pp2 = rows
    lower2 = _part(parts, _L2, k)
    lower1 = minus(_part(parts, _L1, k), times(lower2, pp1))
    diagonal = minus(minus(_part(parts, _D, k), times(lower2, pp2)), times(lower1, p1))
    upper1 = minus(_part(parts, _U1, k), times(lower1, p2))
    upper2 = _part(parts, _U2, k)
    # What waits for the division is as little as can be: the next row waits for this one.
    adjoint = (diagonal[3], -diagonal[1], -diagonal[2], diagonal[0])
    factor = 1.0 / (diagonal[0] * diagonal[3] - diagonal[1] * diagonal[2])
    inverse = scaled(factor, adjoint)
    to1, to2 = scaled(factor, times(adjoint, upper1)), scaled(factor, times(adjoint, upper2))
    row = np.uint64(LOWER * m)
    _store(blocks, row, times(inverse, lower2))
    _store(blocks, row + 4, times(inverse, lower1))
    _store(blocks, row + 8, inverse)
    row = np.uint64(_upper(blocks) + UPPER * m)
    _store(blocks, row, to1)
    _store(blocks, row + 4, to2)
    return (to1, to2, p1, p2), inverse[0] + inverse[1] + inverse[2] + inverse[3]


@kernel(forceinline=True)
def _upper(blocks):
    """Where the upper parts of the rows begin."""
    return blocks.size // (LOWER + UPPER) * LOWER


@kernel(forceinline=True, fastmath=FAST)
def _store(blocks, i, block):
    blocks[i] = block[0]
    blocks[i + np.uint64(1)] = block[1]
    blocks[i + np.uint64(2)] = block[2]
    blocks[i + np.uint64(3)] = block[3]


@kernel(apart=True, forceinline=True, fastmath=_ORDERED)
def solve_chain(body, matrix, b):
    """Solve in place; b is flat, x of every place, then y."""
    places = b.size // 2
    n = body.masses
    r = matrix.blocks
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(1, n + 1):
        i = LOWER * m
        x, y = r[i + 8] * b[m] + r[i + 9] * b[places + m], r[i + 10] * b[m] + r[i + 11] * b[places + m]
        x = x - r[i] * x2 - r[i + 1] * y2
        y = y - r[i + 2] * x2 - r[i + 3] * y2
        x2, y2 = x1, y1
        x1, y1 = x - r[i + 4] * x1 - r[i + 5] * y1, y - r[i + 6] * x1 - r[i + 7] * y1
        b[m], b[places + m] = x1, y1
    upper = _upper(r)
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(n, 0, -1):
        i = upper + UPPER * m
        rx = b[m] - r[i + 4] * x2 - r[i + 5] * y2 - r[i] * x1 - r[i + 1] * y1
        ry = b[places + m] - r[i + 6] * x2 - r[i + 7] * y2 - r[i + 2] * x1 - r[i + 3] * y1
        x2, y2 = x1, y1
        x1, y1 = rx, ry
        b[m], b[places + m] = rx, ry
