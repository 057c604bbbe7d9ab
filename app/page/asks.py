"""What the page's script asks the server for, beside commands to the session."""

from __future__ import annotations

import re
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct

_ASK = re.compile(r"\d{1,15}\|ask\|(\{.{2,16000}\})", re.DOTALL)

_SceneName = Annotated[str, Meta(min_length=1, max_length=200)]


class Ask(Struct, frozen=True, forbid_unknown_fields=True, tag_field="do", tag=str.lower):
    """What the script asks for; the tag is the name of the class."""


class Share(Ask, frozen=True):
    """A link to the scene, with the present pose or without.

    Attributes:
        page: the page's own address, without what stands after its folder.
        short: as an address that the server keeps, instead of a link that holds the scene.
        controls: which there are for whoever opens it: as they are anyway, the bar of time alone, or that and
            the sliders that make most of the scene.
    """

    pose: bool
    page: Annotated[
        str, Meta(pattern=r"^https?://[A-Za-z0-9._\[\]:-]{1,250}/([A-Za-z0-9._~-]{1,80}/){0,20}$")
    ]
    short: bool = False
    controls: Literal["all", "play", "sliders"] = "all"


class Offer(Ask, frozen=True):
    """Have the page open one of its dialogs, if it has the control for it."""

    what: Literal["gallery"]


class Unread(Ask, frozen=True):
    """A text was typed into a number box that is no number; its user is to be told."""

    text: Annotated[str, Meta(min_length=1, max_length=40)]


class Unsent(Ask, frozen=True):
    """Something was too long to be sent; its user is to be told."""

    what: Literal["resume", "link", "paste"]


class Who(Ask, frozen=True):
    """Whose the page is: a secret of its browser, and the owner's key if it was opened with that."""

    visitor: Annotated[str, Meta(pattern=r"^[0-9a-f]{32}$")]
    owner: Annotated[str, Meta(max_length=100)] = ""


class Scenes(Ask, frozen=True):
    """All scenes, and pictures of the user's own."""

    dark: bool


class OpenScene(Ask, frozen=True, tag="open"):
    """Open a scene by its name."""

    name: _SceneName


class Change(Ask, frozen=True):
    """Do something with one of the page's own scenes; `name` is that of a deleted one for "restore".

    Others may be duplicated, too.
    """

    how: Literal["rename", "duplicate", "delete", "restore"]
    name: _SceneName
    to: Annotated[str, Meta(max_length=200)] = ""


class Texts(Ask, frozen=True):
    """The scene is to have another name and another description."""

    name: Annotated[str, Meta(max_length=200)]
    description: Annotated[str, Meta(max_length=8000)]


# ------------------------------------------------------------------------- of the body's parts
Index = Annotated[int, Meta(ge=0, le=999_999)]
Coordinate = Annotated[float, Meta(ge=-1e7, le=1e7)]
"""In the page's world."""

Degrees = Annotated[float, Meta(ge=-1e4, le=1e4)]
Parts = Annotated[tuple[Index, ...], Meta(max_length=100)]


class Gesture(Ask, frozen=True):
    """Something that is to be done to the body's parts."""


class Select(Gesture, frozen=True):
    """Some parts are to be selected; with `toggle`, they change sides and the others stay as they are."""

    masses: Parts = ()
    springs: Parts = ()
    joints: Parts = ()
    toggle: bool = False


class Marquee(Gesture, frozen=True):
    """What lies whole in a rectangle is to be selected, or with `add` selected too."""

    x: tuple[Coordinate, Coordinate]
    y: tuple[Coordinate, Coordinate]
    add: bool = False


class Place(Gesture, frozen=True):
    """A mass is to be put down."""

    x: Coordinate
    y: Coordinate


class Line(Gesture, frozen=True):
    """Two masses are to be joined by a spring; where one is not named, it is to be put down."""

    a: Index | None = None
    b: Index | None = None
    start: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    end: tuple[Coordinate, Coordinate] = (0.0, 0.0)


class Hold(Gesture, frozen=True):
    """An angular spring is to hold two springs at the angle that they have."""

    a: Index
    b: Index


class Turn(Gesture, frozen=True):
    """A joint is to rest at an angle, degrees, or at the one that it has."""

    joint: Index
    angle: Degrees | None = None


class Stroke(Gesture, frozen=True):
    """The springs that a stroke crosses are to be cut."""

    points: Annotated[tuple[tuple[Coordinate, Coordinate], ...], Meta(min_length=2, max_length=64)]


class Move(Gesture, frozen=True):
    """What is selected, or else one mass, is to be moved by (x, y), and may rest as it is then.

    Moves by keys that follow each other are one step of undo.
    """

    x: Coordinate
    y: Coordinate
    rest: bool = False
    under: Index | None = None
    keys: bool = False


What = Literal[
    "remove", "pin", "duplicate", "mirror", "corners", "triangulate", "rest", "all", "copy", "undo", "redo"
]  # fmt: skip


class Do(Gesture, frozen=True):
    """Something that needs no place: to a mass; or to what is selected, else what is under the pointer."""

    what: What
    mass: Index | None = None
    under: Index | None = None


_decode = msgspec.json.Decoder(
    Share | Offer | Unread | Unsent | Who | Scenes | OpenScene | Change | Texts
    | Select | Marquee | Place | Line | Hold | Turn | Stroke | Move | Do
).decode  # fmt: skip


def parse_ask(message: object) -> Ask | None:
    """What a message of the script asks for; None if it is no such message, or makes no sense."""
    match = _ASK.fullmatch(message) if isinstance(message, str) else None
    if match is None:
        return None
    try:
        return _decode(match[1])
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return None
