"""`softrod study`: computing time against error, of softrod's methods and of SciPy's solvers and CVODE."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from rich.console import Console

import sim
from sim import Scene
from sim.errors import InputError
from sim.solve.registry import METHODS

from ..reporting.progress import ProgressBar
from ..reporting.report import make_folder, write_report
from . import study_report as report
from .engines import softrod, solvers
from .measure import Contender, Timing, against, measure
from .random_study import measure_bodies
from .references import agreed_reference
from .results import SOLVERS, SceneResults, Study

TIGHT = (1e-9, 1e-10, 1e-11)
"""Tolerances of the reference, px; the tighter ones only where it needs them."""

SURE = 0.1
"""Part of the smallest error asked for to which the references are brought to agree, if they can be."""

HOPELESS = 10.0
"""Errors larger than so many times the largest one asked for are not timed again."""


def study_scenes() -> list[str]:
    """Return the scenes of a full run."""
    names = [info.name for info in sim.list_scenes() if info.group == "study"]
    return sorted(names, key=lambda name: not name.startswith("study-w"))


def parse_errors(text: str) -> tuple[float, ...]:
    """Return errors from "1,0.1,1e-3", px, from large to small.

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
    """Return methods and other solvers from "auto,rk4"; all that can be measured here for an empty text.

    Raises:
        InputError: there is no such method, or what it needs is not installed.
    """
    names = [word.strip() for word in text.split(",")] if text else []
    has_cvode = solvers.has_cvode()
    here = (*METHODS, *(name for name, (engine, _) in SOLVERS.items() if has_cvode or engine != "CVODE"))
    for name in names:
        if name in SOLVERS and name not in here:
            raise InputError(
                f"--integrators: {name} needs scikit-sundae; uv sync --extra compare installs it"
            )
        if name not in here:
            raise InputError(f"--integrators: {name!r} is not one of {', '.join(here)}")
    return tuple(dict.fromkeys(names)) or here


def repeats(seconds: float) -> int:
    """Return how often a run of that length is timed: short ones more often, as others disturb them more."""
    return 25 if seconds < 0.005 else 5 if seconds < 0.05 else 2 if seconds < 0.5 else 1


def explore(
    scene: Scene, name: str, integrators: Sequence[str], errors: Sequence[float]
) -> Iterator[tuple[SceneResults | None, str]]:
    """Measure a scene.

    Yields:
        The results so far, which grow and become faster, and what comes next.
    """
    yield None, "reference"
    reference = agreed_reference(scene, TIGHT, SURE * min(errors))
    results = SceneResults(name, reference.doubt)
    timing = Timing(lambda point: repeats(point.seconds) if point.error <= HOPELESS * max(errors) else 1)
    contenders = (_contender(scene, integrator, errors) for integrator in integrators)
    for points, what in measure(name, contenders, against(reference.path), timing):
        results.points = points
        yield results, what
    results.complete = True


def _contender(scene: Scene, name: str, errors: Sequence[float]) -> Contender:
    if name in SOLVERS:
        return solvers.studied(scene, *SOLVERS[name], errors)
    return softrod.studied(scene, name, errors)


def study(
    scenes: Sequence[tuple[str, Scene]],
    integrators: Sequence[str],
    errors: tuple[float, ...],
    random: int,
    out: Path,
    console: Console,
) -> int:
    """Measure, print the results and write the report.

    Ctrl-C ends it early; what is done by then is printed and written.

    Args:
        scenes: names and scenes.
        integrators: methods of softrod, and other solvers as in `SOLVERS`.
        errors: px, from large to small.
        random: number of random bodies.
        out: folder for the report; made if its parent exists.
        console: for tables and progress.

    Returns:
        The exit status: 0, or 130 if it was interrupted. A missed target is no failure: it says as much about
        the machine.

    Raises:
        InputError: the folder cannot be made or written to, or a scene has no reference.
    """
    # One core for each solver: threads of LAPACK would only compete with matrices of this size.
    # SciPy reads this when it is first asked for linear algebra.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    make_folder(out)
    found = Study(errors)
    with ProgressBar(console, len(scenes) + random) as bar:
        for done, body in enumerate(measure_bodies(random), start=1):
            found.bodies.append(body)
            bar.say(f"random body {done} of {random}", done)
        for name, scene in scenes:
            results = None
            for so_far, what in explore(scene, name, integrators, errors):
                if results is None and so_far is not None:
                    results = so_far
                    found.scenes.append(results)
                bar.say(f"{name}: {what}")
            bar.advance()
    note = ""
    if bar.interrupted:
        done = f"{sum(results.complete for results in found.scenes)} of {len(scenes)} scenes"
        note = f"Interrupted after {done} and {len(found.bodies)} of {random} random bodies."
    complete = _report(found, note, out, console)
    return 0 if complete and not note else 130


def _report(found: Study, note: str, out: Path, console: Console) -> bool:
    """Print and write; whether all figures are there."""
    for error in (error for error in report.SHORT_HEADINGS if error in found.errors):
        console.print(report.short_table(found, error))
        console.print()
    if summary := report.summary(found):
        console.print(report.target_table(found))
        console.print(f"{summary}.")
    for sentence in (*report.advice(found), note):
        if sentence:
            console.print(sentence, highlight=False, soft_wrap=True)
    tables = {"study": report.points_csv(found), "bodies": report.bodies_csv(found)}
    packages = ["scikit-sundae"] if solvers.has_cvode() else []
    return write_report(out, "study", report.sections(found, note), tables, console, packages)
