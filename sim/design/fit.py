"""The numbers of a scene with which it moves as something that was measured.

What was measured, d, is compared with d(u) of a run of the scene (`residuals`), where u are the unknowns:
logarithms of what is positive, and others as parts of a typical size. Of all u the one is sought for which
the sum of ((d - d(u)) / s)² is least, where s is the noise of each column, which is estimated from what is
left. The derivatives J of the residuals by u are differences of runs.

Residuals that hang together count as fewer: with the correlation r of neighbours, n of them count as
n (1 - r) / (1 + r) (the effective sample size of an autoregressive process of order 1). The singular value
decomposition J = U S Vᵀ then gives for each direction v of u how well it is known: to 1 / s. Directions that
are known to less than a factor of about e are what the data cannot tell; `estimates` says it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..scene.types import Scene
from ..scene.validate import validate
from .estimates import Estimate, Identifiability, Series, at_ends, autocorrelated
from .measurements import Measurement, read_measurements
from .residuals import Problem

Floats = NDArray[np.float64]

_CONFIDENCE = 0.95
_STEP = 3e-4
"""Step of u for a difference."""
_UNKNOWN = 0.5
"""Uncertainty of u from which on a direction counts as unknown."""
_RANK = 1e-5
"""Slope along a direction, as a part of those of the unknowns in it, below which it is the error of
differences."""
_ELSEWHERE = math.log(4.0)
"""How far from the scene's numbers other starts are."""
_STARTS = 32
"""Number of other starts that are looked at."""
_TRIED = 3
"""Number of starts that are followed."""
_WINDOWS = (0.25, 0.5, 1.0)
"""Parts of the rows that are fitted one after another, so that no swing is mistaken for the next."""
_ROUNDS = 60
"""Largest number of steps towards the least sum of squares."""
_AS_GOOD = 0.01
"""Rise of the sum of squares that is none."""
_GIVING_WAY = 5
"""Largest number of steps in which unknowns give way to others that are held."""
_FAR = 0.1
"""Least noise of a column that is assumed at first, as a part of how far off the scene is."""
_NOISELESS = 1e-7
"""Smallest noise of a column, as a part of its range."""


@dataclass(frozen=True, eq=False)
class Fit:
    """What `fit` found.

    Attributes:
        scene: the scene with the numbers, and the start, of the best fit.
        values: of each number that was varied, by its name.
        series: of each column, measured and fitted.
        sentences: what else there is to know, in words.
    """

    scene: Scene
    values: Mapping[str, Estimate]
    series: tuple[Series, ...]
    sentences: tuple[str, ...]
    _draw: Callable[[Floats], Scene] = field(repr=False)
    _spread: Floats = field(repr=False)  # (known directions, unknowns) one standard deviation of each

    def draws(self, n: int, seed: int = 0) -> list[Scene]:
        """Scenes whose numbers scatter as the data leave them open; what they cannot tell at all stays.

        Args:
            n: how many, 0..1000.
            seed: of the random numbers.

        Raises:
            InputError: n is out of range.
        """
        if not 0 <= n <= 1000:
            raise InputError(f"draws: {n} is not in the range 0..1000")
        random = np.random.default_rng(seed)
        scatter = random.standard_normal((n, self._spread.shape[0])) @ self._spread
        return [self._draw(by) for by in scatter]


