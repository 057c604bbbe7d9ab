"""A class speaks several languages at once: each page has what it is told in its own."""

from __future__ import annotations

from pathlib import Path

import pytest

import sim
from app.classroom.answers import Phase
from app.classroom.live import Class, Classes
from app.features.classroom.messages import Seat, Taken
from app.words import speaking
from sim.errors import SettingError
from tests.app.classrooms import Pupil, Teacher, a_vote
from tests.app.test_room import a_room


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
    assert refused == ["The question has no such choice.", "Diese Antwortmöglichkeit hat die Frage nicht."]


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
