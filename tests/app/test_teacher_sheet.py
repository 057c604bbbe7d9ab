"""The sheet of a lesson for its teacher."""

from __future__ import annotations

import html
import re

import pytest

import sim
from app.export.teacher_sheet import sheet_html
from app.words import PSEUDO, speaking
from sim.errors import InputError


def words_of(name: str) -> str:
    text = re.sub(
        r"<(?:style|head).*?</(?:style|head)>", " ", sheet_html(sim.load_scene(name)).decode(), flags=re.S
    )
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", text)).split())


def test_it_says_what_is_asked_run_told_and_tried() -> None:
    words, scene = words_of("lesson-hooke"), sim.load_scene("lesson-hooke")
    assert scene.lesson is not None
    for step in scene.lesson.steps:
        said = [step.title, step.do, step.watch]
        if step.question is not None:
            said += [step.question.text, *step.question.choices, step.question.because]
        for text in said:
            assert text in words
    assert "Run Gravity 2000 px/s²." in words
    assert "Run mass 1 is pulled 150 px down and let go." in words
    assert "Predict Each drags the pale body to where it will be after 4 s." in words
    assert "Collect The stretch of spring 0." in words
    assert sheet_html(scene).count(b"class=right") == 3


def test_what_a_scene_says_is_text_in_it() -> None:
    from msgspec.structs import replace

    scene = sim.load_scene("lesson-hooke")
    assert scene.lesson is not None
    first, *others = scene.lesson.steps
    evil = replace(first, title="<img src=x onerror=alert(1)>")
    made = sheet_html(replace(scene, lesson=replace(scene.lesson, steps=(evil, *others))))
    assert b"<img" not in made


def test_its_command_begins_a_lesson_whose_name_has_spaces() -> None:
    from msgspec.structs import replace

    made = sheet_html(replace(sim.load_scene("lesson-hooke"), name="my lesson")).decode()
    assert "<code>softrod class 'my lesson'</code>" in html.unescape(made)


def test_a_scene_without_a_lesson_has_none() -> None:
    with pytest.raises(InputError, match="rope has no lesson"):
        sheet_html(sim.load_scene("rope"))


def test_it_is_in_the_language_that_is_spoken() -> None:
    with speaking(PSEUDO):
        text = sheet_html(sim.load_scene("lesson-hooke")).decode()
    said = re.findall(r"<(?:title|dt|p)>(.*?)</(?:title|dt|p)>", text, re.DOTALL)
    assert len(said) > 20
    assert all("·" in one for one in said)
