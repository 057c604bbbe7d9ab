"""Muscles: a closed form, the energy balance, the stability limit over a beat, and what rests without a beat.

`test_orders.py` has the order of each method with muscles, against equations of its own.
"""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import (
    Beat,
    Integrator,
    JointMuscle,
    Scene,
    Simulation,
    SpringMuscle,
)
from sim.model.state import start_of, update_rest_state
from sim.model.system import build_system
from sim.motion.stability import limit_at_start
from sim.scene.types import ForceLaw, Method
from sim.solve.registry import METHODS
from tests.sim.bodies import body, with_muscles
from tests.sim.builders import built, row
from tests.sim.changes import after, by, step_all
from tests.sim.inside import same_state
from tests.sim.laws import Laws

ADAPTIVE = [name for name, info in METHODS.items() if info.adaptive]


# ------------------------------------------------------------------------- a closed form
STIFFNESS, KILOGRAMS, LENGTH, AMPLITUDE, FREQUENCY, PHASE = 400.0, 2.0, 100.0, 0.1, 1.3, 30.0


def driven(method: Method, **changes: float) -> Scene:
    """A mass at rest on a spring without damping, whose rest length follows a sine."""
    return built(
        [(0.0, 0.0), (LENGTH, 0.0)], mass=(1.0, KILOGRAMS), stiffness=STIFFNESS,
        spring={"muscle": SpringMuscle(amplitude=AMPLITUDE, phase=PHASE)}, held=(0,),
        beat=Beat(frequency=FREQUENCY), integrator=Integrator(method=method, **changes),
    )  # fmt: skip


def closed_form(t: float) -> float:
    """x'' = -w0² (x - L (1 + A sin(w t + p))) from rest at L: the forced motion and the free one."""
    free, forced, p = math.sqrt(STIFFNESS / KILOGRAMS), 2.0 * math.pi * FREQUENCY, math.radians(PHASE)
    size = LENGTH * AMPLITUDE * free**2 / (free**2 - forced**2)
    own = math.sin(p) * math.cos(free * t) + forced / free * math.cos(p) * math.sin(free * t)
    return LENGTH + size * (math.sin(forced * t + p) - own)


@pytest.mark.parametrize("method", ADAPTIVE)
def test_a_mass_on_a_muscle_moves_by_its_closed_form(method: Method) -> None:
    simulation = Simulation(driven(method, dt=0.01, tolerance=1e-11))
    for _ in range(4):
        simulation.advance(0.5)
        x, y = simulation.positions[1]
        assert x == pytest.approx(closed_form(simulation.time), abs=1e-8)
        assert y == 0.0


def test_what_is_measured_goes_by_the_present_rest_length() -> None:
    simulation = Simulation(driven("rodas5p", dt=0.01, tolerance=1e-9))
    elongation, force = (sim.quantity(f"spring0.{of}", simulation.scene) for of in ("elongation", "force"))
    for _ in range(3):
        simulation.advance(0.13)
        phase = 2.0 * math.pi * FREQUENCY * simulation.time + math.radians(PHASE)
        off = closed_form(simulation.time) - LENGTH * (1.0 + AMPLITUDE * math.sin(phase))
        assert elongation.read(simulation) == pytest.approx(off, abs=1e-6)
        assert force.read(simulation) == pytest.approx(STIFFNESS * off, abs=1e-3)


# ------------------------------------------------------------------------- the energy balance
@pytest.mark.parametrize(
    ("shape", "law"), [("chain", "conservative"), ("ring", "tutorial"), ("cloth", "conservative")]
)
@pytest.mark.parametrize("method", [name for name, info in METHODS.items() if not info.adaptive])
def test_the_balance_closes_at_the_order_of_the_method(method: Method, shape: str, law: ForceLaw) -> None:
    scene = with_muscles(body(shape, law, 1, held=(0,), damping=5.0, twist=0.0, air=0.0))
    left = []
    for steps in (400, 800):
        simulation = Simulation(by(scene, method, dt=0.1 / steps))
        simulation.energy()
        simulation.step(steps)
        balance = simulation.energy()
        left.append(abs(balance.residual))
    assert abs(balance.muscles) > 100.0 * left[-1] or METHODS[method].order == 1
    assert abs(balance.muscles) > 1.0
    order = METHODS[method].order or 1
    assert left[1] < 0.7 * left[0] * 2.0 ** (1 - order)


@pytest.mark.parametrize("method", ADAPTIVE)
def test_the_balance_of_a_method_with_error_control_closes(method: Method) -> None:
    scene = with_muscles(body("chain", "conservative", 1, held=(0,), damping=5.0, air=0.0))
    simulation = after(by(scene, method, dt=0.01, tolerance=1e-8), 2.0)
    balance = simulation.energy()
    assert abs(balance.residual) < 1e-6 * abs(balance.muscles)


