"""A pupil's page in a class."""

from __future__ import annotations

from collections import deque

import msgspec
import numpy as np
import viser

import sim
from app.classroom.judge import GoalWatch, Meter
from app.classroom.live import Class, Doing, Front, Word
from app.classroom.room import FREE, MAX_ANSWERS, Answer, Ghost, Line, Refused, Vote, Work, digest
from app.classroom.room import Seat as SeatOfRoom
from sim.errors import InputError, SettingError
from sim.scene.lesson import Step
from sim.settings import CHOICES, setting_of

from ...session import commands
from ...session.session import Session
from ...stage.sketch import Mapping
from ...ui.controls import Controls
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.messages import OwnBody
from ...wire.to_page import Given, Seat, Taken
from .role import NOTHING, ClassRole, asking, kind_of, places_of, predictions, text_of

_ALWAYS = (from_page.InSeat, from_page.Who, from_page.Unread)


MAX_TRIES = 5
"""Pairs of digits that one page can try, of a hundred, to take a seat over."""

HAND_IN_EVERY = 1.0
"""Seconds between two runs that one page hands in: each is written, and judged by doing it again."""

LOOK_EVERY = 0.5
"""Seconds between two looks at what a pupil's body does."""


class SeatRole(ClassRole):
    """One pupil's page; of several pages of one browser, the one that came last has the seat.

    Args:
        klass: the class.
        mail: to the page's script.
        visitor: whose page it is, of those that the server tells from each other; "" if nobody can tell.
    """

    def __init__(self, klass: Class, mail: Mail, visitor: str = "") -> None:
        super().__init__(klass, mail)
        self._visitor = visitor
        self._secret = ""
        self._number = 0
        self._problem = ""
        self._stop = -1
        self._paused = False
        self._session: Session | None = None
        self._unwritten: deque[tuple[int, str]] = deque(maxlen=MAX_ANSWERS)
        self._hand_in_due = 0.0
        self._audience: set[viser.ClientHandle] = set()  # that see its body on the wall
        self._tries = 0
        self._watch: GoalWatch | None = None
        self._meter: Meter | None = None
        self._begun = -1
        self._reached = self._touched = False
        self._found: float | None = None
        self._look_due = 0.0

    @property
    def seat(self) -> SeatOfRoom | None:
        """Its seat, unless it has none or another page has it now."""
        seat = self.room.seats.get(self._number)
        has = seat is not None and not seat.removed and self.klass.pupils.get(self._number) is self
        return seat if has else None

    @property
    def front(self) -> Front | None:
        seat, room = self.seat, self.room
        if seat is not None and room.phase in FREE and not room.gathered and not seat.follows:
            return None
        return self.klass.front

    @property
    def controls(self) -> Controls | None:
        if self.front is not None or self.seat is None or self.room.phase not in FREE:
            return NOTHING
        step = self.room.step
        return Controls(("play", *(step.controls if step is not None else ())))

    def allows(self, said: from_page.FromPage) -> bool:
        return isinstance(said, _ALWAYS) or (self.front is None and isinstance(said, OwnBody))

    def introduce(self, who: from_page.Who, session: Session) -> None:
        # One page is one browser's, and takes no seat after seat.
        if self._secret in ("", who.visitor):
            self._session, self._secret = session, who.visitor
            self._enter()

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        try:
            match said:
                case from_page.TakeOver(digits):
                    self._tries += 1
                    if self._tries > MAX_TRIES:
                        raise Refused("These were too many tries; reload the page to go on.")
                    self._sit(self.room.move(self._secret, digits))
                case from_page.Give():
                    self._give(said)
                case from_page.RaiseHand(up):
                    self._of_room().hand = up
                    self.room.version += 1
                case from_page.NewName(wanted):
                    self.room.rename(self._of_room().number, wanted)
                case from_page.SitTogether(two):
                    self._of_room().twins = two
                    self.room.version += 1
                case from_page.LeaveBy():
                    self.room.offer_move(self._of_room().number)
                case from_page.Follow(on):
                    self.room.follow(self._of_room().number, on)
        except Refused as error:
            ids = (said.id,) if isinstance(said, from_page.Give) else ()
            self._mail.send(Taken(ids=ids, refused=str(error)))

    def frame(self, session: Session) -> None:
        if self._tell_end():
            return
        self.klass.tend()
        ready = tuple(id for version, id in self._unwritten if version <= self.klass.written)
        if ready:
            left = [one for one in self._unwritten if one[1] not in ready]
            self._unwritten = deque(left, maxlen=MAX_ANSWERS)
            self._mail.send(Taken(ids=ready))
        if self.seat is not None and self.front is None:
            if self._stop != self.room.at:
                if (body := self.klass.body(self._number)) is not None:
                    self._stop = self.room.at
                    session.post(commands.Resume(body, None))
                else:
                    self.begin()
            self._look(session)
            if self.room.seat_on_wall == self._number:
                self.klass.lent = self._shown(session, self.klass.lent, self._audience)
            if self._paused != self.room.paused:
                self._paused = self.room.paused
                session.post(commands.Play(not self._paused))
        if self._is_new(self.seat is None, self._problem, self._reached):
            self._mail.send(self._state())
            self._mail.send(predictions(self.klass))

    def keep(self, keepsake: bytes) -> bool:
        if self.seat is not None and self._stop == self.room.at:
            self.klass.keep(self._number, keepsake)
        return True

    def leave(self) -> None:
        if self.klass.pupils.get(self._number) is self:
            del self.klass.pupils[self._number]
            self.klass.doing.pop(self._number, None)
            if (seat := self.room.seats.get(self._number)) is not None:  # none after the class's end
                seat.hand = False

    # --------------------------------------------------------------------- the teacher's
    def begin(self) -> None:
        self._stop = self.room.at
        try:
            scene = self.klass.scene(self.room.at)
        except SettingError as error:
            self._mail.send(Taken(ids=(), refused=f"This step cannot begin: {error}."))
            return
        self.show(scene)

    def show(self, scene: sim.Scene) -> None:
        if self._session is not None:
            # The class's page tells what the step is; the scene's own card would tell it twice.
            self._session.post(commands.Open(msgspec.structs.replace(scene, lesson=None)))
            self._session.post(commands.Play(not self.room.paused))

    # --------------------------------------------------------------------- inside
    def _look(self, session: Session) -> None:
        """Look at the pupil's body: whether it reaches the goal, and what it does."""
        step = self.room.step
        if self._begun != session.openings:
            self._begun, self._reached, self._found = session.openings, False, None
            self._touched = False
            goal, collect = (step.goal, step.collect) if step is not None else (None, None)
            try:
                self._watch = GoalWatch(goal, session.scene) if goal is not None else None
                self._meter = Meter(collect, session.scene) if collect is not None else None
            except InputError:
                self._watch = self._meter = None
        if self._watch is not None and self._watch.look(session.simulation) and not self._reached:
            self._reached = True
        if self._meter is not None:
            self._found = self._meter.take(session.simulation)
        self._touched = self._touched or session.recorder.acts > 0
        now = session.now()
        if now >= self._look_due:
            self._look_due = now + LOOK_EVERY
            places = places_of(session.simulation.positions, session.scene)
            self.klass.doing[self._number] = Doing(self._word(session, places), places, self._touched)

    def _word(self, session: Session, places: tuple[tuple[int, int], ...]) -> Word:
        if session.simulation.divergence is not None:
            return "exploded"
        if self._reached:
            return "goal reached"
        if not session.playing:
            return "paused"
        before = self.klass.doing.get(self._number, Doing()).places
        return "at rest" if before == places else "moving"

    def _enter(self) -> None:
        try:
            given = self.klass.given.get(self._visitor, ()) if self._visitor else ()
            seat = self.room.enter(self._secret, self.klass.pupils, given)
            self.klass.given.setdefault(self._visitor, set()).add(seat.number)
            self._sit(seat)
            self._problem = ""
        except Refused as error:
            self._problem = str(error)

    def _sit(self, seat: SeatOfRoom) -> None:
        self.leave()
        self._number = seat.number
        self.klass.pupils[seat.number] = self

    def _of_room(self) -> SeatOfRoom:
        """Its seat.

        Raises:
            Refused: it has none, or another page has it.
        """
        seat = self.seat
        if seat is None:
            raise Refused(self._problem or "Another page has this seat now.")
        return seat

    def _give(self, said: from_page.Give) -> None:
        seat = self._of_room()
        match said:
            case from_page.GiveVote(choice=choice):
                content = Vote(choice)
            case from_page.GivePlaces(points=points):
                if said.stop >= len(self.room.stops):
                    raise Refused("The class has no such step.")
                try:
                    scene = self.klass.scene(said.stop)
                except SettingError:
                    raise Refused("This step cannot begin.") from None
                if len(points) != len(scene.masses):
                    raise Refused("That is no place for this body.")
                mapping = Mapping.of(scene)
                content = Ghost(tuple(mapping.to_scene(x, y) for x, y in points))
            case from_page.GiveLine(text=text):
                content = Line(text)
            case _:
                self._hand_in(said, seat)
                return
        answer = Answer(said.id, said.turn, seat.number, said.twin, said.stop, said.round, content)
        self.room.take(seat.number, answer)
        # One that the room had may not be on the disk yet.
        self._unwritten.append((self.room.version, said.id))

    def _hand_in(self, said: from_page.Give, seat: SeatOfRoom) -> None:
        """Hand in what the pupil's body did since it began."""
        session, step = self._session, self.room.step
        if session is None or self.front is not None or said.stop != self.room.at:
            raise Refused("There is no run to hand in now.")
        if session.replay is not None:
            raise Refused("A log is being played; there is nothing to hand in.")
        now = session.now()
        if said.id not in self.room.answers and now < self._hand_in_due:
            return  # it is not acknowledged, so that the page says it again
        self._hand_in_due = now + HAND_IN_EVERY
        positions = session.simulation.positions[:2000]
        is_somewhere = bool(np.isfinite(positions).all())
        content = Work(
            found=self._found,
            setting=_setting(session.scene, step),
            reached=None if self._watch is None else self._reached,
            points=tuple((float(x), float(y)) for x, y in positions) if is_somewhere else (),
            damage=session.simulation.damage if is_somewhere else None,
        )
        answer = Answer(said.id, said.turn, seat.number, said.twin, said.stop, said.round, content)
        if step is None:
            self.room.take(seat.number, answer)
        else:
            scene, log = self.klass.scene(self.room.at), session.recorder.file()
            self.klass.hand_in(answer, log, step, scene, frozenset(session.recorder.been))
        self._unwritten.append((self.room.version, said.id))

    def _state(self) -> Seat:
        room, seat = self.room, self.seat
        if seat is None:
            taken = room.seats.get(self._number)
            if self._secret and taken is not None and not taken.removed:
                return Seat(elsewhere="page" if taken.token == digest(self._secret) else "device")
            return Seat(
                problem=(self._problem or "The teacher has closed this seat.") if self._secret else ""
            )
        mine = [answer for answer in room.answers.values() if answer.seat == seat.number]
        return Seat(
            code=room.code,
            name=seat.name,
            color=seat.color,
            turn=1 + max((answer.turn for answer in mine), default=0),
            two=seat.twins,
            hand=seat.hand,
            types_name=room.own_names,
            digits=seat.move,
            follows=self.front is not None,
            gathered=room.gathered,
            paused=room.paused,
            away=not self.klass.teachers,
            on_wall=room.is_on_wall(seat.number),
            reached=self._reached,
            asking=asking(room),
            given=tuple(
                Given(
                    stop=answer.stop,
                    round=answer.round,
                    twin=answer.twin,
                    kind=kind_of(answer.content),
                    choice=answer.content.choice if isinstance(answer.content, Vote) else -1,
                    text=text_of(answer.content),
                )
                for answer in mine
                if answer.stop == room.at
            ),
        )


def _setting(scene: sim.Scene, step: Step | None) -> float | None:
    """The first number that a step has a slider for."""
    for key in step.controls if step is not None else ():
        if key not in CHOICES:
            try:
                return float(setting_of(scene, key).read(scene))
            except SettingError:
                return None
    return None
