"""Solid masses, which touch each other, walls and springs with their radii, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, LinearSpring, Mass, Scene
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Integrator, Method
from tests.sim.changes import after, by

ELASTIC = Contact(distance=0.0, bounciness=1.0)


def balls(*places: float, speed: float = 0.0, **fields: Any) -> Scene:
    """Solid masses of 1 kg and a radius of 10 px along x, with the first in motion."""
    masses = tuple(Mass(position=(x, 0.0), radius=10.0, solid=True) for x in places)
    masses = (replace(masses[0], velocity=(speed, 0.0)), *masses[1:])
    return Scene(name="balls", masses=masses, **{"contact": ELASTIC, **fields})


@pytest.mark.parametrize("method", ["auto", "adams", "velocity_verlet", "rk4", "rodas5p"])
def test_a_light_mass_bounces_off_a_heavy_one(method: Method) -> None:
    """1 kg at 100 px/s into 3 kg: -50 and +50 px/s, and the momentum stays."""
    scene = balls(0.0, 40.0, speed=100.0)
    scene = replace(scene, masses=(scene.masses[0], replace(scene.masses[1], mass=3.0)))
    simulation = sim.Simulation(replace(scene, integrator=Integrator(method=method, dt=2e-4, tolerance=1e-6)))
    simulation.advance(0.6)
    (first, _), (second, _) = simulation.velocities.tolist()
    assert (first, second) == (pytest.approx(-50.0, abs=1e-4), pytest.approx(50.0, abs=1e-4))
    assert first + 3.0 * second == pytest.approx(100.0, rel=1e-12)


def test_of_five_in_a_row_the_last_takes_all() -> None:
    scene = balls(-60.0, 0.0, 21.0, 42.0, 63.0, speed=100.0, contact=replace(ELASTIC, stiffness=1e6))
    simulation = after(by(scene, "velocity_verlet", dt=2e-5), 0.8)
    *others, last = simulation.velocities[:, 0].tolist()
    assert last == pytest.approx(100.0, abs=0.2) and max(map(abs, others)) < 0.3
    assert simulation.velocities.sum(0) == pytest.approx([100.0, 0.0], abs=1e-10)


def test_half_of_the_speed_is_left_of_a_bounce_where_the_bounciness_says_so() -> None:
    constant = Contact(distance=0.0, bounciness=0.5, restitution="constant")
    simulation = after(by(balls(0.0, 40.0, speed=100.0, contact=constant), "rodas5p", tolerance=1e-4), 0.6)
    (first, _), (second, _) = simulation.velocities.tolist()
    assert second - first == pytest.approx(50.0, rel=0.01)


def test_a_ball_rests_on_the_floor_at_its_radius() -> None:
    floor = Wall(point=(0.0, 100.0), normal=(0.0, -1.0), restitution="constant", bounciness=0.1)
    scene = balls(0.0, gravity=(0.0, 1000.0), walls=(floor,))
    depth = math.sqrt(1000.0 / 8000.0)
    assert after(scene, 4.0).positions[0, 1] == pytest.approx(90.0 + depth, abs=0.01)
    point = replace(scene, masses=(replace(scene.masses[0], solid=False),))
    assert after(point, 4.0).positions[0, 1] == pytest.approx(100.0 + depth, abs=0.01)
    found = sim.equilibrium(scene) if hasattr(sim, "equilibrium") else None
    assert found is None or found.positions[0][1] == pytest.approx(90.0 + depth, abs=1e-3)


def test_a_ball_lies_on_a_spring_at_its_radius_and_the_distance_of_contact() -> None:
    stiff = LinearSpring(a=1, b=2, stiffness=1e6, rest_length=200.0)
    scene = Scene(
        name="beam",
        masses=(
            Mass(position=(10.0, -30.0), radius=12.0, solid=True),
            Mass(position=(-100.0, 0.0)),
            Mass(position=(100.0, 0.0)),
        ),
        linear_springs=(stiff,),
        anchors=(Anchor(mass=1), Anchor(mass=2)),
        gravity=(0.0, 1000.0),
        contact=Contact(distance=5.0, restitution="constant", bounciness=0.1),
    )
    rests = after(by(scene, tolerance=1e-4), 3.0).positions[0]
    assert rests[1] == pytest.approx(-17.0 + math.sqrt(1000.0 / 8000.0), abs=0.01)
    only_balls = replace(scene, contact=Contact(distance=0.0))
    assert after(only_balls, 1.0).positions[0, 1] == pytest.approx(470.0, abs=0.1)  # it falls past it


def test_neighbours_that_overlap_as_they_are_built_never_touch() -> None:
    """A chain of beads as large as its springs is at rest; loose beads at the same places fly apart."""
    beads = balls(0.0, 15.0, 30.0)
    springs = tuple(LinearSpring(a=i, b=i + 1, stiffness=500.0, rest_length=15.0) for i in range(2))
    assert np.abs(after(replace(beads, linear_springs=springs), 0.2).velocities).max() < 1e-3
    assert np.abs(after(beads, 0.2).velocities).max() > 100.0


def test_many_balls_keep_their_momentum_and_energy() -> None:
    rng = np.random.default_rng(3)
    masses = tuple(
        Mass(
            position=(30.0 * i, 30.0 * j),
            velocity=(rng.normal(0.0, 200.0), rng.normal(0.0, 200.0)),
            radius=12.0,
            solid=True,
        )
        for i in range(6)
        for j in range(5)
    )
    scene = Scene(name="gas", masses=masses, contact=ELASTIC)
    simulation = sim.Simulation(by(scene, tolerance=1e-3))
    start = simulation.energy()
    before = simulation.velocities.sum(0)
    simulation.advance(0.5)
    assert np.abs(simulation.velocities - [m.velocity for m in masses]).max() > 100.0
    assert simulation.velocities.sum(0) == pytest.approx(before, abs=1e-9)
    energy = simulation.energy()
    assert energy.kinetic + energy.contact == pytest.approx(start.kinetic + start.contact, rel=1e-5)
