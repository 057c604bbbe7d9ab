"""The matrix of an implicit step: its derivatives, its factors, and the pattern of those."""

from __future__ import annotations

import math
from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import AngularSpring, LinearSpring, Mass, Scene
from sim.model.sparsity import fill
from sim.scene.types import AirLaw, ForceLaw
from sim.solve.linear.sparse import assemble
from tests.amount import examples
from tests.sim.arrays import Arrays, Floats
from tests.sim.bodies import LAWS, SHAPES, body, sharing
from tests.sim.builders import built, chain, row
from tests.sim.changes import pairs, with_joints, with_masses, with_springs

AIR_LAWS: tuple[AirLaw, ...] = get_args(AirLaw)


# ------------------------------------------------------------------------- the definite matrix
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("joints", [True, False])
@pytest.mark.parametrize("shape", SHAPES)
def test_the_definite_matrix_at_rest(shape: str, joints: bool, law: ForceLaw) -> None:
    scene = body(shape, law, 7, air=0.0, joints=joints)
    angles = sim.Simulation(scene).angles
    positions = np.array([mass.position for mass in scene.masses])
    lengths = [math.dist(positions[spring.a], positions[spring.b]) for spring in scene.linear_springs]
    scene = with_springs(with_masses(scene, velocity=(0.0, 0.0)), rest_length=lengths)
    arrays = Arrays(with_joints(scene, rest_angle=angles.tolist()))
    true, definite = (arrays.matrix_of(1e4, 100.0, d) for d in (False, True))
    size = np.abs(true).max()
    more = arrays.weight[:, None] * (definite - true)
    # It takes joints to be somewhat stiffer, against stretching, and nothing else.
    assert np.linalg.eigvalsh(0.5 * (more + more.T))[0] >= -1e-8 * size
    assert (np.abs(more).max() > 0.01 * size) == joints
    if not joints:
        assert np.abs(more).max() <= 1e-8 * size


