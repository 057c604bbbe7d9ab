"""A lesson for the page's script, which shows its steps beside the body (static/lesson.js)."""

from __future__ import annotations

import html

import msgspec

from sim.scene.lesson import Lesson


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
