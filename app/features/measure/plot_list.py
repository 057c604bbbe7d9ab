"""Plots in a tab of the panel: they run with the body, with period and damping, and their tables.

Where no plot is open there is nothing to do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import viser

from sim.errors import InputError
from sim.scene.types import shown_name

from ...export.workshop import workshop
from ...session.notices import Notice
from ...session.plots import MAX_PLOTS, Plot, Wish, curve
from ...stage.colors import palette
from ...ui.page import Page
from . import plots
from .messages import Melody

EVERY = 0.1
"""Seconds between two updates of a plot, at least."""

READ_EVERY = 0.5
"""Seconds between two readings of period and damping."""

WIDTH, HEIGHT = 150, 220
"""Pieces of a curve from left to right, each with its highest and lowest value; pixels of a plot's height."""

SPANS = {"5 s": 5.0, "10 s": 10.0, "20 s": 20.0, "60 s": 60.0}
"""How much time a plot shows."""

ADD, TABLE, PICTURE, HEAR, REMOVE = "Add to it", "CSV", "Picture", "Hear", "Remove"
"""Buttons below a plot."""

NOTES = 240
"""Values of a plot that is heard."""

PICTURE_PIECES = 1000
"""Pieces of a curve in a picture."""

FIRST = 100.0
"""Order of the first plot: what stands above them has lower numbers."""


@dataclass
class _Shown:
    """A plot in the page. Its chart keeps its number of lines: after a change viser may draw nothing."""

    plot: Plot
    title: viser.GuiHtmlHandle
    reading: viser.GuiHtmlHandle
    buttons: viser.GuiButtonGroupHandle
    order: float  # of the chart
    chart: viser.GuiUplotHandle | viser.GuiHtmlHandle | None = None
    sent: int = -1  # the version of the plot that the page has
    looks: tuple[object, ...] = ()  # what its lines and axes are for

    def remove(self) -> None:
        """Take it out of the page."""
        for handle in (self.title, self.reading, self.buttons):
            handle.remove()
        self.remove_chart()

    def remove_chart(self) -> None:
        """Take its chart out of the page; the next time that it is shown it gets another one."""
        if self.chart is not None:
            self.chart.remove()
        self.chart = None


