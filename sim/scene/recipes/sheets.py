"""Sheets: cloth, a flag on its pole, and jelly, which are grids of masses."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from ..numbers import Damping, Index, Kilograms, Stiffness, Vector, bounded
from ..surroundings import Liquid
from .assembly import Assembly, BulkModulus, Jointed, Parts, Size, Sprung

Columns = Annotated[int, bounded(2, 10_000, "", "Columns", slider=(2, 16))]
Rows = Annotated[int, bounded(2, 10_000, "", "Rows", slider=(2, 16))]
ShearStiffness = Annotated[
    float, bounded(0.0, 1e15, "kg/s²", "Shear stiffness", slider=(1.0, 1e5), logarithmic=True)
]


class Cloth(Jointed, frozen=True, kw_only=True):
    """A rectangle of cloth: springs along rows and columns, which angular springs keep straight.

    Masses count along the rows, from the upper left corner. Springs along the rows come first, then those
    along the columns, then the diagonals.

    Attributes:
        columns, rows: 2..10000 masses each way.
        width, height: 1e-3..1e6 px.
        start: of mass 0, px.
        diagonals: whether two springs cross each cell. Without them, angular springs keep its corners at
            right angles, with the stiffness of the others.
        shear_stiffness: of the diagonals, 0..1e15 kg/s².
        held: the held masses: the first row, its two ends, the first mass, or none.
    """

    columns: Columns = 10
    rows: Rows = 10
    width: Size = 270.0
    height: Size = 270.0
    start: Vector = (165.0, 120.0)
    diagonals: bool = True
    shear_stiffness: ShearStiffness = 1000.0
    held: Literal["edge", "corners", "corner", "nothing"] = "corners"
    stiffness: Stiffness = 5000.0
    damping: Damping = 5.0
    mass: Kilograms = 0.2
    radius: Annotated[float, bounded(1e-3, 1e4, "px", "The radius a mass is drawn with")] = 4.0
    angular_stiffness: Stiffness = 50.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        columns, rows = self.columns, self.rows
        _masses(body, self, columns, rows, self.start, (self.width, self.height))
        along, down = _springs(body, self, columns, rows)
        if self.diagonals:
            _crosses(body, self.shear_stiffness, self.damping, columns, rows)
        for row in along:
            for a, b in pairwise(row):
                body.joint(a, b, 0.0, self)
        for upper, lower in pairwise(down):
            for a, b in zip(upper, lower, strict=True):
                body.joint(a, b, 0.0, self)
        if not self.diagonals:
            for row, columns_below in zip(along, down, strict=False):
                for a, b in zip(row, columns_below, strict=False):
                    body.joint(a, b, 90.0, self)
        held = {"edge": tuple(range(columns)), "corners": (0, columns - 1), "corner": (0,), "nothing": ()}
        body.hold(held[self.held], self.driven)
        return body.parts()


class Jelly(Sprung, frozen=True, kw_only=True):
    """A block of jelly: a grid of springs, two of them across each cell, with a filling that preserves the
    area.

    The filling pushes back a cell that is turned inside out, as springs alone would not.

    Masses count along the rows, from the upper left corner. Springs along the rows come first, then those
    along the columns, then the diagonals.

    Attributes:
        columns, rows: 2..10000 masses each way.
        width, height: 1e-3..1e6 px.
        center: px.
        shear_stiffness: of the diagonals, 0..1e15 kg/s².
        bulk_modulus: 0..1e9 kg/s², of a `Liquid` in each cell; there is none if it is 0.
    """

    columns: Columns = 9
    rows: Rows = 6
    width: Size = 240.0
    height: Size = 150.0
    center: Vector = (300.0, 300.0)
    shear_stiffness: ShearStiffness = 500.0
    bulk_modulus: BulkModulus = 1000.0
    stiffness: Stiffness = 1000.0
    damping: Damping = 4.0
    mass: Kilograms = 0.5
    radius: Annotated[float, bounded(1e-3, 1e4, "px", "The radius a mass is drawn with")] = 4.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        columns, rows = self.columns, self.rows
        start = (self.center[0] - self.width / 2.0, self.center[1] - self.height / 2.0)
        _masses(body, self, columns, rows, start, (self.width, self.height))
        _springs(body, self, columns, rows)
        _crosses(body, self.shear_stiffness, self.damping, columns, rows)
        if self.bulk_modulus:
            for row in range(rows - 1):
                for first in range(row * columns, (row + 1) * columns - 1):
                    loop = (first, first + 1, first + columns + 1, first + columns)
                    body.fill(Liquid(masses=loop, bulk_modulus=self.bulk_modulus, area=body.area(loop)))
        body.hold((), self.driven)
        return body.parts()


class FlagPole(Jointed, frozen=True, kw_only=True):
    """A bendy pole, clamped by its two lowest masses, with a flag of springs at its top.

    Masses count up the pole from its foot, then along the rows of the flag, the uppermost first; each row
    begins at a mass of the pole.

    Attributes:
        masses: 3..10000, of the pole.
        height: 1e-3..1e6 px, of the pole.
        start: of its foot, px.
        columns: 1..10000 masses in each row of the flag, without that of the pole.
        rows: 2..10000, of the flag, as far apart as the masses of the pole; rows below its foot are omitted.
        length: 1e-3..1e6 px, of the flag.
        flag_stiffness, flag_damping, flag_angular_stiffness: of the flag's springs.
        shear_stiffness: of two springs across each cell of the flag, 0..1e15 kg/s².
        flag_mass: of each mass of the flag, 1e-6..1e6 kg.
    """

    masses: Annotated[int, bounded(3, 10_000, "", "Masses of the pole", slider=(4, 20))] = 9
    height: Size = 400.0
    start: Vector = (160.0, 560.0)
    columns: Annotated[int, bounded(1, 10_000, "", "Columns of the flag", slider=(1, 12))] = 6
    rows: Annotated[int, bounded(2, 10_000, "", "Rows of the flag", slider=(2, 8))] = 4
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length of the flag", slider=(60.0, 400.0))] = 228.0
    flag_stiffness: Stiffness = 1500.0
    flag_damping: Damping = 1.0
    flag_angular_stiffness: Stiffness = 30.0
    shear_stiffness: ShearStiffness = 30.0
    flag_mass: Annotated[float, bounded(1e-6, 1e6, "kg", "Mass of a flag's point", slider=(0.02, 1.0))] = 0.1
    stiffness: Stiffness = 20_000.0
    damping: Damping = 40.0
    angular_stiffness: Stiffness = 12_000.0
    driven: Index | None = 0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        spacing, step = self.height / (self.masses - 1), self.length / self.columns
        x, y = self.start
        pole = [body.mass((x, y - i * spacing), self.mass, self.radius) for i in range(self.masses)]
        rows = []
        for top in pole[: -self.rows - 1 : -1]:
            height = y - top * spacing
            flag = [
                body.mass((x + i * step, height), self.flag_mass, 0.6 * self.radius)
                for i in range(1, self.columns + 1)
            ]
            rows.append([top, *flag])
        poles = [body.spring(a, a + 1, self.stiffness, self.damping, spacing) for a in pole[:-1]]
        along = [
            [body.spring(a, b, self.flag_stiffness, self.flag_damping, step) for a, b in pairwise(row)]
            for row in rows
        ]
        for upper, lower in pairwise(rows):
            for a, b in zip(upper[1:], lower[1:], strict=True):
                body.spring(a, b, self.flag_stiffness, self.flag_damping, spacing)
        for upper, lower in pairwise(rows):
            for (a, b), (c, d) in zip(pairwise(upper), pairwise(lower), strict=True):
                body.spring(a, d, self.shear_stiffness, self.flag_damping)
                body.spring(b, c, self.shear_stiffness, self.flag_damping)
        for a, b in pairwise(poles):
            body.joint(a, b, 0.0, self)
        for row in along:
            for a, b in pairwise(row):
                body.joint(a, b, 0.0, self, self.flag_angular_stiffness)
        body.hold((0, 1), self.driven)
        return body.parts()


def _masses(body: Assembly, recipe: Sprung, columns: int, rows: int, start: Vector, size: Vector) -> None:
    """Add the masses of a grid, row by row."""
    for row in range(rows):
        y = start[1] + size[1] * row / (rows - 1)
        for column in range(columns):
            x = start[0] + size[0] * column / (columns - 1)
            body.mass((x, y), recipe.mass, recipe.radius)


def _springs(
    body: Assembly, recipe: Sprung, columns: int, rows: int
) -> tuple[list[list[int]], list[list[int]]]:
    """Add the springs of a grid; return those along each row, and those below each row but the last."""
    along = [
        [
            body.spring(i, i + 1, recipe.stiffness, recipe.damping)
            for i in range(row * columns, (row + 1) * columns - 1)
        ]
        for row in range(rows)
    ]
    down = [
        [
            body.spring(i, i + columns, recipe.stiffness, recipe.damping)
            for i in range(row * columns, (row + 1) * columns)
        ]
        for row in range(rows - 1)
    ]
    return along, down


def _crosses(body: Assembly, stiffness: float, damping: float, columns: int, rows: int) -> None:
    """Add the diagonals of a grid: first those down to the right, then those down to the left."""
    cells = [row * columns + column for row in range(rows - 1) for column in range(columns - 1)]
    for a in cells:
        body.spring(a, a + columns + 1, stiffness, damping)
    for a in cells:
        body.spring(a + 1, a + columns, stiffness, damping)
