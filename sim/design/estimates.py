"""What a fit tells: numbers with intervals, columns with what is left of them, and sentences."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from .parameters import Parameter
from .units import within_half_a_turn

Floats = NDArray[np.float64]

_INVOLVED = 0.1
"""Part in an unknown direction from which on a number is named with it."""


@dataclass(frozen=True)
class Estimate:
    """A number that was fitted.

    Attributes:
        name, unit: what it is.
        value: the best one.
        low, high: the 95 % interval. For one that the data cannot tell they are all that it may be: 0 and
            infinity where it is positive.
        known: whether the data tell it.
        before: what it was in the scene.
    """

    name: str
    unit: str
    value: float
    low: float
    high: float
    known: bool
    before: float

    @property
    def text(self) -> str:
        """As people read it, as in "812 ± 9 kg/s²"."""
        unit = f" {self.unit}" if self.unit else ""
        if not self.known:
            return (
                f"{self.value:.3g}{unit} or any other"
                if math.isinf(self.high)
                else f"at most {self.high:.3g}{unit}"
            )
        return f"{plus_minus(self.value, self.low, self.high)}{unit}"


@dataclass(frozen=True, eq=False)
class Series:
    """A column, and what the fitted scene does instead.

    Attributes:
        file, column, quantity: of what; the quantity is as it was matched, as in "-mass1.y".
        unit: of the column.
        time: (k,) s, as in the file.
        measured, fitted: (k,) NaN where there was nothing measured.
        effective: number of independent residuals that the k hold.
    """

    file: str
    column: str
    quantity: str
    unit: str
    time: Floats
    measured: Floats
    fitted: Floats
    effective: float

    @property
    def residuals(self) -> Floats:
        """(k,) measured minus fitted; angles within half a turn."""
        left = self.measured - self.fitted
        return within_half_a_turn(left) if self.unit == "°" else left

    @property
    def noise(self) -> float:
        """Root mean square of the residuals."""
        return float(np.sqrt(np.nanmean(self.residuals**2)))


class Told:
    """What the data tell of the unknowns.

    Args:
        parameters: the unknowns.
        u: the best.
        spread: (known directions, unknowns) one standard deviation of each.
        unknown: (directions, unknowns) of which they tell nothing.
        vague: the same, by how much each leaves the others open.
        wide: standard deviations of an interval.
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        u: Floats,
        spread: Floats,
        unknown: Floats,
        vague: Floats,
        wide: float,
    ) -> None:
        self._parameters, self._u, self._spread, self._wide = parameters, u, spread, wide
        self._unknown, self._vague = unknown, vague
        self._involved = np.flatnonzero((np.abs(unknown) > _INVOLVED).any(axis=0))

    def values(self, rise: Callable[[int, float], float]) -> list[Estimate]:
        """Of each unknown."""
        deviations = np.sqrt((self._spread**2).sum(axis=0) + (self._vague**2).sum(axis=0))
        found = []
        for i, (p, u) in enumerate(zip(self._parameters, self._u, strict=True)):
            value, by = p.value(u), self._wide * float(deviations[i])
            if i in self._involved:
                low, high = (0.0, math.inf) if p.logarithmic else (-math.inf, math.inf)
                if p.logarithmic and self._is_alone(i):
                    high = self._at_most(p, u, partial(rise, i))
                found.append(Estimate(p.name, p.unit, value, low, high, False, p.start))
            else:
                ends = (
                    (math.exp(u - by), math.exp(u + by))
                    if p.logarithmic
                    else (value - by * p.scale, value + by * p.scale)
                )
                found.append(Estimate(p.name, p.unit, value, *ends, True, p.start))
        return found

    def _is_alone(self, i: int) -> bool:
        """Whether an unknown is not known by itself, whatever the others are."""
        share = self._unknown[:, i]
        return bool((share**2).sum() > 0.98)

    def _at_most(self, p: Parameter, u: float, rise: Callable[[float], float]) -> float:
        """The value from which on the data would tell."""
        low, high = 0.0, 0.5
        while rise(high) < self._wide**2:
            low, high = high, 2.0 * high
            if high > 10.0:
                return math.inf
        for _ in range(6):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if rise(middle) >= self._wide**2 else (middle, high)
        return p.value(u + high)

    def sentences(self) -> list[str]:
        """What the data cannot tell."""
        said, left = [], []
        for i in self._involved.tolist():
            if self._is_alone(i):
                said.append(f"The data hardly tell {self._parameters[i].name}.")
            else:
                left.append(i)
        rest = self._unknown[:, left]
        rest = rest[np.sqrt((rest**2).sum(axis=1)) > 0.5] if left else rest[:0]
        return said + (self._apart(rest, left) if rest.shape[0] else [])

    def _apart(self, unknown: Floats, which: list[int]) -> list[str]:
        """For unknowns of which only combinations are known."""
        names = _listed([self._parameters[i].name for i in which])
        sentence = f"The data cannot tell {names} apart"
        logarithmic = all(self._parameters[i].logarithmic for i in which)
        masses = [c for c, i in enumerate(which) if self._parameters[i].unit == "kg"]
        reduced, pivots = _reduced(unknown, masses)
        others = [c for c in range(len(which)) if c not in pivots]
        if not logarithmic or not others:
            return [f"{sentence}."]
        known = []
        for c in others:
            weights = np.zeros(self._u.size)
            weights[which[c]] = 1.0
            for row, pivot in enumerate(pivots):
                weights[which[pivot]] -= _rounded(float(reduced[row, c]))
            known.append(self._combination(weights))
        return [f"{sentence}: of them only {_listed(known)} {'are' if len(known) > 1 else 'is'} known."]

    def _combination(self, weights: Floats) -> str:
        """A product of powers, as in "k / m = 812 ± 9"."""
        value = float(weights @ self._u)
        by = self._wide * float(np.sqrt(((self._spread @ weights) ** 2).sum()))
        terms = {sign: [
            self._parameters[i].name + (f"^{abs(w):.3g}" if abs(abs(w) - 1.0) > 1e-9 else "")
            for i, w in enumerate(weights) if sign * w > 0.0
        ] for sign in (1, -1)}  # fmt: skip
        text = " ".join(terms[1]) + "".join(f" / {name}" for name in terms[-1])
        return f"{text} = {plus_minus(*(math.exp(each) for each in (value, value - by, value + by)))}"


