"""Linear systems with the blocks of contact that are not in the pattern.

The masses and springs that touch each other change all the time, so the blocks that couple them are not in
the pattern. The contributions of contact to the diagonal blocks of masses and to the blocks between the ends
of a spring are, and are factorised with the rest. With that matrix A and the other blocks R, a system (A + R)
x = b is solved as x + A^-1 R x = A^-1 b by GMRES (Saad & Schultz 1986). A few iterations suffice, about as
many as there are independent contact directions, or fewer where the step is short. If they do not, the result
is infinite, and the step is rejected.
"""

from __future__ import annotations

import math

from ...engine.jit import FAST, kernel
from ...forces.rails import keep_on_rails
from ...forces.touch.contact import COUPLING_PAIRS, add_coupling
from .sparse import solve_sparse
from .vectors import add_multiple, dot

# Unless noted, doubling or halving one of these numbers fails no test.
_ACCURACY = 1e-12
"""Residual, relative to the right-hand side, at which the iteration ends."""
_CYCLES = 4
"""Maximum number of Krylov spaces, including restarts. Doubled,
`test_steps_go_on_where_iterations_do_not_converge` fails."""


@kernel(internal=True, fastmath=FAST)
def solve_with_contact(body, state, matrix, b):
    """Solve like `sparse.solve_sparse`, including all blocks of contact."""
    solve_sparse(body, matrix, b)
    if not body.environment.contact.present or matrix.coupling[COUPLING_PAIRS] == 0.0:
        return
    space, hessenberg, width = matrix.krylov, matrix.hessenberg, matrix.hessenberg.shape[1]
    x, right, most = space[width], space[width + 1], width - 1
    masses, slots = body.masses, b.size // 2
    cosine, sine, rest = hessenberg[width], hessenberg[width + 1], hessenberg[width + 2]
    for j in range(b.size):
        x[j], right[j] = 0.0, 0.0
    add_multiple(masses, 1.0, b, right)
    whole, cycle, size = 0.0, 0, math.inf
    while cycle < _CYCLES:
        # The residual of the current solution.
        if cycle == 0:
            for j in range(b.size):
                space[0, j] = right[j]
        else:
            _couple(body, state, matrix, x, space[0])
            solve_sparse(body, matrix, space[0])
            for j in range(b.size):
                space[0, j] = right[j] - x[j] - space[0, j]
        size = math.sqrt(dot(masses, space[0], space[0]))
        whole = size if cycle == 0 else whole
        if not size > _ACCURACY * whole:
            break
        for j in range(b.size):
            space[0, j] /= size
        rest[0], steps = size, 0
        while steps < most and abs(rest[steps]) > _ACCURACY * whole:
            k = steps
            new = space[k + 1]
            _couple(body, state, matrix, space[k], new)
            solve_sparse(body, matrix, new)
            for j in range(b.size):
                new[j] += space[k, j]
            for i in range(k + 1):
                along = dot(masses, space[i], new)
                hessenberg[i, k] = along
                for j in range(b.size):
                    new[j] -= along * space[i, j]
            length = math.sqrt(dot(masses, new, new))
            for j in range(b.size):
                new[j] /= length + 1e-300
            for i in range(k):  # the rotations so far
                upper, lower = hessenberg[i, k], hessenberg[i + 1, k]
                hessenberg[i, k] = cosine[i] * upper + sine[i] * lower
                hessenberg[i + 1, k] = cosine[i] * lower - sine[i] * upper
            upper = hessenberg[k, k]
            diagonal = math.sqrt(upper * upper + length * length) + 1e-300
            cosine[k], sine[k] = upper / diagonal, length / diagonal
            hessenberg[k, k] = diagonal
            rest[k + 1] = -sine[k] * rest[k]
            rest[k] *= cosine[k]
            steps += 1
        size = abs(rest[steps])
        for i in range(steps - 1, -1, -1):
            for k in range(i + 1, steps):
                rest[i] -= hessenberg[i, k] * rest[k]
            rest[i] /= hessenberg[i, i]
            for j in range(b.size):
                x[j] += rest[i] * space[i, j]
        cycle += 1
        if not size > _ACCURACY * whole:
            break
    found = size <= _ACCURACY * whole
    for i in range(1, masses + 1):
        b[i], b[slots + i] = (x[i], x[slots + i]) if found else (math.inf, math.inf)


@kernel(fastmath=FAST)
def _couple(body, state, matrix, z, out):
    """Compute out = R z."""
    for j in range(out.size):
        out[j] = 0.0
    add_coupling(body, state, matrix, z, out)
    keep_on_rails(body, out)
