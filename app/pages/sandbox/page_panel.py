"""The control panel of a page, made of what its features add."""

from __future__ import annotations

from ...ui.controls import Controls
from ...ui.feature import Feature
from ...ui.page import Page
from ...ui.panel import Panel
from ...viser_inside import element_id


class PagePanel:
    """The panel of one page, which is made again when the page gets other controls.

    Args:
        page: the page.
        features: its features.

    Attributes:
        has_lesson: a lesson is shown.
    """

    def __init__(self, page: Page, features: tuple[Feature, ...]) -> None:
        self._page, self._features = page, features
        self._make()

    def _make(self) -> None:
        self._panel = Panel(self._page)
        self.has_lesson = self._page.has_lesson
        for feature in self._features:
            feature.attach(self._panel)
        self._panel.finish()

    def update(self, wanted: Controls) -> None:
        """Make the panel again if other controls are wanted, or a lesson comes or goes."""
        page = self._page
        if (wanted, page.has_lesson) == (page.controls, self.has_lesson):
            return
        page.controls = wanted
        for feature in self._features:
            feature.detach()
        page.client.gui.reset()
        page.clear()
        self._make()

    @property
    def measure_tab(self) -> str:
        """The id of the Measure tab; empty without one."""
        tab = self._panel.find("Measure")
        return element_id(tab) if tab is not None else ""
