"""Which methods `auto` turns to, by what they leave behind: only implicit ones make matrices."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Simulation
from sim.motion.simulation import SolverStats
from sim.motion.stability import largest_step
from sim.scene.makers import fine_rope
from sim.scene.types import Circle, ForceLaw, Method
from tests.sim.bodies import LAWS
from tests.sim.builders import built
from tests.sim.changes import by, with_springs
from tests.sim.whole_step import spectral_radius


def test_far_from_its_limit_verlet_leaves_most_of_the_tolerance_to_what_may_come() -> None:
    """All steps of a rope that swings calmly are limited by their errors, which must not add up to it."""
    assert error_of("study-w1", 0.1) < 0.01


def error_of(name: str, tolerance: float) -> float:
    """How far off a mass is after a second of a scene in one call, px."""
    ends = []
    runs: tuple[tuple[Method, float], ...] = (("auto", tolerance), ("adams", 1e-6))
    for method, given in runs:
        simulation = Simulation(by(sim.load_scene(name), method, dt=1.0, tolerance=given))
        assert simulation.step() == 1
        ends.append(simulation.positions)
    return float(np.hypot(*(ends[0] - ends[1]).T).max())


def effort_of(name: str, tolerance: float) -> SolverStats:
    """What a second of a scene takes, in one call."""
    simulation = Simulation(replace(sim.load_scene(name), integrator=Integrator(tolerance=tolerance, dt=1.0)))
    assert simulation.step() == 1
    return simulation.stats()


@pytest.mark.parametrize("tolerance", [0.1, 1e-6])
@pytest.mark.parametrize("name", ["study-w1", "study-ring", "study-tree"])
def test_where_explicit_methods_are_good_no_matrix_is_made(name: str, tolerance: float) -> None:
    assert effort_of(name, tolerance).matrices == 0


def test_stiff_bodies_are_moved_by_implicit_methods() -> None:
    stats = effort_of("study-w4", 0.1)
    # Explicit ones have to take far shorter steps.
    assert stats.matrices > 50
    assert stats.steps + stats.rejected < 600


def test_where_accuracy_limits_steps_methods_of_high_order_are_turned_to() -> None:
    # Steps of second order would have to be far shorter.
    stats = effort_of("study-w2", 1e-3)
    assert stats.steps < 2000
    assert stats.matrices < 50


@pytest.mark.parametrize("tolerance", [0.5, 0.9, 1.0, 1.1, 2.0])
def test_long_steps_of_stiff_bodies_keep_to_large_tolerances(tolerance: float) -> None:
    """Of steps of a thirtieth of a second, Rosenbrock methods see too little of the error."""
    assert error_of("study-w3", tolerance) < 0.5 * tolerance


@pytest.mark.parametrize("tolerance", [0.1, 0.3, 1.0])
def test_steps_of_damped_bodies_are_longer_than_textbook_verlet_bears(tolerance: float) -> None:
    """Near the limit, forces go by velocities that are predicted so that it is symplectic Euler's."""
    mean = 1.0 / effort_of("study-cloth", tolerance).steps
    verlet, euler = (
        Simulation(sim.load_scene("study-cloth"), integrator=method)
        for method in ("velocity_verlet", "symplectic_euler")
    )
    assert spectral_radius(verlet, 0.9 * mean) > 1.01
    assert spectral_radius(euler, mean) < 1.0 + 1e-6


@pytest.mark.parametrize("tolerance", [0.5, 0.8, 1.0])
def test_frame_by_frame_implicit_steps_are_judged_by_what_they_do_now(tolerance: float) -> None:
    """Each frame cuts one short; going by the first frame, Verlet would be gone on with for ever."""
    scene = sim.load_scene("study-w3")
    scene = with_springs(scene, stiffness=lambda _, spring: 100.0 * spring.stiffness)
    simulation = Simulation(by(scene, dt=1.0 / 60.0, tolerance=tolerance))
    assert simulation.step(60) == 60
    whole = simulation.stats()
    simulation.reset()
    for _ in range(60):
        assert simulation.step() == 1
    framed = simulation.stats()
    assert framed.matrices > 40
    assert framed.work < 2 * whole.work


@pytest.mark.parametrize("tolerance", [10.0, 0.1])
@pytest.mark.parametrize("name", ["net", "led rope"])
def test_where_stability_limits_all_steps_hardly_more_is_done_than_by_the_longest_stable_ones(
    name: str, tolerance: float
) -> None:
    """Whatever the tolerance: trials of other methods, and of longer steps, are few."""
    if name == "net":
        scene = sim.cloth(
            columns=10, rows=10, width=270.0, height=270.0, diagonals=False, stiffness=2e7, damping=300.0,
            mass=0.2, air_friction=0.0,
        )  # fmt: skip
        scene = replace(scene, bodies=(), angular_springs=())
    else:
        scene = fine_rope(60, circle=Circle(radius=20.0, frequency=1.0, ramp=0.1), joints=False)
    simulation = Simulation(replace(scene, integrator=Integrator(dt=1.0, tolerance=tolerance)))
    assert simulation.step() == 1
    assert simulation.stats().work < 1.3 / largest_step(scene, "symplectic_euler")


@pytest.mark.parametrize("tolerance", [0.1, 10.0, 1e3])
@pytest.mark.parametrize("law", LAWS)
def test_no_tolerance_lets_a_light_mass_on_a_strong_damper_run_away(law: ForceLaw, tolerance: float) -> None:
    # Within a tolerance of 10 px, its velocity could be anything for the while that the damper takes.
    scene = built(
        [(100.0, 100.0), (100.0, 140.0)], mass=(1e-6, 1e-3), stiffness=1e4, damping=1e6, rest_length=1.0,
        held=(1,), air_friction=1.0, force_law=law,
        integrator=Integrator(method="auto", dt=1.0 / 60.0, tolerance=tolerance),
    )  # fmt: skip
    simulation = Simulation(scene)
    start = simulation.energy().total
    for _ in range(5):
        assert simulation.step(attempts=400) == 1
        balance = simulation.energy()
        assert balance.total <= start
        assert abs(balance.residual) < 0.01 * start
    assert simulation.divergence is None
