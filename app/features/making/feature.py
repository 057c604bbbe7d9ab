"""The form in which a lesson is made."""

from __future__ import annotations

from typing import ClassVar

import viser

from ...session.notices import Notice
from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ...words import say
from ..instruments.feature import InstrumentsFeature
from ..measure.feature import MeasureFeature
from .maker import LessonMaker, Measured
from .messages import MakeLesson, Prepare


def _open(_: Session, feature: MakingFeature) -> None:
    feature.open()


class MakingFeature(Feature):
    """The lesson form of one page."""

    messages: ClassVar = {Prepare: "edit"}
    commands: ClassVar = {
        "lesson": Row(_open, needs="edit", share=viser.Icon.LIST_CHECK),
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._maker = LessonMaker(page, self._measured)

    def open(self) -> None:
        """Open the form, with the scene's lesson."""
        if self.page.is_in_class:
            self.page.notify(Notice("info", say("making-in-class"), say("making-in-class.text")))
        else:
            self._maker.do(MakeLesson(True))

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        if isinstance(said, Prepare) and not self.page.is_in_class:
            self.page.soon(lambda: self._maker.do(said))

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        if self._maker.is_told:
            self._maker.tell()

    def _measured(self) -> Measured:
        """Return what is measured on the page now."""
        measure, instruments = self.page.find(MeasureFeature), self.page.find(InstrumentsFeature)
        return Measured(
            measure.parts if measure is not None else (),
            measure.texts_of_plots if measure is not None else (),
            instruments.arrows if instruments is not None else frozenset(),
        )
