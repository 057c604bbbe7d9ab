"""The results as a table in the terminal, as Markdown and as CSV."""

from __future__ import annotations

import csv
import datetime
import io
import os
import platform
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from rich.table import Table

from .results import Case, Result, percent

HEADINGS = ("quantity", "exact", "softrod", "error", "slope", "target", "")
Found = Sequence[tuple[Case, Sequence[Result]]]
"""The cases that were run, and what came out."""


def cells(result: Result) -> tuple[str, ...]:
    """The cells of one line."""
    error = ""
    if result.error is not None:
        error = f"{result.error:.2g} {result.unit}" if result.unit else percent(result.error)
    return (
        result.quantity,
        "" if result.exact is None else f"{result.exact:.6g}",
        "" if result.softrod is None else f"{result.softrod:.6g}",
        error,
        "" if result.slope is None else f"{result.slope:.2f}",
        result.target,
        "" if not result.target else "met" if result.met else "missed",
    )


def table(case: Case, results: Sequence[Result]) -> Table:
    """The results of one case, for the terminal."""
    shown = Table(title=case.title, title_justify="left", title_style="bold", box=None, padding=(0, 2, 0, 0))
    for heading in HEADINGS:
        shown.add_column(
            heading, justify="right" if heading in ("exact", "softrod", "error", "slope") else "left"
        )
    for result in results:
        shown.add_row(*cells(result), style="" if result.met else "bold red")
    return shown


def summary(found: Found) -> str:
    """How many targets are met."""
    asked = [result for _, results in found for result in results if result.target]
    met = sum(result.met for result in asked)
    return f"{met} of {len(asked)} targets met"


def markdown(found: Found, figures: Sequence[tuple[str, str]], note: str) -> str:
    """A page with everything.

    Args:
        found: the results.
        figures: (name without ending, caption) of each figure beside the page.
        note: what else there is to say, such as that it is not complete; empty for nothing.
    """
    missed = [(case, r) for case, results in found for r in results if not r.met]
    lines = [
        "# softrod against exact results",
        "",
        "Written by `softrod validate --out DIR`. Errors are softrod less exact, in parts of the exact value "
        "unless a unit is given. A slope is the power with which the error goes with the spacing, the step, "
        "the tolerance or the softness; the error beside it is that at the smallest of those.",
        "",
        f"**{summary(found)}.**{' ' + note if note else ''}",
        "",
        *(f"- Missed: {case.title}, {r.quantity}: {cells(r)[3]} (target {r.target})" for case, r in missed),
        *([""] if missed else []),
    ]
    for name, caption in figures:
        lines += [f"![{caption}]({name}.png)", "", f"*{caption}*", ""]
    for case, results in found:
        lines += [f"## {case.title}", "", case.notes, ""]
        lines += [
            "| quantity | exact | softrod | error | slope | target | |",
            "|---|--:|--:|--:|--:|---|---|",
            *("| " + " | ".join(cell.replace("|", "\\|") for cell in cells(r)) + " |" for r in results),
            "",
        ]
    return "\n".join([*lines, provenance(), ""])


def as_csv(found: Found) -> str:
    """One line for each result, numbers with all their digits; the error is relative where it has no unit."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("case", "quantity", "exact", "softrod", "error", "unit", "slope", "target", "met"))
    for case, results in found:
        for r in results:
            numbers = ["" if n is None else f"{n:.17g}" for n in (r.exact, r.softrod, r.error)]
            slope = "" if r.slope is None else f"{r.slope:.17g}"
            met = str(r.met).lower() if r.target else ""
            writer.writerow((case.key, r.quantity, *numbers, r.unit, slope, r.target, met))
    return text.getvalue()


def provenance(*more: str) -> str:
    """What the results were computed with: processor, versions (also of `more` packages), date."""
    versions = ", ".join(f"{name} {version(name)}" for name in ("softrod", "numpy", "numba", "scipy", *more))
    today = datetime.date.today().isoformat()
    return f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}, {versions}; {today}"


def _processor() -> str:
    """The processor's name, as far as the system tells it."""
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
