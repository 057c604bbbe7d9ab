"""A class speaks several languages at once: each page has what it is told in its own."""

from __future__ import annotations

import csv
import io
import zipfile
from pathlib import Path

import pytest

import sim
from app.classroom.answers import Doubt, Line, Phase, Vote, Work
from app.classroom.live import Class, Classes
from app.features.classroom import messages
from app.features.classroom.messages import Desk, Seat, Taken
from app.words import speaking
from sim.errors import SettingError
from tests.app.classrooms import Pupil, Teacher, Wall, a_vote
from tests.app.inside import fail_to_save
from tests.app.test_room import a_room, an_answer


@pytest.fixture
def classroom(class_folder: Path) -> Class:
    return Classes().begin(a_room().scenes)


def test_a_pupil_is_refused_in_the_language_of_the_page(classroom: Class) -> None:
    english, german = Pupil(classroom, 1), Pupil(classroom, 2)
    classroom.room.go(0, Phase.ASK)
    english.say(a_vote(1, 4))
    with speaking("de"):
        german.say(a_vote(2, 4))
    refused = [pupil.told(Taken)[-1].refused for pupil in (english, german)]
    assert refused == [
        "The question has no such choice.",
        "Diese Antwortmöglichkeit gibt es bei der Frage nicht.",
    ]


def test_what_a_teacher_does_is_said_to_a_pupil_in_the_pupil_s_language(
    classroom: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    with speaking("de"):
        pupil = Pupil(classroom)
        pupil.frame()
    classroom.room.go(0, Phase.TRY)

    def broken(stop: int) -> sim.Scene:
        raise SettingError("?")

    monkeypatch.setattr(classroom, "run_scene", broken)
    Teacher(classroom).arrange("reset")
    assert pupil.told(Taken)[-1].refused == "Dieser Schritt kann nicht beginnen: ?."


def test_the_time_of_homework_is_said_in_the_language_of_the_page(class_folder: Path) -> None:
    homework = Classes().begin((sim.load_scene("lesson-hooke"),), until=4_000_000_000.0)
    pupil = Pupil(homework)
    with speaking("de"):
        assert pupil.shown(Seat).home.startswith("2. Oktober um ")


def test_a_doubt_is_said_in_the_language_of_each_desk(classroom: Class) -> None:
    classroom.room.enter("0" * 32)
    classroom.room.go(0, Phase.COLLECT)
    classroom.room.take(1, an_answer(1, Work(found=1.0, doubt=Doubt("class-doubt-sets", "gravity"))))
    english = Teacher(classroom).shown(Desk).answers[0].doubt
    with speaking("de"):
        german = Teacher(classroom).shown(Desk).answers[0].doubt
    assert english == "the log sets gravity, which this step has no slider for."
    assert german == "die Aufzeichnung stellt gravity ein, wofür dieser Schritt keinen Regler hat."


def test_the_axes_of_the_plot_are_said_in_the_language_of_each_page(class_folder: Path) -> None:
    classroom = Classes().begin((sim.load_scene("lesson-hooke"),))
    classroom.room.go(0, Phase.COLLECT)
    english = Wall(classroom).shown(messages.Wall).axes
    with speaking("de"):
        german = Wall(classroom).shown(messages.Wall).axes, Teacher(classroom).shown(Desk).axes
    assert (english.over, english.what) == ("Gravity", "stretch of spring 0")
    assert {(axes.over, axes.what) for axes in german} == {("Fallbeschleunigung", "Dehnung von Feder 0")}
    assert (german[0].over_unit, german[0].unit) == ("px/s²", "px")


def test_what_happens_to_the_class_is_said_in_the_language_of_the_desk(classroom: Class) -> None:
    """Whichever page had the class look for it."""
    fail_to_save(classroom, OSError(28, "No space left on device"))
    with speaking("de"):
        teacher = Teacher(classroom)
        teacher.frame()
    assert "Die Stunde wird nicht gespeichert" in {notice.title for notice in teacher.session.notices}


def test_the_zip_is_in_the_language_of_the_desk(classroom: Class) -> None:
    """It is made in another thread."""
    classroom.room.enter("0" * 32)
    classroom.room.go(0, Phase.ASK)
    classroom.room.take(1, an_answer(1, Vote(1)))
    classroom.room.go(0, Phase.EXPLAIN)
    classroom.room.take(1, an_answer(2, Line("Energy.")))
    with speaking("de"):
        made = classroom.pack()
    with zipfile.ZipFile(io.BytesIO(made.result())) as file:
        assert "Was eine Klasse abgegeben hat: " in file.read("README.txt").decode()
        rows = list(csv.DictReader(io.StringIO(file.read("answers.csv").decode("utf-8-sig")), delimiter=";"))
    assert [(row["Art"], row["richtig"], row["verspätet"]) for row in rows] == [
        ("Stimme", "ja", "nein"),
        ("Satz", "", "nein"),
    ]
