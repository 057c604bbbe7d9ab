"""Gases and liquids in closed loops of masses.

With the area A of a loop and the excess pressure p(A), kg/s², the force on each mass is p dA/dx. The area is
that of the shoelace formula, half of the sum of x_i × x_{i+1}, so with the neighbours a before and b after a
mass, dA/dx = (b.y - a.y, a.x - b.x) / 2. The forces of a loop have no sum and no torque, and are minus the
gradient of an energy U(A) with U' = -p.

- Gas at a constant temperature: p = P A0 / A - outside, U = outside (A - A0) - P A0 ln(A / A0). Below
  `SMALLEST` A0 the pressure inside goes on along its tangent, through an area of zero and beyond.
- Liquid: p = K (1 - A / A0), U = K (A - A0)² / (2 A0).
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engine.jit import FAST, kernel
from ..engine.table import Indices, Rows, Table
from ..engine.tables import Body, State
from ..scene.surroundings import Gas, Liquid
from ..scene.types import Scene
from .term import Places, Term, Vectors

# Unless noted, doubling or halving one of these numbers fails no test.
SMALL = 8
"""Largest number of masses of a loop whose matrix in an implicit step has a block for each pair of them."""

SMALLEST = 0.01
"""Area of a gas, as a fraction of its own area, below which its pressure grows linearly."""

_THINNEST = 1e-3
"""The least own area of a gas, as a fraction of the squared length around its loop; a circle has 0.08."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Fillings(Table):
    """Read-only. L loops with a filling, M masses in all of them together."""

    start: Indices  # (L + 1,) where the masses of each loop start in `loop`
    loop: Indices  # (M,) slots of the masses of all loops, each in the order in which its area is positive
    rows: Rows  # (L, 4), a `FillingRow` each

    def loops(self) -> list[Indices]:
        """The slots of the masses of each loop; for Python only."""
        return [self.loop[a:b] for a, b in itertools.pairwise(self.start.tolist())]


class FillingRow(NamedTuple):
    """A gas or a liquid."""

    is_gas: float  # 1 for a gas, 0 for a liquid
    strength: float  # kg/s², pressure of a gas at its own area, or bulk modulus of a liquid
    outside: float  # kg/s², the pressure outside
    area: float  # px², its own


NO_FILLINGS = Fillings(
    start=np.zeros(1, np.int64), loop=np.zeros(0, np.int64), rows=np.zeros((0, len(FillingRow._fields)))
).read_only()


def new_fillings(scene: Scene, places: Places) -> Fillings:
    """The table of a valid scene."""
    if not scene.fillings:
        return NO_FILLINGS
    at = np.array([complex(*mass.position) for mass in scene.masses])
    rest = {frozenset((s.a, s.b)): s.rest_length for s in scene.linear_springs}
    loops, rows = [], []
    for filling in scene.fillings:
        masses = list(filling.masses)
        area = polygon_area(at[masses])
        loops.append(places.mass_index[masses if area > 0.0 else masses[::-1]])
        edges = zip(masses, masses[1:] + masses[:1], strict=True)
        around = sum(max(abs(at[b] - at[a]), rest.get(frozenset((a, b)), 0.0)) for a, b in edges)
        rows.append(_row(filling, abs(area), float(around)))
    return Fillings(
        start=np.cumsum([0, *map(len, loops)]).astype(np.int64),
        loop=np.concatenate([np.zeros(0, np.int64), *loops]),
        rows=np.array(rows, float).reshape(-1, len(FillingRow._fields)),
    )


def _row(filling: Gas | Liquid, area: float, around: float) -> FillingRow:
    """The row of a filling; area, px², and length around, px: of its loop."""
    size = filling.area if filling.area is not None else area
    if isinstance(filling, Liquid):
        return FillingRow(0.0, filling.bulk_modulus, 0.0, size)
    # A gas whose area is tiny is the same as one at a larger area. Below a hundredth of its area, its
    # pressure grows linearly, and no step could follow that within a hundredth of a tiny one: it would lead
    # to where pressures are enormous, and energy would come from nowhere.
    larger = max(size, area, _THINNEST * around * around)
    return FillingRow(1.0, filling.pressure * (size / larger), filling.outside, larger)


@kernel(forceinline=True)
def _filling_at(fillings, k):
    """The k-th filling."""
    row = fillings.rows[k]
    return FillingRow(row[0], row[1], row[2], row[3])


