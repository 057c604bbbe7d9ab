"""What a study found, against its targets: as a table in the terminal, as Markdown and as CSV."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from rich.table import Table

from sim.analysis.advice import Tried, recommended
from sim.methods.registry import METHODS

from ..reporting.output import captioned, comma_separated, grid, page, table
from . import others, random_study
from .measure import FOLLOWED, Point, SceneResults, label
from .random_study import OTHER_TOLERANCES, BodyResult, Shares, shares, shares_by_growth, shares_by_tolerance

EULER = "symplectic_euler"

OWN = "study-"
"""With what the names of softrod's own scenes for studies begin."""

TUTORIAL_TARGETS = {"study-w1": 6.5, "study-w2": 16.0, "study-w3": 3.0, "study-w4": 11.0, "study-w5": 12.0}
"""How many times as long as `auto` the tutorial's Euler has to take, with the best step in hindsight."""

OTHERS_TARGET = 30.0
"""How many times as long as `auto` the best of the other solvers has to take."""

COARSE, FINE = 0.1, 1e-6
"""Errors at which there are targets, px."""

WITHIN_TARGET = 0.9
"""Share of random bodies that has to end within the tolerance; none may end beyond ten times that."""


@dataclass
class Study:
    """Results, as far as they go.

    Attributes:
        errors: that are asked about, px, from large to small.
        scenes: one for each scene that was begun.
        bodies: random ones.
    """

    errors: tuple[float, ...]
    scenes: list[SceneResults] = field(default_factory=list)
    bodies: list[BodyResult] = field(default_factory=list)


@dataclass(frozen=True)
class Target:
    """One target.

    Attributes:
        what: it is about.
        wanted, found: in words.
        met: whether it is.
    """

    what: str
    wanted: str
    found: str
    met: bool


def targets(study: Study) -> list[Target]:
    """All targets about which the results say anything."""
    rows = []
    for results in study.scenes:
        wanted = TUTORIAL_TARGETS.get(results.scene)
        if wanted is not None:
            rows += _against(results, COARSE, (EULER,), wanted, "tutorial Euler, best step")
        # Only softrod's own scenes have targets.
        for error in (COARSE, FINE) if results.scene.startswith(OWN) else ():
            if error in study.errors:
                names = [*others.SCIPY, *others.CVODE]
                rows += _against(results, error, names, OTHERS_TARGET, f"best other solver at {error:g} px")
    for what, framed in (("one call", False), ("60 calls", True)):
        found = shares(study.bodies, framed)
        if found.counted:
            share = f"{found.counted} random bodies, {what}"
            rows += [
                Target(
                    f"{share}: end within the tolerance", f"≥ {WITHIN_TARGET:.0%}", f"{found.within:.1%}",
                    found.within >= WITHIN_TARGET,
                ),
                Target(
                    f"{share}: end beyond ten times the tolerance", "none", str(len(found.beyond)),
                    not found.beyond,
                ),
            ]  # fmt: skip
    return rows


def _against(
    results: SceneResults, error: float, names: Sequence[str], wanted: float, what: str
) -> list[Target]:
    """The target that `auto`, with the error as its tolerance, is so many times faster than the best of
    others; nothing where one of them was not measured."""
    auto = results.at(FOLLOWED, error)
    if auto is None or not any(p.integrator in names for p in results.points):
        return []
    title = f"{results.scene}: {what} / auto"
    if results.doubtful(error):
        return [Target(title, f"≥ {wanted:g}×", "below the doubt", False)]
    best = results.best(names, error)
    ratio = best.seconds / auto.seconds if best else math.inf
    found = f"{ratio:.3g}×" if best else "never reached"
    missed = auto.end_error > error
    if missed:
        found += f", but auto ends {auto.end_error:.2g} px off"
    return [Target(title, f"≥ {wanted:g}×", found, ratio >= wanted and not missed)]


# ------------------------------------------------------------------------- tables
SHORT_HEADINGS: dict[float, tuple[str, ...]] = {
    COARSE: ("scene", "auto", "in 60 calls", "its error", "tutorial Euler", "/ auto", "best other", "/ auto"),
    FINE: ("scene", "auto", "in 60 calls", "its error", "softrod's best", "best other", "/ auto"),
}
"""Of the short tables, by the error."""

TARGET_HEADINGS = ("target", "wanted", "found", "")


def short_rows(study: Study, error: float) -> list[tuple[str, ...]]:
    """For each scene `auto` with an error as its tolerance, beside the best of the others within it."""
    rows = []
    for results in study.scenes:
        auto = results.at(FOLLOWED, error)
        row = [results.scene.removeprefix(OWN), _ms(auto), _ms(auto, framed=True), _px(auto)]
        row += (
            _beside(results, (EULER,), error, named=False)
            if error == COARSE
            else _beside(results, tuple(METHODS), error)[:1]
        )
        rows.append((*row, *_beside(results, (*others.SCIPY, *others.CVODE), error)))
    return rows


