"""The teacher's page in a class."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from time import time
from typing import Literal

import numpy as np

from app.classroom import room as rooms
from app.classroom import sheets
from app.classroom.answers import OWN_BODY, Answer, Phase, Prediction, Refused, Vote, Work, doubt_text
from app.classroom.axes import axes_of
from app.classroom.live import Class, PupilStatus, SharedView, is_key
from sim.errors import InputError, SettingError

from ...pages.check.page import check_address
from ...session import commands
from ...session.log import decode_log
from ...session.session import Notice, Session
from ...ui.controls import Controls
from ...wire import from_page
from ...wire.carrier import Mail
from ...words import joined, language, say
from ...words.english import of
from ..files.sharing import qr_code
from . import messages
from .messages import Brought, Desk, DeskAnswer, DeskSeat, DeskStop, DeskTried, Posters
from .role import (
    MAX_PLACES,
    NOTHING,
    ClassRole,
    asking,
    count_bodies,
    found_by,
    home_text,
    law_of,
    lesson_names,
    moved_text,
    places_of,
    predicted,
    predictions,
)

STARTS_PAUSED = frozenset((Phase.LOBBY, Phase.SHOW, Phase.ASK))
"""Phases that begin with the body as its step has it, paused."""

HAS_RUN = frozenset((Phase.RUN, Phase.REVEAL, Phase.EXPLAIN))
"""Phases in which the run can be replayed."""

REPLAY_SPEED = 0.25
"""Simulated seconds per second of such a replay."""


class DeskRole(ClassRole):
    """One window of a teacher; there may be several, with the same rights.

    The one that did something last, or came first, has the body that all look at.

    Args:
        classroom: the class.
        mail: to the page's script.
        address: by which pupils come in, unless the teacher chooses another.
        download: has the browser save a file of that name.
        networks: addresses of this computer to choose from.
    """

    def __init__(
        self,
        classroom: Class,
        mail: Mail,
        address: str,
        download: Callable[[str, bytes], None],
        networks: Sequence[str] = (),
    ) -> None:
        super().__init__(classroom, mail, address)
        self._download, self._networks = download, tuple(networks)
        self._is_teacher = False
        self._place: tuple[int, Phase, int] | None = None
        self._run_time = 0.0  # at which the log of the run was taken
        self._usual_speed: float | None = None  # during a slow replay
        self._replay_begins = False
        # A file for the browser to save that is being made: its name, what to say if it fails, and its bytes.
        self._making: tuple[str, str, Future[bytes]] | None = None
        # Where the class was, and what the bodies did, when the page was told last.
        self._posters: tuple[int, tuple[tuple[int, PupilStatus], ...]] | None = None

    @property
    def controls(self) -> Controls | None:
        return None if self._is_teacher else NOTHING

    @property
    def shared_view(self) -> SharedView | None:
        leads = self._is_teacher and self.classroom.desk is self
        return None if leads else self.classroom.shared_view

    def allows(self, said: from_page.FromPage) -> bool:
        return self._is_teacher or isinstance(said, from_page.Who)

    def introduce(self, who: from_page.Who, session: Session) -> None:
        if not self._is_teacher and is_key(self.room, who.teacher):
            self._is_teacher = True
            self.classroom.teachers += 1
            self.room.language = language()
            session.generation += 1  # it has controls from now on

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        if not self._is_teacher or not isinstance(said, messages.Lead):
            return
        self.classroom.desk = self
        room = self.room
        try:
            match said:
                case messages.Stage(stop, phase, round):
                    room.go(stop, Phase(phase), round)
                    room.began = room.began or time()
                case messages.Star(answer, on):
                    room.star(answer, on)
                case messages.ToWall(answer):
                    room.put_on_wall(answer)
                case messages.ChooseLesson(name):
                    self.classroom.choose(name)
                    self._open(session)
                    session.post(commands.Play(False))
                case messages.ChooseNetwork(address):
                    if address in self._networks:
                        self.classroom.base = address
                        room.version += 1
                case messages.Bring(text):
                    self._import(text)
                case messages.OneSeat(seat, what):
                    self._do_with(seat, what)
                case messages.Arrange(what):
                    self._arrange(what, session)
        except Refused as error:
            session.notices.append(Notice("error", say("desk-not-possible"), str(error)))

    def frame(self, session: Session) -> None:
        if self._making is not None and self._making[2].done():
            self._hand_over(*self._making, session)
            self._making = None
        super().frame(session)

    def _update(self, session: Session) -> None:
        if not self._is_teacher:
            return
        classroom = self.classroom
        if classroom.desk is None:
            classroom.desk = self
        if classroom.desk is self:
            self._lead(session)
            while classroom.notices:
                session.notices.append(Notice("warning", *classroom.notices.popleft()()))
        statuses = classroom.statuses if self.room.phase in OWN_BODY else {}
        posters = self.room.at, tuple(statuses.items())
        if posters != self._posters:
            self._posters = posters
            self._mail.send(self._draw_posters(statuses))
        words = ((status.word, status.begun) for status in statuses.values())
        if self._is_new(classroom.written, classroom.trouble, self._again, tuple(classroom.checks), *words):
            self._mail.send(self._state())
            self._mail.send(predictions(classroom))

    def keep(self, keepsake: bytes) -> bool:
        return False

    def leave(self) -> None:
        if self._is_teacher:
            self.classroom.teachers -= 1
        if self.classroom.desk is self:
            self.classroom.desk = None

    # --------------------------------------------------------------------- what the teacher does
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
                for pupil in self.classroom.pupils.values():
                    pupil.begin()
            case "asMine":
                for pupil in self.classroom.pupils.values():
                    pupil.show(session.scene)
            case "gather" | "giveBack":
                room.gather(what == "gather")
            case "again":
                self._replay(session)
            case "lowerHands":
                room.lower_hands()
            case "law" | "noLaw":
                room.law = what == "law"
            case "zip":
                title = say("desk-no-zip")
                self._making = self._making or (f"class-{room.code}.zip", title, self.classroom.pack())
                return
            case "lessonFile":
                name = f"{room.scenes[room.stops[room.at].scene].name}.html"
                self._making = self._making or (name, say("desk-no-file"), self.classroom.lesson_file())
                return
            case "sheet":
                name = f"{room.scenes[room.stops[room.at].scene].name}-teacher.html"
                self._making = self._making or (name, say("desk-no-sheet"), self.classroom.teacher_sheet())
                return
            case "tell":
                room.tell()
            case "end":
                self.classroom.end()
                return
        room.version += 1

    def _import(self, text: str) -> None:
        """Take answers that a pupil gave in a file, and say what became of them."""
        try:
            imported = sheets.import_sheet(self.room, text)
        except Refused as error:
            self._mail.send(Brought(told=of(str(error)), refused=True))
            return
        if imported.known:
            count = say("desk-brought-known", name=imported.name, count=imported.new, known=imported.known)
        else:
            count = say("desk-brought", name=imported.name, count=imported.new)
        steps = joined(map(str, imported.reached))
        goals = say("desk-brought-goals", count=len(imported.reached), steps=steps) if steps else ""
        self._mail.send(Brought(told=f"{count} {goals}".rstrip()))

    def _hand_over(self, name: str, title: str, made: Future[bytes], session: Session) -> None:
        """Have the browser save a file."""
        if (error := made.exception()) is None:
            self._download(name, made.result())
        else:
            session.notices.append(Notice("error", title, str(error)))

    def _do_with(self, number: int, what: str) -> None:
        """Do something with one seat.

        Raises:
            Refused: it is not possible now.
        """
        room, pupil = self.room, self.classroom.pupils.get(number)
        match what:
            case "reset":
                if pupil is None or room.phase not in OWN_BODY:
                    raise Refused(say("class-refuse-no-body"))
                pupil.begin()
            case "show" | "hide":
                room.put_seat_on_wall(number if what == "show" else 0)
                self.classroom.wall_feed = None  # until the seat's page provides it
            case "move":
                room.offer_move(number)
            case "sendAway":
                room.remove(number)

    # --------------------------------------------------------------------- the teacher's body
    @property
    def _again(self) -> Literal["no", "yes", "now"]:
        """Whether the run can be replayed slowly, or is being replayed."""
        if self.room.phase not in HAS_RUN or not self.classroom.run:
            return "no"
        return "yes" if self._usual_speed is None else "now"

    def _replay(self, session: Session) -> None:
        """Play the run's log slowly: bit for bit the same motion.

        Raises:
            Refused: there is no run, or it cannot be played.
        """
        if self._again == "no":
            raise Refused(say("class-refuse-no-replay"))
        try:
            record = decode_log(self.classroom.run, say("desk-the-run"))
        except InputError as error:
            raise Refused(say("class-refuse-replay-broken", reason=str(error))) from None
        if self._usual_speed is None:
            self._usual_speed = session.pacer.speed
        self._replay_begins = True
        session.post(commands.Speed(REPLAY_SPEED))
        session.post(commands.Replay(record))

    def _follow_run(self, session: Session) -> None:
        """Stop the run at the moment that was predicted, take its log, and end a slow replay."""
        if self._usual_speed is not None:
            if not self._replay_begins and session.replay is None:
                session.post(commands.Speed(self._usual_speed))
                self._usual_speed = None
            self._replay_begins = False
            return
        if self.room.phase not in HAS_RUN:
            return
        time, step = session.simulation.time, self.room.step
        predicted = step.predict if step is not None else None
        if session.playing:
            if self.room.phase is Phase.RUN and predicted is not None and time >= predicted:
                session.post(commands.Play(False))
        elif time > self._run_time and time >= (predicted or 0.0) and session.replay is None:
            self._run_time, self.classroom.run = time, session.recorder.file()

    def _lead(self, session: Session) -> None:
        """Prepare the body for the class's phase, and show it to all."""
        room, place = self.room, (self.room.at, self.room.phase, self.room.round)
        # The page begins with the class's present body, or with what its browser had stored of it.
        is_first = self._place is None
        before, self._place = self._place or place, place
        if is_first and room.phase in STARTS_PAUSED:
            session.post(commands.Play(False))
        elif is_first and (room.phase in HAS_RUN or room.phase in OWN_BODY):
            self._open(session)
        elif before != place:
            is_other = before[0] != room.at
            if is_other or room.phase not in HAS_RUN or room.phase is Phase.RUN:
                self._run_time, self.classroom.run = 0.0, b""
            if is_other or room.phase in STARTS_PAUSED or room.phase is Phase.RUN:
                self._open(session)
            if room.phase in STARTS_PAUSED or is_other:
                session.post(commands.Play(False))
            elif room.phase is Phase.RUN:
                session.post(commands.Play(True))
        else:
            self._follow_run(session)
        classroom, step = self.classroom, room.step
        classroom.plots.follow(session, (step.plots or ()) if step is not None else ())
        classroom.shared_view = self._share(session, classroom.shared_view, classroom.audience)

    def _open(self, session: Session) -> None:
        try:
            runs = self.room.phase in HAS_RUN or self.room.phase in OWN_BODY
            scene = self.classroom.run_scene if runs else self.classroom.scene
            session.post(commands.Open(scene(self.room.at)))
            step = self.room.step if runs else None
            session.post(commands.Compare((step.ghost or "") if step is not None else "", ""))
        except SettingError as error:
            session.notices.append(Notice("error", say("desk-cannot-begin"), str(error)))

    # --------------------------------------------------------------------- what the page shows
    def _state(self) -> Desk:
        room, classroom = self.room, self.classroom
        answered, found = room.answered(), found_by(room, room.at)
        after, step = room.next(), room.step
        before, check = room.phase is Phase.LOBBY, check_address(self.address, room.code)
        return Desk(
            code=room.code,
            address=self.address,
            qr=self.qr,
            check=check,
            check_qr=qr_code(check) if before else "",
            tried=tuple(DeskTried(**vars(check)) for check in classroom.checks),
            stops=tuple(
                DeskStop(title=room.title(i), phases=tuple((p.value, round) for p, round in room.order(i)))
                for i in range(len(room.stops))
            ),
            asking=asking(room, reveal=True),
            next=None if after is None else (after[0], after[1].value, after[2]),
            seats=tuple(
                self._seat(seat, seat.number in answered) for seat in room.seats.values() if not seat.removed
            ),
            answers=tuple(
                self._answer(answer)
                for answer in room.answers.values()
                if (answer.stop, answer.round) == (room.at, room.round)
            ),
            bars=tuple(room.bars(room.at, room.vote_round)),
            doing=count_bodies(classroom),
            right=step.question.answer if step is not None and step.question is not None else -1,
            axes=axes_of(room, room.at),
            law=law_of(found),
            shows_law=room.law,
            on_wall=room.on_wall,
            seat_on_wall=room.seat_on_wall,
            gathered=room.gathered,
            again=self._again,
            open=room.is_open,
            own_names=room.own_names,
            paused=room.paused,
            saved=classroom.written == room.version,
            trouble=classroom.trouble,
            lessons=lesson_names() if before and not room.is_home else (),
            lesson=room.scenes[0].name if len(room.scenes) == 1 else "",
            networks=self._networks if before else (),
            home=home_text(room),
            told=room.is_told,
            done=tuple(self._done(stop) for stop in range(len(room.stops))) if room.is_home else (),
            elapsed=time() - room.began if room.began else -1.0,
        )

    def _draw_posters(self, statuses: Mapping[int, PupilStatus]) -> Posters:
        scene = self.classroom.scene(self.room.at)
        springs = ((spring.a, spring.b) for spring in scene.linear_springs)
        return Posters(
            places={str(number): status.places for number, status in statuses.items()},
            start=places_of(np.array([mass.position for mass in scene.masses]).reshape(-1, 2), scene),
            springs=tuple(pair for pair in springs if max(pair) < MAX_PLACES),
        )

    def _done(self, stop: int) -> tuple[int, int]:
        """How many have answered the question of a stop of homework, and how many have handed in."""
        asked, gave = ({"vote", "prediction"}, {"work"})
        answers = [one for one in self.room.answers.values() if one.stop == stop]
        one, other = ({a.seat for a in answers if a.content.kind in kinds} for kinds in (asked, gave))
        return len(one), len(other)

    def _seat(self, seat: rooms.Seat, answered: bool) -> DeskSeat:
        status = self.classroom.statuses.get(seat.number, PupilStatus())
        done = self.room.done(seat.number) if self.room.is_home else ()
        idle = self.room.phase in OWN_BODY and status.is_untouched
        return DeskSeat(
            number=seat.number,
            name=seat.name,
            color=seat.color,
            here=seat.number in self.classroom.pupils,
            two=seat.twins,
            hand=seat.hand,
            answered=answered,
            doing="untouched" if idle else status.word,
            done=done,
            follows=seat.follows,
            digits=seat.move,
        )

    def _answer(self, answer: Answer) -> DeskAnswer:
        content = answer.content
        work = content if isinstance(content, Work) else Work()
        scene, points, text = self.classroom.scene(answer.stop), work.points, content.words
        if isinstance(content, Prediction):
            free, points = predicted(content, scene, self.room.step_at(answer.stop))
            text = moved_text(scene, free, points)
        return DeskAnswer(
            id=answer.id,
            seat=answer.seat,
            kind=content.kind,
            choice=content.choice if isinstance(content, Vote) else -1,
            text=text,
            late=answer.late,
            starred=answer.starred,
            found=work.found,
            setting=work.setting,
            reached=work.reached,
            doubt=doubt_text(work.doubt),
            places=places_of(np.array(points), scene) if points else (),
        )
