"""The figures of `softrod bench peers`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..reporting.figures import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, new_figure, tidy
from ..reporting.output import Drawing
from .engines import own
from .report import AUTO, title
from .runs import Point
from .scenes import HEAPS, MANY, PATHS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LOOKS = {
    "softrod, auto": (BLACK, "o", "-"),
    "softrod's best": (BLUE, "s", "-"),
    "C loop": (GREY, "D", "-"),
    "NumPy": (GREY, "p", "--"),
    "SciPy": (PURPLE, "^", "--"),
    "CVODE": ("#a05a2c", "v", "--"),
    "JAX": (SKY, "X", "--"),
    "diffrax": (SKY, "P", ":"),
    "Box2D": (ORANGE, "s", "-"),
    "Chipmunk": (GREEN, "^", "-"),
    "MuJoCo": ("#e69f00", "o", "--"),
}
"""Colour, marker and line of each."""

FLOOR, TOP = 1e-4, 300.0
"""Errors that are drawn, px."""


def figures(points: Sequence[Point]) -> dict[str, Drawing]:
    """The figures by name, of what there are points of."""
    there = {p.scene for p in points}
    groups = {
        "ropes": [name for name in PATHS if name.startswith("rope") and name in there],
        "nets": [name for name in PATHS if name.startswith("net") and name in there],
        MANY: [name for name in (MANY,) if name in there],
    }
    drawn: dict[str, Drawing] = {
        name: (
            "Milliseconds of processor time for a simulated second over the error in the end, px; of each, "
            "the settings that none of its others beats, but for auto, of which there are all.",
            lambda names=names: paths(points, names),
        )
        for name, names in groups.items()
        if names
    }
    heaps = [name for name in HEAPS if name in there]
    if heaps:
        drawn["heaps"] = (
            "Milliseconds of processor time for a simulated second over the deepest that a mass came into "
            "another ring, px; beside each setting, how many masses are inside other rings in the end.",
            lambda: _heaps(points, heaps),
        )
    return drawn


def whose(point: Point) -> str:
    """The name in the legend."""
    if point.engine != own.NAME:
        return point.engine
    return "softrod, auto" if point.method.startswith(AUTO) else "softrod's best"


def front(points: Sequence[Point]) -> list[Point]:
    """The points that no other one beats in both error and time, by error from large to small."""
    kept: list[Point] = []
    for point in sorted(points, key=lambda p: (p.seconds, p.error)):
        if math.isfinite(point.error) and (not kept or point.error < kept[-1].error):
            kept.append(point)
    return kept


def paths(points: Sequence[Point], names: Sequence[str]) -> Figure:
    """Time over error, a part for each scene."""
    columns = min(len(names), 3 if len(names) == 3 else 2)
    rows = -(-len(names) // columns)
    figure, axes = new_figure(
        3.6 * columns + 1.0, 3.2 * rows + 0.9, columns, rows, squeeze=False, sharex=True
    )
    for part, name in zip(axes.flat, names, strict=False):
        for who, (color, marker, line) in LOOKS.items():
            theirs = [p for p in points if p.scene == name and whose(p) == who and p.error <= TOP]
            shown = theirs if who == "softrod, auto" else front(theirs)
            if shown:
                style = {"color": color, "marker": marker, "ls": line, "ms": 4.0, "lw": 1.3, "label": who}
                part.loglog([max(p.error, FLOOR) for p in shown], [1e3 * p.seconds for p in shown], **style)
        part.set_title(title(name), fontsize=10.5)
        part.set_xlim(2.0 * TOP, FLOOR / 2.0)
        tidy(part)
    for part in axes[:, 0]:
        part.set_ylabel("processor time, ms")
    for part in axes[-1]:
        part.set_xlabel("error after a second, px")
    _legend(figure, axes.flat)
    return figure


def _heaps(points: Sequence[Point], names: Sequence[str]) -> Figure:
    figure, axes = new_figure(4.6 * len(names) + 0.6, 4.2, len(names), squeeze=False)
    for part, name in zip(axes.flat, names, strict=True):
        for who, (color, marker, _) in LOOKS.items():
            shown = [p for p in points if p.scene == name and whose(p) == who and not p.failure]
            if not shown:
                continue
            times, depths = [1e3 * p.seconds for p in shown], [max(p.overlap, 1e-2) for p in shown]
            part.loglog(depths, times, color=color, marker=marker, ls="", ms=5.0, label=who)
            for point, x, y in zip(shown, depths, times, strict=True):
                part.annotate(
                    f"{point.inside:.0f}", (x, y), xytext=(4, 3), textcoords="offset points", fontsize=7
                )
        part.set_title(title(name), fontsize=10.5)
        part.set_xlabel("deepest overlap, px")
        tidy(part)
    axes[0, 0].set_ylabel("processor time, ms")
    _legend(figure, axes.flat)
    return figure


def _legend(figure: Figure, parts: Any) -> None:
    handles: dict[str, Any] = {}
    for part in parts:
        axes: Axes = part
        handles |= {str(line.get_label()): line for line in axes.get_lines()}
    order = [name for name in LOOKS if name in handles]
    figure.legend(
        [handles[name] for name in order], order, loc="outside lower center",
        ncols=min(6, len(order)), frameon=False, fontsize=8.5,
    )  # fmt: skip
