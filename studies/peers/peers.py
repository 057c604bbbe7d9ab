"""`softrod bench peers`: softrod and what one would take instead, on the same scenes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.console import Console

import sim

from ..reporting.output import Watch, make_folder, write_figures, write_page, write_table
from . import report
from .engines import arrays, box2d, c_loop, chipmunk, jax_loops, muj, own, solvers
from .references import reference
from .runs import Point, measure
from .scenes import HEAPS, NAMES

_ALL = (
    own, c_loop, arrays, solvers.SciPy, solvers.Cvode, jax_loops.Jax, jax_loops.Diffrax, box2d, chipmunk, muj,
)  # fmt: skip
ENGINES: dict[str, Any] = {engine.NAME: engine for engine in _ALL}
"""The modules of `engines` by name."""

QUICK = "rope-12", "net-100-soft", "heap-120"
"""The scenes of a quick run."""


def known(what: str, names: str, all_of_them: Sequence[str]) -> list[str]:
    """Names out of "a,b"; all of them for an empty text.

    Raises:
        sim.InputError: there is none of that name.
    """
    found = [name.strip() for name in names.split(",")] if names else list(all_of_them)
    for name in found:
        if name not in all_of_them:
            raise sim.InputError(f"--{what}: {name!r} is not one of {', '.join(all_of_them)}")
    return list(dict.fromkeys(found))


def bench_peers(
    scenes: str, engines: str, quick: bool, repeats: int, out: Path | None, console: Console
) -> int:
    """Measure, print, and write a report.

    Ctrl-C ends it early; what is done by then is written.

    Args:
        scenes: names with commas between them; empty for all.
        engines: likewise.
        quick: whether only `QUICK` scenes are measured, with fewer repeats.
        repeats: how often what is short is timed.
        out: folder for the report, or None: peers.md, peers.csv.gz and figures.
        console: where it is printed.

    Returns:
        The exit status: 0, or 130 if it was interrupted.

    Raises:
        sim.InputError: a name is unknown, or the folder cannot be made.
    """
    scene_names = known("scenes", scenes, NAMES) if scenes or not quick else list(QUICK)
    engine_names = known("engines", engines, tuple(ENGINES))
    if out is not None:
        make_folder(out)
    lacking = [
        f"{name} is missing: {ENGINES[name].missing()} (`uv sync --extra peers`)."
        for name in engine_names
        if ENGINES[name].missing()
    ]
    for sentence in lacking:
        console.print(sentence)
    here = [ENGINES[name] for name in engine_names if not ENGINES[name].missing()]
    points: list[Point] = []
    done = 0
    with Watch(console, len(scene_names)) as watch:
        for name in scene_names:
            ladders = [ladder for engine in here for ladder in engine.ladders(name)]
            right = None if name in HEAPS else reference(name)
            before, found = list(points), []
            for so_far, what in measure(name, ladders, right, min(repeats, 2) if quick else repeats):
                found = so_far
                points = before + so_far
                watch.say(f"{name}: {what}")
            points, done = before + found, done + 1
            watch.advance()
            watch.print(report.scene_table(name, found))
    note = f"Interrupted after {done} of {len(scene_names)} scenes." if watch.interrupted else ""
    if note:
        console.print(note)
    if out is not None:
        from .figures import figures

        write_table(out / "peers.csv.gz", report.points_csv(points))
        drawn = write_figures(out, figures(points))
        write_page(out / "peers.md", report.markdown(points, drawn, lacking, note))
        console.print(f"written to {out}")
    return 130 if watch.interrupted else 0
