"""The largest stable step of methods with a fixed step: just below it nothing grows, just above it does."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest

import sim
from sim import Integrator, Scene, Simulation
from sim.methods.limits import stability_polynomial
from sim.methods.registry import METHODS
from sim.methods.tableaux import RK4
from sim.motion.stability import largest_step
from sim.scene.types import ForceLaw, Method
from tests.sim.amplification import STEPS, dynamics, radius
from tests.sim.bodies import body
from tests.sim.builders import chain, row

REPLACE = msgspec.structs.replace
SMALL = 1e-6
"""px, the motion that is watched."""
FIXED: list[Method] = ["symplectic_euler", "velocity_verlet", "rk4", "generalized_alpha", "stable_spring"]


def by(scene: Scene, method: Method, dt: float = 0.001) -> Scene:
    return REPLACE(scene, integrator=Integrator(method=method, dt=dt))


def grows(scene: Scene, method: Method, dt: float, steps: int = 2000) -> bool:
    """Whether the second mass of a row leaves its position."""
    simulation = Simulation(by(scene, method, dt))
    for _ in range(steps // 20):
        simulation.step(20)
        away = np.abs(simulation.positions - np.array(row(len(scene.masses)))).max()
        if simulation.divergence is not None or away > 300.0 * SMALL:
            return True
    return False


def oscillator(zeta: float) -> tuple[Scene, float]:
    """A slightly displaced mass on a spring, and its angular frequency."""
    stiffness, mass = 4000.0, 1.5
    omega = math.sqrt(stiffness / mass)
    positions = [(0.0, 0.0), (10.0 + SMALL, 0.0)]
    damping = 2.0 * zeta * omega * mass
    return chain(positions, stiffness=stiffness, mass=mass, damping=damping, held=(0,)), omega


FORMULAS = {
    "symplectic_euler": lambda zeta: 2.0 * (math.sqrt(1.0 + zeta**2) - zeta),
    "velocity_verlet": lambda zeta: 2.0 * (math.sqrt(1.0 + 4.0 * zeta**2) - 2.0 * zeta),
}
"""Limits of omega dt."""


@pytest.mark.parametrize("zeta", [0.0, 0.3, 1.0, 3.0])
@pytest.mark.parametrize("method", FORMULAS)
def test_limit_of_a_damped_mode(method: Method, zeta: float) -> None:
    scene, omega = oscillator(zeta)
    limit = FORMULAS[method](zeta) / omega
    assert Simulation(by(scene, method)).stability().limit == pytest.approx(limit, rel=1e-4)
    assert largest_step(scene, method) == pytest.approx(limit, rel=1e-4)
    assert not grows(scene, method, 0.99 * limit)
    assert grows(scene, method, 1.01 * limit)


@pytest.mark.parametrize(("zeta", "reach"), [(0.0, math.sqrt(8.0)), (10.0, 2.785293563)])
def test_limit_of_runge_kutta(zeta: float, reach: float) -> None:
    # Along the imaginary axis, and along the negative real one (Hairer & Wanner II, IV.2).
    scene, omega = oscillator(zeta)
    fastest = omega * (zeta + math.sqrt(max(zeta**2 - 1.0, 0.0))) if zeta else omega
    limit = Simulation(by(scene, "rk4")).stability().limit
    assert limit == pytest.approx(reach / fastest, rel=1e-5)


@pytest.mark.parametrize("zeta", [0.0, 0.1, 0.5, 0.9, 1.5])
def test_runge_kutta_on_both_sides(zeta: float) -> None:
    scene, _ = oscillator(zeta)
    limit = largest_step(scene, "rk4")
    assert not grows(scene, "rk4", 0.98 * limit)
    assert grows(scene, "rk4", 1.02 * limit)


def test_stability_polynomial_is_that_of_the_exponential() -> None:
    assert stability_polynomial(RK4) == pytest.approx([1.0, 1.0, 1 / 2, 1 / 6, 1 / 24])


# ------------------------------------------------------------------------- any body, against dense matrices
@pytest.mark.parametrize("damping", [0.0, 30.0, 300.0])
@pytest.mark.parametrize("shape", ["chain", "girder", "hub"])
@pytest.mark.parametrize("method", STEPS)
def test_meter_of_bodies_in_motion(method: Method, shape: str, damping: float) -> None:
    scene = by(body(shape, "conservative", 2, damping=damping, held=(1,)), method)
    simulation = Simulation(scene)
    k, c = dynamics(simulation.scene, simulation.positions, simulation.velocities)
    limit = simulation.stability().limit
    # Compressed springs may buckle, which no step helps: motions grow a little at any.
    buckling = radius(method, k, c, 0.5 * limit)
    assert radius(method, k, c, 0.98 * limit) < max(1.0, buckling) ** 2 + 1e-3
    assert radius(method, k, c, 1.02 * limit) > 1.01


@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
@pytest.mark.parametrize("method", STEPS)
def test_meter_of_a_rope(method: Method, law: ForceLaw) -> None:
    scene = by(REPLACE(sim.load_scene("tutorial-3.3"), force_law=law), method)
    simulation = Simulation(scene)
    k, c = dynamics(simulation.scene, simulation.positions, simulation.velocities)
    limit = simulation.stability().limit
    assert radius(method, k, c, 0.99 * limit) <= 1.0 + 1e-4
    assert radius(method, k, c, 1.01 * limit) > 1.001
    assert largest_step(scene, method) == pytest.approx(limit, rel=0.01)


# ------------------------------------------------------------------------- methods without a limit
@pytest.mark.parametrize("damping", [0.0, 40.0, 4000.0])
@pytest.mark.parametrize("method", ["generalized_alpha", "stable_spring"])
def test_no_step_is_too_long(method: Method, damping: float) -> None:
    scene = REPLACE(chain(row(6), stiffness=1e5, angular_stiffness=1e5, damping=damping, held=(0,)))
    positions = np.array(row(6)) + SMALL * np.random.default_rng(3).normal(size=(6, 2))
    off = REPLACE(
        scene, pose=sim.Pose(positions=tuple(map(tuple, positions.tolist())), velocities=((0.0, 0.0),) * 6)
    )
    assert largest_step(scene, method) == math.inf
    for factor in (1.5, 10.0, 100.0):
        assert not grows(off, method, factor * largest_step(scene, "symplectic_euler"), 400)


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
        assert (dt > Simulation(by(scene, "stable_spring", dt)).stability().limit) == beyond
