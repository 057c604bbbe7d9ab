"""All recipes, and the expansion of a scene's recipes into a body."""

from __future__ import annotations

import msgspec

from ...text import Text
from ..numbers import MAX_MASSES, MAX_SPRINGS
from ..parts import LinearSpring
from .assembly import Parts, TooLarge
from .creatures import Hand, Heart, Swimmer, Walker, Worm
from .outlines import AirBalloon, Box, Polygon, WaterBalloon
from .plants import HairTuft, Tree
from .rods import Rod, Rope
from .sheets import Cloth, FlagPole, Jelly
from .trusses import Bridge, Girder

AnyRecipe = (
    Rope | Rod | Box | Polygon | HairTuft | FlagPole | Tree | AirBalloon | WaterBalloon | Cloth | Girder
    | Jelly | Bridge | Worm | Swimmer | Walker | Heart | Hand
)  # fmt: skip
"""The recipes that a scene's `bodies` may have."""


def expand(bodies: tuple[AnyRecipe, ...], links: tuple[LinearSpring, ...]) -> Parts:
    """Return the parts of all bodies, one after the other, and the links after their springs.

    Raises:
        TooLarge: the bodies have too many masses or springs.
        ArithmeticError: a body's numbers do not define one, such as a direction of (0, 0).
    """
    global _last
    last = _last  # read only once, since another thread may expand others meanwhile
    if last is None or last[0] is not bodies or last[1] is not links:
        last = _last = bodies, links, _expanded(bodies, links)
    return last[2]


_last: tuple[tuple[AnyRecipe, ...], tuple[LinearSpring, ...], Parts] | None = None
"""The last expansion, since a scene is first made and then validated."""


def _expanded(bodies: tuple[AnyRecipe, ...], links: tuple[LinearSpring, ...]) -> Parts:
    replace = msgspec.structs.replace
    masses, linear, angular, anchors, fillings = [], [], [], [], []
    for recipe in bodies:
        parts = recipe.expand()
        m, s = len(masses), len(linear)
        masses += parts.masses
        linear += [replace(spring, a=spring.a + m, b=spring.b + m) for spring in parts.linear_springs]
        angular += [replace(joint, a=joint.a + s, b=joint.b + s) for joint in parts.angular_springs]
        anchors += [replace(anchor, mass=anchor.mass + m) for anchor in parts.anchors]
        fillings += [replace(f, masses=tuple(i + m for i in f.masses)) for f in parts.fillings]
        # Stop before a short file with many bodies uses up all memory.
        if len(masses) > MAX_MASSES:
            raise TooLarge(Text("they have more than {most} masses", most=MAX_MASSES))
        if max(len(linear), len(angular)) > MAX_SPRINGS:
            raise TooLarge(Text("they have more than {most} springs of a kind", most=MAX_SPRINGS))
    return Parts(tuple(masses), (*linear, *links), tuple(angular), tuple(anchors), tuple(fillings))
