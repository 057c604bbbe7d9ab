"""Closed outlines: boxes, regular polygons, and balloons, which are polygons with a filling."""

from __future__ import annotations

import math
from typing import Annotated

from ..numbers import Angle, Damping, Index, Kilograms, Stiffness, Vector, bounded
from ..surroundings import Gas, Liquid, Pressure
from .assembly import Assembly, BulkModulus, Jointed, Parts, Size

PerSide = Annotated[int, bounded(1, 5000, "", "Springs per side", slider=(1, 12))]
Around = Annotated[int, bounded(3, 5000, "", "Masses around", slider=(6, 60))]


class Box(Jointed, frozen=True, kw_only=True):
    """A box without diagonals: angular springs keep its corners at right angles and its sides straight.

    Masses count clockwise on a screen whose y points down, from the upper left corner.

    Attributes:
        width, height: 1e-3..1e6 px.
        per_side: 1..5000 springs on each side; there are four times as many masses.
        center: px.
        turn: -180..180 °, its rotation about its center, from +x towards +y.
        held: indices of the held masses.
    """

    width: Annotated[float, bounded(1e-3, 1e6, "px", "Width", slider=(40.0, 400.0))] = 120.0
    height: Annotated[float, bounded(1e-3, 1e6, "px", "Height", slider=(40.0, 400.0))] = 120.0
    per_side: PerSide = 2
    center: Vector = (300.0, 300.0)
    turn: Angle = 0.0
    held: tuple[Index, ...] = ()

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        right, down = self.width / 2.0, self.height / 2.0
        body = Assembly()
        corners = [(-right, -down), (right, -down), (right, down), (-right, down)]
        _outline(body, self, corners, self.per_side, self.center, self.turn)
        body.hold(self.held, self.driven)
        return body.parts()


class Polygon(Jointed, frozen=True, kw_only=True):
    """A regular polygon: angular springs keep its corners at their angle and its sides straight.

    Masses count clockwise on a screen whose y points down, from the corner at the top.

    Attributes:
        sides: 3..5000.
        per_side: 1..5000 springs on each side.
        circumradius: 1e-3..1e6 px, from the center to a corner.
        center: px.
        turn: -180..180 °, its rotation about its center, from +x towards +y.
        held: indices of the held masses.
    """

    sides: Annotated[int, bounded(3, 5000, "", "Sides", slider=(3, 24))] = 3
    per_side: PerSide = 1
    circumradius: Annotated[float, bounded(1e-3, 1e6, "px", "Circumradius", slider=(30.0, 250.0))] = 100.0
    center: Vector = (300.0, 300.0)
    turn: Angle = 0.0
    held: tuple[Index, ...] = ()

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        _outline(body, self, _corners(self.sides, self.circumradius), self.per_side, self.center, self.turn)
        body.hold(self.held, self.driven)
        return body.parts()


class Balloon(Jointed, frozen=True, kw_only=True):
    """The common basis of balloons: a round skin of springs, which angular springs keep round.

    Attributes:
        masses: 3..5000, around the skin, clockwise on a screen whose y points down, from the top.
        diameter: 1e-3..1e6 px.
        center: px.
    """

    masses: Around = 24
    diameter: Size = 160.0
    center: Vector = (300.0, 180.0)
    stiffness: Stiffness = 10_000.0
    mass: Kilograms = 0.2
    angular_stiffness: Stiffness = 1000.0
    angular_damping: Damping = 8.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        loop = _outline(body, self, _corners(self.masses, self.diameter / 2.0), 1, self.center, 0.0)
        body.fill(self.filling(loop, body.area(loop)))
        body.hold((), self.driven)
        return body.parts()

    def filling(self, loop: tuple[int, ...], area: float) -> Gas | Liquid:
        """Return the contents of a loop of masses with a given area, px²."""
        raise NotImplementedError


class AirBalloon(Balloon, frozen=True, kw_only=True):
    """A skin filled with a gas; with the same pressure outside, it is at rest at its diameter.

    Attributes:
        pressure: 0..1e9 kg/s², of the gas at that diameter.
        outside: 0..1e9 kg/s², the pressure of the air outside.
    """

    pressure: Annotated[
        float, bounded(0.0, 1e9, "kg/s²", "Pressure", slider=(10.0, 1e4), logarithmic=True)
    ] = 1000.0
    outside: Pressure = 1000.0

    def filling(self, loop: tuple[int, ...], area: float) -> Gas:
        """See `Balloon.filling`."""
        return Gas(masses=loop, pressure=self.pressure, outside=self.outside)


class WaterBalloon(Balloon, frozen=True, kw_only=True):
    """A skin filled with a liquid, which preserves its area.

    Attributes:
        bulk_modulus: 0..1e9 kg/s².
        fill: 0.1..10, the area of the liquid relative to the initial area of the skin.
    """

    stiffness: Stiffness = 1500.0
    damping: Damping = 5.0
    angular_stiffness: Stiffness = 100.0
    angular_damping: Damping = 5.0
    bulk_modulus: BulkModulus = 5000.0
    fill: Annotated[float, bounded(0.1, 10.0, "", "Filling", slider=(0.5, 2.0))] = 1.0

    def filling(self, loop: tuple[int, ...], area: float) -> Liquid:
        """See `Balloon.filling`."""
        return Liquid(masses=loop, bulk_modulus=self.bulk_modulus, area=area * self.fill)


def _corners(sides: int, circumradius: float) -> list[Vector]:
    """Return the corners of a regular polygon about the origin, clockwise on a screen, from the top."""
    angles = [2.0 * math.pi * i / sides for i in range(sides)]
    return [(circumradius * math.sin(angle), -circumradius * math.cos(angle)) for angle in angles]


def _outline(
    body: Assembly, recipe: Jointed, corners: list[Vector], per_side: int, center: Vector, turn: float
) -> tuple[int, ...]:
    """Add a closed loop of masses with springs and joints and return the indices of the masses.

    Args:
        corners: about the origin, of a polygon with equal angles.
        per_side: springs on each side.
        center: the new position of the origin.
        turn: rotation, degrees.
    """
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
        for i in range(per_side):
            x = x0 + (x1 - x0) * i / per_side
            y = y0 + (y1 - y0) * i / per_side
            place = (center[0] + cosine * x - sine * y, center[1] + sine * x + cosine * y)
            body.mass(place, recipe.mass, recipe.radius)
    count = len(corners) * per_side
    for i in range(count):
        body.spring(i, (i + 1) % count, recipe.stiffness, recipe.damping)
    corner = 360.0 / len(corners)
    for i in range(count):
        # Mass i + 1 is between spring i and the next.
        body.joint(i, (i + 1) % count, 0.0 if (i + 1) % per_side else corner, recipe)
    return tuple(range(count))
