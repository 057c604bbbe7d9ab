"""The Lesson tab: the steps of the scene's lesson, with the sliders and plots that the present one needs.

The text is the page's script's (static/lesson.js), which also knows how far the lesson is. Which step that is
comes from there: with the begin of a step, or where the page goes on in the middle of one.
"""

from __future__ import annotations

import html
from collections.abc import Callable

import msgspec
import viser

from sim.errors import SettingError
from sim.lesson_settings import scene_of_step
from sim.scene.lesson import Lesson, Step

from ..session import commands
from ..session.notices import Notice
from ..session.plots import wish_of
from ..session.session import Session
from .comma_switch import CommaSwitch
from .plot_list import PlotList
from .script import Begin


def lesson_html(lesson: Lesson) -> str:
    """The element that carries a lesson, which may be anyone's: the script shows it as text only."""
    steps = [
        {"title": step.title, "do": step.do, "watch": step.watch, "question": step.question}
        for step in lesson.steps
    ]
    data = html.escape(msgspec.json.encode(steps).decode())
    return f'<div id="softrod-lesson" data-steps="{data}"></div>'


class LessonPanel:
    """One page's lesson.

    Args:
        client: the page.
        tab: where it stands.
        session: whose scene has it.
        notify: tells the user something.
        commas: whether tables have decimal commas.
        page: the page's lists of plots, see `PlotList`.

    Attributes:
        tab: as above.
        plots: those of the present step.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        tab: viser.GuiTabHandle,
        session: Session,
        notify: Callable[[Notice], None],
        commas: CommaSwitch,
        page: list[PlotList],
    ) -> None:
        self.tab = tab
        self._session, self._notify = session, notify
        self._step = 0
        with tab:
            self._text = client.gui.add_html("", order=1)
        self.plots = PlotList(client, tab, session, notify, commas, page)

    @property
    def step(self) -> Step | None:
        """The present step."""
        lesson = self._session.scene.lesson
        return lesson.steps[self._step] if lesson and self._step < len(lesson.steps) else None

    @property
    def controls(self) -> tuple[str, ...]:
        """Keys of the settings whose sliders the present step has."""
        return self.step.controls if self.step else ()

    def build(self, dark: bool) -> None:
        """Show the scene's lesson, and the plots of its present step."""
        lesson = self._session.scene.lesson
        content = lesson_html(lesson) if lesson else ""
        if self._text.content != content:
            self._text.content = content
            self._step = 0
        wishes = tuple(map(wish_of, (self.step.plots or ()) if self.step else ()))
        if wishes != self.plots.wishes:
            self.plots.remember(wishes)
        self.plots.build(dark)

    def begin(self, begin: Begin) -> None:
        """Go to a step: the scene is opened anew as the step wants it, and waits for an answer if it asks.

        A page that is in the middle of it only has its sliders and plots shown.
        """
        session, lesson = self._session, self._session.scene.lesson
        if lesson is None or begin.step >= len(lesson.steps):
            return
        before, self._step = self._step, begin.step
        if begin.how == "on":
            session.generation += before != begin.step  # other sliders and plots
            return
        try:
            scene = scene_of_step(session.opened, begin.step)
        except SettingError as error:
            self._notify(Notice("error", "This step cannot begin", str(error)))
            return
        step = lesson.steps[begin.step]
        waits = step.question is not None and begin.how == "wait"
        session.post(commands.Open(scene, begun=True, waits=waits))
        session.post(commands.Compare(step.ghost or "", ""))
        session.post(commands.Play(not waits))
