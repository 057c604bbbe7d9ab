"""The numbers of single masses, springs and joints."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Literal

import msgspec

from ..errors import SettingError
from ..scene.parts import AngularSpring, LinearSpring, Mass
from ..scene.types import Scene
from ..scene.validate import number_range
from .edit import Edit, changed, counted, of_parts

Kind = Literal["masses", "linear_springs", "angular_springs"]
"""The field of a scene that has the parts."""

_TYPES: dict[Kind, type] = {
    "masses": Mass,
    "linear_springs": LinearSpring,
    "angular_springs": AngularSpring,
}
_WORDS: dict[Kind, str] = {"masses": "mass", "linear_springs": "spring", "angular_springs": "joint"}


@dataclass(frozen=True)
class Number:
    """A number that each part of a kind has.

    Attributes:
        kind, field: where it is.
        label, unit: for people.
        low, high: its range.
        optional: whether a part may be without it.
    """

    kind: Kind
    field: str
    label: str
    unit: str
    low: float
    high: float
    optional: bool = False


def _number(kind: Kind, field: str, label: str, optional: bool = False) -> Number:
    low, high, unit = number_range(_TYPES[kind], field)
    return Number(kind, field, label, unit, low, high, optional)


NUMBERS = (
    _number("masses", "mass", "Mass"),
    _number("masses", "radius", "Radius"),
    _number("linear_springs", "stiffness", "Stiffness"),
    _number("linear_springs", "damping", "Damping"),
    _number("linear_springs", "rest_length", "Rest length"),
    _number("linear_springs", "strength", "Strength", optional=True),
    _number("linear_springs", "yield_force", "Yield force", optional=True),
    _number("linear_springs", "hardening", "Hardening"),
    _number("angular_springs", "stiffness", "Joint stiffness"),
    _number("angular_springs", "damping", "Joint damping"),
    _number("angular_springs", "rest_angle", "Rest angle"),
    _number("angular_springs", "yield_torque", "Yield torque", optional=True),
)
"""Every number that can be set for single parts."""


def number(kind: str, field: str) -> Number:
    """One of `NUMBERS`.

    Raises:
        SettingError: there is none of that name.
    """
    for each in NUMBERS:
        if (each.kind, each.field) == (kind, field):
            return each
    known = ", ".join(f"{each.kind}.{each.field}" for each in NUMBERS)
    raise SettingError(f"{kind}.{field}: there is no such number; there are {known}")


def values_of(scene: Scene, of: Number, parts: Collection[int]) -> set[float | None]:
    """The different values that some parts have."""
    every = getattr(scene, of.kind)
    return {getattr(every[i], of.field) for i in parts}


def set_number(scene: Scene, of: Number, parts: Collection[int], value: float | None) -> Edit:
    """A number of some parts, all to the same value; None takes it away where it may be missing.

    Raises:
        SettingError: the value is out of range, a part does not exist, or the number does not go with the
            others of a part.
    """
    _refuse_value(of, value)
    return _with_values(scene, of, dict.fromkeys(parts, value), f"{of.label} set")


def scale_number(scene: Scene, of: Number, parts: Collection[int], largest: float) -> Edit:
    """A number of some parts so that the largest gets a value and the others keep their proportions to it.

    Raises:
        SettingError: as `set_number`.
    """
    _refuse_value(of, largest)
    every = getattr(scene, of.kind)
    values = {i: value for i in parts if (value := getattr(every[i], of.field)) is not None}
    old = max(map(abs, values.values()), default=0.0)
    scaled = {i: largest * (value / old) if old else largest for i, value in values.items()}
    return _with_values(scene, of, scaled, f"{of.label} scaled")


def _refuse_value(of: Number, value: float | None) -> None:
    if value is None:
        if not of.optional:
            raise SettingError(f"{of.label}: it cannot be left out")
    elif not of.low <= value <= of.high:
        raise SettingError(
            f"{of.label}: {value:g} is not in the range {of.low:g}..{of.high:g} {of.unit}".rstrip()
        )


def _with_values(scene: Scene, of: Number, values: dict[int, float | None], label: str) -> Edit:
    scene = of_parts(scene)
    every = getattr(scene, of.kind)
    for i in values:
        if not 0 <= i < len(every):
            raise SettingError(f"{_WORDS[of.kind]} {i} does not exist (0..{len(every) - 1})")
    new = [(i, msgspec.structs.replace(every[i], **{of.field: value})) for i, value in values.items()]
    for _, part in new:
        _refuse_contradiction(part)
    parts = changed(every, new)
    what = counted(len(values), _WORDS[of.kind])
    return Edit(f"{label}: {what}", msgspec.structs.replace(scene, **{of.kind: parts}))


def _refuse_contradiction(part: Mass | LinearSpring | AngularSpring) -> None:
    """As `sim.scene.validate` refuses it in a file."""
    match part:
        case LinearSpring(yield_force=None, hardening=hardening) if hardening:
            raise SettingError("Hardening: it has no effect on a spring without a yield force")
        case LinearSpring(yield_force=float(), stiffness=0.0):
            raise SettingError("Stiffness: a spring that yields needs one")
        case LinearSpring(yield_force=float(limit), strength=float(strength)) if strength < limit:
            raise SettingError(f"Strength: {strength:g} is below the yield force {limit:g}")
        case AngularSpring(yield_torque=float(), stiffness=0.0):
            raise SettingError("Joint stiffness: a joint that yields needs one")
        case _:
            pass
