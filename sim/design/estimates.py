"""Results of a fit: numbers with intervals, columns with their residuals, and sentences."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..text import Text, listed, number, with_unit
from .combinations import Combination, candidates
from .parameters import Parameter
from .units import within_half_a_turn

Floats = NDArray[np.float64]

# Unless noted, doubling or halving one of these numbers fails no test.
UNKNOWN = 1.0
"""Half-width of an interval of u above which a direction, or a number, counts as unknown."""
_INVOLVED = 0.1
"""Component along an undetermined direction above which an unknown is reported with it."""
_ALONE = 0.98
"""Undetermined part of an unknown, regardless of the others, above which it is reported by itself. At 0.99,
`test_a_number_of_which_the_data_say_nothing_is_named_with_what_it_is_at_most` fails."""
_MUCH = 3.0
"""Factor by which an undetermined unknown must increase the uncertainty of another to be reported with it."""
_FARTHEST = 20.0
"""Largest change of u in the search for the end of an interval."""
_ALONG = 0.7
"""Change of u by which a combination is tested: a factor of 2. Doubled,
`test_what_cannot_be_told_is_named_with_what_is_known_of_it` fails."""


@dataclass(frozen=True)
class Estimate:
    """A fitted number.

    Attributes:
        name, unit: of the number.
        value: the best value.
        low, high: the 95 % interval. For a number that the data cannot determine, the range of possible
            values: 0 and infinity if it is positive and nothing limits it.
        known: whether the data determine it.
        before: its value in the scene.
        also: the same in the measurements' unit of length; empty if that is the scene's.
    """

    name: str
    unit: str
    value: float
    low: float
    high: float
    known: bool
    before: float
    also: str = ""

    @property
    def text(self) -> str:
        """The value for people, as in "998 ± 3 px/s² (2.495 ± 0.007 m/s²)"."""
        return Text("{value} ({also})", value=self.alone, also=self.also) if self.also else self.alone

    @property
    def alone(self) -> str:
        """The value in the scene's unit alone."""
        if not self.known:
            if math.isinf(self.high) and (self.low == 0.0 or math.isinf(self.low)):
                return Text("{value} or any other", value=with_unit(number(self.value, ".3g"), self.unit))
            return _range(self.low, self.high, self.unit, self.low == 0.0)
        return with_unit(plus_minus(self.value, self.low, self.high), self.unit)


