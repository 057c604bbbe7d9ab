"""Ropes and rods: masses in a straight row."""

from __future__ import annotations

import math
from typing import Annotated

from ..numbers import MAX_MASSES, Angle, Damping, Index, Kilograms, Radius, Stiffness, Vector, bounded
from ..parts import AngularSpring, Circle
from .assembly import Assembly, Jointed, Parts, Recipe


class Rope(Recipe, frozen=True, kw_only=True):
    """A straight rope, with any rest angle, as in the tutorial.

    Mass i starts at `start` + (i + offset) * length / (masses - 1) * direction / |direction|. Linear spring s
    connects masses s and s + 1; angular spring j connects linear springs j and j + 1.

    Attributes:
        masses: 2..20000.
        length: 1e-3..1e6 px; every linear spring's rest length is length / (masses - 1).
        start: px.
        offset: -1000..1000; shifts the whole rope by that many spring lengths.
        direction: any vector but zero.
        stiffness, damping: of every linear spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        angular_stiffness, angular_damping: of every angular spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        rest_angle: of every angular spring, -180..180 °.
        joints: whether there are angular springs; with a stiffness of 0 they only measure angles.
        mass, radius: of every mass, kg and px.
        held: indices of the held masses.
        driven: index of the held mass that the pointer drives, or None.
        circle: motion of mass 0, if it is held, or None.
    """

    masses: Annotated[int, bounded(2, MAX_MASSES, "", "Number of masses", slider=(3, 60))] = 12
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length of the rope")] = 300.0
    start: Vector = (0.0, 0.0)
    offset: Annotated[float, bounded(-1000.0, 1000.0, "springs", "Shift in spring lengths")] = 0.0
    direction: Vector = (1.0, 0.0)
    stiffness: Stiffness = 10_000.0
    damping: Damping = 40.0
    angular_stiffness: Stiffness = 10_000.0
    angular_damping: Damping = 0.0
    rest_angle: Angle = 0.0
    joints: bool = True
    mass: Kilograms = 1.0
    radius: Radius = 6.0
    held: tuple[Index, ...] = (0,)
    driven: Index | None = None
    circle: Circle | None = None

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        n = self.masses
        spacing = self.length / (n - 1)
        dx, dy = self.direction
        norm = math.hypot(dx, dy)
        dx, dy = dx / norm, dy / norm
        body = Assembly()
        for i in range(n):
            along = spacing * (i + self.offset)
            body.mass((self.start[0] + along * dx, self.start[1] + along * dy), self.mass, self.radius)
        for i in range(n - 1):
            body.spring(i, i + 1, self.stiffness, self.damping, spacing)
        for j in range(n - 2 if self.joints else 0):
            angle, stiffness, damping = self.rest_angle, self.angular_stiffness, self.angular_damping
            body.add_joint(
                AngularSpring(a=j, b=j + 1, stiffness=stiffness, damping=damping, rest_angle=angle)
            )
        body.hold(self.held, self.driven, self.circle)
        return body.parts()


class Rod(Jointed, frozen=True, kw_only=True):
    """A straight rod. Two held masses at an end clamp it; one lets it swing.

    Spring s connects masses s and s + 1, and angular spring j springs j and j + 1. As a beam it has the
    bending stiffness EI = angular_stiffness (length / (masses - 1))³.

    Attributes:
        masses: 3..20000.
        length: 1e-3..1e6 px.
        start: of mass 0, px.
        direction: any vector but zero.
        held: indices of the held masses.
    """

    masses: Annotated[int, bounded(3, MAX_MASSES, "", "Number of masses", slider=(3, 60))] = 10
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length", slider=(60.0, 480.0))] = 360.0
    start: Vector = (120.0, 260.0)
    direction: Vector = (1.0, 0.0)
    held: tuple[Index, ...] = (0, 1)
    stiffness: Stiffness = 50_000.0
    damping: Damping = 40.0
    angular_stiffness: Stiffness = 50_000.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        spacing = self.length / (self.masses - 1)
        norm = math.hypot(*self.direction)
        dx, dy = (step / norm * spacing for step in self.direction)
        for i in range(self.masses):
            body.mass((self.start[0] + i * dx, self.start[1] + i * dy), self.mass, self.radius)
        for i in range(self.masses - 1):
            body.spring(i, i + 1, self.stiffness, self.damping, spacing)
        for j in range(self.masses - 2):
            body.joint(j, j + 1, 0.0, self)
        body.hold(self.held, self.driven)
        return body.parts()
