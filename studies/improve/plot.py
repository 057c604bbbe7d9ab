"""The figure of a search: results of its runs, the best so far, and the settings of each run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..reporting.figures import BLACK, BLUE, GREY, ORANGE, SKY, is_wide, new_figure, tidy
from .ranges import Range

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MAX_SETTINGS = 8
"""Settings that are drawn; the table has all."""

SHOWN = 0.8
"""Part of the runs, from the best on, that fit into the panel: a few can be far off."""


def plot(
    result: str,
    results: Sequence[float | None],
    scores: Sequence[float | None],
    settings: Sequence[tuple[str, Range, Sequence[float]]],
    best: int | None,
) -> Figure:
    """Draw results and settings over the number of the run.

    Args:
        result: its name and unit.
        results: of each run; None where there is none.
        scores: of each run, the less the better; None for what counts as worst.
        settings: name and unit of each, its range, and its value in each run.
        best: number of the best run, or None.
    """
    from matplotlib.ticker import NullFormatter

    shown = settings[:MAX_SETTINGS]
    figure, pictures = new_figure(
        7.5, 2.9 + 1.35 * len(shown), 1, 1 + len(shown), sharex=True, squeeze=False,
        height_ratios=[2.4, *(1.0 for _ in shown)],
    )  # fmt: skip
    top, *others = (line[0] for line in pictures)
    _results(top, result, results, scores, best)
    failed = [n for n, score in enumerate(scores) if score is None]
    fine = [n for n, score in enumerate(scores) if score is not None]
    for axes, (name, ends, values) in zip(others, shown, strict=True):
        axes.plot(failed, [values[n] for n in failed], "x", ms=3.5, color=GREY)
        axes.plot(fine, [values[n] for n in fine], "o", ms=2.5, color=SKY)
        if best is not None:
            axes.plot(best, values[best], "o", ms=6, mfc="none", mew=1.6, color=ORANGE, clip_on=False)
            axes.axhline(values[best], lw=0.7, color=ORANGE)
        if ends.logarithmic:
            axes.set_yscale("log")
            axes.yaxis.set_minor_formatter(NullFormatter())
        axes.set_ylim(ends.low, ends.high)
        axes.set_title(name, parse_math=False, fontsize=8, loc="left")
        tidy(axes)
    (others or [top])[-1].set_xlabel("run")
    return figure


def _results(
    axes: Axes,
    name: str,
    results: Sequence[float | None],
    scores: Sequence[float | None],
    best: int | None,
) -> None:
    values = np.array([math.nan if value is None else value for value in results])
    axes.plot(values, "o", ms=3, color=SKY, label="a run")
    failed = [n for n, score in enumerate(scores) if score is None]
    if failed:
        low = np.full(len(failed), 0.02)
        axes.plot(
            failed, low, "x", ms=4, color=GREY, transform=axes.get_xaxis_transform(), label="counts as worst"
        )
    until, line = math.inf, np.full(len(values), math.nan)
    for n, score in enumerate(scores):
        if score is not None and score < until and not math.isnan(values[n]):
            until, line[n] = score, values[n]
        elif n:
            line[n] = line[n - 1]
    axes.plot(line, drawstyle="steps-post", lw=1.6, color=BLUE, label="the best so far")
    if scores and scores[0] is not None and not math.isnan(values[0]):
        axes.plot(0, values[0], "s", ms=5, color=BLACK, label="the scene as it is")
    if best is not None and not math.isnan(values[best]):
        axes.plot(best, values[best], "o", ms=8, mfc="none", mew=1.8, color=ORANGE, label="the best")
    order = sorted((score, n) for n, score in enumerate(scores) if score is not None)
    near = values[[n for _, n in order[: max(1, math.ceil(SHOWN * len(order)))]]] if order else values[:0]
    near = near[np.isfinite(near)]
    if near.size and np.ptp(near) > 0.0:
        if is_wide(near):
            axes.set_yscale("log")
            axes.set_ylim(near.min() / 1.3, near.max() * 1.3)
        else:
            margin = 0.08 * float(np.ptp(near))
            axes.set_ylim(near.min() - margin, near.max() + margin)
    axes.set_title(name, parse_math=False, fontsize=9, loc="left")
    axes.legend(frameon=False, fontsize=8, ncols=5, loc="lower left", bbox_to_anchor=(-0.02, 1.07))
    tidy(axes)
