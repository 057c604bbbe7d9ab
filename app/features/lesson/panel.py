"""The Lesson tab: the steps of the scene's lesson, with the sliders and plots that the present one needs.

The text is the page's script's (lesson.js), which also knows how far the lesson is. Which step that is
comes from there: with the begin of a step, or where the page goes on in the middle of one.
"""

from __future__ import annotations

import viser

from sim.errors import SettingError
from sim.scene.lesson import Lesson, Step
from sim.settings import scene_of_run, scene_of_step

from ...lessons import lesson_code
from ...session import commands
from ...session.notices import Notice
from ...session.plots import parse_plot
from ...ui.page import Page
from ...words import say
from ...words.english import step_of
from ..measure.plot_list import PlotList
from .messages import BeginStep, LessonStep
from .messages import Lesson as LessonState

PLACE = '<div id="softrod-lesson"></div>'
"""Where the script puts the lesson."""


class LessonPanel:
    """One page's lesson.

    Args:
        page: whose scene has it.
        tab: where it stands.

    Attributes:
        tab: as above.
        plots: those of the present step.
    """

    def __init__(self, page: Page, tab: viser.GuiTabHandle) -> None:
        self.tab = tab
        self._page, self._session = page, page.session
        self._step = 0
        self._lesson: Lesson | None = None
        with tab:
            self._text = page.client.gui.add_html("", order=1)
        self.plots = PlotList(page, tab)

    @property
    def step(self) -> Step | None:
        """The present step."""
        lesson = self._session.scene.lesson
        return lesson.steps[self._step] if lesson and self._step < len(lesson.steps) else None

    @property
    def controls(self) -> tuple[str, ...]:
        """Keys of the settings whose sliders the present step has."""
        return self.step.controls if self.step else ()

    def build(self) -> None:
        """Show the scene's lesson, and the plots of its present step."""
        scene = self._session.scene
        lesson = scene.lesson
        if lesson is not self._lesson:
            self._lesson, self._step = lesson, 0
            self._text.content = PLACE if lesson else ""
        if lesson is not None:
            steps = (
                LessonStep(step.title, step.do, step.watch, step.question, bool(step.run))
                for step in map(step_of, lesson.steps)
            )
            self._page.mail.send(LessonState(name=f"{scene.name}.{lesson_code(scene)}", steps=tuple(steps)))
        specs = tuple(map(parse_plot, (self.step.plots or ()) if self.step else ()))
        if specs != self.plots.specs:
            self.plots.remember(specs)
        self.plots.build()

    def begin(self, begin: BeginStep) -> None:
        """Go to a step: open the scene as the step sets it up, and wait for an answer if there is a question.

        A page that is in the middle of it only has its sliders and plots shown.
        """
        session, lesson = self._session, self._session.scene.lesson
        if lesson is None or begin.step >= len(lesson.steps):
            return
        before, self._step = self._step, begin.step
        if begin.how == "on":
            session.generation += before != begin.step  # other sliders and plots
            return
        # A lesson that was made or changed since the scene was opened is about the body as it is now.
        base = session.lesson_base if session.lesson_base.lesson == lesson else session.scene
        try:
            waits = lesson.steps[begin.step].question is not None and begin.how == "wait"
            scene = (scene_of_step if waits else scene_of_run)(base, begin.step)
        except SettingError as error:
            self._page.notify(Notice("error", say("lesson-fails"), str(error)))
            return
        step = lesson.steps[begin.step]
        session.post(commands.Open(scene, begun=True, waits=waits))
        session.post(commands.Compare(step.ghost or "", ""))
        session.post(commands.Play(not waits))
