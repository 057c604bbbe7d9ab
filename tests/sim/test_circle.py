"""Anchors that go round: where they are at any time, whatever the method, and whoever leads them beside."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, Scene, Simulation
from sim.scene.types import Circle, ForceLaw, Method
from tests.sim.builders import built
from tests.sim.changes import apart, by
from tests.sim.checks import known

METHODS: tuple[Method, ...] = ("symplectic_euler", "velocity_verlet", "generalized_alpha", "rodas4", "auto")
CIRCLE = Circle(radius=35.0, frequency=1.7, ramp=0.15)
DT = 0.004


def off(circle: Circle, t: float) -> np.ndarray:
    """The displacement of the anchor at a time, as the docstring of `sim.Circle` has it."""
    p = 2.0 * math.pi * circle.frequency * (t - circle.ramp * (1.0 - math.exp(-t / circle.ramp)))
    return circle.radius * np.array([math.sin(p), 1.0 - math.cos(p)])


def rope(method: Method, circle: Circle = CIRCLE, law: ForceLaw = "conservative", dt: float = DT) -> Scene:
    """A rope of few masses, the first of which goes round."""
    numbers: dict[str, Any] = {"stiffness": 2000.0, "angular_stiffness": 300.0, "angular_damping": 2.0}
    scene = sim.rope(masses=5, **numbers, circle=circle, force_law=law)
    return by(scene, method, dt=dt, tolerance=1e-3)


START = np.array([300.0, 150.0])
"""Where the rope's first mass starts, px."""


def away(simulation: Simulation, circle: Circle = CIRCLE, at: np.ndarray = START) -> float:
    """How far the first mass is from where its circle, which began there, has led it."""
    return float(np.abs(simulation.positions[0] - at - off(circle, simulation.time)).max())


# ------------------------------------------------------------------------- by itself
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "circle",
    [
        pytest.param(CIRCLE, id="usual"),
        pytest.param(Circle(radius=12.0, frequency=-3.0), id="the other way"),
        pytest.param(Circle(radius=200.0, frequency=0.3, ramp=2.0), id="slow start"),
        pytest.param(Circle(radius=50.0, frequency=0.0), id="no turns"),
        pytest.param(Circle(radius=0.0, frequency=5.0), id="no radius"),
    ],
)
def test_it_goes_by_its_formula(circle: Circle, method: Method) -> None:
    simulation = Simulation(rope(method, circle))
    assert np.array_equal(simulation.positions[0], START)
    assert not simulation.velocities[0].any()
    for _ in range(60):
        assert simulation.step(5) == 5
        assert away(simulation, circle) <= 1e-10
        t = simulation.time
        speed = (off(circle, t + 1e-5) - off(circle, t - 1e-5)) / 2e-5
        assert np.abs(simulation.velocities[0] - speed).max() <= 1e-6 * circle.radius


@pytest.mark.parametrize("method", METHODS)
def test_several_anchors_go_their_own_ways_though_nothing_else_is_free(method: Method) -> None:
    other = Circle(radius=10.0, frequency=-0.9, ramp=0.5)
    held = (Anchor(mass=4, circle=other), *(Anchor(mass=i) for i in range(1, 4)))
    simulation = Simulation(replace(rope(method), bodies=(), anchors=(*held, Anchor(mass=0, circle=CIRCLE))))
    before = simulation.positions
    simulation.step(80)
    assert away(simulation) <= 1e-10
    assert np.abs(simulation.positions[4] - before[4] - off(other, 80 * DT)).max() <= 1e-10
    assert np.array_equal(simulation.positions[1:4], before[1:4])


# ------------------------------------------------------------------------- and what is done to it beside
def set_another_gravity(simulation: Simulation) -> None:
    here = simulation.positions[0]
    simulation.replace(sim.set_value(simulation.scene, "gravity", 500.0))
    assert np.array_equal(simulation.positions[0], here)


def hold_another_mass(simulation: Simulation) -> None:
    simulation.grab(3)
    simulation.lead(3, (320.0, 400.0))
    simulation.step(20)
    simulation.release(3)


def grab_the_anchor(simulation: Simulation) -> None:
    simulation.grab(0)
    simulation.step(5)
    simulation.release(0)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("do", [set_another_gravity, hold_another_mass, grab_the_anchor])
def test_it_goes_on_round_whatever_is_done_beside(do: Callable[[Simulation], None], method: Method) -> None:
    simulation = Simulation(rope(method))
    simulation.step(30)
    do(simulation)
    simulation.step(20)
    assert away(simulation) <= 1e-10


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("at_once", [True, False], ids=["moved", "led"])
def test_it_goes_on_round_where_it_was_put(at_once: bool, method: Method) -> None:
    simulation, to = Simulation(rope(method)), np.array([340.0, 120.0])
    simulation.step(30)
    (simulation.move if at_once else simulation.lead)(0, (340.0, 120.0))
    center = to - off(CIRCLE, 30 * DT)
    if not at_once:
        simulation.step(20)
        assert np.abs(simulation.positions[0] - to).max() <= 1e-10
        center = to - off(CIRCLE, 50 * DT)
    for _ in range(2):
        simulation.step(25)
        assert away(simulation, at=center) <= 1e-10


@pytest.mark.parametrize("method", METHODS)
def test_on_its_way_the_center_goes_in_a_straight_line(method: Method) -> None:
    # Cut into calls, each of which aims at where it ought to be then.
    simulation = Simulation(rope(method))
    simulation.step(30)
    start, drift = simulation.positions[0] - off(CIRCLE, 30 * DT), np.array([2.0, -1.0])
    whole = Simulation(rope(method))
    whole.step(30)
    x, y = start + 20 * drift + off(CIRCLE, 50 * DT)
    whole.lead(0, (x, y))
    whole.step(20)
    for i in range(1, 21):
        x, y = start + i * drift + off(CIRCLE, (30 + i) * DT)
        simulation.lead(0, (x, y))
        simulation.step()
    assert apart(whole, simulation) <= (1e-9 if method == "symplectic_euler" else 5e-2)


@pytest.mark.parametrize("method", ["symplectic_euler", "auto"])
def test_an_anchor_that_goes_round_beyond_the_edge_stops_there(method: Method) -> None:
    # Nothing is free, so there are no forces, and still nothing may leave the range of a scene file.
    circle = Circle(radius=10.0, frequency=2.0, ramp=0.01)
    scene = built([(0.0, 1e6)], anchors=(Anchor(mass=0, circle=circle),))
    simulation = Simulation(by(scene, method))
    assert simulation.step(100) < 100
    assert known(simulation.divergence).quantity == "position"
    assert abs(simulation.positions).max() <= 1e6