def fit(
    scene: Scene,
    data: Measurement | str | Path | Sequence[Measurement | str | Path],
    vary: Sequence[str],
    match: Mapping[str, str] | None = None,
    scale: float | None = None,
    progress: Callable[[str], object] = lambda _: None,
) -> Fit:
    """The numbers with which a scene moves as what was measured.

    Args:
        scene: a valid scene, to start from.
        data: one or more measurements, or their files; see `parse_measurements`; several runs
            in one file are several measurements.
        vary: one to six names of what is sought: settings (`sim.set_value`), numbers of parts
            ("spring0.stiffness", "mass1.mass"), what a mass starts with ("mass1.vx"), and those of
            `residuals.OF_MEASUREMENT`. With "start", the first row is the start; without it, time 0 is, and
            the scene says how it is then.
        match: for names of columns, quantities as in "mass1.x", "-mass1.y" or "90 - spring0.direction"; None
            for what the names say, see `matching.guesses`.
        scale: how many of the scene's lengths are one metre, or one of the lengths of a file in a unit that
            is not known in metres; needed where neither unit nor `vary` says it.
        progress: is told in a few words what is being done.

    Returns:
        The fit.

    Raises:
        SceneError: the scene is not valid.
        InputError: a file, a column or a name is not right; there are too few numbers, or the scene cannot
            be run. The sentence names it.
    """
    scene = validate(scene)
    every = [data] if isinstance(data, (Measurement, str, Path)) else list(data)
    tables: list[Measurement] = []
    for each in every:
        tables += [each] if isinstance(each, Measurement) else read_measurements(each)
    if not tables:
        raise InputError("fit: name at least one file of what was measured")
    problem = Problem(scene, tables, list(vary), match, scale)
    return _Search(problem, progress).found()


