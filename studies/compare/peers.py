"""`softrod bench peers`: softrod and what one would take instead, on the same scenes."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from rich.console import Console

import sim

from ..reporting.progress import ProgressBar
from ..reporting.report import csv_of_records, make_folder, write_report
from . import peers_report as report
from .contenders import ENGINES
from .engine import Engine
from .heaps import judge_heap
from .measure import Contender, Judge, Timing, against, measure
from .references import reference
from .runs import OF_ALL_THREADS, PATIENCE, SECONDS, Point
from .scenes import COUNT, HEAP_SECONDS, HEAPS, MANY, NAMES, PATHS, ropes

QUICK = ("rope-12", "net-100-soft", "heap-120")
"""The scenes of a quick run."""

SHORT = 0.2
"""Seconds of computing per simulated second; longer runs are timed only once."""


def known(what: str, names: str, all_names: Sequence[str]) -> list[str]:
    """Return names out of "a,b"; all of them for an empty text.

    Raises:
        sim.InputError: there is none of that name.
    """
    found = [name.strip() for name in names.split(",")] if names else list(all_names)
    for name in found:
        if name not in all_names:
            raise sim.InputError(f"--{what}: {name!r} is not one of {', '.join(all_names)}")
    return list(dict.fromkeys(found))


def contenders_of(engine: Engine, name: str) -> list[Contender]:
    """Return what an engine does with a scene; nothing where it takes no part."""
    if name == MANY:
        return engine.many(ropes(COUNT)) if engine.many else []
    make, scenes = (engine.heaps, HEAPS) if name in HEAPS else (engine.paths, PATHS)
    return make(scenes[name].make()) if make else []


def bench_peers(
    scenes: str, engines: str, quick: bool, repeats: int, out: Path | None, console: Console
) -> int:
    """Measure, print the results and write the report.

    Ctrl-C ends it early; what is done by then is written.

    Args:
        scenes: names separated by commas; empty for all.
        engines: names separated by commas; empty for all.
        quick: whether only `QUICK` scenes are measured, with fewer repeats.
        repeats: turns of timing of short runs.
        out: folder for the report, or None: peers.md, peers.csv.gz and figures.
        console: for tables and progress.

    Returns:
        The exit status: 0, or 130 if it was interrupted.

    Raises:
        sim.InputError: a name is unknown, or the folder cannot be made.
    """
    scene_names = known("scenes", scenes, tuple(NAMES)) if scenes or not quick else list(QUICK)
    chosen = [ENGINES[name] for name in known("engines", engines, tuple(ENGINES))]
    if out is not None:
        make_folder(out)
    missing = {engine.name: engine.missing() for engine in chosen}
    lacking = [f"{name} is missing: {why} (`uv sync --extra peers`)." for name, why in missing.items() if why]
    for sentence in lacking:
        console.print(sentence)
    turns = min(repeats, 2) if quick else repeats
    points: list[Point] = []
    done = 0
    with ProgressBar(console, len(scene_names)) as bar:
        for name in scene_names:
            contenders = (
                each for engine in chosen if not missing[engine.name] for each in contenders_of(engine, name)
            )
            before, found = list(points), []
            for found, what in measure(name, contenders, _judge(name), _timing(name, turns)):
                points = before + found
                bar.say(f"{name}: {what}")
            done += 1
            bar.advance()
            bar.print(report.scene_table(name, found, settings=False))
    note = f"Interrupted after {done} of {len(scene_names)} scenes." if bar.interrupted else ""
    if note:
        console.print(note)
    if out is not None:
        sections = report.sections(points, lacking, note)
        packages = dict.fromkeys(each for engine in ENGINES.values() for each in engine.packages)
        tables = {"peers": csv_of_records(Point, points, report.COLUMNS)}
        installed = [each for each in packages if _is_installed(each)]
        if not write_report(out, "peers", sections, tables, console, installed):
            return 130
    return 130 if bar.interrupted else 0


def _judge(name: str) -> Judge:
    return judge_heap(HEAPS[name].make()) if name in HEAPS else against(reference(name)[None])


def _timing(name: str, turns: int) -> Timing:
    return Timing(
        turns=lambda point: turns if point.seconds <= SHORT else 1,
        clocks=OF_ALL_THREADS,
        duration=HEAP_SECONDS if name in HEAPS else SECONDS,
        patience=PATIENCE,
    )


def _is_installed(name: str) -> bool:
    try:
        version(name)
    except PackageNotFoundError:
        return False
    return True
