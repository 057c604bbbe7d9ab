"""Messages to a page's script that belong to no feature."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from .messages import AnswerKind, CommandName, Event, Numbers, PhaseName, State
from .sections import Section


# ------------------------------------------------------------------------- states
class PageState(State, frozen=True, kw_only=True, omit_defaults=True):
    """The state of the session and of the page.

    Attributes:
        page: id of the connection.
        scene: number of the opened scene.
        title: the scene's title.
        width, height: size of the scene's frame, in the page's world.
        unit: unit of lengths.
        joint: index of the joint that is read out; -1 for none.
        playing: the clock runs, or will as soon as a heavy step is done.
        rest: the body stands while the clock runs, so that no frames are sent.
        scrubbed: a moment of the past is shown.
        start, end: of the past that can be shown, s; the end only while a moment of it is shown.
        speed: simulated seconds per second.
        offer: going back to before an explosion is offered.
        future: what happened before the user went back is shown.
        follow: the driven mass follows the pointer.
        broken: number of broken springs.
        controls: names of the page's controls.
        gizmos, meter: switches of the View menu.
        measuring: id of the Measure tab; empty without one.
        lesson: a step of the scene's lesson has begun; None without a lesson.
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


class Hud(State, frozen=True, kw_only=True):
    """The head-up display over the canvas, HTML."""

    html: str


class Keepsake(State, frozen=True, kw_only=True):
    """The state that the browser stores and returns after a reload or an outage, see `keeping`: JSON."""

    kept: str


# ------------------------------------------------------------------------- numbers
class Plan(Numbers, frozen=True, kw_only=True):
    """The parts and the surroundings of a body."""

    sections = (
        Section(
            "head",
            numbers={
                "generation": "which body this is; frames carry the same number",
                "scale": "from px to the page's world",
                "x": "the middle of the scene's frame, px",
                "y": "the middle of the scene's frame, px",
                "flip": "-1 where y grows downwards",
                "many?": "whether there are so many masses that they are drawn with less",
                "bars?": "whether springs are bars instead of coils",
                "slices": "triangles of a wedge",
                "driven": "the mass that the pointer drives, or -1",
            },
        ),
        Section("radius", "of each mass, in the world"),
        Section("springs", "two masses each"),
        Section("rest_length", "px, one for each spring"),
        Section("thickness", "amplitude of the coil or width of the bar, in the world"),
        Section("full_strain", "relative stretch at which each spring has its full colour; or one for all"),
        Section("joints", "spring a, spring b, the mass at the tip, and whether b leaves it (1) or not (-1)"),
        Section("rest_angle", "degrees"),
        Section("pinned", "the held masses that have a support"),
        Section("mass_colors", "three a mass: of rim, fill and shine"),
        Section("strain_colors", "a table, from full compression to full stretch"),
        Section("turn_colors", "a table, from the full negative deviation to the full positive one"),
        Section("ink_colors", "of pins, ring, ghost and the mark of springs that have yielded"),
        Section("walls", "of each a point of the surface, px, and the unit vector to the free side"),
        Section("fillings", "of each whether it is a gas, how many masses its loop has, and which"),
        Section(
            "wind", "velocity, px/s; of each wave of its gusts wave vector, amplitude and phase; or nothing"
        ),
        Section(
            "contact_of",
            numbers={"contact": "px, the distance at which contact begins; 0 where there is none"},
        ),
        Section("loads", "of each constant force which mass it acts on, and its arrow, in the world"),
        Section(
            "muscles",
            "frequency, Hz, and phase of the beat, and of each muscle what swing.js says; or nothing",
        ),
        Section("muscle_colors", "a table, from a muscle at its longest to one at its shortest"),
        Section(
            "resists",
            numbers={
                "medium?": "whether the body is in a medium",
                "ground?": "whether it lies on the ground, seen from above",
            },
        ),
    )


class SecondPlan(Numbers, frozen=True, kw_only=True):
    """The plan of a second body; the positions of its masses are in the frames."""


_MOMENT = {
    "time": "simulated seconds",
    "length_scale": "factor of all rest lengths",
    "angle_shift": "degrees added to all rest angles",
    "time_rest": "what a time in single precision lacks, s",
}


class Frame(Numbers, frozen=True, kw_only=True):
    """The positions of the masses.

    Attributes:
        wall: time at which it was made, s of a monotonic clock.
    """

    wall: float

    sections = (
        Section("moment", numbers={"generation": "of the body", **_MOMENT}),
        Section("positions", "px, x and y of each mass"),
        Section("ghost", "px, of a second body with the same plan"),
        Section("second_moment", "of a second body with a plan of its own: " + ", ".join(_MOMENT)),
        Section("second_positions", "px, x and y of each of its masses"),
    )


