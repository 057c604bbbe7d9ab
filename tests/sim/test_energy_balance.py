"""Tracking the energy only reads: the motion is the same with it and without."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Anchor, Integrator, SceneError, Simulation
from sim.scene.types import Circle, ForceLaw, Method
from sim.solve.registry import METHODS
from tests.sim.bodies import LAWS, body
from tests.sim.changes import by
from tests.sim.fuzzing import STEPS, wild_scene, wild_world, with_muscles
from tests.sim.inside import same_state


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", ["chain", "ring"])
@pytest.mark.parametrize("method", METHODS)
def test_tracking_the_energy_does_not_change_the_motion(method: Method, shape: str, law: ForceLaw) -> None:
    # With a first mass that is free, and with one that is held and led.
    for held in ((), (0,)):
        scene = body(shape, law, 1, twist=0.0, held=held)
        scene = by(scene, method, dt=1e-4, tolerance=1e-4)
        with_tracking, without = Simulation(scene), Simulation(scene)
        with_tracking.track_energy(True)
        x, y = scene.masses[0].position
        for i in range(5):
            for simulation in (with_tracking, without):
                if held:
                    simulation.lead(0, (x + i, y - i))
                # One step each, since the balance of symplectic Euler is kept step by step.
                for _ in range(20):
                    assert simulation.step() == 1
        assert same_state(with_tracking, without)


def test_nor_do_they_change_whole_frames_of_wild_scenes() -> None:
    # A rough tolerance, so that springs turn and shrink within few steps.
    looked_at = 0
    for seed in range(150):
        scene = wild_scene(np.random.default_rng(seed))
        scene = by(scene, "auto", tolerance=1.0)
        try:
            with_tracking, without = Simulation(scene), Simulation(scene)
        except SceneError:
            continue
        looked_at += 1
        with_tracking.track_energy(True)
        for _ in range(6):
            for simulation in (with_tracking, without):
                simulation.step(STEPS, attempts=400)
        assert same_state(with_tracking, without), seed
    assert looked_at > 100


def test_nor_that_of_what_muscles_pull_until_it_yields() -> None:
    for seed in (31, 33, 171, 197, 269):
        rng = np.random.default_rng(seed)
        scene = with_muscles(wild_world(wild_scene(rng), rng), rng)
        for method in ("velocity_verlet", "rk4"):
            with_tracking, without = (Simulation(scene, integrator=method) for _ in range(2))
            with_tracking.track_energy(True)
            for simulation in (with_tracking, without):
                simulation.step(150)
            assert same_state(with_tracking, without), (seed, method)


@pytest.mark.parametrize("method", METHODS)
def test_what_is_asked_in_between_does_not_change_the_motion(method: Method) -> None:
    scene = by(body("chain", "angle", 2), method, dt=1e-3, tolerance=1e-3)
    asked, left = Simulation(scene), Simulation(scene)
    for _ in range(30):
        asked.stability()
        asked.stats()
        assert asked.angles.size == asked.rest_angles.size
        assert asked.pose().positions
        assert asked.step() == left.step()
    assert same_state(asked, left)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("method", ["auto", "adams", "rodas5p", "symplectic_euler"])
def test_what_a_hand_takes_and_gives_back_is_entered(method: Method, law: ForceLaw) -> None:
    scene = body("cloth", law, 1, twist=0.0, held=(0,))
    scene = by(scene, method, dt=1e-5, tolerance=1e-6)
    simulation, mass = Simulation(scene), 6
    kilograms = scene.masses[mass].mass

    def of_height() -> float:
        return -kilograms * float(simulation.positions[mass] @ scene.gravity)

    simulation.energy()
    simulation.step(500)
    before = simulation.energy()
    kinetic = 0.5 * kilograms * float(simulation.velocities[mass] @ simulation.velocities[mass])
    taken = kinetic + of_height()
    simulation.grab(mass)
    grabbed = simulation.energy()
    assert grabbed.anchors - before.anchors == pytest.approx(-taken)
    x, y = simulation.positions[mass]
    simulation.lead(mass, (float(x) + 3.0, float(y) - 5.0))
    simulation.step(500)
    led = simulation.energy()
    simulation.release(mass)
    released = simulation.energy()
    assert released.anchors - led.anchors == pytest.approx(of_height())
    simulation.step(500)
    # Nothing comes from nowhere: neither at once nor while it is in hand.
    wrong = 0.05 * kinetic if method == "symplectic_euler" else 0.01 * abs(of_height())
    for balance in (grabbed, led, released, simulation.energy()):
        assert abs(balance.residual) < wrong


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("method", [name for name, info in METHODS.items() if info.adaptive])
def test_a_body_in_many_hands_has_a_balance_that_closes(method: Method, law: ForceLaw) -> None:
    """No error of a free mass keeps the steps short."""
    scene = body("tree", law, 1, held=tuple(range(15)))
    anchors = tuple(Anchor(mass=i, circle=Circle(radius=5.0 + i, frequency=20.0)) for i in range(15))
    scene = replace(scene, anchors=anchors, integrator=Integrator(method=method))
    simulation = Simulation(scene)
    first = simulation.energy()
    for _ in range(5):
        simulation.lead(3, (100.0, 100.0))
        assert simulation.step(7, attempts=400) == 7
    assert abs(simulation.energy().residual) < 1e-4 * first.total


def test_a_body_that_starts_elsewhere_starts_with_a_new_balance() -> None:
    scene = body("chain", "conservative", 1, twist=0.0, held=())
    simulation, other = Simulation(scene), Simulation(scene)
    simulation.energy()
    simulation.step(10)
    other.step(50)
    simulation.take_state(other)
    balance = simulation.energy()
    assert balance.damping == balance.residual == 0.0
    assert balance.kinetic > 0.0
