"""The largest stable time step: where formulas give it, as the meter estimates it."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Scene, Simulation
from sim.model.state import start_of
from sim.model.system import build_system
from sim.motion.stability import StabilityMeter, largest_step, quick_limit
from sim.scene.surroundings import Wall
from sim.scene.types import ForceLaw, Method
from sim.solve import stability_limits as limits
from sim.solve.registry import METHODS
from sim.solve.tableaux import RK4, explicit
from tests.sim.builders import chain, euler, row
from tests.sim.changes import by, posed
from tests.sim.inside import put
from tests.sim.whole_step import hold

SMALL = 1e-6
"""px, the motion that is watched: small enough for every force to be linear in it."""


def growth(scene: Scene, dt: float, axis: int, steps: int = 3000) -> float:
    """How many times its first size the motion along an axis reaches, at most a million times."""
    simulation = Simulation(scene, dt=dt)
    straight = np.array(row(len(scene.masses)))[:, axis]
    largest = 0.0
    for _ in range(steps // 10):
        simulation.step(10)
        largest = max(largest, float(np.abs(simulation.positions[:, axis] - straight).max()) / SMALL)
        if simulation.divergence is not None or largest > 1e6:
            return 1e6
    return largest


def wobbly(count: int, axis: int) -> list[tuple[float, float]]:
    """A row in its fastest motion: every mass moved against its neighbours."""
    shift = [SMALL * (-1) ** i if 0 < i < count - 1 else 0.0 for i in range(count)]
    return [
        (x + (s if axis == 0 else 0.0), s if axis else 0.0)
        for (x, _), s in zip(row(count), shift, strict=True)
    ]


# ------------------------------------------------------------------------- formulas
@pytest.mark.parametrize(
    ("cause", "count"),
    [
        *(("linear stiffness", count) for count in (3, 4, 10, 30)),
        *(("angular stiffness", count) for count in (5, 10, 30)),
    ],
)
def test_limit_of_a_row(cause: str, count: int) -> None:
    # The sine of the fastest mode's half wave number is what a finite row lacks of a long one.
    bends, stiffness, mass = cause == "angular stiffness", 800.0, 0.5
    along, across = (0.0, stiffness) if bends else (stiffness, 0.0)
    places, held = wobbly(count, int(bends)), (0, count - 1)
    scene = chain(places, stiffness=along, angular_stiffness=across, mass=mass, held=held)
    sine = math.sin((count - 2) * math.pi / (2 * (count - 1)))
    limit = math.sqrt(mass / stiffness) * (0.5 / sine**2 if bends else 1.0 / sine)
    assert growth(scene, 0.98 * limit, int(bends)) < 100.0
    assert growth(scene, 1.02 * limit, int(bends)) == 1e6
    estimate = Simulation(scene).stability()
    assert (estimate.limit, estimate.cause) == (pytest.approx(limit, rel=1e-3), cause)


def oscillator(zeta: float, method: Method) -> tuple[Scene, float]:
    """A slightly displaced mass on a spring, and its angular frequency."""
    stiffness, mass = 4000.0, 1.5
    omega = math.sqrt(stiffness / mass)
    positions, damping = [(0.0, 0.0), (10.0 + SMALL, 0.0)], 2.0 * zeta * omega * mass
    scene = chain(positions, stiffness=stiffness, mass=mass, damping=damping, held=(0,))
    return by(scene, method, dt=0.001), omega


FORMULAS = {
    "symplectic_euler": lambda zeta: 2.0 * (math.sqrt(1.0 + zeta**2) - zeta),
    "velocity_verlet": lambda zeta: 2.0 * (math.sqrt(1.0 + 4.0 * zeta**2) - 2.0 * zeta),
}
"""Limits of omega dt."""


@pytest.mark.parametrize("zeta", [0.0, 0.3, 1.0, 3.0])
@pytest.mark.parametrize("method", FORMULAS)
def test_limit_of_a_damped_mode(method: Method, zeta: float) -> None:
    scene, omega = oscillator(zeta, method)
    limit, damps = FORMULAS[method](zeta) / omega, 0.25 if method == "velocity_verlet" else 0.5
    estimate = Simulation(scene).stability()
    assert estimate.limit == pytest.approx(limit, rel=1e-4)
    assert estimate.cause == ("linear damping" if zeta >= damps else "linear stiffness")
    assert largest_step(scene, method) == pytest.approx(limit, rel=1e-4)
    assert growth(scene, 0.99 * limit, 0) < 300.0
    assert growth(scene, 1.01 * limit, 0) > 300.0


@pytest.mark.parametrize(("zeta", "reach"), [(0.0, math.sqrt(8.0)), (10.0, 2.785293563)])
def test_limit_of_runge_kutta(zeta: float, reach: float) -> None:
    # Along the imaginary axis, and along the negative real one (Hairer & Wanner II, IV.2).
    scene, omega = oscillator(zeta, "rk4")
    fastest = omega * (zeta + math.sqrt(max(zeta**2 - 1.0, 0.0))) if zeta else omega
    assert Simulation(scene).stability().limit == pytest.approx(reach / fastest, rel=1e-5)


@pytest.mark.parametrize("zeta", [0.0, 0.1, 0.5, 0.9, 1.5])
def test_runge_kutta_on_both_sides(zeta: float) -> None:
    scene, _ = oscillator(zeta, "rk4")
    limit = largest_step(scene, "rk4")
    assert growth(scene, 0.98 * limit, 0) < 300.0
    assert growth(scene, 1.02 * limit, 0) > 300.0


def test_stability_polynomial_is_that_of_the_exponential() -> None:
    assert limits.stability_polynomial(RK4) == pytest.approx([1.0, 1.0, 1 / 2, 1 / 6, 1 / 24])


def test_nothing_that_pulls_has_no_limit() -> None:
    for scene in (chain(row(3)), sim.load_scene("tutorial-3.1"), chain([(0.0, 0.0)])):
        estimate = Simulation(scene).stability()
        assert estimate.limit == math.inf
        assert estimate.cause is None


def test_air_friction_limits_the_step_of_a_fast_mass() -> None:
    # F = -air v²; linearised at v the rate is 2 air v / m, and symplectic Euler bears dt < 2 / rate.
    scene = replace(chain([(0.0, 0.0)], velocities=[(300.0, 0.0)], mass=2.0), air_friction=0.5)
    estimate = Simulation(scene).stability()
    assert estimate.limit == pytest.approx(2.0 * 2.0 / (2.0 * 0.5 * 300.0), rel=1e-6)
    assert estimate.cause == "air friction"


# ------------------------------------------------------------------------- at a glance
def quick(scene: Scene) -> float:
    return quick_limit(build_system(scene))


@pytest.mark.parametrize("angular", [0.0, 800.0])
@pytest.mark.parametrize("count", [3, 5, 10, 30])
def test_quick_limit_of_a_straight_body_is_on_the_safe_side(count: int, angular: float) -> None:
    scene = chain(row(count), stiffness=3000.0, angular_stiffness=angular, mass=0.5, held=(0,))
    exact = Simulation(scene).stability().limit
    assert 0.5 * exact < quick(scene) < 1.001 * exact


def test_quick_limit_by_hand() -> None:
    # The mass in the middle of a long row: two springs, and three joints bend there by 1, -2 and 1.
    scene = chain(row(9), stiffness=3000.0, angular_stiffness=800.0, mass=0.5)
    assert quick(scene) == pytest.approx(2.0 / math.sqrt((4.0 * 3000.0 + 16.0 * 800.0) / 0.5))
    assert quick(chain(row(2), stiffness=3000.0, mass=0.5)) == pytest.approx(
        2.0 / math.sqrt(2.0 * 3000.0 / 0.5)
    )

    for nothing in (chain(row(3)), chain(row(3), stiffness=1.0, held=(0, 1, 2))):
        assert quick(nothing) == math.inf


@pytest.mark.parametrize("preset", ["ring", "box", "hair-tuft", "flag-pole", "study-cloth", "study-tree"])
def test_quick_limit_of_presets(preset: str) -> None:
    scene = replace(sim.load_scene(preset), integrator=euler())
    exact = Simulation(scene).stability().limit
    assert 0.4 * exact < quick(scene) < 1.2 * exact


# ------------------------------------------------------------------------- what the meter sees


def test_the_meter_sees_when_another_body_gets_stiffer() -> None:
    hanging = chain([(0.0, 0.0), (0.0, 10.0)], stiffness=100.0, held=(0,))
    corners = ((50.0, 0.0), (90.0, 0.0), (90.0, 40.0), (50.0, 40.0))
    loop = tuple(sim.Mass(position=corner) for corner in corners)
    gas = sim.Gas(masses=(2, 3, 4, 5), pressure=1.0, outside=1.0)
    scene = replace(hanging, masses=(*hanging.masses, *loop), fillings=(gas,))
    simulation = Simulation(by(scene, "velocity_verlet", dt=1e-4))
    assert simulation.stability().limit == pytest.approx(2.0 / math.sqrt(100.0), rel=1e-3)
    squeezed = [(x, min(y, 0.5)) for x, y in corners]
    put(simulation, np.array([(0.0, 0.0), (0.0, 10.0), *squeezed]))
    estimate = simulation.stability()
    # The pressure falls by 4 kg/s² per px of area, of which each mass makes 20 px² per px: 4 · 4 · 20² s⁻².
    assert estimate.limit == pytest.approx(2.0 / math.sqrt(6400.0), rel=1e-3)
    assert estimate.cause == "fillings"


def test_meter_sees_keys_and_grabs() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    before = simulation.stability().limit
    for mass in range(12):
        simulation.grab(mass)
    assert simulation.stability().limit == math.inf
    for mass in range(12):
        simulation.release(mass)
    simulation.keys = {"up"}
    simulation.step(200)
    simulation.keys = set()
    simulation.step(2000)
    # The torques grow with the lengths but so do the levers; what must hold is that it follows.
    hold(simulation)
    assert before == pytest.approx(0.005, rel=0.05)


@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
def test_the_stiffness_that_sets_the_limit_is_named_under_every_law(law: ForceLaw) -> None:
    # Under the laws with an energy, joints also pull along the springs.
    for linear, angular, cause in ((100.0, 1e6, "angular stiffness"), (1e6, 100.0, "linear stiffness")):
        scene = sim.rope(masses=8, stiffness=linear, angular_stiffness=angular, damping=0.0, force_law=law)
        assert Simulation(by(scene, "symplectic_euler")).stability().cause == cause


def test_strong_dampers_of_joints_are_named() -> None:
    scene = sim.rope(masses=8, angular_damping=5000.0, damping=0.0)
    assert Simulation(by(scene, "velocity_verlet")).stability().cause == "angular damping"


def test_a_row_brings_its_own_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ralston's method of second order lets undamped motions grow by next to nothing: it is not unstable."""
    table = explicit(rows=((), (2 / 3,)), weights=(1 / 4, 3 / 4), times=(0.0, 2 / 3))
    row = dataclasses.replace(METHODS["rk4"], order=2, limit=limits.runge_kutta(table), table=table)
    monkeypatch.setitem(METHODS, "rk4", row)
    scene = replace(
        sim.rope(masses=6, damping=0.0, air_friction=0.0, rest_angle=20.0),
        integrator=Integrator(method="rk4", dt=2e-4),
    )
    simulation = Simulation(scene)
    assert simulation.dt < simulation.stability().limit < np.inf
    undamped, _ = limits.runge_kutta(table).solve(np.array([[1e4]]), np.zeros((1, 1)))
    assert 1e-3 < undamped < 0.1  # without even the damping of rounding errors
    energy = simulation.energy().total
    assert simulation.step(4000) == 4000
    assert simulation.energy().total == pytest.approx(energy, rel=0.02, abs=2e3)
    # Beyond it, it does run away.
    far = Simulation(scene, dt=3.0 * simulation.stability().limit)
    far.step(4000)
    assert far.divergence is not None


