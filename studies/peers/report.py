"""What was found, as tables for the terminal, as Markdown and as CSV."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version

from rich.table import Table

from ..reporting.output import captioned, comma_separated, grid, page, table
from .engines import own
from .runs import FRAME, PATIENCE, Point
from .scenes import COUNT, EVERY, HEAP_SECONDS, HEAPS, MANY, PATHS

ERRORS = (10.0, 1.0, 0.1, 0.01, 0.001)
"""Errors that are asked about, px."""

AUTO = "Auto"
"""The label of softrod's method that is told the error, and knows nothing else."""

PACKAGES = ("pyb2d3", "pymunk", "mujoco", "jax", "diffrax", "scikit-sundae")
"""Those of the extra `peers`."""


def title(name: str) -> str:
    """A scene's name for people."""
    if name in PATHS:
        return PATHS[name].title.capitalize()
    return f"{COUNT} ropes of 12 masses" if name == MANY else f"Heap of {name.partition('-')[2]} masses"


def best(points: Sequence[Point], error: float) -> Point | None:
    """The fastest that ends within an error, px."""
    return min((p for p in points if p.error <= error), key=lambda p: p.seconds, default=None)


def auto_at(points: Sequence[Point], error: float) -> Point | None:
    """softrod's `auto` with an error as its tolerance."""
    return next((p for p in points if p.engine == own.NAME and p.method == AUTO and p.value == error), None)


def rivals(points: Sequence[Point]) -> dict[str, list[Point]]:
    """The points of softrod's methods but `auto`, and of each of the others, by names for people."""
    found = {"softrod's best": [p for p in points if p.engine == own.NAME and p.method != AUTO]}
    for name in dict.fromkeys(p.engine for p in points):
        if name != own.NAME:
            found[name] = [p for p in points if p.engine == name]
    return found


def milliseconds(point: Point | None) -> str:
    """Of computing for a simulated second."""
    return "" if point is None or math.isinf(point.seconds) else f"{1e3 * point.seconds:#.3g}".rstrip(".")


PATH_HEADINGS = ("", *(f"{error:g} px" for error in ERRORS))


def path_rows(points: Sequence[Point], settings: bool) -> list[list[str]]:
    """ms for each error: of `auto`, of softrod's best other method, and of the best of each of the others.

    Args:
        points: of a scene.
        settings: whether methods and settings are named, too.
    """
    row = ["softrod, auto"]
    for error in ERRORS:
        auto = auto_at(points, error)
        off = "" if auto is None else auto.failure or f"ends {auto.error:.2g} px off"
        row.append(
            f"{milliseconds(auto)} ({off})"
            if auto and (settings or auto.error > error)
            else milliseconds(auto)
        )
    rows = [row]
    for who, theirs in rivals(points).items():
        row = [who]
        for error in ERRORS:
            found = best(theirs, error)
            text = milliseconds(found) if found else "not reached" if theirs else ""
            row.append(f"{text} ({found.method}, {found.setting})" if found and settings else text)
        rows.append(row)
    return rows


HEAP_HEADINGS = ("", "method", "setting", "ms", "deepest, px", "inside", "speed, px/s")


def heap_rows(points: Sequence[Point]) -> list[list[str]]:
    """A line for each setting."""
    return [
        [p.engine, p.method, p.setting, milliseconds(p)]
        + ([p.failure, "", ""] if p.failure else [f"{p.overlap:.2f}", f"{p.inside:.0f}", f"{p.speed:.1f}"])
        for p in points
    ]


MANY_HEADINGS = ("", "method", "setting", "ms", "error, px")


def many_rows(points: Sequence[Point]) -> list[list[str]]:
    """A line for each setting."""
    return [[p.engine, p.method, p.setting, milliseconds(p), p.failure or f"{p.error:.2g}"] for p in points]


def scene_table(name: str, points: Sequence[Point]) -> Table:
    """For the terminal."""
    if name in HEAPS:
        return table(HEAP_HEADINGS, heap_rows(points), "lll", title=title(name))
    if name == MANY:
        return table(MANY_HEADINGS, many_rows(points), "lll", title=title(name))
    return table(PATH_HEADINGS, path_rows(points, settings=False), title=title(name))


