"""Springs and joints in runs exert the forces that they exert one by one."""

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
from sim.compiling.compiler import fetch, for_forces
from sim.engine.tables import Scratch, State
from sim.forces.all import accelerations
from sim.forces.reference import Physics
from sim.model.state import new_scratch, start_of
from sim.model.system import System, build_system
from sim.scene.types import ForceLaw
from studies.bench.kernels import without_runs
from tests.sim.arrays import off
from tests.sim.bodies import LAWS
from tests.sim.changes import by, with_joints, with_springs

Points = np.ndarray


def moving(scene: Scene, seed: int) -> tuple[System, State]:
    """The tables of a scene without air, and a state in which every mass is near its place and moves.

    By a method with a fixed step, which softens nothing.
    """
    scene = replace(by(scene, "symplectic_euler"), air_friction=0.0)
    system, state = start_of(scene, build_system(scene))
    rng, n = np.random.default_rng(seed), system.body.masses
    for vector, size in ((state.x, 3.0), (state.y, 3.0), (state.vx, 100.0), (state.vy, 100.0)):
        vector[1 : n + 1] += rng.normal(0.0, size, n)
    return system, state


def accelerations_of(system: System, state: State, scratch: Scratch | None = None) -> Points:
    """(2, n) of the masses, px/s²."""
    fetch((*for_forces(system.body), "accelerations"))
    a = np.full(state.q.size, 0.0)
    accelerations(system.body, state, scratch or new_scratch(system), state.q, state.v, a)
    return a.reshape(2, -1)[:, 1 : system.body.masses + 1]


def by_physics(system: System, state: State) -> Points:
    """(2, n) the same by NumPy."""
    x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
    a = Physics(system.body, state).accelerations(x, v)[1 : system.body.masses + 1]
    return np.stack((a.real, a.imag))


def in_runs(scene: Scene) -> float:
    """The part of a scene's springs and joints that are in runs."""
    body = build_system(scene).body
    found = body.held.loose + (body.free.loose - body.hinged) + body.bends.loose
    return found / (body.springs + body.joints)


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
    st.sampled_from(LAWS),
    st.booleans(),
    st.integers(8, 20),
    st.integers(3, 12),
    st.integers(0, 10_000),
)
def test_a_net_accelerates_as_it_should(
    grid: str, law: ForceLaw, damped: bool, columns: int, rows: int, seed: int
) -> None:
    scene = replace(torn(GRIDS[grid](columns, rows), seed), force_law=law)
    accelerates_as_it_should(with_joints(scene, damping=0.7) if damped else scene, columns)


def accelerates_as_it_should(scene: Scene, seed: int) -> None:
    """By NumPy's sums, in runs and with all springs and joints one by one."""
    system, state = moving(scene, seed)
    assert off(accelerations_of(system, state), by_physics(system, state)) <= 1e-13
    system = dataclasses.replace(system, body=without_runs(system.body))
    assert off(accelerations_of(system, state), by_physics(system, state)) <= 1e-13


@pytest.mark.parametrize("name", ["ring", "pile", "box", "bridge", "girder", "flag-pole", "jelly", "tree"])
def test_other_bodies_with_runs(name: str) -> None:
    """In some, springs in no run are held by joints in one, or not all of one distance are held."""
    near = sim.Contact(distance=1.0)
    for scene in (sim.load_scene(name), replace(sim.load_scene(name), contact=near)):
        for law in LAWS:
            accelerates_as_it_should(replace(scene, force_law=law), 3)


def test_what_a_state_leaves_behind_does_not_show_in_the_next() -> None:
    # What is written behind a run, in vectors and rows, must be nobody's at the next state.
    for scene in (sim.cloth(), sim.jelly(), sim.flag_pole(columns=11)):
        system, state = moving(scene, 1)
        assert in_runs(scene) > 0.5
        scratch = new_scratch(system)
        wild = state.copied()
        wild.q[:] *= np.linspace(-1e3, 1e3, wild.q.size)
        accelerations_of(system, wild, scratch)
        wild.q[1 : system.body.masses + 1] = np.nan
        accelerations_of(system, wild, scratch)
        assert np.array_equal(accelerations_of(system, state, scratch), accelerations_of(system, state))


def test_grids_are_in_runs_however_they_are_listed() -> None:
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
        assert in_runs(scene) > 0.75
    assert in_runs(sim.rope()) == 1.0
    assert in_runs(sim.tree()) < 0.25
