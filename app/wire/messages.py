"""What messages between a page and the server are made of.

A message is a class: whoever defines it has it on the wire, typed in the page's script (`wire.d.ts`) and
listed in docs/wire.md. Nothing here knows which there are.
"""

from __future__ import annotations

from functools import cache, reduce
from operator import or_
from typing import Annotated, Any, ClassVar, Literal

import msgspec
import numpy as np
from msgspec import Meta, Struct
from numpy.typing import ArrayLike, NDArray

from .sections import Section, pack


def tag_of(name: str) -> str:
    """The tag of a message, from the name of its class: its first letter is a small one."""
    return name[:1].lower() + name[1:]


class FromPage(Struct, frozen=True, forbid_unknown_fields=True, tag_field="do", tag=tag_of):
    """Something that a page says."""


class OwnBody(FromPage, frozen=True):
    """Something about the page's own body, which a pupil in a class may say, too."""


class Ask(FromPage, frozen=True):
    """Something that takes a while: it is done in a thread, in the order in which it was asked for."""


class ToPage(Struct, frozen=True, kw_only=True, tag_field="tell", tag=tag_of):
    """Something that a page is told."""


class State(ToPage, frozen=True, kw_only=True):
    """How something is now: only the latest counts, and it is told only when it has changed."""


class Event(ToPage, frozen=True, kw_only=True):
    """Something that happened: all of them arrive, in order."""


class Numbers(ToPage, frozen=True, kw_only=True):
    """Numbers of single precision, which travel beside the JSON: only the latest count.

    Attributes:
        sections: what the numbers are.
    """

    numbers: np.ndarray
    sections: ClassVar[tuple[Section, ...]] = ()

    @classmethod
    def pack(cls, **values: ArrayLike) -> NDArray[np.float32]:
        """Numbers with these sections; see `sections.pack`."""
        return pack(cls.sections, values)


Index = Annotated[int, Meta(ge=0, le=999_999)]
Hand = Annotated[int, Meta(ge=0, le=9)]
# Bounds refuse infinity, too; JSON has no NaN.
Coordinate = Annotated[float, Meta(ge=-1e7, le=1e7)]
Degrees = Annotated[float, Meta(ge=-1e4, le=1e4)]
Parts = Annotated[tuple[Index, ...], Meta(max_length=100)]
Point = tuple[Coordinate, Coordinate]
StepNumber = Annotated[int, Meta(ge=0, le=99)]
Number = Annotated[float, Meta(ge=-1e15, le=1e15)]
LongText = Annotated[str, Meta(max_length=8000)]
"""Longer than any text of a lesson may be: its user is told by how much it is too long."""
QuantityName = Annotated[str, Meta(max_length=100)]
SceneName = Annotated[str, Meta(min_length=1, max_length=200)]
Key = Literal["up", "down", "left", "right"]
TextKind = Annotated[str, Meta(pattern="^[a-z]{1,20}$", extra={"typescript": "TextKind"})]
"""What a text is that is too long for one message; whoever gets it looks whether anybody reads it."""
PhaseName = Literal["lobby", "show", "ask", "results", "run", "explain", "try", "collect"]
AnswerKind = Literal["vote", "prediction", "line", "work"]
CommandName = Annotated[str, Meta(pattern="^[A-Za-z]{1,40}$", extra={"typescript": "CommandName"})]
"""Of the table of commands; whoever does one looks whether there is such a command."""


def messages(kind: type) -> list[type]:
    """The messages of a kind, in the order of their modules: the classes that have no subclasses."""
    return sorted(_leaves(kind), key=lambda leaf: leaf.__module__)


def _leaves(kind: type) -> list[type]:
    below = kind.__subclasses__()
    return [leaf for one in below for leaf in _leaves(one)] if below else [kind]


@cache
def _decoder() -> msgspec.json.Decoder[Any]:
    """Of all that a page can say; made at the first message, when all features have been loaded."""
    return msgspec.json.Decoder(reduce(or_, messages(FromPage)))


def read(text: str) -> FromPage | None:
    """What a page says; None if that makes no sense.

    Args:
        text: JSON.
    """
    try:
        return _decoder().decode(text)
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return None
