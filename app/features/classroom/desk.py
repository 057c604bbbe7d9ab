"""The teacher's page in a class."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Literal

import msgspec
import numpy as np

from app.classroom import sheets
from app.classroom.live import Class, Doing, Front, is_key
from app.classroom.room import FREE, PHASE_OF, Phase, Refused, Vote, Work
from sim.errors import InputError, SettingError

from ...pages.check.page import check_address
from ...session import commands
from ...session.log import decode_log
from ...session.session import Notice, Session
from ...ui.controls import Controls
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.to_page import Brought, Desk, DeskAnswer, DeskSeat, DeskStop, DeskTried, Posters
from ..files.sharing import qr_code
from .role import (
    MAX_PLACES,
    NOTHING,
    ClassRole,
    asking,
    found_by,
    kind_of,
    law_of,
    over,
    places_of,
    predictions,
    text_of,
)

STILL = frozenset((Phase.SHOW, Phase.ASK))
"""Phases that begin with the body as its step has it, at rest in time."""

AGAIN = frozenset((Phase.RUN, Phase.EXPLAIN))
"""Phases in which the run can be seen again."""

SLOWLY = 0.25
"""Simulated seconds per second when it is."""


class DeskRole(ClassRole):
    """One window of a teacher; there may be several, with the same rights.

    The one that did something last, or came first, has the body that all look at.

    Args:
        klass: the class.
        mail: to the page's script.
        address: by which pupils come in.
        qr: a picture of its QR code, as an address.
        download: has the browser save a file of that name.
    """

    def __init__(
        self, klass: Class, mail: Mail, address: str, qr: str, download: Callable[[str, bytes], None]
    ) -> None:
        super().__init__(klass, mail)
        self._address, self._qr, self._download = address, qr, download
        self._check = check_address(address, klass.room.code)
        self._check_qr = qr_code(self._check)
        self._is_teacher = False
        self._opened: tuple[int, Phase, int] | None = None
        self._noted = 0.0
        self._speed: float | None = None  # before a slow replay, while there is one
        self._begins = False
        # What is made for the browser to save: its name, what it is called, and its bytes.
        self._making: tuple[str, str, Future[bytes]] | None = None
        self._posters: tuple[tuple[int, Doing], ...] | None = None

    @property
    def controls(self) -> Controls | None:
        return None if self._is_teacher else NOTHING

    @property
    def front(self) -> Front | None:
        leads = self._is_teacher and self.klass.desk is self
        return None if leads else self.klass.front

    def allows(self, said: from_page.FromPage) -> bool:
        return self._is_teacher or isinstance(said, from_page.Who)

    def introduce(self, who: from_page.Who, session: Session) -> None:
        if not self._is_teacher and is_key(self.room, who.teacher):
            self._is_teacher = True
            self.klass.teachers += 1
            session.generation += 1  # it has controls from now on

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        if not self._is_teacher or not isinstance(said, from_page.Lead):
            return
        self.klass.desk = self
        room = self.room
        try:
            match said:
                case from_page.Stage(stop, phase, round):
                    room.go(stop, Phase(phase), round)
                case from_page.Star(answer, on):
                    room.star(answer, on)
                case from_page.ToWall(answer):
                    room.put_on_wall(answer)
                case from_page.Bring(text):
                    self._bring(text)
                case from_page.OneSeat(seat, what):
                    self._do_with(seat, what)
                case from_page.Arrange(what):
                    self._arrange(what, session)
        except Refused as error:
            session.notices.append(Notice("error", "That is not possible", str(error)))

    def frame(self, session: Session) -> None:
        if self._making is not None and self._making[2].done():
            self._hand_over(*self._making, session)
            self._making = None
        if self._tell_end() or not self._is_teacher:
            return
        self.klass.tend()
        if self.klass.desk is None:
            self.klass.desk = self
        if self.klass.desk is self:
            self._lead(session)
            while self.klass.told:
                session.notices.append(Notice("warning", *self.klass.told.popleft()))
        doing = self.klass.doing if self.room.phase in FREE else {}
        if (posters := tuple(doing.items())) != self._posters:
            self._posters = posters
            springs = self.klass.scene(self.room.at).linear_springs if self.room.phase in FREE else ()
            self._mail.send(
                Posters(
                    places={str(number): one.places for number, one in posters},
                    springs=tuple((s.a, s.b) for s in springs if max(s.a, s.b) < MAX_PLACES),
                )
            )
        words = (one.word for one in doing.values())
        if self._is_new(self.klass.written, self.klass.trouble, self._again, tuple(self.klass.tried), *words):
            self._mail.send(self._state())
            self._mail.send(predictions(self.klass))

    def keep(self, keepsake: bytes) -> bool:
        return False

    def leave(self) -> None:
        if self._is_teacher:
            self.klass.teachers -= 1
        if self.klass.desk is self:
            self.klass.desk = None

    # --------------------------------------------------------------------- inside
    def _arrange(self, what: str, session: Session) -> None:
        room = self.room
        match what:
            case "pause" | "goOn":
                room.paused = what == "pause"
            case "open" | "close":
                room.is_open = what == "open"
            case "ownNames" | "givenNames":
                room.own_names = what == "ownNames"
            case "reset":
                for pupil in self.klass.pupils.values():
                    pupil.begin()
            case "asMine":
                for pupil in self.klass.pupils.values():
                    pupil.show(session.scene)
            case "gather" | "giveBack":
                room.gather(what == "gather")
            case "again":
                self._see_again(session)
            case "law" | "noLaw":
                room.law = what == "law"
            case "zip":
                self._making = self._making or (f"class-{room.code}.zip", "The zip", self.klass.pack())
                return
            case "lessonFile":
                name = f"{room.scenes[room.stops[room.at].scene].name}.html"
                self._making = self._making or (name, "The lesson's file", self.klass.lesson_file())
                return
            case "end":
                self.klass.end()
                return
        room.version += 1

    def _bring(self, text: str) -> None:
        """Take answers that a pupil gave in a file, and tell what became of them."""
        try:
            taken = sheets.take(self.room, text)
        except Refused as error:
            self._mail.send(Brought(told=str(error), refused=True))
            return
        count = f"{taken.new} {'answer' if taken.new == 1 else 'answers'}"
        known = f", {taken.known} had been brought before" if taken.known else ""
        steps = ", ".join(map(str, taken.reached))
        goals = f". As its own file says, it reached the goal of step {steps}" if steps else ""
        self._mail.send(Brought(told=f"{taken.name}: {count}{known}{goals}."))

    def _hand_over(self, name: str, what: str, made: Future[bytes], session: Session) -> None:
        """Have the browser save what was made."""
        if (error := made.exception()) is None:
            self._download(name, made.result())
        else:
            session.notices.append(Notice("error", f"{what} could not be made", str(error)))

    def _do_with(self, number: int, what: str) -> None:
        """Do something with one seat.

        Raises:
            Refused: it cannot be.
        """
        room, pupil = self.room, self.klass.pupils.get(number)
        match what:
            case "reset":
                if pupil is None or room.phase not in FREE:
                    raise Refused("That seat has no body of its own now.")
                pupil.begin()
            case "show" | "hide":
                room.put_seat_on_wall(number if what == "show" else 0)
                self.klass.lent = None  # until the seat's page shows it
            case "move":
                room.offer_move(number)
            case "sendAway":
                room.remove(number)

    @property
    def _again(self) -> Literal["no", "yes", "now"]:
        """Whether the run can be seen again, slowly."""
        if self.room.phase not in AGAIN or not self.klass.run:
            return "no"
        return "yes" if self._speed is None else "now"

    def _see_again(self, session: Session) -> None:
        """Play the run's log, slowly: bit for bit the same.

        Raises:
            Refused: there is none.
        """
        if self._again == "no":
            raise Refused("There is no run to see again.")
        try:
            record = decode_log(self.klass.run, "the run")
        except InputError as error:
            raise Refused(f"The run cannot be seen again: {error}.") from None
        if self._speed is None:
            self._speed = session.pacer.speed
        self._begins = True
        session.post(commands.Speed(SLOWLY))
        session.post(commands.Replay(record))

    def _follow_run(self, session: Session) -> None:
        """Have the run stand at the moment that was predicted, keep its log, and end what goes slowly."""
        if self._speed is not None:
            if not self._begins and session.replay is None:
                session.post(commands.Speed(self._speed))
                self._speed = None
            self._begins = False
            return
        if self.room.phase not in AGAIN:
            return
        time, step = session.simulation.time, self.room.step
        predicted = step.predict if step is not None else None
        if session.playing:
            if self.room.phase is Phase.RUN and predicted is not None and time >= predicted:
                session.post(commands.Play(False))
        elif time > self._noted and time >= (predicted or 0.0) and session.replay is None:
            self._noted, self.klass.run = time, session.recorder.file()

    def _lead(self, session: Session) -> None:
        """Have the body as the class's phase wants it, and show it to all."""
        room, place = self.room, (self.room.at, self.room.phase, self.room.round)
        # What is there at first is the class's present body, or what the browser had kept of it.
        before, self._opened = self._opened or place, place
        if before != place:
            another = before[0] != room.at
            if another or room.phase not in AGAIN or room.phase is Phase.RUN:
                self._noted, self.klass.run = 0.0, b""
            if another or room.phase in STILL or room.phase is Phase.RUN:
                self._open(session)
            if room.phase in STILL or another:
                session.post(commands.Play(False))
            elif room.phase is Phase.RUN:
                session.post(commands.Play(True))
        else:
            self._follow_run(session)
        self.klass.front = self._shown(session, self.klass.front, self.klass.audience)

    def _open(self, session: Session) -> None:
        try:
            scene = self.klass.scene(self.room.at)
        except SettingError as error:
            session.notices.append(Notice("error", "This step cannot begin", str(error)))
            return
        session.post(commands.Open(msgspec.structs.replace(scene, lesson=None)))

    def _state(self) -> Desk:
        room, klass = self.room, self.klass
        kinds = [kind for kind, phase in PHASE_OF.items() if phase is room.phase]
        answers = [a for a in room.answers.values() if (a.stop, a.round) == (room.at, room.round)]
        done = {a.seat for a in answers if type(a.content) in kinds}
        step = room.step
        found = found_by(room)
        return Desk(
            code=room.code,
            address=self._address,
            qr=self._qr,
            check=self._check,
            check_qr=self._check_qr if room.phase is Phase.LOBBY else "",
            tried=tuple(
                DeskTried(trip=one.trip, rate=one.rate, works=one.works, doubts=one.doubts)
                for one in klass.tried
            ),
            stops=tuple(
                DeskStop(
                    title=(
                        at.title
                        if at is not None
                        else room.scenes[stop.scene].title or room.scenes[stop.scene].name
                    ),
                    phases=tuple((phase.value, round) for phase, round in room.order(i)),
                )
                for i, stop in enumerate(room.stops)
                for at in (room.step_at(i),)
            ),
            asking=asking(room, all_of_it=True),
            next=None if (after := room.next()) is None else (after[0], after[1].value, after[2]),
            seats=tuple(
                DeskSeat(
                    number=seat.number,
                    name=seat.name,
                    color=seat.color,
                    here=seat.number in klass.pupils,
                    two=seat.twins,
                    hand=seat.hand,
                    answered=seat.number in done,
                    doing=klass.doing[seat.number].word if seat.number in klass.doing else "",
                    follows=seat.follows,
                    digits=seat.move,
                )
                for seat in room.seats.values()
                if not seat.removed
            ),
            answers=tuple(
                DeskAnswer(
                    id=a.id,
                    seat=a.seat,
                    kind=kind_of(a.content),
                    choice=a.content.choice if isinstance(a.content, Vote) else -1,
                    text=text_of(a.content),
                    late=a.late,
                    starred=a.starred,
                    found=a.content.found if isinstance(a.content, Work) else None,
                    setting=a.content.setting if isinstance(a.content, Work) else None,
                    reached=a.content.reached if isinstance(a.content, Work) else None,
                    doubt=a.content.doubt if isinstance(a.content, Work) else "",
                    places=_picture(a.content, klass),
                )
                for a in answers
            ),
            bars=tuple(room.bars(room.at, room.vote_round)),
            right=step.question.answer if step is not None and step.question is not None else -1,
            over=over(klass),
            law=law_of(found),
            shows_law=room.law,
            on_wall=room.on_wall,
            seat_on_wall=room.seat_on_wall,
            gathered=room.gathered,
            again=self._again,
            open=room.is_open,
            own_names=room.own_names,
            paused=room.paused,
            saved=klass.written == room.version,
            trouble=klass.trouble,
        )


def _picture(content: object, klass: Class) -> tuple[tuple[int, int], ...]:
    """Where the masses of a run were that was handed in; nothing of anything else."""
    if not isinstance(content, Work) or not content.points:
        return ()
    return places_of(np.array(content.points), klass.scene(klass.room.at))
