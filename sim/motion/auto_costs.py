"""A-priori costs of the steps of `auto`'s methods, and their tolerances."""

from __future__ import annotations

import numpy as np

from ..engine.tables import ADAMS, ALPHA, CHOICES, ROSENBROCK, VERLET, Body, Floats, Matrix
from ..scene.types import Scene, is_damageable
from ..solve.registry import MethodInfo
from ..solve.steps.auto import MATRICES

LOW_TOLERANCE = 3e-3
"""Tolerance, px, below which `auto` uses RODAS 5P instead of RODAS 4, and no generalized-alpha."""

LONG = 200
"""Number of masses from which `auto` also tries generalized-alpha, which is good at long rods. By
experiment: with 100, a dragged rod of 100 masses takes a ninth of the work at 1 px."""

_COARSEST = 1e-3
"""Largest tolerance of Rosenbrock methods under `auto`, as a fraction of the body's size: their error
estimates are too optimistic for long steps on stiff bodies. By experiment (20 bodies): doubled or halved, 2 %
in work."""
_FINER = 0.03
"""Smallest factor of the tolerance that results from this."""

_LARGEST = 0.004
"""Largest tolerance of all methods under `auto`, as a fraction of the body's size: with a larger one,
velocities of light masses would be arbitrary, and steps hardly longer. By experiment: doubled, errors grow by
6 %; halved, 2 % more work and 15 % smaller errors."""
_SENSIBLE = 0.1
"""Tolerance, px, that is always allowed. By experiment: doubled or halved, nothing on 20 bodies; it is for
small ones."""

_ADAMS_LOW = 0.5
"""Factor of the tolerance of Adams methods under `auto`, for tolerances from `LOW_TOLERANCE` up, and for all
where anything yields or breaks: high orders are of no use at kinks. By experiment: doubled, 11 % larger
errors; halved, 11 % smaller ones, each with 2 % more work."""
_ADAMS_HIGH = 1.6
"""The same for smaller tolerances. Found by experiment, so that about the same share of random bodies ends
within large and within small tolerances: doubled, 21 % larger errors and 2 % less work; halved, 2 % smaller
ones."""

_ITERATIONS = 10.0, 0.05
"""Iterations for a linear system with contact that `auto` expects, and how many more for each spring: it then
prefers explicit methods unless their steps are very short."""

_IN_RUNS, _ALONE = (2.8, 2.0), (5.0, 4.0)
"""ns of a spring and of a joint, where they are in runs and where they are not."""

_SURROUNDINGS, _LIMITS = 12.0, 35.0
"""ns of a mass, where anything acts besides springs and joints, and where springs may yield or break."""


def tolerance_factors(scene: Scene, methods: list[MethodInfo], low: bool) -> Floats:
    """Return (CHOICES,) each method's tolerance as a fraction of the scene's, see `Problem.tolerance_factor`.

    Args:
        scene: the scene.
        methods: the methods.
        low: whether the tolerance calls for methods of low order, see `LOW_TOLERANCE`.
    """
    tolerance_factor = np.array([method.tolerance_factor for method in methods])
    tolerance_factor[ADAMS] *= _ADAMS_LOW if low or is_damageable(scene) else _ADAMS_HIGH
    size = max(
        *np.ptp([mass.position for mass in scene.masses], axis=0),
        *(spring.rest_length for spring in scene.linear_springs),
    )
    tolerance = scene.integrator.tolerance
    largest = min(max(_LARGEST * size, _SENSIBLE), tolerance)
    tolerance_factor[ROSENBROCK] *= min(max(_COARSEST * size / largest, _FINER), 1.0)
    return tolerance_factor * (largest / tolerance)


def costs_of_steps(body: Body, matrix: Matrix, low: bool) -> Floats:
    """Return (CHOICES,) the computing time of a step of each method in steps of Verlet, see `Problem.costs`.

    Estimated in ns from operation counts and measured times per operation.

    Args:
        body, matrix: the tables.
        low: see `tolerance_factors`.
    """
    n = body.masses
    force = 3.3 * n
    if not (body.chain or body.ring):
        in_runs = body.held.loose + body.free.loose - body.hinged, body.bends.loose
        force = 2.0 * n
        for count, inside, quick, slow in zip(
            (body.springs, body.joints), in_runs, _IN_RUNS, _ALONE, strict=True
        ):
            force += quick * inside + slow * (count - inside)
    touching = 20.0 * body.springs if body.environment.contact.present else 0.0
    force += touching + n * (
        (_SURROUNDINGS if body.environment.present else 0.0) + (_LIMITS if body.limits.present else 0.0)
    )
    later = matrix.row_start[1:] - matrix.diagonal - 1
    products = float((later * (later + 1)).sum())
    factors = 300.0 + 45.0 * body.springs + 50.0 * body.joints + 3.6 * products
    blocks = 2.6 * matrix.column.size
    if touching:  # each solution takes some iterations, see `linear.contact`
        blocks = (_ITERATIONS[0] + _ITERATIONS[1] * body.springs) * (blocks + 2.0 * touching)
    stages = 6 if low else 8
    costs = np.zeros(CHOICES)
    costs[VERLET] = 60.0 + force
    costs[ADAMS] = 80.0 + 2.0 * force + n
    costs[ROSENBROCK] = factors + stages * (150.0 + force + 2.0 * blocks + 4.0 * n)
    if low and n >= LONG:
        costs[ALPHA] = MATRICES * (factors + 1.4 * (force + 2.0 * blocks) + 10.0 * n)
    return costs / costs[VERLET]
