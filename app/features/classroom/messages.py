"""Messages of a class: what pupils', teachers' and walls' pages send, and what they are sent."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from app.classroom.axes import Axes

from ...wire.messages import (
    AnswerKind,
    Event,
    FromPage,
    Number,
    Numbers,
    OwnBody,
    PhaseName,
    Point,
    SceneName,
    State,
)
from ...wire.sections import Section

SettingKey = Annotated[str, Meta(pattern=r"^[a-z0-9_%.\[\]-]{1,100}$")]
"""Of `sim.settings`."""


# ------------------------------------------------------------------------- from a pupil
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


class SetNumber(OwnBody, frozen=True):
    """A slider of the step's is moved."""

    key: SettingKey
    value: Number


class SetWord(OwnBody, frozen=True):
    """Something is chosen from a list of the step's."""

    key: SettingKey
    value: Annotated[str, Meta(max_length=40)]


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


class WalkTo(InSeat, frozen=True):
    """The page goes to another stop of its homework."""

    stop: Annotated[int, Meta(ge=0, le=99)]


class Follow(InSeat, frozen=True):
    """The page is to show the teacher's body where it could show its own, or its own again."""

    on: bool


# ------------------------------------------------------------------------- from the teacher
class Lead(FromPage, frozen=True):
    """What the teacher's page says in a class; nobody else's is heard."""


class Stage(Lead, frozen=True):
    """The class goes to a stop and a phase."""

    stop: Annotated[int, Meta(ge=0, le=99)]
    phase: PhaseName
    round: Annotated[int, Meta(ge=0, le=1)] = 0


class ChooseLesson(Lead, frozen=True):
    """The class is to go through another scene; before it begins."""

    name: SceneName


class ChooseNetwork(Lead, frozen=True):
    """Pupils are in the network of one of this computer's addresses."""

    address: Annotated[str, Meta(max_length=300)]


