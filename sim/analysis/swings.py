"""Period, amplitude and damping of what swings, read off a curve."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_RIPPLE = 0.03
"""Part of the curve's range by which it must go back after an extreme, or that is a ripple and none."""

_REGULAR = 0.25
"""How far a cycle may be from the median one, as a part of that, in what counts as swinging."""

_STEADY = 2e-3
"""Logarithmic decrement, in size, up to which the amplitude counts as constant."""

_STILL = 1e-9
"""Range, relative to the largest size of a value, that counts as rest."""


@dataclass(frozen=True)
class Swings:
    """What was read off.

    Attributes:
        period: s, of a whole cycle, on average.
        amplitude: of the last swing, from the centre to one side, in the unit of the values.
        centre: about what it swings, in the unit of the values.
        decrement: the logarithmic decrement, the natural logarithm of the ratio of one amplitude to that of a
            cycle later; None where the amplitude does not decay.
    """

    period: float
    amplitude: float
    centre: float
    decrement: float | None

    @property
    def loss(self) -> float:
        """Part of the amplitude that is lost in a cycle; 0 where it does not decay."""
        return -math.expm1(-self.decrement) if self.decrement is not None else 0.0


def swings(time: Floats, values: Floats) -> Swings | None:
    """Period, amplitude and damping of what swings.

    The centre is where successive extremes would come to, were their distances from it a geometric sequence
    (Aitken's delta-squared process), so that damping does not shift it. The moments at which the curve passes
    the centre are found on a straight line between two samples, and the period is the slope of a straight
    line through these moments.

    Args:
        time: (k,) s, ascending.
        values: (k,) in any unit; NaN is not allowed.

    Returns:
        None where there are not two cycles, or where these differ by more than a quarter: it does not swing.
    """
    size = float(np.abs(values).max(initial=0.0))
    reach = float(np.ptp(values)) if values.size else 0.0
    if values.size < 8 or not reach > _STILL * size:
        return None
    at = _extrema(values, _RIPPLE * reach)
    if len(at) < 4:
        return None
    extremes = np.array([_vertex(values, i) for i in at])
    centre = _centre(extremes)
    # From the first extreme to the last: what is before and after may be no swing.
    moments = _zero_crossings(time[at[0] : at[-1] + 1], values[at[0] : at[-1] + 1] - centre)
    if len(moments) < 4 or not _is_regular(moments):
        return None
    halves = np.abs(np.diff(extremes))  # twice the amplitude, wherever the centre is
    decrement = -2.0 * _slope(np.log(halves)) if len(halves) > 2 else 0.0
    return Swings(
        period=2.0 * _slope(moments),
        amplitude=0.5 * float(halves[-1]),
        centre=centre,
        decrement=decrement if decrement > _STEADY else None,
    )


def _extrema(values: Floats, least: float) -> list[int]:
    """Indices of maxima and minima in turn, between which the curve goes by some amount at least; both ends
    of the curve are none."""
    turns: list[int] = []
    high = low = 0  # of the highest and the lowest value since the last turn
    rises: bool | None = None
    for i, value in enumerate(values.tolist()):
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


def _vertex(values: Floats, i: int) -> float:
    """The extreme of the parabola through three samples."""
    before, here, after = values[i - 1 : i + 2]
    bend = before - 2.0 * here + after
    return float(here - (after - before) ** 2 / (8.0 * bend)) if bend else float(here)


def _centre(extremes: Floats) -> float:
    """The mean of Aitken's limits of three extremes each; large swings have more weight."""
    one, two, three = extremes[:-2], extremes[1:-1], extremes[2:]
    bend = one - 2.0 * two + three  # never zero, since the extremes lie on both sides
    limits = two - (two - one) * (three - two) / bend
    return float((np.abs(bend) * limits).sum() / np.abs(bend).sum())


def _zero_crossings(time: Floats, offsets: Floats) -> Floats:
    """The moments at which a curve passes zero."""
    signs = np.where(offsets >= 0.0, 1, -1)
    i = np.flatnonzero(signs[1:] != signs[:-1])
    share = offsets[i] / (offsets[i] - offsets[i + 1])
    return time[i] + share * (time[i + 1] - time[i])


def _is_regular(moments: Floats) -> bool:
    """Whether all cycles take about as long: from each passage to the next but one."""
    cycles = moments[2:] - moments[:-2]
    middle = float(np.median(cycles))
    return bool((np.abs(cycles - middle) <= _REGULAR * middle).all())


def _slope(values: Floats) -> float:
    """The slope of the straight line through equally spaced values, by least squares."""
    x = np.arange(len(values)) - 0.5 * (len(values) - 1)
    return float((x * (values - values.mean())).sum() / (x * x).sum())
