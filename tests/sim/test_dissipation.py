"""What dampers take away, however strong they are: closed forms, and an energy balance that closes."""

from __future__ import annotations

import math
from typing import Any

import pytest
from msgspec.structs import replace

import sim
from sim import Scene, Simulation
from sim.scene.surroundings import Ground, Medium, Wind
from sim.scene.types import Method
from sim.solve.registry import METHODS
from tests.sim.bodies import body
from tests.sim.builders import built, row
from tests.sim.changes import after, by

STRENGTHS = [0.1, 1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6]

MASSES, SPEED = (1.0, 3.0), 100.0
REDUCED = MASSES[0] * MASSES[1] / sum(MASSES)


def pair(damping: float) -> Scene:
    """Two masses that fly apart, and nothing but a damper between them."""
    return built(
        [(0.0, 0.0), (50.0, 0.0)], mass=MASSES, velocities=[(0.0, 0.0), (SPEED, 0.0)], damping=damping
    )


def hinge(damping: float) -> Scene:
    """Three masses in line, held together by damped springs; their joint has nothing but a damper."""
    speeds = [(0.0, speed) for speed in (SPEED, -2.0 * SPEED, SPEED)]
    joint = {"stiffness": 0.0, "damping": damping}
    return built(row(3, 40.0), velocities=speeds, stiffness=1e5, damping=40.0, joint=joint)


@pytest.mark.parametrize("damping", STRENGTHS)
@pytest.mark.parametrize("method", ["auto", "rodas4", "rodas5p"])
def test_a_damper_takes_what_its_masses_had_of_each_other(method: Method, damping: float) -> None:
    simulation = Simulation(pair(damping), integrator=method)
    first = simulation.energy()
    simulation.step(400)
    calmed = 1.0 - math.exp(-2.0 * damping * simulation.time / REDUCED)
    taken = 0.5 * REDUCED * SPEED**2 * calmed
    balance = simulation.energy()
    assert first.total - balance.total == pytest.approx(taken, rel=0.01)
    assert -balance.damping == pytest.approx(taken, rel=0.6 if damping == 1e6 else 0.05)


@pytest.mark.parametrize("damping", STRENGTHS[:6])
def test_a_damper_of_a_joint_takes_no_more_than_there_is(damping: float) -> None:
    simulation = Simulation(hinge(damping), integrator="auto")
    first = simulation.energy()
    simulation.step(400)
    balance = simulation.energy()
    assert -balance.damping <= 1.05 * first.total
    assert abs(balance.residual) < 0.05 * first.total


@pytest.mark.parametrize("key", ["linear_damping", "angular_damping"])
@pytest.mark.parametrize("name", ["tutorial-3.3", "ring", "flag-pole", "study-cloth"])
def test_the_balance_closes_at_any_damping(name: str, key: str) -> None:
    scene = sim.load_scene(name)
    scene = replace(scene, force_law="conservative", integrator=sim.Integrator())
    for damping in (1e1, 1e2, 1e3, 1e4, 1e5):
        simulation = Simulation(sim.set_value(scene, key, damping))
        first = simulation.energy()
        for _ in range(30):
            simulation.step(7)
        balance = simulation.energy()
        put_in = abs(first.gravity - balance.gravity) + first.linear + first.angular
        assert abs(balance.residual) < 0.08 * (put_in + balance.kinetic), damping


@pytest.mark.parametrize("friction", [5.0, 100.0])
@pytest.mark.parametrize("method", [name for name, info in METHODS.items() if info.order != 1])
def test_strong_friction_takes_what_there_is(method: Any, friction: float) -> None:
    """Two masses on a spring that fall aslant on a rough floor, and creep on it within a step's errors."""
    floor = sim.Wall(point=(0.0, 0.0), normal=(0.0, -1.0), friction=friction, bounciness=0.5)
    dt = 1.0 / 60.0 if METHODS[method].adaptive else 1e-3
    scene = built(
        [(0.0, -30.0), (30.0, -30.0)], velocities=[(300.0, 200.0)] * 2, stiffness=2000.0, damping=2.0,
        gravity=(0.0, 1000.0), walls=(floor,),
        integrator=sim.Integrator(method=method, dt=dt, tolerance=0.1),
    )  # fmt: skip
    simulation = after(scene, 1.5)
    balance = simulation.energy()
    assert abs(balance.residual) < 0.015 * abs(balance.friction)
    assert -2.0e5 < balance.friction < -1.5e5


RESISTED: dict[str, dict[str, Any]] = {
    "medium in wind": {"medium": Medium(across=1e6, along=5e5), "wind": Wind(velocity=(300.0, -80.0))},
    "ground": {
        "ground": Ground(forward=100.0, backward=100.0, sideways=100.0, slip_speed=1e-3),
        "gravity": (0.0, 0.0),
    },
    "both": {"medium": Medium(across=1e4), "ground": Ground(forward=9.0, slip_speed=1e-2)},
}


@pytest.mark.parametrize("tolerance", [1.0, 0.1, 1e-3])
@pytest.mark.parametrize("method", ["auto", "rodas4", "rodas5p"])
@pytest.mark.parametrize("around", RESISTED)
def test_the_balance_closes_at_any_resistance(around: str, method: Any, tolerance: float) -> None:
    """What a strong resistance does follows from displacements, not from speeds within the tolerance."""
    scene = by(replace(body("girder", "conservative", 1), **RESISTED[around]), method, tolerance=tolerance)
    balance = after(scene, 0.1).energy()
    assert abs(balance.residual) < 0.01 * max(abs(balance.air), abs(balance.friction))
