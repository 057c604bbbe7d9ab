"""Rest lengths and rest angles that keep a pose, against forces and a linear program made another way."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace
from numpy.typing import NDArray
from scipy.optimize import linprog

import sim
from sim.analysis.equilibrium import StaticModel
from sim.design.keep_shape import keep_shape_at
from sim.edit.edit import Selection
from sim.forces.reference import Physics
from sim.scene.makers import fine_rope
from sim.scene.types import Damage
from tests.amount import part_of
from tests.sim.bodies import LAWS, SHAPES, body
from tests.sim.builders import PRESETS, built
from tests.sim.changes import posed, with_joints, with_masses, with_springs
from tests.sim.checks import jacobian, known

HANGING = {
    "air-balloon", "box", "buggy", "bungee", "cart", "cradle", "crane", "hopper", "jelly", "kapitza",
    "knee", "lesson-catenary", "lesson-chaos", "lesson-explosion", "octagon", "pendulum", "pile", "rope",
    "stick-slip", "triangle", "water-balloon",
}  # fmt: skip
"""Presets whose first pose nothing can keep: they hang by one mass, have no joints, roll, or fly."""
MOVED = {"lesson-resonance"}
"""Presets with a mass that is led."""


def net_force(scene: sim.Scene) -> float:
    """The largest force on a free mass at rest in the scene's pose, relative to the largest load."""
    body = StaticModel(scene, balanced=False)
    place = body.system.mass_index
    x = np.zeros(body.slots, complex)
    assert scene.pose is not None
    x[place] = np.array(scene.pose.positions) @ (1.0, 1.0j)
    acceleration = Physics(body.tables, body.state).accelerations(x, np.zeros_like(x))[place]
    masses = np.array([mass.mass for mass in scene.masses])
    load = max(
        math.hypot(*scene.gravity) * masses.max(), *(abs(complex(*(m.force or (0, 0)))) for m in scene.masses)
    )
    return float(np.abs(masses * acceleration).max()) / (load or 1.0)


def drift(scene: sim.Scene, seconds: float = 10.0) -> float:
    """How far a mass gets, relative to the size of the body."""
    wind = scene.wind and replace(scene.wind, turbulence=0.0)
    fine = replace(scene, wind=wind, integrator=sim.Integrator(method="auto", tolerance=1e-6))
    simulation = sim.Simulation(fine)
    before = simulation.positions.copy()
    simulation.advance(seconds)
    return float(np.abs(simulation.positions - before).max() / np.ptp(before, axis=0).max())


def at_rest(scene: sim.Scene) -> sim.Scene:
    return with_masses(scene, velocity=(0.0, 0.0))


# ------------------------------------------------------------------------- what can be kept
@pytest.mark.parametrize("name", PRESETS)
def test_presets_stand_as_they_were_drawn(name: str) -> None:
    scene = replace(sim.load_scene(name), pose=None)
    if len(scene.masses) > 200:
        return
    if name in HANGING:
        with pytest.raises(sim.DesignError, match=r"nothing (holds|keeps)|it would buckle|would need"):
            sim.keep_shape(scene)
        return
    kept = sim.keep_shape(scene)
    assert net_force(kept) <= 1e-9
    assert [spring.stiffness for spring in kept.linear_springs] == [s.stiffness for s in scene.linear_springs]
    if name not in MOVED and len(scene.masses) > 1:
        assert drift(kept) <= 1e-6


@pytest.mark.parametrize("seed", part_of(range(200), 4))
def test_random_bodies_are_kept_or_a_linear_program_agrees_that_nothing_keeps_them(seed: int) -> None:
    rng = np.random.default_rng(seed)
    shape, law = list(SHAPES)[seed % 7], LAWS[seed % 3]
    count = len(SHAPES[shape]()[0])
    held = tuple(rng.choice(count, rng.integers(1, 4), replace=False).tolist())
    gravity = tuple((10.0 ** rng.uniform(1.0, 4.0) * rng.uniform(-1.0, 1.0, 2)).tolist())
    scene = at_rest(body(shape, law, seed, gravity=gravity, held=held))
    try:
        kept = sim.keep_shape(scene)
    except sim.DesignError as error:
        if "buckle" not in str(error):
            assert could_be_kept(scene) > 1.0, str(error)
        return
    assert net_force(kept) <= 1e-10
    assert drift(kept) <= 1e-6


