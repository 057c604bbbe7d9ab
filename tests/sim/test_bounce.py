"""Bounces: no method leaves a wall, or another body, with more than it came with, however long its steps."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Integrator, Mass, Scene, Simulation
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Method
from sim.settings import SETTINGS
from sim.solve.registry import METHODS
from tests.sim.builders import built
from tests.sim.changes import after, by

FIXED = [name for name, info in METHODS.items() if not info.adaptive]
FLOOR = Wall(point=(0.0, 0.0), normal=(0.0, -1.0))


def falling(height: float, speed: float, wall: Wall, method: Method, dt: float) -> Scene:
    """Two masses on a spring, side by side, whose stability limit is 32 ms at least."""
    return built(
        [(0.0, -height), (30.0, -height)], velocities=[(0.0, speed)] * 2, stiffness=2000.0,
        walls=(wall,), integrator=Integrator(method=method, dt=dt),
    )  # fmt: skip


def left_with(simulation: Simulation, mass: int, surface: float) -> float:
    """The speed, px/s, with which a mass that falls from above leaves what is at that height."""
    for _ in range(3000):
        simulation.step()
        assert simulation.divergence is None
        x, v = simulation.positions[mass], simulation.velocities[mass]
        if x[1] < surface and v[1] < 0.0:
            return float(np.hypot(*v))
    raise AssertionError("it stays inside")


def fastest_outwards(simulation: Simulation, mass: int, steps: int) -> float:
    """The largest speed, px/s, that a mass has on its way up at the end of any of some steps."""
    fastest = 0.0
    for _ in range(steps):
        simulation.step()
        assert simulation.divergence is None
        if simulation.velocities[mass, 1] < 0.0:
            fastest = max(fastest, float(np.hypot(*simulation.velocities[mass])))
    return fastest


FLOORS = [
    *(replace(FLOOR, bounciness=e) for e in (0.3, 0.5, 0.8, 1.0)),
    *(replace(FLOOR, bounciness=e, restitution="constant") for e in (0.0, 0.3, 0.8, 1.0)),
    *(replace(FLOOR, bounciness=e, friction=mu) for e, mu in ((1.0, 0.5), (0.9, 100.0))),
]


@pytest.mark.parametrize("method", FIXED)
@pytest.mark.parametrize(
    "floor", FLOORS, ids=[f"{f.restitution} {f.bounciness} {f.friction}" for f in FLOORS]
)
def test_no_fixed_step_makes_a_floor_give_energy(method: Method, floor: Wall) -> None:
    most = 1.005 if floor.bounciness == 1.0 else 1.0
    for speed, dt, part in itertools.product(
        (10.0, 100.0, 500.0, 4000.0, 20000.0), (0.001, 0.0025, 1.0 / 60.0), (0.1, 0.45, 0.8)
    ):
        scene = falling(part * speed * dt, speed, floor, method, dt)
        along = 0.7 * speed if floor.friction else 0.0  # which friction may turn into a bounce
        aslant = tuple(replace(mass, velocity=(along, speed)) for mass in scene.masses)
        fastest = fastest_outwards(Simulation(replace(scene, masses=aslant)), 0, 200)
        assert fastest <= most * math.hypot(along, speed)


@pytest.mark.parametrize("method", FIXED)
def test_short_steps_leave_as_the_bounciness_says(method: Method) -> None:
    # A mass that comes with 1000 px/s leaves with that part of it.
    for bounciness in (0.3, 0.8, 1.0):
        scene = falling(1.0, 1000.0, replace(FLOOR, bounciness=bounciness), method, 1e-5)
        assert left_with(Simulation(scene), 0, 0.0) == pytest.approx(1000.0 * bounciness, rel=2e-3)


@pytest.mark.parametrize("bounciness", [0.1, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("method", ["auto", "rodas5p", "velocity_verlet"])
def test_with_a_constant_restitution_all_speeds_keep_the_same_part(method: Method, bounciness: float) -> None:
    wall = replace(FLOOR, bounciness=bounciness, restitution="constant", slip_speed=0.1)
    for speed in (20.0, 300.0, 5000.0):
        scene = falling(0.1, speed, wall, method, 2e-5 * (5000.0 / speed) ** (1.0 / 3.0))  # as it takes long
        assert left_with(Simulation(scene), 0, 0.0) == pytest.approx(bounciness * speed, rel=0.02)


def test_with_a_constant_restitution_a_mass_comes_to_rest() -> None:
    speeds = []
    for restitution in ("viscous", "constant"):
        wall = replace(FLOOR, bounciness=0.5, restitution=restitution)
        scene = replace(falling(30.0, 0.0, wall, "velocity_verlet", 2e-4), gravity=(0.0, 1000.0))
        simulation = after(scene, 3.0)
        speeds.append(float(np.abs(simulation.velocities).max()))
    assert speeds[0] > 5.0
    assert speeds[1] < 1e-4


@pytest.mark.parametrize("method", FIXED)
@pytest.mark.parametrize(("stiffness", "bounciness", "most"), [(500.0, 0.5, 1.0), (1e6, 1.0, 1.005)])
def test_nor_does_another_body(method: Method, stiffness: float, bounciness: float, most: float) -> None:
    # As fast as half of the distance of contact in a step: what is faster may pass by explicit methods.
    contact = Contact(distance=12.0, stiffness=stiffness, friction=0.0, bounciness=bounciness)
    speeds = (10.0, 100.0, 360.0, *((1000.0,) if stiffness > 500.0 and METHODS[method].implicit else ()))
    for speed, dt, part in itertools.product(speeds, (0.001, 1.0 / 60.0), (0.1, 0.45, 0.8)):
        height = contact.distance + part * speed * dt
        scene = built(
            [(-200.0, 0.0), (200.0, 0.0), (0.0, -height), (0.0, -height - 1000.0)], [(0, 1), (2, 3)],
            velocities=[*[(0.0, 0.0)] * 2, *[(0.0, speed)] * 2], stiffness=(1.0, 0.0), held=(0, 1),
            contact=contact, integrator=Integrator(method=method, dt=dt),
        )  # fmt: skip
        assert left_with(Simulation(scene), 2, -contact.distance) <= most * speed


def test_a_body_at_rest_on_a_floor_needs_no_shorter_steps() -> None:
    scene = falling(0.0, 0.0, FLOOR, "generalized_alpha", 1.0 / 60.0)
    simulation = after(replace(scene, gravity=(0.0, 2000.0), air_friction=0.1), 20.0)
    simulation.stats()
    simulation.step(20)
    assert simulation.stats().steps == 20


def height_after(
    bounces: int, method: Method, height: float, dt: float = 0.0025, tolerance: float = 0.1
) -> float:
    """The part of its height that a mass is left with at bounciness 1."""
    scene = Scene(
        name="ball", masses=(Mass(position=(0.0, -height)),), gravity=(0.0, 1000.0), air_friction=0.0,
        walls=(replace(FLOOR, bounciness=1.0, hardness=1e4, friction=0.0),),
        integrator=Integrator(method=method, dt=dt, tolerance=tolerance),
    )  # fmt: skip
    simulation, before, left = Simulation(scene), 0.0, 1.0
    while bounces:
        simulation.step()
        fall = float(simulation.velocities[0, 1])
        if before < 0.0 <= fall:
            bounces -= 1
            left = (0.5 * fall**2 / 1000.0 - float(simulation.positions[0, 1])) / height
        before = fall
    return left


@pytest.mark.parametrize(
    ("method", "tenth", "thousandth"),
    [("auto", 0.984, 0.999), ("adams", 0.957, 0.999), ("rodas4", 0.980, 1.0), ("rodas5p", 1.008, 1.001)],
)
def test_what_bounces_for_ever_keeps_its_height_by_the_tolerance(
    method: Method, tenth: float, thousandth: float
) -> None:
    """docs/surroundings.md has these numbers."""
    assert abs(height_after(100, method, 200.0, tolerance=1e-3) - 1.0) <= 1.1e-3
    assert height_after(100, method, 200.0, tolerance=0.1) == pytest.approx(tenth, abs=0.01)
    assert thousandth == pytest.approx(height_after(100, method, 200.0, tolerance=1e-3), abs=1e-3)


@pytest.mark.parametrize("method", ["symplectic_euler", "velocity_verlet", "rk4"])
def test_a_fixed_step_that_resolves_a_bounce_keeps_its_height(method: Method) -> None:
    assert height_after(100, method, 200.0, dt=0.001) > 0.99
    assert height_after(100, method, 200.0, dt=0.0005) == pytest.approx(1.0, abs=1e-3)
    assert height_after(100, method, 200.0, dt=0.0025) < 0.2


def test_whoever_sets_the_bounciness_is_told_what_a_fixed_step_takes() -> None:
    bounciness = SETTINGS["bounciness"]
    scene = falling(100.0, 0.0, FLOOR, "velocity_verlet", 0.0025)
    assert "fast bounces lose more" in bounciness.remark(scene)
    assert bounciness.remark(by(scene, "auto")) == ""
