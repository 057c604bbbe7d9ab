"""`softrod validate`: the solver held against exact results."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from ..reporting.output import Watch, make_folder, write_figures, write_page, write_table
from . import energy, motion, report, statics, surroundings, trusses
from .results import Case, Result

CASES: tuple[Case, ...] = (
    *statics.CASES,
    *trusses.CASES,
    *motion.CASES,
    *energy.CASES,
    *surroundings.CASES,
)


def validate(out: Path | None, fast: bool, console: Console, cases: tuple[Case, ...] = CASES) -> int:
    """Run all cases, print what came out and, if wanted, write it.

    Ctrl-C ends it early; what is done by then is printed and written.

    Args:
        out: folder for `validate.md`, `validate.csv.gz` and the figures, or None; made if its parent exists.
        fast: leave out what takes long.
        console: where the tables and the progress go.
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
    figures: list[tuple[str, str]] = []
    with Watch(console, len(cases)) as watch:
        for case in cases:
            watch.say(case.title)
            results: list[Result] = []
            found.append((case, results))
            for result in case.run(fast):
                results.append(result)
                watch.say(f"{case.title}: {result.quantity}")
            complete += 1
            watch.advance()
            watch.print(report.table(case, results))
        if out is not None:
            from .figures import FIGURES

            watch.say("figures")
            figures = write_figures(out, FIGURES)
    note = "Interrupted: the figures are missing." if watch.interrupted else ""
    if complete < len(cases):
        note = f"Interrupted after {complete} of {len(cases)} cases."
    if complete < len(found):
        console.print(report.table(*found[-1]))
    console.print(f"{report.summary(found)}. {note}".strip())
    if out is not None:
        write_table(out / "validate.csv.gz", report.as_csv(found))
        write_page(out / "validate.md", report.markdown(found, figures, note))
        console.print(f"written to {out}")
    if note:
        return 130
    return 0 if all(result.met for _, results in found for result in results) else 1
