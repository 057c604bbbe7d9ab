"""`softrod study`: computing time against error, for softrod's methods and for what else one would take."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

import sim
from sim import Scene
from sim.errors import InputError

from ..reporting.output import Watch, make_folder, write_figures, write_page, write_table
from . import report
from .measure import SceneResults, explore, known
from .random_study import measure_bodies
from .report import Study


def study_scenes() -> list[str]:
    """The scenes of a full run."""
    names = [info.name for info in sim.list_scenes() if info.group == "study"]
    return sorted(names, key=lambda name: not name.startswith("study-w"))


def parse_errors(text: str) -> tuple[float, ...]:
    """Errors from "1,0.1,1e-3", px.

    Raises:
        InputError: one is not a number from 1e-8 to 1e3.
    """
    errors = []
    for word in text.split(","):
        try:
            error = float(word)
        except ValueError:
            error = math.nan
        if not 1e-8 <= error <= 1e3:
            raise InputError(f"--errors: {word.strip()!r} is not in the range 1e-08..1000 px")
        errors.append(error)
    return tuple(sorted(set(errors), reverse=True))


def parse_integrators(text: str) -> tuple[str, ...]:
    """Methods and other solvers from "auto,rk4"; all there are for an empty text.

    Raises:
        InputError: there is no such method, or what it needs is not installed.
    """
    return known([word.strip() for word in text.split(",")] if text else [])


def study(
    scenes: Sequence[tuple[str, Scene]],
    integrators: Sequence[str],
    errors: tuple[float, ...],
    random: int,
    out: Path,
    console: Console,
) -> int:
    """Measure, print what came out and write it.

    Ctrl-C ends it early; what is done by then is printed and written.

    Args:
        scenes: names and scenes.
        integrators: methods of softrod, and other solvers as `others` has them.
        errors: px, from large to small.
        random: how many random bodies to run.
        out: folder for the report; made if its parent exists.
        console: where the table and the progress go.

    Returns:
        The exit status: 0, or 130 if it was interrupted. A target that is missed is no failure: it says as
        much about the machine.

    Raises:
        InputError: the folder cannot be made or written to, or a scene has no reference.
    """
    # One core for everybody: threads of LAPACK would only be in each other's way with matrices of this size.
    # SciPy reads it when it is first asked for linear algebra.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    make_folder(out)
    found = Study(errors)
    with Watch(console, len(scenes) * len(integrators) + random) as watch:
        for done, body in enumerate(measure_bodies(random), start=1):
            found.bodies.append(body)
            watch.say(f"random body {done} of {random}", done)
        for name, scene in scenes:
            _measure(found, name, scene, integrators, watch)
    note = ""
    if watch.interrupted:
        done = f"{sum(results.complete for results in found.scenes)} of {len(scenes)} scenes"
        note = f"Interrupted after {done} and {len(found.bodies)} of {random} random bodies."
    _report(found, note, out, console)
    return 130 if note else 0


def _measure(found: Study, name: str, scene: Scene, integrators: Sequence[str], watch: Watch) -> None:
    results: SceneResults | None = None
    for so_far, what in explore(scene, name, integrators, found.errors):
        if results is None and so_far is not None:
            results = so_far
            found.scenes.append(results)
        watch.say(f"{name}: {what}")
    watch.advance(len(integrators))


def _report(found: Study, note: str, out: Path, console: Console) -> None:
    """Print and write."""
    from .figures import figures

    for error in (error for error in report.SHORT_HEADINGS if error in found.errors):
        console.print(report.short_table(found, error))
        console.print()
    if met := report.summary(found):
        console.print(report.target_table(found))
        console.print(f"{met}.")
    for sentence in (*report.advice(found), note):
        if sentence:
            console.print(sentence, highlight=False, soft_wrap=True)
    write_table(out / "study.csv.gz", report.points_csv(found))
    write_table(out / "bodies.csv.gz", report.bodies_csv(found))
    drawn = write_figures(out, figures(found))
    write_page(out / "study.md", report.markdown(found, drawn, note))
    console.print(f"written to {out}")
