"""How plots look in the page: lines, axes, colours, title and reading."""

from __future__ import annotations

import html
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import viser
from numpy.typing import NDArray
from viser import uplot

import sim
from sim.analysis.swings import swings

from ...lessons import quantity_text
from ...session.plots import Plot, PlotWindow, Span
from ...stage.colors import Palette
from ...stage.looks import FONT
from ...ui import readouts
from ...words import joined, number, say
from ...words.keys import Key
from ...words.quantities import kind_of_part, quantity_of
from .analysis import DrawnSpectrum, Fit
from .phase import phase_svg

_COLORS = ("brand", "pulled", "torque_plus", "torque_minus", "held")
_COLOR_OF = {"joint": "torque_plus", "spring": "pulled", "mass": "brand", "body": "brand", "ghost": "held"}
"""Colours by kind of part, as on the canvas; a second part of a kind gets the next free one of `_COLORS`."""

_FONT = f"12px {FONT}"

_MAX_LABEL = 26
"""Letters of an axis label that fit."""

FIT_POINTS = 100
"""Points of a curve over another quantity."""

HEIGHT = 220
"""Height of a chart, pixels."""

_PER_PERIOD = 3
"""Thinned rows in a period, at least, by which it is read: of a faster swing they have the envelope only."""

PALE = 0.35
"""Opacity of values that are later than the moment shown."""


class TimeChart:
    """A plot over time, drawn by uPlot.

    Values later than the moment shown are pale: one line ends there, and a pale one has all values. After the
    number of lines has changed, the chart is to be removed: viser may draw nothing.

    Args:
        gui: of the page.
        order: in the panel.
    """

    def __init__(self, gui: viser.GuiApi, order: float) -> None:
        self._gui, self._order = gui, order
        self._chart: viser.GuiUplotHandle | None = None
        self._looks: tuple[object, ...] = ()  # all that its lines and axes depend on

    def remove(self) -> None:
        """Remove it from the page; `draw` creates it again."""
        if self._chart is not None:
            self._chart.remove()
        self._chart = None

    @property
    def handle(self) -> viser.GuiUplotHandle | None:
        """viser's handle; None before it is drawn."""
        return self._chart

    def draw(self, plot: Plot, drawn: PlotWindow, colors: Palette, fits: Sequence[Fit] = ()) -> None:
        """Send the values, and lines and axes if they have changed."""
        series = colors_of(plot, colors)
        # uPlot takes the first value of a line as a number when it determines ranges, so that must exist.
        values, past = drawn
        some: NDArray[np.bool_] = np.asarray(np.isfinite(values).any(1))
        begin = int(np.isfinite(values[some]).all(0).argmax())
        values, past = values[:, begin:], max(past - begin, 0)
        ahead = past < values.shape[1]
        if values.shape[1] == 1:  # an empty range has no ticks
            values = np.column_stack((values, values))
            values[0, 1] += 0.1
        # Without later values the pale line is left empty: otherwise everything would be sent twice.
        until, whole = values, [np.zeros(0)] * len(series)
        if ahead or self._chart is None:  # viser creates charts with lines of equal length only
            until, whole = values.copy(), list(values[1:])
            until[1:, past:] = np.nan
        data = *until, *whole, *(fit.at(values[0]) for fit in fits)
        before = self._looks
        self._looks = plot.spec, *series, colors.css("text"), *some.tolist(), plot.units, plot.turned
        lines = *_lines(plot, series, some), *_fit_lines(plot, fits, colors)
        axes = _axes(plot, colors)
        if self._chart is None:
            self._chart = self._create(plot, data, lines, axes)
            return
        self._chart.data = data
        if self._looks != before:
            self._chart.series, self._chart.axes = lines, axes

    def _create(self, plot: Plot, data: Any, lines: Any, axes: Any) -> viser.GuiUplotHandle:
        upwards: dict[str, uplot.Scale] = {
            f"y{i}": {"dir": -1} if turned else {} for i, turned in enumerate(plot.turned)
        }
        return self._gui.add_uplot(
            data,
            lines,
            scales={"x": {"time": False}, **upwards},
            axes=axes,
            cursor={"drag": {"x": True, "y": False}},
            # At the right there is an axis, or else room for half of the last label of the time.
            padding=(8, 4 if len(plot.units) > 1 else 20, 0, 0),
            height=HEIGHT,
            order=self._order,
        )


class SvgChart:
    """A plot that the server draws, as SVG; arguments are those of `TimeChart`."""

    def __init__(self, gui: viser.GuiApi, order: float) -> None:
        self._gui, self._order = gui, order
        self._chart: viser.GuiHtmlHandle | None = None

    @property
    def handle(self) -> viser.GuiHtmlHandle | None:
        """viser's handle; None before it is drawn."""
        return self._chart

    def remove(self) -> None:
        """Remove it from the page."""
        if self._chart is not None:
            self._chart.remove()
        self._chart = None

    def put(self, content: str) -> None:
        """Send the drawing."""
        if self._chart is None:
            self._chart = self._gui.add_html(content, order=self._order)
        else:
            self._chart.content = content


