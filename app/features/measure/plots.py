"""How plots are drawn in the page: lines, axes and colours, and what is read off them."""

from __future__ import annotations

import html
from collections.abc import Callable, Sequence

import numpy as np
import viser
from numpy.typing import NDArray
from viser import uplot

import sim
from sim.analysis.swings import swings

from ...session.plots import Plot, PlotWindow
from ...stage.colors import Palette
from ...ui import readouts
from .phase import phase_svg

_COLORS = ("brand", "pulled", "torque_plus", "torque_minus", "held")
_OF = {"joint": "torque_plus", "spring": "pulled", "mass": "brand", "ghost": "held"}
"""The colours that things have on the canvas; a second one in a plot gets the next that is free."""

_FONT = "12px system-ui, sans-serif"

_LONGEST_LABEL = 26
"""Letters of the label of an axis for which there is room."""

PALE = 0.35
"""Opacity of what is ahead of the moment that is shown."""


def draw_over_time(
    chart: viser.GuiUplotHandle | None,
    add: Callable[..., viser.GuiUplotHandle],
    plot: Plot,
    drawn: PlotWindow,
    series: Sequence[str],
    colors: Palette,
    before: tuple[object, ...],
) -> tuple[viser.GuiUplotHandle, tuple[object, ...]]:
    """Set the data of a plot over time; and its lines and axes, if these are others than before.

    What is ahead of the moment that is shown is pale: a line ends there, and a pale one has all values.

    Args:
        chart: where; None to make it.
        add: makes it.
        plot, drawn: what.
        series: colours of its lines, as CSS has them.
        colors: of everything else.
        before: what this returned the last time.

    Returns:
        The chart, and what its lines and axes are for.
    """
    # uPlot takes a number for the first value of every line that it goes by in finding its range.
    values, past = drawn
    some: NDArray[np.bool_] = np.asarray(np.isfinite(values).any(1))
    begin = int(np.isfinite(values[some]).all(0).argmax())
    values, past = values[:, begin:], max(past - begin, 0)
    ahead = past < values.shape[1]
    if values.shape[1] == 1:  # a range of no length has no marks
        values = np.column_stack((values, values))
        values[0, 1] += 0.1
    # The line of all values is empty where the other one has all of them: they would be sent twice.
    until, whole = values, [np.zeros(0)] * len(series)
    if ahead or chart is None:  # in a new chart viser wants all lines of one length
        until, whole = values.copy(), list(values[1:])
        until[1:, past:] = np.nan
    data = *until, *whole
    looks = plot.spec, tuple(series), colors.css("text"), tuple(some.tolist()), plot.units, plot.turned
    lines, axes = _lines(plot, series, some), _axes(plot, colors)
    if chart is None:
        upwards: dict[str, uplot.Scale] = {
            f"y{i}": {"dir": -1} if turned else {} for i, turned in enumerate(plot.turned)
        }
        scales: dict[str, uplot.Scale] = {"x": {"time": False}, **upwards}
        return add(data, lines, scales=scales, axes=axes, cursor={"drag": {"x": True, "y": False}}), looks
    chart.data = data
    if looks != before:
        chart.series, chart.axes = lines, axes
    return chart, looks


def draw_over_another(plot: Plot, drawn: PlotWindow, series: Sequence[str]) -> str:
    """A plot over another quantity than the time, as HTML."""
    count, values = len(plot.spec.names), drawn.values
    turned = any(plot.turned)
    labels = _labelled(plot.quantities[-1:]), downwards(_labelled(plot.quantities[:count]), turned)
    name = f"{', '.join(plot.spec.names)} over {plot.spec.over}"
    return phase_svg(values[1 + count], values[1 : 1 + count], drawn.past, series, labels, name, turned)


def _lines(plot: Plot, series: Sequence[str], some: NDArray[np.bool_]) -> tuple[uplot.Series, ...]:
    until: list[uplot.Series] = []
    whole: list[uplot.Series] = []
    for quantity, color, has_values in zip(plot.quantities, series, some[1:], strict=True):
        line: uplot.Series = {
            "label": f"{quantity.name}, {quantity.unit}" if quantity.unit else quantity.name,
            "stroke": color,
            "width": 2.0,
            "scale": f"y{plot.units.index(quantity.unit)}",
            "auto": bool(has_values),
            "points": {"show": False},
        }
        # The legend has either this one or that, see page.css.
        until.append({**line, "class": "softrod-until"})
        whole.append({**line, "class": "softrod-whole", "alpha": PALE})
    return {"label": "time, s"}, *until, *whole


