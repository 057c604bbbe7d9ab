"""Units of measured quantities, and their conversion to a scene's units."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..motion.dimensions import IN_ASCII, dimension_of
from ..text import Text

_METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "km": 1e3}
"""Metres in each unit of length of known size."""
_CYRILLIC = {
    "м": "m",
    "см": "cm",
    "мм": "mm",
    "км": "km",
    "Н": "N",
    "Дж": "J",
    "град": "°",
    "рад": "rad",
    "с": "s",
}
"""Units written in Cyrillic letters."""
_ANGLES = {"°": 1.0, "deg": 1.0, "degree": 1.0, "degrees": 1.0, "rad": 57.29577951308232}
_FORCES = {"N": 1.0, "mN": 1e-3, "kN": 1e3}
_ENERGIES = {"J": 1.0, "mJ": 1e-3, "N m": 1.0, "Nm": 1.0}

_SIGNS = str.maketrans({"²": "^2", "³": "^3", "·": " ", "*": " ", "º": "°", "−": "-"})


@dataclass(frozen=True)
class Unit:
    """A unit of a measured quantity.

    Attributes:
        dimension: written as a unit with "{unit}" for the length, as in "{unit}/s".
        factor: its size in the same unit with metres, degrees and seconds, or with the `length` below.
        length: the unit of length in it; "m" for all of known size in metres, empty if it has none.
        power: the power of the length.
    """

    dimension: str
    factor: float
    length: str
    power: float


def _all_units() -> dict[str, Unit]:
    found: dict[str, Unit] = {}
    for text, degrees in _ANGLES.items():
        found[text] = Unit("°", degrees, "", 0)
        found[f"{text}/s"] = Unit("°/s", degrees, "", 0)
    for text, metres in _METRES.items():
        found[text] = Unit("{unit}", metres, "m", 1)
        found[f"{text}/s"] = Unit("{unit}/s", metres, "m", 1)
        found[f"{text}/s^2"] = Unit("{unit}/s²", metres, "m", 1)
        found[f"kg {text}/s^2"] = Unit("kg {unit}/s²", metres, "m", 1)
        found[f"kg {text}^2/s^2"] = Unit("kg {unit}²/s²", metres**2, "m", 2)
    for text, newtons in _FORCES.items():
        found[text] = Unit("kg {unit}/s²", newtons, "m", 1)
    for text, joules in _ENERGIES.items():
        found[text] = Unit("kg {unit}²/s²", joules, "m", 2)
    return found


_UNITS = _all_units()


def is_unit(text: str) -> bool:
    """Return whether a text is a unit that is known by itself."""
    return _normal(text) in _UNITS or text in ("px", "px/s", "kg")


def unit_of(text: str, dimension: str, scene_length: str) -> Unit:
    """Return the unit that a text names.

    Args:
        text: from a header; empty for the scene's own unit.
        dimension: of the expected quantity, see `sim.motion.quantities.Kind.unit`.
        scene_length: the scene's unit of length, which may be any word.

    Raises:
        InputError: it is not a unit of that quantity.
    """
    own = Unit(dimension, 1.0, scene_length if "{unit}" in dimension else "", _power(dimension))
    if not text:
        return own
    normal = _normal(text)
    found = _UNITS.get(normal)
    if found is None:
        length = next(
            (each for each in dict.fromkeys((scene_length, "px")) if _has(normal, dimension, each)), ""
        )
        if length:
            return Unit(dimension, 1.0, length, own.power)
    if found is None or found.dimension != dimension:
        expected = dimension.format(unit="m") or Text("a pure number")
        raise InputError(Text("{unit!r} is not a unit of it, as {expected} is", unit=text, expected=expected))
    return found


def known_scale(unit: Unit, scene_length: str) -> float | None:
    """Return the number of a scene's length units in a unit's `length`; None if unknown."""
    if unit.power == 0 or unit.length == scene_length:
        return 1.0
    if unit.length == "m" and scene_length in _METRES:
        return 1.0 / _METRES[scene_length]
    return None


def _power(dimension: str) -> float:
    return dimension_of(dimension).length / 2


def _has(text: str, dimension: str, length: str) -> bool:
    return text.translate(IN_ASCII) == _normal(dimension.format(unit=length)).translate(IN_ASCII)


def _normal(text: str) -> str:
    text = re.sub(r"\s+", " ", text.translate(_SIGNS)).strip()
    text = re.sub(r"[а-яА-Я]+", lambda word: _CYRILLIC.get(word[0], word[0]), text)
    return re.sub(r"\s*/\s*", "/", text).replace("s2", "s^2").replace("s-1", "/s")


def within_half_a_turn(degrees: NDArray[np.float64]) -> NDArray[np.float64]:
    """Wrap angles to -180..180°."""
    return (degrees + 180.0) % 360.0 - 180.0
