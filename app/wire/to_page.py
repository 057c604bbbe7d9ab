"""What the server tells a page's script, beside what viser's own controls and nodes show."""

from __future__ import annotations

import numpy as np
from msgspec import Struct

from sim.scene.lesson import Question

from .from_page import CommandName, leaves, tag_of


class ToPage(Struct, frozen=True, kw_only=True, tag_field="tell", tag=tag_of):
    """Something that a page is told."""


class State(ToPage, frozen=True, kw_only=True):
    """How something is now: only the latest counts, and it is told only when it has changed."""


class Event(ToPage, frozen=True, kw_only=True):
    """Something that happened: all of them arrive, in order."""


class Numbers(ToPage, frozen=True, kw_only=True):
    """Numbers of single precision, which travel beside the JSON: only the latest count."""

    numbers: np.ndarray


# ------------------------------------------------------------------------- states
class PageState(State, frozen=True, kw_only=True, omit_defaults=True):
    """What the script has to know of the session and of the page.

    Attributes:
        page: another text for every connection.
        scene: another number for every scene that is opened.
        title: the scene's.
        width, height: of the scene's frame, in the page's world.
        unit: of lengths.
        joint: the one that is read out; -1 for none.
        playing: whether the clock runs, or will as soon as a heavy step is done.
        rest: whether the body stands while the clock runs, so that no pictures come.
        scrubbed: whether a moment of the past is shown.
        start, end: of the past that can be shown, s; the end only while a moment of it is shown.
        speed: simulated seconds per second.
        offer: whether going back to before an explosion is offered.
        future: whether what came before the user went back is shown.
        follow: whether the driven mass follows the pointer.
        broken: how many springs are broken.
        controls: which there are, of those that the script has or that commands need.
        gizmos, meter: switches of the View menu.
        measuring: id of the Measure tab, if there is one.
        lesson: whether a step of the scene's lesson has begun; None without a lesson.
    """

    page: str
    scene: int
    title: str
    width: float
    height: float
    unit: str
    joint: int = -1
    playing: bool = False
    rest: bool = False
    scrubbed: bool = False
    start: float = 0.0
    end: float = 0.0
    speed: float = 1.0
    offer: bool = False
    future: bool = False
    follow: bool = False
    broken: int = 0
    controls: tuple[str, ...] = ()
    gizmos: bool = False
    meter: bool = False
    measuring: str = ""
    lesson: bool | None = None


class Tools(State, frozen=True, kw_only=True):
    """What is measured on the canvas.

    Attributes:
        traced: masses whose path is drawn.
        seconds: of a path.
        chosen: the mass that was clicked last, or -1.
        coordinates: whether a mass is read out beside it.
    """

    traced: tuple[int, ...] = ()
    seconds: int = 5
    chosen: int = -1
    coordinates: bool = False


class Hud(State, frozen=True, kw_only=True):
    """The head-up display over the canvas, HTML."""

    html: str


class LessonStep(Struct, frozen=True):
    """What the script shows of a step, see `sim.scene.lesson.Step`."""

    title: str
    do: str
    watch: str
    question: Question | None


class Lesson(State, frozen=True, kw_only=True):
    """The scene's lesson, which may be anyone's: the script shows it as text only."""

    steps: tuple[LessonStep, ...]


class Selected(State, frozen=True, kw_only=True):
    """What is selected."""

    masses: tuple[int, ...] = ()
    springs: tuple[int, ...] = ()
    joints: tuple[int, ...] = ()


class Versions(State, frozen=True, kw_only=True):
    """What undo takes back, and what redo does again; empty for nothing.

    Attributes:
        count: how many changes can be undone.
    """

    undo: str = ""
    redo: str = ""
    count: int = 0


class Keepsake(State, frozen=True, kw_only=True):
    """What the browser is to keep, and to give back after a reload or an outage, see `keeping`: JSON."""

    kept: str


# ------------------------------------------------------------------------- numbers
class Plan(Numbers, frozen=True, kw_only=True):
    """What a body is made of, see `drawing.plan.encode_plan`."""


class Frame(Numbers, frozen=True, kw_only=True):
    """Where the masses are, see `drawing.plan.encode_frame`.

    Attributes:
        wall: when it was made, s of a clock that runs evenly.
    """

    wall: float


class Damage(Numbers, frozen=True, kw_only=True):
    """What has yielded and broken, see `drawing.plan.encode_damage`."""


class Arrows(Numbers, frozen=True, kw_only=True):
    """Forces, velocities and torques, see `measure.arrows.encode`; no numbers where nobody looks at any."""


# ------------------------------------------------------------------------- events
class Run(Event, frozen=True, kw_only=True):
    """Do a command that is the page's, see `commands`."""

    command: CommandName


class Resumed(Event, frozen=True, kw_only=True):
    """The server has what the page gave back."""


class ShowMeasures(Event, frozen=True, kw_only=True):
    """Turn to the Measure tab, where a plot is about to come."""


class Copied(Event, frozen=True, kw_only=True):
    """What was to be copied, as text."""

    text: str


class TextsTaken(Event, frozen=True, kw_only=True):
    """Whether the scene has its new texts: a sentence that says why not, or nothing."""

    refused: str


class OfferGallery(Event, frozen=True, kw_only=True):
    """Show the gallery, and why."""

    why: str


class ShelfChanged(Event, frozen=True, kw_only=True):
    """There are other scenes than before."""


class Entry(Struct, frozen=True, kw_only=True):
    """A scene as the gallery shows it.

    Attributes:
        name: by which it is opened.
        title: what it is called: presets by their titles, saved scenes by the names they were saved under.
        line: in one sentence, what it shows.
        text: all of that, which is searched, too.
        group: the heading under which it stands.
        own: whether it is one of the page's own, which it may change.
        saved: whether it is no preset.
    """

    name: str
    title: str
    line: str
    text: str
    group: str
    own: bool
    saved: bool


class Scenes(Event, frozen=True, kw_only=True):
    """All scenes, and the name of the present one."""

    scenes: tuple[Entry, ...]
    present: str


class ScenePictures(Event, frozen=True, kw_only=True):
    """Pictures of scenes by their names, as addresses that an image can have."""

    pictures: dict[str, str]


class SceneChanged(Event, frozen=True, kw_only=True):
    """What was done with a scene of the page's own.

    Attributes:
        undo: by which name it can be brought back, if it can.
    """

    text: str
    undo: str


class Link(Event, frozen=True, kw_only=True):
    """A link to the scene.

    Attributes:
        qr: a picture of its QR code, as an address; empty if it is too long for one.
        problem: why there is none.
    """

    link: str = ""
    qr: str = ""
    problem: str = ""


MESSAGES = tuple(leaves(ToPage))
"""All that a page can be told."""
