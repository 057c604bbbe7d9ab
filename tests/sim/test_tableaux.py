"""The coefficients of the methods, against the order conditions that rooted trees give.

An expansion of the exact solution has one term for each rooted tree. A method is of order p when, for each
tree of up to p nodes, its own weight of that term is 1 / density(tree) (Butcher); a Rosenbrock method goes
along an edge to an only child with alpha + gamma, along others with alpha (Hairer & Wanner II, IV.7).
"""

from __future__ import annotations

import itertools
import math
from functools import cache

import numpy as np
import pytest

from sim.engine.tables import PAST, Adams, Rosenbrock, Tableau
from sim.solve import tableaux
from sim.solve.adams_table import adams
from sim.solve.registry import METHODS

Tree = tuple["Tree", ...]
"""A node, as the tuple of its children."""
Floats = np.ndarray


def nodes(tree: Tree) -> int:
    return 1 + sum(nodes(child) for child in tree)


def density(tree: Tree) -> int:
    return nodes(tree) * math.prod(density(child) for child in tree)


@cache
def trees(order: int) -> list[Tree]:
    """All rooted trees with that many nodes."""
    return [tuple(children) for children in _forests(order - 1, order - 1)]


@cache
def _forests(count: int, largest: int) -> list[list[Tree]]:
    """All multisets of trees with that many nodes together, none larger than `largest`."""
    if count == 0:
        return [[]]
    if largest == 0:
        return []
    found = []
    for copies in range(count // largest + 1):
        for rest in _forests(count - copies * largest, largest - 1):
            for some in itertools.combinations_with_replacement(trees(largest), copies):
                found.append([*some, *rest])
    return found


def stage_weights(tree: Tree, alpha: Floats, beta: Floats) -> Floats:
    """What each stage has of the term of a tree."""
    edge = beta if len(tree) == 1 else alpha
    parts = [edge @ stage_weights(child, alpha, beta) for child in tree]
    return np.prod(parts, axis=0) if parts else np.ones(len(alpha))


def misfit(weights: Floats, order: int, alpha: Floats, beta: Floats, *, exact: bool = True) -> float:
    """The largest error of a sum over stages among the conditions up to an order."""
    return max(
        abs(float(weights @ stage_weights(tree, alpha, beta)) - (1.0 / density(tree) if exact else 0.0))
        for p in range(1, order + 1)
        for tree in trees(p)
    )


def test_there_are_as_many_trees_as_there_should_be() -> None:
    assert [len(trees(order)) for order in range(1, 9)] == [1, 1, 2, 4, 9, 20, 48, 115]
    assert density((((),),)) == 6
    assert density(((), ())) == 3


EXPLICIT = [
    pytest.param(info.table, info.order, id=info.name)
    for info in METHODS.values()
    if isinstance(info.table, Tableau)
]
ROSENBROCK = [(tableaux.RODAS4, 4, 3), (tableaux.RODAS5P, 5, 4)]


@pytest.mark.parametrize(("table", "order"), EXPLICIT)
def test_explicit_methods_fulfil_their_conditions(table: Tableau, order: int) -> None:
    s = table.stages
    # With the end of the step as one more stage, whose weights are those of the method.
    a = np.zeros((s + 1, s + 1))
    a[:] = table.a[:, : s + 1]
    b = a[s]
    assert (np.triu(a) == 0.0).all()
    assert np.abs(a.sum(1) - table.c).max() <= 1e-14
    assert np.abs(a @ a - table.abar[:, : s + 1]).max() <= 1e-14
    assert misfit(b, order, a, a) <= 1e-13
    assert misfit(b, order + 1, a, a) > 1e-6


@pytest.mark.parametrize(("table", "order", "embedded"), ROSENBROCK, ids=["rodas4", "rodas5p"])
def test_rosenbrock_methods_fulfil_their_conditions(table: Rosenbrock, order: int, embedded: int) -> None:
    s = table.stages
    # Back from the form in which each stage is one solve to the coefficients that the conditions are for.
    gamma = np.linalg.inv(np.eye(s) / table.gamma - table.coupling[:s, :s])
    alpha = table.a[:s, :s] @ gamma
    beta = alpha + gamma
    b, error = table.a[s, :s] @ gamma, table.error[:s] @ gamma
    assert np.diag(gamma) == pytest.approx(np.full(s, table.gamma), rel=1e-14)
    assert np.abs(alpha.sum(1) - table.c[:s]).max() <= 1e-12
    assert table.c[s] == 1.0
    assert np.abs(gamma.sum(1) - table.time_weights).max() <= 1e-12
    assert misfit(b, order, alpha, beta) <= 1e-12
    assert misfit(b, order + 1, alpha, beta) > 1e-6
    assert misfit(error, embedded, alpha, beta, exact=False) <= 1e-12
    assert misfit(error, embedded + 1, alpha, beta, exact=False) > 1e-6
    # Stiffly accurate: the end of the step is the last stage and its solution.
    assert np.abs(table.a[s] - table.a[s - 1] - np.eye(1, table.a.shape[1], s - 1)[0]).max() == 0.0
    assert not table.a[:, s:].any()
    assert not table.coupling[:, s:].any()
    assert not table.coupling[s].any()


def test_methods_say_the_order_that_their_tables_have() -> None:
    known = [(id(table), order) for table, order, _ in ROSENBROCK]
    for info in METHODS.values():
        if isinstance(info.table, Adams):
            assert info.order == info.table.degree + 2
        elif isinstance(info.table, Rosenbrock):
            assert (id(info.table), info.order) in known


@pytest.mark.parametrize("k", range(PAST))
def test_adams_methods_are_exact_for_polynomials(k: int) -> None:
    table = adams(PAST - 1)
    back = -np.arange(PAST, dtype=float)
    for power in range(k + 2):
        past = back**power
        off = 1.0 - float(table.ahead[k] @ past)
        # The prediction is exact up to the degree of the polynomial, the correction one beyond it.
        assert off == pytest.approx(0.0 if power <= k else float(math.factorial(k + 1)), abs=1e-8)
        position = float(table.position[k] @ past) + off * table.to_position[k]
        speed = float(table.velocity[k] @ past) + off * table.to_velocity[k]
        assert position == pytest.approx(1.0 / ((power + 1) * (power + 2)), abs=1e-9)
        assert speed == pytest.approx(1.0 / (power + 1), abs=1e-9)
    # Between the known nodes, by the barycentric formula.
    distance = 0.3 + np.arange(k + 1)
    weights = table.barycentric[k, : k + 1] / distance * np.prod(distance) * (-1.0) ** k
    for power in range(k + 1):
        assert float(weights @ np.arange(k + 1.0) ** power) == pytest.approx((-0.3) ** power, abs=1e-9)
        # What a velocity has gained in the last steps.
        for steps in range(1, k + 1):
            gained = float(table.back[k * PAST + steps] @ back**power)
            assert gained == pytest.approx(-((-steps) ** (power + 1.0)) / (power + 1.0), rel=1e-9)
    for padded in (table.position, table.velocity, table.ahead, table.barycentric):
        assert not padded[k, k + 1 :].any()


def test_the_known_coefficients_of_adams() -> None:
    # Hairer, Norsett & Wanner I, III.1: explicit and implicit, of the fourth order.
    table = adams(PAST - 1)
    assert table.velocity[3, :4] * 24.0 == pytest.approx([55.0, -59.0, 37.0, -9.0], abs=1e-12)
    corrected = table.velocity[2, :3] - table.to_velocity[2] * table.ahead[2, :3]
    assert np.array([table.to_velocity[2], *corrected]) * 24.0 == pytest.approx(
        [9.0, 19.0, -5.0, 1.0], abs=1e-12
    )
    # The estimate is what the oldest point changes: in the velocity, the Adams-Moulton constants' difference.
    assert table.error[2] == pytest.approx(abs(9.0 / 24.0 - 5.0 / 12.0))
