"""A plot of the page as a picture for a report: on white, with its axes, units and lines named."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..session.plots import Plot, PlotWindow
from ..stage.colors import palette
from ..words import joined, say

SIZE = 7.0, 4.2
"""Width and height, inches."""

DPI = 200

FIT_POINTS = 1000
"""Points of a fitted curve."""

Floats = NDArray[np.float64]


def plot_png(
    plot: Plot,
    drawn: PlotWindow,
    colors: Sequence[str],
    title: str,
    fits: Sequence[Callable[[Floats], Floats]] = (),
) -> bytes:
    """A plot as PNG, with all that is in its window.

    Args:
        plot: what it is of.
        drawn: its values.
        colors: of the quantities that are plotted upwards, as CSS has them.
        title: above it.
        fits: the curve over each quantity, which gives values from places along the horizontal axis.
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
    places = np.linspace(np.nanmin(across), np.nanmax(across), FIT_POINTS) if fits else across
    for quantity, fit in zip(plot.quantities, fits, strict=False):
        axes[units.index(quantity.unit)].plot(places, fit(places), color="black", linewidth=1.0)
    for axis, unit, turned in zip(axes, units, plot.turned, strict=True):
        label = joined((*(q.name for q in plot.quantities[:count] if q.unit == unit), unit))
        if turned:
            label = say("measure-axis-downwards", label=label)
        axis.set_ylabel(label, parse_math=False)  # a $ is a $
        if turned:
            axis.invert_yaxis()
    last = plot.quantities[-1]
    over = joined((last.name, last.unit))
    left.set_xlabel(over if plot.spec.over else say("measure-axis-time"), parse_math=False)
    left.set_title(title, parse_math=False)
    left.grid(color=palette("softrod", dark=False).css("line"), linewidth=0.8)
    left.set_axisbelow(True)
    if count > 1:
        left.legend(lines, [line.get_label() for line in lines], frameon=False)
    return _png(figure)


def spectrum_png(
    plot: Plot,
    frequencies: Floats,
    amplitudes: Floats,
    peaks: Sequence[tuple[float, float, str]],
    colors: Sequence[str],
    title: str,
) -> bytes:
    """The amplitude spectra of a plot as PNG.

    Args:
        plot: what they are of.
        frequencies: (k,) Hz.
        amplitudes: (quantities, k) in the units of the quantities.
        peaks: frequency, Hz, height and label of each.
        colors: of the quantities, as CSS has them.
        title: above it.
    """
    figure = Figure(figsize=SIZE, dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    axis = figure.add_subplot()
    for quantity, values, color in zip(plot.quantities, amplitudes, colors, strict=False):
        label = joined((quantity.name, quantity.unit))
        axis.plot(frequencies, values, color=color, label=label, linewidth=1.4)
    for frequency, height, label in peaks:
        axis.annotate(label, (frequency, height), (0, 3), textcoords="offset points", ha="center", fontsize=9)
    axis.set_xlabel(say("measure-axis-frequency"))
    axis.set_ylabel(say("measure-number-amplitude"))
    axis.set_ylim(bottom=0.0)
    axis.set_title(title, parse_math=False)
    axis.grid(color=palette("softrod", dark=False).css("line"), linewidth=0.8)
    axis.set_axisbelow(True)
    axis.legend(frameon=False)
    return _png(figure)


def _png(figure: Figure) -> bytes:
    data = io.BytesIO()
    figure.savefig(data, format="png", metadata={"Software": None})
    return data.getvalue()
