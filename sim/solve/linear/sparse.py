"""The matrix of an implicit step for any topology: block-sparse LU with a precomputed pattern.

`sim.model.sparsity` finds an elimination order with little fill-in, and the pattern of the blocks. Rows are
stored consecutively in that order, with ascending columns. Here they are filled and eliminated row by row.
"""

from __future__ import annotations

import numpy as np

from ...engine.jit import FAST, kernel
from ...engine.numerics.blocks import inverted
from ...forces.all import add_derivatives
from ...forces.plasticity import add_yielding_derivatives, yield_at
from ...forces.rails import keep_row_on_rail


@kernel(fastmath=FAST)
def assemble(body, state, matrix, q, v, g, definite):
    """Fill the pattern with the derivatives of all forces, kg/s², except the friction of still air under the
    tutorial's law.

    These are derivatives with respect to positions, plus g times those with respect to velocities; see
    `forces.term.Term.add_derivatives`.
    """
    for i in range(matrix.blocks.size):
        matrix.blocks[i] = 0.0
    if body.limits.present:
        yield_at(body, state, q)
    add_derivatives(body, state, matrix, q, v, g, definite)
    if body.limits.present and not definite:
        add_yielding_derivatives(body, state, matrix, q, v)


@kernel(internal=True, fastmath=FAST)
def eliminate(body, state, matrix, v, a, g):
    """Turn the assembled force derivatives into the matrix and factorise it."""
    slots = v.size // 2
    blocks, start, column, diagonal = matrix.blocks, matrix.row_start, matrix.column, matrix.diagonal
    slot = matrix.slot
    regular = True
    for i in range(body.masses):
        m = matrix.order[i]
        w = -state.inverse_mass[m]
        drag = 2.0 * state.air[m] * g
        for p in range(start[i], start[i + 1]):
            slot[column[p]] = p
        for p in range(4 * start[i], 4 * start[i + 1]):
            blocks[p] *= w
        d, drag_x, drag_y = 4 * diagonal[i], drag * abs(v[m]), drag * abs(v[slots + m])
        if not keep_row_on_rail(body, blocks, m, start[i], start[i + 1], diagonal[i], a, drag_x, drag_y):
            blocks[d] += a + drag_x
            blocks[d + 3] += a + drag_y
        for p in range(start[i], diagonal[i]):
            k = column[p]
            e = 4 * diagonal[k]
            o = 4 * p
            l0 = blocks[o] * blocks[e] + blocks[o + 1] * blocks[e + 2]
            l1 = blocks[o] * blocks[e + 1] + blocks[o + 1] * blocks[e + 3]
            l2 = blocks[o + 2] * blocks[e] + blocks[o + 3] * blocks[e + 2]
            l3 = blocks[o + 2] * blocks[e + 1] + blocks[o + 3] * blocks[e + 3]
            blocks[o], blocks[o + 1], blocks[o + 2], blocks[o + 3] = l0, l1, l2, l3
            for u in range(diagonal[k] + 1, start[k + 1]):
                t = 4 * slot[np.uint64(column[u])]
                c = 4 * u
                blocks[t] -= l0 * blocks[c] + l1 * blocks[c + 2]
                blocks[t + 1] -= l0 * blocks[c + 1] + l1 * blocks[c + 3]
                blocks[t + 2] -= l2 * blocks[c] + l3 * blocks[c + 2]
                blocks[t + 3] -= l2 * blocks[c + 1] + l3 * blocks[c + 3]
        inverse = inverted((blocks[d], blocks[d + 1], blocks[d + 2], blocks[d + 3]))
        blocks[d], blocks[d + 1], blocks[d + 2], blocks[d + 3] = inverse
        if not abs(inverse[0]) + abs(inverse[1]) + abs(inverse[2]) + abs(inverse[3]) < 1e300:
            regular = False
    return regular


@kernel(internal=True, fastmath=FAST)
def solve_sparse(body, matrix, b):
    """Solve with the sparse factors only."""
    slots = b.size // 2
    r, order = matrix.blocks, matrix.order
    start, column, diagonal = matrix.row_start, matrix.column, matrix.diagonal
    for i in range(body.masses):
        m = order[i]
        x, y = b[m], b[slots + m]
        for p in range(start[i], diagonal[i]):
            o = order[column[p]]
            x -= r[4 * p] * b[o] + r[4 * p + 1] * b[slots + o]
            y -= r[4 * p + 2] * b[o] + r[4 * p + 3] * b[slots + o]
        b[m], b[slots + m] = x, y
    for i in range(body.masses - 1, -1, -1):
        m = order[i]
        x, y = b[m], b[slots + m]
        for p in range(diagonal[i] + 1, start[i + 1]):
            o = order[column[p]]
            x -= r[4 * p] * b[o] + r[4 * p + 1] * b[slots + o]
            y -= r[4 * p + 2] * b[o] + r[4 * p + 3] * b[slots + o]
        d = 4 * diagonal[i]
        b[m], b[slots + m] = r[d] * x + r[d + 1] * y, r[d + 2] * x + r[d + 3] * y
