"""What springs and joints do to the masses: laws that hold for any body, and each law by itself."""

from __future__ import annotations

import math
from collections.abc import Callable

import msgspec
import numpy as np
import pytest

import sim
from sim import AngularSpring, Integrator, LinearSpring, Mass, Scene, Simulation
from sim.scene.types import Template
from sim.settings import TEMPLATES
from tests.sim import reference
from tests.sim.builders import chain, row, star, tangle, tutorial_preset, tutorial_rope
from tests.sim.inside import Points, forces_of, general, is_chain, put, spring_forces, system_of

REPLACE = msgspec.structs.replace


def naive_forces(scene: Scene) -> Points:
    body = reference.body_of(scene)
    body.forces()
    return np.array([(p.fx, p.fy) for p in body.points])


def two_springs(v: float, rest: float, template: Template | None = None) -> Scene:
    """Two springs without linear forces, of different lengths, at an angle of v degrees."""
    turn = math.radians(v) + 0.3
    return Scene(
        name="pair",
        masses=(
            Mass(position=(10.0 - 30.0 * math.cos(0.3), 20.0 - 30.0 * math.sin(0.3))),
            Mass(position=(10.0, 20.0)),
            Mass(position=(10.0 + 70.0 * math.cos(turn), 20.0 + 70.0 * math.sin(turn))),
        ),
        linear_springs=(
            LinearSpring(a=0, b=1, stiffness=0.0, rest_length=30.0),
            LinearSpring(a=1, b=2, stiffness=0.0, rest_length=70.0),
        ),
        angular_springs=(AngularSpring(a=0, b=1, stiffness=5.0, rest_angle=rest),),
        template=template,
        force_law="tutorial",
        integrator=Integrator(method="symplectic_euler"),
    )


# ------------------------------------------------------------------------- laws for any body
@pytest.mark.parametrize("seed", range(12))
def test_springs_neither_push_nor_turn_a_body_as_a_whole(seed: int) -> None:
    scene = tangle(seed, masses=4 + seed)
    force, positions = forces_of(scene), np.array([m.position for m in scene.masses])
    torques = positions[:, 0] * force[:, 1] - positions[:, 1] * force[:, 0]
    size = np.abs(force).sum()
    assert np.abs(force.sum(axis=0)).max() <= 1e-13 * size
    assert abs(torques.sum()) <= 1e-13 * size * 300.0
    # Both would also hold if nothing pulled at all.
    assert np.abs(force).max() > 1e4


@pytest.mark.parametrize("seed", range(12))
def test_any_topology_agrees_with_a_sum_over_springs_and_joints(seed: int) -> None:
    scene = tangle(seed + 100, masses=4 + seed)
    expected = naive_forces(scene)
    assert np.abs(forces_of(scene) - expected).max() <= 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("arms", [3, 6, 9])
def test_many_springs_and_joints_at_one_mass(arms: int) -> None:
    scene = star(arms)
    simulation = Simulation(scene)
    body = system_of(simulation).body
    # The common case has one slot for each; the others must have gone to the lists.
    assert body.more_spring.size >= arms - 2
    assert body.more_joint.size > 0
    expected = naive_forces(scene)
    assert np.abs(spring_forces(simulation) - expected).max() <= 1e-12 * np.abs(expected).max()


def test_preset_with_a_hub_uses_the_lists() -> None:
    scene = tutorial_preset("hair-tuft")
    simulation = Simulation(scene)
    assert system_of(simulation).body.more_joint.size > 0
    assert system_of(simulation).body.more_spring.size > 0
    rng = np.random.default_rng(3)
    positions = simulation.positions + rng.normal(0.0, 5.0, simulation.positions.shape)
    put(simulation, positions)
    body = reference.body_of(scene)
    for point, (x, y) in zip(body.points, positions.tolist(), strict=True):
        point.x, point.y = x, y
    body.forces()
    expected = np.array([(p.fx, p.fy) for p in body.points])
    assert np.abs(spring_forces(simulation) - expected).max() <= 1e-12 * np.abs(expected).max()


