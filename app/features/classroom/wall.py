"""The wall: what the class sees on the projector. It has no panel, ignores hands, and shows no names."""

from __future__ import annotations

import numpy as np

from app.classroom.answers import Line, Phase, Vote, Work
from app.classroom.axes import axes_of
from app.classroom.live import Class, SharedView
from app.classroom.plotted import Plotted
from app.classroom.room import Place
from sim.errors import SettingError

from ...session.session import Session
from ...stage.plan import Picture
from ...stage.sketch import Mapping
from ...wire.carrier import Mail
from .messages import Wall, WallLine
from .role import (
    SHOWN,
    ClassRole,
    asking,
    count_bodies,
    found_by,
    in_world,
    law_of,
    plan_numbers,
    predictions,
)


class WallRole(ClassRole):
    """One window for a projector.

    Args:
        classroom: the class.
        mail: to the page's script.
        address: by which pupils come in, unless the teacher chooses another.
    """

    def __init__(self, classroom: Class, mail: Mail, address: str) -> None:
        super().__init__(classroom, mail, address)
        self._work_view: tuple[str, SharedView | None] = "", None  # by the id of the answer
        self._works = 0

    @property
    def front_plots(self) -> Plotted | None:
        return self.classroom.plots if self.room.phase in (Phase.RUN, Phase.REVEAL) else None

    @property
    def shared_view(self) -> SharedView | None:
        room, classroom = self.room, self.classroom
        alone = classroom.wall_feed if room.seat_on_wall else self._view_of_work(room.on_wall)
        return alone or classroom.shared_view

    def _update(self, session: Session) -> None:
        room = self.room
        doing = count_bodies(self.classroom)
        if not self._is_new(tuple(doing.values())):
            return
        found, answered = found_by(room, room.at), room.answered()
        voted = room.phase in SHOWN and bool(room.given(room.at, 0, Vote))
        present = self.classroom.present()
        lines = room.given(room.at, 0, Line) if room.phase is not Phase.EXPLAIN else []
        self._mail.send(
            Wall(
                code=room.code,
                address=self.address,
                qr=self.qr,
                seats=len(present),
                answered=len(answered & present),
                asking=asking(room, place=Place(room.at, Phase.LOBBY) if room.is_home else None),
                bars=tuple(room.bars(room.at, room.vote_round)) if voted else (),
                lines=tuple(
                    WallLine(text=line.text, color=room.seats[answer.seat].color)
                    for answer, line in lines
                    if answer.starred
                ),
                alone=bool(room.on_wall or room.seat_on_wall),
                paused=room.paused,
                found=found,
                axes=axes_of(room, room.at),
                law=law_of(found) if room.law else None,
                doing=doing,
                start=self._start() if room.phase is Phase.REVEAL else (),
                steps=len(room.stops),
                unit=room.scenes[room.stops[room.at].scene].view.unit,
            )
        )
        self._mail.send(predictions(self.classroom))

    def _start(self) -> tuple[tuple[float, float], ...]:
        """Where the masses are as the step begins."""
        try:
            scene = self.classroom.scene(self.room.at)
        except SettingError:
            return ()
        return in_world(Mapping.of(scene), Picture.at_start(scene).positions)

    def _view_of_work(self, id: str) -> SharedView | None:
        """Return a view of the body of a run that was handed in; None if the answer is no run."""
        if self._work_view[0] != id:
            answer, view = self.room.answers.get(id), None
            if answer is not None and isinstance(answer.content, Work):
                view = self._still(answer.content, answer.stop)
            self._work_view = id, view
        return self._work_view[1]

    def _still(self, work: Work, stop: int) -> SharedView | None:
        try:
            scene = self.classroom.scene(stop)
        except SettingError:
            return None
        if len(work.points) != len(scene.masses):
            return None
        self._works += 1
        opening = self._first_opening + self._works
        angles = np.array([spring.rest_angle for spring in scene.angular_springs], float)
        picture = Picture(np.array(work.points), damage=work.damage)
        return SharedView(next(plan_numbers), set(), scene, opening, angles, picture, False, 1.0)
