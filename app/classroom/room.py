"""One class: who is in it, where its lesson is, and what was predicted, answered and handed in.

Nothing here knows a page, a clock, a folder or a thread. A room is changed by its methods alone, each of
which leaves it whole, and is a structure that can be written to a file as it is.

Whatever a pupil sends may be forged, so a room looks at everything: who says it, where the class is, and
whether it fits what was asked. An answer carries an identifier that its page has made up: the page says it
again until the room has it, and the room counts it once.
"""

from __future__ import annotations

import enum
import hashlib
import math
import secrets
import unicodedata
from collections.abc import Collection, Sequence
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

import sim
from sim.scene.lesson import Step
from sim.scene.types import Damage

from . import names

MAX_SEATS = 60
"""Seats of a class."""

MAX_OF_ONE = 40
"""Seats given to one visitor of the server, which may be a school that is one address."""

MAX_LETTERS = 140
"""Letters of a line that a pupil writes."""

MAX_NAME = 20
"""Letters of a name that a pupil has chosen, where the teacher allows that."""

MAX_MARKS = 3
"""Marks above and below one letter; no language has more, and heaps of them cover other lines."""

MAX_ANSWERS = 200
"""Answers of one seat, which no lesson comes near."""

MAX_STOPS = 60
"""Stops of a class."""

Id = Annotated[str, Meta(pattern=r"^[0-9a-f]{16}$")]
FARTHEST = 1e7
"""Coordinate of a prediction, in the scene's units."""

Coordinate = Annotated[float, Meta(ge=-FARTHEST, le=FARTHEST)]


class Phase(enum.Enum):
    """What the class is doing."""

    LOBBY = "lobby"
    """They come in."""
    SHOW = "show"
    """All look at the teacher's body."""
    ASK = "ask"
    """Each one predicts, unseen by the others."""
    RESULTS = "results"
    """All look at what was predicted."""
    RUN = "run"
    """All see the same run."""
    EXPLAIN = "explain"
    """Each one writes a line."""
    TRY = "try"
    """Each one has a body of their own."""
    COLLECT = "collect"
    """Each one hands in what they found, with a body of their own."""


FREE = frozenset((Phase.TRY, Phase.COLLECT))
"""Phases in which each one has a body of their own; in the others all have the teacher's."""


# ------------------------------------------------------------------------- what a pupil gives
class Content(Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag=str.lower):
    """What an answer says."""


class Vote(Content, frozen=True):
    """One of the choices of a question, counted from 0."""

    choice: Annotated[int, Meta(ge=0, le=4)]


class Ghost(Content, frozen=True):
    """Where each mass will be, in the scene's units."""

    points: Annotated[tuple[tuple[Coordinate, Coordinate], ...], Meta(min_length=1, max_length=2000)]


class Line(Content, frozen=True):
    """An explanation, as text."""

    text: Annotated[str, Meta(min_length=1, max_length=MAX_LETTERS)]


class Work(Content, frozen=True):
    """What a pupil hands in: the run, and what came out of it.

    Attributes:
        log: name of the file of the run's log in the class's folder; empty if it could not be kept.
        found: the reading that the step collects; None without one.
        setting: the first number that the step has a slider for: the abscissa of the class's plot.
        reached: whether the step's goal was reached; None without a goal.
        doubt: why the log cannot be what a pupil did; empty if it can.
        points: where the masses were, and
        damage: what had yielded and broken, for a picture; empty where a mass was nowhere.
    """

    log: Annotated[str, Meta(max_length=40)] = ""
    found: float | None = None
    setting: float | None = None
    reached: bool | None = None
    doubt: str = ""
    points: tuple[tuple[float, float], ...] = ()
    damage: Damage | None = None