# ------------------------------------------------------------------------- each law by itself
def test_linear_springs_are_minus_the_gradient_of_their_energy() -> None:
    scene = REPLACE(tangle(5, damping=0.0), angular_springs=())
    simulation = Simulation(scene)
    positions = simulation.positions

    def energy(at: Points) -> float:
        return sum(
            0.5 * s.stiffness * (math.dist(at[s.a], at[s.b]) - s.rest_length) ** 2
            for s in scene.linear_springs
        )

    step = 1e-4
    gradient = np.zeros_like(positions)
    for index in np.ndindex(*positions.shape):
        shift = np.zeros_like(positions)
        shift[index] = step
        gradient[index] = (energy(positions + shift) - energy(positions - shift)) / (2.0 * step)
    assert np.abs(spring_forces(simulation) + gradient).max() <= 1e-7 * np.abs(gradient).max()


def test_damping_opposes_only_the_rate_of_stretching() -> None:
    positions = [(0.0, 0.0), (6.0, 8.0)]
    turning = chain(positions, damping=3.0, velocities=[(0.0, 0.0), (-8.0, 6.0)])
    assert np.abs(forces_of(turning)).max() <= 1e-13
    stretching = chain(positions, damping=3.0, velocities=[(0.0, 0.0), (6.0, 8.0)])
    assert forces_of(stretching) == pytest.approx(np.array([[18.0, 24.0], [-18.0, -24.0]]), rel=1e-13)


@pytest.mark.parametrize("v", [-170.0, -90.0, -31.0, 0.0, 12.0, 100.0, 180.0])
@pytest.mark.parametrize("rest", [-135.0, -20.0, 0.0, 77.0, 180.0])
def test_couple_on_each_spring(v: float, rest: float) -> None:
    scene = two_springs(v, rest)
    force, positions = forces_of(scene), np.array([m.position for m in scene.masses])
    expected = 5.0 * 30.0 * 70.0 * math.sin(math.radians(v - rest))
    for end, torque in ((0, expected), (2, -expected)):
        arm = positions[end] - positions[1]
        assert arm[0] * force[end][1] - arm[1] * force[end][0] == pytest.approx(torque, rel=1e-12, abs=1e-10)
        # All of it is turning, nothing is pulling.
        assert abs(arm @ force[end]) <= 1e-10 * (1.0 + np.abs(force).max())


@pytest.mark.parametrize("template", TEMPLATES)
def test_templates_are_the_general_law_and_the_diagonal_ones_are_stronger(
    template: Template,
) -> None:
    factor = math.sqrt(2.0) if template in (135, 45, -45, -135) else 1.0
    for v in (-150.0, -45.0, 10.0, 60.0, 135.0):
        of_template = forces_of(two_springs(v, float(template), template))
        of_law = forces_of(two_springs(v, float(template)))
        assert of_template == pytest.approx(factor * of_law, rel=1e-12, abs=1e-10)
        body = reference.body_of(two_springs(v, float(template)))
        body.law = reference.TEMPLATE_LAWS[template]
        body.forces()
        own = np.array([(p.fx, p.fy) for p in body.points])
        assert of_template == pytest.approx(own, rel=1e-12, abs=1e-10)


@pytest.mark.parametrize("path", [lambda s: s, general], ids=["chain", "general"])
@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, 1.0)])
def test_straight_rope_without_gravity_stays_straight_and_still(
    path: Callable[[Simulation], Simulation], direction: tuple[float, float]
) -> None:
    scene = tutorial_rope(masses=9, direction=direction, gravity=(0.0, 0.0), held=(), driven=None)
    simulation = path(Simulation(scene))
    start = simulation.positions
    simulation.step(4000)
    assert np.abs(simulation.positions - start).max() <= 1e-9
    assert np.abs(simulation.velocities).max() <= 1e-9


def test_rest_length_scale_stretches_every_spring() -> None:
    scene = REPLACE(chain(row(3), stiffness=7.0, rest_length=10.0), rest_length_scale=1.5)
    assert forces_of(scene) == pytest.approx(np.array([[-35.0, 0.0], [0.0, 0.0], [35.0, 0.0]]), abs=1e-12)


