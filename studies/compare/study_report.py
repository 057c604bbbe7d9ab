"""The report of `softrod study`: results, targets and advice."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields

from sim.analysis.advice import Tried, recommended
from sim.solve.registry import METHODS

from ..reporting.report import Section, Table, bullets, csv_of, csv_of_records
from . import random_study
from .engines import solvers
from .figures import study_figures
from .random_study import OTHER_TOLERANCES, BodyResult, Shares, shares, shares_by_growth, shares_by_tolerance
from .results import SOLVERS, SceneResults, Study, label
from .runs import Point, auto_at, best, milliseconds

EULER = "symplectic_euler"

OWN = "study-"
"""Beginning of the names of softrod's own scenes for studies."""

TUTORIAL_TARGETS = {"study-w1": 6.5, "study-w2": 16.0, "study-w3": 3.0, "study-w4": 11.0, "study-w5": 12.0}
"""Ratio that the time of the tutorial's Euler, with its best step, has to that of `auto` at least."""

OTHERS_TARGET = 30.0
"""Ratio that the time of the best other solver has to that of `auto` at least."""

COARSE = 0.1
"""Error at which there are targets, px."""

FINE = 1e-6
"""The other error at which there are targets, px."""

WITHIN_TARGET = 0.9
"""Share of random bodies that has to end within the tolerance; none may end beyond ten times that."""


@dataclass(frozen=True)
class Target:
    """One target.

    Attributes:
        what: it is about.
        wanted, found: for people.
        met: whether it is.
    """

    what: str
    wanted: str
    found: str
    met: bool


def targets(study: Study) -> list[Target]:
    """Return all targets about which there are results."""
    rows = []
    for results in study.scenes:
        wanted = TUTORIAL_TARGETS.get(results.scene)
        if wanted is not None:
            rows += _against(results, COARSE, (EULER,), wanted, "tutorial Euler, best step")
        # Only softrod's own scenes have targets.
        for error in (COARSE, FINE) if results.scene.startswith(OWN) else ():
            if error in study.errors:
                what = f"best other solver at {error:g} px"
                rows += _against(results, error, tuple(SOLVERS), OTHERS_TARGET, what)
    for what, framed in (("one call", False), ("60 calls", True)):
        found = shares(study.bodies, framed)
        if found.counted:
            share = f"{found.counted} random bodies, {what}"
            rows.append(
                Target(
                    f"{share}: end within the tolerance",
                    f"≥ {WITHIN_TARGET:.0%}",
                    f"{found.within:.1%}",
                    found.within >= WITHIN_TARGET,
                )
            )
            beyond = f"{share}: end beyond ten times the tolerance"
            rows.append(Target(beyond, "none", str(len(found.beyond)), not found.beyond))
    return rows


def _against(
    results: SceneResults, error: float, names: Sequence[str], wanted: float, what: str
) -> list[Target]:
    """The target that `auto`, with the error as its tolerance, is so many times faster than the best of some
    methods; nothing where one of the two was not measured."""
    auto, others = auto_at(results.points, error), results.of(names)
    if auto is None or not others:
        return []
    title = f"{results.scene}: {what} / auto"
    if results.is_doubtful(error):
        return [Target(title, f"≥ {wanted:g}×", "below the doubt", False)]
    fastest = best(others, error)
    ratio = fastest.seconds / auto.seconds if fastest else math.inf
    found = f"{ratio:.3g}×" if fastest else "never reached"
    missed = auto.error > error
    if missed:
        found += f", but auto ends {auto.error:.2g} px off"
    return [Target(title, f"≥ {wanted:g}×", found, ratio >= wanted and not missed)]


# ------------------------------------------------------------------------- tables
SHORT_HEADINGS: dict[float, tuple[str, ...]] = {
    COARSE: ("scene", "auto", "in 60 calls", "its error", "tutorial Euler", "/ auto", "best other", "/ auto"),
    FINE: ("scene", "auto", "in 60 calls", "its error", "softrod's best", "best other", "/ auto"),
}
"""Headings of the short tables, by the error."""