# ------------------------------------------------------------------------- the search
class _Search:
    """Finds the least sum of squares.

    Args:
        problem: the residuals whose squares are summed.
        progress: see `fit`.
    """

    def __init__(self, problem: Problem, progress: Callable[[str], object]) -> None:
        self._problem, self._progress = problem, progress
        parameters = problem.parameters
        self._low = np.array([p.u(max(p.low, 1e-300)) if p.logarithmic else p.u(p.low) for p in parameters])
        self._high = np.array([p.u(p.high) for p in parameters])
        self._noise = [
            np.array(
                [
                    max(float(np.nanstd(row)), 1e-12 * float(np.nanmax(np.abs(row))), 1e-300)
                    for row in t.measured
                ]
            )
            for t in problem.tables
        ]

    def found(self) -> Fit:
        """The fit."""
        problem = self._problem
        first = np.clip(problem.first(), self._low, self._high)
        for t, run in enumerate(problem.fitted(first)):
            if run is None:
                raise InputError("fit: the scene runs away, as it is, within the time that was measured")
            # A column that hardly changes must not outweigh all others.
            off = np.sqrt(np.nanmean((problem.tables[t].measured - run) ** 2, axis=1))
            self._noise[t] = np.maximum(self._noise[t], _FAR * off)
        best, u = np.inf, first
        for number, start in enumerate(self._starts(first), 1):
            for part in _WINDOWS:
                self._progress(f"start {number}, {part:.0%} of the rows")
                start = self._down(start, part)
            cost = float((problem.residuals(start, self._noise) ** 2).sum())
            if cost < best * (1.0 - 1e-9):
                best, u = cost, start
            if self._is_noise(u):
                break
        several = sum(len(table.matches) for table in problem.tables) > 1
        for _ in range(2 if several else 1):
            self._progress("noise of each column")
            self._noise = self._left_noise(u)
            u = self._down(u, 1.0) if several else u
        self._progress("what the data tell")
        return self._summed_up(u, first)

    def _starts(self, first: Floats) -> Iterator[Floats]:
        """The scene's own numbers, and then others, those that fit the first rows best first."""
        from scipy.stats import qmc

        yield first
        spread = np.array([p.spread for p in self._problem.parameters])
        if not spread.any():
            return
        points = qmc.Halton(int(spread.sum()), scramble=False).fast_forward(1).random(_STARTS)
        every = []
        for point in points:
            u = first.copy()
            u[spread] += (2.0 * point - 1.0) * [
                _ELSEWHERE if p.logarithmic else 0.3 for p in self._problem.parameters if p.spread
            ]
            every.append(np.clip(u, self._low, self._high))
        self._progress("where to begin")
        costs = [float((self._problem.residuals(u, self._noise, _WINDOWS[0]) ** 2).sum()) for u in every]
        yield from (every[i] for i in np.argsort(costs)[: _TRIED - 1])

    def _down(self, u: Floats, part: float) -> Floats:
        from scipy.optimize import least_squares

        low, high = self._low - 1e-9, self._high + 1e-9
        last: dict[bytes, Floats] = {}

        def residuals(at: Floats) -> Floats:
            """They are asked for once more for the differences."""
            if at.tobytes() not in last:
                last.clear()
                last[at.tobytes()] = self._problem.residuals(at, self._noise, part)
            return last[at.tobytes()]

        def slopes(at: Floats) -> Floats:
            here = residuals(at)
            moved = (self._problem.residuals(at + by, self._noise, part) for by in _STEP * np.eye(at.size))
            return np.column_stack([(each - here) / _STEP for each in moved])

        found = least_squares(
            residuals, np.clip(u, self._low, self._high), cast(Any, slopes),
            bounds=(low, high), x_scale=1.0, xtol=1e-9, ftol=1e-10, gtol=1e-10, max_nfev=_ROUNDS,
        )  # fmt: skip
        return np.clip(found.x, self._low, self._high)

    def _differences(self, u: Floats, residuals: Callable[[Floats], Floats]) -> Floats:
        """(residuals, unknowns) derivatives by central differences."""
        columns = []
        for i in range(u.size):
            ends = []
            for sign in (1.0, -1.0):
                moved = u.copy()
                moved[i] += sign * _STEP
                ends.append(residuals(moved))
            columns.append((ends[0] - ends[1]) / (2.0 * _STEP))
        return np.column_stack(columns)

    def _directions(
        self, u: Floats, residuals: Callable[[Floats], Floats]
    ) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
        """The slopes, their singular values and directions, and which of these are known."""
        slopes = self._differences(u, residuals)
        _, singular, directions = np.linalg.svd(slopes, full_matrices=False)
        # The error of a difference goes with its own unknown, whose unit may be far from those of others.
        error = _RANK * np.linalg.norm(directions * np.linalg.norm(slopes, axis=0), axis=1)
        known = singular > np.maximum(1.0 / _UNKNOWN, error)
        return slopes, singular, directions, known

    def _left(self, u: Floats) -> list[Floats]:
        """(columns, rows) residuals of each measurement, in units of noise, with gaps."""
        flat, found, at = self._problem.residuals(u, self._noise), [], 0
        for table in self._problem.tables:
            there = ~np.isnan(table.measured)
            each = np.full_like(table.measured, np.nan)
            each[there] = flat[at : at + int(there.sum())]
            at += int(there.sum())
            found.append(each)
        return found

    def _is_noise(self, u: Floats) -> bool:
        """Whether nothing is left but noise, so that no other start can do better."""
        every = [row for table in self._left(u) for row in table]
        return all(effective_sample_fraction(row) == 1.0 for row in every) and all(
            np.nanstd(row) < 0.5 for row in every
        )

    def _left_noise(self, u: Floats) -> list[Floats]:
        """The noise of each column, from what is left of it."""
        count = sum(int((~np.isnan(table.measured)).sum()) for table in self._problem.tables)
        share = max(1.0 - u.size / count, 1.0 / count)
        found = []
        for old, left, table in zip(self._noise, self._left(u), self._problem.tables, strict=True):
            root = np.sqrt(np.nanmean(left**2, axis=1) / share) * old
            spread = np.nanmax(table.measured, axis=1) - np.nanmin(table.measured, axis=1)
            found.append(np.maximum(root, np.maximum(_NOISELESS * spread, 1e-300)))
        return found

    # --------------------------------------------------------------------- what it means
    def _summed_up(self, u: Floats, first: Floats) -> Fit:
        from scipy.stats import t as student

        problem = self._problem
        left = self._left(u)
        shares = [np.array([effective_sample_fraction(row) for row in each]) for each in left]
        noise = [n / np.sqrt(s) for n, s in zip(self._noise, shares, strict=True)]
        residuals = partial(problem.residuals, noise=noise)
        slopes, singular, directions, known = self._directions(u, residuals)
        if not known.all():
            # What the data cannot tell stays as the scene has it.
            back = np.clip(u - (u - first) @ directions[~known].T @ directions[~known], self._low, self._high)
            if float((residuals(back) ** 2).sum()) < float((residuals(u) ** 2).sum()) + _AS_GOOD:
                u = back
                slopes, singular, directions, known = self._directions(u, residuals)
        counts = [(~np.isnan(table.measured)).sum(axis=1) for table in problem.tables]
        effective = [c * s for c, s in zip(counts, shares, strict=True)]
        freedom = max(1.0, sum(float(each.sum()) for each in effective) - u.size)
        wide = float(student.ppf(0.5 + 0.5 * _CONFIDENCE, freedom))
        spread = directions[known] / singular[known, None]
        told = Identifiability(
            problem.parameters, u, spread, directions[~known], wide,
            partial(self._profile, residuals, slopes, float((residuals(u) ** 2).sum()), wide**2),
        )  # fmt: skip
        values = problem.in_units_of_tables(told.values(), u)
        runs = problem.fitted(u)
        series = [
            Series(table.measurement.name, m.column.name, m.text, m.column.unit, table.measurement.time,
                   table.measured[c], run[c] if run is not None else np.full(table.time.size, np.nan),
                   float(effective[t][c]))
            for t, (table, run) in enumerate(zip(problem.tables, runs, strict=True))
            for c, m in enumerate(table.matches)
        ]  # fmt: skip
        sentences = [
            *(remark for table in problem.tables for remark in table.measurement.remarks),
            *problem.doubts(u),
            *told.sentences(),
            *problem.lengths_told(u),
            *at_ends(problem.parameters, u, self._low, self._high, told.known),
            *autocorrelated(series),
        ]
        return Fit(
            problem.scene_at(u), {each.name: each for each in values}, tuple(series), tuple(sentences),
            lambda by: problem.scene_at(np.clip(u + by, self._low, self._high)), spread,
        )  # fmt: skip

    def _profile(
        self,
        residuals: Callable[[Floats], Floats],
        slopes: Floats,
        least: float,
        enough: float,
        at: Floats,
        held: Sequence[int],
    ) -> tuple[Floats, float]:
        """The least sum of squares with some unknowns held: all unknowns there, and by how much the sum
        exceeds the least of all.

        It takes a few steps of Newton's method with the slopes of the best, until that is less than enough.
        """
        free = [i for i in range(at.size) if i not in held]
        sizes = np.linalg.norm(slopes[:, free], axis=0) + 1e-300
        inverse = np.linalg.pinv(slopes[:, free] / sizes, rcond=_RANK) / sizes[:, None]
        at = np.clip(at, self._low, self._high)
        best, rise = at, math.inf
        for _ in range(_GIVING_WAY if free else 1):
            left = residuals(at)
            before, rise = rise, min(rise, float((left**2).sum()) - least)
            best = at if rise < before else best
            if rise < enough or rise > 0.9 * before:
                break
            at = at.copy()
            at[free] -= np.clip(inverse @ left, -1.0, 1.0)
            at = np.clip(at, self._low, self._high)
        return best, rise


def effective_sample_fraction(residuals: Floats) -> float:
    """What part of some residuals is independent, by the correlation of neighbours; 1 where that is not more
    than chance.

    Args:
        residuals: (k,) evenly spaced; NaN for gaps.
    """
    both = ~np.isnan(residuals[1:]) & ~np.isnan(residuals[:-1])
    count, square = int(both.sum()), float(np.nanmean(residuals**2)) if residuals.size else 0.0
    if count < 4 or square == 0.0:
        return 1.0
    r = float((residuals[1:] * residuals[:-1])[both].mean()) / square
    if r < 2.0 / math.sqrt(count):
        return 1.0
    r = min(r, 0.999)
    return (1.0 - r) / (1.0 + r)
