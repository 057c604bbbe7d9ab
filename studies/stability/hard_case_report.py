"""`softrod stability --hard-cases`: how every integrator ends on scenes that are hard on it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray
from rich.console import Console

from sim import Energies, Simulation
from sim.solve.registry import METHODS

from ..reporting.progress import ProgressBar
from ..reporting.report import Section, Table, bullets, csv_of, make_folder, write_report
from .hard_cases import HardCase, hard_cases, long_rods

FRAMES = 40
"""Frames of a sixtieth of a second; where the time step is longer, three steps."""

MAX_ATTEMPTS = 4000
"""Steps that a method may attempt in a sixtieth of a second before the clock lags."""

REFERENCES = (("adams", 1e-2), ("rodas5p", 1e-4))
"""Methods, and their tolerances in those of the case, whose agreement makes a reference.
Where a rope unfolds, Rosenbrock's error is a third of the case's tolerance at a hundredth of it; and DOP853,
whose steps are limited by stability alone in very stiff bodies, sometimes ends several tolerances off."""

LONG_REFERENCES = (("auto", 1e-2), ("auto", 1e-1))
"""The same for long rods, which no other method gets through in time."""

AGREED = 0.2
"""Largest distance between the two, in tolerances of the case, that counts as agreement."""

MAX_REFERENCE_ATTEMPTS = 40_000
"""Steps that a reference may attempt in a sixtieth of a second; one that needs more is none."""

MIN_MADE = 0.1
"""Energy made by a method, in parts of all energy converted, from which on the report mentions it."""


@dataclass(frozen=True)
class Ending:
    """How a run ended.

    Attributes:
        stopped: the time at which it gave up, s, or None.
        behind: seconds that the clock lags.
        made: energy beyond all that was put in, in parts of what was converted; NaN if it gave up.
        positions: (n, 2) px, at the end.
        error: distance from the reference, in tolerances; NaN without a reference.
        fallbacks: fallback steps.
    """

    stopped: float | None
    behind: float
    made: float
    positions: NDArray[np.float64]
    fallbacks: int
    error: float = math.nan

    @property
    def survived(self) -> bool:
        """Whether it reached the end, late by a frame at most."""
        return self.stopped is None and self.behind <= 1.0 / 60.0

    def __str__(self) -> str:
        if self.stopped is not None:
            return f"gave up at {self.stopped:.3g} s"
        words = []
        if self.behind > 0.0:
            words.append(f"lagged {self.behind:.2g} s")
        elif math.isfinite(self.error):
            words.append(f"{self.error:.2g} tol" if self.error < 1e4 else f"{self.error:.0e} tol")
        else:
            words.append("ran")
        if self.made > MIN_MADE:
            words.append(f"made {100.0 * self.made:.0f} % energy" if self.made < 10.0 else "made energy")
        if self.fallbacks:
            words.append(f"{self.fallbacks} fallback steps")
        return ", ".join(words)


def run(
    case: HardCase, method: str, tolerance: float = 1.0, attempts: int = MAX_ATTEMPTS, tracks: bool = True
) -> Ending:
    """Run a case by a method.

    Args:
        tolerance: in those of the case.
        attempts: per sixtieth of a second.
        tracks: whether to track the energy.
    """
    asked = case.scene.integrator
    integrator = replace(asked, method=method, tolerance=tolerance * asked.tolerance)
    simulation = Simulation(replace(case.scene, integrator=integrator))
    simulation.track_energy(tracks)
    behind = fallbacks = 0
    for missing in frames_of(case, simulation, attempts):
        behind += missing
        fallbacks += simulation.stats().fallbacks
    stopped = simulation.time if simulation.divergence is not None else None
    made = (
        _energy_made(simulation.energy(), _tolerated_energy(case)) if tracks and stopped is None else math.nan
    )
    late = behind * simulation.dt if stopped is None else 0.0
    return Ending(stopped, late, made, simulation.positions, fallbacks)


def frames_of(case: HardCase, simulation: Simulation, attempts: int = MAX_ATTEMPTS) -> Iterator[int]:
    """Run a case frame by frame, to its end or until it stops; yield the missing steps of each frame."""
    rng = np.random.default_rng(0)
    steps = max(1, round(1.0 / 60.0 / simulation.dt))
    frames, share = (FRAMES, 1) if steps > 1 else (3, 60)
    for frame in range(frames):
        case.act(simulation, frame, rng)
        yield steps - simulation.step(steps, attempts=attempts * share)
        if simulation.divergence is not None:
            return


def _tolerated_energy(case: HardCase) -> float:
    """Return the energy of an error of the tolerance, in height and the stiffest spring, kg px²/s²."""
    scene, tolerance = case.scene, case.scene.integrator.tolerance
    weight = sum(m.mass for m in scene.masses) * math.hypot(*scene.gravity)
    stiffest = max((s.stiffness for s in scene.linear_springs), default=0.0)
    return weight * tolerance + 0.5 * stiffest * tolerance**2


def _energy_made(balance: Energies, tolerated: float) -> float:
    """Return the energy beyond all that was put in and tolerated, over what was converted."""
    # What damping and air took counts as negative in the balance, and the residual leaves it out.
    beyond = balance.residual + balance.damping + balance.air - tolerated
    converted = balance.kinetic + balance.linear + balance.angular
    converted += abs(balance.anchors) + abs(balance.keys) + abs(balance.changes)
    return max(beyond, 0.0) / converted if converted > 0.0 else 0.0


def reference(case: HardCase, strict: Sequence[tuple[str, float]] = REFERENCES) -> NDArray[np.float64] | None:
    """Return the positions at the end, px, or None if two strict methods do not agree about them."""
    ends = []
    for method, tolerance in strict:
        outcome = run(case, method, tolerance, MAX_REFERENCE_ATTEMPTS, tracks=False)
        if not outcome.survived or outcome.fallbacks:
            return None
        ends.append(outcome.positions)
    return ends[0] if _apart(*ends) <= AGREED * case.scene.integrator.tolerance else None


def _apart(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    return float(np.hypot(*(one - other).T).max())


Row = dict[str, Ending]


def hard_case_report(out: Path, console: Console, only: Sequence[str] = ()) -> int:
    """Run all cases by all integrators, and write `hard-cases.md` and `hard-cases.csv.gz`.

    Ctrl-C ends it early; the cases that are done by then are written.

    Args:
        out: folder; made if its parent exists.
        console: where the progress and the result go.
        only: names of cases to run; none for all.

    Returns:
        The exit status: 0 if `auto` survived all, 1 if not, 130 if it was interrupted.

    Raises:
        InputError: the folder cannot be written to.
    """
    make_folder(out)
    long = long_rods()
    cases = {name: case for name, case in {**hard_cases(), **long}.items() if not only or name in only}
    rows: dict[str, Row] = {}
    known: dict[str, bool] = {}
    with ProgressBar(console, len(cases)) as bar:
        for name, case in cases.items():
            bar.say(f"{name}: reference")
            end = reference(case, LONG_REFERENCES if name in long else REFERENCES)
            row: Row = {}
            for method in ("auto",) if name in long else METHODS:
                bar.say(f"{name}: {method}")
                # The balance takes the work of an anchor from too few looks at a long rod's vibrations.
                outcome = run(case, method, tracks=name not in long)
                if end is not None and outcome.survived:
                    error = _apart(outcome.positions, end) / case.scene.integrator.tolerance
                    outcome = dataclasses.replace(outcome, error=error)
                row[method] = outcome
            rows[name], known[name] = row, end is not None
            bar.advance()
    note = f"Interrupted after {len(rows)} of {len(cases)} cases." if bar.interrupted else ""
    console.print(f"{summary(rows)} {note}".strip())
    tables = {"hard-cases": as_csv(rows)}
    write_report(out, "hard-cases", sections(rows, known, note), tables, console)
    if note:
        return 130
    return 0 if all(row["auto"].survived for row in rows.values()) else 1


def summary(rows: dict[str, Row]) -> str:
    """Say how many cases each method survives."""
    counts = []
    for method in METHODS:
        ran = [row[method] for row in rows.values() if method in row]
        counts.append(f"{method} {sum(o.survived for o in ran)} of {len(ran)}")
    return f"Cases survived: {', '.join(counts)}."


def as_csv(rows: dict[str, Row]) -> str:
    """Return a row for each case and method."""
    lines = []
    for name, row in rows.items():
        for method, o in row.items():
            numbers = (math.nan if o.stopped is None else o.stopped, o.behind, o.error, o.made)
            lines.append(
                (name, method, *(f"{n:.6g}" if math.isfinite(n) else "" for n in numbers), o.fallbacks)
            )
    return csv_of(
        ("case", "method", "gave_up_at", "behind", "error_in_tolerances", "energy_made", "last_resorts"),
        lines,
    )


def sections(rows: dict[str, Row], known: dict[str, bool], note: str) -> Iterator[Section]:
    """Yield the sections of the page: a row for each case, a column for each method."""
    strict = " and ".join(f"{method}, with {part:g} of the tolerance," for method, part in REFERENCES)
    yield "# Hard cases"
    yield (
        "Written by `softrod stability --hard-cases --out DIR`. The tutorial's rope of twelve masses, let go "
        f"horizontally unless the case says otherwise, for {FRAMES} frames of a sixtieth of a second (three "
        "steps where a step is a second), under the conservative law, with the default step and tolerance. "
        "Long rods are for `auto` only; their reference is `auto` under stricter tolerances; their energy "
        "is not judged."
    )
    yield bullets(
        (
            "**… tol**: it ran; the largest distance of a mass from the reference at the end, in tolerances. "
            f"A reference is where {strict} agree to {AGREED:g} of it;",
            "**ran**: it ran, and there is no reference: the motion is chaotic, or no strict method gets "
            "through;",
            "**gave up at**: it ran away, or found no way on, and stopped at its last good state;",
            f"**lagged**: it ran out of attempts, {MAX_ATTEMPTS} in a frame, and the clock is that much "
            "behind; up to a frame counts as surviving;",
            "**made energy**: at the end it has more energy than was ever put in, by more than "
            f"{100.0 * MIN_MADE:g} % of what was turned over;",
            "**fallback steps**: steps in which no method could go on, and a strongly damped one was taken.",
        )
    )
    yield f"**{summary(rows)}** {note}".strip()
    cells = [
        (name, "yes" if known[name] else "no", *(str(row.get(method, "")) for method in METHODS))
        for name, row in rows.items()
    ]
    headings = ("case", "reference", *METHODS)
    yield Table(headings, cells, "l" * len(headings))
