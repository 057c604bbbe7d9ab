"""The plot of a sweep: each measure over the first setting that is varied."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from ..reporting.figures import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    SKY,
    YELLOW,
    is_wide,
    new_figure,
    tidy,
)
from .grid import Axis, Grid
from .measures import GAVE_UP
from .runs import Row
from .table import heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = (BLUE, ORANGE, GREEN, PURPLE, SKY, BLACK, YELLOW, GREY)
"""One for each line; with more lines than these, a panel has a map instead."""

MAX_COLUMNS = 6
"""Panels side by side; the table has everything."""

Values = np.ndarray
"""A measure on the grid, NaN where there is none."""


def plot(grid: Grid, measures: tuple[str, ...], rows: dict[int, Row]) -> Figure:
    """Draw a row of panels for each measure, with a column for each combination of values of the third and
    further axes. A panel has a line for each value of the second axis, or a map where there are too many.

    Args:
        grid: what was varied.
        measures: names, in the order of the rows' values; `survived` is drawn only where nothing else is.
        rows: by the number of the run.
    """
    shown = [name for name in measures if name != "survived"] or ["survived"]
    first, second, rest = grid.axes[0], grid.axes[1:2], grid.axes[2:]
    combinations = list(itertools.product(*(range(len(axis.values)) for axis in rest)))
    columns = min(len(combinations), MAX_COLUMNS)
    figure, pictures = new_figure(
        4.2 * columns + 1.6, 3.2 * len(shown) + 0.3, columns, len(shown), squeeze=False
    )
    for line, name in zip(pictures, shown, strict=True):
        values = _values(grid, rows, measures.index(name))
        for axes, combination in zip(line, combinations, strict=False):
            part = values[(slice(None),) * min(2, len(grid.axes)) + combination]
            if second and len(second[0].values) > len(COLOURS) and second[0].numbers is not None:
                _map(axes, grid, first, second[0], part, heading(grid, name))
            else:
                _lines(axes, grid, first, second, part)
                axes.set_ylabel(heading(grid, name), parse_math=False)
            if rest:
                fixed = (f"{a.key} = {a.values[i]}" for a, i in zip(rest, combination, strict=True))
                axes.set_title(", ".join(fixed), fontsize=9)
    if len(combinations) > columns:
        figure.suptitle(f"the first {columns} of {len(combinations)} combinations", fontsize=9)
    return figure


def _values(grid: Grid, rows: dict[int, Row], column: int) -> Values:
    """A measure on the grid, of as many dimensions as it has axes."""
    shape = [len(axis.values) for axis in grid.axes]
    flat = np.full(int(np.prod(shape)), np.nan)
    for number, row in rows.items():
        value = row.values[column]
        flat[number] = np.nan if value is None else 0.0 if value == GAVE_UP else float(value)
    return flat.reshape(shape)


def _lines(axes: Axes, grid: Grid, first: Axis, second: tuple[Axis, ...], values: Values) -> None:
    places = _scale(axes, "x", first)
    labels = [f"{axis.key} = {value}" for axis in second for value in axis.values] or [""]
    order = np.argsort(places)
    for i, (label, line) in enumerate(zip(labels, values.reshape(len(places), -1).T, strict=True)):
        style = {"marker": "o", "ms": 3.5, "lw": 1.2, "color": COLOURS[i % len(COLOURS)]}
        style["ls"] = "-" if i < len(COLOURS) else "--"
        axes.plot(np.array(places)[order], line[order], label=label, **style)
    good = values[np.isfinite(values)]
    if is_wide(good):
        axes.set_yscale("log")
    axes.set_xlabel(heading(grid, first.key), parse_math=False)
    if second:
        axes.legend(frameon=False, fontsize=8)
    tidy(axes)


def _map(axes: Axes, grid: Grid, first: Axis, second: Axis, values: Values, label: str) -> None:
    from matplotlib.colors import LogNorm

    x, y = _scale(axes, "x", first), _scale(axes, "y", second)
    good = values[np.isfinite(values)]
    across, up = np.argsort(x), np.argsort(y)
    shown = np.ma.masked_invalid(values.T[np.ix_(up, across)])
    mesh = axes.pcolormesh(
        np.array(x)[across],
        np.array(y)[up],
        shown,
        shading="nearest",
        norm=LogNorm() if is_wide(good) else None,
    )
    axes.figure.colorbar(mesh, ax=axes, label=label)
    axes.set_xlabel(heading(grid, first.key), parse_math=False)
    axes.set_ylabel(heading(grid, second.key))


def _scale(axes: Axes, letter: str, axis: Axis) -> list[float]:
    """Where the values of an axis are along x or y: numbers where they are, names at equal distances."""
    numbers = axis.numbers
    if numbers is None:
        places = [float(i) for i in range(len(axis.values))]
        axes.set(**{f"{letter}ticks": places, f"{letter}ticklabels": axis.values})
        return places
    if axis.logarithmic or is_wide(numbers):
        axes.set(**{f"{letter}scale": "log"})
    return numbers
