"""Pages of a class, without pages."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import sim
from app.classroom.live import Class
from app.features.classroom import messages as class_messages
from app.features.classroom.desk import DeskRole
from app.features.classroom.role import ClassRole
from app.features.classroom.seat import SeatRole
from app.features.classroom.wall import WallRole
from app.session.session import Session
from app.wire import from_page
from app.wire.messages import FromPage, ToPage
from tests.app.letters import Letters

ADDRESS = "http://here/"
_T = TypeVar("_T", bound=ToPage)


def who(number: int, teacher: str = "") -> from_page.Who:
    return from_page.Who(f"{number:032x}", "", teacher)


def a_vote(id: int, choice: int, turn: int = 0) -> class_messages.GiveVote:
    return class_messages.GiveVote(f"{id:016x}", turn, 0, 0, 0, choice)


def no_download(name: str, data: bytes) -> None:
    raise AssertionError(name)


class Somebody:
    """A page of a class: its role, what it was told, and its session.

    Args:
        role: of the page, by its mail.
        session: of the page; one with a rope by default.
    """

    def __init__(self, role: Callable[[Letters], ClassRole], session: Session | None = None) -> None:
        self.letters = Letters()
        self.role = role(self.letters)
        self.session = session or Session(sim.rope(), wait=False)

    def introduce(self, number: int, key: str = "") -> None:
        self.role.introduce(who(number, key), self.session)

    def say(self, *said: FromPage) -> None:
        for one in said:
            self.role.hear(one, self.session)

    def frame(self) -> None:
        self.role.frame(self.session)
        self.session.drain()

    def shown(self, kind: type[_T]) -> _T:
        """What the page has of a kind of state after a frame."""
        self.frame()
        return self.letters.last(kind)

    def told(self, kind: type[_T]) -> list[_T]:
        """All of a kind that it was told so far."""
        return [message for message in self.letters.sent if isinstance(message, kind)]


class Pupil(Somebody):
    """A pupil's page, which has a seat."""

    role: SeatRole

    def __init__(self, classroom: Class, number: int = 1, session: Session | None = None) -> None:
        super().__init__(lambda mail: SeatRole(classroom, mail), session)
        self.introduce(number)


class Wall(Somebody):
    """The page for the projector."""

    def __init__(self, classroom: Class) -> None:
        super().__init__(lambda mail: WallRole(classroom, mail, ADDRESS))


class Teacher(Somebody):
    """A teacher's page."""

    role: DeskRole

    def __init__(self, classroom: Class, session: Session | None = None) -> None:
        super().__init__(lambda mail: DeskRole(classroom, mail, ADDRESS, no_download), session)
        self.introduce(9, classroom.room.key)
        self.frame()

    def arrange(self, what: str, seat: int = 0) -> None:
        """Arrange something, or do something with one seat."""
        self.say(class_messages.OneSeat(seat, what) if seat else class_messages.Arrange(what))  # type: ignore[arg-type]
