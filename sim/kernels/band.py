"""The matrix of an implicit step on a chain, factorised in one pass.

The matrix is a I - g Jv - Jx, with Jx and Jv the derivatives of the accelerations by positions and by
velocities: velocity is eliminated, so there are two unknowns a mass. On a chain it has five diagonals of two
by two blocks; rows are built and eliminated one after the other (block LU without pivoting between blocks).
Row i of `matrix.blocks` then holds D^-1 L2, D^-1 L1, D^-1, D^-1 U1 and D^-1 U2, with D the pivot.

The derivatives of the forces take more arithmetic than the elimination does. Springs do not wait for each
other there, so they are done eight at a time, in loops that are vectorised.
"""

from __future__ import annotations

import numpy as np

from .blocks import joint_blocks, length_of, minus, plus, scaled, spring_block, times
from .jit import FAST, kernel
from .tables import ANGLE, CONSERVATIVE, TUTORIAL

ROW = 20
"""Numbers in a row."""

_LANES = 8
_OWN, _AA, _AB, _BA, _BB, _KINDS = 0, 4, 8, 12, 16, 20
"""The derivatives of the tension of a spring by its own vector; those that the joint between it and the next
spring adds, as `joint_blocks` names them; and how many numbers these are."""

PARTS = _KINDS * _LANES
"""Numbers in `Matrix.parts`: of each kind of derivative in turn, those of eight springs side by side."""

_ZERO = (0.0, 0.0, 0.0, 0.0)


