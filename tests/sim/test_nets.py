"""Nets, whose springs and joints come in runs, exert the forces of any other body."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import AngularSpring, LinearSpring, Scene
from sim.body.system import System, build_system, new_scratch, start_of
from sim.forces.all import accelerations
from sim.forces.nets import NO_NET
from sim.kernels.core.tables import Scratch, State
from sim.scene.types import ForceLaw
from tests.sim.arrays import off
from tests.sim.changes import with_joints, with_springs

Points = np.ndarray


def moving(scene: Scene, seed: int) -> tuple[System, State]:
    """The tables of a scene, and a state in which every mass is somewhere near its place and moves."""
    system, state = start_of(scene, build_system(scene))
    rng, n = np.random.default_rng(seed), system.body.masses
    for vector, size in ((state.x, 3.0), (state.y, 3.0), (state.vx, 100.0), (state.vy, 100.0)):
        vector[1 : n + 1] += rng.normal(0.0, size, n)
    return system, state


def accelerations_of(system: System, state: State, scratch: Scratch | None = None) -> Points:
    """(2, n) of the masses, px/s²."""
    a = np.full(state.q.size, 0.0)
    accelerations(system.body, state, scratch or new_scratch(system), state.q, state.v, a)
    return a.reshape(2, -1)[:, 1 : system.body.masses + 1]


def by_the_general_path(system: System) -> System:
    return dataclasses.replace(system, body=system.body.replaced(net=NO_NET))


def is_net(scene: Scene) -> bool:
    return build_system(scene).body.net.present


def torn(scene: Scene, seed: int) -> Scene:
    """The scene without some joints and springs, with some that fit into no run, in another order."""
    rng = np.random.default_rng(seed)
    n, springs, joints = len(scene.masses), scene.linear_springs, scene.angular_springs
    kept = [joint for joint in joints if rng.random() > 0.1]
    hinged = {s for joint in kept for s in (joint.a, joint.b)}
    order = [s for s in range(len(springs)) if s in hinged or rng.random() > 0.04]
    rng.shuffle(order)
    extra = [
        sorted(rng.choice(n, 2, replace=False).tolist(), reverse=bool(rng.integers(2))) for _ in range(3)
    ]
    index = {s: i for i, s in enumerate(order)}
    wild = [
        AngularSpring(a=a, b=b, stiffness=30.0, rest_angle=70.0)
        for a, b in (rng.choice(len(order), 2, replace=False).tolist() for _ in range(2 if joints else 0))
    ]
    numbered = [replace(joint, a=index[joint.a], b=index[joint.b]) for joint in kept]
    rng.shuffle(numbered)
    torn_apart = replace(
        scene, bodies=(), linear_springs=tuple(springs[s] for s in order), angular_springs=tuple(numbered)
    )

    def some(low: float, high: float) -> Callable[..., float]:
        return lambda *_: float(rng.uniform(low, high))

    other = with_springs(torn_apart, stiffness=some(500.0, 5000.0), damping=some(1.0, 9.0))
    other = with_joints(other, stiffness=some(10.0, 90.0), rest_angle=some(-40.0, 40.0))
    extras = tuple(LinearSpring(a=a, b=b, stiffness=300.0, damping=2.0, rest_length=50.0) for a, b in extra)
    return replace(
        other,
        linear_springs=(*other.linear_springs, *extras),
        angular_springs=(*other.angular_springs, *wild),
    )


GRIDS = {
    "cloth": lambda columns, rows: sim.cloth(columns=columns, rows=rows),
    "without diagonals": lambda columns, rows: sim.cloth(columns=columns, rows=rows, diagonals=False),
    "jelly": lambda columns, rows: sim.jelly(columns=columns, rows=rows),
    "flag": lambda columns, rows: sim.flag_pole(columns=columns, rows=rows, masses=rows + 3),
}


@given(
    st.sampled_from(sorted(GRIDS)),
    st.sampled_from(["tutorial", "conservative"]),
    st.integers(8, 20),
    st.integers(3, 12),
    st.integers(0, 10_000),
)
def test_a_net_accelerates_like_any_other_body(
    grid: str, law: ForceLaw, columns: int, rows: int, seed: int
) -> None:
    accelerates_as_any_body(replace(torn(GRIDS[grid](columns, rows), seed), force_law=law), columns)


def accelerates_as_any_body(scene: Scene, seed: int) -> None:
    system, state = moving(scene, seed)
    expected = accelerations_of(by_the_general_path(system), state)
    assert off(accelerations_of(system, state), expected) <= 1e-13


@pytest.mark.parametrize("name", ["ring", "pile", "box", "bridge", "girder", "flag-pole", "jelly", "tree"])
def test_other_bodies_that_are_nets(name: str) -> None:
    """In some, springs in no run are held by joints in one, or not all of one distance are held."""
    near = sim.Contact(distance=1.0)
    for scene in (sim.load_scene(name), replace(sim.load_scene(name), contact=near)):
        for law in ("tutorial", "conservative"):
            accelerates_as_any_body(replace(scene, force_law=law), 3)


def test_what_a_state_leaves_behind_does_not_show_in_the_next() -> None:
    # What is written behind a run, in vectors and rows, must be nobody's at the next state.
    for scene in (sim.cloth(), sim.jelly(), sim.flag_pole(columns=11)):
        system, state = moving(scene, 1)
        assert system.body.net.present
        scratch = new_scratch(system)
        wild = state.copied()
        wild.q[:] *= np.linspace(-1e3, 1e3, wild.q.size)
        accelerations_of(system, wild, scratch)
        wild.q[1 : system.body.masses + 1] = np.nan
        accelerations_of(system, wild, scratch)
        assert np.array_equal(accelerations_of(system, state, scratch), accelerations_of(system, state))


def test_grids_are_nets_however_they_are_listed() -> None:
    cloth = replace(sim.cloth(), bodies=())
    rng = np.random.default_rng(0)
    order = rng.permutation(len(cloth.linear_springs)).tolist()
    shuffled = replace(
        cloth,
        linear_springs=tuple(cloth.linear_springs[s] for s in order),
        angular_springs=tuple(
            replace(joint, a=order.index(joint.a), b=order.index(joint.b))
            for joint in rng.permutation(np.array(cloth.angular_springs, object))
        ),
    )
    for scene in (cloth, shuffled, sim.jelly(), sim.flag_pole(columns=11), sim.bridge()):
        assert is_net(scene)
    for scene in (sim.rope(), sim.tree(), sim.load_scene("triangle"), sim.load_scene("empty")):
        assert not is_net(scene)