class Damage(Numbers, frozen=True, kw_only=True):
    """Yielded and broken springs; sent only when that changes."""

    sections = (
        Section("head", numbers={"generation": "of the body"}),
        Section("broken", "the springs that are broken"),
        Section("set_length", "px by which each rest length has moved for good; empty if none has"),
        Section("set_angle", "degrees by which each rest angle has moved for good; empty if none has"),
        Section("ghost_broken", "the broken springs of a second body with the same plan"),
        Section("second_broken", "as `broken`, of a second body with a plan of its own"),
        Section("second_set_length", "as `set_length`, of that"),
        Section("second_set_angle", "as `set_angle`, of that"),
    )


# ------------------------------------------------------------------------- in a class
class Asking(Struct, frozen=True, kw_only=True):
    """What a class looks at.

    Attributes:
        stop, phase, round: where it is.
        title, do, watch: of the step; empty without one.
        question, choices: empty if nothing is asked.
        right: the right choice, once it may be known; else -1.
        because: why it is right, then.
        predict: simulated time for which the body's place is asked for, s; 0 if it is not.
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
    predict: float
    goal: str
    collects: str


class Given(Struct, frozen=True, kw_only=True):
    """Something that the pupil at a page has given.

    Attributes:
        kind: what it is.
        choice: of a vote; else -1.
        text: of a line, or what was found.
    """

    stop: int
    round: int
    twin: int
    kind: AnswerKind
    choice: int
    text: str


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
        digits: by which another device takes the seat over; empty if it is not to.
        follows: whether the page shows the teacher's body.
        gathered: whether it has to, where it could have its own.
        paused: whether all bodies stand.
        away: whether the teacher is not there.
        on_wall: whether the wall shows something of this pupil's alone.
        elsewhere: what has the seat now: a later page of the same browser, or another device; or empty.
        reached: whether the page's body has reached the step's goal.
    """

    code: str = ""
    problem: str = ""
    name: str = ""
    color: str = ""
    turn: int = 0
    two: bool = False
    hand: bool = False
    types_name: bool = False
    digits: str = ""
    follows: bool = False
    gathered: bool = False
    paused: bool = False
    away: bool = False
    on_wall: bool = False
    elsewhere: Literal["", "page", "device"] = ""
    reached: bool = False
    asking: Asking | None = None
    given: tuple[Given, ...] = ()


class WallLine(Struct, frozen=True, kw_only=True):
    """A line that the teacher has picked out."""

    text: str
    color: str


class Found(Struct, frozen=True, kw_only=True):
    """What one seat found: a point of the class's plot."""

    setting: float
    found: float


class Law(Struct, frozen=True, kw_only=True):
    """The power law, found = factor * setting ** exponent, that the class's points are closest to."""

    factor: float
    exponent: float


class Wall(State, frozen=True, kw_only=True):
    """What the class sees in front; no name is in it.

    Attributes:
        code, address: how one comes in; a QR code of it as an address of a picture.
        seats: how many are here, or have answered what is asked and left.
        answered: how many have answered what is asked.
        bars: votes for each choice, once they are shown; else empty.
        lines: what was picked out.
        alone: whether one prediction is shown alone.
        found: what was handed in, a point a seat; over what, and what it is.
        law: of these points, if it is to be seen.
        doing: how many seats' bodies do what, while each one has their own.
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
    over: str
    law: Law | None
    doing: dict[str, int]


class Predictions(State, frozen=True, kw_only=True):
    """Where the class has said that the masses will be, in the page's world: one body a prediction, without
    names."""

    bodies: tuple[tuple[tuple[float, float], ...], ...] = ()


class Posters(State, frozen=True, kw_only=True):
    """Where the bodies of the seats are, by their numbers: thousandths of the scene's frame from its left and
    upper edge."""

    places: dict[str, tuple[tuple[int, int], ...]]
    springs: tuple[tuple[int, int], ...]


class DeskSeat(Struct, frozen=True, kw_only=True):
    """A seat, as the teacher sees it.

    Attributes:
        here: whether a page of it is connected.
        answered: whether it has given what is asked for.
        doing: what its body does, in a word.
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
    doing: str
    follows: bool
    digits: str


class DeskAnswer(Struct, frozen=True, kw_only=True):
    """An answer, as the teacher sees it.

    Attributes:
        places: of a run that was handed in, where its masses were, as of `Posters`.
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
        over: what the first slider of the step sets: the abscissa of the class's plot.
        law: of the points of that plot; None where they have none.
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
    right: int
    over: str
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


# ------------------------------------------------------------------------- events
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


class Run(Event, frozen=True, kw_only=True):
    """Execute a command of the page's script, see `app.ui.commands`."""

    command: CommandName


class Resumed(Event, frozen=True, kw_only=True):
    """The server has received the saved state."""
