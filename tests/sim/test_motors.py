"""Motors against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec import UNSET
from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene
from sim.scene.parts import Motor
from sim.scene.types import Integrator, Method
from sim.settings import SETTINGS, set_value, settings_of
from sim.store.files import decode_scene, encode_scene
from tests.sim.builders import PRESETS
from tests.sim.changes import by

G, ARM = 1000.0, 50.0
METHODS: tuple[Method, ...] = ("auto", "adams", "rodas5p", "velocity_verlet", "rk4", "generalized_alpha")


def crank(motor: Motor, weight: float = 1.0, gravity: float = 0.0, **fields: Any) -> Scene:
    """An arm of 50 px with a weight at its end, which a motor turns about a hub against a fixed bar."""
    return Scene(
        name="crank",
        masses=(
            Mass(position=(0.0, 0.0)),
            Mass(position=(-100.0, 0.0)),
            Mass(position=(ARM, 0.0), mass=weight),
        ),
        linear_springs=(
            LinearSpring(a=1, b=0, stiffness=1e5, rest_length=100.0),
            LinearSpring(a=0, b=2, stiffness=1e7, damping=100.0, rest_length=ARM),
        ),
        angular_springs=(AngularSpring(a=0, b=1, stiffness=0.0, motor=motor),),
        anchors=(Anchor(mass=0), Anchor(mass=1)),
        gravity=(0.0, gravity),
        **fields,
    )


def test_scenes_with_motors_have_sliders_of_them() -> None:
    """The largest is set, and the others keep their ratio to it; joints without a motor have none."""
    for name in PRESETS:
        keys = {each.key for each in settings_of(sim.load_scene(name))}
        assert (len({"motor_torque", "motor_speed"} & keys) == 2) == (name in ("crane", "buggy")), name
    buggy = set_value(sim.load_scene("buggy"), "motor_speed", -300.0)
    joints = [replace(joint, motor=replace(joint.motor, torque=k * 1e4) if joint.motor else UNSET)
              for k, joint in enumerate(buggy.angular_springs)]  # fmt: skip
    buggy = replace(buggy, angular_springs=tuple(joints))
    torque = {k: joint.motor.torque for k, joint in enumerate(joints) if joint.motor}
    assert len(torque) == 2 and SETTINGS["motor_torque"].differs(buggy)
    halved = set_value(buggy, "motor_torque", 0.5 * max(torque.values()))
    motors = {k: joint.motor for k, joint in enumerate(halved.angular_springs) if joint.motor}
    assert {k: motor.torque for k, motor in motors.items()} == {k: 0.5 * each for k, each in torque.items()}
    assert {motor.speed for motor in motors.values()} == {-300.0}


@pytest.mark.parametrize("method", METHODS)
def test_a_motor_without_a_load_comes_to_its_speed(method: Method) -> None:
    scene = crank(Motor(speed=360.0, torque=1e6, slip=10.0))
    simulation = sim.Simulation(replace(scene, integrator=Integrator(method=method, dt=2e-4, tolerance=1e-3)))
    simulation.advance(0.5)
    assert np.hypot(*simulation.velocities[2]) == pytest.approx(math.tau * ARM, rel=2e-3)
    # From +x to +y: the angle from the first spring to the second grows.
    before = simulation.angles[0]
    simulation.advance(0.01)
    assert (simulation.angles[0] - before) % 360.0 == pytest.approx(3.6, rel=1e-2)


def test_it_starts_with_its_torque() -> None:
    """T = m r² a: the angle grows by T / (m r²) t² / 2 as long as it is much slower than wanted."""
    scene = crank(Motor(speed=36000.0, torque=1e5, slip=10.0))
    simulation = sim.Simulation(by(scene, tolerance=1e-5))
    simulation.advance(0.2)
    turned = 1e5 / ARM**2 * 0.02
    assert simulation.positions[2] == pytest.approx(
        [ARM * math.cos(turned), ARM * math.sin(turned)], abs=0.05
    )


@pytest.mark.parametrize(("torque", "lifts"), [(1.2, True), (0.8, False)])
def test_it_lifts_what_its_torque_can_and_stalls_below(torque: float, lifts: bool) -> None:
    """m g r is what a level arm needs; a motor of less holds where m g r cos(angle) is its torque."""
    scene = crank(Motor(speed=-90.0, torque=torque * G * ARM, slip=1.0), gravity=G)
    simulation = sim.Simulation(by(scene, tolerance=1e-3))
    simulation.advance(0.5)
    raised = -simulation.positions[2, 1]
    assert raised > 20.0 if lifts else raised < 0.0
    if not lifts:
        held = sim.Simulation(by(replace(scene, air_friction=0.05), tolerance=1e-3))
        held.advance(6.0)
        angle = math.degrees(math.asin(held.positions[2, 1] / ARM))
        assert math.cos(math.radians(angle)) == pytest.approx(torque, abs=0.05)


def test_far_from_its_speed_it_counts_as_at_its_speed_in_the_stability_limit() -> None:
    """There it damps with T / slip, which symplectic Euler bears for steps up to 2 m r² slip / T."""
    scene = by(crank(Motor(speed=3600.0, torque=1e7, slip=20.0)), method="symplectic_euler", dt=1e-5)
    limit = 2.0 * ARM**2 * math.radians(20.0) / 1e7
    assert sim.Simulation(scene).stability().limit == pytest.approx(limit, rel=0.02)


def test_its_work_is_in_the_balance() -> None:
    scene = crank(Motor(speed=-360.0, torque=2e5, slip=20.0), gravity=G)
    simulation = sim.Simulation(by(scene, tolerance=1e-4))
    simulation.energy()
    simulation.advance(0.4)
    now = simulation.energy()
    assert now.motors > 1e4
    assert abs(now.residual) < 1e-3 * now.motors


def test_keys_steer_it() -> None:
    """It turns while they are held, to both sides, and else holds still; the same bits from a moment."""
    scene = crank(Motor(speed=180.0, torque=1e5, slip=10.0, keys="left-right"))
    simulation = sim.Simulation(by(scene, "velocity_verlet", dt=2e-4))
    simulation.advance(0.2)
    assert np.abs(simulation.velocities).max() < 1e-9
    start = simulation.capture()
    ends = []
    for _ in range(2):
        simulation.restore(start)
        simulation.keys = {"right"}
        simulation.advance(0.5)
        assert simulation.positions[2, 1] > 10.0
        simulation.keys = {"left", "up"}
        simulation.advance(1.0)
        ends.append(simulation.positions)
        assert np.hypot(*simulation.velocities[2]) == pytest.approx(math.pi * ARM, rel=0.01)
        simulation.keys = ()
        simulation.advance(0.3)
        assert np.abs(simulation.velocities).max() < 1.0
        ends.append(simulation.positions)
    assert (ends[0] == ends[2]).all() and (ends[1] == ends[3]).all()


def test_a_motor_is_saved_and_stops_with_what_it_turns() -> None:
    scene = crank(Motor(speed=-90.0, torque=1e5, keys="up-down"))
    assert decode_scene(encode_scene(scene), "crank") == scene
    springs = (scene.linear_springs[0], replace(scene.linear_springs[1], strength=1e3))
    weak = sim.Simulation(by(replace(crank(Motor(speed=9000.0, torque=1e6)), linear_springs=springs)))
    weak.advance(1.0)
    assert weak.damage is not None and weak.damage.broken == (1,)
