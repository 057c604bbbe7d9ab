"""The Measure tab, with plots of what is chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ...session.plots import PlotSpec, plot_text
from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ..hands.messages import Pick
from .messages import FirstPlot, InView, Melody, Seen
from .panel import MeasurePanel
from .plot_list import open_plots

if TYPE_CHECKING:
    from ...ui.panel import Panel


def _plot_angle(_: Session, feature: MeasureFeature) -> None:
    if feature.panel is not None:
        feature.panel.plot_angle()


def _hear(_: Session, feature: MeasureFeature) -> None:
    feature.play_plot()


def _hear_live(_: Session, feature: MeasureFeature) -> None:
    feature.turn_live()


_AGAIN = 10.0
"""Seconds after a plot is played within which the key plays the next one: long enough to hear it and what is
said of it."""


class MeasureFeature(Feature):
    """The plots of one page.

    Attributes:
        panel: the Measure tab, or None without that control.
    """

    messages: ClassVar = {Pick: "", Seen: "", FirstPlot: "measure", InView: "measure"}
    commands: ClassVar = {
        "plot": Row(_plot_angle, ("G",), needs="measure"),
        "hear": Row(_hear, ("H",)),
        "hearLive": Row(_hear_live, ("Shift H",)),
    }
    controls: ClassVar = {"measure": "the Measure tab"}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self.panel: MeasurePanel | None = None
        self._remembered: tuple[PlotSpec, ...] = ()
        self._is_visible = True

    @property
    def specs(self) -> tuple[PlotSpec, ...]:
        """What is plotted."""
        return self.panel.plots.specs if self.panel is not None else ()

    @property
    def is_seen(self) -> bool:
        """Whether the plots are visible."""
        return self.panel is not None and self.panel.plots.looked_at

    @property
    def texts_of_plots(self) -> tuple[str, ...]:
        """The names of the plots, see `plot_text`."""
        return tuple(map(plot_text, self.specs))

    @property
    def parts(self) -> tuple[str, ...]:
        """The parts of the body in the list."""
        return self.panel.parts if self.panel is not None else ()

    def remember(self, specs: tuple[PlotSpec, ...]) -> None:
        """Replace the plots by these when the next scene is built."""
        self._remembered = specs
        if self.panel is not None:
            self.panel.plots.remember(specs)

    # --------------------------------------------------------------------- see `Feature`
    def hear(self, said: FromPage) -> None:
        match said:
            case Pick(mass):
                self.page.soon(lambda: self._choose(mass))
            case FirstPlot():
                self.page.soon(lambda: self.panel is not None and self.panel.begin())
            case InView(plot, part):
                if part is None or part[0] < part[1]:
                    self.page.soon(lambda: self.panel is not None and self.panel.plots.zoom(plot, part))
            case Seen(tab):
                self.page.soon(lambda: self._see(tab == "measure"))

    def attach(self, panel: Panel) -> None:
        self.panel = None
        if "measure" in self.page.controls:
            self.panel = MeasurePanel(self.page, panel.tab("Measure"))
            self.panel.plots.remember(self._remembered)
            self.panel.plots.looked_at = self._is_visible

    def detach(self) -> None:
        if self.panel is not None:
            self._remembered = self.panel.plots.specs

    def clear(self) -> None:
        self.remember(())

    def build(self) -> None:
        if self.panel is not None:
            self.panel.build()

    def frame(self, drawn: Drawn) -> None:
        if self.panel is not None:
            self.panel.tick()

    def refresh(self) -> None:
        if self.panel is not None:
            self.panel.refresh()

    # --------------------------------------------------------------------- sound
    @property
    def _played(self) -> int | None:
        """The place of the plot that was played last among those that are open; None if there is none."""
        played = max(self.page.plots, key=lambda plots: plots.played_at, default=None)
        place = (played, played.played) if played is not None else None
        plots = open_plots(self.page)
        return plots.index(place) if place in plots else None

    def play_plot(self) -> None:
        """Play the plot as sound that was played last; soon after that, the next one."""
        plots, last = open_plots(self.page), self._played
        if not plots:
            self.page.mail.send(Melody())
            return
        since = self.session.now() - max(each.played_at for each in self.page.plots)
        of, index = plots[0 if last is None else (last + (since < _AGAIN)) % len(plots)]
        of.play(index)

    def turn_live(self) -> None:
        """Hear the plot that was played last while the body moves, or no longer."""
        plots = open_plots(self.page)
        if not plots:
            self.page.mail.send(Melody())
            return
        of, index = plots[self._played or 0]
        of.turn_live(index)

    # --------------------------------------------------------------------- inside
    def _choose(self, mass: int) -> None:
        if self.panel is not None and mass < len(self.session.scene.masses):
            self.panel.choose(mass)

    def _see(self, on: bool) -> None:
        self._is_visible = on
        if self.panel is not None:
            self.panel.plots.looked_at = on
