"""The exact stability limits of methods, by dense matrices made from the reference's forces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sim import Scene
from tests.sim.laws import Laws, complexes, points

Matrix = NDArray[np.float64]


def dynamics(scene: Scene, positions: Matrix, velocities: Matrix) -> tuple[Matrix, Matrix]:
    """(M^-1 K, M^-1 C) of the free masses' coordinates, by differences of forces, with air friction."""
    laws = Laws(scene)
    free = [i for i in range(len(scene.masses)) if i not in laws.held]
    columns: tuple[list[Matrix], list[Matrix]] = [], []
    for mass in free:
        for axis in (0, 1):
            for kind, size in ((0, 1e-4), (1, 1e-2)):
                ends = []
                for sign in (1.0, -1.0):
                    state = positions.copy(), velocities.copy()
                    state[kind][mass, axis] += sign * size
                    ends.append(points(laws.accelerations(*map(complexes, state)))[free].ravel())
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
    """Whether some motion that takes less than four steps a period grows: so a step shows that is too large.

    A radius above 1 alone does not say so: compressed springs buckle at any step, and under the tutorial's
    law fast vibrations may grow by themselves. Twice that growth is allowed.
    """
    values = np.linalg.eigvals(amplification(k, c, dt))
    rates = np.linalg.eigvals(np.block([[np.zeros_like(k), np.eye(len(k))], [-k, -c]]))
    fast = (np.abs(rates) > 0.5 * np.abs(rates).max()) & (rates.imag != 0.0)
    own = float(rates[fast].real.max(initial=0.0))
    return bool((np.abs(values[values.real < 0.0]) > 1.001 * np.exp(2.0 * own * dt)).any())


def exact_limit(k: Matrix, c: Matrix) -> float:
    """The largest step without flips, by bisection."""
    high = 1e-4
    while flips(k, c, high):
        high *= 0.5
    while not flips(k, c, high):
        high *= 2.0
    low = 0.5 * high
    for _ in range(13):  # to a ten thousandth
        middle = 0.5 * (low + high)
        low, high = (low, middle) if flips(k, c, middle) else (middle, high)
    return low


def verlet_step(k: Matrix, c: Matrix, dt: float) -> Matrix:
    """One step of velocity Verlet on (x, v, a), where a is evaluated at the new positions and at v + dt a."""
    eye, zero = np.eye(len(k)), np.zeros_like(k)
    position = [eye, dt * eye, 0.5 * dt**2 * eye]
    guess = [zero, eye, dt * eye]
    force = [-k @ p - c @ g for p, g in zip(position, guess, strict=True)]
    speed = [0.5 * dt * force[0], eye + 0.5 * dt * force[1], 0.5 * dt * (eye + force[2])]
    return np.block([position, speed, force])


def rk4_step(k: Matrix, c: Matrix, dt: float) -> Matrix:
    """exp(dt A) of (x, v)' = A (x, v), to fourth order."""
    eye, zero = np.eye(len(k)), np.zeros_like(k)
    z = dt * np.block([[zero, eye], [-k, -c]])
    one = np.eye(len(z))
    return one + z @ (one + z @ (one + z @ (one + z / 4.0) / 3.0) / 2.0)


STEPS = {"symplectic_euler": amplification, "velocity_verlet": verlet_step, "rk4": rk4_step}
"""What a step makes of small motions, by method."""


def radius(method: str, k: Matrix, c: Matrix, dt: float) -> float:
    """By how much the motion that grows fastest grows in a step."""
    return float(np.abs(np.linalg.eigvals(STEPS[method](k, c, dt))).max())