# ------------------------------------------------------------------------- lengths of chains
@pytest.mark.parametrize("origin", [0, -1])
@pytest.mark.parametrize("law", LAWS)
def test_a_chain_of_any_length_is_solved_like_any_other_body(law: ForceLaw, origin: int) -> None:
    # Derivatives are taken of eight springs at once, and of sixteen before their rows are eliminated, from
    # both ends. What comes behind the last spring has no length where the last mass is at (0, 0).
    for count in (*range(2, 20), *range(30, 40), 47, 48, 49, 60, 61):
        rng = np.random.default_rng(count)
        positions = np.array(row(count)) + rng.uniform(-3.0, 3.0, (count, 2))
        positions -= positions[origin]
        scene = chain(
            pairs(positions), velocities=pairs(rng.normal(0.0, 50.0, (count, 2))), damping=20.0,
            stiffness=2000.0, angular_stiffness=3000.0, held=(count // 2,) if count > 3 else (),
        )  # fmt: skip
        scene = replace(scene, force_law=law, air_friction=0.01, air_law=AIR_LAWS[count % 3])
        one, other = Arrays(scene), Arrays(scene, general=True)
        assert one.body.chain
        assert not other.body.chain
        right = rng.normal(size=2 * count)
        for arrays in (one, other):
            assert arrays.factorise(100.0, 10.0)
        expected = other.solve(right)
        assert np.abs(one.solve(right) - expected).max() <= 1e-9 * np.abs(expected).max(), count


# ------------------------------------------------------------------------- pivots
@pytest.mark.parametrize("general", [False, True])
def test_a_singular_pivot_is_told(general: bool) -> None:
    # Nothing holds the second mass but the spring, which does not pull sideways.
    arrays = Arrays(chain(row(2), stiffness=100.0, rest_length=10.0, held=(0,)), general=general)
    assert arrays.factorise(1.0, 1.0)
    assert not arrays.factorise(0.0, 1.0)


@pytest.mark.parametrize("count", [2, 7, 8, 9, 20, 33, 40])
def test_a_singular_pivot_is_told_wherever_it_is(count: int) -> None:
    # Without springs a row has but 1 + 2 air |v| on its diagonal.
    arrays = Arrays(chain(row(count), velocities=[(1.0, 1.0)] * count))
    assert arrays.factorise(1.0, 1.0)
    for slot in range(1, count + 1):
        arrays.state.air[slot] = -0.5
        assert not arrays.factorise(1.0, 1.0)
        arrays.state.air[slot] = 0.0


# ------------------------------------------------------------------------- the pattern
def dense(arrays: Arrays, g: float) -> Floats:
    """Jx + g Jv of the forces as `assemble` sums them, for all of `here`."""
    matrix, n = arrays.matrix, arrays.body.masses
    assemble(arrays.body, arrays.state, matrix, arrays.q, arrays.v, g, False)
    whole = np.zeros((2 * n, 2 * n))
    for i in range(n):
        for p in range(matrix.row_start[i], matrix.row_start[i + 1]):
            m, o = matrix.order[i] - 1, matrix.order[matrix.column[p]] - 1
            whole[np.ix_((m, n + m), (o, n + o))] = matrix.blocks[4 * p : 4 * p + 4].reshape(2, 2)
    return whole


def fill_in(scene: Scene) -> float:
    arrays = Arrays(scene)
    blocks, factors = fill(arrays.body, arrays.matrix)
    return factors / blocks


def test_elimination_fills_in_little() -> None:
    assert fill_in(body("chain")) == fill_in(body("chain", joints=False)) == 1.0
    # Leaves first: a tree without joints fills in nothing, and joints join what hangs on one mass anyway.
    assert fill_in(body("tree", joints=False)) == 1.0
    assert fill_in(body("tree")) <= 1.1
    assert fill_in(body("hub", joints=False)) == 1.0
    assert fill_in(body("girder")) <= 1.3
    side = 20
    positions = [(30.0 * (i % side), 30.0 * (i // side)) for i in range(side * side)]
    edges = [(i, i + 1) for i in range(side * side) if i % side < side - 1]
    edges += [(i, i + side) for i in range(side * (side - 1))]
    sheet = built(positions, edges, stiffness=1.0)
    # In the order of rows, a band of twenty would be full: over seven times as many.
    assert fill_in(sheet) <= 5.0


def test_a_forest_hangs_on_what_is_held() -> None:
    scene = body("cloth", held=(5, 10))
    lone = (Mass(position=(900.0, 0.0)), Mass(position=(950.0, 0.0)), Mass(position=(999.0, 0.0)))
    spring = LinearSpring(a=17, b=16, stiffness=1.0, rest_length=1.0)
    scene = replace(scene, masses=(*scene.masses, *lone), linear_springs=(*scene.linear_springs, spring))
    arrays = Arrays(scene)
    matrix, tables = arrays.matrix, arrays.body
    joined = set(zip(tables.spring_a.tolist(), tables.spring_b.tolist(), strict=True))
    seen: set[int] = set()
    for m in matrix.walk.tolist():
        p = int(matrix.parent[m])
        if p:
            assert p in seen
            assert (p, m) in joined or (m, p) in joined
        seen.add(m)
    assert len(matrix.walk) == len(seen) == len(scene.masses)
    # Two that are held, one of the pair that hangs on nothing, and one by itself.
    assert [m - 1 for m in sorted(seen) if matrix.parent[m] == 0] == [5, 10, 16, 18]


@st.composite
def graphs(draw: st.DrawFn) -> Scene:
    """Any body: springs and joints as they come, also in parts that do not hang together."""
    n = draw(st.integers(1, 14))
    ways = [(i, j) for i in range(n) for j in range(n) if i != j]
    edges = draw(st.lists(st.sampled_from(ways), max_size=24, unique_by=frozenset)) if ways else []
    meeting = [pair[::order] for pair in sharing(edges) for order in (1, -1)]
    joined = draw(st.lists(st.sampled_from(meeting), max_size=20, unique_by=frozenset)) if meeting else []
    held = draw(st.lists(st.integers(0, n - 1), max_size=3, unique=True))
    rng = np.random.default_rng(draw(st.integers(0, 99)))
    spots, speeds = pairs(rng.uniform(0.0, 300.0, (n, 2))), pairs(rng.normal(0.0, 50.0, (n, 2)))
    joints = tuple(
        AngularSpring(a=a, b=b, stiffness=rng.uniform(1.0, 1e2), damping=0.5, rest_angle=30.0)
        for a, b in joined
    )
    return built(
        spots, edges, velocities=speeds,
        mass=rng.uniform(0.5, 3.0, n).tolist(), stiffness=rng.uniform(10.0, 1e3, len(edges)).tolist(),
        damping=5.0, rest_length=100.0, angular_springs=joints, held=held,
        force_law=draw(st.sampled_from(LAWS)), air_friction=0.01, air_law=draw(st.sampled_from(AIR_LAWS)),
    )  # fmt: skip


@settings(max_examples=examples(150), derandomize=True, database=None)
@given(graphs())
def test_any_graph_is_solved_as_a_dense_matrix_is(scene: Scene) -> None:
    arrays = Arrays(sim.validate(scene), general=True)
    g, here = 200.0, arrays.here
    free = arrays.state.inverse_mass[here % arrays.slots]
    drag = 2.0 * arrays.state.air[here % arrays.slots] * np.abs(arrays.v[here])
    matrix = np.diag(g * g + g * drag) - free[:, None] * dense(arrays, g)
    right = np.random.default_rng(0).normal(size=here.size)
    assert arrays.factorise(g * g, g)
    assert np.abs(arrays.solve(right) - np.linalg.solve(matrix, right)).max() <= 1e-12
