"""Settings of the recipes in a scene, derived from the annotations of their fields; changes of all recipes.

A number of a recipe can be set if its annotation has a slider range. Its key is its field; in a scene with
several bodies, its path, as in `bodies[1].length`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, get_type_hints

import msgspec

from ..scene.numbers import annotation_of
from ..scene.recipes.assembly import Jointed, wrapped
from ..scene.recipes.recipe import AnyRecipe
from ..scene.types import Rope, Scene, rebuilt


@dataclass(frozen=True)
class Setting:
    """One number of a scene that can be set by name.

    Attributes:
        key, label, unit: its name in commands, its name for people, and its unit ("px" stands for the
            scene's own length unit).
        low, high: the allowed range.
        slider: the range of its slider.
        read: returns the number in a scene.
        write: returns the scene with another number, not yet validated.
        applies: whether the setting has any effect on a scene.
        logarithmic: whether its slider is logarithmic.
        integer: whether it takes whole numbers only.
        differs: whether the parts that it sets have different numbers. It then reads the largest and scales
            the others in proportion; for rest angles it reads the first and turns the others by the same
            amount.
        remark: what users should know when they set it in a scene; empty if nothing.
        term: the technical term, where the label is a plainer one.
        recipe: the name of the recipe that it is a field of; empty if it is of the scene.
    """

    key: str
    label: str
    unit: str
    low: float
    high: float
    slider: tuple[float, float]
    read: Callable[[Scene], float]
    write: Callable[[Scene, float], Scene]
    applies: Callable[[Scene], bool]
    logarithmic: bool = False
    integer: bool = False
    differs: Callable[[Scene], bool] = lambda _: False
    remark: Callable[[Scene], str] = lambda _: ""
    term: str = ""
    recipe: str = ""


def recipe_settings(scene: Scene) -> list[Setting]:
    """Return the settings of a scene's recipes that have an effect, in the order of bodies and fields."""
    alone = len(scene.bodies) == 1
    every = [s for i, body in enumerate(scene.bodies) for s in settings_of_recipe(type(body), i, alone)]
    return [setting for setting in every if setting.applies(scene)]


@cache  # so that a panel can recognise unchanged settings
def settings_of_recipe(kind: type[AnyRecipe], body: int = 0, alone: bool = True) -> list[Setting]:
    """Return all settings of a recipe, by its number in the scene and whether it is the only one there."""
    hints = get_type_hints(kind, include_extras=True)
    before = "" if alone else f"{kind.__name__} {body + 1}: "
    found = [(field, annotation_of(hints[field])) for field in kind.__struct_fields__]
    return [
        _setting(kind.__name__, field, number[1], body, before, number[0] is int)
        for field, number in found
        if number is not None and (number[1].extra or {}).get("slider")
    ]


def _setting(recipe: str, field: str, meta: msgspec.Meta, body: int, before: str, integer: bool) -> Setting:
    extra = meta.extra or {}

    def write(scene: Scene, value: float) -> Scene:
        changed = msgspec.structs.replace(scene.bodies[body], **{field: value})
        return rebuilt(scene, bodies=(*scene.bodies[:body], changed, *scene.bodies[body + 1 :]))

    return Setting(
        key=f"bodies[{body}].{field}" if before else field,
        label=f"{before}{extra['label']}",
        unit=extra["unit"],
        low=float(meta.ge or 0),
        high=float(meta.le or 0),
        slider=extra["slider"],
        read=lambda scene: float(getattr(scene.bodies[body], field)),
        write=write,
        # Links refer to masses by index, so with links the number of masses cannot change.
        applies=lambda scene: (
            len(scene.anchors) < len(scene.masses)
            and getattr(scene.bodies[body], field) is not None
            and not (integer and scene.links)
        ),
        logarithmic=extra["logarithmic"],
        integer=integer,
        recipe=recipe,
    )


# ------------------------------------------------------------------------- changes of all recipes
def scaled(scene: Scene, springs: str, field: str, value: float, old: float) -> Scene:
    """Return the scene with the stiffnesses or dampings of all recipes and links multiplied by value / old.

    Args:
        springs: "linear_springs" or "angular_springs".
        field: "stiffness" or "damping".
        value: the new largest value.
        old: the present one; if it is 0, all springs except those of special fields get the value.
    """
    angular = springs == "angular_springs"

    def change(part: Any, names: list[str]) -> Any:
        # Written so that the largest is exactly the value.
        numbers = {n: value * (getattr(part, n) / old) if old else value for n in names}
        return msgspec.structs.replace(part, **numbers)

    bodies = []
    for body in scene.bodies:
        names = [n for n in body.__struct_fields__ if n.endswith(field) and ("angular" in n) == angular]
        if not old:
            names = [n for n in names if n in (field, f"angular_{field}")]
        bodies.append(change(body, names))
    links = scene.links if angular else tuple(change(link, [field]) for link in scene.links)
    return rebuilt(scene, bodies=tuple(bodies), links=links)


def turned(scene: Scene, degrees: float, stiffness: list[float]) -> Scene:
    """Return the scene with the rest angles of all recipes shifted by |degrees| <= 360, without a template.

    Args:
        stiffness: of every angular spring, including that of the template, which ropes keep.
    """
    bodies, joint = [], 0
    for body in scene.bodies:
        changes: dict[str, float] = {}
        if isinstance(body, Rope):
            changes["rest_angle"] = wrapped(body.rest_angle + degrees)
            if body.joints and body.masses > 2:
                changes["angular_stiffness"] = stiffness[joint]
        elif isinstance(body, Jointed):
            changes["bend"] = wrapped(body.bend + degrees)
        bodies.append(msgspec.structs.replace(body, **changes))
        joint += len(body.expand().angular_springs)
    return msgspec.structs.replace(rebuilt(scene, bodies=tuple(bodies)), template=None)
