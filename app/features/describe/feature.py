"""A body and its parts described in words, for whoever cannot see them or has to tell of them."""

from __future__ import annotations

from typing import ClassVar

from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from .describer import Describer
from .messages import Describe, FollowTouches
from .touches import TouchWatch


def _describe(session: Session, feature: DescribeFeature) -> None:
    feature.describer.describe_body(session)


class DescribeFeature(Feature):
    """Describes the body of one page.

    Attributes:
        describer: does it.
    """

    messages: ClassVar = {Describe: "", FollowTouches: ""}
    commands: ClassVar = {
        "describe": Row("page", ("D",)),
        "describeBody": Row(_describe, ("Shift D",)),
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self.describer = Describer(page.mail, page.soon)
        self._touches: TouchWatch | None = None  # while the page asks for it

    def build(self) -> None:
        """See `Feature`."""
        self.describer.forget()
        self._follow_touches(self._touches is not None)

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case Describe(mass):
                self.page.soon(lambda: self.describer.describe(self.session, mass))
            case FollowTouches(on):
                self.page.soon(lambda: self._follow_touches(on))
            case _:
                pass

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        if self._touches is None:
            return
        simulation = self.session.simulation
        up = -1.0 if simulation.scene.view.y_down else 1.0
        told = self._touches.look(simulation, len(simulation.scene.masses), up, drawn.now)
        if told is not None:
            self.page.mail.send(told)

    def _follow_touches(self, on: bool) -> None:
        """Follow the touches of a body from now on, or no longer."""
        self._touches = TouchWatch() if on else None
