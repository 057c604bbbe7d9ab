"""The wall: what the class sees in front. It has no panel, takes no hands, and shows no name."""

from __future__ import annotations

from collections import Counter

from app.classroom.live import Class
from app.classroom.room import PHASE_OF, Line, Phase, Vote, Work

from ...session.session import Session
from ...wire.carrier import Mail
from ...wire.to_page import Found, Wall, WallLine
from .role import ClassRole, asking, predictions


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

    def frame(self, session: Session) -> None:
        if self._tell_end():
            return
        self.klass.tend()
        words = tuple(one.word for one in self.klass.doing.values() if one.word)
        if not self._is_new(words):
            return
        room = self.room
        shown = room.phase in (Phase.RESULTS, Phase.RUN, Phase.EXPLAIN)
        lines = [answer for answer in room.given(room.at, 0, Line) if answer.starred]
        self._mail.tell(
            Wall(
                code=room.code,
                address=self._address,
                qr=self._qr,
                seats=sum(not seat.removed for seat in room.seats.values()),
                answered=answered(self.klass),
                asking=asking(room),
                bars=tuple(room.bars(room.at, room.round)) if shown and room.given(room.at, 0, Vote) else (),
                lines=tuple(
                    WallLine(text=answer.content.text, color=room.seats[answer.seat].color)
                    for answer in lines
                    if isinstance(answer.content, Line) and room.phase is not Phase.EXPLAIN
                ),
                alone=bool(room.on_wall),
                paused=room.paused,
                found=tuple(
                    Found(setting=work.setting, found=work.found)
                    for answer in room.given(room.at, 0, Work)
                    if isinstance(work := answer.content, Work)
                    and work.setting is not None
                    and work.found is not None
                    and not work.doubt
                ),
                over=next(iter(step.controls), "") if (step := room.step) is not None else "",
                doing=dict(Counter(words)),
            )
        )
        self._mail.tell(predictions(self.klass))


def answered(klass: Class) -> int:
    """How many seats have given what is asked for now."""
    room = klass.room
    kinds = [kind for kind, phase in PHASE_OF.items() if phase is room.phase]
    return len({a.seat for kind in kinds for a in room.given(room.at, room.round, kind)})
