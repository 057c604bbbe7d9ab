"""The sparsity pattern of the matrix of an implicit step, and the order in which masses are eliminated."""

from __future__ import annotations

import itertools

import numpy as np

from ..kernels.core.tables import Body, Floats, Indices, Matrix
from .system import slots_of

NO_MATRIX = Matrix.empty()
"""An empty matrix, for methods that solve no linear systems."""


_KRYLOV = 40
"""Largest dimension of a Krylov space for the parts of contact that are not in the pattern."""


def new_matrix(body: Body, held: np.ndarray) -> Matrix:
    """Arrays for the matrix of a body, whose pattern is found here, once.

    The order is SuperLU's minimum degree, called through SciPy. The pattern of the factors follows from
    elimination on the graph of masses, in which a spring connects its two masses, a joint all of its three or
    four, and a filling those that are neighbours around it.
    """
    n = body.masses
    a, b = body.spring_a - 1, body.spring_b - 1
    ja, jb = body.joint_a, body.joint_b
    ends = np.array([b, a]).T  # (S, 2)
    spring_pairs = _pairs(ends, ends)
    of_joint = [_pairs(ends[s], ends[t]) for s in (ja, jb) for t in (ja, jb)]
    joint_pairs = np.concatenate(of_joint, 1) if len(ja) else np.zeros((0, 16, 2), np.int64)
    neighbours: list[set[int]] = [set() for _ in range(n)]
    loop_pairs = _loop_pairs(body)
    for pairs in (spring_pairs, joint_pairs, loop_pairs):
        for row, column in np.unique(pairs.reshape(-1, 2), axis=0).tolist():
            neighbours[row].add(column)
    for i in range(n):
        neighbours[i].add(i)
    order = _minimum_degree(neighbours)
    position = np.empty(n, np.int64)
    position[order] = np.arange(n)
    rows = _fill(neighbours, order, position)
    row_start = np.concatenate(([0], np.cumsum([len(row) for row in rows]))).astype(np.int64)
    column = np.concatenate([np.array(row, np.int64) for row in rows])
    # The keys are ascending, so that a binary search finds the number of a block from its row and column.
    keys = np.repeat(np.arange(n), np.diff(row_start)) * n + column

    def targets(pairs: Indices) -> Indices:
        return np.searchsorted(keys, (position[pairs[..., 0]] * n + position[pairs[..., 1]]).ravel())

    fillings = len(body.environment.fillings.rows)
    walk, parent = forest(body, held)
    diagonal = np.searchsorted(keys, np.arange(n) * n + np.arange(n))
    wide, of_mass = 2 * slots_of(body), np.zeros(0, np.int64)
    krylov = 0
    if body.environment.contact.present:
        krylov, of_mass = _KRYLOV + 3, np.zeros(wide // 2, np.int64)
        of_mass[1 : n + 1] = diagonal[position]
    return Matrix(
        blocks=np.zeros(4 * column.size),
        walk=walk,
        parent=parent,
        order=order + 1,
        row_start=row_start,
        column=column,
        diagonal=diagonal,
        slot=np.zeros(n, np.int64),
        spring_target=targets(spring_pairs),
        joint_target=targets(joint_pairs),
        loop_target=targets(loop_pairs),
        borders=np.zeros((2 * fillings, 2 * slots_of(body) if fillings else 0)),
        corrections=np.zeros((fillings + 1, fillings)),
        of_mass=of_mass,
        touching=np.zeros(3 if krylov else 0),
        touched=np.zeros((3 if krylov else 0, wide)),
        krylov=np.zeros((krylov, wide)),
        hessenberg=np.zeros((_KRYLOV + 4 if krylov else 0, _KRYLOV + 1)),
    )


def clear_factors(matrix: Matrix) -> None:
    """Forget what was computed with a matrix; its pattern stays."""
    for _, array in matrix.arrays():
        if array.dtype == np.float64:
            array[:] = 0.0


def fill(body: Body, matrix: Matrix) -> tuple[int, int]:
    """(number of blocks of the matrix, number of blocks of its factors)."""
    used = np.unique(
        np.concatenate((matrix.spring_target, matrix.joint_target, matrix.loop_target, matrix.diagonal))
    )
    return int(used.size), int(matrix.column.size)


def _pairs(rows: Indices, columns: Indices) -> Indices:
    """(k, 4, 2) the (row, column) of each combination of ends: first with first, first with second, ..."""
    return np.stack([np.stack((rows[:, i], columns[:, j]), 1) for i in (0, 1) for j in (0, 1)], 1).astype(
        np.int64
    )


def _loop_pairs(body: Body) -> Indices:
    """(M, 2, 2) the (row, column) of each mass of a loop with the masses before and after it."""
    fillings = body.environment.fillings
    loop, start = fillings.loop - 1, fillings.start
    before, after = loop.copy(), loop.copy()
    for first, behind in itertools.pairwise(start):
        before[first:behind] = np.roll(loop[first:behind], 1)
        after[first:behind] = np.roll(loop[first:behind], -1)
    return np.stack((np.stack((loop, before), 1), np.stack((loop, after), 1)), 1)


def _minimum_degree(neighbours: list[set[int]]) -> Indices:
    # Only implicit methods need this import.
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import splu

    n = len(neighbours)
    start = np.concatenate(([0], np.cumsum([len(row) for row in neighbours])))
    index = np.concatenate([np.fromiter(sorted(row), np.int64) for row in neighbours])
    # Any diagonally dominant numbers: only the pattern matters.
    value: Floats = np.full(index.size, -1.0)
    value[index == np.repeat(np.arange(n), np.diff(start))] = n + 1.0
    factors = splu(
        csc_matrix((value, index, start), (n, n)),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    order = np.empty(n, np.int64)
    order[factors.perm_c] = np.arange(n)
    return order


def _fill(neighbours: list[set[int]], order: Indices, position: Indices) -> list[list[int]]:
    """The columns of each row of the factors, in the order of elimination.

    Eliminating a mass connects its later neighbours with each other; it is enough to add them to the
    neighbours of the first of them.
    """
    n = len(neighbours)
    upper: list[set[int]] = [
        {int(p) for p in position[list(neighbours[m])] if p > i} for i, m in enumerate(order)
    ]
    rows: list[list[int]] = [[] for _ in range(n)]
    for i in range(n):
        later = sorted(upper[i])
        if later:
            upper[later[0]].update(later[1:])
        for j in later:
            rows[j].append(i)
        rows[i].append(i)
        rows[i].extend(later)
    return rows


def forest(body: Body, held: np.ndarray) -> tuple[Indices, Indices]:
    """(walk, parent): see `Matrix`. Held masses and the first mass of a part without any have no parent."""
    n = body.masses
    parent = np.zeros(body.stiffness.size + 3, np.int64)
    neighbours: list[list[int]] = [[] for _ in range(n + 1)]
    for a, b in zip(body.spring_a.tolist(), body.spring_b.tolist(), strict=True):
        neighbours[a].append(b)
        neighbours[b].append(a)
    walk: list[int] = []
    seen: set[int] = set()
    # All held masses are roots before any other mass is reached from one of them.
    for roots in ((np.flatnonzero(held) + 1).tolist(), *([m] for m in range(1, n + 1))):
        queue = [m for m in roots if m not in seen]
        seen.update(queue)
        for m in queue:  # it grows meanwhile
            walk.append(m)
            for o in neighbours[m]:
                if o not in seen:
                    seen.add(o)
                    parent[o] = m
                    queue.append(o)
    return np.array(walk, np.int64), parent
