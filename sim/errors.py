"""Errors for what a user can get wrong. Each message is one clear sentence."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Literal

from .text import Text

_LONGEST = 60
"""Letters of a name that is compared with others, at most."""


class SceneError(ValueError):
    """A scene or a scene file is not valid. The message names the field and what is allowed."""


class SettingError(ValueError):
    """A setting (a slider's name and value) is not valid for the scene."""


class InputError(ValueError):
    """A call or an input log asks for something that the simulation cannot do."""


def span(count: int) -> str:
    """Return the range of the numbers of some parts, or that there are none."""
    return f"0..{count - 1}" if count else Text("there are none")


def out_of_range(where: str, value: object, low: object, high: object, unit: str = "") -> Text:
    """Return the sentence for a number outside its range.

    Args:
        where: the field.
        value: the number.
        low, high: the ends of the range; "" for one that it does not have.
        unit: of the number, if it has one.
    """
    if not unit:
        return Text(
            "{where}: {value} is not in the range {low}..{high}", where=where, value=value, low=low, high=high
        )
    return Text(
        "{where}: {value} is not in the range {low}..{high} {unit}",
        where=where,
        value=value,
        low=low,
        high=high,
        unit=unit,
    )


Part = Literal["mass", "spring", "joint", "wall"]
"""A kind of part."""


def no_part(what: Part, index: int, count: int) -> Text:
    """Return the sentence for the number of a part that does not exist, of which there are some others."""
    there = span(count)
    match what:
        case "mass":
            return Text("mass {index} does not exist ({span})", index=index, span=there)
        case "spring":
            return Text("spring {index} does not exist ({span})", index=index, span=there)
        case "joint":
            return Text("joint {index} does not exist ({span})", index=index, span=there)
        case "wall":
            return Text("wall {index} does not exist ({span})", index=index, span=there)


def no_part_of_scene(what: Part, index: int, count: int) -> Text:
    """Return the same sentence, with other words for a scene that has no such part."""
    match what:
        case "spring" if not count:
            return Text("spring {index} does not exist (the scene has no springs)", index=index)
        case "joint" if not count:
            return Text("joint {index} does not exist (the scene has no joints)", index=index)
        case _:
            return no_part(what, index, count)


def of_field(where: str, sentence: str) -> Text:
    """Return a sentence with the field that it is about before it."""
    return Text("{where}: {error}", where=where, error=sentence)


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a question in brackets, after a space, with the known name that is most like an unknown one;
    nothing if none is."""
    alike = difflib.get_close_matches(name, known, 1) if len(name) <= _LONGEST else []
    return Text(" (did you mean {name!r}?)", name=alike[0]) if alike else ""
