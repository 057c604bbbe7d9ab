"""Instruments on the canvas: arrows, traces, coordinates, ruler, protractor, stopwatch and light gate."""

from __future__ import annotations

from collections.abc import Set
from typing import TYPE_CHECKING, ClassVar

from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ..hands.messages import Pick
from .messages import PutBack
from .panel import ToolsPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel


class InstrumentsFeature(Feature):
    """The instruments of one page.

    Attributes:
        panel: their switches, or None without that control.
    """

    messages: ClassVar = {Pick: ""}
    commands: ClassVar = {
        "stopwatch": Row("own", ("T", "L")),
    }
    controls: ClassVar = {"tools": "the instruments"}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self.panel: ToolsPanel | None = None
        self._remembered: frozenset[str] = frozenset()

    @property
    def arrows(self) -> frozenset[str]:
        """The kinds of arrows that are on."""
        return self.panel.kinds if self.panel is not None else frozenset()

    def show_arrows(self, kinds: Set[str]) -> None:
        """Show arrows of these kinds only."""
        if self.panel is not None:
            self.panel.show_arrows(kinds)

    # --------------------------------------------------------------------- see `Feature`
    def hear(self, said: FromPage) -> None:
        if isinstance(said, Pick):
            self.page.soon(lambda: self.panel is not None and self.panel.choose(said.mass))

    def attach(self, panel: Panel) -> None:
        self.panel = None
        if "tools" in self.page.controls:
            with panel.tab("Measure"):
                self.panel = ToolsPanel(self.page)
            self.panel.show_arrows(self._remembered)

    def detach(self) -> None:
        if self.panel is not None:
            self._remembered = self.panel.leave()

    def clear(self) -> None:
        self._remembered = frozenset()
        self.page.mail.send(PutBack())
        if self.panel is not None:
            self.panel.clear()

    def build(self) -> None:
        if self.panel is not None:
            self.panel.build()

    def frame(self, drawn: Drawn) -> None:
        if self.panel is not None:
            self.panel.draw(drawn.plan, drawn.now, drawn.exactly)
