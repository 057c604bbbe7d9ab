"""The net force on each mass and the torque of each joint."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, Circle, Integrator, Scene, Simulation
from sim.scene.types import ForceLaw
from tests.sim.bodies import LAWS, SHAPES, body
from tests.sim.builders import built
from tests.sim.changes import by
from tests.sim.checks import known
from tests.sim.surrounded import bare, surrounded, with_everything
from tests.sim.touching import crumpled

H = 1e-5
"""Step of the differences, s."""


def by_differences(scene: Scene, steps: int = 400) -> tuple[Simulation, np.ndarray, np.ndarray]:
    """A simulation, its forces, and mass times acceleration by differences of its velocities.

    A held mass has none of the latter.
    """
    scene = by(scene, "rk4", dt=H)
    simulation = Simulation(scene)
    simulation.step(steps - 1)
    before = simulation.velocities
    simulation.step()
    forces = simulation.loads.forces
    moment = simulation.capture()
    simulation.step()
    mass = np.array([m.mass for m in scene.masses])[:, None]
    differences = mass * (simulation.velocities - before) / (2.0 * H)
    simulation.restore(moment)
    assert simulation.loads.forces == pytest.approx(forces, rel=1e-9, abs=1e-6), (
        "as it was, gone back in time"
    )
    return simulation, forces, differences


def oscillator(damping: float = 0.0) -> Scene:
    """A mass of 2 kg on a spring along x, stretched by 50 px, and an anchor."""
    return built(
        [(0.0, 0.0), (150.0, 0.0)], mass=(1.0, 2.0), stiffness=900.0, rest_length=100.0, damping=damping,
        held=(0,), integrator=Integrator(method="rk4", dt=1e-3),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("scene", "steps", "near"),
    [
        *(pytest.param(body(shape, law), 400, 1e-5, id=f"{shape} {law}") for shape in SHAPES for law in LAWS),
        pytest.param(surrounded("all"), 100, 1e-4, id="all around"),
        pytest.param(crumpled("girder"), 20, 1e-4, id="contact"),
        # The masses of what yields are pulled by a changing rest length, which the differences lag behind.
        pytest.param(with_everything(), 3000, 1e-3, id="what breaks and yields"),
    ],
)
def test_forces_are_mass_times_acceleration(scene: Scene, steps: int, near: float) -> None:
    simulation, forces, differences = by_differences(scene, steps)
    assert np.abs(differences).max() > 1e3
    assert forces == pytest.approx(differences, rel=near, abs=near * np.abs(differences).max())
    if (without := bare(scene)) != scene:
        assert np.abs(Simulation(scene).loads.forces - Simulation(without).loads.forces).max() > 1e3
    if steps == 3000:
        damage = known(simulation.damage)
        assert damage.broken and any(damage.set_lengths)


def test_a_joint_whose_spring_is_broken_has_no_torque() -> None:
    scene = body("tree", damping=0.0)
    springs = (replace(scene.linear_springs[0], strength=1.0), *scene.linear_springs[1:])
    simulation = Simulation(replace(scene, linear_springs=springs))
    assert np.abs(simulation.loads.torques).min() > 0.0
    simulation.step(400)
    assert simulation.damage is not None and simulation.damage.broken == (0,)
    loose = np.array([0 in (joint.a, joint.b) for joint in scene.angular_springs])
    assert loose.any() and not loose.all()
    assert (simulation.loads.torques[loose] == 0.0).all()
    assert np.abs(simulation.loads.torques[~loose]).min() > 0.0


def test_supports_bear_the_weight_of_a_body_at_rest() -> None:
    scene = sim.load_scene("cloth")
    simulation = Simulation(replace(scene, pose=sim.equilibrium(scene)))
    forces, held = simulation.loads.forces, [anchor.mass for anchor in scene.anchors]
    weight = sum(m.mass for m in scene.masses) * np.array(scene.gravity)
    assert forces[held].sum(axis=0) == pytest.approx(weight, rel=1e-6, abs=1e-6 * np.abs(weight).max())
    assert np.abs(np.delete(forces, held, axis=0)).max() < 1e-5 * np.abs(weight).max()


def test_a_hand_bears_what_hangs_on_it() -> None:
    scene = replace(oscillator(damping=50.0), gravity=(0.0, 500.0), air_friction=1.0)
    simulation = Simulation(scene)
    simulation.step(20)
    simulation.grab(1)
    x, y = simulation.positions[1]
    pull = 900.0 * (1.0 - 100.0 / math.hypot(x, y))
    # It is at rest in the hand: neither damping nor air has anything to do with it.
    assert simulation.loads.forces[1] == pytest.approx((-pull * x, 1000.0 - pull * y))


@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
def test_torques_are_those_of_the_law(law: ForceLaw) -> None:
    """Of a joint bent by 40° from its rest angle, whose second spring turns at 3 rad/s."""
    v, rest, stiffness, damping, spin = math.radians(60.0), math.radians(20.0), 500.0, 7.0, 3.0
    one, other = 30.0, 70.0
    tip = np.array((other * math.cos(v), other * math.sin(v)))
    scene = built(
        [(-one, 0.0), (0.0, 0.0), (tip[0], tip[1])], force_law=law,
        velocities=[(0.0, 0.0), (0.0, 0.0), (-spin * tip[1], spin * tip[0])],
        joint={"stiffness": stiffness, "damping": damping, "rest_angle": 20.0},
        integrator=Integrator(method="rk4", dt=1e-4),
    )  # fmt: skip
    simulation = Simulation(scene)
    loads = simulation.loads
    size = v - rest if law == "angle" else math.sin(v - rest)
    wanted = one * other * (stiffness * size + damping * spin)
    assert loads.torques == pytest.approx([wanted])
    # What is plotted has the same sign.
    assert sim.quantity("joint0.torque", scene).read(simulation) == pytest.approx(wanted)
    # The torque is what turns the first spring about the tip, and the second one the other way.
    assert -one * loads.forces[0][1] == pytest.approx(wanted)
    x, y = loads.forces[2]
    assert tip[0] * y - tip[1] * x == pytest.approx(-wanted)


def test_a_mass_that_is_led_in_a_circle_has_no_inertia_in_what_its_support_bears() -> None:
    circle = (Anchor(mass=0, circle=Circle(radius=50.0, frequency=1.0)),)
    simulation = Simulation(replace(oscillator(), anchors=circle))
    simulation.step(100)
    support, force = simulation.loads.forces
    assert np.abs(force).max() > 1e3
    assert support == pytest.approx(-force), "only the spring pulls at it"