def test_a_look_in_parts_finds_the_same() -> None:
    """It is about the state with which it began, though the body goes on meanwhile."""
    whole, other = (Simulation(replace(sim.load_scene("ring"), integrator=euler())) for _ in range(2))
    at_once = whole.stability()
    look, parts = other.stability_in_parts(), 0
    while True:
        try:
            next(look)
        except StopIteration as end:
            assert end.value == at_once
            break
        parts += 1
        other.step(1)
    assert parts > 20


# ------------------------------------------------------------------------- methods without a limit
@pytest.mark.parametrize("hardness", [8e3, 1e6, 1e8])
def test_the_first_look_at_what_lies_on_a_wall_finds_what_later_ones_do(hardness: float) -> None:
    """The wall softens with the step, and so the limit is that for a step that is as long as the limit."""
    balloon = replace(sim.load_scene("air-balloon"), gravity=(0.0, 1000.0), walls=())
    low = max(mass.position[1] for mass in balloon.masses)
    floor = Wall(point=(0.0, low + 20.0), normal=(0.0, -1.0), hardness=hardness, friction=2.0, bounciness=0.1)
    moved = Simulation(replace(balloon, walls=(floor,)))
    moved.advance(0.3)
    scene = by(posed(moved.scene, moved.positions, moved.velocities), "velocity_verlet", dt=2.5e-3)
    system, state = start_of(scene, build_system(scene))
    meter = StabilityMeter(system, "velocity_verlet")
    first = meter.update(state).limit
    later = [meter.update(state).limit for _ in range(30)]
    assert first == pytest.approx(later[-1], rel=0.02)


