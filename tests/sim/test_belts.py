"""Walls that run, and static friction larger than that of sliding, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, LinearSpring, Mass, Scene
from sim.errors import SceneError
from sim.scene.surroundings import Wall
from sim.scene.types import Integrator, Method
from sim.settings import SETTINGS, set_value, settings_of
from sim.settings.touch import with_grip
from sim.store.files import decode_scene, encode_scene
from tests.sim.changes import after, by

G = (0.0, 1000.0)
DEPTH = math.sqrt(1000.0 / 8000.0)
"""px, at which a mass rests in a wall."""
BELT = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), friction=0.2, speed=300.0)
HOLDS = replace(BELT, tangential_hardness=1e6)
METHODS: tuple[Method, ...] = ("auto", "adams", "rodas5p", "velocity_verlet", "rk4", "generalized_alpha")


def block(wall: Wall, **fields: Any) -> Scene:
    return Scene(name="block", masses=(Mass(position=(0.0, DEPTH)),), gravity=G, walls=(wall,), **fields)


def solved(scene: Scene, method: Method) -> Scene:
    return replace(scene, integrator=Integrator(method=method, dt=2e-4, tolerance=1e-3))


@pytest.mark.parametrize("method", METHODS)
def test_a_block_slides_on_a_belt_until_it_goes_along(method: Method) -> None:
    """It is accelerated by mu g = 200 px/s² until it has 300 px/s, after 1.5 s and 225 px."""
    simulation = sim.Simulation(solved(block(HOLDS), method))
    simulation.advance(1.0)
    assert simulation.velocities[0] == pytest.approx([200.0, 0.0], abs=0.2)
    simulation.advance(1.0)
    assert simulation.velocities[0] == pytest.approx([300.0, 0.0], abs=0.2)
    assert simulation.positions[0, 0] == pytest.approx(225.0 + 150.0, abs=0.5)


def test_a_belt_does_work() -> None:
    for wall in (BELT, HOLDS):
        simulation = sim.Simulation(by(block(wall), "auto", tolerance=1e-5))
        start = simulation.energy()
        simulation.advance(1.0)
        now = simulation.energy()
        assert now.friction == pytest.approx(0.5 * 200.0**2, rel=0.01)
        assert abs(now.residual - start.residual) < 1e-3 * now.kinetic


def test_a_belt_to_the_left_and_one_on_a_slope() -> None:
    left = after(by(block(replace(HOLDS, speed=-300.0))), 1.0)
    assert left.velocities[0, 0] == pytest.approx(-200.0, abs=0.2)
    # Held at rest against gravity's pull, by friction that it needs: tan 10° < 1.
    slope = math.radians(10.0)
    n = (math.sin(slope), -math.cos(slope))
    steep = replace(HOLDS, normal=n, friction=1.0, speed=100.0)
    rides = after(by(block(steep)), 2.0).velocities[0]
    assert rides == pytest.approx([100.0 * math.cos(slope), 100.0 * math.sin(slope)], abs=0.2)


def test_what_rides_on_a_belt_rides_on_from_a_saved_moment() -> None:
    """The same bits from a moment, and within rounding from a saved scene, whose clock begins anew."""
    simulation = sim.Simulation(by(block(HOLDS), "velocity_verlet", dt=1e-3))
    simulation.advance(2.0)
    moment = simulation.capture()
    saved = decode_scene(encode_scene(replace(simulation.scene, pose=simulation.pose())), "saved")
    simulation.advance(0.5)
    again = sim.Simulation(saved)
    again.advance(0.5)
    assert again.positions == pytest.approx(simulation.positions, abs=1e-6)
    there = simulation.positions.copy()
    simulation.restore(moment)
    simulation.advance(0.5)
    assert (simulation.positions == there).all()


# ------------------------------------------------------------------------- static friction
def pulled(mu_static: Any = 0.3) -> Scene:
    """A block of 1 kg on a spring of 100 kg/s², whose end is led at 10 px/s."""
    wall = Wall(
        point=(0.0, 0.0),
        normal=(0.0, -1.0),
        friction=0.2,
        tangential_hardness=1e6,
        static_friction=mu_static,
        restitution="constant",
    )
    return Scene(
        name="pulled",
        masses=(Mass(position=(0.0, DEPTH)), Mass(position=(50.0, DEPTH))),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=100.0, rest_length=50.0),),
        anchors=(Anchor(mass=1),),
        gravity=G,
        walls=(wall,),
    )


def pulls(scene: Scene, seconds: float, speed: float) -> np.ndarray:
    """(k, 3) time, force of the spring, and place of the block while its end is led."""
    simulation, found = sim.Simulation(scene), []
    while simulation.time < seconds:
        simulation.lead(1, (50.0 + speed * (simulation.time + 0.002), DEPTH))
        simulation.advance(0.002)
        x = simulation.positions[:, 0]
        found.append((simulation.time, 100.0 * (x[1] - x[0] - 50.0), x[0]))
    return np.array(found)


@pytest.mark.parametrize("method", ["auto", "velocity_verlet", "rodas5p"])
def test_a_block_sticks_and_slips(method: Method) -> None:
    """The force rises to 300, and falls to 100; jumps of 2 px, each of which takes pi sqrt(m / k)."""
    speed = 1.0
    _, force, x = pulls(solved(pulled(), method), 8.0, speed).T
    assert force.max() == pytest.approx(300.0, abs=2.0)
    first = int(force.argmax())
    assert force[first:].min() == pytest.approx(100.0, abs=4.0)
    moving = np.abs(np.diff(x)) > 0.002
    jumps = np.flatnonzero(np.diff(moving.astype(int)) == 1)
    assert len(jumps) >= 2
    begin = jumps[1]
    end = begin + 1 + int(np.argmin(moving[begin + 1 :]))
    # Meanwhile its spring's end goes on.
    assert x[end] - x[begin] == pytest.approx(2.0 + speed * math.pi * 0.1, abs=0.05)
    assert 0.002 * (end - begin) == pytest.approx(math.pi * 0.1, abs=0.03)


def test_with_one_coefficient_it_slides_steadily() -> None:
    """It is overtaken once: the force is at most V sqrt(k m) = 10 more than what it takes to slide."""
    _, force, x = pulls(by(pulled(msgspec.UNSET), tolerance=1e-3), 5.0, 1.0).T
    assert force.max() == pytest.approx(210.0, abs=0.5)
    assert force[-1500:].min() > 189.0 and np.diff(x[-1500:]).min() > -1e-4


def test_sliders_of_belts_and_static_friction() -> None:
    scene = replace(
        pulled(), walls=(replace(pulled().walls[0], speed=-80.0), BELT, replace(BELT, speed=msgspec.UNSET))
    )
    read = {key: SETTINGS[key].read(scene) for key in ("belt_speed", "static_friction")}
    assert read == {"belt_speed": 300.0, "static_friction": 0.3}
    faster = set_value(scene, "belt_speed", -600.0)
    assert [wall.speed for wall in faster.walls] == [160.0, -600.0, msgspec.UNSET]
    still = replace(BELT, speed=msgspec.UNSET)
    assert not {"belt_speed", "static_friction"} & {each.key for each in settings_of(block(still))}
    creeps = with_grip(scene, False)
    assert creeps.walls[0].static_friction is msgspec.UNSET and sim.validate(creeps)


def test_static_friction_needs_friction_that_holds() -> None:
    wall = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), static_friction=0.9)
    with pytest.raises(SceneError, match=r"walls\[0\].static_friction: it needs a tangential_hardness"):
        sim.validate(block(wall))


def test_static_friction_below_that_of_sliding_counts_as_that() -> None:
    low = after(by(block(replace(HOLDS, static_friction=0.1)), tolerance=1e-3), 0.5)
    assert low.velocities[0, 0] == pytest.approx(100.0, abs=0.2)
