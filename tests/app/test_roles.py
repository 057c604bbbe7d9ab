"""What pages may say in a class: a pupil's page is no teacher's, whatever it says."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept
from app.classroom.live import MAX_TRIED, Class, Classes
from app.classroom.room import Line, Phase, Vote, Work
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
        lambda klass, mail: WallRole(klass, mail, "", ""),
        lambda klass, mail: DeskRole(klass, mail, "", "", no_download),
    ],
)
def test_only_a_teacher_leads(
    klass: Class, session: Session, make: Callable[..., ClassRole], said: from_page.Lead
) -> None:
    klass.room.enter("0" * 32)
    role = make(klass, letters := Letters())
    before = msgspec.json.encode(klass.room)
    for key in ("", "x" * len(klass.room.key), klass.room.key[:-1], klass.room.code):
        role.introduce(who(0, key), session)
        assert not role.allows(said)
        role.hear(said, session)
        role.frame(session)
    assert not klass.ended
    assert klass.teachers == 0
    assert not any(isinstance(message, Desk) for message in letters.sent)
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
    assert [one.here for one in letters.last(Desk).seats] == [True]
    seat.leave()
    desk.frame(session)
    assert [one.here for one in letters.last(Desk).seats] == [False]


def test_a_pupil_is_told_whether_a_teachers_page_is_there(klass: Class, session: Session) -> None:
    letters = Letters()
    seat = SeatRole(klass, letters)
    seat.introduce(who(1), session)
    seat.frame(session)
    desk = a_desk(klass, session, Letters())
    seat.frame(session)
    desk.leave()
    seat.frame(session)
    assert [told.away for told in letters.sent if isinstance(told, Seat)] == [True, False, True]


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
    assert one.sent[-1] == Seat(elsewhere="page") or Seat(elsewhere="page") in one.sent
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
    told = letters.last(Wall)
    assert (told.answered, told.bars) == (1, ())
    klass.room.go(0, Phase.RESULTS)
    wall.frame(session)
    assert letters.last(Wall).bars == (0, 1, 0)
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
    for _ in range(MAX_TRIED + 3):
        check.hear(found, session)
    desk.frame(session)
    told = letters.last(Desk)
    assert [(one.trip, one.rate) for one in told.tried] == MAX_TRIED * [(23, 58)]
    assert told.check == f"http://here/check?room={klass.room.code}"
    assert told.check_qr
    # Once the class has begun, it is in the way.
    klass.room.go(0, Phase.SHOW)
    desk.frame(session)
    assert not letters.last(Desk).check_qr
    # A server without classes has the page, too.
    CheckRole(None).hear(found, session)


def an_order(desk: DeskRole, session: Session, what: str, seat: int = 0) -> None:
    """Have the teacher arrange something, or do something with one seat."""
    desk.hear(from_page.OneSeat(seat, what) if seat else from_page.Arrange(what), session)  # type: ignore[arg-type]


def a_desk(klass: Class, session: Session, letters: Letters | None = None) -> DeskRole:
    desk = DeskRole(klass, letters or Letters(), "http://here/", "", no_download)
    desk.introduce(who(9, klass.room.key), session)
    desk.frame(session)
    return desk


def test_a_seat_follows_the_teacher_and_comes_back_to_its_own_body(klass: Class, session: Session) -> None:
    letters = Letters()
    desk = a_desk(klass, session, letters)
    seat, own = SeatRole(klass, Letters()), Session(sim.rope(), wait=False)
    seat.introduce(who(1), own)
    klass.room.go(0, Phase.TRY)
    seat.frame(own)
    own.drain()
    own.do_steps(5)
    places, opened = own.simulation.positions.copy(), own.openings
    assert seat.front is None
    seat.hear(from_page.Follow(True), own)
    assert seat.front is klass.front
    assert not seat.allows(from_page.Perform("reset"))
    seat.frame(own)
    desk.frame(session)
    assert [one.follows for one in letters.last(Desk).seats] == [True]
    seat.hear(from_page.Follow(False), own)
    seat.frame(own)
    own.drain()
    assert seat.front is None
    assert own.openings == opened
    assert (own.simulation.positions == places).all()
    # The teacher has all look at one body, and nobody can help it; then each one has theirs back.
    an_order(desk, session, "gather")
    seat.hear(from_page.Follow(False), own)
    assert seat.front is klass.front
    an_order(desk, session, "giveBack")
    assert seat.front is None
    assert (own.simulation.positions == places).all()


def test_the_wall_shows_the_body_of_a_seat_and_its_pupil_is_told(klass: Class, session: Session) -> None:
    desk, letters = a_desk(klass, session), Letters()
    seat, own = SeatRole(klass, letters), Session(sim.rope(), wait=False)
    wall = WallRole(klass, Letters(), "http://here/", "")
    seat.introduce(who(1), own)
    klass.room.go(0, Phase.TRY)
    seat.frame(own)
    own.drain()
    own.do_steps(5)
    assert wall.front is klass.front
    an_order(desk, session, "show", seat=1)
    seat.frame(own)
    assert wall.front is not None
    assert wall.front is not klass.front
    assert (wall.front.picture.positions == own.simulation.positions).all()
    # Pages know two bodies apart by that number.
    assert klass.front is not None
    assert wall.front.opening != klass.front.opening
    assert letters.last(Seat).on_wall
    an_order(desk, session, "hide", seat=1)
    assert wall.front is klass.front


def test_the_run_is_seen_again_slowly_and_bit_for_bit_the_same(klass: Class) -> None:
    clock = iter(range(10_000))
    session = Session(sim.rope(), clock=lambda: next(clock) / 240.0, wait=True)
    desk = a_desk(klass, session)
    klass.room.go(0, Phase.RUN)

    def run() -> list[tuple[float, bytes]]:
        """Until it stands: each moment that was shown."""
        shown = []
        for _ in range(3000):
            desk.frame(session)
            session.drain()
            session.tick(1.0)
            assert klass.front is not None
            shown.append((klass.front.picture.time, klass.front.picture.positions.tobytes()))
            if not session.playing and session.simulation.time >= 2.0:
                desk.frame(session)
                return shown
        raise AssertionError("it does not stand")

    first, stood = run(), session.simulation.time
    end = session.simulation.positions.copy()
    assert klass.run
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


def test_there_is_nothing_to_see_again_before_a_run(klass: Class, session: Session) -> None:
    desk = a_desk(klass, session)
    an_order(desk, session, "again")
    assert session.notices[-1].text == "There is no run to see again."


def test_the_wall_counts_every_seat_that_is_here_once(klass: Class, session: Session) -> None:
    letters = Letters()
    wall = WallRole(klass, letters, "http://here/", "")
    klass.room.go(0, Phase.TRY)
    now = [0.0]
    sessions = [Session(sim.rope(), clock=lambda: now[0], wait=False) for _ in range(3)]
    seats = [SeatRole(klass, Letters()) for _ in sessions]
    for number, (seat, own) in enumerate(zip(seats, sessions, strict=True), start=1):
        seat.introduce(who(number), own)
        seat.frame(own)
        own.drain()
    sessions[0].post(commands.SetValue("gravity", 500.0))
    sessions[0].drain()
    klass.room.enter(f"{4:032x}")  # has left
    now[0] = 1.0
    for seat, own in zip(seats, sessions, strict=True):
        seat.frame(own)
    wall.frame(session)
    assert letters.last(Wall).doing == {"stable": 1, "exploded": 0, "not begun": 2}
    assert letters.last(Wall).seats == 3


def test_who_left_is_not_waited_for_unless_they_answered(klass: Class, session: Session) -> None:
    letters, pages = Letters(), [SeatRole(klass, Letters()) for _ in range(3)]
    wall = WallRole(klass, letters, "http://here/", "")
    for number, page in enumerate(pages, start=1):
        page.introduce(who(number), session)
    klass.room.go(0, Phase.EXPLAIN)
    klass.room.take(1, an_answer(1, Line("Because.")))
    klass.room.take(2, an_answer(2, Line("Why not.")))
    for page in pages[1:]:
        page.leave()
    wall.frame(session)
    told = letters.last(Wall)
    assert (told.answered, told.seats) == (2, 2)


def test_the_law_is_on_the_wall_only_when_it_is_asked_for(klass: Class, session: Session) -> None:
    letters, desk_letters = Letters(), Letters()
    desk = a_desk(klass, session, desk_letters)
    wall = WallRole(klass, letters, "http://here/", "")
    klass.room.go(0, Phase.COLLECT)
    for number, setting in enumerate((1.0, 4.0, 9.0), start=1):
        seat = klass.room.enter(f"{number:032x}")
        work = Work(setting=setting, found=2.0 * setting**0.5, points=((0.0, 0.0),) * 4)
        klass.room.take(seat.number, an_answer(number, work))

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
    klass.room.put_on_wall(f"{2:016x}")
    assert wall.front is not None
    assert wall.front.picture.positions.tolist() == [[0.0, 0.0]] * 4
    klass.room.put_on_wall("")
    assert wall.front is klass.front
