"""The physics of walls, wind and fillings in NumPy; `sim.physics` is that of springs.

Vectors are complex numbers, as there. For a unit vector n, conj(n) v = n . v + i (n x v) has the parts of v
along n and across it.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from .kernels.around.fillings import SMALLEST
from .kernels.core.surroundings import Surroundings

Vectors = NDArray[np.complex128]
"""An array of vectors, each a complex number."""
Floats = NDArray[np.float64]
"""An array of real numbers."""


def wall_accelerations(around: Surroundings, x: Vectors, v: Vectors) -> Vectors:
    """What all walls do to masses at positions x (px) with velocities v (px/s), px/s²."""
    total, h = np.zeros_like(x), around.step
    for px, py, nx, ny, hardness, rough, slip, loss in around.walls:
        normal = nx + 1j * ny
        depth = np.maximum(((px + 1j * py - x) * normal.conjugate()).real, 0.0)
        speed = v * normal.conjugate()  # real part: outwards, imaginary part: along the wall
        elastic = hardness * depth**2
        push = np.maximum(elastic * (1.0 - loss * speed.real), 0.0)
        push = push / (1.0 + h * (loss * elastic + 2.0 * h * hardness * depth))
        friction = rough * push * np.tanh(speed.imag / (slip + h * rough * push))
        total += (push - 1j * friction) * normal
    return total


def wall_energy(around: Surroundings, x: Vectors, mass: Floats) -> float:
    """The energy of masses (kg) inside walls, kg px²/s²."""
    energy = 0.0
    for px, py, nx, ny, hardness, *_ in around.walls:
        depth = np.maximum(((px + 1j * py - x) * (nx - 1j * ny)).real, 0.0)
        energy += float((mass * hardness * depth**3).sum()) / 3.0
    return energy


def wind(around: Surroundings, x: Vectors, t: float) -> Vectors:
    """The velocity of the air at positions x (px) and a time (s), px/s."""
    total = np.full(x.shape, around.wind_x + 1j * around.wind_y)
    for kx, ky, u, w, phase, rate in around.waves:
        total += (u + 1j * w) * np.sin(kx * x.real + ky * x.imag + phase + rate * t)
    return total


def filling_forces(around: Surroundings, x: Vectors) -> Vectors:
    """What all fillings do to masses at positions x (px), kg px/s²."""
    total = np.zeros_like(x)
    for loop, filling in _loops(around):
        after, before = np.roll(x[loop], -1), np.roll(x[loop], 1)
        # The gradient of the area: half of the way from the mass before to the one after, turned outwards.
        np.add.at(total, loop, -0.5j * (after - before) * pressure(filling, area(x[loop])))
    return total


def filling_energy(around: Surroundings, x: Vectors) -> float:
    """The energy of all fillings, kg px²/s²."""
    return sum(_energy(filling, area(x[loop])) for loop, filling in _loops(around))


def area(corners: Vectors) -> float:
    """The area of a polygon, px²; positive if the corners go from +x towards +y."""
    off = corners - corners[0]
    return 0.5 * float((off.conj() * np.roll(off, -1)).imag.sum())


def pressure(filling: Floats, area: float) -> float:
    """The pressure of a filling, beyond that outside, in a loop of an area (px²), kg/s²."""
    is_gas, strength, outside, size = filling
    if not is_gas:
        return strength * (1.0 - area / size)
    least = SMALLEST * size
    inside = size / area if area > least else size / least * (2.0 - area / least)
    return strength * inside - outside


def _energy(filling: Floats, area: float) -> float:
    is_gas, strength, outside, size = filling
    if not is_gas:
        return 0.5 * strength * (area - size) ** 2 / size
    least = SMALLEST * size
    shrunk = min((area - least) / least, 0.0)
    work = np.log(max(area, least) / size) + shrunk - 0.5 * shrunk**2
    return float(outside * (area - size) - strength * size * work)


def _loops(around: Surroundings) -> list[tuple[NDArray[np.int64], Floats]]:
    """The slots of the masses of each loop, and its row of `Surroundings.fillings`."""
    start = around.loop_start.tolist()
    parts = [around.loop[a:b] for a, b in itertools.pairwise(start)]
    return list(zip(parts, around.fillings, strict=True))
