"""The stable spring: symplectic Euler that gives in where its step is too long, instead of exploding."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Scene, Simulation
from sim.scene.types import ForceLaw
from tests.amount import part_of
from tests.sim.builders import chain, euler, row
from tests.sim.changes import pairs, step_all, with_joints, with_masses, with_springs
from tests.sim.inside import same_state, system_of

SHAPES = ("tutorial-3.3", "ring", "box")
STIFFNESSES = (1e2, 1e4, 1e6, 1e9, 1e15)
STEPS = (1e-4, 1e-3, 1e-2, 0.1, 1.0)


def stable(dt: float) -> Integrator:
    return Integrator(method="stable_spring", dt=dt)


def shaken(
    preset: str,
    *,
    stiffness: float,
    dt: float,
    damping: float = 0.0,
    twist: float = 0.0,
    ratio: float = 1.0,
    law: ForceLaw = "conservative",
    gravity: float = 0.0,
    air: float = 0.0,
) -> Scene:
    """A preset with every spring and joint of one stiffness, out of shape by a tenth of a spring.

    Args:
        preset: its name.
        stiffness: of springs and joints, kg/s².
        dt: the step, s.
        damping, twist: of springs and of joints, kg/s.
        ratio: mass of every second mass; the others have 1 kg.
        law, gravity, air: as in a scene.
    """
    scene = sim.load_scene(preset)
    rng = np.random.default_rng(1)
    size = 0.1 * float(np.median([spring.rest_length for spring in scene.linear_springs]))
    off = rng.uniform(-size, size, (len(scene.masses), 2))
    places = list(pairs(off + [mass.position for mass in scene.masses]))
    scene = with_masses(scene, mass=lambda i, _: 1.0 if i % 2 else ratio, position=places)
    scene = with_springs(scene, stiffness=stiffness, damping=damping)
    scene = with_joints(scene, stiffness=stiffness, damping=twist)
    fields: dict[str, Any] = {"gravity": (0.0, gravity), "air_friction": air, "integrator": stable(dt)}
    return replace(scene, force_law=law, **fields)


def wandered(scene: Scene) -> float:
    """How far any mass is from its start after 400 steps, px; infinite where the body ran away."""
    simulation = Simulation(scene)
    start = simulation.positions
    return float(np.abs(simulation.positions - start).max()) if simulation.step(400) == 400 else np.inf


# ------------------------------------------------------------------------- never
RATIOS = (1e-3, 1.0, 1e3)
CASES = {
    "conservative": [*itertools.product(STIFFNESSES, STEPS, (0.0, 40.0, 1e6), (0.0, 1e6), RATIOS)],
    # With some damping: without any, a law that is no gradient does work for ever.
    "tutorial": [*itertools.product(STIFFNESSES, STEPS, (40.0,), (0.0,), RATIOS)],
    "angle": [*itertools.product(STIFFNESSES, STEPS, (40.0,), (0.0,), RATIOS)],
}


@pytest.mark.parametrize("law", CASES)
@pytest.mark.parametrize("preset", SHAPES)
def test_it_never_explodes(preset: str, law: ForceLaw) -> None:
    for stiffness, dt, damping, twist, ratio in part_of(CASES[law], 5):
        scene = shaken(preset, stiffness=stiffness, dt=dt, damping=damping, twist=twist, ratio=ratio, law=law)
        assert wandered(scene) <= 600.0, (stiffness, dt, damping, twist, ratio)


@pytest.mark.parametrize("preset", SHAPES)
def test_it_sags_where_something_pulls(preset: str) -> None:
    for stiffness, dt, damping in itertools.product(STIFFNESSES, (1e-4, 1e-3, 1e-2, 0.1), (0.0, 40.0)):
        scene = shaken(preset, stiffness=stiffness, dt=dt, damping=damping, gravity=2000.0, air=0.002)
        # A dozen masses on a spring of m / (2 dt²), swinging; or on the weak spring of the scene.
        softest = min(stiffness, 1.0 / (4.0 * dt * dt))
        assert wandered(scene) <= 600.0 + 150.0 * 12.0 * 2000.0 / softest, (stiffness, dt, damping)


def test_symplectic_euler_explodes_where_it_does_not() -> None:
    for preset in SHAPES:
        scene = shaken(preset, stiffness=1e6, dt=0.01)
        assert wandered(scene) <= 600.0
        assert wandered(replace(scene, integrator=euler(0.01))) == np.inf


# ------------------------------------------------------------------------- no more than needed
@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
@pytest.mark.parametrize("preset", [*SHAPES, "flag-pole", "hair-tuft"])
def test_it_is_symplectic_euler_where_the_step_is_short_enough(preset: str, law: ForceLaw) -> None:
    scene = replace(sim.load_scene(preset), force_law=law)
    # At a longer one, it is not.
    for dt, steps, same in ((2e-4, 500, True), (2e-2, 3, False)):
        one, other = (Simulation(replace(scene, integrator=method(dt))) for method in (euler, stable))
        step_all(steps, one, other)
        assert same_state(one, other) == same


@pytest.mark.parametrize("dt", [1e-3, 0.05])
def test_a_spring_is_weakened_to_what_the_reduced_mass_bears(dt: float) -> None:
    pair = chain(row(2), stiffness=1e12, damping=1e6, mass=3.0, dt=dt)
    pair = replace(pair, masses=(pair.masses[0], replace(pair.masses[1], mass=6.0)), integrator=stable(dt))
    tables = system_of(Simulation(pair)).body
    assert tables.stiffness[0] == pytest.approx(2.0 / dt**2, rel=1e-12)
    assert tables.damping[0] == pytest.approx(2.0 / dt, rel=1e-12)
    # A held mass is as good as an infinite one, and springs that share a mass share what it bears.
    held = replace(chain(row(3), stiffness=1e12, mass=3.0, held=(0,)), integrator=stable(dt))
    tables = system_of(Simulation(held)).body
    assert tables.stiffness[:2] == pytest.approx([3.0 / 2.0 / dt**2, 1.5 / 2.0 / dt**2], rel=1e-12)
    # What is weak enough stays as it is; and the scene says what its author said.
    weak = replace(pair, linear_springs=(replace(pair.linear_springs[0], stiffness=1.5, damping=0.7),))
    simulation = Simulation(weak)
    assert (system_of(simulation).body.stiffness[0], system_of(simulation).body.damping[0]) == (1.5, 0.7)
    assert Simulation(pair).scene == pair


def test_a_joint_is_weakened_to_what_its_angle_bears() -> None:
    # Three masses of 1 kg in line, 10 px apart: the angle answers to unit forces by (1 + 4 + 1) / 10² a kg.
    dt = 0.01
    scene = replace(chain(row(3), angular_stiffness=1e12), integrator=stable(dt))
    tables = system_of(Simulation(scene)).body
    share = 1  # one joint
    assert tables.joint_stiffness[0] == pytest.approx(1.0 / (6.0 * share * dt**2), rel=1e-12)
    assert tables.angular_stiffness[1] == tables.joint_stiffness[0]
    joint = replace(scene.angular_springs[0], damping=1e6)
    tables = system_of(Simulation(replace(scene, angular_springs=(joint,)))).body
    assert tables.torque_damping[1] == pytest.approx(1.0 / (6.0 * share * dt), rel=1e-12)


def test_another_step_weakens_anew() -> None:
    scene = shaken("ring", stiffness=1e6, dt=0.02, damping=40.0)
    simulation = Simulation(scene)
    simulation.step(20)
    simulation.replace(replace(scene, integrator=stable(1e-4)))
    assert simulation.step(200) == 200
    tables = system_of(simulation).body
    assert (tables.stiffness[: tables.springs] == 1e6).all()
    assert (system_of(Simulation(scene)).body.stiffness[: tables.springs] < 1e4).all()


def test_keys_and_hands_do_not_undo_it() -> None:
    scene = shaken("tutorial-3.3", stiffness=1e9, dt=0.01, damping=40.0)
    simulation = Simulation(scene)
    simulation.keys = {"up", "right"}
    for i in range(40):
        simulation.lead(0, (300.0 + 100.0 * (i % 2), 200.0))
        simulation.keys = {"up", "right"} if i < 20 else {"down", "left"}
        assert simulation.step(10) == 10
    assert np.abs(simulation.positions).max() <= 5000.0