def short_table(study: Study, error: float) -> Table:
    """Return, for each scene, `auto` with an error as its tolerance, and the best of the others within it."""
    rows = []
    for results in study.scenes:
        auto = auto_at(results.points, error)
        row = [results.scene.removeprefix(OWN), "", "", ""]
        if auto is not None:
            ends = f"{auto.error:.2g}" if math.isfinite(auto.error) else auto.failure
            row[1:] = milliseconds(auto.seconds), milliseconds(auto.framed_seconds), ends
        if error == COARSE:
            row += _fastest(results, (EULER,), error, named=False)
        else:
            row += _fastest(results, tuple(METHODS), error)[:1]
        rows.append([*row, *_fastest(results, tuple(SOLVERS), error)])
    return Table(SHORT_HEADINGS[error], rows, title=f"to {error:g} px: ms for a second; errors in px")


def _fastest(results: SceneResults, names: Sequence[str], error: float, named: bool = True) -> list[str]:
    """The time of the fastest, with its name, and how many times that of `auto` it is."""
    auto, points = auto_at(results.points, error), results.of(names)
    found = best(points, error)
    if results.is_doubtful(error):
        return ["below the doubt", ""]
    if found is None:
        return ["not reached" if points else "", ""]
    time = milliseconds(found.seconds)
    ratio = f"{found.seconds / auto.seconds:.3g}" if auto else ""
    return [f"{label(found.name)} {time}" if named else time, ratio]


def target_table(study: Study) -> Table:
    """Return the targets and whether they are met."""
    rows = [(t.what, t.wanted, t.found, "met" if t.met else "missed") for t in targets(study)]
    return Table(("target", "wanted", "found", ""), rows, "llll")


def summary(study: Study) -> str:
    """Say how many targets are met; empty where there are none, as for a scene of one's own."""
    rows = targets(study)
    return f"{sum(row.met for row in rows)} of {len(rows)} targets met" if rows else ""


def advice(study: Study) -> list[str]:
    """Return a sentence for each scene and error: what to take, and what the next best method costs."""
    return [
        f"{results.scene}, to {error:g} px: {recommended(_tried(results), error)}."
        for results in study.scenes
        for error in study.errors
    ]


def _tried(results: SceneResults) -> list[Tried]:
    """The settings of softrod's methods on a scene."""
    return [Tried(p.method, p.value, p.error, p.seconds) for p in results.of(tuple(METHODS))]


def _scene_table(results: SceneResults, errors: Sequence[float]) -> Table:
    """The fastest setting of each method within each error."""
    rows = []
    for name in dict.fromkeys(point.name for point in results.points):
        row = [label(name)]
        points = results.of((name,))
        for error in errors:
            found = best(points, error)
            if results.is_doubtful(error):
                row.append("below the doubt")
            elif found is None:
                row.append("not reached")
            else:
                is_fixed = name in METHODS and not METHODS[name].adaptive
                setting = f"dt {1e3 * found.value:.3g} ms" if is_fixed else f"tol {found.value:.2g}"
                row.append(f"{milliseconds(found.seconds)} ({setting})")
        failed = [p.failure for p in points if p.failure]
        rows.append([*row, f"{failed[-1]} ({len(failed)} settings)" if failed else ""])
    return Table(("integrator", *(f"{error:g} px" for error in errors), "failures"), rows)


# ------------------------------------------------------------------------- the page
def sections(study: Study, note: str) -> Iterator[Section]:
    """Yield the sections of the page.

    Args:
        study: the results.
        note: what else there is to say, such as that it is not complete; empty for nothing.
    """
    yield "# Computing time against error"
    yield _INTRODUCTION
    if not solvers.has_cvode():
        yield "CVODE is missing: scikit-sundae is not installed (`uv sync --extra compare`)."
    met = f"**{summary(study)}.**" if summary(study) else ""
    yield f"{met} {note}".strip()
    yield bullets(advice(study))
    yield bullets(f"Missed: {t.what}: {t.found} (target {t.wanted})" for t in targets(study) if not t.met)
    yield from study_figures(study)
    if study.scenes:
        yield "## In short"
        yield _SHORT
        for error in SHORT_HEADINGS:
            yield f"To {error:g} px:"
            yield short_table(study, error)
    if targets(study):
        yield "## Targets"
        yield target_table(study)
    for results in study.scenes:
        yield f"## {results.scene}"
        yield f"The references are {results.doubt:.1g} px apart."
        yield "" if results.complete else "Not complete."
        yield _scene_table(results, study.errors)
    if study.bodies:
        yield from _bodies(study.bodies)