def _beside(results: SceneResults, names: Sequence[str], error: float, named: bool = True) -> list[str]:
    """The time of the best, with its name, and how many times that of `auto` it is."""
    auto, best = results.at(FOLLOWED, error), results.best(names, error)
    if results.doubtful(error):
        return ["below the doubt", ""]
    if best is None:
        tried = any(p.integrator in names for p in results.points)
        return ["not reached" if tried else "", ""]
    text = f"{label(best.integrator)} {_ms(best)}" if named else _ms(best)
    return [text, f"{best.seconds / auto.seconds:.3g}" if auto else ""]


def _ms(point: Point | None, framed: bool = False) -> str:
    """A time in milliseconds, three digits."""
    seconds = math.nan if point is None else point.framed_seconds if framed else point.seconds
    if point is None or math.isnan(seconds):
        return ""
    return f"{1e3 * seconds:#.3g}".rstrip(".")


def _px(point: Point | None) -> str:
    if point is None:
        return ""
    return f"{point.end_error:.2g}" if math.isfinite(point.end_error) else point.failure


def short_table(study: Study, error: float) -> Table:
    """A short table, for the terminal."""
    title = f"to {error:g} px: ms for a second; errors in px"
    return table(SHORT_HEADINGS[error], short_rows(study, error), title=title)


def target_table(study: Study) -> Table:
    """The targets, for the terminal."""
    return table(TARGET_HEADINGS, _target_rows(study), "llll")


def _target_rows(study: Study) -> list[tuple[str, ...]]:
    return [(t.what, t.wanted, t.found, "met" if t.met else "missed") for t in targets(study)]


def summary(study: Study) -> str:
    """How many targets are met; empty where there are none, as for a scene of one's own."""
    rows = targets(study)
    return f"{sum(row.met for row in rows)} of {len(rows)} targets met" if rows else ""


def advice(study: Study) -> list[str]:
    """What to take for each scene and each error, and what the next best method costs: a sentence each."""
    return [
        f"{results.scene}, to {error:g} px: {recommended(_tried(results), error)}."
        for results in study.scenes
        for error in study.errors
    ]


def _tried(results: SceneResults) -> list[Tried]:
    """What was tried of softrod's methods on a scene."""
    return [
        Tried(point.integrator, point.value, point.end_error, point.seconds)
        for point in results.points
        if point.integrator in METHODS
    ]


def _scene_rows(results: SceneResults, errors: Sequence[float]) -> list[list[str]]:
    rows = []
    for name in dict.fromkeys(point.integrator for point in results.points):
        row = [label(name)]
        for error in errors:
            best = results.best((name,), error)
            if results.doubtful(error):
                row.append("below the doubt")
            elif best is None:
                row.append("not reached")
            else:
                fixed = name in METHODS and not METHODS[name].adaptive
                setting = f"dt {1e3 * best.value:.3g} ms" if fixed else f"tol {best.value:.2g}"
                row.append(f"{_ms(best)} ({setting})")
        failed = [p.failure for p in results.points if p.integrator == name and p.failure]
        row.append(f"{failed[-1]} ({len(failed)} settings)" if failed else "")
        rows.append(row)
    return rows


def markdown(study: Study, figures: Sequence[tuple[str, str]], note: str) -> str:
    """A page with everything.

    Args:
        study: the results.
        figures: (name without ending, caption) of each figure beside the page.
        note: what else there is to say, such as that it is not complete; empty for nothing.
    """
    blocks = ["# Computing time against error", _INTRODUCTION]
    if not others.has_cvode():
        blocks.append("CVODE is missing: scikit-sundae is not installed (`uv sync --extra compare`).")
    met = f"**{summary(study)}.**" if summary(study) else ""
    blocks.append(f"{met} {note}".strip())
    blocks.append("\n".join(f"- {sentence}" for sentence in advice(study)))
    missed = [target for target in targets(study) if not target.met]
    blocks.append("\n".join(f"- Missed: {t.what}: {t.found} (target {t.wanted})" for t in missed))
    blocks.append(captioned(figures))
    if study.scenes:
        blocks += ["## In short", _SHORT]
        for error, headings in SHORT_HEADINGS.items():
            blocks += [f"To {error:g} px:", grid(headings, short_rows(study, error))]
    if rows := _target_rows(study):
        blocks += ["## Targets", grid(TARGET_HEADINGS, rows, "llll")]
    for results in study.scenes:
        headings = ("integrator", *(f"{error:g} px" for error in study.errors), "failures")
        blocks += [f"## {results.scene}", f"The references are {results.doubt:.1g} px apart."]
        blocks += ["Not complete."] if not results.complete else []
        blocks.append(grid(headings, _scene_rows(results, study.errors)))
    blocks += _bodies(study.bodies) if study.bodies else []
    return page(*blocks, more=["scikit-sundae"] if others.has_cvode() else [])


