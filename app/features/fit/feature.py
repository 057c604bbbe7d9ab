"""Fitting the scene to a table of what was measured."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...ui.feature import Feature
from .panel import FitPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel


class FitFeature(Feature):
    """The table of a page, in its Measure tab."""

    _panel: FitPanel | None = None

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._panel = None
        if "measure" in self.page.controls:
            self._panel = FitPanel(self.page, panel.tab("Measure"))
            self.page.take_tables = self._panel.take

    def detach(self) -> None:
        """See `Feature`."""
        if self._panel is not None:
            self._panel.forget()

    def build(self) -> None:
        """See `Feature`."""
        if self._panel is not None:
            self._panel.build()
