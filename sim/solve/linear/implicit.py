"""The linear systems of implicit steps: a I - g Jv - Jx, factorised and solved, and the product with Jv.

Jx and Jv are the derivatives of the accelerations with respect to positions, 1/s², and velocities, 1/s.
Velocities are eliminated from the systems, which leaves two unknowns per mass. The permanent blocks are in
`sparse`, those of contact that are not in its pattern in `krylov`.

The pressure of a filling depends on the area of its loop, which gives a product of two vectors, see
`forces.fillings.write_area_product`: c M^-1 G Gᵀ is added to the matrix. As this is dense, it is stored for
small loops only. With the rest of the matrix, A, the system (A + U Gᵀ) x = b, where U = c M^-1 G, is solved
as x = y - A^-1 U (I + Gᵀ A^-1 U)^-1 Gᵀ y with A y = b (Sherman, Morrison and Woodbury), for all other
fillings at once.
"""

from __future__ import annotations

from ...engine.jit import FAST, kernel
from ...forces.fillings import write_area_product
from ...forces.rails import keep_on_rails
from .krylov import solve_with_contact
from .sparse import assemble, eliminate
from .vectors import add_multiple, dot


@kernel(fastmath=FAST)
def factorise_matrix(body, state, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v.

    With `definite`, terms that could make the matrix indefinite are left out.

    Returns:
        Whether all pivots are regular.
    """
    assemble(body, state, matrix, q, v, g, definite)
    regular = eliminate(body, state, matrix, v, a, g)
    return regular and _border(body, state, matrix, q)


@kernel(fastmath=FAST)
def solve_matrix(body, state, matrix, b):
    """Solve with the last factors, in place; b is a flat vector, x of every slot, then y."""
    solve_with_contact(body, state, matrix, b)
    fillings = matrix.bordered.size
    for k in range(fillings):
        matrix.corrections[fillings, k] = dot(body.masses, matrix.low_rank[k], b)
    for k in range(fillings):
        part = 0.0
        for i in range(fillings):
            part += matrix.corrections[k, i] * matrix.corrections[fillings, i]
        add_multiple(body.masses, -part, matrix.low_rank[fillings + k], b)


@kernel(fastmath=FAST)
def _border(body, state, matrix, q):
    """Prepare the correction for the products of gradients; return whether its small matrix is regular.

    `low_rank` receives the gradients G, and then A^-1 U; `corrections` the inverse of I + Gᵀ A^-1 U.
    """
    low_rank, small, count = matrix.low_rank, matrix.corrections, matrix.bordered.size
    for k in range(count):
        write_area_product(body, state, matrix.bordered[k], q, low_rank[k], low_rank[count + k])
        keep_on_rails(body, low_rank[count + k])
        solve_with_contact(body, state, matrix, low_rank[count + k])
    for i in range(count):
        for k in range(count):
            small[i, k] = dot(body.masses, low_rank[i], low_rank[count + k]) + (1.0 if i == k else 0.0)
    return _invert(small, count)


@kernel(fastmath=FAST)
def _invert(a, n):
    """Invert the first n rows and columns in place (Gauss-Jordan, no pivoting); return whether it is regular.

    Without springs the matrix is I plus a positive semidefinite matrix, which needs no pivoting.
    """
    regular = True
    for p in range(n):
        pivot = 1.0 / a[p, p]
        if not abs(pivot) < 1e12:
            regular = False
        a[p, p] = 1.0
        for k in range(n):
            a[p, k] *= pivot
        for i in range(n):
            if i != p:
                factor = a[i, p]
                a[i, p] = 0.0
                for k in range(n):
                    a[i, k] -= factor * a[p, k]
    return regular
