"""One class: who is in it, where its lesson is, and what was predicted, answered and handed in.

Nothing here knows a page, a clock, a folder or a thread. A room is changed by its methods alone, each of
which leaves it consistent, and is a structure that can be written to a file as it is.

Whatever a pupil sends may be forged, so a room checks everything: who says it, where the class is, and
whether it fits what was asked. An answer has an identifier that its page has made up: the page repeats the
answer until the room has it, and the room counts it once.
"""

from __future__ import annotations

import hashlib
import secrets
from collections.abc import Collection, Sequence
from typing import NamedTuple, TypeVar

import msgspec
from msgspec import Struct

import sim
from sim.scene.lesson import Step

from ..words import ENGLISH, say, speaking
from ..words.english import name_of, of
from . import names
from .answers import (
    OWN_BODY,
    SEALED,
    Answer,
    AnyContent,
    Content,
    Line,
    Phase,
    Prediction,
    Refused,
    Vote,
    Work,
    kinds_of,
    sanitize_line,
)

MAX_SEATS = 60
"""Seats of a class."""

MAX_SEATS_PER_VISITOR = 40
"""Seats granted to one visitor of the server, which may be a school that is one address."""

MAX_NAME_LENGTH = 20
"""Letters of a name that a pupil has chosen, where the teacher allows that."""

MAX_ANSWERS = 200
"""Answers of one seat, which no lesson comes near."""

PAIRS_FROM, PAIRS_UP_TO = 0.35, 0.7
"""Parts of the votes that are right between which pupils talk in pairs and are asked again."""

MAX_STOPS = 60
"""Stops of a class."""

_C = TypeVar("_C", bound=Content)


class Seat(Struct):
    """One pupil's page, or two pupils' at one.

    Attributes:
        number: from 1; it does not change.
        token: digest of the secret by which its browser comes back.
        name: one of `names`, or what the pupil chose where that is allowed.
        color: as in "#2f6fb5".
        given: name that the class gave it, if that is another one.
        twins: whether two pupils sit here.
        hand: whether a hand is up.
        removed: whether the teacher has sent it away.
        move: two digits by which another device can take it over, or empty.
        follows: whether it looks at the teacher's body where it could have its own.
        at: index of the stop where it is, in homework.
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
    at: int | msgspec.UnsetType = msgspec.UNSET


class Stop(Struct, frozen=True):
    """One place of the class's plan: a scene, and a step of its lesson if it has one."""

    scene: int
    step: int | None = None


def digest(secret: str) -> str:
    """Return what is stored of a secret."""
    return hashlib.sha256(secret.encode()).hexdigest()


class Place(NamedTuple):
    """Where somebody is: a stop of the plan, and what is done there, for the first or the second time."""

    stop: int
    phase: Phase
    round: int = 0


class Asked(Struct):
    """Something that the class has been asked for.

    Attributes:
        stop, round, phase: where and when.
        shown: whether the answers have been shown since; after that none can be changed.
    """

    stop: int
    round: int
    phase: Phase
    shown: bool = False