class PhaseChart(SvgChart):
    """A plot over another quantity than time; arguments and methods are those of `TimeChart`."""

    def draw(self, plot: Plot, drawn: PlotWindow, colors: Palette, fits: Sequence[Fit] = ()) -> None:
        """Send the drawing."""
        self.put(draw_over_another(plot, drawn, colors_of(plot, colors), fits))


class SpectrumChart(SvgChart):
    """The amplitude spectra of a plot."""

    def draw(self, plot: Plot, drawn: DrawnSpectrum, colors: Palette) -> None:
        """Send the drawing."""
        labels = (
            say("measure-axis-frequency"),
            say("measure-axis-amplitude", quantity=_labelled(plot, plot.quantities)),
        )
        name = say(
            "measure-title-spectrum",
            quantity=joined(called(plot, one) for one in plot.quantities[: len(plot.spec.names)]),
        )
        series = colors_of(plot, colors)
        self.put(
            phase_svg(drawn.frequencies, drawn.amplitudes, None, series, labels, name, peaks=drawn.peaks)
        )


def draw_over_another(plot: Plot, drawn: PlotWindow, series: Sequence[str], fits: Sequence[Fit] = ()) -> str:
    """Return a plot over another quantity than time, as HTML."""
    count, values = len(plot.spec.names), drawn.values
    turned = any(plot.turned)
    labels = (
        _labelled(plot, plot.quantities[-1:]),
        downwards(_labelled(plot, plot.quantities[:count]), turned),
    )
    name = say(
        "measure-title-over",
        quantity=joined(called(plot, one) for one in plot.quantities[: len(plot.spec.names)]),
        over=called(plot, plot.quantities[-1]),
    )
    name = f"{name}. {' '.join(_ranges(plot, drawn))}"
    places = [np.linspace(*fit.ends, FIT_POINTS) for fit in fits]
    curves = [(x, fit.at(x)) for x, fit in zip(places, fits, strict=True)]
    return phase_svg(
        values[1 + count], values[1 : 1 + count], drawn.past, series, labels, name, turned, curves
    )


def _ranges(plot: Plot, drawn: PlotWindow) -> Iterator[str]:
    """Yield a sentence about each quantity, for a screen reader: its value now, and its range."""
    for quantity, some in zip(plot.quantities, drawn.values[1:, : drawn.past], strict=True):
        if (known := some[np.isfinite(some)]).size:
            now, low, high = (
                f"{readouts.grouped(float(value))} {quantity.unit}".strip()
                for value in (known[-1], known.min(), known.max())
            )
            yield say("measure-range", quantity=called(plot, quantity), now=now, low=low, high=high)


def _lines(plot: Plot, series: Sequence[str], some: NDArray[np.bool_]) -> tuple[uplot.Series, ...]:
    until: list[uplot.Series] = []
    whole: list[uplot.Series] = []
    for quantity, color, has_values in zip(plot.quantities, series, some[1:], strict=True):
        line: uplot.Series = {
            "label": joined((called(plot, quantity), quantity.unit)),
            "stroke": color,
            "width": 2.0,
            "scale": f"y{plot.units.index(quantity.unit)}",
            "auto": bool(has_values),
            "points": {"show": False},
        }
        # The legend has one of the two, see page.css.
        until.append({**line, "class": "softrod-until"})
        whole.append({**line, "class": "softrod-whole", "alpha": PALE})
    return {"label": say("measure-axis-time")}, *until, *whole


def _fit_lines(plot: Plot, fits: Sequence[Fit], colors: Palette) -> tuple[uplot.Series, ...]:
    return tuple(
        {
            "label": say("measure-line-fit", quantity=quantity.name),
            "stroke": colors.css("text"),
            "width": 1.0,
            "scale": f"y{plot.units.index(quantity.unit)}",
            "points": {"show": False},
            "class": "softrod-fit",
        }
        for quantity, _ in zip(plot.quantities, fits, strict=False)
    )


def _axes(plot: Plot, colors: Palette) -> tuple[uplot.Axis, ...]:
    text, grid = colors.css("text"), colors.css("line")
    common: uplot.Axis = {
        "stroke": text,
        "font": _FONT,
        "labelFont": _FONT,
        "grid": {"stroke": grid, "width": 1.0},
        "ticks": {"stroke": grid, "width": 1.0, "size": 4.0},
    }
    time = say("measure-axis-time")
    axes: list[uplot.Axis] = [
        {**common, "scale": "x", "label": time, "labelSize": 18.0, "size": 26.0, "space": 36.0}
    ]
    for i, (unit, turned) in enumerate(zip(plot.units, plot.turned, strict=True)):
        label = _label([q for q in plot.quantities[: len(plot.spec.names)] if q.unit == unit], unit)
        axis: uplot.Axis = {
            **common,
            "scale": f"y{i}",
            "side": 1 if i else 3,
            "label": downwards(label, turned),
            "labelSize": 18.0,
            # Forces and energies have many digits.
            "size": 76.0 if unit.startswith(("kg", "N", "J")) else 50.0,
        }
        if i:
            axis["grid"] = {"show": False}
        axes.append(axis)
    return tuple(axes)