def could_be_kept(scene: sim.Scene) -> float:
    """The least factor of stiffness with which forces of springs and joints could balance gravity, infinite
    where no such forces do.

    By virtual work: the force on a mass is minus the tension times the derivative of a spring's length, and
    minus the torque times that of a joint's angle. The derivatives are found by differences.
    """
    at = np.array([mass.position for mass in scene.masses])
    free = np.setdiff1d(np.arange(len(at)), [anchor.mass for anchor in scene.anchors])

    def measures(places: NDArray[np.float64]) -> NDArray[np.float64]:
        vectors = [complex(*(places[s.b] - places[s.a])) for s in scene.linear_springs]
        angles = [np.angle(vectors[j.b] / vectors[j.a]) for j in scene.angular_springs]
        return np.array([*map(abs, vectors), *angles])

    start, springs = measures(at), len(scene.linear_springs)

    def turned(places: NDArray[np.float64]) -> NDArray[np.float64]:
        change = measures(places.reshape(-1, 2)) - start
        change[springs:] = np.angle(np.exp(1j * change[springs:]))
        return change

    moving = [2 * mass + axis for mass in free.tolist() for axis in (0, 1)]
    pull_by_place = -jacobian(turned, at.ravel(), 1e-4, moving).T
    lengths = start[:springs]
    pulls = [spring.stiffness * length for spring, length in zip(scene.linear_springs, lengths, strict=True)]
    bent = math.radians(60.0) if scene.force_law == "angle" else math.sin(math.radians(60.0))
    turns = [bent * j.stiffness * lengths[j.a] * lengths[j.b] for j in scene.angular_springs]
    most = np.array([*pulls, *turns])
    loads = [
        mass.mass * g + f
        for mass in (scene.masses[i] for i in free)
        for g, f in zip(scene.gravity, mass.force or (0.0, 0.0), strict=True)
    ]
    scale = max(map(abs, loads), default=0.0) or 1.0
    balance = pull_by_place.reshape(len(loads), most.size) * most / scale
    ones = np.ones((most.size, 1))
    down = np.eye(most.size)[len(pulls) :]
    result = linprog(
        [*np.zeros(most.size), 1.0],
        A_ub=np.block([[np.eye(most.size), -ones], [-down, -ones[len(pulls) :]]]),
        b_ub=np.zeros(most.size + len(turns)),
        A_eq=np.hstack((balance, np.zeros((len(loads), 1)))),
        b_eq=-np.array(loads) / scale,
        bounds=[(None, None)] * most.size + [(0.0, None)],
    )
    return float(result.fun) if result.success else math.inf


def test_on_the_floor_masses_sink_as_deep_as_they_must() -> None:
    scene = replace(sim.load_scene("jelly"), pose=None)
    floor = next(wall.point[1] for wall in scene.walls if wall.normal == (0.0, -1.0))
    low = max(mass.position[1] for mass in scene.masses)
    scene = with_masses(scene, position=lambda _, m: (m.position[0], m.position[1] + floor - low))
    kept, masses = sim.keep_shape(scene), scene.masses
    sunk = np.array(known(kept.pose).positions) - [mass.position for mass in masses]
    at_floor = np.array([mass.position[1] for mass in masses]) > floor - 1e-9
    # The floor's pushes bear the whole weight.
    push = sum(mass.mass * 8000.0 * depth**2 for mass, depth in zip(masses, sunk[:, 1], strict=True))
    assert push == pytest.approx(sum(mass.mass for mass in masses) * 1000.0, rel=1e-9)
    assert np.abs(sunk[~at_floor]).max() == 0.0
    assert np.abs(sunk[:, 0]).max() == 0.0
    assert net_force(kept) <= 1e-10
    assert drift(kept) <= 1e-6


@pytest.mark.parametrize("masses", [100, 1000])
def test_long_rods_are_kept_to_rounding(masses: int) -> None:
    """The stiffnesses of a fine rod are large beside the weights of its masses."""
    scene = fine_rope(masses, gravity=(0.0, 1000.0))
    clamped = (sim.Anchor(mass=0), sim.Anchor(mass=1))
    kept = sim.keep_shape(replace(scene, bodies=(), links=(), anchors=clamped))
    body = StaticModel(kept, balanced=False)
    assert (np.abs(body.accelerations(body.start)) <= body.rounding(body.start)).all()
    assert drift(kept, 1.0) <= 1e-6


def test_mean_wind_and_loads_are_balanced_too() -> None:
    scene = sim.load_scene("flag-pole")
    assert scene.wind is not None
    assert scene.air_friction > 0.0
    masses = list(scene.masses)
    masses[-1] = replace(masses[-1], force=(300.0, -200.0))
    scene = replace(scene, bodies=(), links=(), masses=tuple(masses), pose=None)
    kept = sim.keep_shape(scene)
    still = replace(kept.wind, turbulence=0.0)  # type: ignore[type-var]
    assert net_force(replace(kept, wind=still)) <= 1e-10
    assert drift(kept) <= 1e-6


def test_what_has_yielded_and_what_keys_have_changed_stays_so() -> None:
    scene = sim.load_scene("rod")
    springs, joints = len(scene.linear_springs), len(scene.angular_springs)
    damage = Damage(set_lengths=(2.0,) * springs, hardened=(0.0,) * springs, set_angles=(-3.0,) * joints)
    scene = with_springs(with_joints(scene, yield_torque=1e12), yield_force=1e9)
    kept = sim.keep_shape(posed(replace(scene, rest_length_scale=1.1), damage=damage))
    assert known(kept.pose).damage == damage
    assert kept.rest_length_scale == 1.1
    assert net_force(kept) <= 1e-10
    assert drift(kept) <= 1e-6


