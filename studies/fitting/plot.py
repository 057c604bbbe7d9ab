"""The figure of a fit: measured and fitted values of each column, and the residuals."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from sim.design.fit import Fit

from ..reporting.figures import BLUE, GREY, ORANGE, new_figure, tidy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_COLUMNS = 4
"""Columns of the tables that are shown."""


def plot(found: Fit) -> Figure:
    """Draw two panels for each column: measured points with the fitted line, and residuals below."""
    shown = found.series[:MAX_COLUMNS]
    figure, pictures = new_figure(
        5.0 * len(shown) + 0.6, 4.6, len(shown), 2, squeeze=False, sharex="col", height_ratios=(3.0, 1.0)
    )
    for (above, below), each in zip(pictures.T, shown, strict=True):
        above.plot(each.time, each.measured, "o", ms=3.0, color=GREY, label="measured")
        above.plot(each.time, each.fitted, lw=1.4, color=BLUE, label="fitted")
        label = f"{each.column} ({each.unit})" if each.unit else each.column
        above.set_ylabel(label, parse_math=False)
        above.set_title(f"{each.file}: {each.column} as {each.quantity}", fontsize=9, parse_math=False)
        above.legend(frameon=False, fontsize=8)
        below.axhline(0.0, color=BLUE, lw=1.0)
        below.plot(each.time, each.residuals, "o", ms=2.5, color=ORANGE)
        reach = 1.15 * float(np.nanmax(np.abs(each.residuals))) or 1.0
        below.set_ylim(-reach, reach)
        below.set_ylabel("residual")
        below.set_xlabel("time (s)")
        tidy(above)
        tidy(below)
    if len(found.series) > MAX_COLUMNS:
        figure.suptitle(f"the first {MAX_COLUMNS} of {len(found.series)} columns", fontsize=9)
    return figure
