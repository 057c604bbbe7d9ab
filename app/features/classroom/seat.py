"""A pupil's page in a class."""

from __future__ import annotations

from collections import deque

import msgspec
import numpy as np

import sim
from app.classroom import room as rooms
from app.classroom.answers import (
    OWN_BODY,
    Answer,
    AnyContent,
    Line,
    Phase,
    Prediction,
    Refused,
    Vote,
    Work,
)
from app.classroom.axes import axes_of, first_setting
from app.classroom.judge import GoalWatch, Meter
from app.classroom.live import Class, PupilStatus, SharedView, Word
from app.classroom.room import MAX_ANSWERS, digest
from sim.errors import InputError, SettingError
from sim.scene.lesson import Step
from sim.settings import setting_of

from ...lessons import reading_unit
from ...session import commands
from ...session.framing import Bounds
from ...session.session import Session
from ...stage.sketch import Mapping
from ...ui.controls import Controls
from ...wire import from_page, line
from ...wire.carrier import Mail
from ...wire.messages import OwnBody
from ...words import language, number, say, speaking
from ...words.english import of
from ..describe.messages import Describe
from . import messages
from .messages import Found, Given, Predictions, Seat, Taken
from .role import (
    NOTHING,
    ClassRole,
    asking,
    found_by,
    home_text,
    in_world,
    moved_text,
    places_of,
    predicted,
    predictions,
)

_ALWAYS = (messages.InSeat, from_page.Who, Describe)

MAX_TRIES = 5
"""Pairs of digits, of a hundred, that one page can try in order to take a seat over."""

HAND_IN_EVERY = 1.0
"""Seconds between two runs that one page hands in: each is written, and judged by repeating it."""

STATUS_EVERY = 0.5
"""Seconds between two reports of what a pupil's body does."""


