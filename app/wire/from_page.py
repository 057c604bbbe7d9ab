"""Messages from a page that belong to no feature.

Any client can forge them: `messages.read` accepts only what is exactly declared here, and only finite
numbers. Whether a mass or a control exists is checked where a message is handled. Places are in the page's
world, see `stage.sketch.Mapping`."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from .messages import (
    Ask,
    CommandName,
    FromPage,
    OwnBody,
    PhaseName,
    Point,
    TextKind,
)


class Perform(OwnBody, frozen=True):
    """Execute a command of the table, see `app.ui.commands`."""

    command: CommandName


class Visit(OwnBody, frozen=True):
    """A slider or a number box was focused: later changes are another step of undo."""


# ------------------------------------------------------------------------- long texts
class Part(FromPage, frozen=True):
    """A part of a text that is too long for one message.

    Attributes:
        kind: of the whole text: a saved page ("resume"), or one of a feature's `texts`.
        number: from 1.
        of: number of parts.
    """

    kind: TextKind
    number: Annotated[int, Meta(ge=1, le=99)]
    of: Annotated[int, Meta(ge=1, le=99)]
    letters: Annotated[str, Meta(max_length=48_000, pattern=r"^[\x21-\x7e]*$")]


# ------------------------------------------------------------------------- questions
class Unread(Ask, frozen=True):
    """A text in a number box that is not a number, for a notice to the user."""

    text: Annotated[str, Meta(min_length=1, max_length=40)]


class Unsent(Ask, frozen=True):
    """A text was too long to be sent, for a notice to the user."""

    what: TextKind


class Who(Ask, frozen=True):
    """Identifies the page's user: a secret of the browser, and the owner's key if it was opened with that.

    Attributes:
        teacher: the secret of the page's class, if it is the teacher's page.
    """

    visitor: Annotated[str, Meta(pattern=r"^[0-9a-f]{32}$")]
    owner: Annotated[str, Meta(max_length=100)] = ""
    teacher: Annotated[str, Meta(max_length=100)] = ""


# ------------------------------------------------------------------------- in a class, a pupil
class InSeat(FromPage, frozen=True):
    """What a pupil's page says in a class; see `app.classroom.room`."""


class Give(InSeat, frozen=True):
    """An answer, which is repeated until the server has it; `app.classroom.answers` has its kinds.

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


class GivePrediction(Give, frozen=True):
    """Where each mass will be."""

    points: Annotated[tuple[Point, ...], Meta(min_length=1, max_length=2000)]


class GiveLine(Give, frozen=True):
    """An explanation."""

    text: Annotated[str, Meta(min_length=1, max_length=600)]


class GiveWork(Give, frozen=True):
    """Hand in what the page's body did since the step began; the server has it."""


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