_INTRODUCTION = (
    "Written by `softrod study --out DIR`. Milliseconds of computing for one simulated second, one core, "
    "the least of interleaved repeats of 2 ms or more each, against the largest position error of a mass at "
    "the end, px. "
    "Everybody solves the same equations, in machine code: softrod's methods by `Simulation.step`, SciPy's "
    "and CVODE by softrod's own forces and, where they can use one, its analytic Jacobian, with its narrow "
    "band (LSODA, CVODE) or as a dense or sparse matrix (Radau, BDF); their relative tolerance is "
    f"{others.RELATIVE:g} per px of the absolute one. Tables and patterns of matrices are made before the "
    "clock starts. The tutorial's Euler and other methods with fixed steps have the longest step that "
    "hindsight finds to be good enough; `auto` has no hindsight: its tolerance is the error that is asked "
    "for. Where it ends farther off than that, its target counts as missed, whatever the time."
)

_SHORT = (
    "Milliseconds of computing for a simulated second, errors in px: `auto` with the error as its tolerance, "
    "in one call and in 60 as the page does it, and beside it the fastest that ends within the same error."
)


def _bodies(bodies: Sequence[BodyResult]) -> list[str]:
    """What came of the random bodies."""
    left_out = [body for body in bodies if body.left_out]
    reasons = {
        reason: sum(b.left_out == reason for b in left_out) for reason in {b.left_out for b in left_out}
    }
    headings = ("bodies", "within", "within 3×", "largest, tolerances", "seeds beyond 10×")
    by_tolerance = {f"{found.tolerance:g} px": found for found in shares_by_tolerance(bodies)}
    worst = sorted((b for b in bodies if not b.left_out), key=lambda b: -b.error)[:10]
    cells = [
        (
            str(b.seed), b.shape, b.law, str(b.masses), f"{b.growth:.2g}", f"{b.error:.2g}",
            f"{b.framed_error:.2g}",
        )
        for b in worst
    ]  # fmt: skip
    return [
        "## Random bodies",
        f"{len(bodies)} random chains, rings, trees, grids and tangles under the tutorial's and the "
        f"conservative law, one second, `auto` at {random_study.TOLERANCE:g} px. A rule that was fixed "
        "before looking, and that does not know what `auto` does, leaves out bodies that no method could "
        f"keep to a tolerance: where a nudge of the start grows more than {random_study.CHAOTIC:g} times "
        f"(chaotic), where two references at {random_study.TIGHT:g} px are more than "
        f"{random_study.UNSURE:g} px apart, or where one of them does not arrive. Left out: {len(left_out)}"
        + "".join(f"; {reason}: {count}" for reason, count in sorted(reasons.items()))
        + ".",
        _share_grid(
            ("auto", *headings), {"one call": shares(bodies), "60 calls": shares(bodies, framed=True)}
        ),
        f"By tolerance, in one call; at others than {random_study.TOLERANCE:g} px, only bodies whose "
        f"references are no farther apart than {random_study.UNSURE_PART:.0%} of it:",
        _share_grid(("tolerance", *headings), by_tolerance),
        "By how much a nudge of the start grows, in 60 calls, with chaotic bodies whose references agree:",
        _share_grid(("growth", *headings), shares_by_growth(bodies, framed=True)),
        grid(
            ("worst seeds", "body", "law", "masses", "growth of a nudge", "error, px", "in 60 calls, px"),
            cells,
            "lll",
        ),
    ]


def _share_grid(headings: Sequence[str], rows: dict[str, Shares]) -> str:
    """A line for each that has any bodies."""
    cells = [
        (
            what, str(found.counted), f"{found.within:.1%}", f"{found.within_three:.1%}",
            f"{found.largest:.3g}", ", ".join(map(str, found.beyond)) or "none",
        )
        for what, found in rows.items()
        if found.counted
    ]  # fmt: skip
    return grid(headings, cells)


# ------------------------------------------------------------------------- CSV
def points_csv(study: Study) -> str:
    """One line for each setting, numbers with all their digits."""
    points = [point for results in study.scenes for point in results.points]
    names = [field.name for field in dataclasses.fields(Point)]
    return comma_separated(names, ([getattr(point, name) for name in names] for point in points))


def bodies_csv(study: Study) -> str:
    """One line for each random body."""
    *names, others = (field.name for field in dataclasses.fields(BodyResult))
    headings = [*names, *(f"error_at_{tolerance:g}" for tolerance in OTHER_TOLERANCES)]
    values = ((*(getattr(body, name) for name in names), *getattr(body, others)) for body in study.bodies)
    return comma_separated(headings, values)
