"""The report of `softrod bench peers`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from ..reporting.report import Section, Table
from .figures import peers_figures
from .runs import FRAME, PATIENCE, SOFTROD, Point, auto_at, best, milliseconds
from .scenes import EVERY, HEAP_SECONDS, HEAPS, MANY, NAMES, PATHS

ERRORS = (10.0, 1.0, 0.1, 0.01, 0.001)
"""Errors that are asked about, px."""

SHORT_ERROR = 0.1
"""Error of the short table, px."""

_SAME = ("setting", "value", "seconds", "error", "overlap", "inside", "speed", "runs", "failure")

COLUMNS = {"scene": "scene", "engine": "engine", "method": "label", **dict(zip(_SAME, _SAME, strict=True))}
"""Columns of peers.csv, and the fields of `Point` they come from."""


def rivals(points: Sequence[Point]) -> dict[str, list[Point]]:
    """Return the points of softrod's methods but `auto`, and of each other engine, by names for people."""
    found = {"softrod's best": [p for p in points if p.engine == SOFTROD and p.method != "auto"]}
    for name in dict.fromkeys(p.engine for p in points):
        if name != SOFTROD:
            found[name] = [p for p in points if p.engine == name]
    return found


def scene_table(name: str, points: Sequence[Point], settings: bool) -> Table:
    """Return the results of a scene.

    Args:
        name: of the scene.
        points: of the scene.
        settings: whether methods and settings are named where only the fastest is shown.
    """
    title = NAMES[name]
    if name in HEAPS:
        headings = ("", "method", "setting", "ms", "deepest, px", "inside", "speed, px/s")
        rows = [[*_setting(p), *_of_heap(p)] for p in points]
        return Table(headings, rows, "lll", title)
    if name == MANY:
        rows = [[*_setting(p), p.failure or f"{p.error:.2g}"] for p in points]
        return Table(("", "method", "setting", "ms", "error, px"), rows, "lll", title)
    headings = ("", *(f"{error:g} px" for error in ERRORS))
    rows = [["softrod, auto", *(_auto(auto_at(points, error), error, settings) for error in ERRORS)]]
    for who, theirs in rivals(points).items():
        rows.append([who, *(_fastest(theirs, error, settings) for error in ERRORS)])
    return Table(headings, rows, title=title)


def _setting(point: Point) -> tuple[str, ...]:
    return point.engine, point.label, point.setting, milliseconds(point.seconds)


def _of_heap(point: Point) -> tuple[str, ...]:
    if point.failure:
        return point.failure, "", ""
    return f"{point.overlap:.2f}", f"{point.inside:.0f}", f"{point.speed:.1f}"


def _auto(auto: Point | None, error: float, always: bool) -> str:
    """The time of `auto`; with its error where that is larger than it should be, or always."""
    if auto is None:
        return ""
    off = auto.failure or f"ends {auto.error:.2g} px off"
    time = milliseconds(auto.seconds)
    return f"{time} ({off})".strip() if always or auto.error > error else time


def _fastest(points: Sequence[Point], error: float, settings: bool) -> str:
    found = best(points, error)
    if found is None:
        return "not reached" if points else ""
    time = milliseconds(found.seconds)
    return f"{time} ({found.label}, {found.setting})" if settings else time


def short_table(points: Sequence[Point]) -> Table:
    """Return, for each rope and net, the ms that each engine needs to `SHORT_ERROR`."""
    engines = dict.fromkeys(p.engine for p in points if p.scene in PATHS and p.engine != SOFTROD)
    rows = []
    for name in PATHS:
        here = [p for p in points if p.scene == name]
        if not here:
            continue
        auto, others = auto_at(here, SHORT_ERROR), rivals(here)
        cell = milliseconds(auto.seconds if auto else None)
        row = [NAMES[name], f"{cell} ({auto.error:.2g})" if auto and auto.error > SHORT_ERROR else cell]
        for who in ("softrod's best", *engines):
            theirs = others.get(who, [])
            row.append(_fastest(theirs, SHORT_ERROR, settings=False).replace("not reached", "–"))
        rows.append(row)
    return Table(("", "softrod, auto", "softrod's best", *engines), rows)


def sections(points: Sequence[Point], lacking: Sequence[str], note: str) -> Iterator[Section]:
    """Yield the sections of the page.

    Args:
        points: all of them.
        lacking: sentences on who is missing.
        note: what else there is to say; empty for nothing.
    """
    yield "# Softrod and others on the same scenes"
    yield _INTRODUCTION
    yield from lacking
    yield note
    short = short_table(points)
    if short.rows:
        yield f"## To {SHORT_ERROR:g} px"
        yield _SHORT
        yield short
    yield from peers_figures(points)
    for name in dict.fromkeys(p.scene for p in points):
        here = [p for p in points if p.scene == name]
        yield f"## {NAMES[name]}"
        yield scene_table(name, here, settings=True)
        failed = [p for p in here if p.failure and name in PATHS]
        if failed:
            counts, reasons = Counter(p.engine for p in failed), {p.engine: p.failure for p in failed}
            listed = "; ".join(f"{who}: {count}, as {reasons[who]}" for who, count in counts.items())
            yield f"Settings that came to no end: {listed}."


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
