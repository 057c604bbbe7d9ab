"""The wall: what the class sees in front. It has no panel, takes no hands, and shows no name."""

from __future__ import annotations

import numpy as np

from app.classroom.live import Class, Front
from app.classroom.room import FREE, PHASE_OF, Line, Phase, Vote, Work
from sim.errors import SettingError

from ...session.session import Session
from ...stage.plan import Picture
from ...wire.carrier import Mail
from ...wire.to_page import Wall, WallLine
from .role import ClassRole, asking, found_by, law_of, over, plan_numbers, predictions


class WallRole(ClassRole):
    """One window for a projector.

    Args:
        klass: the class.
        mail: to the page's script.
        address: by which pupils come in.
        qr: a picture of its QR code, as an address.
    """

    def __init__(self, klass: Class, mail: Mail, address: str, qr: str) -> None:
        super().__init__(klass, mail)
        self._address, self._qr = address, qr
        self._work: tuple[str, Front | None] = "", None
        self._works = 0

    @property
    def front(self) -> Front | None:
        if self.room.seat_on_wall:
            return self.klass.lent or self.klass.front
        return self._front_of_work() or self.klass.front

    def frame(self, session: Session) -> None:
        if self._tell_end():
            return
        self.klass.tend()
        room = self.room
        doing = self._doing() if room.phase in FREE else {}
        if not self._is_new(tuple(doing.values())):
            return
        found = found_by(room)
        answered = answered_by(self.klass)
        shown = room.phase in (Phase.RESULTS, Phase.RUN, Phase.EXPLAIN)
        voted = shown and bool(room.given(room.at, 0, Vote))
        lines = [answer for answer in room.given(room.at, 0, Line) if answer.starred]
        self._mail.send(
            Wall(
                code=room.code,
                address=self._address,
                qr=self._qr,
                seats=len(seats_here(self.klass) | answered),
                answered=len(answered),
                asking=asking(room),
                bars=tuple(room.bars(room.at, room.vote_round)) if voted else (),
                lines=tuple(
                    WallLine(text=answer.content.text, color=room.seats[answer.seat].color)
                    for answer in lines
                    if isinstance(answer.content, Line) and room.phase is not Phase.EXPLAIN
                ),
                alone=bool(room.on_wall or room.seat_on_wall),
                paused=room.paused,
                found=found,
                over=over(self.klass),
                law=law_of(found) if room.law else None,
                doing=doing,
            )
        )
        self._mail.send(predictions(self.klass))

    def _doing(self) -> dict[str, int]:
        """How many bodies are stable, have exploded, or have not been begun with, of the seats that are here.
        With a goal, also how many have reached it."""
        seats = seats_here(self.klass)
        bodies = [self.klass.doing.get(number) for number in seats]
        exploded = sum(one is not None and one.word == "exploded" for one in bodies)
        idle = sum(one is None or (one.word != "exploded" and not one.begun) for one in bodies)
        counts = {"stable": len(seats) - exploded - idle, "exploded": exploded, "not begun": idle}
        if (step := self.room.step) is not None and step.goal is not None:
            counts["at the goal"] = sum(one is not None and one.word == "goal reached" for one in bodies)
        return counts

    def _front_of_work(self) -> Front | None:
        """The body of a run that was handed in, if that is on the wall."""
        id = self.room.on_wall
        if self._work[0] != id:
            answer, front = self.room.answers.get(id), None
            if answer is not None and isinstance(work := answer.content, Work):
                front = self._still(work, answer.stop)
            self._work = id, front
        return self._work[1]

    def _still(self, work: Work, stop: int) -> Front | None:
        try:
            scene = self.klass.scene(stop)
        except SettingError:
            return None
        if len(work.points) != len(scene.masses):
            return None
        self._works += 1
        opening = self._first_opening + self._works
        angles = np.array([spring.rest_angle for spring in scene.angular_springs], float)
        return Front(
            next(plan_numbers),
            set(),
            scene,
            opening,
            angles,
            Picture(np.array(work.points), damage=work.damage),
            False,
            1.0,
        )


def seats_here(klass: Class) -> set[int]:
    """Numbers of the seats that somebody sits at."""
    seats = klass.room.seats
    return {number for number in klass.pupils if number in seats and not seats[number].removed}


def answered_by(klass: Class) -> set[int]:
    """Numbers of the seats that have given what is asked for now."""
    room = klass.room
    kinds = [kind for kind, phase in PHASE_OF.items() if phase is room.phase]
    return {a.seat for kind in kinds for a in room.given(room.at, room.round, kind)}
