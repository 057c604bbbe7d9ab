"""The sparsity pattern of the matrix of an implicit step, and the order in which masses are eliminated."""

from __future__ import annotations

import itertools
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..engine.tables import Body, Indices, Matrix
from ..forces.fillings import SMALL
from .system import slots_of

NO_MATRIX = Matrix.empty()
"""An empty matrix, for methods that solve no linear systems."""


# Unless noted, doubling or halving one of these numbers fails no test.
_KRYLOV = 40
"""Largest dimension of a Krylov space for the contact blocks that are not in the pattern."""
_KEPT = 4
"""Number of patterns that are cached. That of a cloth of 10 000 masses takes 20 MB."""


class Pattern(NamedTuple):
    """The part of a `Matrix` that depends only on connections and held masses; fields as there."""

    walk: Indices
    parent: Indices
    order: Indices
    row_start: Indices
    column: Indices
    diagonal: Indices
    spring_target: Indices
    joint_target: Indices
    loop_target: Indices
    bordered: Indices


def new_matrix(body: Body, held: np.ndarray) -> Matrix:
    """Allocate the matrix of a body.

    The elimination order is SuperLU's minimum degree, called through SciPy, on the graph of masses in which a
    spring connects its two masses, a joint all of its three or four, and a filling its neighbouring masses,
    or all masses of a small loop. The pattern is that of the factors. The most recent patterns are cached,
    since scenes are often rebuilt with other parameters only.
    """
    fillings = body.environment.fillings
    tables = body.spring_a, body.spring_b, body.joint_a, body.joint_b, fillings.loop, fillings.start
    room = body.stiffness.size + 3
    pattern = pattern_of(body.masses, room, *(table.tobytes() for table in (*tables, np.flatnonzero(held))))
    count, wide = pattern.bordered.size, 2 * slots_of(body)
    krylov, of_mass = 0, np.zeros(0, np.int64)
    if body.environment.contact.present:
        krylov, of_mass = _KRYLOV + 3, np.zeros(wide // 2, np.int64)
        of_mass[pattern.order] = pattern.diagonal
    return Matrix(
        blocks=np.zeros(4 * pattern.column.size),
        slot=np.zeros(body.masses, np.int64),
        low_rank=np.zeros((2 * count, wide if count else 0)),
        corrections=np.zeros((count + 1, count)),
        of_mass=of_mass,
        coupling=np.zeros(3 if krylov else 0),
        coupling_state=np.zeros((3 if krylov else 0, wide)),
        krylov=np.zeros((krylov, wide)),
        hessenberg=np.zeros((_KRYLOV + 4 if krylov else 0, _KRYLOV + 1)),
        **pattern._asdict(),
    )


@lru_cache(maxsize=_KEPT)
def pattern_of(n: int, room: int, *tables: bytes) -> Pattern:
    """Return the pattern for n masses; `room` is the size of `parent`, `tables` are the connections."""
    a, b, ja, jb, loop, start, held = (np.frombuffer(table, np.int64) for table in tables)
    ends = np.array([b, a]).T - 1  # (S, 2)
    spring_pairs = _pairs(ends, ends)
    of_joint = [_pairs(ends[s], ends[t]) for s in (ja, jb) for t in (ja, jb)]
    joint_pairs = np.concatenate(of_joint, 1)
    loop_pairs = _loop_pairs(loop - 1, start)
    pairs = np.concatenate([pairs.reshape(-1, 2) for pairs in (spring_pairs, joint_pairs, loop_pairs)])
    position, row_start, column = _factors(n, pairs)
    order = np.empty(n, np.int64)
    order[position] = np.arange(1, n + 1)
    # The keys are ascending, so a binary search finds the number of a block from its row and column.
    keys = np.repeat(np.arange(n), np.diff(row_start)) * n + column

    def targets(pairs: Indices) -> Indices:
        return np.searchsorted(keys, (position[pairs[..., 0]] * n + position[pairs[..., 1]]).ravel())

    walk, parent = _forest(n, room, a, b, held + 1)
    return Pattern(
        walk=walk,
        parent=parent,
        order=order,
        row_start=row_start,
        column=column,
        diagonal=np.searchsorted(keys, np.arange(n) * (n + 1)),
        spring_target=targets(spring_pairs),
        joint_target=targets(joint_pairs),
        loop_target=targets(loop_pairs),
        bordered=np.flatnonzero(np.diff(start) > SMALL),
    )


def clear_factors(matrix: Matrix) -> None:
    """Discard the computed contents of a matrix; its pattern stays."""
    for _, array in matrix.arrays():
        if array.dtype == np.float64:
            array[:] = 0.0


def fill(body: Body, matrix: Matrix) -> tuple[int, int]:
    """Return (number of blocks of the matrix, number of blocks of its factors)."""
    used = np.unique(
        np.concatenate((matrix.spring_target, matrix.joint_target, matrix.loop_target, matrix.diagonal))
    )
    return int(used.size), int(matrix.column.size)


def _pairs(rows: Indices, columns: Indices) -> Indices:
    """Return (k, 4, 2) the (row, column) of each combination of ends: first with first, then second, ..."""
    return np.stack([np.stack((rows[:, i], columns[:, j]), 1) for i in (0, 1) for j in (0, 1)], 1).astype(
        np.int64
    )


def _loop_pairs(loop: Indices, start: Indices) -> Indices:
    """Return the (k, 2) (row, column) of each mass of a loop with its two neighbours, or, for small loops,
    with all masses of the loop."""
    pairs = [np.zeros((0, 2), np.int64)]
    for first, behind in itertools.pairwise(start):
        masses = loop[first:behind]
        if masses.size <= SMALL:
            columns = np.tile(masses, (masses.size, 1))
        else:
            columns = np.stack((np.roll(masses, 1), np.roll(masses, -1)), 1)
        pairs.append(np.stack((np.repeat(masses, columns.shape[1]), columns.ravel()), 1))
    return np.concatenate(pairs)


def _factors(n: int, pairs: Indices) -> tuple[Indices, Indices, Indices]:
    """Return the position of each mass in the elimination order, and in that order the first block of each
    row of the factors and the columns of all blocks.

    Args:
        n: number of masses.
        pairs: (k, 2) connected masses, counted from 0; in both orders.
    """
    # Only implicit methods need this import.
    from scipy.sparse import coo_matrix
    from scipy.sparse.linalg import splu

    row, column = np.concatenate((pairs.T, np.tile(np.arange(n), (2, 1))), 1)
    graph = coo_matrix((np.ones(row.size), (row, column)), (n, n)).tocsc()
    graph.sort_indices()
    count = np.diff(graph.indptr)
    # Everything that elimination adds off the diagonal is negative, so that nothing cancels, and hardly
    # smaller than its source, so that nothing vanishes along a chain.
    on_diagonal = graph.indices == np.repeat(np.arange(n), count)
    graph.data = np.where(on_diagonal, np.repeat((1.0 + 1e-6) * count, count) - 1.0, -1.0)
    factors = splu(graph, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    # Zeros in it are not part of the pattern, but due to SuperLU's storage scheme.
    lower = factors.L
    lower.eliminate_zeros()
    lower.sort_indices()
    rows = lower.tocsr()
    before, after = np.diff(rows.indptr), np.diff(lower.indptr)  # both with the diagonal
    row_start = np.concatenate(([0], np.cumsum(before + after - 1)))
    columns = np.empty(row_start[-1], np.int64)
    # A row of the factors consists of a row of the lower factor and of its column below the diagonal.
    columns[np.arange(rows.nnz) + np.repeat(row_start[:-1] - rows.indptr[:-1], before)] = rows.indices
    below = np.arange(lower.nnz) + np.repeat(row_start[:-1] + before - 1 - lower.indptr[:-1], after)
    columns[below] = lower.indices
    return factors.perm_c.astype(np.int64), row_start, columns


def _forest(n: int, room: int, a: Indices, b: Indices, held: Indices) -> tuple[Indices, Indices]:
    """Return (walk, parent), see `Matrix`. Held masses and the first mass of a part without any are roots."""
    parent = np.zeros(room, np.int64)
    neighbours: list[list[int]] = [[] for _ in range(n + 1)]
    for one, other in zip(a.tolist(), b.tolist(), strict=True):
        neighbours[one].append(other)
        neighbours[other].append(one)
    walk: list[int] = []
    seen: set[int] = set()
    # All held masses are roots before any other mass is reached from one of them.
    for roots in (held.tolist(), *([m] for m in range(1, n + 1))):
        queue = [m for m in roots if m not in seen]
        seen.update(queue)
        for m in queue:  # it grows during the loop
            walk.append(m)
            for o in neighbours[m]:
                if o not in seen:
                    seen.add(o)
                    parent[o] = m
                    queue.append(o)
    return np.array(walk, np.int64), parent
