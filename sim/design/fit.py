"""Fit the numbers of a scene so that it moves as something that was measured.

The measurements d are compared with d(u) of a run of the scene (`residuals`), where u are the unknowns:
logarithms of positive numbers, and other numbers as fractions of a typical size. The fit minimises the sum of
((d - d(u)) / s)² over u, where s is the noise of each column, estimated from its residuals. The derivatives J
of the residuals with respect to u are finite differences of runs.

Correlated residuals count as fewer: with the correlation r of neighbours, n of them count as
n (1 - r) / (1 + r) (the effective sample size of an autoregressive process of order 1). The singular value
decomposition J = U S Vᵀ then gives the uncertainty of each direction v of u: 1 / s. The data do not determine
directions whose interval is wider than a factor of e to both sides; `estimates` reports them.
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

from ..errors import InputError, of_field
from ..scene.types import Scene
from ..scene.validate import validate
from ..text import Text
from .estimates import UNKNOWN, Estimate, Identifiability, Series, at_ends, autocorrelated
from .measurements import Measurement, read_measurements
from .residuals import Problem

Floats = NDArray[np.float64]

_CONFIDENCE = 0.95
"""Probability that an interval contains the true value, the usual one. At 0.9,
`test_draws_scatter_as_the_intervals_say` fails; halved,
`test_intervals_hold_the_truth_as_often_as_they_say`."""
# Unless noted, doubling or halving one of these numbers fails no test.
_STEP = 3e-4
"""Step of u in finite differences."""
_RANK = 1e-5
"""Slope along a direction, relative to those of the unknowns in it, below which it is the error of finite
differences."""
_ELSEWHERE = math.log(4.0)
"""Largest distance of other starts from the scene's numbers, in logarithms."""
_STARTS = 32
"""Number of other starts that are evaluated."""
_TRIED = 3
"""Number of starts that are followed."""
_WINDOWS = (0.25, 0.5, 1.0)
"""Fractions of the rows, fitted one after another so that no swing is mistaken for the next."""
_ROUNDS = 60
"""Largest number of steps in a descent."""
_AS_GOOD = 0.01
"""Rise of the sum of squares that counts as none. At 0, `test_what_the_data_do_not_tell_stays_as_it_is`
fails."""
_GIVING_WAY = 5
"""Largest number of steps in which unknowns adapt to others that are held. Halved,
`test_a_number_of_which_the_data_say_nothing_is_named_with_what_it_is_at_most` fails."""
_FAR = 0.1
"""Smallest initial noise of a column, as a fraction of its initial residuals. At 0,
`test_what_cannot_be_told_is_named_with_what_is_known_of_it` fails."""
_NOISELESS = 1e-7
"""Smallest noise of a column, as a fraction of its range."""


@dataclass(frozen=True, eq=False)
class Fit:
    """Result of `fit`.

    Attributes:
        scene: the scene with the numbers, and the start, of the best fit.
        values: the estimate of each varied number, by its name.
        series: each column, measured and fitted.
        sentences: further findings, in words.
    """

    scene: Scene
    values: Mapping[str, Estimate]
    series: tuple[Series, ...]
    sentences: tuple[str, ...]
    _draw: Callable[[Floats], Scene] = field(repr=False)
    _spread: Floats = field(repr=False)  # (known directions, unknowns) one standard deviation of each

    def draws(self, n: int, seed: int = 0) -> list[Scene]:
        """Return scenes with numbers drawn from their uncertainty; undetermined directions are not varied.

        Args:
            n: number of scenes, 0..1000.
            seed: seed of the random numbers.

        Raises:
            InputError: n is out of range.
        """
        if not 0 <= n <= 1000:
            raise InputError(Text("{where}: {n} is not in the range 0..1000", where="draws", n=n))
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
    """Fit the numbers of a scene so that it moves as measured.

    Args:
        scene: a valid scene, to start from.
        data: one or more measurements, or their files, see `parse_measurements`; several runs in one file are
            several measurements.
        vary: one to six names of numbers to fit: settings (`sim.set_value`), numbers of parts
            ("spring0.stiffness", "joint0.motor.torque"), start values of masses ("mass1.vx"), and those of
            `residuals.OF_MEASUREMENT`. With "start", the first row is the start; without it, the start is at
            time 0 and as the scene has it.
        match: quantities by column name, as in "mass1.x", "-mass1.y" or "90 - spring0.direction"; None to
            guess them from the names, see `matching.guesses`.
        scale: number of the scene's length units in one metre, or in one length unit of a file if its size in
            metres is unknown; needed where neither the units nor `vary` give it.
        progress: called with a few words on what is being done.

    Returns:
        The fit.

    Raises:
        SceneError: the scene is not valid.
        InputError: a file, a column or a name is invalid, there are too few values, or the scene cannot be
            run. The message names it.
    """
    scene = validate(scene)
    every = [data] if isinstance(data, (Measurement, str, Path)) else list(data)
    tables: list[Measurement] = []
    for each in every:
        tables += [each] if isinstance(each, Measurement) else read_measurements(each)
    if not tables:
        raise InputError(Text("{where}: name at least one file of what was measured", where="fit"))
    problem = Problem(scene, tables, list(vary), match, scale)
    return _Search(problem, progress).found()


