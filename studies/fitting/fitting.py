"""`softrod fit`: prints and writes the result of a fit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import msgspec
from rich.console import Console

import sim
from sim.design.estimates import Estimate
from sim.design.fit import Fit
from sim.store.files import safe_name

from ..reporting.progress import ProgressBar
from ..reporting.report import Figure, Table, csv_of, make_folder
from .plot import plot


def fit_and_report(
    scene: sim.Scene,
    data: tuple[Path, ...],
    vary: list[str],
    match: Mapping[str, str] | None,
    scale: float | None,
    out: Path | None,
    console: Console,
    decimal_comma: bool = False,
) -> int:
    """Fit a scene, print what was found and write it.

    Args:
        scene, data, vary, match, scale: arguments of `sim.fit`.
        out: folder for scene.json, values.csv and fit.png; None to write nothing.
        console: where to print.
        decimal_comma: whether values.csv has decimal commas.

    Returns:
        The exit status: 130 if Ctrl-C ended it.

    Raises:
        SceneError, InputError: those of `sim.fit`, or a file cannot be written.
    """
    if out is not None:
        make_folder(out)
    found: Fit | None = None
    with ProgressBar(console, 1.0) as bar:
        found = sim.fit(scene, list(data), vary, match, scale, bar.say)
    if found is None:
        return 130
    rows = [(each.name, each.text, f"{each.before:.4g}") for each in found.values.values()]
    console.print(Table(("number", "fitted (95 % interval)", "before"), rows, "lll"))
    for series in found.series:
        console.print(
            f"{series.file}, {series.column} as {series.quantity}: "
            f"what is left is {series.noise:.3g} {series.unit}".rstrip(),
            markup=False,
            highlight=False,
        )
    for sentence in found.sentences:
        console.print(sentence, markup=False, highlight=False)
    if out is not None:
        _write(found, scene, out, decimal_comma)
    return 0


def _write(found: Fit, scene: sim.Scene, out: Path, decimal_comma: bool) -> None:
    name = safe_name(f"{scene.name} fitted"[:60]) or "fitted"
    sim.save_scene(msgspec.structs.replace(found.scene, name=name, title=""), out / "scene.json")
    headings = ("number", "unit", "value", "low", "high", "known", "before", "in the table's unit")
    text = csv_of(headings, map(_row, found.values.values()), decimal_comma)
    (out / "values.csv").write_text(text, encoding="utf-8")
    Figure("fit", "", lambda: plot(found)).write(out)


def _row(each: Estimate) -> tuple[object, ...]:
    known = "yes" if each.known else "no"
    ends = (end if math.isfinite(end) else None for end in (each.low, each.high))
    return each.name, each.unit, each.value, *ends, known, each.before, each.also
