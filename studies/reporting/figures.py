"""How figures look: Okabe and Ito's colours, which the colour-blind can tell apart, and few lines around."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BLUE = "#0072b2"
ORANGE = "#d55e00"
GREEN = "#009e73"
PURPLE = "#cc79a7"
SKY = "#56b4e9"
YELLOW = "#e69f00"
BROWN = "#a05a2c"
BLACK = "#000000"
GREY = "#777777"

WIDE_RANGE = 30.0
"""Largest over smallest number from which on a scale is logarithmic."""


def new_figure(
    width: float, height: float, columns: int = 1, rows: int = 1, **options: Any
) -> tuple[Figure, Any]:
    """Return a figure that belongs to no window, and its axes."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure((width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.subplots(rows, columns, **options)


def tidy(axes: Axes) -> None:
    """Leave only two sides of the frame, and a faint grid."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(True, color="#e4e4e4", linewidth=0.6)
    axes.set_axisbelow(True)


def shared_legend(
    figure: Figure, panels: Iterable[Axes], order: Iterable[str], columns: int | None = None
) -> None:
    """Put one legend below all panels.

    Args:
        figure: the figure.
        panels: its axes.
        order: of the labels; lines with other labels are left out.
        columns: at most; as many as fit unless given.
    """
    handles: dict[str, Any] = {str(line.get_label()): line for axes in panels for line in axes.get_lines()}
    names = [name for name in order if name in handles]
    columns = columns or int(figure.get_figwidth() / 1.5)
    figure.legend(
        [handles[name] for name in names],
        names,
        loc="outside lower center",
        ncols=min(columns, len(names)),
        frameon=False,
        fontsize=8.5,
    )


def is_wide(numbers: Any) -> bool:
    """Whether finite numbers are best shown on a logarithmic scale."""
    return len(numbers) > 0 and min(numbers) > 0.0 and max(numbers) > WIDE_RANGE * min(numbers)
