"""What lies between scenes and kernels: softened lengths, dead ends, what may change on the way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, Integrator, Scene, Simulation
from sim.model.system import build_system
from sim.motion.auto_costs import LONG
from sim.scene.types import Circle, Method
from sim.solve.registry import METHODS
from tests.sim.bodies import body
from tests.sim.builders import built
from tests.sim.changes import by, with_masses
from tests.sim.checks import known
from tests.sim.inside import drive, solver_of


def test_methods_and_tracking_may_be_changed_on_the_way() -> None:
    # Whatever is handed over once has to be handed over again when it is replaced.
    scene = body("chain", "conservative", 3)
    simulation = Simulation(scene)
    simulation.step(5)
    simulation.track_energy(True)
    simulation.energy()
    simulation.step(5)
    moving = simulation.energy()
    assert moving.damping < 0.0
    simulation.track_energy(False)
    simulation.step(5)
    simulation.track_energy(True)
    assert simulation.energy().damping == 0.0
    simulation.step(5)
    assert simulation.energy().damping < 0.0


@pytest.mark.parametrize("masses", [7, 8, 9, 15, 16, 17, LONG])
def test_the_balance_sees_the_hand_at_the_end_of_a_rope_of_any_length(masses: int) -> None:
    scene = sim.rope(masses, driven=None, integrator=Integrator(tolerance=1e-5))
    scene = replace(scene, bodies=(), anchors=(Anchor(mass=0), Anchor(mass=masses - 1, driven=True)))
    simulation = Simulation(scene)
    simulation.energy()
    x, y = simulation.positions[masses - 1]
    simulation.lead(masses - 1, (float(x) + 20.0, float(y) + 10.0))
    simulation.step(20)
    balance = simulation.energy()
    assert balance.anchors > 0.0
    assert abs(balance.residual) < 1e-3 * balance.anchors


def test_lengths_are_softened_far_below_the_tolerance_and_not_at_all_for_the_tutorial() -> None:
    def softened(**integrator: object) -> float:
        scene = replace(body("chain", "conservative", 1), integrator=Integrator(**integrator))  # type: ignore[arg-type]
        return math.sqrt(build_system(scene).body.softening)

    for tolerance in (0.1, 1e-3, 1e-6):
        assert 0.0 < softened(tolerance=tolerance) <= 0.03 * tolerance
    assert softened(method="symplectic_euler") < 1e-100
    assert softened(method="stable_spring") < 1e-100


def collapsing() -> Scene:
    """Two masses that fly through each other, a hair off the middle."""
    places, speeds = [(0.0, 0.0), (10.0, 0.003)], [(1500.0, 0.0), (-1500.0, 0.0)]
    return built(places, velocities=speeds, stiffness=1e4, rest_length=10.0, integrator=Integrator(dt=0.005))


@pytest.mark.parametrize("method", ["auto", "adams", "rodas4", "rodas5p"])
def test_a_spring_that_passes_through_a_point_keeps_its_energy(method: Method) -> None:
    simulation = Simulation(by(collapsing(), method, dt=0.005))
    before = simulation.energy()
    simulation.step()
    after = simulation.energy()
    # They have passed: nothing but a great many short steps shows that the spring pushed both ways.
    assert simulation.positions[0, 0] > simulation.positions[1, 0]
    start = before.kinetic + before.linear
    assert after.kinetic + after.linear == pytest.approx(start, rel=0.02)


def test_a_step_of_last_resort_keeps_within_bounds() -> None:
    # An anchor that goes round beyond the edge of what a scene may have.
    circle = Circle(radius=10.0, frequency=20.0, ramp=0.001)
    scene = with_masses(collapsing(), position=[(0.0, 1e6), (0.0, 1e6 - 10.0)], velocity=(0.0, 0.0))
    simulation = Simulation(replace(scene, anchors=(Anchor(mass=0, driven=True, circle=circle),)))
    solver_of(simulation).load(0.0)
    solver_of(simulation).fall_back(0.005, drive(simulation, 0.0, 0.005))
    assert simulation.positions[0, 1] == 1e6
    assert np.abs(simulation.positions).max() <= 1e6
    simulation.step()
    assert known(simulation.divergence).quantity == "position"
    assert np.abs(simulation.positions).max() <= 1e6


@pytest.mark.parametrize("attempts", [1, 7, 30, 400])
@pytest.mark.parametrize("method", ["auto", "rodas4", "rodas5p"])
def test_attempts_that_end_in_a_dead_end_only_delay(method: Method, attempts: int) -> None:
    # So stiff and light that no step is short enough; fallback steps take its energy away.
    scene = built(
        [(0.0, 0.0), (60.0, 0.0)], mass=(1e-6, 1.0), velocities=[(70.0, 300.0), (-20.0, -500.0)],
        stiffness=1e15, damping=1.0, rest_length=1e-9,
    )  # fmt: skip
    simulation = Simulation(by(scene, method, dt=1.0, tolerance=1e-3))
    energy = simulation.energy().total
    fallbacks = 0
    for _ in range(20 if attempts > 1 else 100):
        simulation.step(attempts=attempts)
        assert simulation.divergence is None
        assert simulation.energy().total <= energy
        energy = simulation.energy().total
        fallbacks += simulation.stats().fallbacks
    assert fallbacks > 0
    assert simulation.energy().fallbacks < 0.0
    assert simulation.time > 0.0


@pytest.mark.parametrize("method", [name for name, info in METHODS.items() if info.adaptive])
def test_a_short_call_after_long_steps_ends_where_it_should(method: Method) -> None:
    # Of a body at rest, steps grow and grow; a call may then be a millionth of one.
    scene = replace(sim.rope(5), gravity=(0.0, 0.0), integrator=Integrator(method=method, dt=1.0))
    simulation = Simulation(scene)
    simulation.step(20)
    solver, start = solver_of(simulation), simulation.time
    driven = drive(simulation, start, start + 1.0)
    for end in (start + 1e-9, start + 1e-5):
        solver.run(end, driven, attempts=1000)
        assert solver.time == end
