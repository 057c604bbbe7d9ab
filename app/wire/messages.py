"""Base classes and field types of messages between a page and the server.

A message is a class: defining it is enough to send it, typed in the page's script (`wire.d.ts`) and listed in
docs/wire.md.
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
    """The tag of a message: the name of its class with a lower-case first letter."""
    return name[:1].lower() + name[1:]


class FromPage(Struct, frozen=True, forbid_unknown_fields=True, tag_field="do", tag=tag_of):
    """A message from a page."""


class OwnBody(FromPage, frozen=True):
    """A message about the page's own body, which a pupil in a class may send, too."""


class Ask(FromPage, frozen=True):
    """A request that takes a while: it is handled in a thread, in the order of arrival."""


class ToPage(Struct, frozen=True, kw_only=True, tag_field="tell", tag=tag_of):
    """A message to a page."""


class State(ToPage, frozen=True, kw_only=True):
    """The present state of something: only the latest counts, and it is sent only when it has changed."""


class Event(ToPage, frozen=True, kw_only=True):
    """Something that happened: all events arrive, in order."""


class Numbers(ToPage, frozen=True, kw_only=True):
    """Numbers of single precision, outside the JSON: only the latest count.

    Attributes:
        sections: the sections of the array.
    """

    numbers: np.ndarray
    sections: ClassVar[tuple[Section, ...]] = ()

    @classmethod
    def pack(cls, **values: ArrayLike) -> NDArray[np.float32]:
        """Make an array with these sections; see `sections.pack`."""
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
"""Longer than any text of a lesson may be, so that a notice can say by how much it is too long."""
QuantityName = Annotated[str, Meta(max_length=200)]
SceneName = Annotated[str, Meta(min_length=1, max_length=200)]
Key = Literal["up", "down", "left", "right"]
TextKind = Annotated[str, Meta(pattern="^[a-z]{1,20}$", extra={"typescript": "TextKind"})]
"""Kind of a text that is too long for one message; the receiver checks whether a feature handles it."""
PhaseName = Literal["lobby", "show", "ask", "results", "run", "reveal", "explain", "try", "collect"]
AnswerKind = Literal["vote", "prediction", "line", "work"]
CommandName = Annotated[str, Meta(pattern="^[A-Za-z]{1,40}$", extra={"typescript": "CommandName"})]
"""Name in the table of commands; the receiver checks whether there is such a command."""


def messages(kind: type) -> list[type]:
    """The messages derived from a class, in the order of their modules: classes without subclasses."""
    return sorted(_leaves(kind), key=lambda leaf: leaf.__module__)


def _leaves(kind: type) -> list[type]:
    below = kind.__subclasses__()
    return [leaf for one in below for leaf in _leaves(one)] if below else [kind]


@cache
def _decoder() -> msgspec.json.Decoder[Any]:
    """The decoder of all messages from pages; made at the first message, after all features were imported."""
    return msgspec.json.Decoder(reduce(or_, messages(FromPage)))


def read(text: str) -> FromPage | None:
    """Decode a message from a page; None if it is invalid.

    Args:
        text: JSON from the page.
    """
    try:
        return _decoder().decode(text)
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return None
