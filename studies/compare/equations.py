"""A scene as a system of first-order equations for ODE solvers, evaluated by softrod's kernels."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Literal

import msgspec
import numba
import numpy as np

import sim
from sim.engine.table import Floats, Indices, Table
from sim.engine.tables import Body, Matrix, PrescribedMotion, Scratch, State
from sim.forces.all import accelerations
from sim.forces.drive import drive_to
from sim.model.sparsity import new_matrix
from sim.motion.driving import Driver
from sim.solve.linear.sparse import assemble

Layout = Literal["dense", "banded", "sparse"]
"""Layout of a Jacobian: an (N, N) array; diagonals, where row `above` + i - j holds J[i, j] at column j; or
the numbers of a matrix in compressed columns."""


class _Tables(Table):
    """Arguments of the functions below."""

    body: Body
    state: State
    scratch: Scratch
    drive: PrescribedMotion
    matrix: Matrix
    at: Indices  # slot of each free mass
    a: Floats  # accelerations, flat
    used: Indices  # blocks of the matrix
    row: Indices  # index of the row of each
    by_position: Floats  # derivatives of the blocks by positions


@numba.njit
def _take(tables, t, y):
    """Copy the state y at time t into the kernels' tables."""
    at, q, v = tables.at, tables.state.q, tables.state.v
    slots = q.size // 2
    for i in range(at.size):
        m, k = at[i], 4 * i
        q[m], q[slots + m], v[m], v[slots + m] = y[k], y[k + 1], y[k + 2], y[k + 3]
    if tables.drive.moving:
        drive_to(tables.body, tables.state, tables.drive, t, q, v)


@numba.njit
def _derivative(tables, t, y, out):
    at, q, a = tables.at, tables.state.q, tables.a
    slots = q.size // 2
    _take(tables, t, y)
    accelerations(tables.body, tables.state, tables.scratch, q, tables.state.v, a)
    for i in range(at.size):
        m, k = at[i], 4 * i
        out[k], out[k + 1], out[k + 2], out[k + 3] = y[k + 2], y[k + 3], a[m], a[slots + m]