def test_at_a_moment_what_held_keys_have_changed_is_counted_in() -> None:
    scene = sim.load_scene("tutorial-3.3")
    clamped = replace(scene, bodies=(), links=(), anchors=(sim.Anchor(mass=0), sim.Anchor(mass=1)))
    simulation = sim.Simulation(clamped)
    simulation.keys = {"right", "up"}
    simulation.advance(0.1)
    simulation.keys = set()
    moment = simulation.capture()
    assert moment.rest_angle_shift != 0.0
    assert moment.rest_length_scale != 1.0
    rows = moment.rows.copy()
    rows[2:] = 0.0
    kept = keep_shape_at(moment)
    simulation.restore(dataclasses.replace(moment, scene=kept, rows=rows))
    before = simulation.positions.copy()
    simulation.advance(5.0)
    assert np.abs(simulation.positions - before).max() < 1e-3


def test_only_what_is_chosen_changes() -> None:
    scene = with_joints(at_rest(body("girder", seed=3, held=(0, 1))), stiffness=5.0)
    chosen = Selection(springs=frozenset(range(len(scene.linear_springs))))
    kept = sim.keep_shape(scene, chosen)
    assert kept.angular_springs == scene.angular_springs
    assert net_force(kept) <= 1e-10
    one = Selection(springs=frozenset({0}))
    with pytest.raises(sim.DesignError, match="what is selected cannot balance mass"):
        sim.keep_shape(scene, one)


# ------------------------------------------------------------------------- what cannot be kept
def test_refusals_name_the_part_and_show_the_motion() -> None:
    box = replace(sim.load_scene("box"), pose=None)
    said = "nothing keeps it from turning about mass 0: hold a second mass or add a joint"
    with pytest.raises(sim.DesignError, match=said) as turning:
        sim.keep_shape(box)
    motion = known(turning.value.motion)
    arms = np.array([mass.position for mass in box.masses]) - box.masses[0].position
    turned = np.column_stack((-arms[:, 1], arms[:, 0])) / np.hypot(*arms.T).max()
    assert np.abs(motion - math.copysign(1.0, motion[1] @ turned[1]) * turned).max() < 1e-6
    with pytest.raises(sim.DesignError, match="nothing holds mass"):
        sim.keep_shape(replace(box, bodies=(), links=(), anchors=()))


def test_a_joint_that_bears_too_much_is_named_with_the_stiffness_that_it_needs() -> None:
    """A weight at the end of a rod of one joint: its torque is the weight times the arm."""
    places, joint = [(100.0 * i, 0.0) for i in range(3)], {"stiffness": 5.0}
    scene = built(places, stiffness=1e4, joint=joint, held=(0, 1), gravity=(0.0, 1000.0))
    factor = 1000.0 * 100.0 / (5.0 * 100.0 * 100.0 * math.sin(math.radians(60.0)))
    with pytest.raises(
        sim.DesignError, match=f"joint 0 would need {factor:.3g} times its stiffness"
    ) as error:
        sim.keep_shape(scene)
    assert error.value.stiffening == pytest.approx(factor, rel=1e-9)
    kept = sim.keep_shape(scene, allow_stiffening=True)
    assert kept.angular_springs[0].stiffness == pytest.approx(5.0 * factor, rel=1e-9)
    assert net_force(kept) <= 1e-10
    assert drift(kept) <= 1e-6


def column(stiffness: float, weight: float) -> sim.Scene:
    """A mast of five springs that is held by its lowest two masses, with a weight on top."""
    places, mass = [(0.0, -40.0 * i) for i in range(6)], [*[1e-3] * 5, weight]
    springs: dict[str, Any] = {"stiffness": 1e6, "damping": 1.0}
    joint = {"stiffness": stiffness}
    return built(places, mass=mass, **springs, joint=joint, held=(0, 1), gravity=(0.0, 1000.0))


def test_a_mast_buckles_at_eulers_load_and_stands_with_the_stiffness_that_is_named() -> None:
    """A clamped chain of n rigid links of length l with hinges of stiffness c bears
    2 (1 - cos(pi / (2 n + 1))) c / l: the lowest eigenvalue of its matrix of second differences."""
    hinge, length = 20.0 * 40.0 * 40.0, 40.0
    bears = 2.0 * (1.0 - math.cos(math.pi / 9.0)) * hinge / length / 1000.0  # kg
    assert drift(sim.keep_shape(column(20.0, 0.97 * bears)), 2.0) <= 1e-6
    with pytest.raises(
        sim.DesignError, match=r"it would buckle at mass 5; with .* times the stiffness it stands"
    ) as no:
        sim.keep_shape(column(20.0, 1.5 * bears))
    assert no.value.stiffening == pytest.approx(1.5, rel=0.03)
    motion = known(no.value.motion)
    assert np.abs(motion[:2]).max() == 0.0
    assert np.abs(motion[2:, 1]).max() < 1e-6
    assert (np.diff(np.abs(motion[1:, 0])) > 0.0).all()
    stands = sim.keep_shape(column(20.0, 1.5 * bears), allow_stiffening=True)
    assert stands.angular_springs[0].stiffness == pytest.approx(20.0 * (no.value.stiffening or 0.0))
    assert net_force(stands) <= 1e-10
