"""Springs that only pull or push, and joints that act on one side, against closed forms."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene
from sim.scene.types import Integrator, Method
from sim.store.files import decode_scene, encode_scene
from tests.sim.changes import after, by
from tests.sim.checks import known

G = (0.0, 1000.0)
ROPE = Scene(
    name="bungee",
    masses=(Mass(position=(0.0, 0.0)), Mass(position=(0.0, 0.001))),
    linear_springs=(LinearSpring(a=0, b=1, stiffness=200.0, rest_length=100.0, only="pull"),),
    anchors=(Anchor(mass=0),),
    gravity=G,
)
"""Let go at its anchor: it falls freely to 100 px, and to 100 + 5 (1 + sqrt 41) px in all."""
LOWEST = 100.0 + 5.0 * (1.0 + math.sqrt(41.0 - 0.4 * 0.001))
METHODS: tuple[Method, ...] = (
    "auto",
    "adams",
    "rodas4",
    "rodas5p",
    "velocity_verlet",
    "rk4",
    "generalized_alpha",
)


def heights(scene: Scene, seconds: float) -> np.ndarray:
    simulation, found = sim.Simulation(scene), []
    while simulation.time < seconds:
        simulation.step(1)
        found.append((simulation.time, simulation.positions[1, 1], simulation.velocities[1, 1]))
    return np.array(found)


@pytest.mark.parametrize("method", METHODS)
def test_a_jump_with_a_rope_ends_where_its_energy_says(method: Method) -> None:
    t, y, _ = heights(replace(ROPE, integrator=Integrator(method=method, dt=2e-4, tolerance=1e-4)), 1.4).T
    slack = math.sqrt(0.002 * (100.0 - 0.001))  # 0.44721 s
    fall = t < slack
    assert np.abs(y[fall] - 0.001 - 500.0 * t[fall] ** 2).max() < 1e-6
    close = 0.02 if method in ("generalized_alpha", "velocity_verlet", "rk4") else 1e-3
    assert y.max() == pytest.approx(LOWEST, abs=close)
    back = t[(t > 1.0) & (y < 0.01)]
    assert back.size == 0 or y[t > 1.0].min() > -close  # it comes back to where it was let go, and not higher


def test_what_only_pushes_throws_and_lets_go() -> None:
    """A spring gun: v = x sqrt(k / m)."""
    scene = replace(
        ROPE,
        masses=(Mass(position=(0.0, 0.0)), Mass(position=(60.0, 0.0))),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=900.0, rest_length=100.0, only="push"),),
        gravity=(0.0, 0.0),
    )
    simulation = sim.Simulation(by(scene, "rodas5p", tolerance=1e-6))
    simulation.advance(0.5)
    assert simulation.velocities[1, 0] == pytest.approx(40.0 * 30.0, rel=1e-6)


def stopped(only: str, weight: float) -> Scene:
    """A rod on a pivot whose angle to a fixed one is held by a stop at 30°."""
    masses = ((0.0, 0.0), (-50.0, 0.0), (0.0, -80.0))
    return Scene(
        name="stop",
        masses=tuple(Mass(position=place) for place in masses),
        linear_springs=(
            LinearSpring(a=1, b=0, stiffness=1e6, rest_length=50.0),
            LinearSpring(a=0, b=2, stiffness=1e6, damping=200.0, rest_length=80.0),
        ),
        angular_springs=(
            AngularSpring(a=0, b=1, stiffness=50.0, damping=5.0, rest_angle=30.0, only=only),  # pyright: ignore
        ),
        anchors=(Anchor(mass=0), Anchor(mass=1)),
        gravity=(0.0, weight),
        integrator=Integrator(method="rodas5p", tolerance=1e-4),
    )


def test_a_rod_that_falls_on_its_stop_rests_where_the_torques_balance() -> None:
    """K |A| sin(over) = m g cos(angle), and no torque before the stop."""
    scene = stopped("above", 1000.0)
    start = replace(scene.masses[2], position=(80.0 * math.cos(0.1), 80.0 * math.sin(0.1)))
    scene = replace(scene, masses=(*scene.masses[:2], start))
    simulation = sim.Simulation(scene)
    simulation.advance(0.02)
    assert simulation.loads.torques[0] == 0.0
    simulation.advance(20.0)
    x, y = simulation.positions[2]
    angle = math.atan2(y, x)
    over = angle - math.radians(30.0)
    assert over > 0.0
    assert 50.0 * 50.0 * math.sin(over) == pytest.approx(1000.0 * math.cos(angle), rel=1e-5)
    other = sim.equilibrium(scene)
    assert other.positions[2] == pytest.approx((x, y), abs=1e-3)


@pytest.mark.parametrize("method", ["auto", "rodas5p", "velocity_verlet"])
def test_the_balance_closes_while_ropes_go_slack_and_stops_are_hit(method: Method) -> None:
    scene = stopped("above", 1000.0)
    scene = replace(
        scene,
        masses=(
            *scene.masses[:2],
            Mass(position=(79.6, 8.0)),
            Mass(position=(60.0, 60.0), velocity=(-400.0, 0.0)),
        ),
        linear_springs=(
            *scene.linear_springs,
            LinearSpring(a=2, b=3, stiffness=500.0, damping=3.0, rest_length=60.0, only="pull"),
            LinearSpring(a=0, b=3, stiffness=300.0, damping=1.0, rest_length=90.0, only="pull"),
        ),
        integrator=Integrator(method=method, dt=2e-5, tolerance=1e-5),
    )
    simulation = after(scene, 1.5)
    energy = simulation.energy()
    assert abs(energy.residual) < 1e-4 * (abs(energy.damping) + energy.kinetic)
    assert energy.damping < 0.0


def test_keep_shape_gives_a_slack_rope_nothing_to_bear() -> None:
    """A mass between two ropes: the upper one has all of its weight, and the lower one is just slack."""
    masses = (Mass(position=(0.0, 0.0)), Mass(position=(0.0, 80.0), mass=2.0), Mass(position=(0.0, 200.0)))
    ropes = (
        LinearSpring(a=0, b=1, stiffness=500.0, rest_length=10.0, only="pull"),
        LinearSpring(a=1, b=2, stiffness=500.0, rest_length=10.0, only="pull"),
    )
    scene = Scene(
        name="between",
        masses=masses,
        linear_springs=ropes,
        anchors=(Anchor(mass=0), Anchor(mass=2)),
        gravity=G,
    )
    kept = sim.keep_shape(scene)
    assert [spring.rest_length for spring in kept.linear_springs] == pytest.approx([76.0, 120.0])
    assert sim.equilibrium(kept).positions[1] == pytest.approx((0.0, 80.0), abs=1e-9)


def test_a_file_has_it_and_a_spring_of_both_sides_has_nothing_in_it() -> None:
    assert decode_scene(encode_scene(ROPE), "it") == ROPE
    assert b"only" not in encode_scene(replace(sim.rope(masses=4), bodies=()))


def test_what_does_not_act_neither_breaks_nor_yields() -> None:
    """A slack rope, until it is taut; a buffer and a stop that would yield on their other sides."""
    weak = replace(ROPE.linear_springs[0], strength=3000.0)
    simulation = sim.Simulation(replace(ROPE, linear_springs=(weak,)))
    simulation.advance(0.4)
    assert simulation.damage is None
    simulation.advance(0.4)
    assert known(simulation.damage).broken == (0,)
    assert abs(simulation.energy().residual) < 1e-3 * 1000.0 * LOWEST
    buffer = LinearSpring(a=0, b=1, stiffness=200.0, rest_length=50.0, only="push", yield_force=100.0)
    far = (ROPE.masses[0], Mass(position=(0.0, 90.0)))
    thrown = sim.Simulation(replace(ROPE, masses=far, linear_springs=(buffer,)))
    (joint,) = stopped("below", 0.0).angular_springs
    loose = replace(joint, only="above", yield_torque=1000.0)
    stop = sim.Simulation(replace(stopped("above", 0.0), angular_springs=(loose,)))
    for still in (thrown, stop):
        still.advance(0.1)
        assert still.damage is None or not any((*still.damage.set_lengths, *still.damage.set_angles))


def test_steps_bear_ropes_that_are_slack_and_stops_that_are_not_reached() -> None:
    limit = sim.Simulation(by(ROPE, "symplectic_euler")).stability().limit
    assert limit == pytest.approx(2.0 / math.sqrt(200.0), rel=0.01)
    stop = by(stopped("above", 1000.0), "symplectic_euler")
    (joint,) = stop.angular_springs
    stiff = replace(joint, stiffness=1e7)
    at_rest = replace(stiff, rest_angle=-90.0, only=msgspec.UNSET)
    limits = [
        sim.Simulation(replace(stop, angular_springs=(one,))).stability().limit for one in (stiff, at_rest)
    ]
    assert limits[0] == pytest.approx(limits[1], rel=0.01)
    assert limits[0] < 0.7 * sim.Simulation(stop).stability().limit
