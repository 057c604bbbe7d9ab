"""A body described in words, for whoever cannot see it or has to tell of it."""

from __future__ import annotations

from contextvars import copy_context
from typing import ClassVar

from sim.analysis.description import Description, describe
from sim.scene.types import Scene

from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Feature
from ...ui.page import Page
from ...ui.queues import threads
from .messages import Described
from .paragraph import paragraph, swing_of


def _describe(session: Session, feature: DescribeFeature) -> None:
    feature.describe(session)


class DescribeFeature(Feature):
    """Describes the body of one page."""

    commands: ClassVar = {"describe": Row(_describe, ("D",))}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._before: Description | None = None

    def build(self) -> None:
        """See `Feature`."""
        self._before = None

    def describe(self, session: Session) -> None:
        """Describe the body as it is now; how it swings is found in another thread."""
        scene = session.simulation.scene
        found, before = describe(session.simulation, scene), self._before
        self._before = found
        threads.submit(copy_context().run, self._say, found, scene, before)

    def _say(self, found: Description, scene: Scene, before: Description | None) -> None:
        told = Described(text=paragraph(found, scene, swing_of(found, scene), before))
        self.page.soon(lambda: self.page.mail.send(told))
