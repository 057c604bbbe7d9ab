"""The card beside a mass that was clicked."""

from __future__ import annotations

from typing import ClassVar

from ...ui import readouts
from ...ui.feature import Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ..hands.messages import Pick
from .messages import CloseCard, MassCard


class ReadingFeature(Feature):
    """Says the numbers of the mass that was clicked, until it is clicked again."""

    messages: ClassVar = {Pick: "", CloseCard: ""}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._mass = -1

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case Pick(mass):
                self.page.soon(lambda: self._read(-1 if mass == self._mass else mass))
            case CloseCard():
                self.page.soon(lambda: self._read(-1))
            case _:
                pass

    def build(self) -> None:
        """See `Feature`."""
        self._read(-1)

    def refresh(self) -> None:
        """See `Feature`."""
        if self._mass >= 0:
            self._send()

    def _read(self, mass: int) -> None:
        self._mass = mass if mass < len(self.session.scene.masses) else -1
        self._send()

    def _send(self) -> None:
        if self._mass < 0:
            self.page.mail.send(MassCard())
            return
        joint = readouts.joint_of_mass(self.session.scene, self._mass)
        title, rows = readouts.reading(self.session, self._mass, joint)
        joint = -1 if joint is None else joint
        self.page.mail.send(MassCard(mass=self._mass, joint=joint, title=title, rows=tuple(rows.items())))