_INTRODUCTION = (
    "Written by `softrod study --out DIR`. Milliseconds of computing for one simulated second, one core, "
    "the least of interleaved repeats of 2 ms or more each, against the largest position error of a mass at "
    "the end, px. "
    "Everybody solves the same equations, in machine code: softrod's methods by `Simulation.step`, SciPy's "
    "and CVODE by softrod's own forces and, where they can use one, its analytic Jacobian, with its narrow "
    "band (LSODA, CVODE) or as a dense or sparse matrix (Radau, BDF); their relative tolerance is "
    f"{solvers.RELATIVE:g} per px of the absolute one. Tables and patterns of matrices are made before the "
    "clock starts. The tutorial's Euler and other methods with fixed steps have the longest step that "
    "hindsight finds to be good enough; `auto` has no hindsight: its tolerance is the error that is asked "
    "for. Where it ends farther off than that, its target counts as missed, whatever the time."
)

_SHORT = (
    "Milliseconds of computing for a simulated second, errors in px: `auto` with the error as its tolerance, "
    "in one call and in 60 as the page does it, and the fastest of the others that ends within the same "
    "error."
)


def _bodies(bodies: Sequence[BodyResult]) -> Iterator[Section]:
    """The sections on the random bodies."""
    left_out = [body.left_out for body in bodies if body.left_out]
    reasons = "".join(f"; {why}: {left_out.count(why)}" for why in sorted(set(left_out)))
    worst = sorted((b for b in bodies if not b.left_out), key=lambda b: -b.error)[:10]
    yield "## Random bodies"
    yield (
        f"{len(bodies)} random chains, rings, trees, grids and tangles under the tutorial's and the "
        f"conservative law, one second, `auto` at {random_study.TOLERANCE:g} px. A rule that was fixed "
        "before looking, and that does not know what `auto` does, leaves out bodies that no method could "
        f"keep to a tolerance: where a nudge of the start grows more than {random_study.CHAOTIC:g} times "
        f"(chaotic), where two references at {random_study.TIGHT:g} px are more than "
        f"{random_study.UNSURE:g} px apart, or where one of them does not arrive. Left out: {len(left_out)}"
        f"{reasons}."
    )
    yield _share_table("auto", {"one call": shares(bodies), "60 calls": shares(bodies, framed=True)})
    yield (
        f"By tolerance, in one call; at others than {random_study.TOLERANCE:g} px, only bodies whose "
        f"references are no farther apart than {random_study.UNSURE_PART:.0%} of it:"
    )
    yield _share_table(
        "tolerance", {f"{found.tolerance:g} px": found for found in shares_by_tolerance(bodies)}
    )
    yield "By how much a nudge of the start grows, in 60 calls, with chaotic bodies whose references agree:"
    yield _share_table("growth", shares_by_growth(bodies, framed=True))
    headings = ("worst seeds", "body", "law", "masses", "growth of a nudge", "error, px", "in 60 calls, px")
    rows = [
        (
            str(b.seed),
            b.shape,
            b.law,
            str(b.masses),
            *(f"{n:.2g}" for n in (b.growth, b.error, b.framed_error)),
        )
        for b in worst
    ]
    yield Table(headings, rows, "lll")


def _share_table(what: str, rows: dict[str, Shares]) -> Table:
    """A row for each group that has any bodies."""
    cells = [
        (
            name,
            str(found.counted),
            f"{found.within:.1%}",
            f"{found.within_three:.1%}",
            f"{found.largest:.3g}",
            ", ".join(map(str, found.beyond)) or "none",
        )
        for name, found in rows.items()
        if found.counted
    ]
    return Table((what, "bodies", "within", "within 3×", "largest, tolerances", "seeds beyond 10×"), cells)


# ------------------------------------------------------------------------- CSV
_COLUMNS = {
    "scene": "scene",
    "integrator": "name",
    "value": "value",
    "end_error": "error",
    "path_error": "path_error",
    "seconds": "seconds",
    "framed_seconds": "framed_seconds",
    "framed_end_error": "framed_error",
    "runs": "runs",
    "failure": "failure",
}
"""Columns of study.csv, and the fields of `Point` they come from."""


def points_csv(study: Study) -> str:
    """Return a row for each setting."""
    return csv_of_records(Point, (point for results in study.scenes for point in results.points), _COLUMNS)


def bodies_csv(study: Study) -> str:
    """Return a row for each random body."""
    *names, others = (field.name for field in fields(BodyResult))
    headings = [*names, *(f"error_at_{tolerance:g}" for tolerance in OTHER_TOLERANCES)]
    rows = ((*(getattr(body, name) for name in names), *getattr(body, others)) for body in study.bodies)
    return csv_of(headings, rows)
