"""The teacher's page in a class."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import msgspec
import numpy as np

from app.classroom.live import Class, Doing, Front, is_key
from app.classroom.room import FREE, PHASE_OF, Phase, Refused, Vote, Work
from app.classroom.takeaway import pack
from sim.errors import SettingError

from ...session import commands
from ...session.session import Notice, Session
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.to_page import Desk, DeskAnswer, DeskSeat, DeskStop, DeskTried, Posters
from ..body.view import picture_of
from ..check.page import check_address
from ..controls import Controls
from ..files.sharing import qr_code
from .front import looks_alike, send
from .role import NOTHING, ClassRole, asking, kind_of, predictions, text_of
from .seat import MOST_PLACES

STILL = frozenset((Phase.SHOW, Phase.ASK))
"""Phases that begin with the body as its step has it, at rest in time."""


_numbers = itertools.count(1_000_000)
"""Of plans that all pages of a class have: no page has so many of its own."""


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
        self._plan: tuple[int, int] = (-1, -1)
        self._number = 0
        self._posters: tuple[tuple[int, Doing], ...] | None = None
        self._angles = np.empty(0)

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
                case from_page.SendAway(seat):
                    room.remove(seat)
                case from_page.Arrange(what):
                    self._arrange(what, session)
        except Refused as error:
            session.notices.append(Notice("error", "That is not possible", str(error)))

    def frame(self, session: Session) -> None:
        if self._tell_end() or not self._is_teacher:
            return
        self.klass.tend()
        if self.klass.desk is None:
            self.klass.desk = self
        if self.klass.desk is self:
            self._lead(session)
        doing = self.klass.doing if self.room.phase in FREE else {}
        if (posters := tuple(doing.items())) != self._posters:
            self._posters = posters
            springs = self.klass.scene(self.room.at).linear_springs if doing else ()
            self._mail.tell(
                Posters(
                    places={str(number): one.places for number, one in posters},
                    springs=tuple((s.a, s.b) for s in springs if max(s.a, s.b) < MOST_PLACES),
                )
            )
        if self._is_new(self.klass.written, tuple(self.klass.tried), *(one.word for one in doing.values())):
            self._mail.tell(self._state())
            self._mail.tell(predictions(self.klass))

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
            case "zip":
                self._download(f"class-{room.code}.zip", pack(room))
                return
            case "end":
                self.klass.end()
        room.version += 1

    def _lead(self, session: Session) -> None:
        """Have the body as the class's phase wants it, and show it to all."""
        room, place = self.room, (self.room.at, self.room.phase, self.room.round)
        # What is there at first is the class's present body, or what the browser had kept of it.
        before, self._opened = self._opened or place, place
        if before != place:
            another = before[0] != room.at
            if another or room.phase in STILL or room.phase is Phase.RUN:
                self._open(session)
            if room.phase in STILL or another:
                session.post(commands.Play(False))
            elif room.phase is Phase.RUN:
                session.post(commands.Play(True))
        step = room.step
        predicted = step.predict if step is not None and room.phase is Phase.RUN else None
        if predicted is not None and session.playing and session.simulation.time >= predicted:
            session.post(commands.Play(False))
        self._show(session)

    def _show(self, session: Session) -> None:
        """Have all see what this page does."""
        before, simulation = self.klass.front, session.simulation
        plan = session.openings, session.revision
        if plan != self._plan or before is None:
            self._plan, self._number = plan, next(_numbers)
            self._angles = simulation.rest_angles - simulation.rest_angle_shift
            if (damage := simulation.damage) is not None and damage.set_angles:
                self._angles = self._angles - np.array(damage.set_angles)
        front = Front(
            self._number,
            self.klass.audience,
            session.scene,
            session.openings,
            self._angles,
            picture_of(session),
            session.playing,
            session.pacer.speed,
        )
        if before is None or not looks_alike(before, front):
            self.klass.front = front
            send(front, session.now())

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
                )
                for a in answers
            ),
            bars=tuple(room.bars(room.at, room.round)),
            right=step.question.answer if step is not None and step.question is not None else -1,
            on_wall=room.on_wall,
            open=room.is_open,
            own_names=room.own_names,
            paused=room.paused,
            saved=klass.written == room.version,
        )
