"""How plots are drawn in the page: lines, axes and colours, and what is read off them."""

from __future__ import annotations

import html
from collections.abc import Sequence

import numpy as np
import viser
from numpy.typing import NDArray
from viser import uplot

import sim
from sim.analysis.swings import swings

from ..drawing.colors import Palette
from ..session.plots import Plot
from . import readouts
from .phase import phase_svg

_COLORS = ("driven", "pulled", "torque_plus", "torque_minus", "held")
_OF = {"joint": "torque_plus", "spring": "pulled", "mass": "driven", "ghost": "held"}
"""The colours that things have on the canvas; a second one in a plot gets the next that is free."""

_FONT = "12px system-ui, sans-serif"


def draw_over_time(
    chart: viser.GuiUplotHandle,
    plot: Plot,
    drawn: NDArray[np.float64],
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
    # uPlot takes a number for the first value of every line that it goes by in finding its range.
    some: NDArray[np.bool_] = np.asarray(np.isfinite(drawn).any(1))
    drawn = drawn[:, int(np.isfinite(drawn[some]).all(0).argmax()) :]
    if drawn.shape[1] == 1:  # a range of no length has no marks
        drawn = np.column_stack((drawn, drawn))
        drawn[0, 1] += 0.1
    looks = plot.wish, tuple(series), colors.css("text"), tuple(some.tolist()), plot.units
    chart.data = tuple(drawn)
    if looks != before:
        chart.series = _lines(plot, series, some)
        chart.scales = {"x": {"time": False}, **{f"y{i}": {} for i in range(len(plot.units))}}
        chart.axes = _axes(plot, colors)
        chart.cursor = {"drag": {"x": True, "y": False}}
    return looks


def draw_over_another(plot: Plot, drawn: NDArray[np.float64], series: Sequence[str]) -> str:
    """A plot over another quantity than the time, as HTML."""
    count = len(plot.wish.names)
    labels = _labelled(plot.quantities[-1:]), _labelled(plot.quantities[:count])
    name = f"{', '.join(plot.wish.names)} over {plot.wish.over}"
    return phase_svg(drawn[1 + count], drawn[1 : 1 + count], series, labels, name)


def _lines(plot: Plot, series: Sequence[str], some: NDArray[np.bool_]) -> tuple[uplot.Series, ...]:
    lines: list[uplot.Series] = [{"label": "time, s"}]
    for quantity, color, has_values in zip(plot.quantities, series, some[1:], strict=True):
        lines.append(
            {
                "label": f"{quantity.name}, {quantity.unit}" if quantity.unit else quantity.name,
                "stroke": color,
                "width": 2.0,
                "scale": f"y{plot.units.index(quantity.unit)}",
                "auto": bool(has_values),
                "points": {"show": False},
            }
        )
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
            "size": 76.0 if unit.startswith("kg") else 50.0,  # forces and energies have many digits
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
