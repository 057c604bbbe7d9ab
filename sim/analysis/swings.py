"""Period, amplitude and damping of an oscillation, measured from a curve."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_RIPPLE = 0.03
"""Fraction of the curve's range by which it must turn back after an extreme that is not a ripple. Doubled,
`test_the_damping_of_a_mass_on_a_spring_is_read_off` fails."""

# Unless noted, doubling or halving one of these numbers fails no test.
_REGULAR = 0.25
"""Largest relative deviation of a cycle from the median one in a regular oscillation."""

_STEADY = 2e-3
"""Magnitude of the logarithmic decrement up to which the amplitude counts as constant."""

_STILL = 1e-9
"""Range, relative to the largest magnitude of a value, up to which a curve counts as constant."""


@dataclass(frozen=True)
class Swings:
    """A measured oscillation.

    Attributes:
        period: mean duration of a whole cycle, s.
        amplitude: of the last swing, from the centre to one side, in the unit of the values.
        centre: the value about which it oscillates, in the unit of the values.
        decrement: the logarithmic decrement, the natural logarithm of the ratio of successive amplitudes one
            cycle apart; None where the amplitude does not decay.
    """

    period: float
    amplitude: float
    centre: float
    decrement: float | None

    @property
    def loss(self) -> float:
        """The fraction of the amplitude lost in a cycle; 0 where it does not decay."""
        return -math.expm1(-self.decrement) if self.decrement is not None else 0.0


def swings(time: Floats, values: Floats) -> Swings | None:
    """Measure the period, amplitude and damping of an oscillation.

    The centre is the limit of successive extremes, assuming that their distances from it form a geometric
    sequence (Aitken's delta-squared process), so damping does not shift it. The times at which the curve
    crosses the centre are interpolated linearly between samples, and the period is the slope of a straight
    line fitted to them.

    Args:
        time: (k,) s, ascending.
        values: (k,) in any unit; NaN is not allowed.

    Returns:
        None if there are fewer than two cycles or if cycles differ by more than a quarter: no oscillation.
    """
    size = float(np.abs(values).max(initial=0.0))
    reach = float(np.ptp(values)) if values.size else 0.0
    if values.size < 8 or not reach > _STILL * size:
        return None
    at = _extrema(values, _RIPPLE * reach)
    if len(at) < 4:
        return None
    extremes = np.array([_vertex(time, values, i) for i in at])
    centre = _centre(extremes)
    # From the first extreme to the last, since the curve may not oscillate before and after.
    moments = _zero_crossings(time[at[0] : at[-1] + 1], values[at[0] : at[-1] + 1] - centre)
    if len(moments) < 4 or not _is_regular(moments):
        return None
    halves = np.abs(np.diff(extremes))  # twice the amplitude, independent of the centre
    decrement = -2.0 * _slope(np.log(halves)) if len(halves) > 2 else 0.0
    return Swings(
        period=2.0 * _slope(moments),
        amplitude=0.5 * float(halves[-1]),
        centre=centre,
        decrement=decrement if decrement > _STEADY else None,
    )


def _extrema(values: Floats, least: float) -> list[int]:
    """Return the indices of alternating maxima and minima that differ by more than `least`, without the ends
    of the curve."""
    turns: list[int] = []
    high = low = 0  # indices of the highest and lowest values since the last turn
    rises: bool | None = None
    corners = _corners(values)
    for i, value in zip(corners.tolist(), values[corners].tolist(), strict=True):
        if value > values[high]:
            high = i
        if value < values[low]:
            low = i
        if rises is not False and values[high] - value > least:
            turns.append(high)
            rises, low = False, i
        elif rises is not True and value - values[low] > least:
            turns.append(low)
            rises, high = True, i
    return [i for i in turns if 0 < i < len(values) - 1]


def _corners(values: Floats) -> NDArray[np.int64]:
    """Return the indices of the first and the last value, and of those where the curve turns back."""
    moves = np.flatnonzero(np.diff(values))  # from each of these to the next value
    rises = values[moves + 1] > values[moves]
    turns = moves[:-1][rises[1:] != rises[:-1]] + 1  # of a flat top, the first value
    return np.unique(np.concatenate(([0], turns, [len(values) - 1])))


def _vertex(time: Floats, values: Floats, i: int) -> float:
    """Return the extreme of the parabola through three samples."""
    (t0, t1, t2), (before, here, after) = time[i - 1 : i + 2], values[i - 1 : i + 2]
    one, two = (here - before) / (t1 - t0), (after - here) / (t2 - t1)
    bend = (two - one) / (t2 - t0)
    slope = one + bend * (t1 - t0)
    return float(here - slope**2 / (4.0 * bend)) if bend else float(here)


def _centre(extremes: Floats) -> float:
    """Return the mean of Aitken's limits of each three successive extremes, weighted towards large swings."""
    one, two, three = extremes[:-2], extremes[1:-1], extremes[2:]
    bend = one - 2.0 * two + three  # never zero, since extremes alternate between maxima and minima
    limits = two - (two - one) * (three - two) / bend
    return float((np.abs(bend) * limits).sum() / np.abs(bend).sum())


def _zero_crossings(time: Floats, offsets: Floats) -> Floats:
    """Return the times at which a curve crosses zero."""
    signs = np.where(offsets >= 0.0, 1, -1)
    i = np.flatnonzero(signs[1:] != signs[:-1])
    share = offsets[i] / (offsets[i] - offsets[i + 1])
    return time[i] + share * (time[i + 1] - time[i])


def _is_regular(moments: Floats) -> bool:
    """Return whether all cycles, each from one crossing to the next but one, take about equally long."""
    cycles = moments[2:] - moments[:-2]
    middle = float(np.median(cycles))
    return bool((np.abs(cycles - middle) <= _REGULAR * middle).all())


def _slope(values: Floats) -> float:
    """Return the slope of the least-squares line through equally spaced values."""
    x = np.arange(len(values)) - 0.5 * (len(values) - 1)
    return float((x * (values - values.mean())).sum() / (x * x).sum())
