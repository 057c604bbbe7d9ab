"""Every compiled path against `sim.forces.reference`, the statement of the physics in NumPy."""

from __future__ import annotations

from itertools import product
from typing import get_args

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, Circle, Integrator, Scene, Simulation
from sim.scene.types import ForceLaw, Method
from tests.amount import NIGHT, part_of
from tests.sim.bodies import SHAPES, body
from tests.sim.changes import with_masses
from tests.sim.fuzzing import with_muscles
from tests.sim.inside import by_numpy, general

LAWS: tuple[ForceLaw, ...] = get_args(ForceLaw)


def plain(scene: Scene) -> Simulation:
    return by_numpy(Simulation(scene))


def lively(shape: str, law: ForceLaw, method: Method, seed: int) -> Scene:
    """A body with damping everywhere, air, loads, an anchor that goes round and keys that do something."""
    scene = with_masses(body(shape, law, seed), force=lambda i, _: (200.0 * i, -300.0))
    circle = Circle(radius=5.0, frequency=20.0, ramp=1e-3)
    return replace(
        scene,
        anchors=(sim.Anchor(mass=0, circle=circle),),
        arrow_keys=sim.ArrowKeys(),
        integrator=Integrator(method=method, dt=2e-5),
    )


RUNS = product(["symplectic_euler", "velocity_verlet"], SHAPES, LAWS, ["own", "general", "muscles"])


@pytest.mark.parametrize(("method", "shape", "law", "path"), part_of([*RUNS], 3))
def test_a_run_by_numpy_is_that_of_the_kernels(method: Method, shape: str, law: ForceLaw, path: str) -> None:
    scene = lively(shape, law, method, seed=3)
    if path == "muscles":
        scene = with_muscles(scene, np.random.default_rng(1))
    one, other = plain(scene), Simulation(scene)
    if path == "general":
        other = general(other)
    start = one.positions
    last = len(scene.masses) - 1
    for simulation in (one, other):
        simulation.step(30)
        simulation.keys = {"up", "right"}
        simulation.grab(last)
        x, y = simulation.positions[last]
        simulation.lead(last, (x + 2.0, y - 1.0))
        simulation.step(30)
        simulation.release(last)
        simulation.keys = ()
        simulation.step(40)
    assert one.plain
    assert np.abs(one.positions - start).max() > 0.1
    assert one.positions == pytest.approx(other.positions, abs=1e-9)
    assert one.velocities == pytest.approx(other.velocities, abs=1e-6)
    assert one.rest_angles == pytest.approx(other.rest_angles, abs=1e-12)


def test_a_body_that_runs_away_from_its_fixed_step_stops_at_its_last_good_state() -> None:
    scene = sim.set_value(sim.load_scene("tutorial-3.3"), "linear_stiffness", 1e6)
    one, other = plain(scene), Simulation(scene)
    done = [simulation.step(5000) for simulation in (one, other)]
    assert done[0] == pytest.approx(done[1], abs=2)
    assert one.divergence is not None
    assert one.divergence.quantity == "speed"
    assert np.abs(one.velocities).max() <= 1e6
    assert np.isfinite(one.positions).all()


def test_a_body_too_stiff_for_numpy_is_late_and_not_lost() -> None:
    scene = sim.load_scene("study-w4")
    simulation = plain(scene)
    assert simulation.step(100, attempts=50) < 100
    assert simulation.divergence is None
    assert simulation.stats().steps == 50


@pytest.mark.parametrize("name", part_of([info.name for info in sim.list_scenes() if info.built_in], 3))
def test_every_preset_moves_by_numpy(name: str) -> None:
    scene, steps = sim.load_scene(name), 40 if NIGHT else 8
    simulation = plain(scene)
    assert simulation.step(steps) == steps
    assert simulation.time == pytest.approx(steps * scene.integrator.dt)
    assert simulation.divergence is None
    if len(scene.anchors) < len(scene.masses):
        assert simulation.velocities.any()
    exact = Simulation(scene)
    exact.step(steps)
    assert simulation.positions == pytest.approx(exact.positions, abs=0.2)


def test_all_masses_held_go_where_they_are_led() -> None:
    scene = sim.load_scene("tutorial-3.1")
    simulation = plain(scene)
    simulation.lead(0, (250.0, 260.0))
    assert simulation.step(4) == 4
    assert simulation.positions[0].tolist() == [250.0, 260.0]
    assert simulation.anchors == scene.anchors
    assert isinstance(scene.anchors[0], Anchor)