@pytest.mark.parametrize("damping", [0.0, 40.0, 4000.0])
@pytest.mark.parametrize("method", ["generalized_alpha", "stable_spring"])
def test_no_step_is_too_long(method: Method, damping: float) -> None:
    scene = chain(row(6), stiffness=1e5, angular_stiffness=1e5, damping=damping, held=(0,))
    positions = np.array(row(6)) + SMALL * np.random.default_rng(3).normal(size=(6, 2))
    off = posed(scene, positions)
    assert largest_step(scene, method) == math.inf
    for factor in (1.5, 10.0, 100.0):
        dt = factor * largest_step(scene, "symplectic_euler")
        assert max(growth(by(off, method, dt=1e-3), dt, axis, 400) for axis in (0, 1)) < 300.0


@pytest.mark.parametrize("method", METHODS)
def test_only_explicit_methods_with_a_fixed_step_have_a_limit(method: Method) -> None:
    limit = Simulation(by(sim.load_scene("tutorial-3.3"), method)).stability().limit
    info = METHODS[method]
    assert (limit < math.inf) == (not info.adaptive and not info.implicit) == (info.limit is not None)


def test_the_stable_spring_has_a_limit_where_proportions_are_lost() -> None:
    # A torque is levered by the ratio of the lengths, and clamped by that of the rest lengths.
    positions = [(0.0, 0.0), (10.0, 0.0), (11.0, 0.0), (21.0, 0.0)]
    scene = chain(positions, angular_stiffness=1e4, held=(0,))
    limit = largest_step(scene, "stable_spring")
    assert limit < 1.0
    for dt, beyond in ((0.98 * limit, False), (1.02 * limit, True)):
        assert (dt > Simulation(by(scene, "stable_spring", dt=dt)).stability().limit) == beyond
