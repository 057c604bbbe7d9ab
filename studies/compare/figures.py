"""The figures of `softrod study` and `softrod bench peers`."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from sim.solve.registry import METHODS

from ..reporting import report
from ..reporting.figures import (
    BLACK,
    BLUE,
    BROWN,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    SKY,
    YELLOW,
    new_figure,
    shared_legend,
    tidy,
)
from .random_study import CHAOTIC, TOLERANCE, BodyResult
from .results import Study, label
from .runs import SOFTROD, Point, auto_at
from .scenes import HEAPS, MANY, NAMES, PATHS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STAR_ERROR = 0.1
"""Tolerance of `auto` at the star in the figure of the study, px."""

STUDY_FLOOR = 1e-8
"""The smallest error that the study's figure distinguishes, px."""

PEERS_FLOOR = 1e-4
"""The smallest error that the figures of the peers distinguish, px."""

PEERS_TOP = 300.0
"""The largest error that the figures of the peers show, px."""


@dataclass(frozen=True)
class Look:
    """How the points of one contender look.

    Attributes:
        color, marker, line: of Matplotlib.
        whole: whether all settings are shown, not only those that no other one beats.
        more: further properties of the line.
    """

    color: str
    marker: str
    line: Any = "-"
    whole: bool = False
    more: Mapping[str, Any] = field(default_factory=dict)


def _study_look(color: str, marker: str, is_own: bool, is_auto: bool) -> Look:
    width, order = (2.2, 4) if is_auto else (1.1, 3 if is_own else 2)
    more = {"mfc": color if is_own else "white", "mew": 0.9, "lw": width, "zorder": order}
    return Look(color, marker, "-" if is_own else (0, (4, 2)), more=more)


STUDY_LOOKS = {
    label(name): _study_look(*method.look, True, name == "auto") for name, method in METHODS.items()
} | {
    label(name): _study_look(color, marker, False, False)
    for name, color, marker in (
        ("scipy_rk45", GREY, "<"),
        ("scipy_dop853", GREY, ">"),
        ("scipy_radau", GREY, "p"),
        ("scipy_bdf", GREY, "o"),
        ("scipy_lsoda", GREY, "s"),
        ("cvode_bdf", BROWN, "o"),
        ("cvode_adams", BROWN, "s"),
    )
}
"""softrod's methods have full lines, other solvers broken ones."""

PEERS_LOOKS = {
    "softrod, auto": Look(BLACK, "o", whole=True),
    "softrod's best": Look(BLUE, "s"),
    "C loop": Look(GREY, "D"),
    "NumPy": Look(GREY, "p", "--"),
    "SciPy": Look(PURPLE, "^", "--"),
    "CVODE": Look(BROWN, "v", "--"),
    "JAX": Look(SKY, "X", "--"),
    "diffrax": Look(SKY, "P", ":"),
    "Box2D": Look(ORANGE, "s"),
    "Chipmunk": Look(GREEN, "^"),
    "MuJoCo": Look(YELLOW, "o", "--"),
}


def peer(point: Point) -> str:
    """Return the name of an engine in the legend; softrod's `auto` has one of its own."""
    if point.engine != SOFTROD:
        return point.engine
    return "softrod, auto" if point.label.startswith("Auto") else "softrod's best"


