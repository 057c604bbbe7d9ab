"""The physics of walls, wind, fillings and contact in NumPy; `sim.physics` is that of springs.

Vectors are complex numbers, as there. For a unit vector n, conj(n) v = n . v + i (n x v) has the parts of v
along n and across it.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from .kernels.around.bounce import CALMING
from .kernels.around.fillings import SMALLEST
from .kernels.core.surroundings import Surroundings
from .near import near_pairs, nearest_points

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
        push, friction = _push_and_friction(hardness, loss, rough, slip, h, 1.0, 1.0, depth, speed)
        total += (push - 1j * friction) * normal
    return total


def _push_and_friction(
    stiffness: float,
    loss: float,
    rough: float | Floats,
    slip: float,
    h: float,
    across: float | Floats,
    around: float | Floats,
    depth: NDArray[np.floating],
    speed: Vectors,
) -> tuple[Floats, Floats]:
    """See `kernels.around.bounce`; the speed is outwards + i along."""
    elastic = stiffness * depth**2
    power = (h * across * (loss * elastic + 4.0 * h * stiffness * depth)) ** 4
    calming = CALMING * h / np.maximum(depth, 1e-300) * (power / (1.0 + power))
    push = np.maximum(elastic * (1.0 - (loss + calming) * speed.real), 0.0) / (1.0 + power) ** 0.25
    slips = (slip**4 + (h * around * rough * push) ** 4) ** 0.25
    return push, rough * push * np.tanh(speed.imag / slips)


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


class Touching:
    """Contact of a body's masses with its springs, see `kernels.around.contact`.

    Pairs that are nearer than the distance of contact plus a margin are kept until some mass has moved by
    half of the margin.

    Args:
        around: what surrounds the body.
        inverse_mass: (slots,) 1/kg, zero for a mass that is held; for explicit methods.
        masses: number of masses.
        ends: (S, 2) slots of the masses at the ends of each spring.
    """

    def __init__(
        self, around: Surroundings, inverse_mass: Floats, masses: int, ends: NDArray[np.int64]
    ) -> None:
        self._around, self._inverse_mass, self._ends = around, inverse_mass, ends
        self._masses = np.arange(1, masses + 1)
        self._at = np.full(inverse_mass.size, np.inf + 0j)
        self._pairs = np.zeros((3, 0), np.int64)

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """What contact does to masses at positions x (px) with velocities v (px/s), kg px/s²."""
        contact, total = self._around.contact, np.zeros_like(x)
        pairs, t, gap = self._touching(x)
        m, a, b = pairs
        spring, turning = x[b] - x[a], v[b] - v[a]
        normal, square = gap / np.maximum(abs(gap), 1e-300), np.maximum(abs(spring) ** 2, 1e-300)
        lever = 1j * spring * abs(gap) / square
        rate = (v[m] - v[a] - t * turning) * normal.conjugate()
        speed = rate - 1j * (turning * lever.conjugate()).real
        free, tangent = self._inverse_mass, 1j * normal
        across = free[m] + (1.0 - t) ** 2 * free[a] + t**2 * free[b]
        around = (
            free[m]
            + free[a] * abs(lever - (1.0 - t) * tangent) ** 2
            + free[b] * abs(lever + t * tangent) ** 2
        )
        rough = contact.friction * np.minimum(square / contact.distance**2, 1.0)
        push, friction = _push_and_friction(
            contact.stiffness, contact.loss, rough, contact.slip,
            self._around.step, across, around, contact.distance - abs(gap), speed,
        )  # fmt: skip
        force, couple = (push - 1j * friction) * normal, friction * lever
        np.add.at(total, m, force)
        np.add.at(total, a, -(1.0 - t) * force - couple)
        np.add.at(total, b, -t * force + couple)
        return total

    def energy(self, x: Vectors) -> float:
        """The energy of all pairs that touch, kg px²/s²."""
        contact = self._around.contact
        _, _, gap = self._touching(x)
        return float((contact.stiffness * (contact.distance - abs(gap)) ** 3).sum()) / 3.0

    def _touching(self, x: Vectors) -> tuple[NDArray[np.int64], Floats, Vectors]:
        """(3, k) the mass and the ends of the spring of each pair, the nearest point, and the way from it."""
        contact = self._around.contact
        here = self._masses
        if not np.isfinite(x[here]).all():
            return self._pairs[:, :0], np.zeros(0), x[:0]
        if not 2.0 * float(abs(x[here] - self._at[here]).max()) <= contact.margin:
            self._pairs, self._at = self._near(x), x.copy()
        m, a, b = self._pairs
        t = nearest_points(x[m], x[a], x[b])
        gap = x[m] - x[a] - t * (x[b] - x[a])
        near = abs(gap) < contact.distance
        return self._pairs[:, near], t[near], gap[near]

    def _near(self, x: Vectors) -> NDArray[np.int64]:
        """(3, k) the mass and the ends of the spring of each pair that may touch."""
        contact = self._around.contact
        spring, mass = near_pairs(x, self._masses, self._ends, contact.distance + contact.margin)
        never = np.repeat(np.arange(len(self._ends)), np.diff(contact.apart_start))
        apart = np.isin(spring * x.size + mass, never * x.size + contact.apart)
        return np.stack((mass, *self._ends[spring].T))[:, ~apart & (contact.broken[spring] == 0.0)]


def _loops(around: Surroundings) -> list[tuple[NDArray[np.int64], Floats]]:
    """The slots of the masses of each loop, and its row of `Surroundings.fillings`."""
    start = around.loop_start.tolist()
    parts = [around.loop[a:b] for a, b in itertools.pairwise(start)]
    return list(zip(parts, around.fillings, strict=True))