class Arrange(Lead, frozen=True):
    """Something that needs no place.

    All bodies are to stand, to go on, or to begin anew, or are to be the teacher's as it is now; all are to
    look at the teacher's, or to have their own back; the run is to be seen again, slowly; all hands go down;
    the class's plot is to have the law of its points, or no longer; the door and whether names can be typed;
    what was given is to be saved as a file, the present lesson as one that lives without a server, or as a
    sheet for its teacher; and the end.
    """

    what: Literal[
        "pause",
        "goOn",
        "reset",
        "asMine",
        "gather",
        "giveBack",
        "again",
        "lowerHands",
        "law",
        "noLaw",
        "open",
        "close",
        "ownNames",
        "givenNames",
        "zip",
        "lessonFile",
        "sheet",
        "tell",
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


# ------------------------------------------------------------------------- to a page
class Asking(Struct, frozen=True, kw_only=True):
    """What a class looks at.

    Attributes:
        stop, phase, round: where it is.
        title, do, watch: of the step; empty without one.
        question, choices: empty if nothing is asked.
        right: the right choice, once it may be known; else -1.
        because: why it is right, then.
        runs: what is otherwise when it runs than as the step begins, in words; empty for nothing.
        predict: simulated time for which the body's place is asked for, s; 0 if it is not.
        masses: whose places are asked for: those that the step reads; empty for all.
        goal: what is to be reached, in words; empty for nothing.
        collects: what each one hands in, in words; empty for the run alone.
    """

    stop: int
    phase: PhaseName
    round: int
    title: str
    do: str
    watch: str
    question: str
    choices: tuple[str, ...]
    right: int
    because: str
    runs: str
    predict: float
    masses: tuple[int, ...]
    goal: str
    collects: str


class Given(Struct, frozen=True, kw_only=True):
    """Something that the pupil at a page has given.

    Attributes:
        kind: what it is.
        choice: of a vote; else -1.
        text: of a line, or what was found, or how far a prediction has moved its one mass.
        late: whether it came in after the right answer had been shown.
    """

    stop: int
    round: int
    twin: int
    kind: AnswerKind
    choice: int
    text: str
    late: bool


class Found(Struct, frozen=True, kw_only=True):
    """What one seat found: a point of the class's plot."""

    setting: float
    found: float


class Law(Struct, frozen=True, kw_only=True):
    """The power law, found = factor * setting ** exponent, that the class's points are closest to."""

    factor: float
    exponent: float


class Seat(State, frozen=True, kw_only=True):
    """What a pupil's page has to know of the class.

    Attributes:
        code: the class's; empty while the page is in none.
        problem: why it is in none.
        name, color: the pupil's.
        turn: that the page's next answer has at least.
        two: whether two pupils sit here.
        hand: whether a hand is up.
        types_name: whether names can be typed.
        is_given: whether the pupil's name is still the one that the class gave.
        digits: by which another device takes the seat over; empty if it is not to.
        follows: whether the page shows the teacher's body.
        gathered: whether it has to, where it could have its own.
        paused: whether all bodies stand.
        away: whether the teacher is not there.
        on_wall: whether the wall shows something of this pupil's alone.
        elsewhere: what has the seat now: a later page of the same browser, or another device; or empty.
        reached: whether the page's body has reached the step's goal.
        reading: the number that would be handed in now, with its unit; empty while there is none.
        found: of the class's plot, for a pupil who has put a point on it; else empty.
        own: that point.
        axes: of that plot.
        home: when what is right in homework is told, in words; empty for a class.
        told: whether it is.
        done: of homework, which steps have been answered wholly; empty for a class.
    """

    code: str = ""
    problem: str = ""
    name: str = ""
    color: str = ""
    turn: int = 0
    two: bool = False
    hand: bool = False
    types_name: bool = False
    is_given: bool = False
    digits: str = ""
    follows: bool = False
    gathered: bool = False
    paused: bool = False
    away: bool = False
    on_wall: bool = False
    elsewhere: Literal["", "page", "device"] = ""
    reached: bool = False
    reading: str = ""
    found: tuple[Found, ...] = ()
    own: Found | None = None
    axes: Axes = Axes()
    home: str = ""
    told: bool = False
    done: tuple[bool, ...] = ()
    asking: Asking | None = None
    given: tuple[Given, ...] = ()


class Dial(Struct, frozen=True, kw_only=True):
    """A slider or a list of a pupil's page.

    Attributes:
        key: of the setting.
        label, unit: of its number.
        low, high: of the slider.
        logarithmic: equal steps of it are equal factors.
        value: at present.
        options: value and word of each, of a list; empty for a slider.
        sets: what it sets of a body that moves in the page itself; empty if it cannot.
    """

    key: str
    label: str
    unit: str = ""
    low: float = 0.0
    high: float = 1.0
    logarithmic: bool = False
    value: float | str = 0.0
    options: tuple[tuple[str, str], ...] = ()
    sets: tuple[str, ...] = ()


class Curve(Struct, frozen=True, kw_only=True):
    """A plot of a step.

    Attributes:
        names, labels, units: of its quantities: as files and as people call them.
        over, over_unit: the quantity on the horizontal axis; empty for the time.
        turned: whether it grows downwards.
    """

    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: tuple[str, ...]
    over: str
    over_label: str
    over_unit: str
    turned: bool


class Bench(State, frozen=True, kw_only=True):
    """What a pupil has to work with: sliders, plots, and arrow keys.

    Attributes:
        opening: of the body; another one begins with empty plots.
    """

    opening: int = -1
    dials: tuple[Dial, ...] = ()
    curves: tuple[Curve, ...] = ()


class Readings(Numbers, frozen=True, kw_only=True):
    """What the plots of a page show now."""

    sections = (
        Section("now", numbers={"opening": "of the body, as in `Bench`", "time": "simulated seconds"}),
        Section("values", "of each plot the quantities, and the one on the horizontal axis"),
    )


class Alone(State, frozen=True, kw_only=True):
    """A body with which a page goes on where its connection ends.

    Attributes:
        opening: of the body; -1 for none: its method needs the server.
        body: JSON, the `BodyData` of a live file.
        method, dt: by which it moves, as in a live file.
    """

    opening: int = -1
    body: str = ""
    method: str = ""
    dt: float = 0.0


class Remark(Event, frozen=True, kw_only=True):
    """Something that the user of the page is to read once."""

    title: str
    text: str


class WallLine(Struct, frozen=True, kw_only=True):
    """A line that the teacher has picked out."""

    text: str
    color: str


class Wall(State, frozen=True, kw_only=True):
    """What the class sees in front; no name is in it.

    Attributes:
        code, address: how one comes in; a QR code of it as an address of a picture.
        seats: how many are here, or have answered what is asked and left.
        answered: how many have answered what is asked.
        bars: votes for each choice, once they are shown; else empty.
        lines: what was picked out.
        alone: whether one prediction is shown alone.
        found: what was handed in, a point a seat, and
        axes: of their plot.
        law: of these points, if it is to be seen.
        doing: how many bodies do what, of those who have not handed in, while each one has their own.
        start: where the masses were as the step began, in the page's world; only for the reveal.
        steps: of the class's plan.
        unit: of lengths.
    """

    code: str
    address: str
    qr: str
    seats: int
    answered: int
    asking: Asking
    bars: tuple[int, ...]
    lines: tuple[WallLine, ...]
    alone: bool
    paused: bool
    found: tuple[Found, ...]
    axes: Axes
    law: Law | None
    doing: dict[str, int]
    start: tuple[Point, ...]
    steps: int
    unit: str


class Predictions(State, frozen=True, kw_only=True):
    """Where the class has said that the masses will be, in the page's world: one body a prediction, without
    names."""

    bodies: tuple[tuple[tuple[float, float], ...], ...] = ()


class Posters(State, frozen=True, kw_only=True):
    """Where bodies are: thousandths of the scene's frame from its left and upper edge.

    Attributes:
        places: of the seats' own bodies, by their numbers; none while they have none.
        start: of the body as the step begins.
        springs: between which masses.
    """

    places: dict[str, tuple[tuple[int, int], ...]]
    start: tuple[tuple[int, int], ...]
    springs: tuple[tuple[int, int], ...]


class DeskSeat(Struct, frozen=True, kw_only=True):
    """A seat, as the teacher sees it.

    Attributes:
        here: whether a page of it is connected.
        answered: whether it has given what is asked for.
        doing: what its body does; empty while it has none.
        done: of homework, see `Seat`.
        follows: whether it looks at the teacher's body where it could have its own.
        digits: by which another device takes the seat over; empty if it is not to.
    """

    number: int
    name: str
    color: str
    here: bool
    two: bool
    hand: bool
    answered: bool
    doing: Literal["", "moving", "untouched", "at rest", "paused", "exploded", "goal reached"]
    done: tuple[bool, ...]
    follows: bool
    digits: str


class DeskAnswer(Struct, frozen=True, kw_only=True):
    """An answer, as the teacher sees it.

    Attributes:
        places: in thousandths as in `Posters`: where the masses of a run that was handed in were; or where
            those that were asked for will be, in a prediction.
    """

    id: str
    seat: int
    kind: AnswerKind
    choice: int
    text: str
    late: bool
    starred: bool
    found: float | None
    setting: float | None
    reached: bool | None
    doubt: str
    places: tuple[tuple[int, int], ...]


class DeskTried(Struct, frozen=True, kw_only=True):
    """What a device found that tried whether it can take part; see `from_page.Checked`."""

    trip: int
    rate: int
    works: bool
    doubts: bool


class LessonName(Struct, frozen=True, kw_only=True):
    """A scene that the class could go through: its name, and its title."""

    name: str
    title: str


class DeskStop(Struct, frozen=True, kw_only=True):
    """A stop of the class's plan."""

    title: str
    phases: tuple[tuple[PhaseName, int], ...]


class Desk(State, frozen=True, kw_only=True):
    """What the teacher's page has to know of the class.

    Attributes:
        stops: the plan.
        next: where the class goes next: stop, phase, round; None at the end.
        answers: to the present stop and round, or to what was asked last there.
        bars: votes for each choice, also while they are sealed.
        doing: see `Wall`.
        axes: of the class's plot.
        law: of its points; None where they have none.
        shows_law: whether the wall shows it.
        on_wall: the answer that is shown alone.
        seat_on_wall: the seat whose body is on the wall, or 0.
        gathered: whether all look at the teacher's body where each one could have their own.
        again: whether there is a run to be seen again, slowly: "no", "yes", or "now" while it is.
        saved: whether all that there is is on the disk.
        trouble: why nothing can be kept there now; empty while all is well.
        check: the address at which a device tries whether it can take part.
        check_qr: a picture of its QR code; empty once the class has begun.
        tried: what the last devices found that did.
        lessons: to choose from before the class begins, and
        lesson: the name of the one that is chosen.
        networks: addresses by which pupils may come in, of which one can be chosen; empty where there is
            nothing to choose.
        home, told: see `Seat`.
        done: of homework, how many have answered each stop's question, and how many have handed in there.
        elapsed: since the class left the lobby, s; negative before.
    """

    code: str
    address: str
    qr: str
    check: str
    check_qr: str
    tried: tuple[DeskTried, ...]
    stops: tuple[DeskStop, ...]
    asking: Asking
    next: tuple[int, PhaseName, int] | None
    seats: tuple[DeskSeat, ...]
    answers: tuple[DeskAnswer, ...]
    bars: tuple[int, ...]
    doing: dict[str, int]
    right: int
    axes: Axes
    law: Law | None
    shows_law: bool
    on_wall: str
    seat_on_wall: int
    gathered: bool
    again: Literal["no", "yes", "now"]
    open: bool
    own_names: bool
    paused: bool
    saved: bool
    trouble: str
    lessons: tuple[LessonName, ...]
    lesson: str
    networks: tuple[str, ...]
    home: str
    told: bool
    done: tuple[tuple[int, int], ...]
    elapsed: float


class Taken(Event, frozen=True, kw_only=True):
    """The server has these answers, or has refused one: then it says why."""

    ids: tuple[str, ...]
    refused: str = ""


class Brought(Event, frozen=True, kw_only=True):
    """What became of answers that the teacher brought, in a sentence."""

    told: str
    refused: bool = False


class ClassEnded(Event, frozen=True, kw_only=True):
    """The class is over: nothing of it is to be kept."""