# ------------------------------------------------------------------------- one step
def test_one_step_with_air_gravity_and_mass() -> None:
    scene = REPLACE(
        chain(
            row(2, 12.0), stiffness=50.0, velocities=[(3.0, -4.0), (0.0, 0.0)], dt=0.01, gravity=(5.0, 9.0),
            mass=2.0,
        ),
        air_friction=0.1,
    )  # fmt: skip
    simulation = Simulation(scene)
    simulation.step()
    # Spring: 50 * (12 - 10) = 100 towards the other mass; air: -0.1 v|v|; both over 2 kg.
    expected = np.array(
        [
            (3.0 + 0.01 * ((100.0 - 0.1 * 9.0) / 2.0 + 5.0), -4.0 + 0.01 * (0.1 * 16.0 / 2.0 + 9.0)),
            (0.01 * (-100.0 / 2.0 + 5.0), 0.01 * 9.0),
        ]
    )
    assert simulation.velocities == pytest.approx(expected, rel=1e-13)
    assert simulation.positions == pytest.approx(np.array(row(2, 12.0)) + 0.01 * expected, rel=1e-13)


# ------------------------------------------------------------------------- the leaner branches
TINY = 1e-300
"""So small that it changes no sum, yet not zero, so that the branch with that force is taken."""


def with_tiny_damping(scene: Scene) -> Scene:
    return REPLACE(scene, linear_springs=tuple(REPLACE(s, damping=TINY) for s in scene.linear_springs))


def without_damping(scene: Scene) -> Scene:
    return REPLACE(scene, linear_springs=tuple(REPLACE(s, damping=0.0) for s in scene.linear_springs))


def with_idle_joints(scene: Scene) -> Scene:
    return REPLACE(scene, angular_springs=tuple(REPLACE(j, stiffness=0.0) for j in scene.angular_springs))


def bodies() -> list[Scene]:
    rope = REPLACE(sim.load_scene("tutorial-3.3"), bodies=())
    lying = [(300.0 + 25.0 * i, 200.0 + 8.0 * (i % 3)) for i in range(len(rope.masses))]
    masses = tuple(REPLACE(m, position=p) for m, p in zip(rope.masses, lying, strict=True))
    return [
        REPLACE(rope, masses=masses),
        REPLACE(tangle(8, dt=2e-4), gravity=(0.0, 2000.0), air_friction=0.01),
    ]


@pytest.mark.parametrize("scene", bodies(), ids=["chain", "general"])
@pytest.mark.parametrize("joints", [True, False], ids=["joints", "no joints"])
@pytest.mark.parametrize("damped", [True, False], ids=["damped", "undamped"])
@pytest.mark.parametrize("air", [True, False], ids=["air", "no air"])
@pytest.mark.parametrize("gravity", [True, False], ids=["gravity", "no gravity"])
def test_leaner_branches_agree_with_the_full_ones(
    scene: Scene, joints: bool, damped: bool, air: bool, gravity: bool
) -> None:
    lean = rich = scene
    if not joints:
        lean, rich = REPLACE(lean, angular_springs=()), with_idle_joints(rich)
    if not damped:
        lean, rich = without_damping(lean), with_tiny_damping(rich)
    if not air:
        lean, rich = REPLACE(lean, air_friction=0.0), REPLACE(rich, air_friction=TINY)
    if not gravity:
        lean, rich = REPLACE(lean, gravity=(0.0, 0.0)), REPLACE(rich, gravity=(0.0, TINY))
    one, other, naive = Simulation(lean), Simulation(rich), reference.body_of(lean)
    assert is_chain(one) == is_chain(other) == (scene.name != "tangle")
    one.step(150)
    other.step(150)
    for _ in range(150):
        naive.step()
    assert np.abs(one.positions - other.positions).max() <= 1e-9
    assert np.abs(one.positions - np.array(naive.positions())).max() <= 1e-8
    start = np.array([mass.position for mass in scene.masses])
    assert np.abs(one.positions - start).max() > 0.1
