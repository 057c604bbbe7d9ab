"""The Solver tab: method, law and step, energy and predictability, and a second body to compare."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ...session import commands
from ...session.session import Session
from ...ui.board import Board, dials_of
from ...ui.commands import Row
from ...ui.feature import Feature
from ...ui.page import Page
from .panel import SolverPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel

DIALS = ("dt", "tolerance")
"""Settings whose sliders stand here."""


def _energy(session: Session, _: Feature) -> None:
    session.post(commands.FollowEnergy(not session.follows_energy))


def _foretell(session: Session, _: Feature) -> None:
    session.post(commands.MeasurePredictability(session.predictability is None))


class SolverFeature(Feature):
    """The Solver tab of a page, if it has one."""

    commands: ClassVar = {
        "energy": Row(_energy, needs="solver"),
        "foretell": Row(_foretell, needs="solver"),
        "ownSolver": Row(commands.RestoreSceneValues("solver")),
    }
    controls: ClassVar = {"solver": "the Solver tab"}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._panel: SolverPanel | None = None
        self._board = Board(page)
        self._shown_revision = -1

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._panel, self._board = None, Board(self.page)
        if "solver" in self.page.controls:
            self._tab = panel.tab("Solver")
            with self._tab:
                self._panel = SolverPanel(self.page)

    def build(self) -> None:
        """See `Feature`."""
        if self._panel is None:
            return
        self._shown_revision = -1
        self._panel.build()
        dials = [dial for dial in dials_of(self.session.scene) if dial.key in DIALS]
        if self._board.is_new(dials):
            self._board.add_sliders(self._tab, dials)

    @property
    def unsettled(self) -> bool:
        """See `Feature`."""
        return not self._board.settled or (self._panel is not None and self._panel.waits)

    def refresh(self) -> None:
        """See `Feature`."""
        if self._panel is None:
            return
        if self._shown_revision != self.session.revision:
            self._shown_revision = self.session.revision
            self._panel.refresh_controls()
        self._board.show(self.session.scene)
        self._panel.refresh_readouts()