class PlotList:
    """Plots of a session, one below the other.

    Args:
        page: whose body is plotted.
        tab: where they stand.
        extend: the name of the quantity that the button "Add to it" adds to a plot; None where plots are not
            the user's own to change.
        changed: called when plots came or went.

    Attributes:
        looked_at: whether anybody sees the plots; otherwise they run on, but are not sent.
        seconds: how much time they show.
    """

    def __init__(
        self,
        page: Page,
        tab: viser.GuiTabHandle,
        extend: Callable[[], str] | None = None,
        changed: Callable[[], None] = lambda: None,
    ) -> None:
        self._page, self._client, self._session, self._tab = page, page.client, page.session, tab
        self._extend_by, self._changed = extend, changed
        page.plots.append(self)
        self._plots: list[_Shown] = []
        self._kept: tuple[Wish, ...] | None = None  # None for those that are open
        self._due = self._read_due = 0.0
        self._numbers = 0
        self.looked_at = True
        self.seconds = 10.0

    def __len__(self) -> int:
        return len(self._plots)

    @property
    def names(self) -> tuple[str, ...]:
        """The quantities that are plotted."""
        return tuple(name for shown in self._plots for name in shown.plot.wish.names)

    @property
    def wishes(self) -> tuple[Wish, ...]:
        """The plots that are open."""
        return tuple(shown.plot.wish for shown in self._plots) if self._kept is None else self._kept

    @property
    def wants_energy(self) -> bool:
        """Whether any quantity is an entry of the energy balance."""
        return any(shown.plot.wants_energy for shown in self._plots)

    def remember(self, wishes: tuple[Wish, ...]) -> None:
        """Have these plots, and no others, as soon as the scene is there that they are of."""
        self._kept = wishes[:MAX_PLOTS]

    def build(self) -> None:
        """Another scene, or other looks: plots of what is not there any more go, the others begin anew if
        their time does."""
        scene = self._session.scene
        wishes, self._kept = self._kept, None
        if wishes is not None:
            for shown in list(self._plots):
                self._remove(shown)
            for wish in wishes:
                self.add(wish)
        for shown in list(self._plots):
            try:
                plot = Plot(shown.plot.wish, scene)
            except InputError:
                self._remove(shown)
                continue
            units = [q.unit for q in plot.quantities]
            if units != [q.unit for q in shown.plot.quantities] or plot.turned != shown.plot.turned:
                if plot.turned != shown.plot.turned:
                    shown.remove_chart()
                plot.version = shown.sent + 1
                shown.plot = plot
        self.redraw()

    def tick(self) -> None:
        """Note the present values, and show them when it is time."""
        if not self._plots:
            return
        session, now = self._session, self._session.now()
        for shown in self._plots:
            shown.plot.sample(session)
        if now >= self._due and self.looked_at:
            self._due = now + EVERY
            reads = now >= self._read_due
            if reads:
                self._read_due = now + READ_EVERY
            for shown in self._plots:
                if shown.sent != shown.plot.version:
                    self._show(shown, reads)
                    if reads:
                        shown.sent = shown.plot.version

    def add(self, wish: Wish) -> None:
        """Open a plot, or say why not."""
        try:
            if len(self._plots) == MAX_PLOTS:
                raise InputError(f"a page has room for {MAX_PLOTS} plots; remove one first")
            plot = Plot(wish, self._session.scene)
        except InputError as error:
            self._page.notify(Notice("error", "That cannot be plotted", f"{error}."))
            return
        self._numbers += 1
        order, gui = 10.0 * self._numbers + FIRST, self._client.gui
        mine = (TABLE, PICTURE, HEAR)
        if self._extend_by is not None:
            mine = (ADD, *mine, REMOVE)
        with self._tab:
            title = gui.add_html("", order=order)
            reading = gui.add_html("", order=order + 2)
            buttons = gui.add_button_group("", mine, order=order + 3)
        shown = _Shown(plot, title, reading, buttons, order + 1)
        self._plots.append(shown)

        @buttons.on_click
        async def _(event: viser.GuiEvent[Any]) -> None:
            actions = {
                ADD: self._extend,
                TABLE: self._download,
                PICTURE: self._picture,
                HEAR: self._hear,
                REMOVE: self._remove,
            }
            if event.client_id is not None and event.target.value in mine:
                self._page.later(partial(actions[event.target.value], shown))

        plot.sample(self._session)
        self._changed()
        self._show(shown, reads=True)

    def redraw(self) -> None:
        """Send all plots."""
        for shown in self._plots:
            self._show(shown, reads=True)

    # --------------------------------------------------------------------- buttons
    def _remove(self, shown: _Shown) -> None:
        if shown not in self._plots:
            return
        self._plots.remove(shown)
        shown.remove()
        if not (self._session.follows_energy or any(plots.wants_energy for plots in self._page.plots)):
            self._session.simulation.track_energy(False)
        self._changed()

    def _extend(self, shown: _Shown) -> None:
        """Plot what is chosen beside what a plot has."""
        assert self._extend_by is not None
        wish, name = shown.plot.wish, self._extend_by()
        if shown not in self._plots or name in wish.names:
            return
        try:
            plot = Plot(Wish((*wish.names, name), wish.over), self._session.scene)
        except InputError as error:
            self._page.notify(Notice("error", "That cannot be added", f"{error}."))
            return
        plot.take_over(shown.plot)
        shown.remove_chart()
        shown.plot, shown.sent = plot, -1
        plot.sample(self._session)
        self._show(shown, reads=True)

    def _download(self, shown: _Shown) -> None:
        name = f"{self._session.scene.name}-{shown.plot.wish.names[0]}.csv"
        table = shown.plot.table(self._page.commas.on).encode()
        self._client.send_file_download(name, table, save_immediately=True)

    def _picture(self, shown: _Shown) -> None:
        """Send the plot as it is shown, as a picture; matplotlib takes a while to draw it."""
        scene, plot = self._session.scene, shown.plot
        drawn = curve(plot, self.seconds, PICTURE_PIECES)
        colors = plots.colors_of(plot, palette(scene.view.colors, dark=False))
        title, name = shown_name(scene), f"{scene.name}-{plot.wish.names[0]}.png"

        def make() -> None:
            from ...export.plot_picture import plot_png  # matplotlib does not delay the start

            self._client.send_file_download(name, plot_png(plot, drawn, colors, title), save_immediately=True)

        workshop.submit(make)

    def _hear(self, shown: _Shown) -> None:
        """Have the first quantity of a plot heard, as far as it is past."""
        quantity, rows = shown.plot.quantities[0], shown.plot.window(self.seconds)
        if not len(rows):
            return
        times = np.linspace(rows[0, 0], rows[-1, 0], NOTES)
        # At the moments that there are: between two of them nobody knows.
        places = np.minimum(np.searchsorted(rows[:, 0], times), len(rows) - 1)
        values = tuple(float(v) if np.isfinite(v) else None for v in rows[places, 1])
        self._page.mail.send(Melody(name=quantity.name, unit=quantity.unit, values=values))

    # --------------------------------------------------------------------- drawing
    def _show(self, shown: _Shown, reads: bool) -> None:
        """Send a plot."""
        plot, seconds = shown.plot, self.seconds
        drawn = curve(plot, seconds, WIDTH)
        colors = palette(self._session.scene.view.colors, self._page.looks.dark)
        series = plots.colors_of(plot, colors)
        gui, chart = self._client.gui, shown.chart
        with self._client.atomic(), self._tab:
            if plot.wish.over:
                content = plots.draw_over_another(plot, drawn, series)
                if isinstance(chart, viser.GuiHtmlHandle):
                    chart.content = content
                else:
                    shown.chart = gui.add_html(content, order=shown.order)
            else:
                before = chart if isinstance(chart, viser.GuiUplotHandle) else None
                # At the right there is an axis, or else room for half of the last number of the time.
                padding = (8, 4 if len(plot.units) > 1 else 20, 0, 0)
                add = partial(gui.add_uplot, height=HEIGHT, padding=padding, order=shown.order)
                shown.chart, shown.looks = plots.draw_over_time(
                    before, add, plot, drawn, series, colors, shown.looks
                )
            if reads:
                shown.title.content = plots.title(plot, series)
                # In a lesson, it is not the user who asked for a plot of something that does not swing.
                none = ("",) if self._extend_by is None else ()
                shown.reading.content = plots.reading(plot, seconds, *none)
