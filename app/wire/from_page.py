"""What a page says to the server.

Any client can forge these: `read` takes nothing but exactly what is written here, and no number that is not
finite. Whether a mass exists, or a control, is checked where a message is done.

Places are in the page's world, see `drawing.sketch.Mapping`.
"""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from sim.scene.parts import Wave

from .messages import (
    Ask,
    CommandName,
    Coordinate,
    Degrees,
    FromPage,
    Hand,
    Index,
    Key,
    LongText,
    Number,
    OwnBody,
    Parts,
    PhaseName,
    Point,
    QuantityName,
    SceneName,
    StepNumber,
    TextKind,
)


# ------------------------------------------------------------------------- commands, keys and hands
class Perform(OwnBody, frozen=True):
    """Do a command of the table, see `commands`."""

    command: CommandName


class Keys(OwnBody, frozen=True):
    """The arrow keys that are held; said again and again while any is."""

    held: Annotated[tuple[Key, ...], Meta(max_length=4)]


class At(OwnBody, frozen=True):
    """Where hands are; said at every animation frame in which one moved."""

    hands: Annotated[tuple[tuple[Hand, Coordinate, Coordinate], ...], Meta(min_length=1, max_length=10)]


class Grab(OwnBody, frozen=True):
    """A hand takes hold of a mass."""

    hand: Hand
    mass: Index
    x: Coordinate
    y: Coordinate


class Drop(OwnBody, frozen=True):
    """A hand lets go."""

    hand: Hand


class Pick(OwnBody, frozen=True):
    """A mass was clicked."""

    mass: Index


# ------------------------------------------------------------------------- time and looks
class GoTo(OwnBody, frozen=True):
    """Show a moment of the past, s."""

    time: Coordinate


class Speed(OwnBody, frozen=True):
    """How fast time goes, simulated seconds per second."""

    speed: Coordinate


class Visit(OwnBody, frozen=True):
    """A slider was pressed, or a number box entered: what is changed from here on is another step of undo."""


class Seen(OwnBody, frozen=True):
    """In which tab somebody sees plots now; they are not sent otherwise."""

    tab: Literal["measure", "lesson", ""]


class BeginStep(FromPage, frozen=True):
    """The page goes to a step of the scene's lesson.

    Attributes:
        how: "run" or "wait": it begins; the body waits if there is a question. "on": the page goes on in the
            middle of it, as after a reload.
    """

    step: StepNumber
    how: Literal["run", "wait", "on"] = "wait"


# ------------------------------------------------------------------------- long texts
class Part(FromPage, frozen=True):
    """A part of what is too long for one message.

    Attributes:
        kind: of the whole text: a keepsake ("resume"), a link, a file, what is pasted, or one of a feature's.
        number: from 1.
        of: how many parts there are.
    """

    kind: TextKind
    number: Annotated[int, Meta(ge=1, le=99)]
    of: Annotated[int, Meta(ge=1, le=99)]
    letters: Annotated[str, Meta(max_length=48_000, pattern=r"^[\x21-\x7e]*$")]


# ------------------------------------------------------------------------- questions
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


class Unread(Ask, frozen=True):
    """A text was typed into a number box that is no number; its user is to be told."""

    text: Annotated[str, Meta(min_length=1, max_length=40)]


class Unsent(Ask, frozen=True):
    """Something was too long to be sent; its user is to be told."""

    what: TextKind


class Who(Ask, frozen=True):
    """Whose the page is: a secret of its browser, and the owner's key if it was opened with that.

    Attributes:
        teacher: the secret of the class that the page is of, if it is the teacher's.
    """

    visitor: Annotated[str, Meta(pattern=r"^[0-9a-f]{32}$")]
    owner: Annotated[str, Meta(max_length=100)] = ""
    teacher: Annotated[str, Meta(max_length=100)] = ""


class ListScenes(Ask, frozen=True):
    """All scenes, and pictures of the user's own."""

    dark: bool


