"""The figures of `softrod study`: softrod's methods have full lines, other solvers broken ones."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from sim.methods.registry import METHODS

from ..reporting.figures import BLACK, BLUE, GREY, ORANGE, new_figure, tidy
from ..reporting.output import Drawing
from .measure import FOLLOWED, Point, SceneResults, label
from .random_study import CHAOTIC, TOLERANCE
from .report import COARSE, Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STAR = "#e69f00"

STYLES: dict[str, tuple[str, str]] = {
    **{name: method.look for name, method in METHODS.items()},
    "scipy_rk45": (GREY, "<"),
    "scipy_dop853": (GREY, ">"),
    "scipy_radau": (GREY, "p"),
    "scipy_bdf": (GREY, "o"),
    "scipy_lsoda": (GREY, "s"),
    "cvode_bdf": ("#a05a2c", "o"),
    "cvode_adams": ("#a05a2c", "s"),
}
"""Colour and marker of each method."""

FLOOR = 1e-8
"""Errors that are drawn at least, px."""


def figures(study: Study) -> dict[str, Drawing]:
    """The figures by name, of what there are results of."""
    drawn: dict[str, Drawing] = {}
    if any(results.points for results in study.scenes):
        drawn["work-precision"] = (
            "Milliseconds of computing for a simulated second over the largest position error at the end, "
            "px; for each method the settings that none of its others beats. Full lines: softrod; broken: "
            f"SciPy and CVODE. The star is auto at a tolerance of {COARSE:g} px in one call, the open star "
            "in 60 calls.",
            lambda: work_precision(study),
        )
    if any(not body.left_out for body in study.bodies):
        drawn["bodies"] = (
            f"Random bodies: the share that ends within so many tolerances (auto at {TOLERANCE:g} px), and "
            "the error over how much the body amplifies a nudge of its start.",
            lambda: bodies(study),
        )
    return drawn


def front(points: list[Point]) -> list[Point]:
    """The settings that no other one beats in both error and time, by error from large to small."""
    kept: list[Point] = []
    for point in sorted(points, key=lambda p: (p.seconds, p.end_error)):
        if math.isfinite(point.end_error) and (not kept or point.end_error < kept[-1].end_error):
            kept.append(point)
    return kept


def work_precision(study: Study) -> Figure:
    """Small multiples: one for each scene."""
    shown = [results for results in study.scenes if results.points]
    columns = min(4, len(shown))
    rows = -(-len(shown) // columns)
    figure, grid = new_figure(
        3.3 * columns + 0.5,
        3.1 * rows + 6.0 / (columns + 1.0),
        columns,
        rows,
        sharex=True,
        sharey=True,
        squeeze=False,
    )
    low, high = FLOOR, 10.0 * max(study.errors)
    for axes, results in zip(grid.flat, shown, strict=False):
        _scene(axes, results, low, high)
    for axes in grid.flat[len(shown) :]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel("computing time, ms")
    for axes in grid[-1]:
        axes.set_xlabel("error at the end, px")
    handles: dict[str, Any] = {}
    for axes in grid.flat:
        handles |= {line.get_label(): line for line in axes.get_lines() if line.get_label()[0] != "_"}
    order = [label(name) for name in STYLES if label(name) in handles]
    figure.legend(
        [handles[name] for name in order],
        order,
        loc="outside lower center",
        ncols=min(6, 2 * columns, len(order)),
        frameon=False,
        fontsize=8.5,
    )
    return figure


def _scene(axes: Axes, results: SceneResults, low: float, high: float) -> None:
    for name, (color, marker) in STYLES.items():
        points = [
            p for p in front([p for p in results.points if p.integrator == name]) if p.end_error <= high
        ]
        if not points:
            continue
        ours = not name.startswith(("scipy_", "cvode_"))
        axes.loglog(
            [max(p.end_error, low) for p in points],
            [1e3 * p.seconds for p in points],
            color=color,
            marker=marker,
            ms=4.0,
            mfc=color if ours else "white",
            mew=0.9,
            lw=2.2 if name == FOLLOWED else 1.1,
            ls="-" if ours else (0, (4, 2)),
            zorder=4 if name == FOLLOWED else 3 if ours else 2,
            label=label(name),
        )
    auto = results.at(FOLLOWED, COARSE)
    if auto is not None and math.isfinite(auto.end_error):
        star = {"marker": "*", "ms": 14.0, "mec": BLACK, "zorder": 5}
        axes.plot(auto.end_error, 1e3 * auto.seconds, mfc=STAR, **star)
        if math.isfinite(auto.framed_end_error):
            axes.plot(auto.framed_end_error, 1e3 * auto.framed_seconds, mfc="white", **star)
    axes.set_title(results.scene, fontsize=10.5, parse_math=False)
    axes.set_xlim(2.0 * high, low / 2.0)
    axes.xaxis.set_major_locator(_decades(2))
    tidy(axes)


def _decades(step: int) -> Any:
    from matplotlib.ticker import LogLocator

    return LogLocator(10.0**step, numticks=20)


def bodies(study: Study) -> Figure:
    """How the errors on random bodies are spread, and what they go with."""
    figure, (left, right) = new_figure(9.8, 4.2, columns=2)
    counted = [body for body in study.bodies if not body.left_out]
    floor = 1e-3
    for what, framed, color, style in (("one call", False, BLUE, "-"), ("60 calls", True, ORANGE, "--")):
        errors = [(b.framed_error if framed else b.error) / TOLERANCE for b in counted]
        sorted_errors = np.maximum(np.sort(errors), floor)
        share = 100.0 * np.arange(1, len(errors) + 1) / len(errors)
        left.step(sorted_errors, share, where="post", color=color, ls=style, lw=1.6, label=f"auto, {what}")
    left.set_xscale("log")
    left.set_xlabel("error at the end, tolerances")
    left.set_ylabel("bodies with no larger error, %")
    left.legend(frameon=False, loc="upper left")
    growth = [max(body.growth, 1e-2) for body in counted]
    right.loglog(
        growth, [max(body.error / TOLERANCE, floor) for body in counted], "o", color=BLUE, ms=4.0, mfc="none"
    )
    right.set_xlabel(f"growth of a nudge of the start (left out above {CHAOTIC:g})")
    right.set_ylabel("error at the end, tolerances")
    for axes, line in ((left, left.axvline), (right, right.axhline)):
        line(1.0, color=GREY, lw=1.0)
        line(10.0, color=GREY, lw=1.0, ls=":")
        tidy(axes)
    return figure
