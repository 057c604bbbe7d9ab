"""A lesson for the page's script, which shows its steps beside the body (static/lesson.js)."""

from __future__ import annotations

import html

import msgspec

from sim.lesson_settings import scene_of_step
from sim.scene.lesson import Lesson

from ..session import commands
from ..session.plots import wish_of
from ..session.session import Session
from .measure_panel import MeasurePanel
from .script import Begin
from .tools_panel import ToolsPanel


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


def begin_step(
    session: Session, begin: Begin, measure: MeasurePanel | None, tools: ToolsPanel | None
) -> None:
    """Open the scene anew, as a step of its lesson wants it; it waits while the step has a question.

    Args:
        session: whose scene it is.
        begin: which step.
        measure, tools: where the plots and arrows are that the step wants, if the page has that.

    Raises:
        SettingError: there is no such step, or what it sets cannot be set.
    """
    lesson = session.scene.lesson
    if lesson is None:
        return
    step = lesson.steps[begin.step]
    waits = step.question is not None and not begin.run
    session.post(commands.Open(scene_of_step(session.opened, begin.step), begun=True, waits=waits))
    session.post(commands.Play(not waits))
    if step.plots is not None and measure is not None:
        measure.remember(tuple(map(wish_of, step.plots)), show=bool(step.plots))
    if step.arrows is not None and tools is not None:
        tools.show_arrows(frozenset(step.arrows))