class OpenScene(Ask, frozen=True):
    """Open a scene by its name."""

    name: SceneName


class UseInClass(Ask, frozen=True):
    """Begin a class with a scene, by its name."""

    name: SceneName


class ChangeScene(Ask, frozen=True):
    """Do something with one of the page's own scenes; `name` is that of a deleted one for "restore".

    Others may be duplicated, too.
    """

    how: Literal["rename", "duplicate", "delete", "restore"]
    name: SceneName
    to: Annotated[str, Meta(max_length=200)] = ""


# ------------------------------------------------------------------------- in a class, a pupil
class InSeat(FromPage, frozen=True):
    """What a pupil's page says in a class; see `app.classroom.room`."""


class Give(InSeat, frozen=True):
    """An answer, which is said again until the server has it.

    Attributes:
        id: made up by the page.
        turn: counts what the page gave.
        twin: 1 for the second of two pupils at one page.
        stop, round: what it is the answer to.
    """

    id: Annotated[str, Meta(pattern=r"^[0-9a-f]{16}$")]
    turn: Annotated[int, Meta(ge=0, le=1_000_000)]
    stop: Annotated[int, Meta(ge=0, le=99)]
    round: Annotated[int, Meta(ge=0, le=1)]
    twin: Annotated[int, Meta(ge=0, le=1)]


class GiveVote(Give, frozen=True):
    """One of the choices of a question."""

    choice: Annotated[int, Meta(ge=0, le=4)]


class GivePlaces(Give, frozen=True):
    """Where each mass will be."""

    points: Annotated[tuple[Point, ...], Meta(min_length=1, max_length=2000)]


class GiveLine(Give, frozen=True):
    """An explanation."""

    text: Annotated[str, Meta(min_length=1, max_length=600)]


class HandIn(Give, frozen=True):
    """What the page's body did since the step began is to be handed in; the server has it."""


class RaiseHand(InSeat, frozen=True):
    """A hand goes up or down."""

    up: bool


class NewName(InSeat, frozen=True):
    """Another name is wanted: one of the class's, or the one that was typed."""

    wanted: Annotated[str, Meta(max_length=100)] = ""


class SitTogether(InSeat, frozen=True):
    """Two pupils are at this page, or one."""

    two: bool


class LeaveBy(InSeat, frozen=True):
    """Another device is to take the seat over: two digits are wanted by which it finds it."""


class TakeOver(InSeat, frozen=True):
    """This page is to have the seat that offers itself by two digits."""

    digits: Annotated[str, Meta(pattern=r"^[0-9]{2}$")]


class Checked(FromPage, frozen=True):
    """What a device found that tried whether it can take part in a class.

    Attributes:
        trip: round trip, ms; -1 if no answer came.
        rate: pictures that arrived a second.
        works: whether it can take part.
        doubts: whether its page has anything marked.
    """

    trip: Annotated[int, Meta(ge=-1, le=99_999)]
    rate: Annotated[int, Meta(ge=0, le=999)]
    works: bool
    doubts: bool


class Follow(InSeat, frozen=True):
    """The page is to show the teacher's body where it could show its own, or its own again."""

    on: bool


# ------------------------------------------------------------------------- in a class, the teacher
class Lead(FromPage, frozen=True):
    """What the teacher's page says in a class; nobody else's is heard."""


class Stage(Lead, frozen=True):
    """The class goes to a stop and a phase."""

    stop: Annotated[int, Meta(ge=0, le=99)]
    phase: PhaseName
    round: Annotated[int, Meta(ge=0, le=1)] = 0


class Arrange(Lead, frozen=True):
    """Something that needs no place.

    All bodies are to stand, to go on, or to begin anew, or are to be the teacher's as it is now; all are to
    look at the teacher's, or to have their own back; the run is to be seen again, slowly; the class's plot is
    to have the law of its points, or no longer; the door and whether names can be typed; what was given is to
    be saved as a file, or the present lesson as one that lives without a server; and the end.
    """

    what: Literal[
        "pause",
        "goOn",
        "reset",
        "asMine",
        "gather",
        "giveBack",
        "again",
        "law",
        "noLaw",
        "open",
        "close",
        "ownNames",
        "givenNames",
        "zip",
        "lessonFile",
        "end",
    ]


