"""The matrix of an implicit step on a chain, factorised in one pass.

The matrix is a I - g Jv - Jx, with Jx and Jv the derivatives of the accelerations by positions and by
velocities: velocity is eliminated, so there are two unknowns a mass. On a chain it has five diagonals of two
by two blocks; rows are built and eliminated one after the other (block LU without pivoting between blocks).
Row i of `matrix.blocks` then holds L2, L1, the inverse of the pivot D, and D^-1 U1, D^-1 U2.
"""

from __future__ import annotations

from .blocks import inverted, joint_blocks, length_of, minus, plus, spring_block, times
from .jit import FAST, kernel

ROW = 20
"""Numbers in a row."""


@kernel(forceinline=True, fastmath=FAST)
def _scaled_row(w, block):
    return -w * block[0], -w * block[1], -w * block[2], -w * block[3]


@kernel(fastmath=FAST)
def factorise_chain(body, live, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v; false if a pivot is singular."""
    places = q.size // 2
    n, soft = body.masses, body.softening
    blocks = matrix.blocks
    zero = (0.0, 0.0, 0.0, 0.0)
    regular = True
    before = (0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)  # of the spring behind: m, o, p
    to_last, to_own = zero, zero  # of the joint behind: ba, bb
    p1, p2, pp1, pp2 = zero, zero, zero, zero
    vector = (q[2] - q[1], q[places + 2] - q[places + 1])
    rate = (v[2] - v[1], v[places + 2] - v[places + 1])
    length = length_of(vector[0], vector[1], soft)
    for m in range(1, n + 1):
        s = m - 1
        back, own, ahead = zero, zero, zero
        if m < n:
            own = plus(
                spring_block(
                    body.stiffness[s], body.damping[s], live.pull[s], length, vector, rate, g, definite
                ),
                to_own,
            )
            back = to_last
            if m < n - 1 and body.joints:
                next_vector = (q[m + 2] - q[m + 1], q[places + m + 2] - q[places + m + 1])
                next_rate = (v[m + 2] - v[m + 1], v[places + m + 2] - v[places + m + 1])
                next_length = length_of(next_vector[0], next_vector[1], soft)
                aa, ab, to_last, to_own = joint_blocks(
                    body.law,
                    body.couple_size[m],
                    live.couple_cos[m],
                    live.couple_sin[m],
                    live.couple_rest[m],
                    body.couple_damping[m],
                    vector,
                    next_vector,
                    length,
                    next_length,
                    soft,
                    rate,
                    next_rate,
                    g,
                    definite,
                )
                own = plus(own, aa)
                ahead = ab
                vector, rate, length = next_vector, next_rate, next_length
            elif m < n - 1:
                vector = (q[m + 2] - q[m + 1], q[places + m + 2] - q[places + m + 1])
                rate = (v[m + 2] - v[m + 1], v[places + m + 2] - v[places + m + 1])
                length = length_of(vector[0], vector[1], soft)
        last_back, last_own, last_ahead = before
        w = live.inverse_mass[m]
        c1 = minus(last_back, last_own)
        c2 = minus(last_own, last_ahead)
        d1 = minus(back, own)
        d2 = minus(own, ahead)
        lower2 = _scaled_row(-w, last_back)
        lower1 = minus(_scaled_row(w, plus(c1, back)), times(lower2, pp1))
        diagonal = _scaled_row(w, minus(c2, d1))
        drag = 2.0 * live.air[m] * g
        diagonal = (
            diagonal[0] + a + drag * abs(v[m]),
            diagonal[1],
            diagonal[2],
            diagonal[3] + a + drag * abs(v[places + m]),
        )
        diagonal = minus(minus(diagonal, times(lower2, pp2)), times(lower1, p1))
        upper1 = minus(_scaled_row(w, minus(last_ahead, d2)), times(lower1, p2))
        upper2 = _scaled_row(-w, ahead)
        inverse = inverted(diagonal)
        if not abs(inverse[0]) + abs(inverse[1]) + abs(inverse[2]) + abs(inverse[3]) < 1e300:
            regular = False
        pp1, pp2 = p1, p2
        p1, p2 = times(inverse, upper1), times(inverse, upper2)
        row = ROW * m
        for j, block in ((0, lower2), (4, lower1), (8, inverse), (12, p1), (16, p2)):
            blocks[row + j] = block[0]
            blocks[row + j + 1] = block[1]
            blocks[row + j + 2] = block[2]
            blocks[row + j + 3] = block[3]
        before = back, own, ahead
    return regular


@kernel(forceinline=True, fastmath=FAST)
def solve_chain(body, matrix, b):
    """Solve in place; b is flat, x of every place, then y."""
    places = b.size // 2
    n = body.masses
    r = matrix.blocks
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(1, n + 1):
        i = ROW * m
        rx = b[m] - (r[i] * x2 + r[i + 1] * y2) - (r[i + 4] * x1 + r[i + 5] * y1)
        ry = b[places + m] - (r[i + 2] * x2 + r[i + 3] * y2) - (r[i + 6] * x1 + r[i + 7] * y1)
        x2, y2 = x1, y1
        x1, y1 = r[i + 8] * rx + r[i + 9] * ry, r[i + 10] * rx + r[i + 11] * ry
        b[m], b[places + m] = x1, y1
    x1, y1, x2, y2 = 0.0, 0.0, 0.0, 0.0
    for m in range(n, 0, -1):
        i = ROW * m
        rx = b[m] - (r[i + 16] * x2 + r[i + 17] * y2) - (r[i + 12] * x1 + r[i + 13] * y1)
        ry = b[places + m] - (r[i + 18] * x2 + r[i + 19] * y2) - (r[i + 14] * x1 + r[i + 15] * y1)
        x2, y2 = x1, y1
        x1, y1 = rx, ry
        b[m], b[places + m] = rx, ry
