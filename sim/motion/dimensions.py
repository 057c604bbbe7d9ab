"""Dimensions of what is measured: powers of kg, length, ° and s, read from units and written as such."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import NamedTuple

from ..errors import InputError
from ..text import Text

HIGHEST = 9
"""Highest power in a unit, so that a power is one digit."""

_RAISED = dict(zip("²³⁴⁵⁶⁷⁸⁹", "23456789", strict=True))

IN_ASCII = str.maketrans({"°": "deg", **{sign: f"^{digit}" for sign, digit in _RAISED.items()}})
"""Signs of units for a table: not every program that opens one asks how it is encoded."""

_WORD = re.compile(r"([^\W\d_²³⁴⁵⁶⁷⁸⁹]+|°|\{unit\})(?:\^(-?\d(?:\.5)?)|([²³⁴⁵⁶⁷⁸⁹]))?")


class Dimension(NamedTuple):
    """Powers of units. They are doubled, so that those of square roots are whole numbers, too.

    Attributes:
        kg, length, angle, time: twice the powers of kg, of the scene's unit of length, of ° and of s.
    """

    kg: int = 0
    length: int = 0
    angle: int = 0
    time: int = 0

    def times(self, other: Dimension, power: float = 1.0) -> Dimension:
        """The dimension of a product with a power of another.

        Raises:
            InputError: a power is no multiple of 1/2, or beyond `HIGHEST`; the text's `of` says what has it.
        """
        found = [one + power * of for one, of in zip(self, other, strict=True)]
        if any(abs(each) > 2 * HIGHEST for each in found):
            raise InputError(Text("{of} has a unit with a power beyond {most}", of="it", most=HIGHEST))
        if any(each != int(each) for each in found):
            raise InputError(Text("{of} has a unit with a power that is no multiple of 1/2", of="it"))
        return Dimension(*map(int, found))

    @property
    def unit(self) -> str:
        """The unit, as in "kg {unit}²/s²"; empty for a pure number."""
        powers = list(zip(("kg", "{unit}", "°", "s"), self, strict=True))
        above = [_raised(name, power) for name, power in powers if power > 0]
        below = [_raised(name, -power) for name, power in powers if power < 0]
        if not below:
            return " ".join(above)
        under = below[0] if len(below) == 1 else f"({' '.join(below)})"
        return f"{' '.join(above) or '1'}/{under}"


PURE = Dimension()
"""That of a pure number."""

DEGREES = Dimension(angle=2)

_BASE = {
    "kg": (1.0, Dimension(kg=2)),
    "s": (1.0, Dimension(time=2)),
    "°": (1.0, DEGREES),
    "deg": (1.0, DEGREES),
    "rad": (math.degrees(1.0), DEGREES),
}

_OF_METRES = {"N": Dimension(2, 2, 0, -4), "J": Dimension(2, 4, 0, -4)}


def dimension_of(unit: str) -> Dimension:
    """The dimension of a unit that softrod writes, with "{unit}" for the length; `PURE` if it is empty."""
    return _read(unit, {**_BASE, "{unit}": (1.0, Dimension(length=2))})[1] if unit else PURE


def read_unit(text: str, length: str) -> tuple[float, Dimension]:
    """How many of softrod's own units a unit is, and its dimension.

    Args:
        text: such as "px/s^2", "kg px²/s²", "rad" or "1/(kg s)".
        length: the scene's unit of length; if that is "m", N and J are units, too.

    Raises:
        InputError: it is no such unit.
    """
    named = {name: (1.0, of) for name, of in _OF_METRES.items()} if length == "m" else {}
    try:
        return _read(text, {length: (1.0, Dimension(length=2)), **_BASE, **named})
    except InputError:
        known = ", ".join(("kg", length, "s", "°", "deg", "rad", *named))
        raise InputError(
            Text(
                "{unit!r} is not a unit made of {known}, as {length}/s^2 is",
                unit=text,
                known=known,
                length=length,
            )
        ) from None


def _read(text: str, units: Mapping[str, tuple[float, Dimension]]) -> tuple[float, Dimension]:
    above, slash, below = (part.strip() for part in text.partition("/"))
    if below.startswith("(") and below.endswith(")"):
        below = below[1:-1]
    elif len(below.split()) > 1:
        raise InputError(Text("it is open what is below the stroke"))
    factor, found = 1.0, PURE
    for words, sign in ((above if not slash or above != "1" else "", 1.0), (below, -1.0)):
        for word in words.split():
            match = _WORD.fullmatch(word)
            if match is None or match[1] not in units:
                raise InputError(Text("{word!r} is not a unit", word=word))
            size, dimension = units[match[1]]
            power = sign * float(match[2] or _RAISED.get(match[3], "1"))
            factor *= size**power
            found = found.times(dimension, power)
    if not above or (slash and not below.strip()):
        raise InputError(Text("a unit is missing"))
    return factor, found


def _raised(name: str, twice: int) -> str:
    """A unit to a power, which is given twice as large."""
    if twice % 2:
        return f"{name}^{twice / 2:g}"
    return name if twice == 2 else name + next(s for s, digit in _RAISED.items() if digit == str(twice // 2))
