"""What pages may say in a class: a pupil's page is no teacher's, whatever it says."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom.answers import OWN_BODY, Line, Phase, Vote, Work
from app.classroom.live import MAX_CHECKS, Class, Classes
from app.features.classroom import messages as class_messages
from app.features.classroom.check_role import CheckRole
from app.features.classroom.desk import DeskRole
from app.features.classroom.messages import Desk, Seat, Taken
from app.features.classroom.role import ClassRole, asking
from app.features.classroom.seat import SeatRole
from app.features.classroom.wall import WallRole
from app.features.describe.messages import Describe
from app.session import commands
from app.session.session import Session
from app.wire import from_page
from tests.app.classrooms import ADDRESS, Pupil, Somebody, Teacher, Wall, a_vote, no_download
from tests.app.test_classes import until_written
from tests.app.test_room import a_room, an_answer

LED = tuple(
    msgspec.json.decode(text, type=kind)
    for kind, text in (
        (class_messages.Stage, b'{"do":"stage","stop":0,"phase":"try"}'),
        (class_messages.Arrange, b'{"do":"arrange","what":"end"}'),
        (class_messages.Arrange, b'{"do":"arrange","what":"zip"}'),
        (class_messages.Star, b'{"do":"star","answer":"0000000000000001","on":true}'),
        (class_messages.ToWall, b'{"do":"toWall","answer":""}'),
        (class_messages.OneSeat, b'{"do":"oneSeat","seat":1,"what":"sendAway"}'),
        (class_messages.OneSeat, b'{"do":"oneSeat","seat":1,"what":"move"}'),
        (class_messages.Arrange, b'{"do":"arrange","what":"gather"}'),
        (class_messages.Arrange, b'{"do":"arrange","what":"again"}'),
    )
)


@pytest.fixture
def classroom(class_folder: Path) -> Class:
    return Classes().begin(a_room().scenes)


def test_no_page_has_the_right_answer_before_it_is_told() -> None:
    room = a_room()
    seen = []
    while (after := room.next()) is not None and after[0] == 0:
        room.go(*after)
        seen.append((asking(room).right, asking(room).because))
    assert seen == [(-1, "")] * 4 + [(1, "It is.")] * 3


@pytest.mark.parametrize("said", LED)
@pytest.mark.parametrize(
    "make",
    [
        SeatRole,
        lambda room, mail: WallRole(room, mail, ""),
        lambda room, mail: DeskRole(room, mail, "", no_download),
    ],
)
def test_only_a_teacher_leads(
    classroom: Class, make: Callable[..., ClassRole], said: class_messages.Lead
) -> None:
    classroom.room.enter("0" * 32)
    page = Somebody(lambda mail: make(classroom, mail))
    before = msgspec.json.encode(classroom.room)
    for key in ("", "x" * len(classroom.room.key), classroom.room.key[:-1], classroom.room.code):
        page.introduce(0, key)
        assert not page.role.allows(said)
        page.say(said)
        page.frame()
    assert not classroom.ended
    assert classroom.teachers == 0
    assert not page.told(Desk)
    assert msgspec.json.encode(classroom.room) == before


def test_a_teacher_leads_and_is_told_who_is_there(classroom: Class) -> None:
    teacher, pupil = Teacher(classroom), Pupil(classroom)
    teacher.say(LED[0])
    assert classroom.room.phase is Phase.TRY
    assert [one.here for one in teacher.shown(Desk).seats] == [True]
    pupil.role.leave()
    assert [one.here for one in teacher.shown(Desk).seats] == [False]


def test_a_pupil_is_told_whether_a_teachers_page_is_there(classroom: Class) -> None:
    pupil = Pupil(classroom)
    pupil.frame()
    teacher = Teacher(classroom)
    pupil.frame()
    teacher.role.leave()
    pupil.frame()
    assert [told.away for told in pupil.told(Seat)] == [True, False, True]


def test_an_answer_is_acknowledged_once_it_is_on_the_disk_and_counts_once(classroom: Class) -> None:
    pupil = Pupil(classroom)
    classroom.room.go(0, Phase.ASK)
    pupil.say(a_vote(1, 2), a_vote(1, 2))
    assert not pupil.told(Taken)
    until_written(classroom)
    pupil.frame()
    assert {id for message in pupil.told(Taken) for id in message.ids} == {f"{1:016x}"}
    assert classroom.room.bars(0, 0) == [0, 0, 1]
    # A forged one is refused with a sentence, and the page forgets it.
    pupil.say(a_vote(2, 4, turn=1))
    assert pupil.letters.sent[-1] == Taken(ids=(f"{2:016x}",), refused="The question has no such choice.")


def test_the_last_page_of_a_browser_has_the_seat(classroom: Class) -> None:
    first, second = Pupil(classroom), Pupil(classroom)
    first.frame()
    assert Seat(elsewhere="page") in first.letters.sent
    first.say(a_vote(1, 0))
    assert not classroom.room.answers
    first.role.leave()
    assert second.role.seat is not None


def test_the_wall_has_no_name_and_no_sealed_bar(classroom: Class) -> None:
    wall, pupil = Wall(classroom), Pupil(classroom)
    classroom.room.own_names = True
    pupil.say(class_messages.NewName("Zaphod"))
    classroom.room.go(0, Phase.ASK)
    pupil.say(a_vote(1, 1))
    assert isinstance(classroom.room.answers[f"{1:016x}"].content, Vote)
    told = wall.shown(class_messages.Wall)
    assert (told.answered, told.bars) == (1, ())
    classroom.room.go(0, Phase.RESULTS)
    assert wall.shown(class_messages.Wall).bars == (0, 1, 0)
    assert all("Zaphod" not in str(message) for message in wall.letters.sent)


def test_a_device_that_only_tries_is_told_to_the_teacher_and_to_nobody_else(classroom: Class) -> None:
    teacher, found = Teacher(classroom), class_messages.Checked(23, 58, True, False)
    for page in (Pupil(classroom), Wall(classroom)):
        assert not page.role.allows(found)
    check = CheckRole(classroom)
    assert not any(check.allows(said) for said in (*LED, a_vote(1, 0), class_messages.RaiseHand(True)))
    for _ in range(MAX_CHECKS + 3):
        check.hear(found, teacher.session)
    told = teacher.shown(Desk)
    assert [(one.trip, one.rate) for one in told.tried] == MAX_CHECKS * [(23, 58)]
    assert told.check == f"{ADDRESS}check?room={classroom.room.code}"
    assert told.check_qr
    # Once the class has begun, it is in the way.
    classroom.room.go(0, Phase.SHOW)
    assert not teacher.shown(Desk).check_qr
    # A server without classes has the page, too.
    CheckRole(None).hear(found, teacher.session)


def test_a_seat_follows_the_teacher_and_comes_back_to_its_own_body(classroom: Class) -> None:
    teacher, pupil = Teacher(classroom), Pupil(classroom)
    seat, own = pupil.role, pupil.session
    classroom.room.go(0, Phase.TRY)
    pupil.frame()
    own.do_steps(5)
    places, opened = own.simulation.positions.copy(), own.openings
    assert seat.shared_view is None
    pupil.say(class_messages.Follow(True))
    assert seat.shared_view is classroom.shared_view
    assert not seat.allows(from_page.Perform("reset"))
    pupil.frame()
    assert [one.follows for one in teacher.shown(Desk).seats] == [True]
    pupil.say(class_messages.Follow(False))
    pupil.frame()
    assert seat.shared_view is None
    assert own.openings == opened
    assert (own.simulation.positions == places).all()
    # The teacher has all look at one body, and nobody can help it; then each one has theirs back.
    teacher.arrange("gather")
    pupil.say(class_messages.Follow(False))
    assert seat.shared_view is classroom.shared_view
    teacher.arrange("giveBack")
    assert seat.shared_view is None
    assert (own.simulation.positions == places).all()


def test_a_pupil_may_have_described_what_is_asked_about_and_an_own_body(classroom: Class) -> None:
    pupil = Pupil(classroom)
    assert pupil.role.allows(Describe())
    told = {}
    for phase in Phase:
        classroom.room.go(0, phase)
        told[phase] = pupil.role.describes
    assert {phase for phase, describes in told.items() if describes} == {Phase.ASK, *OWN_BODY}


def test_the_wall_shows_the_body_of_a_seat_and_its_pupil_is_told(classroom: Class) -> None:
    teacher, pupil, wall = Teacher(classroom), Pupil(classroom), Wall(classroom)
    classroom.room.go(0, Phase.TRY)
    pupil.frame()
    pupil.session.do_steps(5)
    assert wall.role.shared_view is classroom.shared_view
    teacher.arrange("show", seat=1)
    pupil.frame()
    shown = wall.role.shared_view
    assert shown is not None and classroom.shared_view is not None
    assert (shown.picture.positions == pupil.session.simulation.positions).all()
    # Pages know two bodies apart by that number.
    assert shown.opening != classroom.shared_view.opening
    assert pupil.letters.last(Seat).on_wall
    teacher.arrange("hide", seat=1)
    assert wall.role.shared_view is classroom.shared_view


def test_the_run_is_seen_again_slowly_and_bit_for_bit_the_same(classroom: Class) -> None:
    clock = iter(range(10_000))
    session = Session(sim.rope(), clock=lambda: next(clock) / 240.0, wait=True)
    teacher = Teacher(classroom, session)
    classroom.room.go(0, Phase.RUN)

    def run() -> list[tuple[float, bytes]]:
        """Until it stands: each moment that was shown."""
        shown = []
        for _ in range(3000):
            teacher.frame()
            session.tick(1.0)
            view = classroom.shared_view
            assert view is not None
            shown.append((view.picture.time, view.picture.positions.tobytes()))
            if not session.playing and session.simulation.time >= 2.0:
                teacher.frame()
                return shown
        raise AssertionError("it does not stand")

    first, stood = run(), session.simulation.time
    end = session.simulation.positions.copy()
    assert classroom.run
    for _ in range(2):
        teacher.arrange("again")
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
        teacher.frame()
        assert session.pacer.speed == 1.0


def test_a_class_runs_what_it_was_asked_about_and_goes_on_with_that(
    class_folder: Path,
) -> None:
    classroom = Classes().begin((sim.load_scene("lesson-hooke"),))
    session = Session(sim.rope(), wait=True)
    teacher = Teacher(classroom, session)
    seen = []
    for phase in (Phase.SHOW, Phase.ASK, Phase.RESULTS, Phase.RUN, Phase.REVEAL, Phase.EXPLAIN):
        classroom.room.go(0, phase)
        teacher.frame()
        session.drain()
        teacher.frame()
        seen.append(session.scene.gravity[1])
    assert seen == [1000.0, 1000.0, 1000.0, 2000.0, 2000.0, 2000.0]
    classroom.room.go(0, Phase.TRY)
    pupil = Pupil(classroom)
    pupil.frame()
    assert pupil.session.scene.gravity == (0.0, 2000.0), "as their step says what to do"


def test_there_is_nothing_to_see_again_before_a_run(classroom: Class) -> None:
    teacher = Teacher(classroom)
    teacher.arrange("again")
    assert teacher.session.notices[-1].text == "There is no run to see again."


def test_the_wall_counts_every_seat_that_is_here_once(classroom: Class) -> None:
    wall, now = Wall(classroom), [0.0]
    classroom.room.go(0, Phase.TRY)
    sessions = [Session(sim.rope(), clock=lambda: now[0], wait=False) for _ in range(3)]
    pupils = [Pupil(classroom, number, own) for number, own in enumerate(sessions, start=1)]
    for pupil in pupils:
        pupil.frame()
    sessions[0].post(commands.SetValue("gravity", 500.0))
    sessions[0].drain()
    classroom.room.enter(f"{4:032x}")  # has left
    now[0] = 1.0
    for pupil in pupils:
        pupil.frame()
    told = wall.shown(class_messages.Wall)
    assert told.doing == {"trying": 1, "exploded": 0, "untouched": 2}
    assert told.seats == 3


def test_who_has_handed_in_is_not_counted_again_by_what_the_body_does(classroom: Class) -> None:
    wall, desk, pupils = Wall(classroom), Teacher(classroom), [Pupil(classroom, number) for number in (1, 2)]
    classroom.room.go(0, Phase.COLLECT)
    for pupil in pupils:
        pupil.frame()
    classroom.room.take(1, an_answer(1, Work(found=1.0)))
    told = wall.shown(class_messages.Wall), desk.shown(class_messages.Desk)
    assert [one.doing for one in told] == 2 * [{"trying": 0, "exploded": 0, "untouched": 1}]


def test_who_left_is_not_waited_for_and_does_not_count(classroom: Class) -> None:
    wall, pupils = Wall(classroom), [Pupil(classroom, number) for number in (1, 2, 3)]
    classroom.room.go(0, Phase.EXPLAIN)
    classroom.room.take(1, an_answer(1, Line("Because.")))
    classroom.room.take(2, an_answer(2, Line("Why not.")))
    for pupil in pupils[1:]:
        pupil.role.leave()
    told = wall.shown(class_messages.Wall)
    assert (told.answered, told.seats) == (1, 1)


def test_the_law_is_on_the_wall_only_when_it_is_asked_for(classroom: Class) -> None:
    teacher, wall = Teacher(classroom), Wall(classroom)
    classroom.room.go(0, Phase.COLLECT)
    for number, setting in enumerate((1.0, 4.0, 9.0), start=1):
        seat = classroom.room.enter(f"{number:032x}")
        work = Work(setting=setting, found=2.0 * setting**0.5, points=((0.0, 0.0),) * 4)
        classroom.room.take(seat.number, an_answer(number, work))
    assert wall.shown(class_messages.Wall).law is None
    teacher.arrange("law")
    found = wall.shown(class_messages.Wall).law
    assert found is not None
    assert (found.factor, found.exponent) == (pytest.approx(2.0), pytest.approx(0.5))
    told = teacher.shown(Desk)
    assert told.shows_law
    assert [len(answer.places) for answer in told.answers] == [4, 4, 4]
    teacher.arrange("noLaw")
    assert wall.shown(class_messages.Wall).law is None
    # What was handed in stands on the wall as it was.
    classroom.room.put_on_wall(f"{2:016x}")
    assert wall.role.shared_view is not None
    assert wall.role.shared_view.picture.positions.tolist() == [[0.0, 0.0]] * 4
    classroom.room.put_on_wall("")
    assert wall.role.shared_view is classroom.shared_view


def test_a_teacher_chooses_the_lesson_before_the_class_begins_and_not_after(classroom: Class) -> None:
    teacher, pupil, wall = Teacher(classroom), Pupil(classroom), Wall(classroom)
    pupil.frame()
    names = [one.name for one in teacher.shown(Desk).lessons]
    assert (names[0], names[-1], len(names)) == ("lesson-hooke", "lesson-spectrum", 17)
    teacher.say(class_messages.ChooseLesson("lesson-worm"))
    teacher.frame()
    told = teacher.shown(Desk)
    assert (told.lesson, len(told.stops)) == ("lesson-worm", 4)
    assert teacher.session.scene.name == "lesson-worm"
    assert wall.shown(class_messages.Wall).steps == 4
    teacher.say(class_messages.ChooseLesson("no-such-lesson"))
    assert "no-such-lesson" in teacher.session.notices[-1].text
    teacher.say(class_messages.Stage(0, "ask"))
    assert not teacher.shown(Desk).lessons
    teacher.say(class_messages.Stage(0, "lobby"), class_messages.ChooseLesson("lesson-hooke"))
    assert teacher.session.notices[-1].text == "The class has begun: its lesson can no longer be chosen."
    assert classroom.room.scenes[0].name == "lesson-worm"


def test_of_several_networks_the_teacher_chooses_the_pupils(classroom: Class) -> None:
    networks = ["http://192.168.1.7:8080/", "http://10.42.0.1:8080/"]
    teacher = Somebody(lambda mail: DeskRole(classroom, mail, networks[0], no_download, networks))
    teacher.introduce(9, classroom.room.key)
    wall = Wall(classroom)
    assert teacher.shown(Desk).address == networks[0]
    assert wall.shown(class_messages.Wall).address == ADDRESS, "the one that it was opened at"
    teacher.say(class_messages.ChooseNetwork(networks[1]))
    told = teacher.shown(Desk)
    assert (told.address, told.check) == (networks[1], f"{networks[1]}check?room={classroom.room.code}")
    shown = wall.shown(class_messages.Wall)
    assert shown.address == networks[1]
    assert shown.qr == told.qr
    teacher.say(class_messages.ChooseNetwork("http://evil.example/"))
    assert teacher.shown(Desk).address == networks[1]