def _axes(plot: Plot, colors: Palette) -> tuple[uplot.Axis, ...]:
    text, grid = colors.css("text"), colors.css("line")
    common: uplot.Axis = {
        "stroke": text,
        "font": _FONT,
        "labelFont": _FONT,
        "grid": {"stroke": grid, "width": 1.0},
        "ticks": {"stroke": grid, "width": 1.0, "size": 4.0},
    }
    axes: list[uplot.Axis] = [
        {**common, "scale": "x", "label": "time, s", "labelSize": 18.0, "size": 26.0, "space": 36.0}
    ]
    for i, (unit, turned) in enumerate(zip(plot.units, plot.turned, strict=True)):
        label = _label([q for q in plot.quantities[: len(plot.spec.names)] if q.unit == unit], unit)
        axis: uplot.Axis = {
            **common,
            "scale": f"y{i}",
            "side": 1 if i else 3,
            "label": downwards(label, turned),
            "labelSize": 18.0,
            "size": 76.0
            if unit.startswith(("kg", "N", "J"))
            else 50.0,  # forces and energies have many digits
        }
        if i:
            axis["grid"] = {"show": False}
        axes.append(axis)
    return tuple(axes)


def colors_of(plot: Plot, colors: Palette) -> list[str]:
    """The colour of each quantity that is plotted upwards."""
    taken: list[str] = []
    for quantity in plot.quantities[: len(plot.spec.names)]:
        first = _OF.get(quantity.kind.of, _COLORS[0])
        taken.append(next(name for name in (first, *_COLORS) if name not in taken))
    return [colors.css(name) for name in taken]


def _labelled(quantities: Sequence[sim.Quantity]) -> str:
    """The label of an axis for some quantities, of one or two units."""
    units = ", ".join(dict.fromkeys(q.unit for q in quantities if q.unit))
    if len(quantities) > 1:
        return _label(quantities, units)
    return f"{quantities[0].name}, {units}" if units else quantities[0].name


def _label(quantities: Sequence[sim.Quantity], unit: str) -> str:
    """What some quantities are, with their unit; of what they are, where that would be too long."""
    for words in ((q.kind.what for q in quantities), (q.kind.of for q in quantities)):
        names = ", ".join(dict.fromkeys(words))
        label = f"{names}, {unit}" if unit else names
        if len(label) <= _LONGEST_LABEL:
            break
    return label


def downwards(label: str, turned: bool) -> str:
    """The label of an axis, which says if its values grow downwards."""
    return f"{label}, downwards" if turned else label


def title(plot: Plot, series: Sequence[str]) -> str:
    """The names of what is plotted, with their colours."""
    keys = (
        f'<span translate="no"><i style="background:{color}"></i>{html.escape(name)}</span>'
        for name, color in zip(plot.spec.names, series, strict=True)
    )
    over = f" over {html.escape(plot.spec.over)}" if plot.spec.over else ""
    return f'<div class="softrod-plot-title">{" ".join(keys)}{over}</div>'


def reading(plot: Plot, seconds: float, none: str = "no regular swing") -> str:
    """Period, amplitude and damping of each quantity, as far as it swings: of all that is in view, or of its
    last part, where something else went before.

    Args:
        plot: what it is read off.
        seconds: of the window.
        none: what is said if nothing swings.
    """
    rows = plot.window(seconds)
    lines = []
    for i, quantity in enumerate(plot.quantities[: len(plot.spec.names)], start=1):
        for begin in (0, len(rows) // 2, 3 * len(rows) // 4):
            time, values = rows[begin:, 0], rows[begin:, i]
            found = None if np.isnan(values).any() else swings(time, values)
            if found is not None:
                loss = f", loses {100.0 * found.loss:.2g} % per cycle" if found.decrement is not None else ""
                amplitude = f"{readouts.grouped(found.amplitude)} {quantity.unit}".strip()
                lines.append(
                    f"{html.escape(quantity.name)}: period <b>{found.period:.4g} s</b>, "
                    f"amplitude <b>{html.escape(amplitude)}</b>{loss}"
                )
                break
    return f'<div class="softrod-text softrod-reading">{"<br>".join(lines) or none}</div>'
