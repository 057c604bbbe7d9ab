"""Homework: each pupil goes through the steps alone, and what is right is told at its time."""

from __future__ import annotations

from pathlib import Path

import pytest

import sim
from app.classroom import live
from app.classroom.answers import Line, Phase, Prediction, Refused, Vote, Work
from app.classroom.live import Class, Classes
from app.cli.main import main
from app.features.classroom import messages
from app.features.classroom.messages import Desk, Seat, Taken
from app.features.hands.messages import Grab
from tests.app.classrooms import Pupil, Teacher, a_vote
from tests.app.test_room import an_answer

LATER = 4_000_000_000.0


@pytest.fixture
def homework(class_folder: Path) -> Class:
    return Classes().begin((sim.load_scene("lesson-hooke"),), until=LATER)


def test_a_pupil_first_answers_and_then_has_a_body_that_moves(homework: Class) -> None:
    """Without a teacher; the body of a question stands still, and nobody can move it."""
    pupil, room = Pupil(homework), homework.room
    told = pupil.shown(Seat)
    assert told.home.startswith("2 October, ")
    assert told.done == (False,) * 4
    assert (told.types_name, told.is_given) == (True, True)
    assert told.asking is not None
    assert (told.asking.phase, told.asking.right, told.away) == ("ask", -1, False)
    assert pupil.session.scene.gravity == (0.0, 1000.0)
    assert not pupil.session.playing
    assert not pupil.role.allows(Grab(0, 1, 0.0, 0.0))
    pupil.say(a_vote(1, 2))
    assert room.place_of(1).phase is Phase.ASK, "a prediction is asked for, too"
    points = tuple(mass.position for mass in pupil.session.scene.masses)
    room.take(1, an_answer(2, Prediction(points)))
    pupil.frame()
    pupil.frame()
    told = pupil.shown(Seat)
    assert told.asking is not None
    assert (told.asking.phase, told.asking.right, told.asking.because) == ("collect", -1, "")
    assert pupil.session.scene.gravity == (0.0, 2000.0)
    assert pupil.session.playing
    assert pupil.role.allows(Grab(0, 1, 0.0, 0.0))
    # The first answer counts: the run has shown what is so.
    with pytest.raises(Refused, match="your first answer counts"):
        room.take(1, an_answer(3, Vote(1), turn=5))
    room.take(1, an_answer(4, Line("Because."), turn=6))
    room.take(1, an_answer(5, Line("Because it is."), turn=7))
    assert room.done(1) == (False,) * 4, "the number has not been handed in"
    room.take(1, an_answer(6, Work(found=100.0, setting=2000.0), turn=8))
    assert room.done(1) == (True, False, False, False)


def test_each_goes_where_it_likes_and_comes_back_to_its_answers(homework: Class) -> None:
    one, other = Pupil(homework, 1), Pupil(homework, 2)
    one.say(messages.WalkTo(3))
    assert homework.room.place_of(1) == (3, Phase.COLLECT, 0), "that step asks nothing"
    assert homework.room.place_of(2) == (0, Phase.ASK, 0)
    one.say(messages.WalkTo(7))
    assert one.told(Taken)[-1].refused == "The homework has no such step."
    told = one.shown(Seat)
    assert told.asking is not None
    assert told.asking.stop == 3
    assert "controls" not in told.problem
    assert one.role.controls is not None
    assert one.role.controls.names == ("play", "gravity", "angular_stiffness")
    other.frame()
    assert other.role.controls is not None
    assert other.role.controls.names == ()


def test_what_is_right_is_told_at_its_time_and_answers_are_late_then(
    homework: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    pupil, teacher, room = Pupil(homework), Teacher(homework), homework.room
    pupil.say(a_vote(1, 2))
    desk = teacher.shown(Desk)
    assert (desk.told, desk.done[0], desk.bars) == (False, (1, 0), (0, 0, 1))
    monkeypatch.setattr(live.time, "time", lambda: LATER + 1.0)
    pupil.frame()
    told = pupil.shown(Seat)
    assert room.told
    assert told.asking is not None
    assert told.asking.right == 1
    room.take(1, an_answer(4, Work(), turn=6))
    assert [one.late for one in room.answers.values()] == [False, True]


def test_the_teacher_may_tell_it_before(homework: Class) -> None:
    pupil, teacher = Pupil(homework), Teacher(homework)
    teacher.arrange("tell")
    told = pupil.shown(Seat)
    assert told.told
    assert told.asking is not None
    assert told.asking.because


def test_a_class_s_pupils_walk_nowhere(class_folder: Path) -> None:
    pupil = Pupil(Classes().begin((sim.load_scene("lesson-hooke"),)))
    pupil.say(messages.WalkTo(1))
    assert pupil.told(Taken)[-1].refused == "The class goes on together."


def test_homework_goes_on_after_a_restart_and_a_class_does_not_become_one(class_folder: Path) -> None:
    first = Classes()
    made = first.begin((sim.load_scene("lesson-hooke"),), until=LATER)
    Pupil(made).say(messages.WalkTo(2))
    first.close()
    again = Classes()
    again.resume(None, 1)
    [found] = again
    assert (found.room.until, found.room.seats[1].at) == (LATER, 2)
    again.close()
    later = Classes()
    later.resume(None, 1, until=LATER + 5.0)
    assert next(iter(later)).room.until == LATER + 5.0
    next(iter(later)).end()
    while list(later):
        next(iter(later)).poll_writer()
    plain = Classes()
    plain.begin((sim.rope(),))
    plain.close()
    with pytest.raises(Refused, match="is no homework"):
        Classes().resume(None, 1, until=LATER)


@pytest.mark.parametrize(
    ("text", "said"),
    [("soon", "soon is no date"), ("2020-01-15", "has passed"), ("2027-13-01", "is no date")],
)
def test_a_date_that_is_none_is_refused_in_a_sentence(
    text: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit, match="1"):
        main(["class", "--until", text])
    assert said in capsys.readouterr().err
