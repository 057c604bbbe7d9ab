"""The scene's lesson: its steps, with the sliders, plots and arrows that the present one needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from sim.scene.lesson import Lesson
from sim.settings import CHOICES

from ...session import commands
from ...session.notices import Notice
from ...session.plots import PlotSpec
from ...ui.board import Board, dials_of
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ...words import say
from ..instruments.feature import InstrumentsFeature
from ..measure.feature import MeasureFeature
from ..measure.messages import Seen
from .messages import BeginStep
from .panel import LessonPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel


@dataclass(frozen=True)
class ToolsBeforeLesson:
    """What a user had switched on before a lesson, and gets back after it on the same scene."""

    plots: tuple[PlotSpec, ...]
    arrows: frozenset[str]
    ghost: commands.Compare


class LessonFeature(Feature):
    """The lesson of a page's scene, if it is shown."""

    messages: ClassVar = {BeginStep: "", Seen: ""}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._panel: LessonPanel | None = None
        self._board = Board(page)
        self._before: ToolsBeforeLesson | None = None
        self._said_closed: Lesson | None = None
        self._is_seen: bool | None = None

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case BeginStep():
                self.page.soon(lambda: self._panel is not None and self._panel.begin(said))
            case Seen(tab):
                self.page.soon(lambda: self._see(tab == "lesson"))

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._panel, self._board = None, Board(self.page)
        if self.page.has_lesson:
            self._panel = LessonPanel(self.page, panel.tab("Lesson"))
            if self._is_seen is not None:
                self._panel.plots.looked_at = self._is_seen

    def clear(self) -> None:
        """See `Feature`."""
        self._before = None

    def build(self) -> None:
        """See `Feature`."""
        page, lesson = self.page, self.session.scene.lesson
        if not page.is_in_class and lesson not in (None, self._said_closed) and page.is_closed(lesson):
            self._said_closed = lesson
            page.notify(Notice("info", say("lesson-closed"), say("lesson-closed.text")))
        if self._panel is None:
            self._restore_tools()
            return
        self._before = self._before or self._current_tools()
        self._panel.build()
        keys = self._panel.controls
        known = {dial.key: dial for dial in dials_of(self.session.scene)}
        dials = [known[key] for key in keys if key in known]
        if self._board.is_new((dials, keys)):
            self._board.add_sliders(self._panel.tab, dials)
            self._board.add_choices(self._panel.tab, [key for key in keys if key in CHOICES], 30)
        step, instruments = self._panel.step, page.find(InstrumentsFeature)
        if step is not None and step.arrows is not None and instruments is not None:
            instruments.show_arrows(frozenset(step.arrows))

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        if self._panel is not None:
            self._panel.plots.tick()

    @property
    def unsettled(self) -> bool:
        """See `Feature`."""
        return not self._board.settled

    def refresh(self) -> None:
        """See `Feature`."""
        self._board.show(self.session.scene)

    # --------------------------------------------------------------------- inside
    def _see(self, on: bool) -> None:
        self._is_seen = on
        if self._panel is not None:
            self._panel.plots.looked_at = on

    def _current_tools(self) -> ToolsBeforeLesson:
        """What the user has switched on; a ghost in the middle of a lesson is the lesson's."""
        measure, instruments = self.page.find(MeasureFeature), self.page.find(InstrumentsFeature)
        ghost, compare = self.session.ghost, commands.Compare("", "")
        if ghost is not None and not self.session.lesson_begun:
            compare = commands.Compare(ghost.method, ghost.law, ghost.finer)
        return ToolsBeforeLesson(
            measure.specs if measure is not None else (),
            instruments.arrows if instruments is not None else frozenset(),
            compare,
        )

    def _restore_tools(self) -> None:
        """After a lesson, as at the end of a step's trial, restore what was switched on before it."""
        if self._before is None:
            return
        before, self._before = self._before, None
        if (instruments := self.page.find(InstrumentsFeature)) is not None:
            instruments.show_arrows(before.arrows)
        if (measure := self.page.find(MeasureFeature)) is not None:
            measure.remember(before.plots)
        if not self.page.makes_lesson:  # after the trial of a step it is back already
            self.session.post(before.ghost)