@dataclass(frozen=True, eq=False)
class Series:
    """A measured column, and the values of the fitted scene.

    Attributes:
        file, column, quantity: names; the quantity is as it was matched, as in "-mass1.y".
        unit: of the column.
        time: (k,) s, as in the file.
        measured, fitted: (k,) NaN where nothing was measured.
        effective: number of independent residuals among the k.
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


class Identifiability:
    """How well the data determine the unknowns.

    Args:
        parameters: the unknowns.
        u: the best estimate.
        spread: (known directions, unknowns) one standard deviation along each.
        unknown: (directions, unknowns) the directions that the data do not determine.
        wide: half-width of an interval, in standard deviations.
        give_way: given u and the indices of held unknowns, minimizes over the others; returns the whole
            u and the increase of the sum of squares.
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        u: Floats,
        spread: Floats,
        unknown: Floats,
        wide: float,
        give_way: Callable[[Floats, Sequence[int]], tuple[Floats, float]],
    ) -> None:
        self._parameters, self._u, self._spread, self._wide = parameters, u, spread, wide
        self._profile = give_way
        self._open = unknown.T @ unknown  # the projection onto what is unknown
        involved = np.flatnonzero((np.abs(unknown) > _INVOLVED).any(axis=0)).tolist()
        self._reached: list[Floats] = [u]
        self._ends = {i: self._between(i) for i in involved if self._is_alone(i)}
        together = self._together([i for i in involved if i not in self._ends])
        self._groups = [each for each in map(self._group, together) if each.known]
        vague = [i for i, known in enumerate(self.known) if known and self._is_wide(i)]
        self._ends |= {i: self._between(i) for i in vague}

    @property
    def known(self) -> list[bool]:
        """Whether the data determine each unknown."""
        unknown = {*self._ends, *(i for group in self._groups for i in group.which)}
        return [i not in unknown for i in range(self._u.size)]

    def values(self) -> list[Estimate]:
        """Return the estimate of each unknown."""
        bounds = dict(self._ends)
        for group in self._groups:
            bounds |= self._bounds(group)
        found = []
        for i, (p, known) in enumerate(zip(self._parameters, self.known, strict=True)):
            low, high = bounds[i] if i in bounds else map(p.free, self._interval(i))
            found.append(Estimate(p.name, p.unit, p.value(float(self._u[i])), low, high, known, p.start))
        return found

    def sentences(self) -> list[str]:
        """Return what the data cannot determine, and what they do tell about it."""
        return [self._alone(i) for i in self._ends] + [self._apart(each) for each in self._groups]

    def _interval(self, i: int) -> tuple[float, float]:
        """Return the interval of u of a known unknown, which varies as undetermined ones do."""
        reached = [at[i] for at in self._reached]
        by = self._wide * math.sqrt(float((self._spread[:, i] ** 2).sum()))
        return min(reached) - by, max(reached) + by

    def _is_wide(self, i: int) -> bool:
        low, high = self._interval(i)
        return high - low > 2.0 * UNKNOWN

    def _risen(self, at: Floats, held: Sequence[int]) -> float:
        """Return by how much the sum of squares is larger at other u; record u that the data still allow."""
        at, rise = self._profile(at, held)
        if rise < self._wide**2:
            self._reached.append(at)
        return rise

    # --------------------------------------------------------------------- a single unknown
    def _is_alone(self, i: int) -> bool:
        """Return whether an unknown is undetermined and hardly affects any other."""
        return bool(self._open[i, i] > _ALONE) and not any(
            self._goes_with(i, j) and not p.logarithmic for j, p in enumerate(self._parameters) if j != i
        )

    def _goes_with(self, i: int, j: int) -> bool:
        """Return whether two unknowns are undetermined together.

        Positive ones are compared by factors. The units of others are arbitrary: these belong together if one
        is known much less well than it would be alone.
        """
        for one, other in ((i, j), (j, i)):
            if not self._parameters[one].logarithmic:
                alone = float(np.sqrt((self._spread[:, one] ** 2).sum()))
                if abs(self._open[one, other]) > _MUCH * alone * math.sqrt(self._open[other, other]):
                    return True
        return bool(abs(self._open[i, j]) > _INVOLVED**2)

    def _between(self, i: int) -> tuple[float, float]:
        """Return the values of an unknown beyond which the data rule it out."""
        p = self._parameters[i]
        low, high = (self._far(i, sign) for sign in (-1.0, 1.0))
        return (
            p.value(low) if math.isfinite(low) else 0.0 if p.logarithmic else low,
            p.value(high) if math.isfinite(high) else high,
        )

    def _far(self, i: int, sign: float) -> float:
        """Return the u of an unknown from which the data rule it out, in one direction."""
        enough, p = self._wide**2, self._parameters[i]
        start = float(self._u[i])
        end = p.high if sign > 0.0 else max(p.low, 1e-300) if p.logarithmic else p.low
        most = min(abs(p.u(end) - start), _FARTHEST)

        def is_told(by: float) -> bool:
            return self._risen(self._u + sign * by * (np.arange(self._u.size) == i), [i]) >= enough

        near, far = 0.0, min(0.5, most)
        while not is_told(far):
            if far >= most:
                return sign * math.inf
            near, far = far, min(2.0 * far, most)
        for _ in range(5):
            middle = 0.5 * (near + far)
            near, far = (near, middle) if is_told(middle) else (middle, far)
        return start + sign * far

    def _alone(self, i: int) -> str:
        p, (low, high) = self._parameters[i], self._ends[i]
        if math.isinf(high) and (low == 0.0 if p.logarithmic else math.isinf(low)):
            return Text("The data do not tell {name}: whatever it is, the fit is as good.", name=p.name)
        return Text(
            "The data hardly tell {name}: it is {range}.",
            name=p.name,
            range=_range(low, high, p.unit, p.logarithmic),
        )

    # --------------------------------------------------------------------- unknowns that belong together
    def _together(self, which: list[int]) -> list[list[int]]:
        """Return the sets of unknowns that are known only in combination."""
        left, found = list(which), []
        while left:
            group = [left.pop(0)]
            for i in group:
                near = [j for j in left if self._goes_with(i, j)]
                group += near
                left = [j for j in left if j not in near]
            found.append(sorted(group))
        return found

    def _group(self, which: list[int]) -> _Group:
        """Return what is known of unknowns that belong together; nothing if each is known by itself."""
        size, vectors = np.linalg.eigh(self._open[np.ix_(which, which)])
        reduced, pivots = _reduced(
            vectors.T[size > 0.5], [c for c, i in enumerate(which) if self._is_base(i)]
        )
        if not pivots:
            return _Group(which, [], False)
        solved, choices = [i for c, i in enumerate(which) if c not in pivots], []
        for c, i in enumerate(which):
            if i in solved:
                weights = np.zeros(self._u.size)
                weights[which] = -reduced[:, c] @ (np.arange(len(which)) == np.array(pivots)[:, None])
                if all(self._parameters[j].logarithmic for j in which):
                    weights[np.abs(weights) < _INVOLVED] = 0.0
                weights[i] = 1.0
                choices.append(candidates(weights, self._parameters, self._u))
        ways = [(which[pivot], sign * _ALONG) for pivot in pivots for sign in (1.0, -1.0)]

        def worst(kept: list[Combination]) -> float:
            """Return the largest rise of the sum of squares along some combinations."""
            return max(self._risen(at, which) for at in self._along(kept, solved, ways))

        kept = [each[0] for each in choices]
        least = worst(kept)
        for c, each in enumerate(choices):
            for other in each[1:]:
                if least >= self._wide**2:
                    tried = [*kept[:c], other, *kept[c + 1 :]]
                    found = worst(tried)
                    kept, least = (tried, found) if found < least else (kept, least)
        return _Group(which, kept, least >= self._wide**2)

    def _is_base(self, i: int) -> bool:
        """Return whether others are expressed in terms of an unknown, as in stiffness / mass."""
        return self._parameters[i].unit == "kg" or self._parameters[i].name == "length_scale"

    def _along(
        self, kept: list[Combination], solved: list[int], ways: list[tuple[int, float]]
    ) -> Iterator[Floats]:
        """Yield unknowns at which some combinations are unchanged.

        Args:
            kept: the combinations.
            solved: the unknown for which each is solved.
            ways: the others that are changed, and by how much.
        """
        for i, by in ways:
            # A sum leaves less room on one side.
            for part in (1.0, 0.5, 0.25, 0.0):
                at = self._u + part * by * (np.arange(self._u.size) == i)
                new = [each.kept(at, self._u, c) for each, c in zip(kept, solved, strict=True)]
                given = [each for each in new if each is not None]
                if len(given) == len(new):
                    at[solved] = given
                    yield at
                    break

    def _bounds(self, group: _Group) -> dict[int, tuple[float, float]]:
        found = {
            i: (0.0, math.inf) if self._parameters[i].logarithmic else (-math.inf, math.inf)
            for i in group.which
        }
        if not group.is_near:
            for each in group.known:
                _, *ends = each.interval(self._u, self._spread, self._wide)
                found |= each.bounds(*ends)
        return found

    def _apart(self, group: _Group) -> str:
        names = listed([self._parameters[i].name for i in group.which])
        known = []
        for each in group.known:
            value = plus_minus(*each.interval(self._u, self._spread, self._wide))
            known.append(Text("{name} = {value}", name=each.text, value=with_unit(value, each.unit)))
        if len(known) > 1:
            said = Text(
                "The data cannot tell {names} apart: of them only {known} are known",
                names=names,
                known=listed(known),
            )
        else:
            said = Text(
                "The data cannot tell {names} apart: of them only {known} is known",
                names=names,
                known=known[0],
            )
        if group.is_near:
            return Text("{error}, and that near these values only.", error=said)
        return Text("{error}.", error=said)


