"""What was found, as tables for the terminal, as Markdown and as CSV."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

from rich.table import Table

from ..reporting.output import comma_separated, table
from .engines import own
from .runs import Point
from .scenes import HEAPS, PATHS

ERRORS = (10.0, 1.0, 0.1, 0.01, 0.001)
"""Errors that are asked about, px."""

AUTO = "Auto"
"""The label of softrod's method that is told the error, and knows nothing else."""


def best(points: Sequence[Point], error: float) -> Point | None:
    """The fastest that ends within an error, px."""
    return min((p for p in points if p.error <= error), key=lambda p: p.seconds, default=None)


def auto_at(points: Sequence[Point], error: float) -> Point | None:
    """softrod's `auto` with an error as its tolerance."""
    return next((p for p in points if p.engine == own.NAME and p.method == AUTO and p.value == error), None)


def milliseconds(point: Point | None) -> str:
    """Of computing for a simulated second."""
    return "" if point is None or math.isinf(point.seconds) else f"{1e3 * point.seconds:#.3g}".rstrip(".")


def path_headings(points: Sequence[Point]) -> list[str]:
    """Of `path_rows`."""
    others = [name for name in dict.fromkeys(p.engine for p in points) if name != own.NAME]
    return ["to", "auto", "its error", "softrod's best own", "auto / it", *others]


def path_rows(points: Sequence[Point]) -> list[list[str]]:
    """For each error `auto`, the best of softrod's other methods, and the best of each of the others."""
    rows = []
    others = [name for name in dict.fromkeys(p.engine for p in points) if name != own.NAME]
    for error in ERRORS:
        auto = auto_at(points, error)
        mine = best([p for p in points if p.engine == own.NAME and p.method != AUTO], error)
        row = [f"{error:g} px", milliseconds(auto)]
        row.append("" if auto is None else auto.failure or f"{auto.error:.2g}")
        row.append("not reached" if mine is None else f"{milliseconds(mine)} {mine.method}, {mine.setting}")
        row.append(f"{auto.seconds / mine.seconds:.2f}" if auto and mine else "")
        for engine in others:
            other = best([p for p in points if p.engine == engine], error)
            row.append(
                "not reached" if other is None else f"{milliseconds(other)} {other.method}, {other.setting}"
            )
        rows.append(row)
    return rows


HEAP_HEADINGS = ("engine", "method", "setting", "ms/s", "deepest, px", "inside", "speed at the end, px/s")


def heap_rows(points: Sequence[Point]) -> list[list[str]]:
    """A line for each setting."""
    return [
        [p.engine, p.method, p.setting, milliseconds(p)]
        + ([p.failure, "", ""] if p.failure else [f"{p.overlap:.2f}", f"{p.inside:.0f}", f"{p.speed:.1f}"])
        for p in points
    ]


def scene_table(name: str, points: Sequence[Point]) -> Table:
    """For the terminal."""
    if name in PATHS:
        title = f"{PATHS[name].title}: ms of processor time for a simulated second"
        return table(path_headings(points), path_rows(points), title=title)
    if name in HEAPS:
        return table(HEAP_HEADINGS, heap_rows(points), "lll", title=name)
    return table(("engine",), [])


def points_csv(points: Sequence[Point]) -> str:
    """One line for each setting, numbers with all their digits."""
    names = [field.name for field in dataclasses.fields(Point)]
    return comma_separated(names, ([getattr(point, name) for name in names] for point in points))
