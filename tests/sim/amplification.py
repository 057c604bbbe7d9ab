"""The exact stability limit of symplectic Euler, by dense matrices made from the reference's forces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sim import Scene
from tests.sim import reference

Matrix = NDArray[np.float64]


def dynamics(scene: Scene, positions: Matrix, velocities: Matrix) -> tuple[Matrix, Matrix]:
    """(M^-1 K, M^-1 C) of the free masses' coordinates, by differences of forces, with air friction."""
    body = reference.body_of(scene)
    free = [i for i, point in enumerate(body.points) if not point.held]

    def put(at: Matrix, moving: Matrix) -> None:
        for point, (x, y), (vx, vy) in zip(body.points, at.tolist(), moving.tolist(), strict=True):
            point.x, point.y = x, y
            point.vx, point.vy = (0.0, 0.0) if point.held else (vx, vy)

    def acceleration() -> Matrix:
        body.forces()
        return np.array(
            [
                (
                    (point.fx - body.air * point.vx * abs(point.vx)) / point.mass,
                    (point.fy - body.air * point.vy * abs(point.vy)) / point.mass,
                )
                for point in (body.points[i] for i in free)
            ]
        ).ravel()

    columns: tuple[list[Matrix], list[Matrix]] = [], []
    for mass in free:
        for axis in (0, 1):
            for kind, size in ((0, 1e-4), (1, 1e-2)):
                ends = []
                for sign in (1.0, -1.0):
                    state = positions.copy(), velocities.copy()
                    state[kind][mass, axis] += sign * size
                    put(*state)
                    ends.append(acceleration())
                columns[kind].append((ends[1] - ends[0]) / (2.0 * size))
    return np.column_stack(columns[0]), np.column_stack(columns[1])


def amplification(k: Matrix, c: Matrix, dt: float) -> Matrix:
    """What a step does to (x, v): v += -dt (K x + C v), then x += dt v."""
    eye = np.eye(len(k))
    v_from_x, v_from_v = -dt * k, eye - dt * c
    return np.block([[eye + dt * v_from_x, dt * v_from_v], [v_from_x, v_from_v]])


def spectral_radius(k: Matrix, c: Matrix, dt: float) -> float:
    return float(np.abs(np.linalg.eigvals(amplification(k, c, dt))).max())


def flips(k: Matrix, c: Matrix, dt: float) -> bool:
    """Whether some motion changes sign and grows at every step, which is how too large a step shows.

    A radius above 1 alone does not say so: compressed springs buckle at any step.
    """
    values = np.linalg.eigvals(amplification(k, c, dt))
    return bool(((values.real < -1.0) & (np.abs(values.imag) < 1e-9)).any())


def exact_limit(k: Matrix, c: Matrix) -> float:
    """The largest step without flips, by bisection."""
    high = 1e-6
    while not flips(k, c, high):
        high *= 1.3
    low = high / 1.3
    for _ in range(18):  # to a millionth
        middle = 0.5 * (low + high)
        low, high = (low, middle) if flips(k, c, middle) else (middle, high)
    return low
