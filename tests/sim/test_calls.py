"""What a run depends on: not on the calls that it is cut into, and not on what was before a reset."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, ArrowKeys, Circle, Integrator, Scene, Simulation
from sim.engine.table import Table
from sim.scene.types import Method
from sim.solve.registry import METHODS
from tests.sim.arrays import Arrays
from tests.sim.bodies import body
from tests.sim.changes import by, step_all, with_springs, with_walls
from tests.sim.checks import known
from tests.sim.inside import solver_of
from tests.sim.surrounded import KINDS, around, block_on_a_belt, surrounded
from tests.sim.touching import crumpled

FIXED = [name for name, info in METHODS.items() if not info.adaptive]
ADAPTIVE = [name for name, info in METHODS.items() if info.adaptive]


def bits(simulation: Simulation) -> bytes:
    """All that a run leaves behind: also what has broken and yielded, and what sticks."""
    state = simulation.positions.tobytes() + simulation.velocities.tobytes()
    state += np.array([simulation.time, simulation.rest_length_scale, *simulation.rest_angles]).tobytes()
    return state + repr((simulation.step_count, simulation.damage, simulation.capture().grips)).encode()


def restless(**fields: object) -> Scene:
    """A body that time drives, by gusts and an anchor that goes round, and that breaks, yields and sticks."""
    scene = replace(around("girder that sticks to itself", 8), **KINDS["all"])
    scene = with_springs(
        scene, strength=lambda i, _: 5e4 if i % 2 else 2e4, yield_force=lambda i, _: 2e4 if i % 2 else None
    )
    anchor = Anchor(mass=0, driven=True, circle=Circle(radius=20.0, frequency=3.0, ramp=0.1))
    scene = with_walls(scene, tangential_hardness=40.0)
    return replace(scene, anchors=(anchor,), arrow_keys=ArrowKeys(), **fields)


def test_a_restless_body_breaks_yields_and_sticks() -> None:
    simulation = Simulation(restless(integrator=Integrator(method="rk4", dt=3e-4)))
    simulation.step(20)
    damage, grips = known(simulation.damage), known(simulation.capture().grips)
    assert damage.broken and any(damage.set_lengths)
    assert grips.walls and grips.springs


# ------------------------------------------------------------------------- calls
@pytest.mark.parametrize("method", FIXED)
def test_steps_of_a_fixed_length_are_the_same_bits_however_they_are_called(method: Method) -> None:
    scene = restless(integrator=Integrator(method=method, dt=3e-4))
    ends = set()
    for every in (42, 1, 6):
        simulation = Simulation(scene)
        for keys in ((), ("up", "left"), ("left",)):
            simulation.keys = keys
            for _ in range(42 // every):
                simulation.step(every)
        ends.add(bits(simulation))
    assert len(ends) == 1


@pytest.mark.parametrize("method", FIXED)
def test_so_are_steps_after_which_friction_falls(method: Method) -> None:
    scene = replace(block_on_a_belt(), integrator=Integrator(method=method, dt=2e-3))
    at_once, apart = Simulation(scene), Simulation(scene)
    at_once.step(12)
    for _ in range(12):
        apart.step()
    assert known(at_once.capture().grips).sliding
    assert bits(at_once) == bits(apart)


@pytest.mark.parametrize("method", FIXED)
def test_no_step_is_lost_to_rounding_however_late_it_is(method: Method) -> None:
    scene = replace(body("chain", "conservative", 1), integrator=Integrator(method=method, dt=1e-6))
    simulation = Simulation(scene)
    simulation.restore(dataclasses.replace(simulation.capture(), time=1e5))
    assert [simulation.step() for _ in range(50)] == [1] * 50
    assert simulation.step(50) == 50
    assert simulation.stats().steps == 100


@pytest.mark.parametrize("method", ADAPTIVE)
def test_steps_that_a_method_chooses_agree_to_the_tolerance(method: Method) -> None:
    # They are cut at the ends of calls. The first steps of a jelly on a floor try to be far too long.
    scene = sim.load_scene("jelly")
    scene = replace(scene, integrator=Integrator(method=method, dt=0.0025, tolerance=0.1))
    ends = []
    for every in (80, 640, 1):
        simulation = Simulation(scene)
        for _ in range(640 // every):
            simulation.step(every)
        assert simulation.stats().fallbacks == 0
        ends.append(simulation.positions)
    assert np.abs(ends[1] - ends[0]).max() <= 0.1
    assert np.abs(ends[2] - ends[0]).max() <= 0.1


# ------------------------------------------------------------------------- what was before
@pytest.mark.parametrize("scene", ["fillings", "contact"])
def test_a_solution_that_overflows_leaves_nothing_behind(scene: str) -> None:
    arrays = Arrays(surrounded("fillings", seed=1) if scene == "fillings" else crumpled("girder"))
    g = 150.0
    assert arrays.factorise(g * g, g)
    right = np.random.default_rng(1).normal(size=arrays.here.size)
    expected = arrays.solve(right)  # which looks that nothing is written beside the masses
    for much in (1e308, np.inf, np.nan):
        arrays.solve(much * np.sign(right))
    assert np.array_equal(arrays.solve(right), expected)


def spoil(*tables: Table) -> None:
    """Make all floats of tables NaN, but for what belongs to the body."""
    for table in tables:
        for name, array in table.arrays():
            if array.dtype == np.float64 and name not in ("damping", "limits"):
                array[:] = np.nan


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", ["chain", "ring", "tree", "everything"])
def test_a_reset_or_restored_simulation_depends_on_nothing_before(kind: str, method: Method) -> None:
    scene = restless() if kind == "everything" else body(kind, "conservative", 1)
    scene = replace(scene, integrator=Integrator(method=method, dt=3e-4))
    simulation, fresh = Simulation(scene), Simulation(scene)
    fresh.step(20)
    simulation.keys = {"up", "right"}
    simulation.step(5)
    simulation.keys = ()
    moment = fresh.capture()
    ends = []
    for back in (simulation.reset, lambda: simulation.restore(moment)):
        solver = solver_of(simulation)
        spoil(solver.integrator, solver.scratch)
        if METHODS[method].implicit:
            spoil(solver.matrix)
        _, state = simulation.tables
        state.q[:] = state.v[:] = np.nan
        back()
        simulation.step(20)
        ends.append(bits(simulation))
    assert ends[0] == bits(fresh)
    fresh.restore(moment)
    fresh.step(20)
    assert ends[1] == bits(fresh)


def test_a_mass_that_was_led_before_a_reset_starts_with_its_own_velocity() -> None:
    scene = body("chain", "conservative", 1)
    simulation, fresh = Simulation(scene), Simulation(scene)
    simulation.grab(3)
    simulation.lead(3, (100.0, 50.0))
    simulation.step(4)
    simulation.reset()
    step_all(4, simulation, fresh)
    assert bits(simulation) == bits(fresh)


# ------------------------------------------------------------------------- steps that are refused
@pytest.mark.parametrize("method", ["symplectic_euler", "velocity_verlet", "rk4"])
def test_the_last_good_state_has_the_keys_of_its_own_steps(method: Method) -> None:
    scene = replace(body("girder", "conservative", 1), **KINDS["gusts"], air_friction=0.3)
    scene = by(replace(scene, arrow_keys=ArrowKeys()), method, dt=0.02)
    simulation, once = Simulation(scene), Simulation(scene)
    simulation.keys = once.keys = {"up", "right"}
    simulation.step(2000)
    assert simulation.divergence is not None
    once.step(simulation.step_count)
    assert once.divergence is None
    assert simulation.rest_length_scale == once.rest_length_scale
    assert simulation.rest_angle_shift == once.rest_angle_shift
    assert np.array_equal(simulation.tables[1].clock, once.tables[1].clock)
    assert bits(simulation) == bits(once)
