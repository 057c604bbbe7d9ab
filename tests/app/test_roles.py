"""What pages may say in a class: a pupil's page is no teacher's, whatever it says."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept
from app.classroom.live import MOST_TRIED, Class, Classes
from app.classroom.room import Phase, Vote
from app.page.check.role import CheckRole
from app.page.classroom.desk import DeskRole
from app.page.classroom.role import ClassRole
from app.page.classroom.seat import SeatRole
from app.page.classroom.wall import WallRole
from app.session.session import Session
from app.wire import from_page
from app.wire.to_page import Desk, Seat, Taken, Wall
from tests.app.letters import Letters
from tests.app.test_classes import until_written
from tests.app.test_room import a_room

LED = tuple(
    msgspec.json.decode(text, type=kind)
    for kind, text in (
        (from_page.Stage, b'{"do":"stage","stop":0,"phase":"try"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"end"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"zip"}'),
        (from_page.Star, b'{"do":"star","answer":"0000000000000001","on":true}'),
        (from_page.ToWall, b'{"do":"toWall","answer":""}'),
        (from_page.SendAway, b'{"do":"sendAway","seat":1}'),
    )
)


@pytest.fixture
def klass(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Class:
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path)
    return Classes().begin(a_room().scenes)


@pytest.fixture
def session() -> Session:
    return Session(sim.rope(), wait=False)


def who(number: int, teacher: str = "") -> from_page.Who:
    return from_page.Who(f"{number:032x}", "", teacher)


def a_vote(id: int, choice: int, turn: int = 0) -> from_page.GiveVote:
    return from_page.GiveVote(f"{id:016x}", turn, 0, 0, 0, choice)


def no_download(name: str, data: bytes) -> None:
    raise AssertionError(name)


@pytest.mark.parametrize("said", LED)
@pytest.mark.parametrize(
    "make",
    [
        SeatRole,
        lambda klass, mail: WallRole(klass, mail, "", ""),
        lambda klass, mail: DeskRole(klass, mail, "", "", no_download),
    ],
)
def test_only_a_teacher_leads(
    klass: Class, session: Session, make: Callable[..., ClassRole], said: from_page.Lead
) -> None:
    klass.room.enter("0" * 32)
    role = make(klass, Letters())
    before = msgspec.json.encode(klass.room)
    for key in ("", "x" * len(klass.room.key), klass.room.key[:-1], klass.room.code):
        role.introduce(who(0, key), session)
        assert not role.allows(said)
        role.hear(said, session)
    assert not klass.ended
    assert msgspec.json.encode(klass.room) == before


def test_a_teacher_leads_and_is_told_who_is_there(klass: Class, session: Session) -> None:
    letters = Letters()
    desk = DeskRole(klass, letters, "http://here/", "", no_download)
    desk.introduce(who(9, klass.room.key), session)
    seat = SeatRole(klass, Letters())
    seat.introduce(who(1), session)
    desk.hear(LED[0], session)
    assert klass.room.phase is Phase.TRY
    desk.frame(session)
    told = next(message for message in letters.sent if isinstance(message, Desk))
    assert [one.here for one in told.seats] == [True]
    seat.leave()
    desk.frame(session)
    told = [message for message in letters.sent if isinstance(message, Desk)][-1]
    assert [one.here for one in told.seats] == [False]


def test_an_answer_is_acknowledged_once_it_is_on_the_disk_and_counts_once(
    klass: Class, session: Session
) -> None:
    letters = Letters()
    seat = SeatRole(klass, letters)
    seat.introduce(who(1), session)
    klass.room.go(0, Phase.ASK)
    seat.hear(a_vote(1, 2), session)
    seat.hear(a_vote(1, 2), session)
    assert not [message for message in letters.sent if isinstance(message, Taken)]
    until_written(klass)
    seat.frame(session)
    taken = [message for message in letters.sent if isinstance(message, Taken)]
    assert {id for message in taken for id in message.ids} == {f"{1:016x}"}
    assert klass.room.bars(0, 0) == [0, 0, 1]
    # A forged one is refused with a sentence, and the page forgets it.
    seat.hear(a_vote(2, 4, turn=1), session)
    assert letters.sent[-1] == Taken(ids=(f"{2:016x}",), refused="The question has no such choice.")


def test_the_last_page_of_a_browser_has_the_seat(klass: Class, session: Session) -> None:
    first, second = SeatRole(klass, one := Letters()), SeatRole(klass, Letters())
    first.introduce(who(1), session)
    second.introduce(who(1), session)
    first.frame(session)
    assert one.sent[-1] == Seat(elsewhere=True) or Seat(elsewhere=True) in one.sent
    first.hear(a_vote(1, 0), session)
    assert not klass.room.answers
    first.leave()
    assert second.seat is not None


def test_the_wall_has_no_name_and_no_sealed_bar(klass: Class, session: Session) -> None:
    letters = Letters()
    wall = WallRole(klass, letters, "http://here/", "")
    seat = SeatRole(klass, Letters())
    seat.introduce(who(1), session)
    klass.room.own_names = True
    seat.hear(from_page.NewName("Zaphod"), session)
    klass.room.go(0, Phase.ASK)
    seat.hear(a_vote(1, 1), session)
    assert isinstance(klass.room.answers[f"{1:016x}"].content, Vote)
    wall.frame(session)
    told = [message for message in letters.sent if isinstance(message, Wall)][-1]
    assert (told.answered, told.bars) == (1, ())
    klass.room.go(0, Phase.RESULTS)
    wall.frame(session)
    told = [message for message in letters.sent if isinstance(message, Wall)][-1]
    assert told.bars == (0, 1, 0)
    assert all("Zaphod" not in str(message) for message in letters.sent)


def test_a_device_that_only_tries_is_told_to_the_teacher_and_to_nobody_else(
    klass: Class, session: Session
) -> None:
    letters = Letters()
    desk = DeskRole(klass, letters, "http://here/", "", no_download)
    desk.introduce(who(9, klass.room.key), session)
    found = from_page.Checked(23, 58, True, False)
    for role in (SeatRole(klass, Letters()), WallRole(klass, Letters(), "", "")):
        assert not role.allows(found)
    check = CheckRole(klass)
    assert not any(check.allows(said) for said in (*LED, a_vote(1, 0), from_page.RaiseHand(True)))
    for _ in range(MOST_TRIED + 3):
        check.hear(found, session)
    desk.frame(session)
    told = letters.last(Desk)
    assert [(one.trip, one.rate) for one in told.tried] == MOST_TRIED * [(23, 58)]
    assert told.check == f"http://here/check?room={klass.room.code}"
    assert told.check_qr
    # Once the class has begun, it is in the way.
    klass.room.go(0, Phase.SHOW)
    desk.frame(session)
    assert not letters.last(Desk).check_qr
    # A server without classes has the page, too.
    CheckRole(None).hear(found, session)
