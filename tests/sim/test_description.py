"""Descriptions of bodies, against readings of their own from positions and velocities."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim.analysis.description import Motion, describe
from sim.analysis.part_description import describe_joint, describe_mass, describe_spring
from sim.store.files import list_scenes
from tests.amount import part_of
from tests.sim.bodies import body
from tests.sim.fuzzing import wild_scene

PRESETS = [info.name for info in list_scenes() if info.built_in]


def moving(simulation: sim.Simulation, masses: Sequence[int]) -> dict[str, float]:
    """What can be read from places and velocities of some masses alone."""
    scene, some = simulation.scene, list(masses)
    x, v = simulation.positions[some], simulation.velocities[some]
    mass = np.array([scene.masses[m].mass for m in some])
    centre, drift = mass @ x / mass.sum(), mass @ v / mass.sum()
    arm, rate = x - centre, v - drift
    down = 1.0 if scene.view.y_down else -1.0
    spin = float((mass * (arm[:, 0] * rate[:, 1] - arm[:, 1] * rate[:, 0])).sum())
    inertia = float((mass * (arm**2).sum(1)).sum())
    read = {
        "speed": float(np.hypot(*v.T).max()),
        "drift": float(np.hypot(*drift)),
        "turning": -down * spin / inertia if inertia > 0.0 else 0.0,
    }
    held = [some.index(anchor.mass) for anchor in scene.anchors if anchor.mass in some]
    if held:
        read["hangs"] = float((down * x[:, 1]).max() - (down * x[held, 1]).min())
    return read


def strains(simulation: sim.Simulation) -> tuple[float, float]:
    """The largest and the smallest strain of a spring; 0 without any."""
    scene, x = simulation.scene, simulation.positions
    ends = np.array([[spring.a, spring.b] for spring in scene.linear_springs], int).reshape(-1, 2)
    rest = np.array([spring.rest_length for spring in scene.linear_springs]) * simulation.rest_length_scale
    strain = np.hypot(*(x[ends[:, 1]] - x[ends[:, 0]]).T) / rest - 1.0
    return float(strain.max(initial=0.0)), float(strain.min(initial=0.0))


def told(motion: Motion) -> dict[str, float]:
    """The same as it is described."""
    said = {"speed": motion.speed, "drift": math.hypot(*motion.drift), "turning": motion.turning}
    return said if motion.hangs is None else said | {"hangs": motion.hangs}


@pytest.mark.parametrize("name", part_of(PRESETS, 4))
def test_each_number_is_within_two_percent_of_one_s_own_reading(name: str) -> None:
    scene = sim.load_scene(name)
    simulation = sim.Simulation(scene)
    simulation.step(60)
    found = describe(simulation, scene)
    left, low, right, high = found.box
    assert (right - left, high - low) == pytest.approx(np.ptp(simulation.positions, axis=0), rel=0.02)
    everything = range(len(scene.masses))
    for masses, motion in (
        (everything, found.motion),
        *((each.masses, each.motion) for each in found.pieces),
    ):
        assert told(motion) == pytest.approx(moving(simulation, masses), rel=0.02, abs=1e-6)
        assert {motion.fastest, motion.lowest} <= set(masses)
    muscular = any(part.muscle for part in (*scene.linear_springs, *scene.angular_springs))
    if not muscular and found.yielded == found.broken == 0:
        for pair, strain in zip((found.stretched, found.squeezed), strains(simulation), strict=True):
            if pair is not None:
                assert pair[1] == pytest.approx(strain, rel=0.02)
    assert sum(len(piece.masses) for piece in found.pieces) == len(scene.masses)


def test_wild_bodies_are_described_by_what_they_consist_of() -> None:
    for seed in range(60):
        scene = wild_scene(np.random.default_rng(seed))
        try:
            found = describe(sim.Simulation(scene), scene)
        except sim.SceneError:
            continue
        for piece in found.pieces:
            assert piece.loops == piece.springs - len(piece.masses) + 1 >= 0
        assert sum(piece.springs for piece in found.pieces) == len(scene.linear_springs) - found.broken
        assert sorted(m for piece in found.pieces for m in piece.masses) == list(range(len(scene.masses)))


@pytest.mark.parametrize(
    ("name", "shape", "loops"),
    [("rope", "chain", 0), ("ring", "ring", 1), ("tree", "tree", 0), ("cloth", "net", 243)],
)
def test_the_shape_of_a_body_is_known(name: str, shape: str, loops: int) -> None:
    scene = sim.load_scene(name)
    found = describe(sim.Simulation(scene), scene)
    assert (found.pieces[0].shape, found.pieces[0].loops) == (shape, loops)


def test_it_says_where_a_body_is_held_and_what_it_touches() -> None:
    rope = sim.rope(masses=5)
    found = describe(sim.Simulation(rope), rope)
    assert found.pieces[0].held == (0,)
    assert found.pieces[0].sides == ("top",)
    buggy = sim.load_scene("buggy")
    parked = sim.Simulation(buggy)
    parked.step(100)
    found = describe(parked, buggy)
    assert found.touching > 0


def test_a_broken_spring_parts_a_chain() -> None:
    rope = body("chain", "angle", 0)
    weak = tuple(replace(spring, strength=1e-3) for spring in rope.linear_springs)
    torn = replace(rope, linear_springs=weak, gravity=(0.0, 1000.0))
    simulation = sim.Simulation(torn)
    simulation.step(200)
    found = describe(simulation, torn)
    assert found.broken > 0
    assert len(found.pieces) == 1 + found.broken


def spring_reading(simulation: sim.Simulation, number: int) -> tuple[float, float]:
    """Length and force of a spring without a muscle, from places and velocities alone."""
    spring = simulation.scene.linear_springs[number]
    x, v = simulation.positions, simulation.velocities
    line = x[spring.b] - x[spring.a]
    length = float(np.hypot(*line))
    rest = spring.rest_length * simulation.rest_length_scale
    rate = float(line @ (v[spring.b] - v[spring.a])) / length
    return length, spring.stiffness * (length - rest) + spring.damping * rate


def joint_reading(simulation: sim.Simulation, number: int) -> tuple[float, float]:
    """Angle, degrees, and torque of a joint without a muscle or a motor, from places and velocities alone."""
    scene = simulation.scene
    joint, x, v = scene.angular_springs[number], simulation.positions, simulation.velocities
    angles, rates, lengths = [], [], []
    for s in (joint.a, joint.b):
        spring = scene.linear_springs[s]
        line, rate = x[spring.b] - x[spring.a], v[spring.b] - v[spring.a]
        square = float(line @ line)
        angles.append(math.atan2(line[1], line[0]))
        rates.append(float(line[0] * rate[1] - line[1] * rate[0]) / square)
        lengths.append(math.sqrt(square))
    angle = math.remainder(angles[1] - angles[0], math.tau)
    off = math.remainder(angle - math.radians(joint.rest_angle), math.tau)
    bent = off if scene.force_law == "angle" else math.sin(off)
    torque = math.prod(lengths) * (joint.stiffness * bent + joint.damping * (rates[1] - rates[0]))
    return math.degrees(angle), torque


@pytest.mark.parametrize("name", part_of(PRESETS, 4))
def test_each_number_of_a_part_is_within_two_percent_of_one_s_own_reading(name: str) -> None:
    scene = sim.load_scene(name)
    simulation = sim.Simulation(scene)
    simulation.step(60)
    scene, whole = simulation.scene, simulation.damage is None
    for number in {0, len(scene.masses) // 2, len(scene.masses) - 1}:
        mass = describe_mass(simulation, scene, number)
        assert mass.place == pytest.approx(tuple(simulation.positions[number]), rel=0.02)
        assert mass.velocity == pytest.approx(tuple(simulation.velocities[number]), rel=0.02)
        assert mass.mass == scene.masses[number].mass
        ends = [(s.a, s.b) for s in scene.linear_springs]
        if whole:
            assert sorted(mass.neighbours) == sorted(sum(pair) - number for pair in ends if number in pair)
    # Forces are differences of large numbers; they are compared with the largest that acts there.
    for number in {0, len(scene.linear_springs) // 2} if whole and scene.linear_springs else ():
        line = scene.linear_springs[number]
        if line.muscle or line.only:
            continue
        spring = describe_spring(simulation, scene, number)
        length, force = spring_reading(simulation, number)
        assert spring.length == pytest.approx(length, rel=0.02)
        assert spring.rest_length * (1.0 + spring.strain) == pytest.approx(length, rel=0.02)
        assert spring.force == pytest.approx(force, rel=0.02, abs=1e-6 * line.stiffness)
    for number in {0, len(scene.angular_springs) // 2} if whole and scene.angular_springs else ():
        of = scene.angular_springs[number]
        if of.muscle or of.motor or of.only:
            continue
        joint = describe_joint(simulation, scene, number)
        angle, torque = joint_reading(simulation, number)
        if not scene.linear_springs[of.a].only and joint.mass == scene.linear_springs[of.a].b:
            assert math.remainder(joint.angle - angle, 360.0) == pytest.approx(0.0, abs=0.02)
            if scene.template is None and joint.rest_angle == of.rest_angle:
                assert joint.torque == pytest.approx(torque, rel=0.02, abs=1e-4 * of.stiffness)


def test_a_broken_spring_joins_no_masses_and_what_touches_is_said_of_a_mass() -> None:
    rope = body("chain", "angle", 0)
    weak = tuple(replace(spring, strength=1e-3) for spring in rope.linear_springs)
    torn = replace(rope, linear_springs=weak, gravity=(0.0, 1000.0))
    simulation = sim.Simulation(torn)
    simulation.step(200)
    broken = [s for s in range(len(weak)) if describe_spring(simulation, torn, s).is_broken]
    assert broken
    assert broken[0] not in describe_mass(simulation, torn, torn.linear_springs[broken[0]].a).springs
    assert describe_spring(simulation, torn, broken[0]).force == 0.0
    buggy = sim.load_scene("buggy")
    parked = sim.Simulation(buggy)
    parked.step(100)
    found = [describe_mass(parked, buggy, m).touches for m in range(len(buggy.masses))]
    assert sum(found) == describe(parked, buggy).touching > 0
