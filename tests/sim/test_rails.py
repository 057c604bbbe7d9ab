"""Masses on rails, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, LinearSpring, Mass, Scene
from sim.analysis.modes import Modes
from sim.analysis.vibrations import free_vibrations
from sim.errors import SceneError
from sim.scene.types import Circle, Integrator, Method
from tests.sim.changes import after, by

G, L = 1000.0, 100.0
METHODS: tuple[Method, ...] = ("auto", "adams", "rodas5p", "velocity_verlet", "rk4", "generalized_alpha")


def cart(angle: float, heavy: float = 2.0, **fields: Any) -> Scene:
    """A pendulum of 1 kg and 100 px on a cart on a level rail."""
    bob = L * math.sin(angle), L * math.cos(angle)
    return Scene(
        name="cart",
        masses=(Mass(position=(0.0, 0.0), mass=heavy, rail=(2.0, 0.0)), Mass(position=bob)),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=1e7, rest_length=L - 1e-4),),
        gravity=(0.0, G),
        **fields,
    )


@pytest.mark.parametrize("method", METHODS)
def test_a_pendulum_on_a_cart_swings_faster(method: Method) -> None:
    """omega² = (g / L) (1 + m / M), and the cart goes by m / (M + m) of the width to the other side."""
    omega = math.sqrt(G / L * 1.5)
    scene = replace(cart(0.001), integrator=Integrator(method=method, dt=2e-4, tolerance=1e-5))
    simulation = sim.Simulation(scene)
    simulation.advance(math.pi / omega)  # half a swing
    (x, y), (bob, _) = simulation.positions.tolist()
    assert y == 0.0
    assert (x, bob) == (pytest.approx(0.2 / 3.0, abs=1e-3), pytest.approx(0.2 / 3.0 - 0.1, abs=1e-3))


def test_the_balance_closes_and_momentum_along_the_rail_stays() -> None:
    simulation = sim.Simulation(by(cart(1.2), tolerance=1e-4))
    start = simulation.energy()
    simulation.advance(2.0)
    assert abs(simulation.energy().residual) < 1e-4 * abs(start.gravity)
    assert 2.0 * simulation.velocities[0, 0] + simulation.velocities[1, 0] == pytest.approx(0.0, abs=1e-4)


def test_vibrations_and_modes_know_the_rail() -> None:
    scene = replace(cart(0.0), integrator=Integrator())
    posed = replace(scene, pose=sim.equilibrium(scene))
    slow = free_vibrations(posed, 3).omega
    assert slow[0] == pytest.approx(math.sqrt(G / L * 1.5), rel=1e-5)
    assert slow.size == 2  # the cart itself is free to roll
    assert Modes(posed, 2).omega[0] == pytest.approx(slow[0], rel=1e-5)


def test_the_stability_limit_is_that_of_motions_along_the_rail() -> None:
    scene = by(cart(1.0, heavy=0.5), "symplectic_euler", dt=1e-4)
    omega = math.sqrt(1e7 * (1.0 + math.sin(1.0) ** 2 / 0.5))
    assert sim.Simulation(scene).stability().limit == pytest.approx(2.0 / omega, rel=1e-3)


def test_a_held_mass_on_a_rail_is_led_along_it() -> None:
    slope = Mass(position=(0.0, 0.0), rail=(3.0, 4.0))
    simulation = sim.Simulation(by(Scene(name="led", masses=(slope,), anchors=(Anchor(mass=0),))))
    simulation.lead(0, (50.0, 0.0))
    simulation.advance(0.1)
    assert simulation.positions[0] == pytest.approx([18.0, 24.0])  # the nearest place on the rail
    simulation.move(0, (0.0, 50.0))
    assert simulation.positions[0] == pytest.approx([24.0, 32.0])


def test_a_circle_of_a_held_mass_on_a_rail_goes_to_and_fro() -> None:
    led = Mass(position=(0.0, 0.0), rail=(0.0, 1.0))
    turning = Anchor(mass=0, circle=Circle(radius=10.0, frequency=1.0, ramp=1e-3))
    for method in ("auto", "velocity_verlet"):
        simulation = after(by(Scene(name="led", masses=(led,), anchors=(turning,)), method), 0.501)
        assert simulation.positions[0] == pytest.approx([0.0, 20.0], abs=1e-3)


def kapitza(frequency: float, radius: float = 10.0) -> Scene:
    """A pendulum upside down, 0.1 rad off, whose pivot goes up and down."""
    bob = L * math.sin(0.1), -L * math.cos(0.1)
    return Scene(
        name="kapitza",
        masses=(Mass(position=(0.0, 0.0), rail=(0.0, 1.0)), Mass(position=bob)),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=1e7, damping=10.0, rest_length=L),),
        anchors=(Anchor(mass=0, circle=Circle(radius=radius, frequency=frequency, ramp=1e-3)),),
        gravity=(0.0, G),
        integrator=Integrator(tolerance=0.05),
    )


def test_kapitzas_pendulum_stands_upright_where_its_pivot_is_fast() -> None:
    """a² omega² > 2 g L: that is from 7.12 Hz on."""
    least = math.sqrt(2.0 * G * L) / 10.0 / math.tau
    assert least == pytest.approx(7.118, abs=1e-3)
    stands, falls = sim.Simulation(kapitza(1.5 * least)), sim.Simulation(kapitza(0.6 * least))
    heights = []
    for _ in range(20):
        stands.advance(0.1)
        heights.append(stands.positions[0, 1] - stands.positions[1, 1])
    assert min(heights) > 0.9 * L
    falls.advance(1.0)
    assert falls.positions[0, 1] - falls.positions[1, 1] < 0.9 * L


def test_a_bead_on_a_slope_slides_and_needs_no_wall() -> None:
    """g sin(angle) along the rail."""
    bead = Scene(name="bead", masses=(Mass(position=(0.0, 0.0), rail=(4.0, 3.0)),), gravity=(0.0, G))
    assert after(bead, 0.5).positions[0] == pytest.approx([0.48 * 125.0 / 0.6 * 0.6, 0.36 * 125.0], rel=1e-9)
    fast = replace(bead, gravity=(0.0, 0.0), masses=(replace(bead.masses[0], velocity=(100.0, 0.0)),))
    assert sim.Simulation(fast).velocities[0] == pytest.approx([64.0, 48.0])


def test_a_shape_is_kept_on_a_rail_and_at_rest_there() -> None:
    """A beam between an anchor and a mass on an upright rail: the rail takes what it pushes sideways."""
    scene = Scene(
        name="prop",
        masses=(
            Mass(position=(0.0, 0.0)),
            Mass(position=(60.0, 80.0)),
            Mass(position=(120.0, 0.0), rail=(1.0, 0.0)),
        ),
        linear_springs=(
            LinearSpring(a=0, b=1, stiffness=1e4, rest_length=100.0),
            LinearSpring(a=1, b=2, stiffness=1e4, rest_length=100.0),
            LinearSpring(a=0, b=2, stiffness=1e4, rest_length=120.0),
        ),
        anchors=(Anchor(mass=0),),
        gravity=(0.0, -G),
    )
    rests = sim.equilibrium(scene)
    still = after(by(replace(scene, pose=rests), tolerance=1e-4), 0.5)
    assert np.abs(still.velocities).max() < 1e-2
    assert rests.positions[2][1] == 0.0
    kept = sim.keep_shape(scene)
    assert np.abs(after(by(kept, tolerance=1e-4), 0.5).velocities).max() < 1e-2
    # Each bar bears 1 / (2 sin) of the weight.
    assert kept.linear_springs[0].rest_length == pytest.approx(100.0 + 625.0 / 1e4, rel=1e-6)


def test_a_direction_of_nothing_is_refused() -> None:
    wrong = Scene(name="wrong", masses=(Mass(position=(0.0, 0.0), rail=(0.0, 0.0)),))
    with pytest.raises(SceneError, match=r"masses\[0\].rail: a direction of \(0, 0\) points nowhere"):
        sim.validate(wrong)
