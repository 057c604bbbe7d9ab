"""A lesson for the page's script, which shows its steps beside the body (static/lesson.js)."""

from __future__ import annotations

import html

import msgspec

from sim.lesson_settings import scene_of_step
from sim.scene.lesson import Lesson

from ..session import commands
from ..session.session import Session


def lesson_html(lesson: Lesson) -> str:
    """The hidden element that carries a lesson, which may be anyone's: the script shows it as text only."""
    steps = [
        {
            "title": step.title,
            "do": step.do,
            "watch": step.watch,
            "question": step.question,
        }
        for step in lesson.steps
    ]
    data = html.escape(msgspec.json.encode(steps).decode())
    return f'<div id="softrod-lesson" hidden data-steps="{data}"></div>'


def begin_step(session: Session, number: int) -> None:
    """Open the scene anew, as a step of its lesson wants it; it waits while the step has a question.

    Raises:
        SettingError: there is no such step, or what it sets cannot be set.
    """
    lesson = session.scene.lesson
    if lesson is not None:
        session.post(commands.Open(scene_of_step(session.opened, number)))
        session.post(commands.Play(lesson.steps[number].question is None))
