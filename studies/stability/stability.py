"""`softrod stability`: maps of where each integrator turns unstable."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

import numpy as np
from rich.console import Console

from sim import Scene
from sim.errors import InputError
from sim.solve.registry import METHODS

from ..reporting.progress import ProgressBar
from ..reporting.report import Figure, Section, Table, bullets, csv_of, make_folder, write_report
from .axes import AXES, released
from .figures import draw
from .map import (
    ACCURATE,
    DAMPED_WRONGLY,
    ENDINGS,
    NEAR,
    SAMPLES,
    UNSTABLE,
    Map,
    borders,
    compute,
    fixed_step_methods,
)

PAIRS = (
    ("dt", "stiffness"),
    ("dt", "damping"),
    ("dt", "angular_stiffness"),
    ("mass_ratio", "dt"),
    ("masses", "dt"),
)
"""The maps that are drawn by default."""

Range = tuple[float, float] | None


def stability(
    scene: Scene,
    axes: tuple[str, str] | None,
    ranges: tuple[Range, Range],
    size: int,
    methods: Sequence[str],
    duration: float,
    out: Path,
    console: Console,
) -> int:
    """Compute maps and write `stability.csv.gz`, `stability.md`, and a PNG of each.

    Ctrl-C ends it early; what is done by then is written.

    Args:
        scene: with everything that is not varied.
        axes: names of two numbers, see AXES; None for all of PAIRS that the scene has.
        ranges: of both axes, or None for the defaults.
        size: cells along each axis, at most.
        methods: names of methods with a fixed step; empty for all.
        duration: simulated time in each cell, s.
        out: folder; made if its parent exists.
        console: for tables and progress.

    Returns:
        The exit status: 0, or 130 if it was interrupted.

    Raises:
        InputError: an axis, a range or a method does not exist, or the folder cannot be written to.
    """
    moving = released(scene)
    chosen = [axes] if axes else [pair for pair in PAIRS if not any(AXES[k].problem(moving) for k in pair)]
    charts = [_chart(moving, pair, ranges if axes else (None, None), size) for pair in chosen]
    methods = list(methods) or fixed_step_methods()
    for method in methods:
        if method not in fixed_step_methods():
            raise InputError(
                f"--integrators: {method!r} is not one of {', '.join(fixed_step_methods())}, "
                "the methods with a fixed step"
            )
    make_folder(out)
    with ProgressBar(console, 1) as bar:
        for chart in charts:

            def report(done: int, of: int, what: str, chart: Map = chart) -> None:
                bar.say(f"{chart.x.key} × {chart.y.key}: {what}", done, of)

            compute(moving, chart, methods, duration, report)
            bar.print(summary(chart))
    note = "Interrupted: maps or cells are missing." if bar.interrupted else ""
    begun = [chart for chart in charts if chart.endings]
    if note:
        console.print(note)
    page = sections(scene, moving, begun, duration, note)
    complete = write_report(out, "stability", page, {"stability": as_csv(begun)}, console)
    return 0 if complete and not note else 130


def _chart(scene: Scene, pair: tuple[str, str], ranges: tuple[Range, Range], size: int) -> Map:
    x, y = (AXES[key] for key in pair)
    if x.key == y.key:
        raise InputError(f"--x and --y are both {x.key}: a map needs two numbers")
    for axis in (x, y):
        problem = axis.problem(scene)
        if problem is not None:
            raise InputError(f"{axis.key}: {problem}")
    return Map(x, y, x.values(ranges[0], size), y.values(ranges[1], size), scene.integrator.dt)


def summary(chart: Map) -> Table:
    """Return how the cells of each method ended, and where its border is."""
    rows = []
    for method, endings in chart.endings.items():
        shares = [f"{100.0 * (endings == k).mean():.0f} %" for k in (ACCURATE, DAMPED_WRONGLY, UNSTABLE)]
        found, border = borders(chart, method), ""
        if found.size:
            border = f"{np.median(found):.2f} ({found.min():.2f} to {found.max():.2f})"
        elif not np.isfinite(chart.limits[method]).any():
            border = "no limit"
        rows.append((METHODS[method].label, *shares, border))
    headings = ("integrator", "accurate", "damped wrongly", "unstable", "border / analytic limit")
    return Table(headings, rows, title=_title(chart))


def _title(chart: Map) -> str:
    return f"{chart.x.label} × {chart.y.label}"


def as_csv(charts: Sequence[Map]) -> str:
    """Return a row for each cell: the two numbers, then ending, error and limit of each integrator."""
    methods = list(charts[0].endings) if charts else []
    parts = [f"{method}{part}" for method in methods for part in ("", "_error", "_limit")]
    rows = []
    for chart in charts:
        for i, y in enumerate(chart.ys):
            for j, x in enumerate(chart.xs):
                cells: list[str] = []
                for method in methods:
                    if method in chart.endings:
                        cells.append(ENDINGS[int(chart.endings[method][i, j])])
                        numbers = (chart.errors[method][i, j], chart.limits[method][i, j])
                        cells += [f"{n:.2g}" if np.isfinite(n) else "" for n in numbers]
                    else:
                        cells += ["", "", ""]
                rows.append((chart.x.key, chart.y.key, f"{x:.6g}", f"{y:.6g}", *cells))
    return csv_of(("x", "y", "x_value", "y_value", *parts), rows)


def sections(
    scene: Scene, moving: Scene, charts: Sequence[Map], duration: float, note: str
) -> Iterator[Section]:
    """Yield the sections of the page.

    Args:
        scene: as it was named.
        moving: the same with something to move, see `released`.
        charts: the maps.
        duration: of each cell, s.
        note: what else there is to say; empty for nothing.
    """
    let_go = (
        f"All masses of {scene.name} are held; here all but the first are let go. "
        if len(moving.anchors) < len(scene.anchors)
        else ""
    )
    yield f"# Where {scene.name} breaks"
    yield (
        f"Written by `softrod stability --out DIR`. {let_go}Each cell is a simulation of {duration:g} s with "
        "the two values of its row and column, under the force law "
        f"“{moving.force_law}”, with a time step of {1e3 * moving.integrator.dt:g} ms where none is an axis. "
        "Each free mass starts with a kick of an "
        "extent of the body per second, in a direction that turns by "
        f"the golden angle from mass to mass. It is looked at {SAMPLES} times:"
    )
    yield bullets(
        (
            f"**accurate**: no mass is ever farther than {100.0 * NEAR:g} % of the body's extent from where "
            "it is in the reference, which is `auto` with a tolerance of a thousandth of that;",
            "**damped wrongly**: it stays within bounds, but amplitude or phase is off by more;",
            "**unstable**: a mass passes the limits of a simulation (1e6 px, 1e6 px/s), or the method finds "
            "no way on, or kinetic energy and height come to more than they ever do in the reference by all "
            "that was put in: kinetic and elastic energy at the start, and the body's weight times its "
            "extent.",
        )
    )
    yield (
        "The black line is the analytic limit of the step, that of small motions about the start "
        "(`sim/motion/stability.py`), which the meter in the page shows, too. The last column of the tables "
        "has the step at which bodies turned unstable, in parts of that limit: the median over the map's "
        "lines, and the range. A cell is as wide as the range in which a border cannot be told apart."
    )
    yield f"**{note}**" if note else ""
    for chart in charts:
        title = _title(chart)
        yield f"## {title[0].upper()}{title[1:]}"
        yield Figure(chart.name, "", partial(draw, chart, scene.name), dpi=100, alt=title)
        if "dt" in (chart.x.key, chart.y.key):
            steps = chart.xs if chart.x.key == "dt" else chart.ys
            width = (steps[-1] / steps[0]) ** (1.0 / max(len(steps) - 1, 1)) - 1.0
            yield f"A cell is {100.0 * width:.0f} % of its step wide."
        yield summary(chart)
