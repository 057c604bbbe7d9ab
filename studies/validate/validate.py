"""`softrod validate`: the solver compared with exact results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from rich.console import Console

from ..reporting.progress import ProgressBar
from ..reporting.report import Section, Table, bullets, csv_of, make_folder, write_report
from . import energy, figures, motion, statics, surroundings, trusses
from .results import Case, Result, percent

CASES: tuple[Case, ...] = (
    *statics.CASES,
    *trusses.CASES,
    *motion.CASES,
    *energy.CASES,
    *surroundings.CASES,
)

Found = Sequence[tuple[Case, Sequence[Result]]]
"""The cases that were run, and their results."""


def validate(out: Path | None, fast: bool, console: Console, cases: tuple[Case, ...] = CASES) -> int:
    """Run all cases, print the results and, if wanted, write them.

    Ctrl-C ends it early; what is done by then is printed and written.

    Args:
        out: folder for `validate.md`, `validate.csv.gz` and the figures, or None; made if its parent exists.
        fast: leave out what takes long.
        console: for tables and progress.
        cases: what to run.

    Returns:
        The exit status: 0 if all targets are met, 1 if one is missed, 130 if it was interrupted.

    Raises:
        InputError: the folder cannot be made or written to.
    """
    if out is not None:
        make_folder(out)
    found: list[tuple[Case, list[Result]]] = []
    complete = 0
    with ProgressBar(console, len(cases)) as bar:
        for case in cases:
            bar.say(case.title)
            results: list[Result] = []
            found.append((case, results))
            for result in case.run(fast):
                results.append(result)
                bar.say(f"{case.title}: {result.quantity}")
            complete += 1
            bar.advance()
            bar.print(case_table(case, results))
    note = "" if complete == len(cases) else f"Interrupted after {complete} of {len(cases)} cases."
    if complete < len(found):
        console.print(case_table(*found[-1]))
    console.print(f"{summary(found)}. {note}".strip())
    interrupted = bool(note)
    if out is not None:
        tables = {"validate": as_csv(found)}
        interrupted |= not write_report(out, "validate", sections(found, note), tables, console)
    if interrupted:
        return 130
    return 0 if all(result.met for _, results in found for result in results) else 1


# ------------------------------------------------------------------------- the report
def case_table(case: Case, results: Sequence[Result]) -> Table:
    """Return the results of one case."""
    headings = ("quantity", "exact", "softrod", "error", "slope", "target", "")
    return Table(headings, [_cells(result) for result in results], "lrrrrll", case.title)


def _cells(result: Result) -> tuple[str, ...]:
    return (
        result.quantity,
        "" if result.exact is None else f"{result.exact:.6g}",
        "" if result.softrod is None else f"{result.softrod:.6g}",
        _error(result),
        "" if result.slope is None else f"{result.slope:.2f}",
        result.target,
        "" if not result.target else "met" if result.met else "missed",
    )


def _error(result: Result) -> str:
    if result.error is None:
        return ""
    return f"{result.error:.2g} {result.unit}" if result.unit else percent(result.error)


def summary(found: Found) -> str:
    """Say how many targets are met."""
    asked = [result for _, results in found for result in results if result.target]
    return f"{sum(result.met for result in asked)} of {len(asked)} targets met"


def sections(found: Found, note: str) -> Iterator[Section]:
    """Yield the sections of the page.

    Args:
        found: the results.
        note: what else there is to say, such as that it is not complete; empty for nothing.
    """
    yield "# softrod against exact results"
    yield (
        "Written by `softrod validate --out DIR`. Errors are softrod less exact, in parts of the exact value "
        "unless a unit is given. A slope is the power with which the error goes with the spacing, the step, "
        "the tolerance or the softness; the error beside it is that at the smallest of those."
    )
    yield f"**{summary(found)}.** {note}".strip()
    missed = [(case, result) for case, results in found for result in results if not result.met]
    yield bullets(
        f"Missed: {case.title}, {result.quantity}: {_error(result)} (target {result.target})"
        for case, result in missed
    )
    yield from () if note else figures.FIGURES
    for case, results in found:
        yield f"## {case.title}"
        yield case.notes
        yield case_table(case, results)


def as_csv(found: Found) -> str:
    """Return a row for each result; the error is relative where it has no unit."""
    headings = ("case", "quantity", "exact", "softrod", "error", "unit", "slope", "target", "met")
    return csv_of(
        headings,
        (
            (case.key, *(getattr(result, name) for name in headings[1:-1]), _met(result))
            for case, results in found
            for result in results
        ),
    )


def _met(result: Result) -> str:
    return str(result.met).lower() if result.target else ""