class SeatRole(ClassRole):
    """One pupil's page; of several pages of one browser, the latest has the seat.

    Args:
        classroom: the class.
        mail: to the page's script.
        visitor: whose page it is, as far as the server can tell visitors apart; "" if it cannot.
    """

    def __init__(self, classroom: Class, mail: Mail, visitor: str = "") -> None:
        super().__init__(classroom, mail)
        self._visitor, self._language = visitor, language()
        self._secret = ""
        self._number = 0
        self._problem = ""
        self._stop: tuple[int, bool] = -1, False  # that the body is of, and whether it moves
        self._paused = False
        self._session: Session | None = None
        self._unwritten: deque[tuple[int, str]] = deque(maxlen=MAX_ANSWERS)
        self._hand_in_due = 0.0
        self._audience: set[line.Line] = set()  # of its body on the wall
        self._tries = 0
        self._watch: GoalWatch | None = None
        self._meter: Meter | None = None
        self._opening = -1
        self._reached = self._touched = False
        self._found: float | None = None
        self._stood = False  # at the moment that was predicted
        self._status_due = 0.0
        self._reading_text = ""

    @property
    def seat(self) -> rooms.Seat | None:
        """Its seat, unless it has none or another page has it now."""
        seat = self.room.seats.get(self._number)
        has = seat is not None and not seat.removed and self.classroom.pupils.get(self._number) is self
        return seat if has else None

    @property
    def _place(self) -> rooms.Place:
        return self.room.place_of(self._number)

    @property
    def _step(self) -> Step | None:
        return self.room.step_at(self._place.stop)

    @property
    def _moves(self) -> bool:
        """Whether the page has a body of its own that may move."""
        seat, room = self.seat, self.room
        if seat is None or self._place.phase not in OWN_BODY:
            return False
        return room.is_home or not (room.gathered or seat.follows)

    @property
    def shared_view(self) -> SharedView | None:
        return None if self._moves or self.room.is_home else self.classroom.shared_view

    @property
    def bounds(self) -> Bounds | None:
        return self.classroom.bounds(self._place.stop)

    @property
    def controls(self) -> Controls | None:
        if not self._moves or self.shared_view is not None:
            return NOTHING
        step = self._step
        return Controls(("play", *(step.controls if step is not None else ())))

    @property
    def plots(self) -> tuple[str, ...]:
        step = self._step
        return (step.plots or ()) if step is not None else ()

    @property
    def describes(self) -> bool:
        # While they are asked, all have the same body, which stands where the step begins.
        return self.seat is not None and (self._moves or self._place.phase is Phase.ASK)

    def allows(self, said: from_page.FromPage) -> bool:
        return isinstance(said, _ALWAYS) or (self._moves and isinstance(said, OwnBody))

    def introduce(self, who: from_page.Who, session: Session) -> None:
        # A page belongs to one browser, and cannot take seat after seat.
        if self._secret in ("", who.visitor):
            self._session, self._secret = session, who.visitor
            self._enter()

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        try:
            match said:
                case messages.TakeOver(digits):
                    self._tries += 1
                    if self._tries > MAX_TRIES:
                        raise Refused(say("class-refuse-tries"))
                    self._sit(self.room.move(self._secret, digits))
                case messages.Give():
                    self._give(said)
                case messages.RaiseHand(up):
                    self._own_seat().hand = up
                    self.room.version += 1
                case messages.NewName(wanted):
                    self.room.rename(self._own_seat().number, wanted)
                case messages.SitTogether(two):
                    self._own_seat().twins = two
                    self.room.version += 1
                case messages.LeaveBy():
                    self.room.offer_move(self._own_seat().number)
                case messages.WalkTo(stop):
                    self.room.walk(self._own_seat().number, stop)
                case messages.Follow(on):
                    self.room.follow(self._own_seat().number, on)
        except Refused as error:
            ids = (said.id,) if isinstance(said, messages.Give) else ()
            self._mail.send(Taken(ids=ids, refused=of(str(error))))

    def _update(self, session: Session) -> None:
        ready = tuple(id for version, id in self._unwritten if version <= self.classroom.written)
        if ready:
            left = [one for one in self._unwritten if one[1] not in ready]
            self._unwritten = deque(left, maxlen=MAX_ANSWERS)
            self._mail.send(Taken(ids=ready))
        if self.seat is not None and self.shared_view is None:
            self._update_body(session)
        if self._is_new(self.seat is None, self._problem, self._reached, self._reading_text, self._touched):
            self._mail.send(self._state())
            self._mail.send(self._predictions() if self.room.is_home else predictions(self.classroom))

    def keep(self, keepsake: bytes) -> bool:
        if self._moves and self._stop == (self._place.stop, True):
            self.classroom.keep_body(self._number, keepsake)
        return True

    def leave(self) -> None:
        if self.classroom.pupils.get(self._number) is self:
            del self.classroom.pupils[self._number]
            self.classroom.statuses.pop(self._number, None)
            if (seat := self.room.seats.get(self._number)) is not None:  # none after the class's end
                seat.hand = False

    # --------------------------------------------------------------------- called by the teacher's page
    def begin(self) -> None:
        stop, moves = self._stop = self._place.stop, self._moves
        self._stood = False
        try:
            # As a page alone has it once its step has run: what the step says to do begins there.
            self.show(self.classroom.run_scene(stop) if moves else self.classroom.scene(stop))
            self._accompany(stop if moves else None)
        except SettingError as error:
            # The teacher's page, which may have another language, calls this, too.
            with speaking(self._language):
                self._mail.send(Taken(ids=(), refused=say("class-refuse-begin", reason=str(error))))

    def show(self, scene: sim.Scene) -> None:
        if self._session is not None:
            # The class's own card has the step; the scene's card would repeat it.
            self._session.post(commands.Open(msgspec.structs.replace(scene, lesson=None)))
            self._session.post(commands.Play(self._moves and not self.room.paused))

    def _accompany(self, stop: int | None) -> None:
        """Have the body move at its usual speed, with the second body of a stop's step, if it has one."""
        step = self.room.step_at(stop) if stop is not None else None
        if self._session is not None:
            self._session.post(commands.Compare((step.ghost or "") if step is not None else "", ""))
            self._session.post(commands.Speed(1.0))

    # --------------------------------------------------------------------- the pupil's body
    def _update_body(self, session: Session) -> None:
        """Begin or resume the pupil's body, watch it, and pause it with all others."""
        if self._stop != (here := (self._place.stop, self._moves)):
            if self._moves and (keepsake := self.classroom.body(self._number)) is not None:
                self._stop = here
                session.post(commands.Resume(keepsake, None))
            else:
                self.begin()
        self._watch_body(session)
        self._stand(session)
        if self.room.seat_on_wall == self._number:
            self.classroom.wall_feed = self._share(session, self.classroom.wall_feed, self._audience)
        if self._paused != self.room.paused:
            self._paused = self.room.paused
            session.post(commands.Play(not self._paused))

    def _stand(self, session: Session) -> None:
        """In homework, stop the first run at the moment that was predicted."""
        step = self._step
        predict = step.predict if step is not None and self.room.is_home and self._moves else None
        if predict and not self._stood and session.playing and session.simulation.time >= predict:
            self._stood = True
            session.post(commands.Play(False))

    def _predictions(self) -> Predictions:
        """What the pupil has predicted in homework, until they do something with the body."""
        stop = self._place.stop
        mine = [one for answer, one in self.room.given(stop, 0, Prediction) if answer.seat == self._number]
        if not mine or not self._moves or self._touched:
            return Predictions()
        mapping = Mapping.of(self.classroom.scene(stop))
        return Predictions(bodies=(in_world(mapping, mine[-1].points),))

    def _watch_body(self, session: Session) -> None:
        """Check whether the body reaches the goal, read off what is collected, and report what it does."""
        if self._opening != session.openings:
            self._opening, self._reached, self._touched, self._found = session.openings, False, False, None
            self._reading_text = ""
            step = self._step
            goal, collect = (step.goal, step.collect) if step is not None else (None, None)
            try:
                self._watch = GoalWatch(goal, session.scene) if goal is not None else None
                self._meter = Meter(collect, session.scene) if collect is not None else None
            except InputError:
                self._watch = self._meter = None
        if self._watch is not None:
            self._reached = self._watch.look(session.simulation)
        if self._meter is not None:
            self._found = self._meter.take(session.simulation)
        self._touched = self._touched or session.recorder.acts > 0
        if (now := session.now()) >= self._status_due:
            self._status_due = now + STATUS_EVERY
            places = places_of(session.simulation.positions, session.scene)
            status = PupilStatus(self._word(session, places), places, self._touched)
            self.classroom.statuses[self._number] = status
            self._reading_text = self._read_out(session.scene)

    def _words(self, content: AnyContent, stop: int) -> str:
        """What was given, as the pupil reads it."""
        if not isinstance(content, Prediction):
            return content.words
        scene = self.classroom.scene(stop)
        return moved_text(scene, *predicted(content, scene, self.room.step_at(stop)))

    def _read_out(self, scene: sim.Scene) -> str:
        """What would be handed in now, as the pupil reads it."""
        step = self._step
        if self._found is None or step is None or step.collect is None:
            return ""
        return f"{number(self._found, 4)} {reading_unit(step.collect, scene)}".rstrip()

    def _word(self, session: Session, places: tuple[tuple[int, int], ...]) -> Word:
        if session.simulation.divergence is not None:
            return "exploded"
        if self._reached:
            return "goal reached"
        if not session.playing:
            return "paused"
        before = self.classroom.statuses.get(self._number, PupilStatus()).places
        return "at rest" if before == places else "moving"

    def _class_found(self) -> tuple[Found, ...]:
        """The class's plot, for a pupil who has put a point on it."""
        room, (stop, phase, _) = self.room, self._place
        has_given = any(answer.seat == self._number for answer, _ in room.given(stop, 0, Work))
        may_see = not room.is_home or room.is_told
        return found_by(room, stop) if phase is Phase.COLLECT and has_given and may_see else ()

    # --------------------------------------------------------------------- seat and answers
    def _enter(self) -> None:
        granted = self.classroom.granted.setdefault(self._visitor, set())
        try:
            seat = self.room.enter(self._secret, self.classroom.pupils, granted if self._visitor else ())
        except Refused as error:
            self._problem = of(str(error))
            return
        granted.add(seat.number)
        self._sit(seat)
        self._problem = ""

    def _sit(self, seat: rooms.Seat) -> None:
        self.leave()
        self._number = seat.number
        self.classroom.pupils[seat.number] = self

    def _own_seat(self) -> rooms.Seat:
        """Return its seat.

        Raises:
            Refused: it has none, or another page has it.
        """
        if (seat := self.seat) is None:
            raise Refused(self._problem or say("class-refuse-other-page"))
        return seat

    def _give(self, said: messages.Give) -> None:
        seat = self._own_seat()
        match said:
            case messages.GiveVote(choice=choice):
                content: AnyContent | None = Vote(choice)
            case messages.GivePrediction(points=points):
                content = self._prediction(points, said.stop)
            case messages.GiveLine(text=text):
                content = Line(text)
            case _:
                content = self._work(said)
        if content is None:
            return  # not acknowledged, so that the page repeats it
        answer = Answer(said.id, said.turn, seat.number, said.twin, said.stop, said.round, content)
        if isinstance(content, Work) and self._session is not None and (step := self._step) is not None:
            scene, recorder = self.classroom.run_scene(self._place.stop), self._session.recorder
            self.classroom.hand_in(answer, recorder.file(), step, scene, frozenset(recorder.visited))
        else:
            self.room.take(seat.number, answer)
        # Even an answer that the room has already may not be on the disk yet.
        self._unwritten.append((self.room.version, said.id))

    def _prediction(self, points: tuple[tuple[float, float], ...], stop: int) -> Prediction:
        """Convert a prediction from the page's world to the scene of a stop.

        Raises:
            Refused: there is no such scene, or they are not one for each of its masses.
        """
        if stop >= len(self.room.stops):
            raise Refused(say("class-refuse-no-step"))
        try:
            scene = self.classroom.scene(stop)
        except SettingError:
            raise Refused(say("class-refuse-cannot-begin")) from None
        if len(points) != len(scene.masses):
            raise Refused(say("class-refuse-no-such-place"))
        mapping = Mapping.of(scene)
        return Prediction(tuple(mapping.to_scene(x, y) for x, y in points))

    def _work(self, said: messages.Give) -> Work | None:
        """Return what the pupil's body has done since it began; None so soon after the last one.

        Raises:
            Refused: there is no run to hand in.
        """
        session = self._session
        if session is None or self.shared_view is not None or said.stop != self._place.stop:
            raise Refused(say("class-refuse-no-run"))
        if session.replay is not None:
            raise Refused(say("class-refuse-replay"))
        now = session.now()
        if said.id not in self.room.answers and now < self._hand_in_due:
            return None
        self._hand_in_due = now + HAND_IN_EVERY
        positions = session.simulation.positions[:2000]
        is_somewhere = bool(np.isfinite(positions).all())
        return Work(
            found=self._found,
            setting=self._setting(session.scene),
            reached=None if self._watch is None else self._reached,
            points=tuple((float(x), float(y)) for x, y in positions) if is_somewhere else (),
            damage=session.simulation.damage if is_somewhere else None,
        )

    def _setting(self, scene: sim.Scene) -> float | None:
        """Return the value of the first number that the step has a slider for."""
        key = first_setting(self.room, self._place.stop)
        try:
            return float(setting_of(scene, key).read(scene)) if key else None
        except SettingError:
            return None

    def _state(self) -> Seat:
        room, seat = self.room, self.seat
        if seat is None:
            taken = room.seats.get(self._number)
            if self._secret and taken is not None and not taken.removed:
                return Seat(elsewhere="page" if taken.token == digest(self._secret) else "device")
            closed = self._problem or say("class-refuse-removed")
            return Seat(problem=closed if self._secret else "")
        place = self._place
        mine = [answer for answer in room.answers.values() if answer.seat == seat.number]
        return Seat(
            code=room.code,
            name=seat.name,
            color=seat.color,
            turn=1 + max((answer.turn for answer in mine), default=0),
            two=seat.twins,
            hand=seat.hand,
            types_name=room.own_names,
            is_given=seat.name == seat.given,
            digits=seat.move,
            follows=self.shared_view is not None,
            gathered=room.gathered,
            paused=room.paused,
            away=not (self.classroom.teachers or room.is_home),
            on_wall=room.is_on_wall(seat.number),
            reached=self._reached,
            reading=self._reading_text,
            found=self._class_found(),
            own=next(
                (
                    Found(setting=answer.content.setting, found=answer.content.found)
                    for answer in reversed(mine)
                    if answer.stop == place.stop
                    and isinstance(answer.content, Work)
                    and answer.content.setting is not None
                    and answer.content.found is not None
                ),
                None,
            ),
            axes=axes_of(room, place.stop),
            asking=asking(room, place=place),
            home=home_text(room),
            told=room.is_told,
            done=room.done(seat.number) if room.is_home else (),
            given=tuple(
                Given(
                    stop=answer.stop,
                    round=answer.round,
                    twin=answer.twin,
                    kind=answer.content.kind,
                    choice=answer.content.choice if isinstance(answer.content, Vote) else -1,
                    text=self._words(answer.content, answer.stop),
                    late=answer.late,
                )
                for answer in mine
                if answer.stop == place.stop
            ),
        )
