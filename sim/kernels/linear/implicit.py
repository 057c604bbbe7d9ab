"""The linear systems of implicit steps, on any topology."""

from __future__ import annotations

from ..core.jit import FAST, kernel
from .sparse import factorise_sparse, solve_sparse
from .two_sided_lu import factorise_chain, solve_chain


@kernel(fastmath=FAST)
def factorise_matrix(body, state, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v.

    Jx and Jv are the derivatives of the accelerations with respect to positions and velocities. With
    `definite`, terms that could make the matrix indefinite are left out.

    Returns:
        Whether all pivots are regular.
    """
    if body.chain:
        return factorise_chain(body, state, matrix, q, v, a, g, definite)
    return factorise_sparse(body, state, matrix, q, v, a, g, definite)


@kernel(fastmath=FAST)
def solve_matrix(body, matrix, b):
    """Solve with the last factors, in place; b is a flat vector, x of every slot, then y."""
    if body.chain:
        solve_chain(body, matrix, b)
    else:
        solve_sparse(body, matrix, b)