# ------------------------------------------------------------------------- force and energy
@kernel(forceinline=True)
def _neighbours(fillings, k, i):
    """The slots of the masses before and after the i-th of all masses in loops, which is in loop k."""
    first, behind = fillings.start[k], fillings.start[k + 1]
    before = fillings.loop[i - 1] if i > first else fillings.loop[behind - 1]
    after = fillings.loop[i + 1] if i + 1 < behind else fillings.loop[first]
    return before, after


@kernel(forceinline=True, fastmath=FAST)
def _area_by_mass(fillings, k, i, q):
    """The gradient of the area of loop k by the position of its mass `fillings.loop[i]`, px."""
    slots = q.size // 2
    before, after = _neighbours(fillings, k, i)
    return 0.5 * (q[slots + after] - q[slots + before]), 0.5 * (q[before] - q[after])


@kernel(fastmath=FAST)
def _area_of(fillings, k, q):
    """The area of a loop, px²."""
    first, behind = np.uint64(fillings.start[k]), np.uint64(fillings.start[k + 1])
    x0, y0 = _at(q, fillings.loop[first])  # differences lose no digits far from the origin
    before_x, before_y, twice = 0.0, 0.0, 0.0
    for i in range(first + np.uint64(1), behind):
        x, y = _at(q, fillings.loop[i])
        twice += before_x * (y - y0) - (x - x0) * before_y
        before_x, before_y = x - x0, y - y0
    return 0.5 * twice


