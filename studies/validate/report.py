"""The results as a table in the terminal, as Markdown and as CSV."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table

from ..reporting import output
from .results import Case, Result, percent

HEADINGS = ("quantity", "exact", "softrod", "error", "slope", "target", "")
ALIGN = "lrrrrll"
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
    return output.table(HEADINGS, map(cells, results), ALIGN, case.title)


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
    return output.page(
        "# softrod against exact results",
        "Written by `softrod validate --out DIR`. Errors are softrod less exact, in parts of the exact value "
        "unless a unit is given. A slope is the power with which the error goes with the spacing, the step, "
        "the tolerance or the softness; the error beside it is that at the smallest of those.",
        f"**{summary(found)}.**{' ' + note if note else ''}",
        "\n".join(
            f"- Missed: {case.title}, {r.quantity}: {cells(r)[3]} (target {r.target})" for case, r in missed
        ),
        output.captioned(figures),
        *(
            f"## {case.title}\n\n{case.notes}\n\n{output.grid(HEADINGS, map(cells, results), ALIGN)}"
            for case, results in found
        ),
    )


def as_csv(found: Found) -> str:
    """One line for each result, numbers with all their digits; the error is relative where it has no unit."""
    headings = ("case", "quantity", "exact", "softrod", "error", "unit", "slope", "target", "met")
    rows = (
        (
            case.key, r.quantity, r.exact, r.softrod, r.error, r.unit, r.slope, r.target,
            str(r.met).lower() if r.target else "",
        )
        for case, results in found
        for r in results
    )  # fmt: skip
    return output.comma_separated(headings, rows)
