"""The maps of `softrod stability`: a panel for each integrator, in colours for the colour-blind."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from sim.solve.registry import METHODS

from ..reporting.figures import BLACK, GREY, ORANGE, new_figure
from .axes import Axis
from .map import ACCURATE, DAMPED_WRONGLY, ENDINGS, NEAR, NO_REFERENCE, UNKNOWN, UNSTABLE, Map

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLORS = {
    UNKNOWN: "#ffffff",
    ACCURATE: "#8cc5e8",
    DAMPED_WRONGLY: "#f0e442",
    UNSTABLE: ORANGE,
    NO_REFERENCE: "#bbbbbb",
}
"""Light blue, yellow and vermilion also differ in lightness."""

_MEANINGS = {
    ACCURATE: f"within {100.0 * NEAR:g} % of the body's extent",
    DAMPED_WRONGLY: "bounded, but amplitude or phase is off",
    UNSTABLE: "runs away, or makes more energy\nthan was put in",
    NO_REFERENCE: "bounded; there is nothing to compare with",
    UNKNOWN: "not computed",
}


def draw(chart: Map, scene: str) -> Figure:
    """Draw the panels of a map."""
    methods = list(chart.endings)
    columns = min(3, len(methods) + 1)
    rows = -(-(len(methods) + 1) // columns)
    figure, panels = new_figure(3.3 * columns, 3.1 * rows, columns, rows, squeeze=False)
    flat = panels.ravel()
    for i, (panel, method) in enumerate(zip(flat, methods, strict=False)):
        _panel(panel, chart, method)
        if i >= len(methods) - columns:
            panel.set_xlabel(_named(chart.x))
        if i % columns == 0:
            panel.set_ylabel(_named(chart.y))
    for panel in flat[len(methods) :]:
        panel.set_axis_off()
    _legend(flat[len(methods)], chart)
    figure.suptitle(f"{scene}: where it breaks", x=0.01, ha="left", fontsize=12, parse_math=False)
    return figure


def _named(axis: Axis) -> str:
    return f"{axis.label}, {axis.unit}" if axis.unit else axis.label


def _panel(axes: Axes, chart: Map, method: str) -> None:
    from matplotlib.colors import BoundaryNorm, ListedColormap

    order = sorted(COLORS)
    colors = ListedColormap([COLORS[ending] for ending in order])
    norm = BoundaryNorm([*(ending - 0.5 for ending in order), order[-1] + 0.5], len(order))
    edges = _edges(chart.xs), _edges(chart.ys)
    axes.pcolormesh(*edges, chart.endings[method], cmap=colors, norm=norm, rasterized=True)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(METHODS[method].label, fontsize=10, loc="left")
    axes.tick_params(labelsize=8)
    limits = chart.limits[method]
    lines: dict[str, Any] = {"solid_capstyle": "round"}
    axes.minorticks_off()
    if not _drawn(chart, method):
        words = "limit is not on this map" if np.isfinite(limits).any() else "no limit in linear theory"
        axes.text(
            0.04, 0.04, words, transform=axes.transAxes, fontsize=8,
            bbox={"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 1.5},
        )  # fmt: skip
    elif "dt" in (chart.x.key, chart.y.key):
        along_y = chart.x.key == "dt"
        steps = limits[:, 0] if along_y else limits[0]
        line = (steps, chart.ys) if along_y else (chart.xs, steps)
        for color, width in (("white", 3.4), (BLACK, 1.6)):
            axes.plot(*line, color=color, lw=width, **lines)
    else:
        for color, width in (("white", 3.4), (BLACK, 1.6)):
            axes.contour(
                chart.xs, chart.ys, np.log(chart.dt / limits), levels=[0.0], colors=color, linewidths=width
            )
    axes.set_xlim(edges[0][0], edges[0][-1])
    axes.set_ylim(edges[1][0], edges[1][-1])


def _drawn(chart: Map, method: str) -> bool:
    """Whether the analytic limit is anywhere on the map."""
    ratio = chart.steps() / chart.limits[method]
    return bool((ratio > 0.0).all() and ratio.max() > 1.0 and ratio.min() < 1.0)


def _edges(values: np.ndarray) -> np.ndarray:
    """Return the borders of the cells around values, on a logarithmic axis."""
    logs = np.log(values)
    if len(logs) == 1:
        return np.exp([logs[0] - 0.1, logs[0] + 0.1])
    middles = 0.5 * (logs[1:] + logs[:-1])
    return np.exp([2.0 * logs[0] - middles[0], *middles, 2.0 * logs[-1] - middles[-1]])


def _legend(axes: Axes, chart: Map) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    found = {int(ending) for endings in chart.endings.values() for ending in np.unique(endings)}
    entries: list[Any] = [
        Patch(facecolor=COLORS[k], edgecolor=GREY, label=f"{ENDINGS[k]}\n{_MEANINGS[k]}".strip())
        for k in (ACCURATE, DAMPED_WRONGLY, UNSTABLE, NO_REFERENCE, UNKNOWN)
        if k in found or k in (ACCURATE, DAMPED_WRONGLY, UNSTABLE)
    ]
    entries.append(Line2D([], [], color=BLACK, lw=1.6, label="analytic limit of the step"))
    axes.legend(
        handles=entries, loc="center left", frameon=False, fontsize=8.5, labelspacing=1.1, borderaxespad=0.0
    )
    if math.isfinite(chart.dt) and "dt" not in (chart.x.key, chart.y.key):
        axes.set_title(f"time step {1e3 * chart.dt:g} ms", fontsize=10, loc="left")
