"""A snake against PyElastica, a solver for Cosserat rods: its example of a continuum snake, which a wave of
muscle torque bends, as in Gazzola et al., "Forward and inverse problems in the mechanics of soft filaments"
(2018): on its own ground, with dry friction, and in the drag of a `Medium`, which in PyElastica is a forcing
of a few lines."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace
from scipy.interpolate import BSpline

import sim
from tests.sim.builders import built

LENGTH, PERIOD = 350.0, 2.0
"""mm, which a px is here, and s."""
RADIUS, DENSITY, YOUNG = 0.011 * LENGTH, 1e-6, 1e3
"""mm, kg/mm³, kg/(mm s²)."""
TORQUES = np.array([3.4, 3.3, 4.2, 2.6, 3.6, 3.5]) * 1e3
"""kg mm²/s², the coefficients of a cubic spline of the amplitude along the body, from the head."""
FRICTION = 1e-3 * LENGTH / (PERIOD**2 * 9.80665 * 0.1)
"""The coefficient of friction forwards, of a Froude number of 0.1; backwards it is 1.5 times as large, and
sideways twice."""
IN_DRAG = 91.88
"""mm/s, by PyElastica 1.0.0 with 50 elements in its fourth period, steps of 0.1 ms, and without its numerical
damping but for 2e-8 kg m²/s of turning; the muscles grow for one period. 50 springs here reach 91.87."""
ON_GROUND = 27.85
"""mm/s, of PyElastica's example as it is, likewise. 50 springs here reach 28.09, and 25 reach 27.86."""


def snake(n: int, **around: Any) -> sim.Scene:
    """The snake of n springs. A torque M bends as a rest angle does of M times a spring's length / (E I)."""
    piece = LENGTH / n
    area, bending = math.pi * RADIUS**2, YOUNG * math.pi * RADIUS**4 / 4.0
    knots = [0.0, 0.0, 0.0, 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0, 1.0, 1.0, 1.0]
    torque = BSpline(knots, TORQUES, 3)
    mass = DENSITY * area * piece
    muscles = [
        sim.JointMuscle(
            amplitude=math.degrees(float(torque(1.0 - j / n)) * piece / bending), phase=360.0 * j / n
        )
        for j in range(1, n)
    ]
    scene = built(
        [(piece * i, 0.0) for i in range(n + 1)], mass=[mass / 2.0, *[mass] * (n - 1), mass / 2.0],
        stiffness=YOUNG * area / piece, rest_length=piece, joint={"stiffness": bending / piece**3},
        beat=sim.Beat(frequency=1.0 / PERIOD), force_law="angle",
        integrator=sim.Integrator(method="generalized_alpha", dt=0.01), **around,
    )  # fmt: skip
    joints = zip(scene.angular_springs, muscles, strict=True)
    return replace(scene, angular_springs=tuple(replace(joint, muscle=muscle) for joint, muscle in joints))


def speed(scene: sim.Scene, periods: int) -> float:
    """mm/s, of the centre of mass in the last of some periods; towards the end that bends first."""
    weights = np.array([mass.mass for mass in scene.masses])
    simulation, centres = sim.Simulation(scene), []
    for _ in range(periods):
        places = []
        for _ in range(100):
            places.append(weights @ simulation.positions / weights.sum())
            simulation.advance(PERIOD / 100.0)
        centres.append(np.mean(places, 0))
    assert centres[-1][0] > centres[-2][0]
    return float(np.hypot(*(centres[-1] - centres[-2]))) / PERIOD


def test_a_snake_of_muscles_swims_as_fast_as_pyelasticas() -> None:
    swimming = snake(20, medium=sim.Medium(across=5e-4, along=5e-5))
    assert speed(swimming, 3) == pytest.approx(IN_DRAG, rel=0.02)


def test_a_snake_of_muscles_slithers_as_fast_as_pyelasticas() -> None:
    ground = sim.Ground(
        gravity=9806.65, forward=FRICTION, backward=1.5 * FRICTION, sideways=2.0 * FRICTION, slip_speed=2.0
    )
    assert speed(snake(25, ground=ground), 5) == pytest.approx(ON_GROUND, rel=0.02)