@numba.njit
def _jacobian(tables, to_place, to_speed, to_one, t, y, out):
    """Write the Jacobian of `_derivative` into the flat array `out`.

    Args:
        to_place, to_speed: (4 B,) indices in `out` of a block's derivatives by positions and by velocities.
        to_one: (2 free masses) indices of the derivatives of positions by velocities; after those, as many
            on the diagonal by velocities, where air acts.
    """
    at, row, used, scratch = tables.at, tables.row, tables.used, tables.by_position
    state, blocks = tables.state, tables.matrix.blocks
    q, v = state.q, state.v
    _take(tables, t, y)
    # The blocks are linear in g: without it they are by positions, and what g = 1 adds is by velocities.
    assemble(tables.body, state, tables.matrix, q, v, 0.0, False)
    for i in range(used.size):
        w = state.inverse_mass[row[i]]
        for k in range(4):
            scratch[4 * i + k] = blocks[4 * used[i] + k]
            out[to_place[4 * i + k]] = w * scratch[4 * i + k]
    assemble(tables.body, state, tables.matrix, q, v, 1.0, False)
    for i in range(used.size):
        w = state.inverse_mass[row[i]]
        for k in range(4):
            out[to_speed[4 * i + k]] = w * (blocks[4 * used[i] + k] - scratch[4 * i + k])
    for i in range(2 * at.size):
        out[to_one[i]] = 1.0
        m = at[i // 2] + q.size // 2 * (i % 2)
        out[to_one[2 * at.size + i]] -= 2.0 * state.air[at[i // 2]] * abs(v[m])


class Equations:
    """dy/dt = f(t, y) of a scene, and its Jacobian; anchors on circles make f depend on t.

    y holds x, y, vx, vy of one free mass after the other. Masses of a chain are in its order and those of any
    other body in reverse Cuthill-McKee order, so that the Jacobian has a narrow band.

    Args:
        scene: a valid scene.

    Attributes:
        start: (N,) y at time 0.
        below, above: diagonals of the Jacobian on either side.
    """

    def __init__(self, scene: sim.Scene) -> None:
        scene = msgspec.structs.replace(scene, integrator=sim.Integrator(method="adams", tolerance=1e-9))
        simulation = sim.Simulation(scene)
        system, state, n = simulation._system, simulation._state, len(scene.masses)
        self._state, self._place = state, system.mass_index
        matrix = new_matrix(system.body, system.held)
        owner = np.repeat(np.arange(n), np.diff(matrix.row_start))
        used = np.unique(np.concatenate((matrix.spring_target, matrix.joint_target, matrix.diagonal)))
        row, column = matrix.order[owner[used]], matrix.order[matrix.column[used]]  # slots
        free = np.flatnonzero(~system.held) + 1
        inside = np.isin(row, free) & np.isin(column, free)
        used, row, column = used[inside], row[inside], column[inside]
        self._at = at = free if system.body.chain else _in_order(free, row, column)
        number = np.full(n + 1, -1)
        number[at] = np.arange(free.size)
        i, j = number[row], number[column]
        # (row, column) in the Jacobian of each number, in the order in which the kernel has them.
        rows = (4 * i[:, None] + np.array([2, 2, 3, 3])).ravel()
        columns = (4 * j[:, None] + np.array([0, 1, 0, 1])).ravel()
        x = (4 * np.arange(free.size)[:, None] + np.array([0, 1])).ravel()
        self._rows, self._columns = (
            np.concatenate(parts) for parts in ((rows, rows, x, x + 2), (columns, columns + 2, x + 2, x + 2))
        )
        self.below = int((self._rows - self._columns).max())
        self.above = int((self._columns - self._rows).max())
        self.start = np.column_stack((state.x[at], state.y[at], state.vx[at], state.vy[at])).ravel()
        self._scratch = np.zeros(rows.size)
        self._tables = _Tables(
            body=system.body,
            state=state,
            scratch=simulation._motion.scratch,
            drive=Driver(scene, system, state).drive(0.0, np.inf, {}),
            matrix=matrix,
            at=at,
            a=np.zeros_like(state.q),
            used=used,
            row=row,
            by_position=self._scratch,
        )

    def derivative_into(self) -> Callable[[float, Floats, Floats], None]:
        """Return a function (t, y, out) that writes dy/dt into `out`."""
        return functools.partial(_derivative, self._tables)

    def derivative(self) -> Callable[[float, Floats], Floats]:
        """Return a function (t, y) that returns dy/dt."""
        tables, size = self._tables, self.start.size

        def derivative(t: float, y: Floats) -> Floats:
            out = np.empty(size)
            _derivative(tables, t, y, out)
            return out

        return derivative

    def jacobian_into(self, layout: Layout) -> Callable[[float, Floats, Floats], None]:
        """Return a function (t, y, out) that writes the Jacobian into the flat `out`, except its zeros."""
        size, (i, j) = self.start.size, (self._rows, self._columns)
        if layout == "dense":
            index = i * size + j
        elif layout == "banded":
            index = (self.above + i - j) * size + j
        else:
            index = np.searchsorted(np.unique(j * size + i), j * size + i)
        parts = np.split(index, (self._scratch.size, 2 * self._scratch.size))
        return functools.partial(_jacobian, self._tables, *parts)

    def pattern(self) -> tuple[Indices, Indices]:
        """Return the row of each number and the first number of each column, in compressed columns."""
        size = self.start.size
        keys = np.unique(self._columns * size + self._rows)
        return keys % size, np.searchsorted(keys // size, np.arange(size + 1))

    def positions(self, t: float, y: Floats) -> Floats:
        """Return the (n, 2) positions of all masses at time t, px, in the scene's order."""
        self.derivative_into()(t, y, np.empty(y.size))  # also moves led masses
        return np.column_stack((self._state.x[self._place], self._state.y[self._place]))


def _in_order(free: Indices, row: Indices, column: Indices) -> Indices:
    """Return the slots of the free masses in reverse Cuthill-McKee order."""
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    index = np.searchsorted(free, row), np.searchsorted(free, column)
    graph = csr_matrix((np.ones(row.size), index), (free.size, free.size))
    return free[reverse_cuthill_mckee(graph, symmetric_mode=True)]