class Room(Struct, kw_only=True):
    """A class.

    Attributes:
        code: four letters by which pupils find it.
        key: the teacher's secret, which the terminal shows again after a restart.
        scenes: what it goes through, in order.
        at: index of the present one of `stops`.
        phase: what they do there.
        round: 0 for the first time that this stop asks, 1 for the second.
        asked: all that they have been asked for so far, in order.
        is_open: whether new pupils can come in.
        own_names: whether pupils may choose their names.
        paused: whether all bodies stand.
        seats, answers: by number, and by id.
        gathered: whether all look at the teacher's body where each one could have their own.
        on_wall: the answer that is shown alone on the wall, or empty.
        seat_on_wall: number of the seat whose body the wall shows, or 0.
        law: whether the class's plot shows the law that its points follow.
        until: of homework, the time at which its answers are told, s since 1970; a class has none, and is
            written without.
        told: whether what is right in homework may be known.
        began: when the class left the lobby for the first time, s since 1970; not before it has.
        language: the tag of the teacher's, in which the class names its pupils.
        version: counts the changes.
    """

    code: str
    key: str
    scenes: tuple[sim.Scene, ...]
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
    until: float | msgspec.UnsetType = msgspec.UNSET
    told: bool | msgspec.UnsetType = msgspec.UNSET
    began: float | msgspec.UnsetType = msgspec.UNSET
    language: str = ENGLISH
    version: int = 0

    # --------------------------------------------------------------------- the plan
    @property
    def stops(self) -> tuple[Stop, ...]:
        """All steps of all scenes; a scene without a lesson is one stop."""
        return tuple(
            Stop(number, step)
            for number, scene in enumerate(self.scenes)
            for step in (range(len(scene.lesson.steps)) if scene.lesson else (None,))
        )

    def step_at(self, stop: int) -> Step | None:
        """Return the step of a lesson at a stop; None for a scene without a lesson."""
        at = self.stops[stop]
        lesson = self.scenes[at.scene].lesson
        return lesson.steps[at.step] if lesson is not None and at.step is not None else None

    @property
    def step(self) -> Step | None:
        """The step of a lesson where the class is."""
        return self.step_at(self.at)

    @property
    def is_home(self) -> bool:
        """Whether this is homework: each pupil goes through the stops alone, and answers stay sealed."""
        return bool(self.until)

    @property
    def is_told(self) -> bool:
        """Whether what is right in homework may be known."""
        return bool(self.told)

    @property
    def place(self) -> Place:
        """Where the class is."""
        return Place(self.at, self.phase, self.round)

    def place_of(self, number: int) -> Place:
        """Return where a seat is: with the class, or in homework where it has gone by itself.

        There each stop first asks, and lets the body move once all has been answered.
        """
        seat = self.seats.get(number)
        if not self.is_home or seat is None:
            return self.place
        at = seat.at or 0
        is_open = self._wanted(at, Phase.ASK) <= self._gave(number, at)
        return Place(at, Phase.COLLECT if is_open else Phase.ASK)

    def _wanted(self, stop: int, *phases: Phase) -> set[type[Content]]:
        """What a stop asks of everybody in some phases."""
        step = self.step_at(stop)
        kinds: dict[type[Content], object] = {}
        if step is not None:
            asked = step.question
            kinds = {Vote: asked, Line: asked, Prediction: step.predict, Work: step.collect or step.goal}
        return {kind for kind, wanted in kinds.items() if wanted is not None and kind.phase in phases}

    def _gave(self, number: int, stop: int) -> set[type[Content]]:
        """What a seat has given at a stop."""
        mine = (one for one in self.answers.values() if one.seat == number)
        return {type(one.content) for one in mine if one.stop == stop}

    def done(self, number: int) -> tuple[bool, ...]:
        """Return for each stop whether a seat has given all that it asks for."""
        asked = (Phase.ASK, Phase.EXPLAIN, Phase.COLLECT)
        return tuple(
            self._wanted(stop, *asked) <= self._gave(number, stop) and bool(self._gave(number, stop))
            for stop in range(len(self.stops))
        )

    def walk(self, number: int, stop: int) -> None:
        """Let a seat go to another stop of its homework.

        Raises:
            Refused: there is no such seat or stop, or all are where the class is.
        """
        seat = self._seat(number)
        if not self.is_home:
            raise Refused(say("class-refuse-together"))
        if not 0 <= stop < len(self.stops):
            raise Refused(say("class-refuse-no-home-step"))
        seat.at = stop
        self.version += 1

    def tell(self) -> None:
        """Let all know what is right in the homework; what is answered from now on is late."""
        self.told = True
        self.version += 1

    def may_reveal(self, place: Place) -> bool:
        """Whether the right answer of a question may be known at a place."""
        if self.is_home:
            return self.is_told
        return place.phase in OWN_BODY or place.phase in (Phase.REVEAL, Phase.EXPLAIN)

    @property
    def vote_round(self) -> int:
        """The round whose votes count now: the present one, or else the last in which somebody voted."""
        if self.phase in (Phase.ASK, Phase.RESULTS):
            return self.round
        return 1 if self.given(self.at, 1, Vote) else 0

    @property
    def is_split(self) -> bool:
        """Whether so many have chosen right, and so many have not, that they can convince each other.

        They then talk in pairs and are asked again (Crouch and Mazur 2001, American Journal of Physics 69,
        970); the bounds are theirs.
        """
        step = self.step
        bars = self.bars(self.at, 0)
        if step is None or step.question is None or not sum(bars):
            return False
        return PAIRS_FROM <= bars[step.question.answer] / sum(bars) <= PAIRS_UP_TO

    def order(self, stop: int) -> tuple[tuple[Phase, int], ...]:
        """Return the phases of a stop and their rounds, as a lesson goes through them."""
        step = self.step_at(stop)
        if step is None or (step.question is None and step.predict is None):
            return (Phase.SHOW, 0), (Phase.TRY, 0), (Phase.COLLECT, 0)
        again = ((Phase.ASK, 1), (Phase.RESULTS, 1)) if step.question is not None else ()
        first = (Phase.SHOW, 0), (Phase.ASK, 0), (Phase.RESULTS, 0)
        then = (Phase.RUN, Phase.REVEAL, Phase.EXPLAIN, Phase.TRY, Phase.COLLECT)
        return *first, *again, *((phase, 0) for phase in then)

    @property
    def _collects(self) -> bool:
        """Whether there is something to hand in: of a step, a number or a goal."""
        step = self.step
        return step is None or step.collect is not None or step.goal is not None

    def next(self) -> tuple[int, Phase, int] | None:
        """Return where the class goes next: stop, phase and round; None at the end."""
        if self.phase is Phase.LOBBY:
            return self.at, Phase.SHOW, 0
        order = self.order(self.at)
        after = order.index((self.phase, self.round)) + 1
        if after < len(order) and order[after] == (Phase.ASK, 1) and not self.is_split:
            after += 2
        if after < len(order) and order[after] == (Phase.COLLECT, 0) and not self._collects:
            after += 1
        if after < len(order):
            return self.at, *order[after]
        return (self.at + 1, Phase.SHOW, 0) if self.at + 1 < len(self.stops) else None

    # --------------------------------------------------------------------- the teacher
    def go(self, stop: int, phase: Phase, round: int = 0) -> None:
        """Take the class somewhere. All answers that were sealed so far are shown.

        Raises:
            Refused: there is no such place.
        """
        if phase is Phase.LOBBY:
            stop, round = self.at, 0
        elif not 0 <= stop < len(self.stops) or (phase, round) not in self.order(stop):
            raise Refused(say("class-refuse-no-place"))
        if (stop, phase, round) == (self.at, self.phase, self.round):
            return
        for asked in self.asked:
            asked.shown = asked.shown or asked.phase in SEALED
        self.at, self.phase, self.round = stop, phase, round
        self.on_wall, self.seat_on_wall, self.law, self.gathered = "", 0, False, False
        for seat in self.seats.values():
            seat.follows = False
        if kinds_of(phase) and self._asked(stop, round, phase) is None:
            self.asked.append(Asked(stop, round, phase))
        self.version += 1

    def star(self, id: str, on: bool) -> None:
        """Pick an answer out, or take that back.

        Raises:
            Refused: there is no such answer.
        """
        self.answers[id] = msgspec.structs.replace(self._answer(id), starred=on)
        self.version += 1

    def put_on_wall(self, id: str) -> None:
        """Show an answer alone on the wall, or none ("").

        Raises:
            Refused: there is no such answer, or it is sealed.
        """
        if id and not self._is_shown(self._answer(id)):
            raise Refused(say("class-refuse-sealed"))
        self.on_wall, self.seat_on_wall = id, 0
        self.version += 1

    def put_seat_on_wall(self, number: int) -> None:
        """Show the body of a seat on the wall as it moves, or the teacher's again (0).

        Raises:
            Refused: there is no such seat, or it has no body of its own now.
        """
        if number:
            self._seat(number)
            if self.phase not in OWN_BODY:
                raise Refused(say("class-refuse-no-bodies"))
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
        if self.phase not in OWN_BODY or self.gathered:
            raise Refused(say("class-refuse-gathered"))
        seat.follows = on
        self.version += 1

    def remove(self, number: int) -> None:
        """Close a seat and delete its answers; its browser cannot come in again.

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

    def choose(self, scenes: tuple[sim.Scene, ...]) -> None:
        """Go through other scenes, while nothing has begun.

        Raises:
            Refused: something has been given, or the class has begun.
        """
        if self.phase is not Phase.LOBBY or self.asked or self.answers or self.is_home:
            raise Refused(say("class-refuse-begun"))
        self.scenes, self.at = scenes, 0
        if len(self.stops) > MAX_STOPS:
            raise Refused(say("class-refuse-steps", most=MAX_STOPS, steps=len(self.stops)))
        self.version += 1

    def lower_hands(self) -> None:
        """Take all hands down."""
        for seat in self.seats.values():
            seat.hand = False
        self.version += 1

    # --------------------------------------------------------------------- the pupils
    def enter(self, secret: str, here: Collection[int] | None = None, granted: Collection[int] = ()) -> Seat:
        """Return the seat of a browser: the one that it had, or a new one.

        In a full class a new one replaces a seat where nobody sits and from which nothing was given, so that
        nobody keeps others out by coming in again and again.

        Args:
            secret: of the browser.
            here: numbers of the seats that somebody sits at; None for all.
            granted: numbers of the seats that the same visitor has been given.

        Raises:
            Refused: the class is closed or full, the visitor has enough seats, or the seat was closed.
        """
        if (seat := self._seat_of(secret)) is not None:
            return seat
        if not self.is_open:
            raise Refused(say("class-refuse-closed"))
        if sum(number in self.seats and not self.seats[number].removed for number in granted) >= (
            MAX_SEATS_PER_VISITOR
        ):
            raise Refused(say("class-refuse-network", seats=MAX_SEATS_PER_VISITOR))
        return self._new_seat(secret, here)

    def _seat_of(self, secret: str) -> Seat | None:
        """Return the seat of a browser, if it has one.

        Raises:
            Refused: the seat was closed.
        """
        token = digest(secret)
        seat = next((seat for seat in self.seats.values() if seat.token == token), None)
        if seat is not None and seat.removed:
            raise Refused(say("class-refuse-removed"))
        return seat

    def _new_seat(self, secret: str, here: Collection[int] | None = None) -> Seat:
        """Return a new seat; see `enter`.

        Raises:
            Refused: the class is full.
        """
        if sum(not seat.removed for seat in self.seats.values()) >= MAX_SEATS:
            needed = {answer.seat for answer in self.answers.values()}.union(
                self.seats if here is None else here
            )
            idle = next((n for n, seat in self.seats.items() if n not in needed and not seat.removed), None)
            if idle is None:
                raise Refused(say("class-refuse-full", seats=MAX_SEATS))
            del self.seats[idle]
        number = max(self.seats, default=0) + 1
        with speaking(self.language):
            name, color = names.new_name([seat.given for seat in self.seats.values()])
        seat = self.seats[number] = Seat(number, digest(secret), name, color, name)
        self.version += 1
        return seat

    def rename(self, number: int, wanted: str = "") -> None:
        """Give a seat another of the class's names, or the one that its pupil typed.

        Raises:
            Refused: names cannot be typed in this class, the name is taken, or it has no visible letter.
        """
        seat = self._seat(number)
        taken = [other.name for other in self.seats.values() if other is not seat]
        if not wanted:
            with speaking(self.language):
                seat.given, seat.color = names.new_name([*taken, seat.given])
            seat.name = seat.given
        else:
            name = sanitize_line(wanted, MAX_NAME_LENGTH)
            if not self.own_names:
                raise Refused(say("class-refuse-names"))
            if not name:
                raise Refused(say("class-refuse-no-name"))
            if name.casefold() in (other.casefold() for other in taken):
                raise Refused(say("class-refuse-same-name"))
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
        """Hand the seat with these digits over to another browser.

        The seat that this browser had before is deleted; it must have no answers.

        Raises:
            Refused: no seat has these digits, or the browser's own seat has answers.
        """
        seat = next((seat for seat in self.seats.values() if digits and seat.move == digits), None)
        if seat is None:
            raise Refused(say("class-refuse-digits"))
        token = digest(secret)
        for other in list(self.seats.values()):
            if other.token == token and other is not seat:
                if any(answer.seat == other.number for answer in self.answers.values()):
                    raise Refused(say("class-refuse-own-answers"))
                del self.seats[other.number]
        seat.token, seat.move = token, ""
        self.version += 1
        return seat

    def take(self, number: int, answer: Answer) -> bool:
        """Take an answer, once.

        Args:
            number: of the seat that gives it.
            answer: as it arrived; its own `seat` is ignored.

        Returns:
            whether it counts; False if the room has it already, or a later one to the same.

        Raises:
            Refused: the class has not been asked for it, or it fits no question; nothing is changed.
        """
        seat = self._seat(number)
        answer = msgspec.structs.replace(answer, seat=number)
        known = self.answers.get(answer.id)
        if known is not None:
            if known.seat != number:
                raise Refused(say("class-refuse-not-yours"))
            return False
        if answer.twin and not seat.twins:
            raise Refused(say("class-refuse-one"))
        if not 0 <= answer.stop < len(self.stops):
            raise Refused(say("class-refuse-no-step"))
        asked = self._asked(answer.stop, answer.round, answer.content.phase)
        if asked is None:
            raise Refused(say("class-refuse-not-asked"))
        content = self._checked(answer)
        previous = self.previous(answer)
        if previous is not None and previous.turn >= answer.turn:
            return False
        if previous is not None and self.is_home and asked.phase is Phase.ASK:
            raise Refused(say("class-refuse-has-run"))
        if previous is not None and asked.shown:
            raise Refused(say("class-refuse-shown"))
        if previous is None and sum(a.seat == number for a in self.answers.values()) >= MAX_ANSWERS:
            raise Refused(say("class-refuse-answers", most=MAX_ANSWERS))
        self._replace(
            previous, msgspec.structs.replace(answer, content=content, late=asked.shown, starred=False)
        )
        self.version += 1
        return True

    def import_answers(self, secret: str, name: str, answers: Sequence[Answer]) -> tuple[Seat, int]:
        """Take answers that were given without a page of this class, which the teacher brings.

        They get a seat of their own, even while the door is closed. They count as late, whether or not the
        class has been asked already, and are taken all or not at all.

        Args:
            secret: by which their seat is known again.
            name: typed where they were given; empty for one of the class's.
            answers: as they arrived; their own `seat` is ignored.

        Returns:
            the seat, and how many of the answers are new.

        Raises:
            Refused: one of them fits no question of this class; nothing is changed.
        """
        answers = [msgspec.structs.replace(answer, content=self._checked(answer)) for answer in answers]
        if (seat := self._seat_of(secret)) is None:
            seat = self._new_seat(secret)
            seat.name = self._free_name(sanitize_line(name, MAX_NAME_LENGTH)) or seat.name
        new = 0
        for answer in answers:
            answer = msgspec.structs.replace(answer, seat=seat.number, late=True)
            previous = self.previous(answer)
            if answer.id not in self.answers and (previous is None or previous.turn < answer.turn):
                self._replace(previous, answer)
                new += 1
        self.version += 1
        return seat, new

    def _free_name(self, wanted: str) -> str:
        """Return a name that nobody has, numbered if it is taken; empty for an empty one."""
        taken = {seat.name.casefold() for seat in self.seats.values()}
        if not wanted or wanted.casefold() not in taken:
            return wanted
        numbered = (f"{wanted[: MAX_NAME_LENGTH - 4]} {i}" for i in range(2, MAX_SEATS + 3))
        return next(name for name in numbered if name.casefold() not in taken)

    def previous(self, answer: Answer) -> Answer | None:
        """Return the answer to the same that the room has."""
        mine = (other for other in self.answers.values() if other.seat == answer.seat)
        return next((other for other in mine if other.slot == answer.slot), None)

    def _replace(self, previous: Answer | None, answer: Answer) -> None:
        if previous is not None:
            del self.answers[previous.id]
        self.answers[answer.id] = answer

    # --------------------------------------------------------------------- queries
    def given(self, stop: int, round: int, kind: type[_C]) -> list[tuple[Answer, _C]]:
        """Return the answers of a kind to a stop, in order of arrival, each with what it says."""
        return [
            (answer, answer.content)
            for answer in self.answers.values()
            if (answer.stop, answer.round) == (stop, round) and isinstance(answer.content, kind)
        ]

    def answered(self) -> set[int]:
        """Return the numbers of the seats that have given what is asked for now.

        Where there is a question that is an answer, with a prediction or without.
        """
        step = self.step_at(self.at)
        is_question = self.phase is Phase.ASK and step is not None and step.question is not None
        kinds = (Vote,) if is_question else kinds_of(self.phase)
        return {answer.seat for kind in kinds for answer, _ in self.given(self.at, self.round, kind)}

    def bars(self, stop: int, round: int) -> list[int]:
        """Return how many have voted for each choice."""
        step = self.step_at(stop)
        counts = [0] * (len(step.question.choices) if step is not None and step.question is not None else 0)
        for _, vote in self.given(stop, round, Vote):
            counts[vote.choice] += 1
        return counts

    def title(self, stop: int) -> str:
        """Return the title of a stop."""
        step, scene = self.step_at(stop), self.scenes[self.stops[stop].scene]
        return of(step.title) if step is not None else name_of(scene)

    def _seat(self, number: int) -> Seat:
        seat = self.seats.get(number)
        if seat is None or seat.removed:
            raise Refused(say("class-refuse-no-seat"))
        return seat

    def _answer(self, id: str) -> Answer:
        if id not in self.answers:
            raise Refused(say("class-refuse-no-answer"))
        return self.answers[id]

    def _asked(self, stop: int, round: int, phase: Phase) -> Asked | None:
        if self.is_home:
            return Asked(stop, 0, phase, self.is_told) if round == 0 else None
        key = (stop, round, phase)
        return next((asked for asked in self.asked if (asked.stop, asked.round, asked.phase) == key), None)

    def _is_shown(self, answer: Answer) -> bool:
        asked = self._asked(answer.stop, answer.round, answer.content.phase)
        return asked is not None and (asked.phase not in SEALED or asked.shown)

    def _checked(self, answer: Answer) -> AnyContent:
        return answer.content.checked(self.scenes[self.stops[answer.stop].scene], self.step_at(answer.stop))