class Answer(Struct, frozen=True):
    """Something that a pupil gave.

    Attributes:
        id: made up by the pupil's page.
        turn: counts what that page gave; of two answers to the same, the one with the larger turn counts,
            whichever comes first.
        seat: number of the seat.
        twin: 0, or 1 for the second of two pupils at one seat.
        stop: the stop of the class that it is for.
        round: 0 for the first time that this is asked, 1 for the second.
        content: what it says.
        late: whether it came after the others' had been shown.
        starred: whether the teacher has picked it out.
    """

    id: Id
    turn: Annotated[int, Meta(ge=0, le=1_000_000)]
    seat: int
    twin: int
    stop: int
    round: int
    content: Vote | Ghost | Line | Work
    late: bool = False
    starred: bool = False

    @property
    def place(self) -> tuple[int, int, int, int, str]:
        """What it is the answer to; another one to the same takes its place."""
        return self.seat, self.twin, self.stop, self.round, type(self.content).__name__


class Seat(Struct):
    """One pupil's page, or two pupils' at one.

    Attributes:
        number: from 1; it does not change.
        token: digest of the secret by which its browser comes back.
        name: one of `names`, or what the pupil chose where that is allowed.
        color: as in "#2f6fb5".
        twins: whether two pupils sit here.
        hand: whether a hand is up.
        removed: whether the teacher has sent it away.
        given: name that the class gave it, if that is another one.
        move: two digits by which another device can take it over, or empty.
        follows: whether it looks at the teacher's body where it could have its own.
    """

    number: int
    token: str
    name: str
    color: str
    given: str
    twins: bool = False
    hand: bool = False
    removed: bool = False
    move: str = ""
    follows: bool = False


class Stop(Struct, frozen=True):
    """One place of the class's plan: a scene, and a step of its lesson if it has one."""

    scene: int
    step: int | None = None


class Refused(Exception):
    """What was asked for cannot be; the message is a sentence for the one who asked."""


def digest(secret: str) -> str:
    """What is kept of a secret."""
    return hashlib.sha256(secret.encode()).hexdigest()


def plain(text: str, most: int) -> str:
    """A text that a pupil typed, on one line and without what cannot be seen or covers the lines around it.

    Args:
        most: letters that are kept.
    """
    seen, marks = "", 0
    for c in unicodedata.normalize("NFC", text):
        kind = unicodedata.category(c)[0]
        marks = marks + 1 if kind == "M" else 0
        if marks <= MAX_MARKS:
            seen += " " if kind in "CZ" else c
    return " ".join(seen.split())[:most].strip()


class Asked(Struct):
    """Something that the class has been asked for.

    Attributes:
        stop, round, phase: where and when.
        shown: whether the answers have been shown since; then none is changed any more.
    """

    stop: int
    round: int
    phase: Phase
    shown: bool = False


PHASE_OF: dict[type[Content], Phase] = {
    Vote: Phase.ASK,
    Ghost: Phase.ASK,
    Line: Phase.EXPLAIN,
    Work: Phase.COLLECT,
}
"""When what is asked for."""

SEALED = frozenset((Phase.ASK, Phase.EXPLAIN))
"""Phases whose answers nobody else sees before the next phase."""