class Star(Lead, frozen=True):
    """An answer is picked out, or no longer."""

    answer: Annotated[str, Meta(pattern=r"^[0-9a-f]{16}$")]
    on: bool


class ToWall(Lead, frozen=True):
    """An answer is to be shown alone on the wall; none for ""."""

    answer: Annotated[str, Meta(pattern=r"^([0-9a-f]{16})?$")]


class Bring(Lead, frozen=True):
    """Answers that a pupil gave in a file: the text of the file that was saved there, or of its QR code."""

    text: Annotated[str, Meta(min_length=1, max_length=20_000)]


class OneSeat(Lead, frozen=True):
    """Something is to be done with one seat.

    Its body is to begin anew, or to be shown on the wall, or no longer; another device may take it over by
    two digits; or it is closed, and all that it gave goes.
    """

    seat: Annotated[int, Meta(ge=1, le=9999)]
    what: Literal["reset", "show", "hide", "move", "sendAway"]


# ------------------------------------------------------------------------- the scene's lesson
class Prepare(FromPage, frozen=True):
    """Something about the lesson that is being made; for pages that may edit, and are in no class."""


class MakeLesson(Prepare, frozen=True):
    """The form of the lesson is to be open, or not."""

    on: bool


class AddStep(Prepare, frozen=True):
    """A new step, which is to have that number, counted from 0."""

    at: StepNumber


class OfStep(Prepare, frozen=True):
    """Something about one step."""

    step: StepNumber


class CopyStep(OfStep, frozen=True):
    """A copy of the step is to come after it."""


class RemoveStep(OfStep, frozen=True):
    """The step is to go; with the last one, the lesson goes."""


class MoveStep(OfStep, frozen=True):
    """The step is to have another place."""

    to: StepNumber


class WriteStep(OfStep, frozen=True):
    """A text of the step."""

    field: Literal["title", "do", "watch"]
    text: LongText


class AskInStep(OfStep, frozen=True):
    """The question of the step."""

    text: LongText
    choices: Annotated[tuple[LongText, ...], Meta(max_length=10)]
    answer: Annotated[int, Meta(ge=0, le=9)]
    because: LongText


class PredictInStep(OfStep, frozen=True):
    """The time after which the body's place is asked for, s."""

    seconds: Number


class AimInStep(OfStep, frozen=True):
    """The goal of the step, see `sim.scene.lesson.Goal`."""

    quantity: QuantityName
    of: Literal["value", "period"]
    low: Number | None
    high: Number | None
    seconds: Number


class CollectInStep(OfStep, frozen=True):
    """What is handed in of the step."""

    quantity: QuantityName
    of: Literal["value", "period"]


class OfferInStep(OfStep, frozen=True):
    """The sliders and lists that stand below the step, by their keys."""

    controls: Annotated[tuple[QuantityName, ...], Meta(max_length=40)]


class CompareInStep(OfStep, frozen=True):
    """The method of the second body, "reference", or "" for none."""

    ghost: Annotated[str, Meta(max_length=40)]


class TakeInStep(OfStep, frozen=True):
    """The step is to have the settings, the plots or the arrows as they are now."""

    what: Literal["settings", "plots", "arrows"]


class DropFromStep(OfStep, frozen=True):
    """The step is to have no such thing any more; without arrows of its own it leaves them as they are."""

    what: Literal["question", "predict", "goal", "collect", "plots", "arrows"]


class TryStep(OfStep, frozen=True):
    """The step is to begin as a pupil sees it."""


class EndTrying(Prepare, frozen=True):
    """The page goes back to where a step was tried from."""


class DropLesson(Prepare, frozen=True):
    """The lesson is to go."""


# ------------------------------------------------------------------------- edits
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
