"""Combinations of unknowns: products of powers, sums, sums of reciprocals, and products of such sums.

Where the data leave a direction of the unknowns u undetermined, the gradient of anything they do determine is
orthogonal to it. Many functions share a gradient: where k0 = k1, it is the same for k0 k1, for k0 + k1
(springs in parallel) and for 1/k0 + 1/k1 (springs in series). `candidates` lists those that people would
write down. To find which of them the data determine, the unknowns are changed by a factor of 2 at a constant
value of each, and the fit must stay as good.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .parameters import Parameter

Floats = NDArray[np.float64]

# Unless noted, doubling or halving one of these numbers fails no test.
_NEAR_HALF = 0.1
"""Largest distance of a power from a multiple of 1/2 to which it is rounded."""
_NEAR_ONE = 0.03
"""Largest distance of a factor from 1 to which it is rounded."""


@dataclass(frozen=True)
class _Term:
    """(sum of a x^p over its members)^(q): a generalised mean of some unknowns.

    Attributes:
        members: for each, the index of an unknown, its factor a, and its power p, 1 or -1.
        outer: the power of the sum, 1 or -1, so that the unit is that of the unknowns.
        power: the power of the whole.
    """

    members: Sequence[tuple[int, float, int]]
    outer: int
    power: float

    def total(self, values: Sequence[float]) -> float:
        """Return the sum."""
        return sum(a * values[i] ** p for i, a, p in self.members)

    def text(self, names: Sequence[str]) -> str:
        """Return the usual notation, without the power."""
        text = ""
        for i, a, p in self.members:
            size = abs(a)
            if p == 1:
                each = names[i] if size == 1.0 else f"{size:.3g} {names[i]}"
            else:
                each = f"{size:.3g} / {names[i]}"
            sign = "-" if a < 0.0 else "+" if text else ""
            text += f" {sign} {each}" if text else f"{sign}{each}"
        if self.outer < 0:
            return f"1 / ({text})"
        return text


@dataclass(frozen=True)
class Combination:
    """A function of some unknowns, f(u): a product of terms.

    Attributes:
        terms: its factors.
        parameters: all unknowns.
    """

    terms: Sequence[_Term]
    parameters: Sequence[Parameter]

    @property
    def which(self) -> list[int]:
        """Indices of the unknowns in it."""
        return sorted(i for term in self.terms for i, _, _ in term.members)

    @property
    def is_product(self) -> bool:
        """Whether it is positive, so that its uncertainty is a factor rather than a difference."""
        return all(self.parameters[i].logarithmic for i in self.which) and all(
            a > 0.0 for term in self.terms for _, a, _ in term.members
        )

    @property
    def text(self) -> str:
        """The usual notation, as in "k / (m0 + m1)"."""
        names = [each.name for each in self.parameters]
        if len(self.terms) == 1 and self.terms[0].power == 1.0:
            return self.terms[0].text(names)
        parts: dict[bool, list[str]] = {True: [], False: []}
        for term in self.terms:
            base = term.text(names)
            if len(term.members) > 1:
                base = f"({base})"
            size = abs(term.power)
            parts[term.power > 0.0].append(base if size == 1.0 else f"{base}^{size:.3g}")
        above, below = " ".join(parts[True]) or "1", "".join(f" / {each}" for each in parts[False])
        return above + below

    @property
    def unit(self) -> str:
        """The unit of a sum; empty for a product, whose unit would be hard to read."""
        if len(self.terms) != 1 or self.terms[0].power != 1.0:
            return ""
        term = self.terms[0]
        first, _, power = term.members[0]
        return self.parameters[first].unit if power == term.outer else ""

    def value(self, u: Floats) -> float:
        """Return f(u)."""
        values = self._values(u)
        return math.prod(term.total(values) ** (term.outer * term.power) for term in self.terms)

    def interval(self, u: Floats, spread: Floats, wide: float) -> tuple[float, float, float]:
        """Return f(u) and the ends of its interval.

        Args:
            u: the best estimate.
            spread: (known directions, unknowns) one standard deviation along each.
            wide: half-width of the interval, in standard deviations.
        """
        step, slopes, value = 1e-5, np.zeros(u.size), self.value(u)
        for i in self.which:
            moved = step * (np.arange(u.size) == i)
            slopes[i] = (self.value(u + moved) - self.value(u - moved)) / (2.0 * step)
        by = wide * float(np.sqrt(((spread @ slopes) ** 2).sum()))
        if self.is_product:
            return value, value * math.exp(-by / value), value * math.exp(by / value)
        return value, value - by, value + by

    def kept(self, u: Floats, at: Floats, i: int) -> float | None:
        """Return the i-th element of u for which f(u) = f(at); None if there is none."""
        values = self._values(u)
        own = next(term for term in self.terms if i in [j for j, _, _ in term.members])
        factor, power = next((a, p) for j, a, p in own.members if j == i)
        goal = self.value(at)
        for term in self.terms:
            if term is not own:
                goal /= term.total(values) ** (term.outer * term.power)
        if goal <= 0.0 and own.power != 1.0:
            return None
        total = (goal ** (1.0 / own.power)) ** own.outer
        wanted = (total - sum(a * values[j] ** p for j, a, p in own.members if j != i)) / factor
        if self.parameters[i].logarithmic and not wanted > 0.0:
            return None
        found = self.parameters[i].u(wanted ** (1.0 / power))
        return found if math.isfinite(found) else None

    def bounds(self, low: float, high: float) -> dict[int, tuple[float, float]]:
        """Return the bounds on each unknown from the interval of a sum of positive ones: no part exceeds the
        whole."""
        term = self.terms[0]
        if len(self.terms) > 1 or term.power != 1.0 or len({p for _, _, p in term.members}) > 1:
            return {}
        if not self.is_product:
            return {}
        if term.outer > 0:
            return {i: (0.0, high / a) for i, a, _ in term.members}
        return {i: (low * a, math.inf) for i, a, _ in term.members}

    def _values(self, u: Floats) -> list[float]:
        """Return the values of the unknowns, not clipped to their ranges so that f is smooth."""
        return [each.free(value) for each, value in zip(self.parameters, u.tolist(), strict=True)]


def candidates(weights: Floats, parameters: Sequence[Parameter], u: Floats) -> list[Combination]:
    """Return the combinations with a given gradient, the simplest first.

    Args:
        weights: (unknowns,) the gradient with respect to u, of any length; 0 for unknowns not involved.
        parameters: the unknowns.
        u: the point at which the gradient is given.
    """
    which = np.flatnonzero(weights).tolist()
    if not all(parameters[i].logarithmic for i in which):
        return [
            Combination((_sum_of(which, weights, parameters, u, power),), parameters)
            for power in ((1, -1) if any(parameters[i].logarithmic for i in which) else (1,))
        ]
    powers = {i: _rounded(float(weights[i])) for i in which}
    product = Combination(tuple(_Term(((i, 1.0, 1),), 1, powers[i]) for i in which), parameters)
    groups: dict[tuple[str, bool], list[int]] = {}
    for i in which:
        groups.setdefault((parameters[i].unit, bool(weights[i] > 0.0)), []).append(i)
    sums: list[Combination] = []
    if 1 < len(groups) < len(which):
        for power in (1, -1):
            terms = [
                _sum_of(each, weights, parameters, u, power if len(each) > 1 else 1)
                for each in groups.values()
            ]
            powered = [
                _Term(term.members, term.outer, _rounded(float(weights[each].sum())))
                for term, each in zip(terms, groups.values(), strict=True)
            ]
            sums.append(Combination(tuple(powered), parameters))
    one_unit = len({parameters[i].unit for i in which}) == 1
    if not one_unit and len({bool(weights[i] > 0.0) for i in which}) > 1:
        return [product, *sums]
    for power in (1, -1) if one_unit else (1,):
        sums.append(Combination((_sum_of(which, weights, parameters, u, power),), parameters))
    plain = all((2.0 * each).is_integer() for each in powers.values())
    return [product, *sums] if plain else [*sums, product]


def _sum_of(
    which: Sequence[int], weights: Floats, parameters: Sequence[Parameter], u: Floats, power: int
) -> _Term:
    """Return the sum whose gradient has the same direction; positive unknowns get the power, others 1."""
    members: list[tuple[int, float, int]] = []
    for i in sorted(which, key=lambda i: (parameters[i].logarithmic, i)):
        parameter = parameters[i]
        if parameter.logarithmic:
            factor, own = float(weights[i]) / (power * math.exp(power * float(u[i]))), power
        else:
            factor, own = float(weights[i]) / parameter.scale, 1
        members.append((i, factor, own))
    first = members[0][1]
    scaled = [(i, factor / first, own) for i, factor, own in members]
    near = [(i, _one(factor), own) for i, factor, own in scaled]
    outer = -1 if all(own == -1 for _, _, own in near) else 1
    return _Term(tuple(near), outer, 1.0)


def _one(factor: float) -> float:
    return math.copysign(1.0, factor) if abs(abs(factor) - 1.0) < _NEAR_ONE else factor


def _rounded(power: float) -> float:
    """Round a power to a multiple of 1/2 if it is close to one."""
    half = round(2.0 * power) / 2.0
    return half if half and abs(power - half) < _NEAR_HALF else power