class Room(Struct, kw_only=True):
    """A class.

    Attributes:
        code: four letters by which pupils find it.
        key: the teacher's secret, which the terminal shows again after a restart.
        scenes: what it goes through, in order.
        pushed: how many of these, the last ones, were brought to the class while it went on.
        at: index of the present one of `stops`.
        phase: what they do there.
        round: 0 for the first time that this stop asks, 1 for the second.
        asked: what they have been asked for until now, in order.
        is_open: whether new pupils can come in.
        own_names: whether pupils may choose their names.
        paused: whether all bodies stand.
        seats, answers: by number, and by id.
        gathered: whether all look at the teacher's body where each one could have their own.
        on_wall: the answer that is shown alone on the wall, or empty.
        seat_on_wall: number of the seat whose body the wall shows, or 0.
        law: whether the class's plot has the law that its points follow.
        version: counts the changes.
    """

    code: str
    key: str
    scenes: tuple[sim.Scene, ...]
    pushed: int = 0
    at: int = 0
    phase: Phase = Phase.LOBBY
    round: int = 0
    asked: list[Asked] = msgspec.field(default_factory=list)
    is_open: bool = True
    own_names: bool = False
    paused: bool = False
    seats: dict[int, Seat] = msgspec.field(default_factory=dict)
    answers: dict[str, Answer] = msgspec.field(default_factory=dict)
    gathered: bool = False
    on_wall: str = ""
    seat_on_wall: int = 0
    law: bool = False
    version: int = 0

    # --------------------------------------------------------------------- the plan
    @property
    def begun_with(self) -> tuple[sim.Scene, ...]:
        """The scenes that it went through from the first."""
        return self.scenes[: len(self.scenes) - self.pushed]

    @property
    def stops(self) -> tuple[Stop, ...]:
        """All steps of all scenes; a scene without a lesson is one stop."""
        return tuple(
            Stop(number, step)
            for number, scene in enumerate(self.scenes)
            for step in (range(len(scene.lesson.steps)) if scene.lesson else (None,))
        )

    def step_at(self, stop: int) -> Step | None:
        """The step of a lesson that a stop is; None for a scene without one."""
        at = self.stops[stop]
        lesson = self.scenes[at.scene].lesson
        return lesson.steps[at.step] if lesson is not None and at.step is not None else None

    @property
    def step(self) -> Step | None:
        """The step of a lesson where the class is."""
        return self.step_at(self.at)

    @property
    def has_told(self) -> bool:
        """Whether the right answer of the present question may be known."""
        return self.phase in FREE or (self.phase is Phase.RESULTS and self.round > 0)

    @property
    def vote_round(self) -> int:
        """The round of the votes that count now: of the present one, or the last that was asked for here."""
        if self.phase in (Phase.ASK, Phase.RESULTS):
            return self.round
        asked = [one.round for one in self.asked if one.stop == self.at and one.phase is Phase.ASK]
        return max(asked, default=0)

    def order(self, stop: int) -> tuple[tuple[Phase, int], ...]:
        """The phases of a stop and their rounds, as a lesson goes through them."""
        step = self.step_at(stop)
        if step is None or (step.question is None and step.predict is None):
            return (Phase.SHOW, 0), (Phase.TRY, 0), (Phase.COLLECT, 0)
        again = ((Phase.ASK, 1), (Phase.RESULTS, 1)) if step.question is not None else ()
        first = ((Phase.SHOW, 0), (Phase.ASK, 0), (Phase.RESULTS, 0), (Phase.RUN, 0), (Phase.EXPLAIN, 0))
        return *first, *again, (Phase.TRY, 0), (Phase.COLLECT, 0)

    def next(self) -> tuple[int, Phase, int] | None:
        """Where the class goes next: stop, phase and round; None at the end."""
        if self.phase is Phase.LOBBY:
            return self.at, Phase.SHOW, 0
        order = self.order(self.at)
        after = order.index((self.phase, self.round)) + 1
        if after < len(order):
            return self.at, *order[after]
        return (self.at + 1, Phase.SHOW, 0) if self.at + 1 < len(self.stops) else None

    # --------------------------------------------------------------------- the teacher
    def go(self, stop: int, phase: Phase, round: int = 0) -> None:
        """Take the class somewhere. What was asked for and sealed until now is shown.

        Raises:
            Refused: there is no such place.
        """
        if phase is Phase.LOBBY:
            stop, round = self.at, 0
        elif not 0 <= stop < len(self.stops) or (phase, round) not in self.order(stop):
            raise Refused("The class has no such place.")
        if (stop, phase, round) == (self.at, self.phase, self.round):
            return
        for asked in self.asked:
            asked.shown = asked.shown or asked.phase in SEALED
        self.at, self.phase, self.round = stop, phase, round
        self.on_wall, self.seat_on_wall, self.law, self.gathered = "", 0, False, False
        for seat in self.seats.values():
            seat.follows = False
        if phase in PHASE_OF.values() and self._asked(stop, round, phase) is None:
            self.asked.append(Asked(stop, round, phase))
        self.version += 1

    def push(self, scene: sim.Scene) -> None:
        """Bring a scene to all, as another stop after the others; they look at it.

        Raises:
            Refused: the class has too many stops.
        """
        if len(self.stops) >= MAX_STOPS:
            raise Refused(f"A class has {MAX_STOPS} stops at most.")
        whole = msgspec.structs.replace(scene, lesson=None)
        self.scenes, self.pushed = (*self.scenes, whole), self.pushed + 1
        self.go(len(self.stops) - 1, Phase.SHOW)

    def star(self, id: str, on: bool) -> None:
        """Pick an answer out, or no longer.

        Raises:
            Refused: there is no such answer.
        """
        self.answers[id] = msgspec.structs.replace(self._answer(id), starred=on)
        self.version += 1

    def put_on_wall(self, id: str) -> None:
        """Show an answer alone on the wall; none for "".

        Raises:
            Refused: there is no such answer, or it is sealed.
        """
        if id and self._is_sealed(self._answer(id)):
            raise Refused("Nobody sees the answers before all are shown.")
        self.on_wall, self.seat_on_wall = id, 0
        self.version += 1

    def put_seat_on_wall(self, number: int) -> None:
        """Show the body of a seat on the wall, as it moves; the teacher's again for 0.

        Raises:
            Refused: there is no such seat, or it has no body of its own now.
        """
        if number:
            self._seat(number)
            if self.phase not in FREE:
                raise Refused("Seats have no bodies of their own now.")
        self.on_wall, self.seat_on_wall = "", number
        self.version += 1

    def is_on_wall(self, number: int) -> bool:
        """Whether the wall shows something of a seat alone."""
        shown = self.answers.get(self.on_wall)
        return number == self.seat_on_wall or (shown is not None and shown.seat == number)

    def gather(self, on: bool) -> None:
        """Have all look at the teacher's body, or give each one theirs back."""
        self.gathered = on
        if not on:
            for seat in self.seats.values():
                seat.follows = False
        self.version += 1

    def follow(self, number: int, on: bool) -> None:
        """Have a seat look at the teacher's body where it could have its own, or at its own again.

        Raises:
            Refused: there is no such seat, or all look at the teacher's body.
        """
        seat = self._seat(number)
        if self.phase not in FREE or self.gathered:
            raise Refused("All look at the teacher's now.")
        seat.follows = on
        self.version += 1

    def remove(self, number: int) -> None:
        """Send a seat away, with all that it gave; its browser does not come in again.

        Raises:
            Refused: there is no such seat.
        """
        seat = self._seat(number)
        seat.removed, seat.hand, seat.move = True, False, ""
        if self.seat_on_wall == number:
            self.seat_on_wall = 0
        self.answers = {id: answer for id, answer in self.answers.items() if answer.seat != number}
        if self.on_wall not in self.answers:
            self.on_wall = ""
        self.version += 1

    # --------------------------------------------------------------------- the pupils
    def enter(self, secret: str, here: Collection[int] | None = None, given: Collection[int] = ()) -> Seat:
        """The seat of a browser: the one that it had, or a new one.

        In a full class a new one takes the place of one where nobody sits and that gave nothing: nobody keeps
        others out by coming in again and again.

        Args:
            secret: of the browser.
            here: numbers of the seats that somebody sits at; None for all.
            given: numbers of the seats that were given to the same visitor.

        Raises:
            Refused: the class is closed or full, the visitor has enough seats, or the seat was sent away.
        """
        token = digest(secret)
        for seat in self.seats.values():
            if seat.token == token:
                if seat.removed:
                    raise Refused("The teacher has closed this seat.")
                return seat
        if not self.is_open:
            raise Refused("The class has begun; ask your teacher to open the door.")
        if sum(number in self.seats and not self.seats[number].removed for number in given) >= MAX_OF_ONE:
            raise Refused(
                f"Your network has {MAX_OF_ONE} seats, as many as one gets; your teacher can remove some."
            )
        return self._new_seat(token, here)

    def _new_seat(self, token: str, here: Collection[int] | None) -> Seat:
        """A new seat; see `enter`.

        Raises:
            Refused: the class is full.
        """
        if sum(not seat.removed for seat in self.seats.values()) >= MAX_SEATS:
            needed = {answer.seat for answer in self.answers.values()} | set(
                self.seats if here is None else here
            )
            idle = next((n for n, seat in self.seats.items() if n not in needed and not seat.removed), None)
            if idle is None:
                raise Refused(f"The class is full: it has {MAX_SEATS} seats.")
            del self.seats[idle]
        number = max(self.seats, default=0) + 1
        name = names.new_name([seat.given for seat in self.seats.values()])
        seat = Seat(number, token, name, names.color_of(name), name)
        self.seats[number] = seat
        self.version += 1
        return seat

    def rename(self, number: int, wanted: str = "") -> None:
        """Give a seat another name of the class's, or the one that its pupil typed.

        Raises:
            Refused: names cannot be typed in this class, somebody has that one, or nothing of it can be seen.
        """
        seat = self._seat(number)
        taken = [other.name for other in self.seats.values() if other is not seat]
        if not wanted:
            seat.given = seat.name = names.new_name([*taken, seat.given])
            seat.color = names.color_of(seat.given)
        else:
            name = plain(wanted, MAX_NAME)
            if not self.own_names:
                raise Refused("In this class names are given.")
            if not name:
                raise Refused("A name needs a letter.")
            if name.casefold() in (other.casefold() for other in taken):
                raise Refused("Somebody has that name.")
            seat.name = name
        self.version += 1

    def offer_move(self, number: int) -> None:
        """Let another device take a seat over, by two digits that no other seat offers.

        Raises:
            Refused: there is no such seat.
        """
        seat = self._seat(number)
        taken = {other.move for other in self.seats.values()}
        seat.move = secrets.choice([text for i in range(100) if (text := f"{i:02}") not in taken])
        self.version += 1

    def move(self, secret: str, digits: str) -> Seat:
        """Have the seat that offers itself by these digits be another browser's.

        The seat that this browser had before goes; it must be one that nothing was given from.

        Raises:
            Refused: no seat offers itself by them.
        """
        seat = next((seat for seat in self.seats.values() if digits and seat.move == digits), None)
        if seat is None:
            raise Refused("No seat has that number now.")
        token = digest(secret)
        for other in list(self.seats.values()):
            if other.token == token and other is not seat:
                if any(answer.seat == other.number for answer in self.answers.values()):
                    raise Refused("This device has a seat with answers of its own.")
                del self.seats[other.number]
        seat.token, seat.move = token, ""
        self.version += 1
        return seat

    def take(self, number: int, answer: Answer) -> bool:
        """Take an answer, once.

        Args:
            number: of the seat that gives it.
            answer: as it came; whose it says that it is does not count.

        Returns:
            whether it counts; False for one that the room has, or has a later one for.

        Raises:
            Refused: it is none that this class could give here; nothing is changed.
        """
        seat = self._seat(number)
        answer = msgspec.structs.replace(answer, seat=number)
        known = self.answers.get(answer.id)
        if known is not None:
            if known.seat != number:
                raise Refused("That answer is somebody else's.")
            return False
        if answer.twin and not seat.twins:
            raise Refused("Only one sits here.")
        if not 0 <= answer.stop < len(self.stops):
            raise Refused("The class has no such step.")
        asked = self._asked(answer.stop, answer.round, PHASE_OF[type(answer.content)])
        if asked is None:
            raise Refused("The class has not been asked for that.")
        content = self._fitting(answer)
        before = self.before(answer)
        if before is not None and before.turn >= answer.turn:
            return False
        if before is not None and asked.shown:
            raise Refused("The answers have been shown; yours stays as it was.")
        if before is None and sum(a.seat == number for a in self.answers.values()) >= MAX_ANSWERS:
            raise Refused(f"A seat can give {MAX_ANSWERS} answers.")
        if before is not None:
            del self.answers[before.id]
        taken = msgspec.structs.replace(answer, content=content, late=asked.shown, starred=False)
        self.answers[answer.id] = taken
        self.version += 1
        return True

    def take_brought(self, secret: str, name: str, answers: Sequence[Answer]) -> tuple[Seat, int]:
        """Take answers that the teacher brings, since they were given without a page of this class.

        They have a seat of their own, also where the door is closed. They are late, whether the class has
        been asked already or not yet, and are taken all or not at all.

        Args:
            secret: by which their seat is known again.
            name: that was typed where they were given; empty for one of the class's.
            answers: as they came; whose they say that they are does not count.

        Returns:
            the seat, and how many of the answers count from now on.

        Raises:
            Refused: this class could not be given one of them; nothing is changed.
        """
        answers = [msgspec.structs.replace(answer, content=self._fitting(answer)) for answer in answers]
        token = digest(secret)
        seat = next((seat for seat in self.seats.values() if seat.token == token), None)
        if seat is not None and seat.removed:
            raise Refused("The teacher has closed this seat.")
        if seat is None:
            seat = self._new_seat(token, None)
            seat.name = self._free_name(plain(name, MAX_NAME)) or seat.name
        new = 0
        for answer in answers:
            answer = msgspec.structs.replace(answer, seat=seat.number, late=True)
            before = self.before(answer)
            if answer.id in self.answers or (before is not None and before.turn >= answer.turn):
                continue
            if before is not None:
                del self.answers[before.id]
            self.answers[answer.id] = answer
            new += 1
        self.version += 1
        return seat, new

    def _free_name(self, wanted: str) -> str:
        """A name that nobody has, with a number where somebody has it; empty for an empty one."""
        taken = {seat.name.casefold() for seat in self.seats.values()}
        if not wanted or wanted.casefold() not in taken:
            return wanted
        numbered = (f"{wanted[: MAX_NAME - 4]} {i}" for i in range(2, MAX_SEATS + 3))
        return next(name for name in numbered if name.casefold() not in taken)

    def before(self, answer: Answer) -> Answer | None:
        """The answer whose place another one takes."""
        mine = (other for other in self.answers.values() if other.seat == answer.seat)
        return next((other for other in mine if other.place == answer.place), None)

    # --------------------------------------------------------------------- what there is
    def given(self, stop: int, round: int, kind: type[Content]) -> list[Answer]:
        """The answers of a kind to a stop, in the order in which they came."""
        return [
            answer
            for answer in self.answers.values()
            if (answer.stop, answer.round) == (stop, round) and isinstance(answer.content, kind)
        ]

    def bars(self, stop: int, round: int) -> list[int]:
        """How many have voted for each choice."""
        step = self.step_at(stop)
        counts = [0] * (len(step.question.choices) if step is not None and step.question is not None else 0)
        for answer in self.given(stop, round, Vote):
            if isinstance(answer.content, Vote):
                counts[answer.content.choice] += 1
        return counts

    def _seat(self, number: int) -> Seat:
        seat = self.seats.get(number)
        if seat is None or seat.removed:
            raise Refused("There is no such seat.")
        return seat

    def _answer(self, id: str) -> Answer:
        if id not in self.answers:
            raise Refused("There is no such answer.")
        return self.answers[id]

    def _asked(self, stop: int, round: int, phase: Phase) -> Asked | None:
        key = (stop, round, phase)
        return next((asked for asked in self.asked if (asked.stop, asked.round, asked.phase) == key), None)

    def _is_sealed(self, answer: Answer) -> bool:
        asked = self._asked(answer.stop, answer.round, PHASE_OF[type(answer.content)])
        return asked is None or (asked.phase in SEALED and not asked.shown)

    def _fitting(self, answer: Answer) -> Vote | Ghost | Line | Work:
        """What an answer says, if it is one to what its stop asks for.

        Raises:
            Refused: it is not.
        """
        step, content = self.step_at(answer.stop), answer.content
        match content:
            case Vote(choice):
                if step is None or step.question is None or not 0 <= choice < len(step.question.choices):
                    raise Refused("The question has no such choice.")
            case Ghost(points):
                masses = len(self.scenes[self.stops[answer.stop].scene].masses)
                if step is None or step.predict is None or len(points) != masses:
                    raise Refused("That is no place for this body.")
                # What is on the disk is read by the same bounds, which NaN is not within either.
                if not all(-FARTHEST <= c <= FARTHEST for point in points for c in point):
                    raise Refused("That is no place for this body.")
            case Line(text):
                if not (text := plain(text, MAX_LETTERS)):
                    raise Refused("A line needs a letter.")
                return Line(text)
            case Work(found=found, setting=setting, points=points):
                # A body that has exploded may be handed in, but JSON has no NaN.
                finite = all(math.isfinite(c) for point in points for c in point)
                return msgspec.structs.replace(
                    content,
                    found=found if found is not None and math.isfinite(found) else None,
                    setting=setting if setting is not None and math.isfinite(setting) else None,
                    points=points if finite else (),
                )
        return content
