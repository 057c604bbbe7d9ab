"""Plots in a tab of the panel: they follow the body, with a reading of period and damping and a table."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import viser
from msgspec.structs import replace

from sim.analysis.curves import CURVES
from sim.errors import InputError
from sim.store import files

from ...background import file_worker
from ...session.notices import Notice
from ...session.plots import MAX_PLOTS, Plot, PlotSpec, Span, curve
from ...stage.colors import palette
from ...ui.page import Page, Plots
from ...ui.viser.handlers import on_change
from ...viser_inside import element_id
from ...words import say
from ...words.english import name_of, refusal
from ...words.keys import Key
from . import analysis, hearing, plots
from .messages import Melody, Tones

EVERY = 0.1
"""Seconds between two updates of a plot, at least."""

READ_EVERY = 0.5
"""Seconds between two readings of period and damping, at least."""

PIECES = 150
"""Pieces of a curve from left to right, each with its highest and lowest value."""

SPANS = {"5 s": 5.0, "10 s": 10.0, "20 s": 20.0, "1 min": 60.0, "10 min": 600.0, "1 h": 3600.0}
"""How much time a plot shows, s, by its label."""

SPAN = "10 s"
"""What a new plot shows."""

ADD: Key = "measure-add"
TABLE: Key = "measure-table"
PICTURE: Key = "measure-picture"
HEAR: Key = "measure-hear"
REMOVE: Key = "measure-remove"
"""Buttons below a plot."""

PICTURE_PIECES = 1000
"""Pieces of a curve in a picture."""

ORDER = 100.0
"""Order of the first plot in the panel; the controls above have lower ones."""


def open_plots(page: Page) -> list[tuple[Plots, int]]:
    """The open plots of a page, by their lists and their places in these; those first that are visible."""
    lists = sorted(page.plots, key=lambda plots: not plots.looked_at)
    return [(plots, i) for plots in lists for i in range(len(plots))]


class _OpenPlot:
    """A plot in the page.

    Attributes:
        plot: what it shows.
        chart: its drawing.
        seconds: how much time it shows, s.
        zoom: the part of the time that is shown instead, from and to, s; None for no part.
        run: of the plot in which that part is.
        sent: the version of the plot that `PlotList.tick` sent last; -1 for none. A new chart does not count:
            its lines are pale until it is updated.
    """

    def __init__(self, plot: Plot, page: Page, tab: viser.GuiTabHandle, order: float, is_own: bool) -> None:
        self.plot, self.sent, self.seconds = plot, -1, SPANS[SPAN]
        self.zoom: tuple[float, float] | None = None
        self.run = 0
        self._analysis, self._order, self._is_removed = analysis.NONE, order, False
        self._fits: tuple[analysis.Fit, ...] = ()
        self._page, self._tab, self._is_own = page, tab, is_own
        gui = page.client.gui
        self.chart = self._new_chart()
        with tab:
            self._title = gui.add_html("", order=order)
            self._reading = gui.add_html("", order=order + 2)
            keys = (ADD, TABLE, PICTURE, HEAR, REMOVE) if is_own else (TABLE, PICTURE, HEAR)
            self.buttons = gui.add_button_group("", tuple(map(say, keys)), order=order + 3)
            hint = say("measure-hear-live.hint")
            self.live = gui.add_checkbox(
                say("measure-hear-live"), initial_value=False, hint=hint, order=order + 3.5
            )
            self._lists = self._add_lists(order + 4)

    def _add_lists(self, order: float) -> tuple[viser.GuiDropdownHandle[str], ...]:
        """Add what a user chooses for this plot alone; in a lesson, how it is analysed."""
        page, gui = self._page, self._page.client.gui
        kinds = {analysis.label_of(each): each for each in self._kinds}
        kind = gui.add_dropdown(
            say("measure-analysis"), tuple(kinds), initial_value=next(iter(kinds)), order=order + 1
        )
        on_change(kind, lambda: page.later(partial(self._prepare, kinds.get(kind.value, ""))))
        if not self._is_own:
            return (kind,)
        span = gui.add_dropdown(say("measure-span"), tuple(SPANS), initial_value=SPAN, order=order)
        on_change(span, lambda: page.later(partial(self._set_span, span.value)))
        return span, kind

    @property
    def _kinds(self) -> tuple[str, ...]:
        """What it can be analysed by."""
        return analysis.OVER_ANOTHER if self.plot.spec.over else analysis.OVER_TIME

    def _set_span(self, label: str) -> None:
        self.seconds = SPANS.get(label, self.seconds)
        self.renew()

    def _prepare(self, kind: str) -> None:
        """Analyse by another kind, once what it takes is loaded."""
        if kind not in self._kinds:  # a page can send any text
            return

        def load() -> None:
            import scipy.optimize  # noqa: F401 - it would hold up a frame

            self._page.later(partial(self._analyse, kind))

        if kind in CURVES:
            file_worker.submit(load)
        else:
            self._analyse(kind)

    def _analyse(self, kind: str) -> None:
        self._analysis, self._fits = kind, ()
        self.renew(self.zoom)

    @property
    def _span(self) -> Span:
        """The time that is in view."""
        return self.zoom or self.seconds

    def _new_chart(self) -> plots.TimeChart | plots.PhaseChart | plots.SpectrumChart:
        gui, order = self._page.client.gui, self._order + 1
        if self._analysis == analysis.SPECTRUM:
            return plots.SpectrumChart(gui, order)
        return (plots.PhaseChart if self.plot.spec.over else plots.TimeChart)(gui, order)

    def zoom_to(self, part: tuple[float, float] | None) -> None:
        """Show a part of the time, as the page does already."""
        self.zoom, self.run = part, self.plot.run
        self.show(reads=True)

    def renew(self, zoom: tuple[float, float] | None = None) -> None:
        """Draw it anew, with other lines or another part of the time."""
        if self._is_removed:
            return
        self.chart.remove()
        self.zoom, self.chart, self.sent = zoom, self._new_chart(), -1
        self.show(reads=True)

    def remove(self) -> None:
        """Remove it from the page."""
        self._is_removed = True
        for handle in (self._title, self._reading, self.buttons, self.live, *self._lists):
            handle.remove()
        self.chart.remove()

    def show(self, reads: bool) -> None:
        """Send what it shows; with `reads`, period and damping, too."""
        page, plot = self._page, self.plot
        colors = palette(page.session.scene.view.colors, page.looks.dark)
        with page.client.atomic(), self._tab:
            if reads:
                self._title.content = plots.title(plot, plots.colors_of(plot, colors))
            if isinstance(self.chart, plots.SpectrumChart):
                if reads:
                    spectra = analysis.draw_spectra(plot, self._span)
                    self.chart.draw(plot, spectra, colors)
                    self._reading.content = spectra.text
                return
            if reads and self._analysis in CURVES:
                self._fits = analysis.fits_of(plot, self._span, self._analysis)
                self._reading.content = analysis.fits_text(plot, self._fits)
            elif reads:
                # In a lesson, it is not the user who plots something that does not swing.
                none: Key | None = "measure-still" if self._is_own else None
                self._reading.content = plots.reading(plot, self._span, none)
            self.chart.draw(plot, curve(plot, self._span, PIECES), colors, self._fits)

    # --------------------------------------------------------------------- buttons
    def download(self) -> None:
        """Send all values as a table."""
        self._send(".csv", self.plot.table(self._page.commas.on).encode())

    def draw_picture(self) -> None:
        """Send the plot as it is shown, as a picture; in another thread, since matplotlib is slow."""
        scene, plot = self._page.session.scene, self.plot
        is_spectrum = self._analysis == analysis.SPECTRUM
        spectra = analysis.draw_spectra(plot, self._span, PICTURE_PIECES) if is_spectrum else None
        drawn = curve(plot, self._span, PICTURE_PIECES)
        fits = tuple(fit.at for fit in self._fits)
        colors, title = plots.colors_of(plot, palette(scene.view.colors, dark=False)), name_of(scene)

        def make() -> None:
            from ...export.plot_picture import plot_png, spectrum_png  # matplotlib does not delay the start

            if spectra is None:
                data = plot_png(plot, drawn, colors, title, fits)
            else:
                data = spectrum_png(plot, *spectra[:3], colors, title)
            self._send(".png", data)

        file_worker.submit(make)

    @property
    def id(self) -> str:
        """The id of the control that draws it; empty before it is drawn."""
        handle = self.chart.handle
        return "" if handle is None else element_id(handle)

    @property
    def melody(self) -> Melody:
        """What is in view, as it is heard."""
        if self._analysis == analysis.SPECTRUM:
            drawn = analysis.draw_spectra(self.plot, self._span, hearing.NOTES)
            return hearing.spectrum_melody(self.plot, drawn, self.id)
        return hearing.melody(self.plot, self._span, self.id)

    def sound(self) -> None:
        """Send its newest values as tones."""
        self._page.mail.send(hearing.tones(self.plot, self._span, self.id))

    def _send(self, suffix: str, data: bytes) -> None:
        name = f"{self._page.session.scene.name}-{files.safe_name(self.plot.spec.names[0])}{suffix}"
        self._page.client.send_file_download(name, data, save_immediately=True)


class PlotList:
    """Plots of a session, one below the other.

    Args:
        page: whose body is plotted.
        tab: where they stand.
        extend: returns the name of the quantity that the button "Add to it" adds; None if the user may not
            change the plots.
        changed: called when plots are opened or removed.

    Attributes:
        looked_at: whether the plots are visible; hidden ones record values, but are not sent.
        played_at: when one of them was played last as sound, s.
    """

    def __init__(
        self,
        page: Page,
        tab: viser.GuiTabHandle,
        extend: Callable[[], str] | None = None,
        changed: Callable[[], None] = lambda: None,
    ) -> None:
        self._page, self._session, self._tab = page, page.session, tab
        self._extend_by, self._changed = extend, changed
        page.plots.append(self)
        self._plots: list[_OpenPlot] = []
        self._pending: tuple[PlotSpec, ...] | None = None  # replace the plots with the next scene
        self._due = self._read_due = 0.0
        self._count = 0
        self._live: _OpenPlot | None = None
        self._played: _OpenPlot | None = None
        self.played_at = -math.inf
        self.looked_at = True

    def __len__(self) -> int:
        return len(self._plots)

    @property
    def names(self) -> tuple[str, ...]:
        """The quantities that are plotted."""
        return tuple(name for shown in self._plots for name in shown.plot.spec.names)

    @property
    def specs(self) -> tuple[PlotSpec, ...]:
        """What is plotted, or will be with the next scene."""
        return tuple(shown.plot.spec for shown in self._plots) if self._pending is None else self._pending

    @property
    def wants_energy(self) -> bool:
        """Whether any quantity is an entry of the energy balance."""
        return any(shown.plot.wants_energy for shown in self._plots)

    def remember(self, specs: tuple[PlotSpec, ...]) -> None:
        """Replace the plots by these when the next scene is built."""
        self._pending = specs[:MAX_PLOTS]

    def build(self) -> None:
        """Adapt to another scene or other looks: plots of missing parts are removed; the others continue,
        unless their units or axes change."""
        specs, self._pending = self._pending, None
        if specs is not None:
            for shown in list(self._plots):
                self._remove(shown)
            for spec in specs:
                self.add(spec)
        for shown in list(self._plots):
            before = shown.plot
            try:
                plot = Plot(before.spec, self._session.scene, before.in_words)
            except InputError:
                self._remove(shown)
                continue
            is_turned = plot.turned != before.turned
            if is_turned:
                shown.chart.remove()
            if is_turned or [q.unit for q in plot.quantities] != [q.unit for q in before.quantities]:
                plot.version = shown.sent + 1
                shown.plot = plot
        self.redraw()

    def tick(self) -> None:
        """Record the present values, and show them when it is time."""
        if not self._plots:
            return
        session, now = self._session, self._session.now()
        for shown in self._plots:
            shown.plot.sample(session)
            if shown is self._live:
                shown.sound()
            if shown.zoom is not None and shown.run != shown.plot.run:
                shown.renew()
        if now < self._due or not self.looked_at:
            return
        self._due = now + EVERY
        reads = now >= self._read_due
        if reads:
            self._read_due = now + READ_EVERY
        for shown in self._plots:
            if shown.sent != shown.plot.version:
                shown.show(reads)
                if reads:
                    shown.sent = shown.plot.version

    def add(self, spec: PlotSpec) -> None:
        """Open a plot, or notify the user why that is impossible."""
        try:
            if len(self._plots) == MAX_PLOTS:
                raise InputError(say("measure-no-room", count=MAX_PLOTS))
            plot = Plot(spec, self._session.scene, in_words=self._extend_by is None)
        except InputError as error:
            self._page.notify(Notice("error", say("measure-cannot"), refusal(error)))
            return
        self._count += 1
        shown = _OpenPlot(
            plot, self._page, self._tab, 10.0 * self._count + ORDER, self._extend_by is not None
        )
        self._plots.append(shown)
        presses = {
            say(TABLE): shown.download, say(PICTURE): shown.draw_picture,
            say(HEAR): partial(self._play, shown), say(ADD): partial(self._extend, shown),
            say(REMOVE): partial(self._remove, shown),
        }  # fmt: skip

        @shown.buttons.on_click
        async def _(event: viser.GuiEvent[Any]) -> None:
            label = event.target.value
            if event.client_id is not None and label in shown.buttons.options:
                self._page.later(presses[label])

        on_change(shown.live, lambda: self._page.later(lambda: self._listen(shown, shown.live.value)))
        plot.sample(self._session)
        self._changed()
        shown.show(reads=True)

    def zoom(self, control: str, part: tuple[float, float] | None) -> None:
        """Show a part of the time of the plot whose chart has this id, or all of it."""
        for shown in self._plots:
            if shown.id == control and isinstance(shown.chart, plots.TimeChart):
                shown.zoom_to(part)

    # --------------------------------------------------------------------- sound
    @property
    def played(self) -> int:
        """The plot that was played last; -1 for none."""
        return self._plots.index(self._played) if self._played in self._plots else -1

    def play(self, index: int) -> None:
        """Send one of the plots as a melody."""
        self._play(self._plots[index])

    def _play(self, shown: _OpenPlot) -> None:
        if shown not in self._plots:
            return
        self._played, self.played_at = shown, self._session.now()
        plots = open_plots(self._page)
        number = plots.index((self, self._plots.index(shown))) + 1
        self._page.mail.send(replace(shown.melody, number=number, count=len(plots)))

    def turn_live(self, index: int) -> None:
        """Hear one of the plots while the body moves, or no longer."""
        shown = self._plots[index]
        shown.live.value = shown is not self._live
        self._listen(shown, shown.live.value)

    def fall_silent(self) -> None:
        """Hear no plot while the body moves."""
        if self._live is not None:
            self._live.live.value = False
            self._live = None
            self._page.mail.send(Tones())

    def _listen(self, shown: _OpenPlot, on: bool) -> None:
        """Hear a plot while the body moves, and no other one; or no longer."""
        for plots_of in self._page.plots:
            plots_of.fall_silent()
        if on and shown in self._plots:
            self._live = shown
            shown.live.value = True
            shown.sound()

    def redraw(self) -> None:
        """Send all plots."""
        for shown in self._plots:
            shown.show(reads=True)

    def _remove(self, shown: _OpenPlot) -> None:
        if shown not in self._plots:
            return
        self._plots.remove(shown)
        if shown is self._live:
            self.fall_silent()
        shown.remove()
        if not (self._session.follows_energy or any(each.wants_energy for each in self._page.plots)):
            self._session.simulation.track_energy(False)
        self._changed()

    def _extend(self, shown: _OpenPlot) -> None:
        """Add the chosen quantity to a plot."""
        assert self._extend_by is not None
        spec, name = shown.plot.spec, self._extend_by()
        if shown not in self._plots or name in spec.names:
            return
        try:
            plot = Plot(PlotSpec((*spec.names, name), spec.over), self._session.scene)
        except InputError as error:
            self._page.notify(Notice("error", say("measure-cannot-add"), refusal(error)))
            return
        plot.take_over(shown.plot)
        shown.chart.remove()
        shown.plot, shown.sent = plot, -1
        plot.sample(self._session)
        shown.show(reads=True)
