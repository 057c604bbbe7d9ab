"""Muscles and forces that keys work, against closed forms; tests of motors are in `test_motors`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec import UNSET
from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene, SceneError
from sim.forces.reference import Physics
from sim.model.state import rest_angles, rest_lengths
from sim.scene.parts import Beat, JointMuscle, SpringMuscle
from sim.scene.types import Method
from sim.store.files import decode_scene, encode_scene
from tests.sim.changes import by

RISE = 0.05
M, K, LENGTH = 2.0, 200.0, 100.0
OMEGA = math.sqrt(K / M)


def puller(muscle: SpringMuscle, **fields: Any) -> Scene:
    """A mass on a spring that is a muscle, without gravity."""
    return Scene(
        name="puller",
        masses=(Mass(position=(0.0, 0.0)), Mass(position=(LENGTH, 0.0), mass=M)),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=K, rest_length=LENGTH, muscle=muscle),),
        anchors=(Anchor(mass=0),),
        beat=Beat(frequency=2.0),
        **fields,
    )


def cart(**fields: Any) -> Scene:
    """Two loose masses: Left and Right push one, Up and Down the other."""
    return Scene(
        name="cart",
        masses=(
            Mass(position=(0.0, 0.0), mass=M, force=(30.0, 40.0), keys="left-right"),
            Mass(position=(0.0, 50.0), force=(0.0, -100.0), keys="up-down"),
        ),
        **fields,
    )


STEADY = SpringMuscle(wave="steady", amplitude=0.2, keys="left-right")


def pulled(t: float) -> tuple[float, float]:
    """How far the mass has come, px, a time after the key was pressed, and the rest length, px."""
    full, c = 0.2 * LENGTH, OMEGA**2 / (OMEGA**2 + RISE**-2)
    fade = math.exp(-t / RISE)
    swing = (1.0 - c) * math.cos(OMEGA * t) + c / (RISE * OMEGA) * math.sin(OMEGA * t)
    return full * (1.0 - c * fade - swing), LENGTH + full * (1.0 - fade)


@pytest.mark.parametrize("method", ["auto", "rk4", "adams", "rodas5p"])
def test_a_muscle_pulls_while_its_key_is_held(method: Method) -> None:
    simulation = sim.Simulation(by(puller(STEADY), method, dt=1e-3, tolerance=1e-5))
    simulation.energy()
    simulation.advance(0.3)
    assert simulation.positions[1, 0] == pytest.approx(LENGTH, abs=1e-4)
    simulation.keys = {"right"}
    simulation.advance(0.4)
    moved, rest = pulled(0.4)
    assert simulation.positions[1, 0] == pytest.approx(LENGTH + moved, abs=1e-3)
    now, speed = simulation.energy(), simulation.velocities[1, 0]
    stored = 0.5 * M * speed**2 + 0.5 * K * (LENGTH + moved - rest) ** 2
    assert now.muscles == pytest.approx(stored, rel=1e-4) and stored > 1000.0
    assert abs(now.residual) < 1e-3 * stored and now.keys == 0.0


def test_it_rests_without_and_pulls_the_other_way_by_the_other_key() -> None:
    simulation = sim.Simulation(by(puller(STEADY), tolerance=1e-4))
    simulation.keys = {"left"}
    simulation.advance(1.0)
    body, state = simulation.tables[0].body, simulation.tables[1]
    assert rest_lengths(body, state)[0] == pytest.approx(0.8 * LENGTH, rel=1e-6)
    simulation.keys = ()
    simulation.advance(0.035)
    rest = LENGTH * (1.0 - 0.2 * math.exp(-0.035 / RISE))
    assert rest_lengths(body, state)[0] == pytest.approx(rest, rel=1e-6)
    simulation.advance(2.0)
    assert rest_lengths(body, state)[0] == pytest.approx(LENGTH, rel=1e-9)


@pytest.mark.parametrize(("key", "way"), [("up", 1.0), ("down", -1.0)])
def test_a_wave_runs_while_its_key_is_held_and_backwards_by_the_other(key: str, way: float) -> None:
    pulse = JointMuscle(wave="pulse", keys="up-down")
    scene = puller(SpringMuscle(amplitude=0.2, phase=30.0, keys="up-down"))
    scene = replace(
        scene,
        masses=(*scene.masses, Mass(position=(LENGTH, LENGTH))),
        linear_springs=(
            *scene.linear_springs,
            LinearSpring(a=1, b=2, stiffness=K, damping=1.0, rest_length=LENGTH),
        ),
        angular_springs=(AngularSpring(a=0, b=1, stiffness=1.0, rest_angle=90.0, muscle=pulse),),
    )
    simulation = sim.Simulation(by(scene, tolerance=1e-3))
    simulation.advance(0.2)
    simulation.keys = {key}
    simulation.advance(0.1)
    effort, phase = 1.0 - math.exp(-0.1 / RISE), way * math.tau * 2.0 * 0.3
    body, state = simulation.tables[0].body, simulation.tables[1]
    wave = math.sin(phase + math.radians(30.0))
    assert rest_lengths(body, state)[0] == pytest.approx(LENGTH * (1.0 + 0.2 * effort * wave), abs=1e-6)
    bent = 20.0 * effort * math.exp(4.0 * (math.sin(phase) - 1.0))
    assert rest_angles(body, state)[0] == pytest.approx(90.0 + bent, abs=1e-6)


@pytest.mark.parametrize("method", ["auto", "rk4", "adams", "generalized_alpha", "velocity_verlet"])
def test_keys_push_masses(method: Method) -> None:
    """Way F t² / 2 m, speed F t / m, work (F t)² / 2 m; two keys at once push both."""
    simulation = sim.Simulation(by(cart(), method, dt=1e-3))
    simulation.energy()
    simulation.advance(0.2)
    assert np.abs(simulation.velocities).max() == 0.0
    simulation.keys = {"left", "up"}
    simulation.advance(0.5)
    assert simulation.velocities == pytest.approx(np.array([[-7.5, -10.0], [0.0, -50.0]]), rel=1e-9)
    assert simulation.positions == pytest.approx(np.array([[-1.875, -2.5], [0.0, 37.5]]), rel=1e-6)
    now = simulation.energy()
    assert now.keys == pytest.approx(0.5 * M * 12.5**2 + 0.5 * 50.0**2, rel=1e-9)
    assert abs(now.residual) < 1e-6 * now.keys
    simulation.keys = ()
    simulation.advance(0.5)
    assert simulation.velocities[1, 1] == pytest.approx(-50.0)


def test_kernels_push_as_numpy_does() -> None:
    simulation = sim.Simulation(cart())
    simulation.keys = {"right", "down"}
    system, state = simulation.tables
    net = Physics(system.body, state).forces(state.x + 1j * state.y, state.vx + 1j * state.vy)
    assert net[system.mass_index].tolist() == [30.0 + 40.0j, 100.0j]
    assert simulation.loads.forces.tolist() == [[30.0, 40.0], [0.0, 100.0]]


def walker() -> Scene:
    """A puller whose mass is pushed, too."""
    scene = puller(replace(STEADY, wave="sine"))
    pushed = replace(scene.masses[1], force=(0.0, -50.0), keys="up-down")
    return by(replace(scene, masses=(scene.masses[0], pushed)), tolerance=1e-3)


def test_the_same_bits_from_a_moment_while_keys_are_held() -> None:
    simulation = sim.Simulation(walker())
    simulation.keys = {"right"}
    simulation.advance(0.03)
    start, ends = simulation.capture(), []
    assert len(start.steer) == 5
    for _ in range(2):
        simulation.keys = {"left", "down"}
        simulation.restore(start)
        simulation.keys = {"right"}
        simulation.advance(0.1)
        simulation.keys = {"left", "up"}
        simulation.advance(0.1)
        ends.append(simulation.positions)
    fresh = sim.Simulation(walker())
    fresh.restore(start)
    fresh.keys = {"right"}
    fresh.advance(0.1)
    fresh.keys = {"left", "up"}
    fresh.advance(0.1)
    assert (ends[0] == ends[1]).all()
    assert fresh.positions == pytest.approx(ends[0], abs=1e-4)
    simulation.reset()
    assert simulation.capture().steer[2:4] == (0.0, 0.0)


def test_a_run_resumes_with_its_efforts_bit_for_bit() -> None:
    simulation = sim.Simulation(walker())
    simulation.keys = {"right", "up"}
    simulation.advance(0.03)
    there, ends = simulation.checkpoint(), []
    for _ in range(2):
        simulation.advance(0.04)
        simulation.keys = {"left"}
        simulation.advance(0.1)
        ends.append(simulation.positions)
        simulation.resume(there)
    assert (ends[0] == ends[1]).all()


def test_an_effort_goes_on_when_a_number_changes() -> None:
    simulation = sim.Simulation(by(puller(STEADY), tolerance=1e-5))
    simulation.keys = {"right"}
    simulation.advance(0.04)
    simulation.replace(replace(simulation.scene, air_friction=1e-9))
    simulation.advance(0.06)
    assert simulation.positions[1, 0] == pytest.approx(LENGTH + pulled(0.1)[0], abs=1e-3)


def test_at_rest_nobody_holds_a_key() -> None:
    """Equilibrium, shape and loads are those without keys, and so is the stable step."""
    hanging = replace(walker(), gravity=(300.0, 0.0))
    muscle, (anchor, mass) = hanging.linear_springs[0], hanging.masses
    plain = replace(
        hanging,
        masses=(anchor, replace(mass, force=UNSET, keys=UNSET)),
        linear_springs=(replace(muscle, muscle=UNSET),),
    )
    lengths = [sim.keep_shape(scene).linear_springs[0].rest_length for scene in (hanging, plain)]
    assert lengths[0] == lengths[1]
    steps = [sim.Simulation(by(scene, "rk4")).stability().limit for scene in (hanging, plain)]
    assert steps[0] == pytest.approx(steps[1], rel=1e-3)


def test_what_keys_work_is_saved_and_refused_where_it_means_nothing() -> None:
    for scene in (cart(), puller(STEADY)):
        assert decode_scene(encode_scene(scene), scene.name) == scene
    with pytest.raises(SceneError, match=r"masses\[0\]\.keys: there is no force"):
        sim.Simulation(replace(cart(), masses=(Mass(position=(0.0, 0.0), keys="up-down"),)))
    with pytest.raises(SceneError, match=r'muscle\.wave: "steady" needs keys'):
        sim.Simulation(puller(SpringMuscle(wave="steady")))


def test_what_is_steady_has_no_tempo() -> None:
    with pytest.raises(sim.SettingError, match="tempo"):
        sim.set_value(puller(STEADY), "tempo", 2.0)
    assert sim.set_value(walker(), "tempo", 3.0).beat == Beat(frequency=3.0)