def scene_grid(name: str, points: Sequence[Point]) -> str:
    """In Markdown."""
    if name in HEAPS:
        return grid(HEAP_HEADINGS, heap_rows(points), "lll")
    if name == MANY:
        return grid(MANY_HEADINGS, many_rows(points), "lll")
    return grid(PATH_HEADINGS, path_rows(points, settings=True))


SHORT_ERROR = 0.1
"""Error of the short table, px."""


def short_rows(points: Sequence[Point]) -> tuple[list[str], list[list[str]]]:
    """Headings and rows: for each rope and net, ms to `SHORT_ERROR` of everybody."""
    names = [name for name in PATHS if any(p.scene == name for p in points)]
    engines = [
        name for name in dict.fromkeys(p.engine for p in points if p.scene in PATHS) if name != own.NAME
    ]
    rows = []
    for name in names:
        here = [p for p in points if p.scene == name]
        auto = auto_at(here, SHORT_ERROR)
        cell = milliseconds(auto)
        row = [title(name), f"{cell} ({auto.error:.2g})" if auto and auto.error > SHORT_ERROR else cell]
        for who in ("softrod's best", *engines):
            theirs = rivals(here).get(who, [])
            found = best(theirs, SHORT_ERROR)
            row.append(milliseconds(found) if found else "–" if theirs else "")
        rows.append(row)
    return ["", "softrod, auto", "softrod's best", *engines], rows


def markdown(
    points: Sequence[Point], figures: Sequence[tuple[str, str]], lacking: Sequence[str], note: str
) -> str:
    """A page with everything.

    Args:
        points: all of them.
        figures: (name without ending, caption) of each figure beside the page.
        lacking: sentences on who is missing.
        note: what else there is to say; empty for nothing.
    """
    blocks = ["# Softrod and others on the same scenes", _INTRODUCTION, *lacking, note]
    headings, rows = short_rows(points)
    if rows:
        blocks += [f"## To {SHORT_ERROR:g} px", _SHORT, grid(headings, rows)]
    blocks.append(captioned(figures))
    for name in dict.fromkeys(p.scene for p in points):
        here = [p for p in points if p.scene == name]
        blocks += [f"## {title(name)}", scene_grid(name, here)]
        failed = {p.engine: p.failure for p in here if p.failure and name not in HEAPS}
        if failed and name in PATHS:
            counts = {who: sum(p.engine == who and bool(p.failure) for p in here) for who in failed}
            said = "; ".join(f"{who}: {counts[who]}, as {why}" for who, why in failed.items())
            blocks.append(f"Settings that came to no end: {said}.")
    return page(*blocks, more=[name for name in PACKAGES if _installed(name)])


def _installed(name: str) -> bool:
    try:
        version(name)
    except PackageNotFoundError:
        return False
    return True


_INTRODUCTION = (
    "Written by `softrod bench peers --out DIR`; [peers.md](../peers.md) says what is compared, and what is "
    "unfair to whom. Milliseconds of processor time for a simulated second, the least of interleaved "
    "repeats; errors are the largest distance of a mass from where a reference has it after a second, px. "
    "Everybody has the setting that hindsight finds to be the fastest within the error; `auto` has none: "
    "its tolerance is the error. Where it ends farther off than that, the table says so. Heaps are moved by "
    f"frames of 1/{round(1 / FRAME)} s for {HEAP_SECONDS:g} s: the deepest that a mass came into another "
    "ring, how many are inside others in the end, and the root mean square of their speeds then. Of the "
    f"many ropes, one in {EVERY} is looked at. A run that takes more than {PATIENCE:g} s of processor "
    "time is given up where that is possible."
)

_SHORT = (
    "Milliseconds of processor time for a simulated second. A dash: no setting comes that close. In "
    "brackets: how far `auto` ends off, where that is more."
)


def points_csv(points: Sequence[Point]) -> str:
    """One line for each setting, numbers with all their digits."""
    names = [field.name for field in dataclasses.fields(Point)]
    return comma_separated(names, ([getattr(point, name) for name in names] for point in points))