def colors_of(plot: Plot, colors: Palette) -> list[str]:
    """Return the CSS colour of each quantity on a vertical axis."""
    taken: list[str] = []
    for quantity in plot.quantities[: len(plot.spec.names)]:
        first = _COLOR_OF.get(quantity.kind.of, _COLORS[0])
        taken.append(next(name for name in (first, *_COLORS) if name not in taken))
    return [colors.css(name) for name in taken]


def called(plot: Plot, quantity: sim.Quantity) -> str:
    """Return what a quantity of a plot is called."""
    return quantity_text(quantity.name) if plot.in_words else quantity.name


def _labelled(plot: Plot, quantities: Sequence[sim.Quantity]) -> str:
    """Return the axis label of quantities of one or two units."""
    units = joined(dict.fromkeys(q.unit for q in quantities))
    if len(quantities) > 1 or quantities[0].formula:
        return _label(quantities, units)
    name = called(plot, quantities[0])
    return joined((name, units))


def _label(quantities: Sequence[sim.Quantity], unit: str) -> str:
    """Return what the quantities are, with their unit; or the kinds of their parts, if that is too long."""
    for words in (
        (quantity_of(q.kind.of, q.kind.what) for q in quantities),
        (kind_of_part(q.kind.of) for q in quantities),
    ):
        label = joined((*dict.fromkeys(words), unit))
        if len(label) <= _MAX_LABEL:
            break
    return label


def downwards(label: str, turned: bool) -> str:
    """Return an axis label that says whether values grow downwards."""
    return say("measure-axis-downwards", label=label) if turned else label


def title(plot: Plot, series: Sequence[str]) -> str:
    """Return the names of the quantities in their colours, as HTML."""
    is_name = "" if plot.in_words else ' translate="no"'
    *upwards, last = (html.escape(called(plot, quantity)) for quantity in plot.quantities)
    keys = " ".join(
        f'<span{is_name}><i style="background:{color}"></i>{name}</span>'
        for name, color in zip(upwards if plot.spec.over else [*upwards, last], series, strict=True)
    )
    said = say("measure-title-over", quantity=keys, over=last) if plot.spec.over else keys
    return f'<div class="softrod-plot-title" role="heading" aria-level="2">{said}</div>'


def reading(plot: Plot, span: Span, none: Key | None = "measure-still") -> str:
    """Return period, amplitude and damping of each oscillating quantity, as HTML.

    They are those of the whole window, or of its last half or quarter if the motion was different before; of
    shorter parts, too, if only these have all frames.

    Args:
        plot: the plot.
        span: the window.
        none: what to say if nothing oscillates.
    """
    rows = plot.window(span)
    parts = list(_parts(rows[:, 0], plot.complete_since))
    lines = []
    for i, quantity in enumerate(plot.quantities[: len(plot.spec.names)], start=1):
        for begin, longest in parts:
            time, values = rows[begin:, 0], rows[begin:, i]
            found = None if np.isnan(values).any() else swings(time, values)
            if found is not None and longest <= found.period / _PER_PERIOD:
                amplitude = f"{readouts.grouped(found.amplitude)} {quantity.unit}".strip()
                name, period = html.escape(called(plot, quantity)), number(found.period, 4)
                amplitude = html.escape(amplitude)
                if found.decrement is None:
                    lines.append(say("measure-swing", quantity=name, period=period, amplitude=amplitude))
                    break
                lines.append(
                    say(
                        "measure-swing.loses",
                        quantity=name,
                        period=period,
                        amplitude=amplitude,
                        percent=number(100.0 * found.loss, 2),
                    )
                )
                break
    if not lines and none:
        lines = [say(none)]
    return f'<div class="softrod-text softrod-reading">{"<br>".join(lines)}</div>'


def _parts(time: NDArray[np.float64], complete_since: float) -> Iterator[tuple[int, float]]:
    """Yield the first row of each part of a window to read, with the longest interval of thinned rows."""
    if not time.size:
        return
    begin, part = 0, 1.0
    while True:
        thinned = int(np.searchsorted(time, complete_since))
        yield begin, float(np.diff(time[begin : thinned + 1]).max(initial=0.0))
        if part <= 0.25 and begin >= thinned:
            return
        part *= 0.5
        begin = int(np.searchsorted(time, time[-1] - part * (time[-1] - time[0])))