def front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other one beats in both error and time, from large to small errors."""
    found: list[Point] = []
    for point in sorted(points, key=lambda p: (p.seconds, p.error)):
        if math.isfinite(point.error) and (not found or point.error < found[-1].error):
            found.append(point)
    return found


def work_against_error(
    axes: Axes,
    points: Sequence[Point],
    looks: Mapping[str, Look],
    who: Callable[[Point], str],
    ends: tuple[float, float],
) -> None:
    """Draw time over error, a line for each contender.

    Args:
        axes: where.
        points: of one scene.
        looks: by name.
        who: the name of a point's contender.
        ends: the smallest and the largest error shown, px.
    """
    low, high = ends
    for name, look in looks.items():
        theirs = [p for p in points if who(p) == name]
        shown = [p for p in (theirs if look.whole else front(theirs)) if p.error <= high]
        if shown:
            style = {"color": look.color, "marker": look.marker, "ls": look.line, "ms": 4.0, "lw": 1.3}
            errors = [max(p.error, low) for p in shown]
            times = [1e3 * p.seconds for p in shown]
            axes.loglog(errors, times, label=name, **(style | dict(look.more)))
    axes.set_xlim(2.0 * high, low / 2.0)
    tidy(axes)


# ------------------------------------------------------------------------- softrod study
def study_figures(study: Study) -> Iterator[report.Figure]:
    """Yield the figures of a study for which there are results."""
    if any(results.points for results in study.scenes):
        yield report.Figure(
            "work-precision",
            "Milliseconds of computing for a simulated second over the largest position error at the end, "
            "px; for each method the settings that none of its others beats. Full lines: softrod; broken: "
            f"SciPy and CVODE. The star is auto at a tolerance of {STAR_ERROR:g} px in one call, the open "
            "star in 60 calls.",
            partial(_work_precision, study),
        )
    if any(not body.left_out for body in study.bodies):
        yield report.Figure(
            "bodies",
            f"Random bodies: the share that ends within so many tolerances (auto at {TOLERANCE:g} px), and "
            "the error over how much the body amplifies a nudge of its start.",
            partial(_bodies, study.bodies),
        )


def _work_precision(study: Study) -> Figure:
    """Small multiples: one for each scene."""
    from matplotlib.ticker import LogLocator

    shown = [results for results in study.scenes if results.points]
    columns = min(4, len(shown))
    rows = -(-len(shown) // columns)
    size = 3.3 * columns + 0.5, 3.1 * rows + 6.0 / (columns + 1.0)
    figure, panels = new_figure(*size, columns, rows, sharex=True, sharey=True, squeeze=False)
    ends = STUDY_FLOOR, 10.0 * max(study.errors)
    for axes, results in zip(panels.flat, shown, strict=False):
        work_against_error(axes, results.points, STUDY_LOOKS, lambda p: label(p.name), ends)
        auto = auto_at(results.points, STAR_ERROR)
        if auto is not None and math.isfinite(auto.error):
            star = {"marker": "*", "ms": 14.0, "mec": BLACK, "zorder": 5}
            axes.plot(auto.error, 1e3 * auto.seconds, mfc=YELLOW, **star)
            if math.isfinite(auto.framed_error):
                axes.plot(auto.framed_error, 1e3 * auto.framed_seconds, mfc="white", **star)
        axes.set_title(results.scene, fontsize=10.5, parse_math=False)
        axes.xaxis.set_major_locator(LogLocator(100.0, numticks=20))
    for axes in panels.flat[len(shown) :]:
        axes.set_visible(False)
    _label(panels, "computing time, ms", "error at the end, px")
    shared_legend(figure, panels.flat, STUDY_LOOKS, min(6, 2 * columns))
    return figure


def _label(panels: Any, y: str, x: str) -> None:
    for axes in panels[:, 0]:
        axes.set_ylabel(y)
    for axes in panels[-1]:
        axes.set_xlabel(x)


def _bodies(bodies: Sequence[BodyResult]) -> Figure:
    """Distribution of the errors on random bodies, and their errors over growth."""
    figure, (left, right) = new_figure(9.8, 4.2, columns=2)
    counted = [body for body in bodies if not body.left_out]
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
    errors = [max(body.error / TOLERANCE, floor) for body in counted]
    right.loglog(growth, errors, "o", color=BLUE, ms=4.0, mfc="none")
    right.set_xlabel(f"growth of a nudge of the start (left out above {CHAOTIC:g})")
    right.set_ylabel("error at the end, tolerances")
    for axes, line in ((left, left.axvline), (right, right.axhline)):
        line(1.0, color=GREY, lw=1.0)
        line(10.0, color=GREY, lw=1.0, ls=":")
        tidy(axes)
    return figure


# ------------------------------------------------------------------------- softrod bench peers
def peers_figures(points: Sequence[Point]) -> Iterator[report.Figure]:
    """Yield the figures of the scenes that have points."""
    there = {p.scene for p in points}
    groups = {
        "ropes": [name for name in PATHS if name.startswith("rope") and name in there],
        "nets": [name for name in PATHS if name.startswith("net") and name in there],
        MANY: [name for name in (MANY,) if name in there],
    }
    for group, names in groups.items():
        if names:
            yield report.Figure(
                group,
                "Milliseconds of processor time for a simulated second over the error in the end, px; of "
                "each, the settings that none of its others beats, but for auto, of which there are all.",
                partial(_paths, points, names),
            )
    if heaps := [name for name in HEAPS if name in there]:
        yield report.Figure(
            "heaps",
            "Milliseconds of processor time for a simulated second over the deepest that a mass came into "
            "another ring, px; beside each setting, how many masses are inside other rings in the end.",
            partial(_heaps, points, heaps),
        )


def _paths(points: Sequence[Point], names: Sequence[str]) -> Figure:
    """Time over error, a panel for each scene."""
    columns = min(len(names), 3 if len(names) == 3 else 2)
    rows = -(-len(names) // columns)
    size = 3.6 * columns + 1.0, 3.2 * rows + 0.9
    figure, panels = new_figure(*size, columns, rows, squeeze=False, sharex=True)
    for axes, name in zip(panels.flat, names, strict=False):
        here = [p for p in points if p.scene == name]
        work_against_error(axes, here, PEERS_LOOKS, peer, (PEERS_FLOOR, PEERS_TOP))
        axes.set_title(NAMES[name], fontsize=10.5)
    _label(panels, "processor time, ms", "error after a second, px")
    shared_legend(figure, panels.flat, PEERS_LOOKS)
    return figure


def _heaps(points: Sequence[Point], names: Sequence[str]) -> Figure:
    figure, panels = new_figure(4.6 * len(names) + 0.6, 4.2, len(names), squeeze=False)
    for axes, name in zip(panels.flat, names, strict=True):
        for who, look in PEERS_LOOKS.items():
            shown = [p for p in points if p.scene == name and peer(p) == who and not p.failure]
            if not shown:
                continue
            times = [1e3 * p.seconds for p in shown]
            depths = [max(p.overlap, 1e-2) for p in shown]
            axes.loglog(depths, times, color=look.color, marker=look.marker, ls="", ms=5.0, label=who)
            for point, x, y in zip(shown, depths, times, strict=True):
                text = f"{point.inside:.0f}"
                axes.annotate(text, (x, y), xytext=(4, 3), textcoords="offset points", fontsize=7)
        axes.set_title(NAMES[name], fontsize=10.5)
        tidy(axes)
    _label(panels, "processor time, ms", "deepest overlap, px")
    shared_legend(figure, panels.flat, PEERS_LOOKS)
    return figure
