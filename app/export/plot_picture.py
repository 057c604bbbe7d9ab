"""A plot of the page as a picture for a report: on white, with its axes, units and lines named."""

from __future__ import annotations

import io
from collections.abc import Sequence

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..session.plots import Plot, PlotWindow
from ..stage.colors import palette

SIZE = 7.0, 4.2
"""Width and height, inches."""

DPI = 200


def plot_png(plot: Plot, drawn: PlotWindow, colors: Sequence[str], title: str) -> bytes:
    """A plot as PNG, with all that is in its window.

    Args:
        plot: what it is of.
        drawn: its values.
        colors: of the quantities that are plotted upwards, as CSS has them.
        title: above it.
    """
    count, units = len(plot.spec.names), plot.units
    figure = Figure(figsize=SIZE, dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    left = figure.add_subplot()
    axes = [left] if len(units) < 2 else [left, left.twinx()]
    across = drawn.values[1 + count] if plot.spec.over else drawn.values[0]
    lines = []
    for quantity, values, color in zip(plot.quantities, drawn.values[1:], colors, strict=False):
        axis = axes[units.index(quantity.unit)]
        lines += axis.plot(across, values, color=color, label=quantity.name, linewidth=1.4)
    for axis, unit, turned in zip(axes, units, plot.turned, strict=True):
        names = ", ".join(q.name for q in plot.quantities[:count] if q.unit == unit)
        label = f"{names}, {unit}" if unit else names
        axis.set_ylabel(f"{label}, downwards" if turned else label, parse_math=False)  # a $ is a $
        if turned:
            axis.invert_yaxis()
    last = plot.quantities[-1]
    over = f"{last.name}, {last.unit}" if last.unit else last.name
    left.set_xlabel(over if plot.spec.over else "time, s", parse_math=False)
    left.set_title(title, parse_math=False)
    left.grid(color=palette("softrod", dark=False).css("line"), linewidth=0.8)
    left.set_axisbelow(True)
    if count > 1:
        left.legend(lines, [line.get_label() for line in lines], frameon=False)
    data = io.BytesIO()
    figure.savefig(data, format="png", metadata={"Software": None})
    return data.getvalue()