# ------------------------------------------------------------------------- the search
class _Search:
    """Minimises the sum of squares.

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
        """Return the fit."""
        problem = self._problem
        first = np.clip(problem.first(), self._low, self._high)
        for t, run in enumerate(problem.fitted(first)):
            if run is None:
                if any(q.formula for q in problem.tables[t].quantities):
                    why = Text(
                        "the scene runs away, or a formula has no value, within the time that was measured"
                    )
                else:
                    why = Text("the scene runs away, as it is, within the time that was measured")
                raise InputError(of_field("fit", why))
            # A column that hardly changes must not outweigh all others.
            off = np.sqrt(np.nanmean((problem.tables[t].measured - run) ** 2, axis=1))
            self._noise[t] = np.maximum(self._noise[t], _FAR * off)
        best, u = np.inf, first
        for number, start in enumerate(self._starts(first), 1):
            for part in _WINDOWS:
                self._progress(Text("start {number}, {part:.0%} of the rows", number=number, part=part))
                start = self._down(start, part)
            cost = float((problem.residuals(start, self._noise) ** 2).sum())
            if cost < best * (1.0 - 1e-9):
                best, u = cost, start
            if self._is_noise(u):
                break
        several = sum(len(table.matches) for table in problem.tables) > 1
        for _ in range(2 if several else 1):
            self._progress(Text("noise of each column"))
            self._noise = self._left_noise(u)
            u = self._down(u, 1.0) if several else u
        self._progress(Text("what the data tell"))
        return self._summed_up(u, first)

    def _starts(self, first: Floats) -> Iterator[Floats]:
        """Yield the scene's own numbers, then others, starting with those that fit the first rows best."""
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
        self._progress(Text("where to begin"))
        costs = [float((self._problem.residuals(u, self._noise, _WINDOWS[0]) ** 2).sum()) for u in every]
        yield from (every[i] for i in np.argsort(costs)[: _TRIED - 1])

    def _down(self, u: Floats, part: float) -> Floats:
        from scipy.optimize import least_squares

        low, high = self._low - 1e-9, self._high + 1e-9
        last: dict[bytes, Floats] = {}

        def residuals(at: Floats) -> Floats:
            """Return the residuals, cached because the differences need them again."""
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
        """Return the derivatives, (residuals, unknowns), by central differences."""
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
        self, u: Floats, residuals: Callable[[Floats], Floats], wide: float
    ) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
        """Return the slopes, their singular values and directions, and which of the latter are known if an
        interval has a half-width of `wide` standard deviations."""
        slopes = self._differences(u, residuals)
        _, singular, directions = np.linalg.svd(slopes, full_matrices=False)
        # The error of a difference scales with its own unknown, whose unit may differ greatly from others.
        error = _RANK * np.linalg.norm(directions * np.linalg.norm(slopes, axis=0), axis=1)
        known = singular > np.maximum(wide / UNKNOWN, error)
        return slopes, singular, directions, known

    def _left(self, u: Floats) -> list[Floats]:
        """Return the residuals of each measurement, (columns, rows), in units of noise, with gaps."""
        flat, found, at = self._problem.residuals(u, self._noise), [], 0
        for table in self._problem.tables:
            there = ~np.isnan(table.measured)
            each = np.full_like(table.measured, np.nan)
            each[there] = flat[at : at + int(there.sum())]
            at += int(there.sum())
            found.append(each)
        return found

    def _is_noise(self, u: Floats) -> bool:
        """Return whether only noise is left, so that no other start can do better."""
        every = [row for table in self._left(u) for row in table]
        return all(effective_sample_fraction(row) == 1.0 for row in every) and all(
            np.nanstd(row) < 0.5 for row in every
        )

    def _left_noise(self, u: Floats) -> list[Floats]:
        """Estimate the noise of each column from its residuals."""
        count = sum(int((~np.isnan(table.measured)).sum()) for table in self._problem.tables)
        share = max(1.0 - u.size / count, 1.0 / count)
        found = []
        for old, left, table in zip(self._noise, self._left(u), self._problem.tables, strict=True):
            root = np.sqrt(np.nanmean(left**2, axis=1) / share) * old
            spread = np.nanmax(table.measured, axis=1) - np.nanmin(table.measured, axis=1)
            found.append(np.maximum(root, np.maximum(_NOISELESS * spread, 1e-300)))
        return found

    # --------------------------------------------------------------------- summary
    def _summed_up(self, u: Floats, first: Floats) -> Fit:
        from scipy.stats import t as student

        problem = self._problem
        left = self._left(u)
        shares = [np.array([effective_sample_fraction(row) for row in each]) for each in left]
        noise = [n / np.sqrt(s) for n, s in zip(self._noise, shares, strict=True)]
        counts = [(~np.isnan(table.measured)).sum(axis=1) for table in problem.tables]
        effective = [c * s for c, s in zip(counts, shares, strict=True)]
        freedom = max(1.0, sum(float(each.sum()) for each in effective) - u.size)
        wide = float(student.ppf(0.5 + 0.5 * _CONFIDENCE, freedom))
        residuals = partial(problem.residuals, noise=noise)
        slopes, singular, directions, known = self._directions(u, residuals, wide)
        best = u
        for direction in directions[~known][::-1]:
            # What the data cannot determine keeps the scene's values.
            back = np.clip(u - (u - first) @ direction * direction, self._low, self._high)
            if float((residuals(back) ** 2).sum()) < float((residuals(u) ** 2).sum()) + _AS_GOOD:
                u = back
        if u is not best:
            slopes, singular, directions, known = self._directions(u, residuals, wide)
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
        """Minimise the sum of squares with some unknowns held; return all unknowns there, and by how much the
        sum exceeds the overall minimum.

        Take a few steps of Newton's method with the slopes of the best fit, until that is less than `enough`.
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
    """Return the fraction of residuals that is independent, from the correlation of neighbours; 1 where that
    is no more than chance.

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
