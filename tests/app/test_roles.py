"""What pages may say in a class: a pupil's page is no teacher's, whatever it says."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept
from app.classroom.answers import Line, Phase, Vote, Work
from app.classroom.live import MAX_CHECKS, Class, Classes
from app.features.classroom.check_role import CheckRole
from app.features.classroom.desk import DeskRole
from app.features.classroom.role import ClassRole, asking
from app.features.classroom.seat import SeatRole
from app.features.classroom.wall import WallRole
from app.session import commands
from app.session.session import Session
from app.wire import from_page
from app.wire.to_page import Desk, Law, Seat, Taken, Wall
from tests.app.letters import Letters
from tests.app.test_classes import until_written
from tests.app.test_room import a_room, an_answer

LED = tuple(
    msgspec.json.decode(text, type=kind)
    for kind, text in (
        (from_page.Stage, b'{"do":"stage","stop":0,"phase":"try"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"end"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"zip"}'),
        (from_page.Star, b'{"do":"star","answer":"0000000000000001","on":true}'),
        (from_page.ToWall, b'{"do":"toWall","answer":""}'),
        (from_page.OneSeat, b'{"do":"oneSeat","seat":1,"what":"sendAway"}'),
        (from_page.OneSeat, b'{"do":"oneSeat","seat":1,"what":"move"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"gather"}'),
        (from_page.Arrange, b'{"do":"arrange","what":"again"}'),
    )
)


@pytest.fixture
def classroom(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Class:
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


def test_no_page_has_the_right_answer_before_it_is_told() -> None:
    room = a_room()
    seen = []
    while (after := room.next()) is not None and after[0] == 0:
        room.go(*after)
        seen.append((asking(room).right, asking(room).because))
    assert seen == [(-1, "")] * 6 + [(1, "It is.")] * 3


@pytest.mark.parametrize("said", LED)
@pytest.mark.parametrize(
    "make",
    [
        SeatRole,
        lambda classroom, mail: WallRole(classroom, mail, "", ""),
        lambda classroom, mail: DeskRole(classroom, mail, "", "", no_download),
    ],
)
def test_only_a_teacher_leads(
    classroom: Class, session: Session, make: Callable[..., ClassRole], said: from_page.Lead
) -> None:
    classroom.room.enter("0" * 32)
    role = make(classroom, letters := Letters())
    before = msgspec.json.encode(classroom.room)
    for key in ("", "x" * len(classroom.room.key), classroom.room.key[:-1], classroom.room.code):
        role.introduce(who(0, key), session)
        assert not role.allows(said)
        role.hear(said, session)
        role.frame(session)
    assert not classroom.ended
    assert classroom.teachers == 0
    assert not any(isinstance(message, Desk) for message in letters.sent)
    assert msgspec.json.encode(classroom.room) == before


def test_a_teacher_leads_and_is_told_who_is_there(classroom: Class, session: Session) -> None:
    letters = Letters()
    desk = DeskRole(classroom, letters, "http://here/", "", no_download)
    desk.introduce(who(9, classroom.room.key), session)
    seat = SeatRole(classroom, Letters())
    seat.introduce(who(1), session)
    desk.hear(LED[0], session)
    assert classroom.room.phase is Phase.TRY
    desk.frame(session)
    assert [one.here for one in letters.last(Desk).seats] == [True]
    seat.leave()
    desk.frame(session)
    assert [one.here for one in letters.last(Desk).seats] == [False]


def test_a_pupil_is_told_whether_a_teachers_page_is_there(classroom: Class, session: Session) -> None:
    letters = Letters()
    seat = SeatRole(classroom, letters)
    seat.introduce(who(1), session)
    seat.frame(session)
    desk = a_desk(classroom, session, Letters())
    seat.frame(session)
    desk.leave()
    seat.frame(session)
    assert [told.away for told in letters.sent if isinstance(told, Seat)] == [True, False, True]


def test_an_answer_is_acknowledged_once_it_is_on_the_disk_and_counts_once(
    classroom: Class, session: Session
) -> None:
    letters = Letters()
    seat = SeatRole(classroom, letters)
    seat.introduce(who(1), session)
    classroom.room.go(0, Phase.ASK)
    seat.hear(a_vote(1, 2), session)
    seat.hear(a_vote(1, 2), session)
    assert not [message for message in letters.sent if isinstance(message, Taken)]
    until_written(classroom)
    seat.frame(session)
    taken = [message for message in letters.sent if isinstance(message, Taken)]
    assert {id for message in taken for id in message.ids} == {f"{1:016x}"}
    assert classroom.room.bars(0, 0) == [0, 0, 1]
    # A forged one is refused with a sentence, and the page forgets it.
    seat.hear(a_vote(2, 4, turn=1), session)
    assert letters.sent[-1] == Taken(ids=(f"{2:016x}",), refused="The question has no such choice.")


def test_the_last_page_of_a_browser_has_the_seat(classroom: Class, session: Session) -> None:
    first, second = SeatRole(classroom, one := Letters()), SeatRole(classroom, Letters())
    first.introduce(who(1), session)
    second.introduce(who(1), session)
    first.frame(session)
    assert one.sent[-1] == Seat(elsewhere="page") or Seat(elsewhere="page") in one.sent
    first.hear(a_vote(1, 0), session)
    assert not classroom.room.answers
    first.leave()
    assert second.seat is not None


def test_the_wall_has_no_name_and_no_sealed_bar(classroom: Class, session: Session) -> None:
    letters = Letters()
    wall = WallRole(classroom, letters, "http://here/", "")
    seat = SeatRole(classroom, Letters())
    seat.introduce(who(1), session)
    classroom.room.own_names = True
    seat.hear(from_page.NewName("Zaphod"), session)
    classroom.room.go(0, Phase.ASK)
    seat.hear(a_vote(1, 1), session)
    assert isinstance(classroom.room.answers[f"{1:016x}"].content, Vote)
    wall.frame(session)
    told = letters.last(Wall)
    assert (told.answered, told.bars) == (1, ())
    classroom.room.go(0, Phase.RESULTS)
    wall.frame(session)
    assert letters.last(Wall).bars == (0, 1, 0)
    assert all("Zaphod" not in str(message) for message in letters.sent)


def test_a_device_that_only_tries_is_told_to_the_teacher_and_to_nobody_else(
    classroom: Class, session: Session
) -> None:
    letters = Letters()
    desk = DeskRole(classroom, letters, "http://here/", "", no_download)
    desk.introduce(who(9, classroom.room.key), session)
    found = from_page.Checked(23, 58, True, False)
    for role in (SeatRole(classroom, Letters()), WallRole(classroom, Letters(), "", "")):
        assert not role.allows(found)
    check = CheckRole(classroom)
    assert not any(check.allows(said) for said in (*LED, a_vote(1, 0), from_page.RaiseHand(True)))
    for _ in range(MAX_CHECKS + 3):
        check.hear(found, session)
    desk.frame(session)
    told = letters.last(Desk)
    assert [(one.trip, one.rate) for one in told.tried] == MAX_CHECKS * [(23, 58)]
    assert told.check == f"http://here/check?room={classroom.room.code}"
    assert told.check_qr
    # Once the class has begun, it is in the way.
    classroom.room.go(0, Phase.SHOW)
    desk.frame(session)
    assert not letters.last(Desk).check_qr
    # A server without classes has the page, too.
    CheckRole(None).hear(found, session)


def an_order(desk: DeskRole, session: Session, what: str, seat: int = 0) -> None:
    """Have the teacher arrange something, or do something with one seat."""
    desk.hear(from_page.OneSeat(seat, what) if seat else from_page.Arrange(what), session)  # type: ignore[arg-type]


def a_desk(classroom: Class, session: Session, letters: Letters | None = None) -> DeskRole:
    desk = DeskRole(classroom, letters or Letters(), "http://here/", "", no_download)
    desk.introduce(who(9, classroom.room.key), session)
    desk.frame(session)
    return desk


def test_a_seat_follows_the_teacher_and_comes_back_to_its_own_body(
    classroom: Class, session: Session
) -> None:
    letters = Letters()
    desk = a_desk(classroom, session, letters)
    seat, own = SeatRole(classroom, Letters()), Session(sim.rope(), wait=False)
    seat.introduce(who(1), own)
    classroom.room.go(0, Phase.TRY)
    seat.frame(own)
    own.drain()
    own.do_steps(5)
    places, opened = own.simulation.positions.copy(), own.openings
    assert seat.shared_view is None
    seat.hear(from_page.Follow(True), own)
    assert seat.shared_view is classroom.shared_view
    assert not seat.allows(from_page.Perform("reset"))
    seat.frame(own)
    desk.frame(session)
    assert [one.follows for one in letters.last(Desk).seats] == [True]
    seat.hear(from_page.Follow(False), own)
    seat.frame(own)
    own.drain()
    assert seat.shared_view is None
    assert own.openings == opened
    assert (own.simulation.positions == places).all()
    # The teacher has all look at one body, and nobody can help it; then each one has theirs back.
    an_order(desk, session, "gather")
    seat.hear(from_page.Follow(False), own)
    assert seat.shared_view is classroom.shared_view
    an_order(desk, session, "giveBack")
    assert seat.shared_view is None
    assert (own.simulation.positions == places).all()


def test_the_wall_shows_the_body_of_a_seat_and_its_pupil_is_told(classroom: Class, session: Session) -> None:
    desk, letters = a_desk(classroom, session), Letters()
    seat, own = SeatRole(classroom, letters), Session(sim.rope(), wait=False)
    wall = WallRole(classroom, Letters(), "http://here/", "")
    seat.introduce(who(1), own)
    classroom.room.go(0, Phase.TRY)
    seat.frame(own)
    own.drain()
    own.do_steps(5)
    assert wall.shared_view is classroom.shared_view
    an_order(desk, session, "show", seat=1)
    seat.frame(own)
    assert wall.shared_view is not None
    assert wall.shared_view is not classroom.shared_view
    assert (wall.shared_view.picture.positions == own.simulation.positions).all()
    # Pages know two bodies apart by that number.
    assert classroom.shared_view is not None
    assert wall.shared_view.opening != classroom.shared_view.opening
    assert letters.last(Seat).on_wall
    an_order(desk, session, "hide", seat=1)
    assert wall.shared_view is classroom.shared_view


def test_the_run_is_seen_again_slowly_and_bit_for_bit_the_same(classroom: Class) -> None:
    clock = iter(range(10_000))
    session = Session(sim.rope(), clock=lambda: next(clock) / 240.0, wait=True)
    desk = a_desk(classroom, session)
    classroom.room.go(0, Phase.RUN)

    def run() -> list[tuple[float, bytes]]:
        """Until it stands: each moment that was shown."""
        shown = []
        for _ in range(3000):
            desk.frame(session)
            session.drain()
            session.tick(1.0)
            assert classroom.shared_view is not None
            shown.append(
                (classroom.shared_view.picture.time, classroom.shared_view.picture.positions.tobytes())
            )
            if not session.playing and session.simulation.time >= 2.0:
                desk.frame(session)
                return shown
        raise AssertionError("it does not stand")

    first, stood = run(), session.simulation.time
    end = session.simulation.positions.copy()
    assert classroom.run
    for _ in range(2):
        an_order(desk, session, "again")
        session.drain()
        again = run()
        assert session.simulation.time == stood
        assert session.simulation.positions.tobytes() == end.tobytes()
        # Whatever both have shown is the same, and it takes four times as many frames.
        both = dict(first).keys() & dict(again).keys()
        assert len(both) > 20
        assert all(dict(first)[time] == dict(again)[time] for time in both)
        assert len(again) > 3 * len(first)
        assert "agrees with the log" in session.notices[-1].text
        desk.frame(session)
        session.drain()
        assert session.pacer.speed == 1.0


def test_there_is_nothing_to_see_again_before_a_run(classroom: Class, session: Session) -> None:
    desk = a_desk(classroom, session)
    an_order(desk, session, "again")
    assert session.notices[-1].text == "There is no run to see again."


def test_the_wall_counts_every_seat_that_is_here_once(classroom: Class, session: Session) -> None:
    letters = Letters()
    wall = WallRole(classroom, letters, "http://here/", "")
    classroom.room.go(0, Phase.TRY)
    now = [0.0]
    sessions = [Session(sim.rope(), clock=lambda: now[0], wait=False) for _ in range(3)]
    seats = [SeatRole(classroom, Letters()) for _ in sessions]
    for number, (seat, own) in enumerate(zip(seats, sessions, strict=True), start=1):
        seat.introduce(who(number), own)
        seat.frame(own)
        own.drain()
    sessions[0].post(commands.SetValue("gravity", 500.0))
    sessions[0].drain()
    classroom.room.enter(f"{4:032x}")  # has left
    now[0] = 1.0
    for seat, own in zip(seats, sessions, strict=True):
        seat.frame(own)
    wall.frame(session)
    assert letters.last(Wall).doing == {"stable": 1, "exploded": 0, "not begun": 2}
    assert letters.last(Wall).seats == 3


def test_who_left_is_not_waited_for_unless_they_answered(classroom: Class, session: Session) -> None:
    letters, pages = Letters(), [SeatRole(classroom, Letters()) for _ in range(3)]
    wall = WallRole(classroom, letters, "http://here/", "")
    for number, page in enumerate(pages, start=1):
        page.introduce(who(number), session)
    classroom.room.go(0, Phase.EXPLAIN)
    classroom.room.take(1, an_answer(1, Line("Because.")))
    classroom.room.take(2, an_answer(2, Line("Why not.")))
    for page in pages[1:]:
        page.leave()
    wall.frame(session)
    told = letters.last(Wall)
    assert (told.answered, told.seats) == (2, 2)


def test_the_law_is_on_the_wall_only_when_it_is_asked_for(classroom: Class, session: Session) -> None:
    letters, desk_letters = Letters(), Letters()
    desk = a_desk(classroom, session, desk_letters)
    wall = WallRole(classroom, letters, "http://here/", "")
    classroom.room.go(0, Phase.COLLECT)
    for number, setting in enumerate((1.0, 4.0, 9.0), start=1):
        seat = classroom.room.enter(f"{number:032x}")
        work = Work(setting=setting, found=2.0 * setting**0.5, points=((0.0, 0.0),) * 4)
        classroom.room.take(seat.number, an_answer(number, work))

    def law() -> Law | None:
        wall.frame(session)
        return letters.last(Wall).law

    assert law() is None
    an_order(desk, session, "law")
    found = law()
    assert found is not None
    assert (found.factor, found.exponent) == (pytest.approx(2.0), pytest.approx(0.5))
    desk.frame(session)
    told = desk_letters.last(Desk)
    assert told.shows_law
    assert [len(answer.places) for answer in told.answers] == [4, 4, 4]
    an_order(desk, session, "noLaw")
    assert law() is None
    # What was handed in stands on the wall as it was.
    classroom.room.put_on_wall(f"{2:016x}")
    assert wall.shared_view is not None
    assert wall.shared_view.picture.positions.tolist() == [[0.0, 0.0]] * 4
    classroom.room.put_on_wall("")
    assert wall.shared_view is classroom.shared_view
