"""A body and its parts described in words, for whoever cannot see them or has to tell of them."""

from __future__ import annotations

from contextvars import copy_context
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from sim.analysis.description import Description, describe
from sim.analysis.part_description import describe_part
from sim.edit.edit import Selection
from sim.scene.types import Scene

from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...ui.queues import threads
from ...wire.messages import FromPage
from .messages import Describe, Described, FollowTouches
from .paragraph import paragraph, swing_of
from .part import of_part
from .touches import TouchWatch


def _describe(session: Session, feature: DescribeFeature) -> None:
    feature.describe(session)


class DescribeFeature(Feature):
    """Describes the body of one page."""

    messages: ClassVar = {Describe: "", FollowTouches: ""}
    commands: ClassVar = {
        "describe": Row("page", ("D",)),
        "describeBody": Row(_describe, ("Shift D",)),
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._before: Description | None = None
        self._touches: TouchWatch | None = None  # while the page asks for it

    def build(self) -> None:
        """See `Feature`."""
        self._before = None
        self._follow_touches(self._touches is not None)

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case Describe(mass):
                self.page.soon(lambda: self._describe(mass))
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

    def _describe(self, mass: int | None) -> None:
        """Describe what is selected, or a mass, or the body."""
        session = self.session
        part = _only(session.selection)
        if part is None and mass is not None and mass < len(session.scene.masses):
            part = "mass", mass
        if part is None:
            self.describe(session)
            return
        scene = session.simulation.scene
        found = describe_part(session.simulation, scene, *part)
        text = of_part(found, scene, is_in_hand=part[0] == "mass" and part[1] in session.hands.masses)
        self.page.mail.send(Described(text=text))

    def describe(self, session: Session) -> None:
        """Describe the body as it is now; how it swings is found in another thread."""
        scene = session.simulation.scene
        found, before = describe(session.simulation, scene), self._before
        self._before = found
        positions = session.simulation.positions.copy()
        threads.submit(copy_context().run, self._say, found, scene, positions, before)

    def _say(
        self, found: Description, scene: Scene, positions: NDArray[np.float64], before: Description | None
    ) -> None:
        told = Described(text=paragraph(found, scene, swing_of(found, scene, positions), before))
        self.page.soon(lambda: self.page.mail.send(told))


def _only(selection: Selection) -> tuple[str, int] | None:
    """The kind and the number of the part that is selected, if it is one."""
    parts = [
        (kind, part)
        for kind, some in zip(("mass", "spring", "joint"), selection, strict=True)
        for part in some
    ]
    return parts[0] if len(parts) == 1 else None
