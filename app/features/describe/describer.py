"""Describes the body of a page, or a part of it, to the page's script."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sim.analysis.description import Description, describe
from sim.analysis.part_description import describe_part
from sim.edit.edit import Selection
from sim.scene.types import Scene

from ...session.session import Session
from ...ui.queues import SerialQueue
from ...wire.carrier import Mail
from .messages import Described
from .paragraph import paragraph, swing_of
from .part import of_part


class Describer:
    """Describes what one page shows.

    Args:
        mail: to the page's script.
        soon: has the ticker call a function; any thread may ask.
    """

    def __init__(self, mail: Mail, soon: Callable[[Callable[[], object]], object]) -> None:
        self._mail, self._soon = mail, soon
        self._queue = SerialQueue(lambda _: None)  # what is asked meanwhile is overtaken, and done at once
        self._asked = 0
        self._before: Description | None = None

    def forget(self) -> None:
        """Another body takes the place of the one that was described."""
        self._asked += 1
        self._before = None

    def describe(self, session: Session, mass: int | None) -> None:
        """Describe what is selected, or a mass, or the body."""
        self._asked += 1
        part = _only(session.selection)
        if part is None and mass is not None and mass < len(session.scene.masses):
            part = "mass", mass
        if part is None:
            self.describe_body(session)
            return
        scene = session.simulation.scene
        found = describe_part(session.simulation, scene, *part)
        text = of_part(found, scene, is_in_hand=part[0] == "mass" and part[1] in session.hands.masses)
        self._mail.send(Described(text=text))

    def describe_body(self, session: Session) -> None:
        """Describe the body as it is now; how it swings is found in another thread.

        A description that another one has overtaken is not told any more.
        """
        self._asked += 1
        scene = session.simulation.scene
        found = describe(session.simulation, scene)
        positions = session.simulation.positions.copy()
        self._queue.submit(self._say, self._asked, found, scene, positions, self._before)

    def _say(
        self,
        asked: int,
        found: Description,
        scene: Scene,
        positions: NDArray[np.float64],
        before: Description | None,
    ) -> None:
        if asked != self._asked:
            return
        text = paragraph(found, scene, swing_of(found, scene, positions), before)
        self._soon(lambda: self._tell(asked, text, found))

    def _tell(self, asked: int, text: str, found: Description) -> None:
        if asked == self._asked:
            self._before = found  # what is told next compares with what was heard
            self._mail.send(Described(text=text))


def _only(selection: Selection) -> tuple[str, int] | None:
    """The kind and the number of the part that is selected, if it is one."""
    parts = [
        (kind, part)
        for kind, some in zip(("mass", "spring", "joint"), selection, strict=True)
        for part in some
    ]
    return parts[0] if len(parts) == 1 else None
