"""Functions such as `rope(...)` and `box(...)`, which make a scene with one body from a few numbers."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from ..errors import SceneError
from ..text import Text
from .parts import Beat
from .recipes.creatures import Hand, Heart, Swimmer, Walker, Worm
from .recipes.outlines import AirBalloon, Box, Polygon, WaterBalloon
from .recipes.plants import HairTuft, Tree
from .recipes.recipe import AnyRecipe
from .recipes.rods import Rod, Rope
from .recipes.sheets import Cloth, FlagPole, Jelly
from .recipes.trusses import Bridge, Girder
from .surroundings import Contact, Medium, Wall, Wind
from .types import BODY_FIELDS, ArrowKeys, Scene
from .validate import validate

_OF_SCENES = tuple(
    field
    for field in Scene.__struct_fields__
    if field not in (*BODY_FIELDS, "format", "bodies", "links", "template", "lesson")
)
"""The fields of a scene that its maker accepts."""

_FLOOR = (Wall(point=(300.0, 500.0), normal=(0.0, -1.0)),)
_FALLING: dict[str, Any] = {"gravity": (0.0, 1000.0), "air_friction": 0.0, "walls": _FLOOR}


def _maker(recipe: type[AnyRecipe], ordered: int = 0, **usual: Any) -> Callable[..., Scene]:
    """Return the function that makes scenes with a recipe.

    Args:
        ordered: how many of the recipe's first numbers may be positional arguments.
        usual: defaults of its scenes and their recipe.
    """
    name = str(recipe.__struct_config__.tag)
    first = recipe.__struct_fields__[:ordered]

    def make(*in_order: Any, **numbers: Any) -> Scene:
        numbers = {"name": name, **usual, **dict(zip(first, in_order, strict=False)), **numbers}
        if len(in_order) > ordered:
            fields = recipe.__struct_fields__
            example = "masses" if not ordered and "masses" in fields else fields[ordered]
            raise SceneError(
                Text(
                    "{name}: numbers have names, but the first {count} need none, as in "
                    "sim.{name}({example}={last!r})",
                    name=name,
                    count=ordered,
                    example=example,
                    last=in_order[-1],
                )
                if ordered
                else Text(
                    "{name}: numbers have names, as in sim.{name}({example}={last!r})",
                    name=name,
                    example=example,
                    last=in_order[-1],
                )
            )
        of_recipe = {field: numbers[field] for field in recipe.__struct_fields__ if field in numbers}
        others = {field: value for field, value in numbers.items() if field not in of_recipe}
        unknown = next((field for field in others if field not in _OF_SCENES), None)
        if unknown is not None:
            known = ", ".join((*recipe.__struct_fields__, *_OF_SCENES))
            raise SceneError(
                Text(
                    "{unknown}: {name} has no such number; there are {known}",
                    unknown=unknown,
                    name=name,
                    known=known,
                )
            )
        return validate(Scene(**others, bodies=(recipe(**of_recipe),)))

    make.__name__ = make.__qualname__ = name
    make.__doc__ = f"""A scene with one `sim.{recipe.__name__}`.

    Args:
        numbers: those of `sim.{recipe.__name__}`, which gives their units, ranges and defaults, and those of
            `sim.Scene` but its body.

    Raises:
        SceneError: a number is unknown or out of range; the sentence names it.
    """
    # What help() and editors show. The long annotations are those of the types.
    defaults = {field: p.default for field, p in inspect.signature(recipe).parameters.items()}
    of_scene = inspect.signature(Scene).parameters
    defaults |= {field: of_scene[field].default for field in _OF_SCENES} | {"name": name} | usual
    make.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
        [
            inspect.Parameter(
                field,
                inspect.Parameter.POSITIONAL_OR_KEYWORD if field in first else inspect.Parameter.KEYWORD_ONLY,
                default=d,
            )
            for field, d in defaults.items()
        ],
        return_annotation=Scene,
    )
    return make


_KEYS = ArrowKeys()

rope = _maker(
    Rope,
    ordered=2,
    start=(300.0, 150.0),
    direction=(0.0, 1.0),
    driven=0,
    gravity=(0.0, 2000.0),
    air_friction=0.002,
    air_law="tutorial",
    arrow_keys=_KEYS,
)
"""Its defaults are the tutorial's constants."""

rod = _maker(Rod, gravity=(0.0, 1000.0), air_friction=0.002, arrow_keys=_KEYS)
box = _maker(Box, gravity=(0.0, 1000.0), air_friction=0.002, arrow_keys=_KEYS)
polygon = _maker(Polygon, gravity=(0.0, 1000.0), air_friction=0.002, arrow_keys=_KEYS)
hair_tuft = _maker(HairTuft, gravity=(0.0, 400.0), air_friction=0.0005, arrow_keys=_KEYS)
flag_pole = _maker(
    FlagPole,
    gravity=(0.0, 600.0),
    air_friction=0.0005,
    wind=Wind(velocity=(500.0, 0.0), turbulence=0.4, length_scale=200.0),
)
tree = _maker(
    Tree, gravity=(0.0, 400.0), air_friction=0.0005, wind=Wind(velocity=(350.0, 0.0), turbulence=0.5)
)
air_balloon = _maker(AirBalloon, **_FALLING)
water_balloon = _maker(WaterBalloon, **_FALLING)
cloth = _maker(Cloth, gravity=(0.0, 1000.0), air_friction=0.0005)
girder = _maker(Girder, gravity=(0.0, 1000.0))
jelly = _maker(Jelly, **_FALLING)
bridge = _maker(Bridge, gravity=(0.0, 1000.0))
_ROUGH = (Wall(point=(300.0, 500.0), normal=(0.0, -1.0), friction=0.9, bounciness=0.1),)
_CREEPING: dict[str, Any] = {"gravity": (0.0, 1000.0), "walls": _ROUGH, "arrow_keys": _KEYS}
worm = _maker(Worm, beat=Beat(frequency=1.0), **_CREEPING)
walker = _maker(Walker, beat=Beat(frequency=1.4), **_CREEPING)
hand = _maker(Hand, beat=Beat(frequency=0.25), contact=Contact(distance=12.0), **_CREEPING)
swimmer = _maker(Swimmer, beat=Beat(frequency=2.0), medium=Medium(across=0.5, along=0.25), arrow_keys=_KEYS)
heart = _maker(Heart, beat=Beat(frequency=1.2), air_friction=0.002, arrow_keys=_KEYS)


def fine_rope(masses: int, **changes: Any) -> Scene:
    """Return the tutorial's rope of twelve masses, divided more finely; horizontal, held at its left end.

    Length, weight, drag and stiffness of the rope as a whole are unchanged. `changes` are arguments of
    `rope`.
    """
    finer = (masses - 1) / 11.0
    numbers = {
        "start": (100.0, 100.0),
        "direction": (1.0, 0.0),
        "driven": None,
        "mass": 12.0 / masses,
        "stiffness": 1e4 * finer,
        "damping": 40.0 * finer,
        "angular_stiffness": 1e4 * finer**3,
        "air_friction": 0.002 * 12.0 / masses,
    }
    return rope(masses, **(numbers | changes))
