"""How plots are drawn in the page: lines, axes and colours, and what is read off them."""

from __future__ import annotations

import html
from collections.abc import Sequence

import numpy as np
import viser
from viser import uplot

import sim
from sim.analysis.swings import swings

from ..session.plots import Curve, Plot
from . import readouts
from .colors import Palette
from .phase import phase_svg

_COLORS = ("driven", "pulled", "torque_plus", "torque_minus", "held")
_OF = {"joint": "torque_plus", "spring": "pulled", "mass": "driven", "ghost": "held"}
"""The colours that things have on the canvas; a second one in a plot gets the next that is free."""

_FONT = "12px system-ui, sans-serif"


def draw_over_time(
    chart: viser.GuiUplotHandle,
    plot: Plot,
    drawn: Curve,
    series: Sequence[str],
    colors: Palette,
    before: tuple[object, ...],
) -> tuple[object, ...]:
    """Set the data of a plot over time; and its lines and axes, if these are others than before.

    Args:
        chart: where.
        plot, drawn: what.
        series: colours of its lines, as CSS has them.
        colors: of everything else.
        before: what this returned the last time.
    """
    time, values = drawn.time, drawn.values
    is_back = drawn.past < len(time)
    data: tuple[np.ndarray, ...] = (time, *values)
    if is_back:
        after = np.arange(len(time)) >= drawn.past
        data = (time, *np.where(after, np.nan, values), *np.where(np.roll(after, -1) | after, values, np.nan))
    if len(time) == 1:  # a range of no length has no marks
        data = tuple(np.append(column, column + (0.1 if i == 0 else 0.0)) for i, column in enumerate(data))
    looks = plot.wish, tuple(series), colors.css("text"), is_back, plot.units
    chart.data = data
    if looks != before:
        chart.series = _lines(plot, series, is_back)
        chart.scales = {"x": {"time": False}, **{f"y{i}": {} for i in range(len(plot.units))}}
        chart.axes = _axes(plot, colors)
        chart.cursor = {"drag": {"x": True, "y": False}}
    return looks


def draw_over_another(plot: Plot, drawn: Curve, series: Sequence[str]) -> str:
    """A plot over another quantity than the time, as HTML."""
    count = len(plot.wish.names)
    labels = _labelled(plot.quantities[-1:]), _labelled(plot.quantities[:count])
    name = f"{', '.join(plot.wish.names)} over {plot.wish.over}"
    return phase_svg(drawn.values[count], drawn.values[:count], drawn.past, series, labels, name)


def _lines(plot: Plot, series: Sequence[str], is_back: bool) -> tuple[uplot.Series, ...]:
    lines: list[uplot.Series] = [{"label": "time, s"}]
    for part in ("now", "ahead") if is_back else ("now",):
        for quantity, color in zip(plot.quantities, series, strict=True):
            line: uplot.Series = {
                "label": f"{quantity.name}, {quantity.unit}" if quantity.unit else quantity.name,
                "stroke": color,
                "width": 2.0,
                "scale": f"y{plot.units.index(quantity.unit)}",
                "points": {"show": False},
            }
            if part == "ahead":
                line |= {"alpha": 0.25, "label": f"{quantity.name}, ahead", "class": "softrod-ahead"}
            lines.append(line)
    return tuple(lines)


def _axes(plot: Plot, colors: Palette) -> tuple[uplot.Axis, ...]:
    text, grid = colors.css("text"), colors.css("grid_major")
    common: uplot.Axis = {
        "stroke": text,
        "font": _FONT,
        "labelFont": _FONT,
        "grid": {"stroke": grid, "width": 1.0},
        "ticks": {"stroke": grid, "width": 1.0, "size": 4.0},
    }
    axes: list[uplot.Axis] = [{**common, "scale": "x", "label": "time, s", "labelSize": 18.0, "size": 26.0}]
    for i, unit in enumerate(plot.units):
        names = ", ".join(dict.fromkeys(q.kind.what for q in plot.quantities if q.unit == unit))
        axis: uplot.Axis = {
            **common,
            "scale": f"y{i}",
            "side": 1 if i else 3,
            "label": f"{names}, {unit}" if unit else names,
            "labelSize": 18.0,
            "size": 56.0,
        }
        if i:
            axis["grid"] = {"show": False}
        axes.append(axis)
    return tuple(axes)


def colors_of(plot: Plot, colors: Palette) -> list[str]:
    """The colour of each quantity that is plotted upwards."""
    taken: list[str] = []
    for quantity in plot.quantities[: len(plot.wish.names)]:
        first = _OF.get(quantity.kind.of, _COLORS[0])
        taken.append(next(name for name in (first, *_COLORS) if name not in taken))
    return [colors.css(name) for name in taken]


def _labelled(quantities: Sequence[sim.Quantity]) -> str:
    """The label of an axis for some quantities."""
    names = ", ".join(dict.fromkeys(q.kind.what if len(quantities) > 1 else q.name for q in quantities))
    units = ", ".join(dict.fromkeys(q.unit for q in quantities if q.unit))
    return f"{names}, {units}" if units else names


def title(plot: Plot, series: Sequence[str]) -> str:
    """The names of what is plotted, with their colours."""
    keys = (
        f'<i style="background:{color}"></i>{html.escape(name)}'
        for name, color in zip(plot.wish.names, series, strict=True)
    )
    over = f" over {html.escape(plot.wish.over)}" if plot.wish.over else ""
    return f'<div class="softrod-plot-title">{" ".join(keys)}{over}</div>'


def reading(plot: Plot, seconds: float) -> str:
    """Period, amplitude and damping of each quantity, as far as it swings: of all that is in view, or of its
    last part, where something else went before."""
    rows = plot.window(seconds)
    rows = rows[rows[:, 0] <= plot.shown]
    lines = []
    for i, quantity in enumerate(plot.quantities[: len(plot.wish.names)], start=1):
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
    return f'<div class="softrod-text softrod-reading">{"<br>".join(lines) or "no regular swing"}</div>'
