"""Errors for what a user can get wrong. Each message is one clear sentence."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

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


def short(value: float) -> Text:
    """Return a number with six digits at most."""
    return Text("{value:g}", value=value)


def no_mass(where: str, mass: int, count: int) -> Text:
    """Return the sentence for the number of a mass that does not exist."""
    return Text("{where}: mass {mass} does not exist ({span})", where=where, mass=mass, span=span(count))


def no_spring(where: str, spring: int, count: int) -> Text:
    """Return the sentence for the number of a spring that does not exist."""
    return Text(
        "{where}: spring {spring} does not exist ({span})", where=where, spring=spring, span=span(count)
    )


def no_wall(where: str, wall: int, count: int) -> Text:
    """Return the sentence for the number of a wall that does not exist."""
    return Text("{where}: wall {wall} does not exist ({span})", where=where, wall=wall, span=span(count))


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a question in brackets, after a space, with the known name that is most like an unknown one;
    nothing if none is."""
    alike = difflib.get_close_matches(name, known, 1) if len(name) <= _LONGEST else []
    return Text(" (did you mean {name!r}?)", name=alike[0]) if alike else ""
