"""The figure of a fit: each column as it was measured and as the scene has it, and what is left."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from sim.design.fit import Fit

from ..reporting.figures import BLUE, GREY, ORANGE, new_figure, tidy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLUMNS = 4
"""Pictures at most; the scene has everything."""


def plot(found: Fit) -> Figure:
    """For each column two pictures: the measured points with the fitted line, and below what is left."""
    shown = found.series[:COLUMNS]
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
    if len(found.series) > COLUMNS:
        figure.suptitle(f"the first {COLUMNS} of {len(found.series)} columns", fontsize=9)
    return figure
