"""Which bodies take the fast paths for chains and rings, in whatever order they are listed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, ArrowKeys, Integrator, LinearSpring, Scene, Simulation
from sim.forces.all import accelerations
from sim.scene.types import ForceLaw, Method
from tests.sim.arrays import Arrays
from tests.sim.builders import built, chain, row
from tests.sim.changes import by, pairs, step_all, with_joints
from tests.sim.inside import general, is_chain, is_ring


def shuffled(scene: Scene, seed: int) -> tuple[Scene, list[int]]:
    """The scene with masses, springs and joints listed in another order, and the new index of each mass."""
    rng = np.random.default_rng(seed)
    masses, linear, angular = (
        rng.permutation(len(part)).tolist()
        for part in (scene.masses, scene.linear_springs, scene.angular_springs)
    )
    new_index = [masses.index(i) for i in range(len(masses))]
    springs = [scene.linear_springs[i] for i in linear]
    joints = [scene.angular_springs[i] for i in angular]
    changed = replace(
        scene,
        bodies=(),
        pose=None,
        masses=tuple(scene.masses[i] for i in masses),
        linear_springs=tuple(replace(s, a=new_index[s.a], b=new_index[s.b]) for s in springs),
        angular_springs=tuple(replace(j, a=linear.index(j.a), b=linear.index(j.b)) for j in joints),
        anchors=tuple(replace(a, mass=new_index[a.mass]) for a in scene.anchors),
    )
    return changed, new_index


def some_chain() -> Scene:
    """A chain each of whose joints has a stiffness and a rest angle of its own, so that a mix-up shows."""
    scene = sim.load_scene("tutorial-3.3")
    return with_joints(scene, stiffness=lambda i, _: 5000.0 + 900.0 * i, rest_angle=lambda i, _: 7.0 * i)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", ["chain", "ring"])
def test_a_chain_or_ring_is_one_in_whatever_order_it_is_listed(kind: str, seed: int) -> None:
    scene = some_chain() if kind == "chain" else ring(11)
    scene = by(scene, "adams", tolerance=1e-7)
    changed, new_index = shuffled(scene, seed)
    one, other = Simulation(scene), Simulation(changed)
    assert (
        (is_chain(other), is_ring(other))
        == (is_chain(one), is_ring(one))
        == (kind == "chain", kind == "ring")
    )
    step_all(20, one, other)
    # Where it begins decides in which order numbers are added.
    assert one.positions == pytest.approx(other.positions[new_index], abs=1e-6)
    found = dict(zip(joint_masses(changed), other.angles, strict=True))
    expected = dict(zip((new_index[m] for m in joint_masses(scene)), one.angles, strict=True))
    assert found == pytest.approx(expected, abs=1e-6)
    rest_angles = [joint.rest_angle for joint in changed.angular_springs]
    assert other.rest_angles == pytest.approx(rest_angles, abs=1e-12)


def test_what_is_not_one_chain_takes_the_general_path() -> None:
    scene = replace(sim.load_scene("tutorial-3.3"), bodies=())
    springs, joints = scene.linear_springs, scene.angular_springs
    assert is_chain(Simulation(replace(scene, angular_springs=joints[:3] + joints[4:])))
    # A ring and a single mass have as many springs as a chain has.
    single = chain([*row(3), (50.0, 50.0)], stiffness=1.0)
    ends = single.linear_springs
    others = {
        "a mass by itself": replace(scene, linear_springs=springs[:-1], angular_springs=joints[:-1]),
        "a spring turned round": replace(scene, linear_springs=(replace(springs[0], a=1, b=0), *springs[1:])),
        "a joint turned round": replace(scene, angular_springs=(replace(joints[0], a=1, b=0), *joints[1:])),
        "a branch": replace(
            scene, linear_springs=(*springs[:-1], replace(springs[-1], a=5)), angular_springs=joints[:-1]
        ),
        "a ring": replace(scene, linear_springs=(*springs, replace(springs[0], a=11, b=0))),
        "a ring and a mass": replace(single, linear_springs=(*ends[:2], replace(ends[2], a=2, b=0))),
    }
    for name, other in others.items():
        assert not is_chain(Simulation(other)), name


@pytest.mark.parametrize("held", [(0,), (9,), (4,), (0, 6), ()])
@pytest.mark.parametrize("method", ["generalized_alpha", "rodas4", "adams"])
def test_a_chain_moves_like_any_other_body(method: Method, held: tuple[int, ...]) -> None:
    # Springs turn and stretch along the chain in loops of its own.
    scene = by(sim.rope(masses=10, angular_damping=2.0), method, dt=0.005, tolerance=1e-8)
    scene = replace(scene, bodies=(), anchors=tuple(Anchor(mass=m) for m in held))
    one, other = Simulation(scene), general(Simulation(scene))
    assert is_chain(one)
    assert not is_chain(other)
    for simulation in (one, other):
        simulation.step(5)
        simulation.grab(3)
        x, y = simulation.positions[3]
        simulation.lead(3, (x + 12.0, y - 8.0))
        simulation.step(30)
        simulation.release(3)
        simulation.step(30)
    start = np.array([mass.position for mass in scene.masses])
    assert np.abs(one.positions - start).max() > 3.0
    assert one.positions == pytest.approx(other.positions, abs=1e-5)
    if method == "generalized_alpha":
        # Newton's method converges as soon on either way, but where rounding decides on one more move.
        assert one.stats().steps == other.stats().steps
        assert one.stats().forces == pytest.approx(other.stats().forces, rel=0.05)


def ring(n: int, **settings: Any) -> Scene:
    """A ring of n masses and as many joints, no two alike, in the middle of a motion."""
    rng = np.random.default_rng(n)
    turns = 2.0 * np.pi * np.arange(n) / n
    positions = np.column_stack((np.cos(turns), np.sin(turns))) * 8.0 * n + rng.uniform(-4.0, 4.0, (n, 2))
    speeds = rng.normal(0.0, 50.0, (n, 2))
    around = [(i, (i + 1) % n) for i in range(n)]
    joints = tuple(
        AngularSpring(a=a, b=b, stiffness=float(rng.uniform(500.0, 900.0)), rest_angle=360.0 / n + a)
        for a, b in around
    )
    return built(
        pairs(positions), around, velocities=pairs(speeds), mass=rng.uniform(0.5, 2.0, n).tolist(),
        stiffness=rng.uniform(2e3, 4e3, n).tolist(), damping=5.0, rest_length=50.0, held=(1,),
        angular_springs=joints, gravity=(0.0, 300.0), air_friction=0.01,
        arrow_keys=ArrowKeys(rest_angle_step=3.0), **settings,
    )  # fmt: skip


@pytest.mark.parametrize("count", [3, 4, 7, 8, 9, 24])
@pytest.mark.parametrize("law", ["conservative", "tutorial", None])
def test_a_ring_is_accelerated_like_any_other_body(law: ForceLaw | None, count: int) -> None:
    scene = ring(count, force_law=law or "conservative")
    if law is None:
        scene = replace(scene, angular_springs=())
    one, other = Arrays(scene), Arrays(scene, general=True)
    assert one.body.ring
    q, v = one.q.copy(), one.v.copy()
    padding = np.setdiff1d(np.arange(q.size), one.here)
    a = np.zeros_like(q)
    accelerations(one.body, one.state, one.scratch, q, v, a)
    expected = other.accelerations(other.q, other.v)
    assert a[one.here] == pytest.approx(expected, rel=1e-12, abs=1e-12 * float(np.abs(expected).max()))
    # Padding must not pass for masses.
    assert not np.array((q, v, a))[:, padding].any()
    assert np.array_equal(q, other.q)
    assert np.array_equal(v, other.v)


@pytest.mark.parametrize("count", [3, 8, 13])
@pytest.mark.parametrize("method", ["velocity_verlet", "rk4", "rodas4", "adams", "generalized_alpha", "auto"])
def test_a_ring_moves_like_any_other_body(method: Method, count: int) -> None:
    scene = ring(count, integrator=Integrator(method=method, dt=0.001, tolerance=1e-7))
    one, other = Simulation(scene), general(Simulation(scene))
    assert is_ring(one)
    assert not is_ring(other)
    for simulation in (one, other):
        simulation.step(5)
        # All rest angles change, also that of the joint between the last spring and the first one.
        simulation.keys = {"right"}
        simulation.step(5)
        simulation.keys = ()
        simulation.step(20)
    start = np.array([mass.position for mass in scene.masses])
    assert np.abs(one.positions - start).max() > 3.0
    assert one.positions == pytest.approx(other.positions, abs=2e-6)


def joint_masses(scene: Scene) -> list[int]:
    """The mass at which each joint holds its springs, in the scene's order of joints."""
    return [scene.linear_springs[joint.a].b for joint in scene.angular_springs]


