"""Hard cases among walls: never a bad number, never stuck; the clock lags where computing is too slow."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Scene, Simulation, polygon
from sim.scene.surroundings import Gas, Ground, Wall, Wind
from sim.scene.types import Method
from sim.solve.registry import METHODS
from tests.sim.bodies import body
from tests.sim.builders import built
from tests.sim.changes import by, with_masses, with_springs
from tests.sim.checks import known
from tests.sim.surrounded import surrounded

FLOOR = Wall(point=(0.0, 0.0), normal=(0.0, -1.0))


def jelly(y: float, **fields: Any) -> Scene:
    """Four by four masses with springs along rows, columns and diagonals, the lowest at the height y."""
    at = [(30.0 * (i % 4), y - 30.0 * (i // 4)) for i in range(16)]
    near = [(i, k) for i, k in itertools.combinations(range(16), 2) if math.dist(at[i], at[k]) < 50.0]
    numbers: dict[str, Any] = {"mass": 0.5, "stiffness": 4000.0, "damping": 4.0}
    return built(at, near, **numbers, gravity=(0.0, 2000.0), **fields)


def frames(scene: Scene, method: Method, count: int = 60, dt: float = 1e-3) -> Simulation:
    """Sixty frames, each of which may try 1500 steps, as the page grants them."""
    simulation = Simulation(by(scene, method, dt=dt if not METHODS[method].adaptive else 1.0 / 60.0))
    simulation.energy()
    last = 0.0
    for _ in range(count):
        simulation.step(round(1.0 / 60.0 / simulation.dt), attempts=6000)
        assert np.isfinite(simulation.positions).all()
        assert np.isfinite(simulation.velocities).all()
        assert np.isfinite(simulation.energy().residual)
        if METHODS[method].adaptive:
            assert simulation.divergence is None
            assert simulation.time > last  # it may lag, but it goes on
            last = simulation.time
        elif simulation.divergence is not None:
            break  # a fixed step was too long, and it says so
    return simulation


@pytest.mark.parametrize("method", METHODS)
def test_dropped_from_the_highest_place_there_is(method: Method) -> None:
    # It arrives with 63 000 px/s.
    falling = with_masses(jelly(0.0, walls=(FLOOR,)), velocity=(0.0, math.sqrt(2.0 * 2000.0 * 9.9e5)))
    simulation = frames(falling, method)
    if METHODS[method].adaptive:
        assert simulation.time >= 0.3
        assert simulation.positions[:, 1].min() < 0.0


@pytest.mark.parametrize("method", METHODS)
def test_a_floor_through_the_middle_of_the_body_at_the_start(method: Method) -> None:
    simulation = frames(jelly(300.0, walls=(FLOOR,)), method)
    if METHODS[method].adaptive or METHODS[method].order == 1:
        # All of it comes out, at no more than a wall gives.
        assert simulation.divergence is None
        assert simulation.time >= 1.0 - 1e-9
        assert simulation.positions[:, 1].max() <= 30.0
        assert simulation.positions[:, 1].min() >= -2000.0


@pytest.mark.parametrize("method", ["auto", "adams", "rodas5p", "symplectic_euler", "velocity_verlet"])
def test_friction_of_ten(method: Method) -> None:
    scene = jelly(-20.0, walls=(replace(FLOOR, friction=10.0),))
    simulation = frames(with_masses(scene, velocity=(800.0, 0.0)), method, 120)
    assert simulation.divergence is None
    assert abs(simulation.velocities[:, 0].mean()) <= 300.0  # it tumbles over its lowest corner
    assert simulation.energy().friction < 0.0


@pytest.mark.parametrize("method", METHODS)
def test_a_girder_that_snaps_in_the_middle_of_a_step(method: Method) -> None:
    scene = with_springs(jelly(0.0, held=(12, 15)), strength=3000.0)
    simulation = frames(scene, method)
    assert known(simulation.damage).broken
    assert simulation.divergence is None


def test_walls_that_leave_no_room() -> None:
    walls = (FLOOR, replace(FLOOR, point=(0.0, -40.0), normal=(0.0, 1.0)))  # the jelly is 90 px high
    simulation = frames(jelly(0.0, walls=walls), "auto")
    assert simulation.time == pytest.approx(1.0)
    assert np.ptp(simulation.positions[:, 1]) <= 60.0


def test_a_gale() -> None:
    gale = Wind(velocity=(1e5, 0.0), turbulence=5.0, length_scale=50.0)
    frames(jelly(0.0, wind=gale, air_friction=1.0, held=(0,)), "auto")


def test_a_filling_of_a_loop_that_crosses_itself() -> None:
    crossing = Gas(masses=(0, 3, 12, 15), pressure=500.0, area=900.0)
    simulation = frames(jelly(-100.0, walls=(FLOOR,), fillings=(crossing,)), "auto")
    assert simulation.time == pytest.approx(1.0)


@pytest.mark.parametrize("method", METHODS)
def test_everything_at_once(method: Method) -> None:
    frames(with_springs(surrounded("all", seed=8), strength=5e4, yield_force=2e4), method, 30, 1e-4)


@pytest.mark.parametrize("method", ["auto", "adams", "rodas5p"])
def test_a_gas_in_a_flat_loop_gets_no_energy_from_nowhere(method: Method) -> None:
    # Its own area is 2e-6 px², so it was hard within less than a millionth of a px when the loop closed.
    ring = polygon(
        sides=12, circumradius=60.0, center=(300.0, 300.0), mass=0.2, stiffness=2000.0, damping=1.0,
        angular_stiffness=100.0, gravity=(0.0, 0.0), air_friction=0.0,
    )  # fmt: skip
    flat = with_masses(ring, position=lambda _, m: (m.position[0], 300.0 + 2e-10 * (m.position[1] - 300.0)))
    gas = Gas(masses=tuple(range(12)), pressure=300.0, outside=100.0)
    simulation = Simulation(by(replace(flat, fillings=(gas,)), method, dt=0.01, tolerance=0.1))
    largest = simulation.energy().linear
    for _ in range(30):
        assert simulation.step(1, attempts=20_000) == 1
        assert abs(simulation.energy().residual) <= 1e-3 * largest


@pytest.mark.parametrize(
    "fields",
    [
        {"ground": Ground(forward=mu, backward=mu, sideways=mu, slip_speed=1e-3), "gravity": (0.0, 0.0)}
        for mu in (100.0, 10.0)
    ]
    + [{"walls": (Wall(point=(0.0, 30.0), normal=(0.1, -1.0), friction=100.0, slip_speed=1e-3),)}],
)
def test_an_implicit_step_ends_where_masses_begin_to_stick(fields: dict[str, Any]) -> None:
    scene = replace(body("girder", "conservative", 1), **fields)
    simulation = Simulation(by(scene, "generalized_alpha", dt=1.0 / 960.0))
    assert simulation.step(240) == 240
    assert simulation.stats().steps < 20 * 240
