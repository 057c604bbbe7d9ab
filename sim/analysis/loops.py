"""Linear systems of a body with many small loops full of gas or liquid, as a jelly has them.

A filling couples all masses around its loop. `kernels.linear.implicit` keeps that out of the sparse matrix,
and solves a system for each filling instead: that is best for few loops, however long. Small ones are better
filled into the matrix, which stays sparse. SuperLU factorises it, through SciPy, without pivoting off the
diagonal. So the matrix, with the masses multiplied out and symmetric but for the tutorial's law, is positive
definite if and only if all of its pivots are positive.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..forces.fillings import write_area_product
from ..kernels.core.tables import Body, Floats, Matrix, State
from ..kernels.linear.sparse import assemble

if TYPE_CHECKING:
    from scipy.sparse.linalg import SuperLU

_MANY, _SMALL = 8, 12
"""Number of loops from which on, and of masses around one up to which, they are filled into the matrix."""


def has_many_loops(body: Body) -> bool:
    """Whether `LoopsMatrix` suits a body: one of many small loops without contact, which has no pattern."""
    environment = body.environment
    sizes = np.diff(environment.fillings.start)
    return sizes.size >= _MANY and int(sizes.max()) <= _SMALL and not environment.contact.present


class LoopsMatrix:
    """The matrix shift I - J of accelerations at rest.

    Args:
        body, state: tables.
        matrix: a pattern for that body; its blocks are scratch.
    """

    def __init__(self, body: Body, state: State, matrix: Matrix) -> None:
        self._body, self._state, self._matrix = body, state, matrix
        slots = state.x.size
        free = np.flatnonzero(state.inverse_mass)
        self._columns = np.concatenate((free, slots + free))
        self._mass = 1.0 / np.tile(state.inverse_mass[free], 2)
        index = np.full(2 * slots, -1)
        index[self._columns] = np.arange(self._columns.size)
        # The pattern has room for the factors, too.
        used = (matrix.spring_target, matrix.joint_target, matrix.loop_target, matrix.diagonal)
        block = np.unique(np.concatenate(used))
        row = np.repeat(matrix.order, np.diff(matrix.row_start))[block]
        column = matrix.order[matrix.column[block]]
        # Each block has four numbers: xx, xy, yx, yy.
        rows = index[np.stack((row, row, slots + row, slots + row), 1)].ravel()
        cols = index[np.stack((column, slots + column, column, slots + column), 1)].ravel()
        kept = (rows >= 0) & (cols >= 0)
        self._numbers = (4 * block[:, None] + np.arange(4)).ravel()[kept]
        self._loops = []
        for loop in body.environment.fillings.loops():
            at = np.unique(loop)
            both = np.concatenate((at, slots + at))
            both = both[index[both] >= 0]
            self._loops.append((both, index[both]))
        diagonal = np.arange(free.size * 2)
        self._rows = np.concatenate(
            (rows[kept], diagonal, *(np.repeat(at, at.size) for _, at in self._loops))
        )
        self._cols = np.concatenate((cols[kept], diagonal, *(np.tile(at, at.size) for _, at in self._loops)))
        self._gradient, self._scaled = np.zeros((2, 2 * slots))
        self._factors: SuperLU | None = None

    def factorise(self, q: Floats, still: Floats, shift: float, definite: bool) -> bool:
        """Factorise it at positions q; whether it is positive definite. Other arguments as of `assemble`."""
        from scipy.sparse import coo_array
        from scipy.sparse.linalg import splu

        body, state, matrix = self._body, self._state, self._matrix
        assemble(body, state, matrix, q, still, 0.0, definite)
        values = [-matrix.blocks[self._numbers], shift * self._mass]
        for k, (slots, at) in enumerate(self._loops):
            write_area_product(body, state, k, q, self._gradient, self._scaled)
            scaled = self._mass[at] * self._scaled[slots]
            values.append(np.outer(scaled, self._gradient[slots]).ravel())
        count = self._columns.size
        whole = coo_array((np.concatenate(values), (self._rows, self._cols)), (count, count)).tocsc()
        self._factors = None
        if not np.isfinite(whole.data).all():
            return False
        try:
            options = {"SymmetricMode": True, "Equil": False}
            factors = splu(whole, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
        except RuntimeError:  # it is singular
            return False
        self._factors = factors
        return bool((factors.perm_r == factors.perm_c).all() and (factors.U.diagonal() > 0.0).all())

    def solve(self, b: Floats) -> Floats:
        """The solution with the last factors; infinite where there are none."""
        x = np.zeros(b.size)
        if self._factors is None:
            x[self._columns] = np.inf
        else:
            x[self._columns] = self._factors.solve(self._mass * b[self._columns])
        return x