# ------------------------------------------------------------------------- in NumPy
def test_the_work_of_quick_muscles_is_that_of_all_their_waves() -> None:
    """A step of a Rosenbrock method passes over several, which hardly move the masses."""
    rope = sim.rope(6, stiffness=1e5, damping=20.0, gravity=(0.0, 500.0))
    springs = [
        replace(spring, muscle=SpringMuscle(amplitude=0.1, phase=60.0 * i, wave="pulse", per_beat=4))
        for i, spring in enumerate(rope.linear_springs)
    ]
    scene = replace(rope, bodies=(), beat=Beat(frequency=80.0), linear_springs=tuple(springs))
    right = after(by(scene, "rk4", dt=4e-5), 0.25).energy().muscles
    for tolerance, off in ((1.0, 0.3), (0.1, 0.2), (1e-3, 0.01)):
        simulation = after(by(scene, "rodas5p", tolerance=tolerance), 0.25)
        assert simulation.energy().muscles == pytest.approx(right, rel=off)


@pytest.mark.parametrize("shape", ["chain", "ring", "cloth"])
def test_the_kernels_and_numpy_let_them_move_alike(shape: str) -> None:
    scene = with_muscles(body(shape, "conservative", 3, held=(0,)))
    reference = Laws(scene)
    simulation = Simulation(by(scene, "rk4", dt=1e-3))
    for _ in range(5):
        simulation.step(37)
        system, state = simulation.tables
        by_kernel = {
            name: getattr(state, name).copy() for name in ("rest_tension", "torque_cos", "torque_sin")
        }
        update_rest_state(system.body, state)
        for name, array in by_kernel.items():
            assert getattr(state, name) == pytest.approx(array, rel=1e-13, abs=1e-9), name
        reference.at(simulation.time)
        expected = np.degrees(np.unwrap(reference.rest_angles))
        off = (simulation.rest_angles - expected + 180.0) % 360.0 - 180.0
        assert np.abs(off).max(initial=0.0) < 1e-9


# ------------------------------------------------------------------------- the stability limit
def hinged(amplitude: float) -> Scene:
    """A mass that hardly more than a joint holds, straight ahead of two that are held."""
    joint = {"stiffness": 1000.0, "muscle": JointMuscle(amplitude=amplitude)}
    fields: dict[str, Any] = {"beat": Beat(frequency=0.7), "force_law": "angle"}
    return built(row(3, 100.0), stiffness=1e-3, joint=joint, held=(0, 1), **fields)


@pytest.mark.parametrize("method", ["symplectic_euler", "velocity_verlet", "rk4"])
def test_the_stability_limit_is_that_of_the_worst_moment_of_a_beat(method: Method) -> None:
    """A joint that is bent by d has the energy K |A||B| d² / 2 under the angle law. With springs of one
    length, its second derivative by the free mass's position is K (1 + d² / 2) across the spring, and 0
    along it."""
    straight, bent = (limit_at_start(hinged(amplitude), method).limit for amplitude in (0.0, 60.0))
    assert straight / bent == pytest.approx(math.sqrt(1.0 + 0.5 * math.radians(60.0) ** 2), rel=1e-3)


def test_a_moving_body_is_looked_at_over_a_beat_too() -> None:
    simulation = Simulation(by(hinged(60.0), "rk4", dt=1e-3))
    first = simulation.stability().limit
    assert simulation.stability().limit == pytest.approx(first, rel=1e-6)


# ------------------------------------------------------------------------- without a beat
def test_muscles_rest_without_a_beat() -> None:
    scene = body("cloth", "angle", 4, held=(0,))
    resting = replace(with_muscles(scene), beat=msgspec.UNSET)
    one, other = Simulation(scene), Simulation(resting)
    step_all(100, one, other)
    assert same_state(one, other)
    assert not build_system(resting).body.muscles.present


def test_analyses_let_muscles_rest() -> None:
    scene = sim.rope(masses=6, rest_angle=10.0)
    moving = with_muscles(scene)
    rest = sim.equilibrium(scene)
    assert sim.equilibrium(moving) == rest
    one, other = (sim.vibrations(replace(each, pose=rest), 4) for each in (scene, moving))
    assert np.array_equal(one.omega, other.omega)


def test_a_beat_at_the_start_is_where_its_phase_says() -> None:
    scene = replace(driven("rk4"), beat=Beat(phase=60.0))
    _, state = start_of(scene, build_system(scene))
    expected = STIFFNESS * LENGTH * (1.0 + AMPLITUDE * math.sin(math.radians(60.0 + PHASE)))
    assert state.rest_tension[0] == pytest.approx(expected, rel=1e-13)