@dataclass(frozen=True)
class _Group:
    """Unknowns that are known only in combination.

    Attributes:
        which: indices.
        known: the combinations that the data determine.
        is_near: whether they do so only near the best values.
    """

    which: list[int]
    known: list[Combination]
    is_near: bool


def _range(low: float, high: float, unit: str, positive: bool) -> str:
    """Return a range in words, as in "at most 3 kg"."""
    if math.isinf(high):
        return Text("at least {value}", value=with_unit(number(low, ".3g"), unit))
    most = with_unit(number(high, ".3g"), unit)
    if low == 0.0 if positive else math.isinf(low):
        return Text("at most {value}", value=most)
    return Text("between {low:.3g} and {high}", low=low, high=most)


def _reduced(rows: Floats, wanted: Collection[int]) -> tuple[Floats, list[int]]:
    """Return the reduced echelon form of some rows, and its pivots: those wanted, or as far to the right as
    possible."""
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


def at_ends(
    parameters: Sequence[Parameter], u: Floats, low: Floats, high: Floats, known: Sequence[bool]
) -> list[str]:
    """Return sentences on known numbers of a scene that have reached an end of their range, low..high."""
    return [
        Text(
            "{name} has run to {value}, the end of the range in which it is sought.",
            name=p.name,
            value=with_unit(number(p.value(value), ".3g"), p.unit),
        )
        for p, value, least, most, is_known in zip(parameters, u, low, high, known, strict=True)
        if p.write is not None and is_known and (value <= least + 1e-6 or value >= most - 1e-6)
    ]


def autocorrelated(series: Sequence[Series]) -> list[str]:
    """Return sentences on columns whose residuals are more than noise."""
    found = []
    for each in series:
        count = int((~np.isnan(each.measured)).sum())
        if each.effective < 0.5 * count:
            found.append(
                Text(
                    "What is left of {column} ({file}) is no mere noise: its {count} numbers count as "
                    "{effective}, and the intervals are as much wider. The scene may lack something.",
                    column=each.column,
                    file=each.file,
                    count=count,
                    effective=max(1, round(each.effective)),
                )
            )
    return found


def plus_minus(value: float, low: float, high: float) -> str:
    """Return a number with its interval, as in "812 ± 9", to two digits of the latter; with both ends where
    these are not symmetric."""
    by = 0.5 * (high - low)
    if not (math.isfinite(by) and by > 0.0):
        return number(value, ".4g")
    if abs(high - value - by) > 0.1 * by:
        return Text("{value:.3g} ({low:.3g} to {high:.3g})", value=value, low=low, high=high)
    digits = 1 - math.floor(math.log10(by))
    if abs(value) < 1e6 and digits <= 6:
        form = f".{max(digits, 0)}f"
        return Text("{value} ± {by}", value=number(value, form), by=number(by, form))
    return Text("{value:.6g} ± {by:.2g}", value=value, by=by)
