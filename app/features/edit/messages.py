"""What a page says of the body's parts, and is told of them."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from sim.scene.parts import Wave

from ...wire.messages import Coordinate, Degrees, Event, FromPage, Index, Parts, Point, State


class Edit(FromPage, frozen=True):
    """Something that changes the scene; for pages that may edit."""


class SetTexts(Edit, frozen=True):
    """The scene is to have another name and another description."""

    name: Annotated[str, Meta(max_length=200)]
    description: Annotated[str, Meta(max_length=8000)]


class Tempo(Edit, frozen=True):
    """The beat of all muscles is to have another frequency, Hz."""

    frequency: Annotated[float, Meta(ge=0, le=100)]


class Gesture(Edit, frozen=True):
    """Something that is to be done to the body's parts."""


class Select(Gesture, frozen=True):
    """Some parts are to be selected; with `toggle`, they change sides and the others stay as they are."""

    masses: Parts = ()
    springs: Parts = ()
    joints: Parts = ()
    toggle: bool = False


class Marquee(Gesture, frozen=True):
    """What lies whole in a rectangle is to be selected, or with `add` selected too."""

    x: Point
    y: Point
    add: bool = False


class Place(Gesture, frozen=True):
    """A mass is to be put down."""

    x: Coordinate
    y: Coordinate


class Line(Gesture, frozen=True):
    """Two masses are to be joined by a spring; where one is not named, it is to be put down."""

    a: Index | None = None
    b: Index | None = None
    start: Point = (0.0, 0.0)
    end: Point = (0.0, 0.0)


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

    points: Annotated[tuple[Point, ...], Meta(min_length=2, max_length=64)]


class Move(Gesture, frozen=True):
    """What is selected, or else one mass, is to be moved by (x, y), and may rest as it is then.

    Moves by keys that follow each other are one step of undo.
    """

    x: Coordinate
    y: Coordinate
    rest: bool = False
    under: Index | None = None
    keys: bool = False


class MoveMuscles(Gesture, frozen=True):
    """The selected muscles are to come to their largest later, and to be larger.

    Those by keys that follow each other are one step of undo; so are all others until the next `Visit`.

    Attributes:
        later: beats.
        stretch: is added to the amplitudes of springs.
        turn: degrees that are added to those of joints.
    """

    later: Annotated[float, Meta(ge=-10, le=10)] = 0.0
    stretch: Annotated[float, Meta(ge=-2, le=2)] = 0.0
    turn: Degrees = 0.0
    keys: bool = False


class ShapeMuscles(Gesture, frozen=True):
    """The selected muscles are to have another wave, or another number of waves in a beat, or are to be
    spread over the beat."""

    wave: Wave | None = None
    per_beat: Annotated[int, Meta(ge=1, le=16)] | None = None
    spread: bool = False


class Act(Gesture, frozen=True):
    """Something that needs no place: to a mass; or to what is selected, else what is under the pointer."""

    what: Literal[
        "remove",
        "pin",
        "duplicate",
        "mirror",
        "corners",
        "triangulate",
        "rest",
        "keep",
        "stiffen",
        "all",
        "copy",
    ]
    mass: Index | None = None
    under: Index | None = None


class Selected(State, frozen=True, kw_only=True):
    """What is selected."""

    masses: tuple[int, ...] = ()
    springs: tuple[int, ...] = ()
    joints: tuple[int, ...] = ()


class Versions(State, frozen=True, kw_only=True):
    """What undo takes back, and what redo does again; empty for nothing.

    Attributes:
        count: how many changes can be undone.
        stiffen: the factor of stiffness with which the body could keep the shape that it could not keep
            without; 0 for none.
    """

    undo: str = ""
    redo: str = ""
    count: int = 0
    stiffen: float = 0.0


class Copied(Event, frozen=True, kw_only=True):
    """What was to be copied, as text."""

    text: str


class TextsTaken(Event, frozen=True, kw_only=True):
    """Whether the scene has its new texts: a sentence that says why not, or nothing."""

    refused: str