def test_what_is_not_one_ring_takes_the_general_path() -> None:
    scene = ring(6)
    springs, joints = scene.linear_springs, scene.angular_springs
    assert is_ring(Simulation(replace(scene, angular_springs=joints[:3] + joints[4:])))
    back = [1, 2, 0, 4, 5, 3]
    others = {
        "two rings": replace(
            scene,
            linear_springs=tuple(replace(s, b=b) for s, b in zip(springs, back, strict=True)),
            angular_springs=(joints[0], joints[1], joints[3], joints[4]),
        ),
        "a spring against the others": replace(
            scene, linear_springs=(*springs[:-1], replace(springs[-1], a=0, b=5))
        ),
        "a joint turned round": replace(scene, angular_springs=(replace(joints[0], a=1, b=0), *joints[1:])),
        "a ring with a tail": replace(
            scene, linear_springs=(*springs[:-1], replace(springs[-1], b=2)), angular_springs=joints[:-1]
        ),
        "a spring across": replace(
            scene, linear_springs=(*springs, LinearSpring(a=0, b=3, stiffness=1.0, rest_length=50.0))
        ),
    }
    for name, other in others.items():
        assert not is_ring(Simulation(other)), name
        assert not is_chain(Simulation(other)), name


@pytest.mark.parametrize("kind", ["tutorial", "conservative", "no joints"])
def test_a_chain_of_any_length_is_accelerated_as_on_the_general_path(kind: str) -> None:
    # Its loops do four masses at a time, and another one measures the springs of a long chain.
    law: ForceLaw = "tutorial" if kind == "tutorial" else "conservative"
    rng = np.random.default_rng(1)
    for masses in [*range(2, 42), *range(43, 54)]:
        scene = sim.rope(
            masses, held=(), joints=kind != "no joints", force_law=law, integrator=Integrator(method="auto")
        )
        one, other = Arrays(scene), Arrays(scene, general=True)
        assert one.body.chain and not other.body.chain
        at = one.pairs(one.q) + rng.normal(size=(masses, 2))
        speeds = rng.normal(size=(masses, 2)) * 100.0
        found, expected = (a.accelerations(a.flat(at), a.flat(speeds)) for a in (one, other))
        assert np.abs(found - expected).max() <= 1e-12 * np.abs(expected).max()
