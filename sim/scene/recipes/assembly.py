"""The common basis of recipes: a body under construction, and parameters shared by most bodies."""

from __future__ import annotations

import math
import re
from typing import Annotated, NamedTuple

import msgspec

from ...text import Text
from ..numbers import (
    MAX_MASSES,
    MAX_SPRINGS,
    Damping,
    Index,
    Kilograms,
    Radius,
    Stiffness,
    Vector,
    bounded,
)
from ..parts import Anchor, AngularSpring, Circle, LinearSpring, Mass
from ..surroundings import Gas, Liquid, loop_area

Size = Annotated[float, bounded(1e-3, 1e6, "px", "A length")]
BulkModulus = Annotated[
    float, bounded(0.0, 1e9, "kg/s²", "Bulk modulus", slider=(10.0, 1e5), logarithmic=True)
]
Bend = Annotated[float, bounded(-180.0, 180.0, "°", "Curl of every joint", slider=(-60.0, 60.0))]


class Parts(NamedTuple):
    """A body's masses, springs, anchors and fillings, which refer to one another by index."""

    masses: tuple[Mass, ...]
    linear_springs: tuple[LinearSpring, ...]
    angular_springs: tuple[AngularSpring, ...]
    anchors: tuple[Anchor, ...]
    fillings: tuple[Gas | Liquid, ...]


class TooLarge(ValueError):
    """A recipe makes more masses or springs than a scene may have; the message gives the maximum."""


def _snake(name: str) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


class Recipe(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="recipe", tag=_snake
):
    """A body of a certain shape; in a file, the field `recipe` contains its name, such as "air_balloon".

    A recipe is expanded when a scene is made, always into the same body.
    """

    def expand(self) -> Parts:
        """Return the body, with indices counted from 0.

        Raises:
            TooLarge: it would have too many masses or springs.
            ArithmeticError: its numbers do not define a body, such as a direction of (0, 0).
        """
        raise NotImplementedError


class Sprung(Recipe, frozen=True, kw_only=True):
    """Parameters of every body of masses and linear springs.

    Attributes:
        stiffness, damping: of every linear spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        mass, radius: of every mass, 1e-6..1e6 kg and 1e-3..1e4 px.
        driven: index of a held mass that the pointer drives, or None.
    """

    stiffness: Stiffness = 10_000.0
    damping: Damping = 20.0
    mass: Kilograms = 1.0
    radius: Radius = 6.0
    driven: Index | None = None


class Jointed(Sprung, frozen=True, kw_only=True):
    """Parameters of every body that also has angular springs.

    Attributes:
        angular_stiffness, angular_damping: of every angular spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        bend: -180..180 °, added to every rest angle; a body with a bend is not at rest where it starts.
    """

    angular_stiffness: Stiffness = 10_000.0
    angular_damping: Damping = 0.0
    bend: Bend = 0.0


class Assembly:
    """A body under construction: every part that is added gets the next index."""

    def __init__(self) -> None:
        self._masses: list[Mass] = []
        self._linear: list[LinearSpring] = []
        self._angular: list[AngularSpring] = []
        self._anchors: list[Anchor] = []
        self._fillings: list[Gas | Liquid] = []

    def mass(self, position: Vector, mass: float, radius: float) -> int:
        """Add a mass and return its index.

        Raises:
            TooLarge: there are `MAX_MASSES` already.
        """
        if len(self._masses) == MAX_MASSES:
            raise TooLarge(Text("they have more than {most} masses", most=MAX_MASSES))
        self._masses.append(Mass(position=position, mass=mass, radius=radius))
        return len(self._masses) - 1

    def spring(
        self, a: int, b: int, stiffness: float, damping: float, rest_length: float | None = None
    ) -> int:
        """Add a linear spring and return its index. Without a rest length, it is at rest at its length."""
        if rest_length is None:
            rest_length = self.distance(a, b)
        return self.add_spring(
            LinearSpring(a=a, b=b, stiffness=stiffness, damping=damping, rest_length=rest_length)
        )

    def add_spring(self, spring: LinearSpring) -> int:
        """Add an existing linear spring and return its index.

        Raises:
            TooLarge: there are `MAX_SPRINGS` already.
        """
        if len(self._linear) == MAX_SPRINGS:
            raise TooLarge(Text("they have more than {most} linear springs", most=MAX_SPRINGS))
        self._linear.append(spring)
        return len(self._linear) - 1

    def joint(self, a: int, b: int, rest_angle: float, body: Jointed, stiffness: float | None = None) -> None:
        """Add an angular spring between two linear ones; the body's bend is added to the rest angle."""
        self.add_joint(
            AngularSpring(
                a=a,
                b=b,
                stiffness=body.angular_stiffness if stiffness is None else stiffness,
                damping=body.angular_damping,
                rest_angle=wrapped(rest_angle + body.bend),
            )
        )

    def add_joint(self, joint: AngularSpring) -> None:
        """Add an existing angular spring.

        Raises:
            TooLarge: there are `MAX_SPRINGS` already.
        """
        if len(self._angular) == MAX_SPRINGS:
            raise TooLarge(Text("they have more than {most} angular springs", most=MAX_SPRINGS))
        self._angular.append(joint)

    def fill(self, filling: Gas | Liquid) -> None:
        """Add a filling."""
        self._fillings.append(filling)

    def hold(self, held: tuple[int, ...], driven: int | None, circle: Circle | None = None) -> None:
        """Hold some masses and the driven one, ignoring missing ones: a recipe may be given fewer masses.

        `circle` is the motion of mass 0.
        """
        every = {i for i in (*held, *([] if driven is None else [driven])) if i < len(self._masses)}
        self._anchors += [
            Anchor(mass=i, driven=i == driven, circle=None if i else circle) for i in sorted(every)
        ]

    def distance(self, a: int, b: int) -> float:
        """Return the distance between two masses, px."""
        return math.dist(self._masses[a].position, self._masses[b].position)

    def area(self, loop: tuple[int, ...]) -> float:
        """Return the area inside a loop of masses, px²."""
        return loop_area([self._masses[i].position for i in loop])

    def parts(self) -> Parts:
        """Return the body."""
        return Parts(
            tuple(self._masses),
            tuple(self._linear),
            tuple(self._angular),
            tuple(self._anchors),
            tuple(self._fillings),
        )


def wrapped(angle: float) -> float:
    """Return an angle between -360 and 360 °, wrapped into (-180, 180]."""
    return angle - 360.0 if angle > 180.0 else angle + 360.0 if angle <= -180.0 else angle
