"""Messages about the parts of the body and edits of them."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from sim.scene.parts import Wave

from ...wire.messages import Coordinate, Degrees, Event, FromPage, Index, Parts, Point, State


class Edit(FromPage, frozen=True):
    """A change of the scene; for pages that may edit."""


class SetTexts(Edit, frozen=True):
    """Change the name and the description of the scene."""

    name: Annotated[str, Meta(max_length=200)]
    description: Annotated[str, Meta(max_length=8000)]


class Tempo(Edit, frozen=True):
    """Change the frequency of the beat of all muscles, Hz."""

    frequency: Annotated[float, Meta(ge=0, le=100)]


class Gesture(Edit, frozen=True):
    """An edit of the parts of the body."""


class Select(Gesture, frozen=True):
    """Select these parts only; or with `toggle`, select or deselect them."""

    masses: Parts = ()
    springs: Parts = ()
    joints: Parts = ()
    toggle: bool = False


class Marquee(Gesture, frozen=True):
    """Select what lies entirely in a rectangle; with `add`, in addition to the selection."""

    x: Point
    y: Point
    add: bool = False


class Place(Gesture, frozen=True):
    """Add a mass."""

    x: Coordinate
    y: Coordinate


class Line(Gesture, frozen=True):
    """Add a spring between two masses; a mass that is not given is added, too."""

    a: Index | None = None
    b: Index | None = None
    start: Point = (0.0, 0.0)
    end: Point = (0.0, 0.0)


class Hold(Gesture, frozen=True):
    """Add an angular spring between two springs, at rest at their present angle."""

    a: Index
    b: Index


class Turn(Gesture, frozen=True):
    """Set the rest angle of a joint, degrees; by default to its present angle."""

    joint: Index
    angle: Degrees | None = None


class Stroke(Gesture, frozen=True):
    """Cut the springs that a stroke crosses."""

    points: Annotated[tuple[Point, ...], Meta(min_length=2, max_length=64)]


class Move(Gesture, frozen=True):
    """Move the selection, or else one mass; with `rest`, springs and joints rest as they are then.

    Consecutive moves by keys are one step of undo.

    Attributes:
        x, y: displacement in the page's world.
        under: the mass to move without a selection.
    """

    x: Coordinate
    y: Coordinate
    rest: bool = False
    under: Index | None = None
    keys: bool = False


class MoveMuscles(Gesture, frozen=True):
    """Change phase and amplitude of the selected muscles.

    Consecutive changes by keys are one step of undo; so are all others until the next `Visit`.

    Attributes:
        later: added to the phases, beats.
        stretch: added to the amplitudes of springs.
        turn: added to the amplitudes of joints, degrees.
    """

    later: Annotated[float, Meta(ge=-10, le=10)] = 0.0
    stretch: Annotated[float, Meta(ge=-2, le=2)] = 0.0
    turn: Degrees = 0.0
    keys: bool = False


class ShapeMuscles(Gesture, frozen=True):
    """Change the waveform or the waves per beat of the selected muscles, or spread their phases."""

    wave: Wave | None = None
    per_beat: Annotated[int, Meta(ge=1, le=16)] | None = None
    spread: bool = False


class Act(Gesture, frozen=True):
    """Apply an action to a mass; or to the selection, or else to the mass under the pointer."""

    what: Literal[
        "remove", "pin", "duplicate", "mirror", "corners", "triangulate",
        "rest", "keep", "stiffen", "all", "copy",
    ]  # fmt: skip
    mass: Index | None = None
    under: Index | None = None


class Selected(State, frozen=True):
    """The selection."""

    masses: tuple[int, ...] = ()
    springs: tuple[int, ...] = ()
    joints: tuple[int, ...] = ()


class Versions(State, frozen=True):
    """Names of the changes that can be undone and redone; empty for none.

    Attributes:
        count: number of changes that can be undone.
        stiffen: the factor by which a stiffer body could keep the shape that it cannot keep now; 0 for none.
    """

    undo: str = ""
    redo: str = ""
    count: int = 0
    stiffen: float = 0.0


class Copied(Event, frozen=True, kw_only=True):
    """The copied parts, as text."""

    text: str


class TextsTaken(Event, frozen=True, kw_only=True):
    """The result of `SetTexts`: a sentence that says why it was refused, or an empty one."""

    refused: str
