"""The Lesson tab: the steps of the scene's lesson, with the sliders and plots that the present one needs.

The text is the page's script's (lesson.js), which also knows how far the lesson is. Which step that is
comes from there: with the begin of a step, or where the page goes on in the middle of one.
"""

from __future__ import annotations

from collections.abc import Callable

import viser

from sim.errors import SettingError
from sim.scene.lesson import Lesson, Step
from sim.settings import scene_of_step

from ...session import commands
from ...session.notices import Notice
from ...session.plots import wish_of
from ...session.session import Session
from ...wire.carrier import Mail
from ...wire.from_page import BeginStep
from ...wire.to_page import Lesson as LessonState
from ...wire.to_page import LessonStep
from ..measure.plot_list import PlotList
from ..viser.comma_switch import CommaSwitch

PLACE = '<div id="softrod-lesson"></div>'
"""Where the script puts the lesson."""


class LessonPanel:
    """One page's lesson.

    Args:
        client: the page.
        tab: where it stands.
        session: whose scene has it.
        mail: to the page's script.
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
        mail: Mail,
        notify: Callable[[Notice], None],
        commas: CommaSwitch,
        page: list[PlotList],
    ) -> None:
        self.tab = tab
        self._session, self._mail, self._notify = session, mail, notify
        self._step = 0
        self._lesson: Lesson | None = None
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
        if lesson is not self._lesson:
            self._lesson, self._step = lesson, 0
            self._text.content = PLACE if lesson else ""
        if lesson is not None:
            steps = (LessonStep(step.title, step.do, step.watch, step.question) for step in lesson.steps)
            self._mail.tell(LessonState(steps=tuple(steps)))
        wishes = tuple(map(wish_of, (self.step.plots or ()) if self.step else ()))
        if wishes != self.plots.wishes:
            self.plots.remember(wishes)
        self.plots.build(dark)

    def begin(self, begin: BeginStep) -> None:
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
