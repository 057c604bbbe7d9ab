"""Lessons between the page and the session, without a browser."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path

import msgspec
import pytest

import sim
from app.cli import Check
from app.drawing.sketch import Mapping
from app.page import script
from app.page.lesson_card import lesson_html
from sim.lesson_settings import scene_of_step
from sim.scene.files import decode_scene, encode_scene
from sim.scene.lesson import Lesson, Question, Step

QUESTION = Question(text="?", choices=("a", "b"), answer=1, because="so")


def with_lesson(*steps: Step) -> sim.Scene:
    return msgspec.structs.replace(sim.load_scene("tutorial-3.3"), lesson=Lesson(steps=steps))


def test_the_page_gets_a_lesson_as_text() -> None:
    evil = '"><script>x</script>&'
    content = lesson_html(Lesson(steps=(Step(title=evil, do=evil, question=QUESTION),)))
    found = re.fullmatch(r'<div id="softrod-lesson" hidden data-steps="([^"<>]*)"></div>', content)
    assert found is not None
    (step,) = json.loads(html.unescape(found[1]))
    assert (step["title"], step["do"], step["watch"]) == (evil, evil, "")
    assert msgspec.convert(step["question"], Question) == QUESTION
    assert "settings" not in step  # which are the server's


def test_a_message_begins_a_step_and_nonsense_does_not() -> None:
    mapping = Mapping.of(sim.load_scene("ring"))
    assert script.parse("3|lesson|12", mapping) == script.Begin(12)
    for nonsense in ("3|lesson|", "3|lesson|-1", "3|lesson|123", "3|lesson|1|2", "3|lesson|x"):
        assert script.parse(nonsense, mapping) is None


def test_a_lesson_is_saved_and_a_scene_without_one_does_not_mention_it() -> None:
    scene = with_lesson(Step(title="A", do="B", question=QUESTION, settings=("gravity=0",)))
    assert decode_scene(encode_scene(scene), "a") == scene
    assert b"lesson" not in encode_scene(sim.load_scene("ring"))


def test_steps_set_what_they_name() -> None:
    scene = with_lesson(
        Step(title="A", do="B"), Step(title="A", do="B", settings=("gravity=7", "method=rk4"))
    )
    assert scene_of_step(scene, 0) == scene
    second = scene_of_step(scene, 1)
    assert second.gravity == (0.0, 7.0)
    assert second.integrator.method == "rk4"
    with pytest.raises(sim.SettingError, match=r"^lesson\.steps: step 2 does not exist$"):
        scene_of_step(scene, 2)


def test_what_is_wrong_with_a_lesson_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    question = msgspec.structs.replace(QUESTION, answer=2)
    with pytest.raises(sim.SceneError, match=r"^lesson\.steps\[0\]\.question\.answer: choice 2 "):
        sim.validate(with_lesson(Step(title="A", do="B", question=question)))
    with pytest.raises(sim.SceneError, match=r"^lesson\.steps"):
        sim.validate(msgspec.structs.replace(sim.load_scene("ring"), lesson=Lesson(steps=())))
    path = tmp_path / "lesson.json"
    sim.save_scene(with_lesson(Step(title="A", do="B", settings=("gravity=0", "gravty=1"))), path)
    assert Check((path,)).run() == 1
    assert f"{path}: lesson.steps[0].settings[1]: gravty: there is no such setting" in capsys.readouterr().err