@kernel(inline="always")
def _at(q, m):
    """The position of mass m."""
    # With unsigned indices numba omits its test for negative ones.
    return q[np.uint64(m)], q[np.uint64(q.size // 2) + np.uint64(m)]


@kernel(fastmath=FAST)
def _pressure_at(filling, area):
    """The pressure of a filling beyond that outside, kg/s², and its derivative by the area."""
    size, strength = filling.area, filling.strength
    if filling.is_gas == 0.0:
        return strength * (1.0 - area / size), -strength / size
    least = SMALLEST * size
    if area > least:
        inside = strength * size / area
        return inside - filling.outside, -inside / area
    return (
        strength * size * (2.0 - area / least) / least - filling.outside,
        -strength * size / (least * least),
    )


@kernel(fastmath=FAST)
def _energy_at(filling, area):
    """The energy of a filling, kg px²/s², zero at its own area."""
    size, strength = filling.area, filling.strength
    off = area - size
    if filling.is_gas == 0.0:
        return 0.5 * strength * off * off / size
    least = SMALLEST * size
    if area > least:
        return filling.outside * off - strength * size * math.log(area / size)
    below = (area - least) / least
    return filling.outside * off - strength * size * (math.log(SMALLEST) + below - 0.5 * below * below)


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    fillings = body.environment.fillings
    for k in range(fillings.rows.shape[0]):
        pressure, _ = _pressure_at(_filling_at(fillings, k), _area_of(fillings, k, q))
        half = 0.5 * pressure
        first, behind = np.uint64(fillings.start[k]), np.uint64(fillings.start[k + 1])
        start, m = fillings.loop[first], fillings.loop[first]
        (before_x, before_y), (x, y) = _at(q, fillings.loop[behind - np.uint64(1)]), _at(q, m)
        for i in range(first + np.uint64(1), behind + np.uint64(1)):
            after = fillings.loop[i] if i < behind else start
            after_x, after_y = _at(q, after)
            # As `_area_by_mass`.
            scratch.fx[np.uint64(m)] += half * (after_y - before_y)
            scratch.fy[np.uint64(m)] += half * (before_x - after_x)
            before_x, before_y, x, y, m = x, y, after_x, after_y, after


@kernel(fastmath=FAST)
def _energy(body, state, q):
    fillings, energy = body.environment.fillings, 0.0
    for k in range(fillings.rows.shape[0]):
        energy += _energy_at(_filling_at(fillings, k), _area_of(fillings, k, q))
    return energy


# ------------------------------------------------------------------------- derivatives
@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    """The part p d²A/dx² of the derivative of the forces, at the rows of each mass and its neighbours.

    By the mass b after it, dA/dx = (b.y - a.y, a.x - b.x) / 2 has the derivative ((0, 1), (-1, 0)) / 2, and
    by the one before it minus that. This is indefinite. The other part, that of `write_area_product`, couples
    all masses of a loop; it is added here for small loops, whose pattern has all blocks.
    """
    fillings, blocks, target = body.environment.fillings, matrix.blocks, 0
    for k in range(fillings.rows.shape[0]):
        first, behind = fillings.start[k], fillings.start[k + 1]
        pressure, slope = _pressure_at(_filling_at(fillings, k), _area_of(fillings, k, q))
        half, count = 0.0 if definite else 0.5 * pressure, behind - first
        small = count <= SMALL
        for i in range(count):
            if small:
                x, y = _area_by_mass(fillings, k, first + i, q)
                for j in range(count):
                    to_x, to_y = _area_by_mass(fillings, k, first + j, q)
                    block = 4 * matrix.loop_target[target + j]
                    blocks[block] += slope * x * to_x
                    blocks[block + 1] += slope * x * to_y
                    blocks[block + 2] += slope * y * to_x
                    blocks[block + 3] += slope * y * to_y
                before = 4 * matrix.loop_target[target + (i + count - 1) % count]
                after = 4 * matrix.loop_target[target + (i + 1) % count]
                target += count
            else:
                before, after = 4 * matrix.loop_target[target], 4 * matrix.loop_target[target + 1]
                target += 2
            blocks[after + 1] += half
            blocks[after + 2] -= half
            blocks[before + 1] -= half
            blocks[before + 2] += half


@kernel(fastmath=FAST)
def write_area_product(body, state, k, q, gradient, scaled):
    """The part of the derivative that couples all masses of loop k, -c G Gᵀ with c = -dp/dA, kg/(px² s²).

    Args:
        gradient: gets G = dA/dx, px.
        scaled: gets c M^-1 G, 1/(px s²).
    """
    fillings, w, slots = body.environment.fillings, state.inverse_mass, q.size // 2
    gradient[:], scaled[:] = 0.0, 0.0
    _, slope = _pressure_at(_filling_at(fillings, k), _area_of(fillings, k, q))
    for i in range(fillings.start[k], fillings.start[k + 1]):
        m = fillings.loop[i]
        dx, dy = _area_by_mass(fillings, k, i, q)
        gradient[m] += dx
        gradient[slots + m] += dy
        scaled[m] = -slope * w[m] * gradient[m]
        scaled[slots + m] = -slope * w[m] * gradient[slots + m]


# ------------------------------------------------------------------------- in NumPy
class FillingsReference:
    """Gases and liquids in NumPy; see `Reference`."""

    def __init__(self, body: Body, _state: State) -> None:
        fillings = body.environment.fillings
        self._loops = list(zip(fillings.loops(), map(FillingRow._make, fillings.rows), strict=True))

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        total = np.zeros_like(x)
        for loop, filling in self._loops:
            after, before = np.roll(x[loop], -1), np.roll(x[loop], 1)
            # The gradient of the area: half of the way from the mass before to the one after, turned.
            np.add.at(total, loop, -0.5j * (after - before) * _pressure(filling, polygon_area(x[loop])))
        return total

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return sum(_energy_of(filling, polygon_area(x[loop])) for loop, filling in self._loops)


def polygon_area(corners: NDArray[np.complex128]) -> float:
    """The area of a polygon, px²; positive if the corners go from +x towards +y."""
    off = corners - corners[0]
    return 0.5 * float((off.conj() * np.roll(off, -1)).imag.sum())


def _pressure(filling: FillingRow, area: float) -> float:
    """As `_pressure_at`, kg/s²."""
    is_gas, strength, outside, size = filling
    if not is_gas:
        return strength * (1.0 - area / size)
    least = SMALLEST * size
    inside = size / area if area > least else size / least * (2.0 - area / least)
    return strength * inside - outside


def _energy_of(filling: FillingRow, area: float) -> float:
    """As `_energy_at`, kg px²/s²."""
    is_gas, strength, outside, size = filling
    if not is_gas:
        return 0.5 * strength * (area - size) ** 2 / size
    least = SMALLEST * size
    shrunk = min((area - least) / least, 0.0)
    work = np.log(max(area, least) / size) + shrunk - 0.5 * shrunk**2
    return float(outside * (area - size) - strength * size * work)


FILLINGS = Term(
    "fillings",
    lambda scene: bool(scene.fillings),
    FillingsReference,
    _add_forces,
    field="fillings",
    table=Fillings,
    new=new_fillings,
    energy=_energy,
    label="gases and liquids",
    add_derivatives=_add_derivatives,
)