@kernel(inner=True, fastmath=FAST)
def factorise_chain(body, live, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v; false if a pivot is singular."""
    places, n = q.size // 2, body.masses
    parts = matrix.parts
    rows = _ZERO, _ZERO, _ZERO, _ZERO  # of the last row: D^-1 U1 and D^-1 U2; and of the one before it
    before = _ZERO, _ZERO, _ZERO  # by the vectors of the spring before, of its own and of the next: a tension
    to_last, to_own = _ZERO, _ZERO  # ba and bb of the joint behind
    regular = True
    for first in range(0, n - 1, _LANES):
        _derive_springs(body, live, q, v, g, definite, first, parts)
        if body.joints:
            if definite:
                _derive_joints(body, live, q, v, g, CONSERVATIVE, True, True, first, parts)
            elif body.law == TUTORIAL and not body.twisted:
                _derive_joints(body, live, q, v, g, TUTORIAL, False, False, first, parts)
            elif body.law == CONSERVATIVE and not body.twisted:
                _derive_joints(body, live, q, v, g, CONSERVATIVE, False, False, first, parts)
            else:
                _derive_joints(body, live, q, v, g, body.law, True, False, first, parts)
        for k in range(min(_LANES, n - 1 - first)):
            m = first + k + 1
            own = plus(plus(_part(parts, _OWN, k), to_own), _part(parts, _AA, k))
            present = to_last, own, _part(parts, _AB, k)
            rows, good = _eliminate(live, matrix, m, places, v, a, g, before, present, rows)
            regular = regular and good
            before = present
            to_last, to_own = _part(parts, _BA, k), _part(parts, _BB, k)
    rows, good = _eliminate(live, matrix, n, places, v, a, g, before, (_ZERO, _ZERO, _ZERO), rows)
    return regular and good


@kernel(forceinline=True, fastmath=FAST)
def _derive_springs(body, live, q, v, g, definite, first, parts):
    for k in range(parts.size // _KINDS):
        s = np.uint64(first + k)  # unsigned indices need no test for counting from the end
        vector, rate = _between(q, s), _between(v, s)
        length = length_of(vector[0], vector[1], body.softening)
        block = spring_block(
            body.stiffness[s], body.damping[s], live.pull[s], length, vector, rate, g, definite
        )
        _put(parts, _OWN, k, block)


@kernel(forceinline=True, fastmath=FAST)
def _derive_joints(body, live, q, v, g, law, twisted, definite, first, parts):
    """The law, whether joints have damping, and `definite`, are constants where it is called: a loop each."""
    soft = body.softening
    for k in range(parts.size // _KINDS):
        s, place = np.uint64(first + k), np.uint64(first + k + 1)
        vector, after = _between(q, s), _between(q, place)
        rate, rate_after, damping, rest = (0.0, 0.0), (0.0, 0.0), 0.0, 0.0
        if twisted:
            rate, rate_after, damping = _between(v, s), _between(v, place), body.couple_damping[place]
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
def _between(values, s):
    """The difference of flat values between the ends of spring s."""
    y = np.uint64(values.size // 2) + s
    return (
        values[s + np.uint64(2)] - values[s + np.uint64(1)],
        values[y + np.uint64(2)] - values[y + np.uint64(1)],
    )


@kernel(forceinline=True, fastmath=FAST)
def _put(parts, kind, k, block):
    parts[_LANES * kind + k] = block[0]
    parts[_LANES * (kind + 1) + k] = block[1]
    parts[_LANES * (kind + 2) + k] = block[2]
    parts[_LANES * (kind + 3) + k] = block[3]


@kernel(forceinline=True, fastmath=FAST)
def _part(parts, kind, k):
    return (
        parts[_LANES * kind + k],
        parts[_LANES * (kind + 1) + k],
        parts[_LANES * (kind + 2) + k],
        parts[_LANES * (kind + 3) + k],
    )


@kernel(forceinline=True, fastmath=FAST)
def _eliminate(live, matrix, m, places, v, a, g, before, present, rows):
    """Build the row of mass m from how the springs behind and ahead of it answer, and eliminate."""
    last_back, last_own, last_ahead = before
    back, own, ahead = present
    p1, p2, pp1, pp2 = rows
    w = live.inverse_mass[m]
    c1 = minus(last_back, last_own)
    c2 = minus(last_own, last_ahead)
    d1 = minus(back, own)
    d2 = minus(own, ahead)
    lower2 = scaled(w, last_back)
    lower1 = minus(scaled(-w, plus(c1, back)), times(lower2, pp1))
    diagonal = scaled(-w, minus(c2, d1))
    drag = 2.0 * live.air[m] * g
    diagonal = (
        diagonal[0] + a + drag * abs(v[m]),
        diagonal[1],
        diagonal[2],
        diagonal[3] + a + drag * abs(v[places + m]),
    )
    diagonal = minus(minus(diagonal, times(lower2, pp2)), times(lower1, p1))
    upper1 = minus(scaled(-w, minus(last_ahead, d2)), times(lower1, p2))
    upper2 = scaled(w, ahead)
    # What waits for the division is as little as can be: the next row waits for this one.
    adjoint = (diagonal[3], -diagonal[1], -diagonal[2], diagonal[0])
    factor = 1.0 / (diagonal[0] * diagonal[3] - diagonal[1] * diagonal[2])
    inverse = scaled(factor, adjoint)
    good = abs(inverse[0]) + abs(inverse[1]) + abs(inverse[2]) + abs(inverse[3]) < 1e300
    to1, to2 = scaled(factor, times(adjoint, upper1)), scaled(factor, times(adjoint, upper2))
    row, blocks = ROW * m, matrix.blocks
    for j, block in (
        (0, times(inverse, lower2)),
        (4, times(inverse, lower1)),
        (8, inverse),
        (12, to1),
        (16, to2),
    ):
        blocks[row + j] = block[0]
        blocks[row + j + 1] = block[1]
        blocks[row + j + 2] = block[2]
        blocks[row + j + 3] = block[3]
    return (to1, to2, p1, p2), good


@kernel(forceinline=True, fastmath=FAST)
def solve_chain(body, matrix, b):
    """Solve in place; b is flat, x of every place, then y."""
    places = b.size // 2
    n = body.masses
    r = matrix.blocks
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(1, n + 1):
        i = ROW * m
        x, y = r[i + 8] * b[m] + r[i + 9] * b[places + m], r[i + 10] * b[m] + r[i + 11] * b[places + m]
        x -= r[i] * x2 + r[i + 1] * y2
        y -= r[i + 2] * x2 + r[i + 3] * y2
        x2, y2 = x1, y1
        x1, y1 = x - (r[i + 4] * x1 + r[i + 5] * y1), y - (r[i + 6] * x1 + r[i + 7] * y1)
        b[m], b[places + m] = x1, y1
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(n, 0, -1):
        i = ROW * m
        rx = b[m] - (r[i + 16] * x2 + r[i + 17] * y2) - (r[i + 12] * x1 + r[i + 13] * y1)
        ry = b[places + m] - (r[i + 18] * x2 + r[i + 19] * y2) - (r[i + 14] * x1 + r[i + 15] * y1)
        x2, y2 = x1, y1
        x1, y1 = rx, ry
        b[m], b[places + m] = rx, ry
