"""Bodies in motion: a damped oscillator and a double pendulum, against exact solutions."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

import sim
from sim.scene.types import Method
from sim.solve.registry import METHODS

from . import bodies, exact
from .results import Case, Result, converging, integrator_of

STIFFNESS = 160.0
"""Of the oscillator, kg/s²; its mass is 1 kg. It swings twice a second, with a tenth of critical damping."""

DAMPING = 2.5
"""Of the oscillator, kg/s."""

REST = 100.0
"""Rest length, px."""

START = 10.0
"""Initial displacement, px."""

STEPS = (1.0 / 100.0, 1.0 / 200.0, 1.0 / 400.0, 1.0 / 800.0)
"""s, of the methods with fixed steps."""

TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8)
"""px, of the others."""

SAMPLES = 10
"""Samples of the oscillator within a second."""


def oscillator_error(method: Method, size: float) -> float:
    """Return the oscillator's largest error in a second, px, with a step (s) or a tolerance (px)."""
    scene = bodies.chain(
        [(0.0, 0.0), (REST + START, 0.0)],
        stiffness=STIFFNESS,
        damping=DAMPING,
        rest_length=REST,
        held=(0,),
        integrator=integrator_of(method, size, 1.0 / SAMPLES),
    )
    simulation = sim.Simulation(scene)
    worst = 0.0
    for _ in range(SAMPLES):
        simulation.step(round(1.0 / (SAMPLES * simulation.dt)))
        time = np.array([simulation.time])
        right = REST + float(exact.damped_oscillation(time, START, 1.0, STIFFNESS, DAMPING)[0])
        worst = max(worst, abs(float(simulation.positions[1, 0]) - right))
    return worst


def _oscillator(fast: bool) -> Iterator[Result]:
    for method in METHODS.values():
        if method.adaptive:
            for tolerance in TOLERANCES:
                error = oscillator_error(method.name, tolerance)
                yield Result(
                    f"{method.name}, tolerance {tolerance:g} px", error=error, unit="px",
                    target=f"≤ {tolerance:g} px", met=error <= tolerance,
                )  # fmt: skip
        else:
            errors = []
            for dt in STEPS:
                errors.append(oscillator_error(method.name, dt))
                yield Result(f"{method.name}, dt = 1/{1.0 / dt:g} s", error=errors[-1], unit="px")
            yield converging(
                f"{method.name}, dt = 1/100 to 1/800 s", STEPS, errors, method.order, exactly=False, unit="px"
            )


PENDULUM_STIFFNESSES = (1e4, 1e5, 1e6, 1e7)
"""kg/s²."""

PENDULUM_ANGLES = (1.2, 0.6)
"""Radians from the vertical: it swings far, but its motion is not chaotic yet."""

PENDULUM_GRAVITY = 10.0
"""In rod lengths per s²."""

PENDULUM_TIME = 1.5
"""Simulated time, s."""


def pendulum_error(stiffness: float) -> float:
    """Return the distance of masses on springs from those of the rigid double pendulum, in rod lengths."""
    one, two = PENDULUM_ANGLES
    first = (math.sin(one), math.cos(one))
    scene = bodies.chain(
        [(0.0, 0.0), first, (first[0] + math.sin(two), first[1] + math.cos(two))],
        stiffness=stiffness,
        held=(0,),
        gravity=PENDULUM_GRAVITY,
        integrator=sim.Integrator(method="adams", dt=PENDULUM_TIME / 2.0, tolerance=1e-11),
    )
    simulation = sim.Simulation(scene)
    simulation.step(2)
    right = exact.double_pendulum(PENDULUM_TIME, PENDULUM_ANGLES, PENDULUM_GRAVITY)
    return float(np.hypot(*(simulation.positions[1:] - right).T).max())


def _double_pendulum(fast: bool) -> Iterator[Result]:
    stiffnesses = PENDULUM_STIFFNESSES[:3] if fast else PENDULUM_STIFFNESSES
    errors = []
    for stiffness in stiffnesses:
        errors.append(pendulum_error(stiffness))
        yield Result(f"distance, k = {stiffness:g} kg/s²", error=errors[-1], unit="rod lengths")
    yield converging(
        f"distance over 1/k, k = 1e4 to {stiffnesses[-1]:.0e} kg/s²",
        [1.0 / k for k in stiffnesses],
        errors,
        1.0,
        unit="rod lengths",
    )


CASES = (
    Case(
        "oscillator",
        "Damped oscillator",
        "One mass on one spring, along the spring: x = e^(-ct/2m) (cos ωt + c/(2mω) sin ωt), 2 Hz and "
        "damped by a tenth of the critical damping, from 10 px off; the largest error at ten times within "
        "a second. Methods with a fixed step have a slope over the step, those with error control a "
        "tolerance, below which they should stay.",
        _oscillator,
    ),
    Case(
        "pendulum",
        "Double pendulum",
        "Two masses on two very stiff springs without joints, against Lagrange's equations for rigid rods, "
        "solved by SciPy's DOP853 to 1e-13, before chaos would separate them. Springs stretch by what "
        "hangs on them over their stiffness k, so the distance goes as 1/k. (Method adams, tolerance "
        "1e-11 px.)",
        _double_pendulum,
    ),
)