def _reduced(rows: Floats, wanted: Collection[int]) -> tuple[Floats, list[int]]:
    """The reduced echelon form of some rows, and its pivots: those wanted, or as far to the right as they can
    be."""
    rows, pivots = rows.copy(), []
    for row in range(rows.shape[0]):
        size = np.abs(rows[row:]).max(axis=0)
        pivot = max(
            (c for c in range(rows.shape[1]) if c not in pivots and size[c] > 0.3 * size.max()),
            key=lambda c: (c in wanted, c),
        )
        best = row + int(np.argmax(np.abs(rows[row:, pivot])))
        rows[[row, best]] = rows[[best, row]]
        rows[row] /= rows[row, pivot]
        for other in range(rows.shape[0]):
            if other != row:
                rows[other] -= rows[other, pivot] * rows[row]
        pivots.append(pivot)
    return rows, pivots


def _rounded(power: float) -> float:
    """A power, as a half of a whole number where it is nearly one."""
    half = round(2.0 * power) / 2.0
    return half if abs(power - half) < 0.1 else power


def at_ends(parameters: Sequence[Parameter], u: Floats, low: Floats, high: Floats) -> list[str]:
    """Which numbers of a scene have run to an end of their range, low..high."""
    return [
        f"{p.name} has run to {p.value(value):.3g} {p.unit}".rstrip()
        + ", the end of the range in which it is sought."
        for p, value, least, most in zip(parameters, u, low, high, strict=True)
        if p.write is not None and (value <= least + 1e-6 or value >= most - 1e-6)
    ]


def hanging_together(series: Sequence[Series]) -> list[str]:
    """Of which columns more than noise is left."""
    found = []
    for each in series:
        count = int((~np.isnan(each.measured)).sum())
        if each.effective < 0.5 * count:
            found.append(
                f"What is left of {each.column} ({each.file}) is no mere noise: its {count} numbers count as "
                f"{max(1, round(each.effective))}, and the intervals are as much wider. The scene may lack "
                "something."
            )
    return found


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def plus_minus(value: float, low: float, high: float) -> str:
    """A number with its interval, as in "812 ± 9", to two digits of the latter; with both ends where they are
    not alike."""
    by = 0.5 * (high - low)
    if not (math.isfinite(by) and by > 0.0):
        return f"{value:.4g}"
    if abs(high - value - by) > 0.1 * by:
        return f"{value:.3g} ({low:.3g} to {high:.3g})"
    digits = 1 - math.floor(math.log10(by))
    if abs(value) < 1e6 and digits <= 6:
        return f"{value:.{max(digits, 0)}f} ± {by:.{max(digits, 0)}f}"
    return f"{value:.6g} ± {by:.2g}"
