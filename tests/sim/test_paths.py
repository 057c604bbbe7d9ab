"""Which bodies take the fast path for chains, in whatever order they are listed."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from sim import Anchor, Integrator, Scene, Simulation
from sim.scene import Method
from tests.sim.builders import chain, row
from tests.sim.inside import general, is_chain

REPLACE = msgspec.structs.replace


def shuffled(scene: Scene, seed: int) -> tuple[Scene, list[int]]:
    """The scene with masses, springs and joints listed in another order, and each old mass's new place."""
    rng = np.random.default_rng(seed)
    masses, linear, angular = (
        rng.permutation(len(part)).tolist()
        for part in (scene.masses, scene.linear_springs, scene.angular_springs)
    )
    place = [masses.index(i) for i in range(len(masses))]
    springs = [scene.linear_springs[i] for i in linear]
    joints = [scene.angular_springs[i] for i in angular]
    changed = REPLACE(
        scene,
        rope=None,
        pose=None,
        masses=tuple(scene.masses[i] for i in masses),
        linear_springs=tuple(REPLACE(s, a=place[s.a], b=place[s.b]) for s in springs),
        angular_springs=tuple(REPLACE(j, a=linear.index(j.a), b=linear.index(j.b)) for j in joints),
        anchors=tuple(REPLACE(a, mass=place[a.mass]) for a in scene.anchors),
    )
    return changed, place


@pytest.mark.parametrize("seed", range(4))
def test_a_chain_is_a_chain_in_whatever_order_it_is_listed(seed: int) -> None:
    scene = sim.set_value(sim.load_scene("tutorial-3.2"), "template", 45)
    # Each angular spring gets a stiffness of its own, so that a mix-up shows.
    joints = tuple(REPLACE(j, stiffness=5000.0 + 900.0 * i) for i, j in enumerate(scene.angular_springs))
    scene = REPLACE(scene, rope=None, angular_springs=joints)
    changed, place = shuffled(scene, seed)
    one, other = Simulation(scene), Simulation(changed)
    assert is_chain(one)
    assert is_chain(other)
    one.step(300)
    other.step(300)
    assert np.array_equal(one.positions, other.positions[place])
    assert sorted(one.angles) == sorted(other.angles)


@pytest.mark.parametrize("seed", range(4))
def test_angles_are_told_in_the_order_of_the_scenes_joints(seed: int) -> None:
    scene = REPLACE(sim.load_scene("tutorial-3.3"), rope=None)
    joints = tuple(REPLACE(j, rest_angle=7.0 * i) for i, j in enumerate(scene.angular_springs))
    changed, _ = shuffled(REPLACE(scene, angular_springs=joints), seed)
    simulation = Simulation(changed)
    expected = [joint.rest_angle for joint in changed.angular_springs]
    assert simulation.rest_angles == pytest.approx(expected, abs=1e-12)
    # Without gravity it settles with every joint at its rest angle, so each has a present angle of its own.
    simulation.replace(REPLACE(changed, gravity=(0.0, 0.0)))
    simulation.step(40_000)
    assert simulation.angles == pytest.approx(expected, abs=0.1)


def test_what_is_not_one_chain_takes_the_general_path() -> None:
    scene = REPLACE(sim.load_scene("tutorial-3.3"), rope=None)
    springs, joints = scene.linear_springs, scene.angular_springs
    assert is_chain(Simulation(REPLACE(scene, angular_springs=joints[:3] + joints[4:])))
    others = [
        REPLACE(scene, linear_springs=springs[:-1], angular_springs=joints[:-1]),  # a mass by itself
        REPLACE(scene, linear_springs=(REPLACE(springs[0], a=1, b=0), *springs[1:])),  # against the others
        REPLACE(scene, angular_springs=(REPLACE(joints[0], a=1, b=0), *joints[1:])),  # turned round
        REPLACE(scene, linear_springs=(*springs[:-1], REPLACE(springs[-1], a=5))),  # a branch
        REPLACE(scene, linear_springs=(*springs, REPLACE(springs[0], a=11, b=0))),  # a ring
    ]
    for other in others[:3] + others[4:]:
        assert not is_chain(Simulation(other))
    branch = REPLACE(others[3], angular_springs=joints[:-1])
    assert not is_chain(Simulation(branch))
    # A ring and a single mass have as many springs as a chain has.
    ring = chain([*row(3), (50.0, 50.0)], stiffness=1.0)
    ring = REPLACE(ring, linear_springs=(*ring.linear_springs[:2], REPLACE(ring.linear_springs[2], a=2, b=0)))
    assert not is_chain(Simulation(ring))


@pytest.mark.parametrize("held", [(0,), (9,), (4,), (0, 6), ()])
@pytest.mark.parametrize("method", ["generalized_alpha", "rodas4", "adams"])
def test_a_chain_moves_like_any_other_body(method: Method, held: tuple[int, ...]) -> None:
    # Springs turn and stretch along the chain in loops of its own.
    scene = sim.rope(
        masses=10,
        angular_damping=2.0,
        force_law="conservative",
        integrator=Integrator(method=method, dt=0.005, tolerance=1e-8),
    )
    scene = REPLACE(scene, rope=None, anchors=tuple(Anchor(mass=m) for m in held))
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
        # Where they are must not depend on the way, but how soon Newton's method is there does.
        assert one.effort() == other.effort()
