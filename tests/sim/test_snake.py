"""A snake against PyElastica, a solver for Cosserat rods: its example of a continuum snake, which a wave of
muscle torque bends, as in Gazzola et al., "Forward and inverse problems in the mechanics of soft filaments"
(2018). Its dry friction is by the direction of the whole slip, `Ground` has one for each axis; so both are
given the drag of a `Medium`, which in PyElastica is a forcing of a few lines."""

from __future__ import annotations

import math

import numpy as np
from scipy.interpolate import BSpline

import sim

LENGTH, PERIOD = 350.0, 2.0
"""mm, which a px is here, and s."""
RADIUS, DENSITY, YOUNG = 0.011 * LENGTH, 1e-6, 1e3
"""mm, kg/mm³, kg/(mm s²)."""
TORQUES = np.array([3.4, 3.3, 4.2, 2.6, 3.6, 3.5]) * 1e3
"""kg mm²/s², the coefficients of a cubic spline of the amplitude along the body, from the head."""
SPEED = 91.88
"""mm/s, by PyElastica 1.0.0 with 50 elements in its fourth period, steps of 0.1 ms, and without its numerical
damping but for 2e-8 kg m²/s of turning; the muscles grow for one period. 50 springs here reach 91.87."""


def snake(n: int) -> sim.Scene:
    """The snake of n springs. A torque M bends as a rest angle does of M times a spring's length / (E I)."""
    piece = LENGTH / n
    area, bending = math.pi * RADIUS**2, YOUNG * math.pi * RADIUS**4 / 4.0
    knots = [0.0, 0.0, 0.0, 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0, 1.0, 1.0, 1.0]
    torque = BSpline(knots, TORQUES, 3)
    mass = DENSITY * area * piece
    return sim.Scene(
        name="snake",
        masses=tuple(
            sim.Mass(position=(piece * i, 0.0), mass=mass if 0 < i < n else mass / 2.0) for i in range(n + 1)
        ),
        linear_springs=tuple(
            sim.LinearSpring(a=i, b=i + 1, stiffness=YOUNG * area / piece, rest_length=piece)
            for i in range(n)
        ),
        angular_springs=tuple(
            sim.AngularSpring(
                a=j - 1,
                b=j,
                stiffness=bending / piece**3,
                muscle=sim.JointMuscle(
                    amplitude=math.degrees(float(torque(1.0 - j / n)) * piece / bending), phase=360.0 * j / n
                ),
            )
            for j in range(1, n)
        ),
        beat=sim.Beat(frequency=1.0 / PERIOD),
        medium=sim.Medium(across=5e-4, along=5e-5),
        force_law="angle",
        integrator=sim.Integrator(method="generalized_alpha", dt=0.01),
    )


def test_a_snake_of_muscles_swims_as_fast_as_pyelasticas() -> None:
    scene = snake(20)
    weights = np.array([mass.mass for mass in scene.masses])
    simulation, centres = sim.Simulation(scene), []
    for _ in range(3):
        places = []
        for _ in range(100):
            places.append(weights @ simulation.positions / weights.sum())
            simulation.advance(PERIOD / 100.0)
        centres.append(np.mean(places, 0))
    speed = float(np.hypot(*(centres[2] - centres[1]))) / PERIOD
    assert abs(speed / SPEED - 1.0) < 0.02, speed
    assert centres[2][0] > centres[1][0]  # towards the end that bends first
