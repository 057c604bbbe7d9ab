"""Amplitude spectrum of a curve, and the frequencies of its peaks."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LEAST = 16
"""Samples of a curve, at least."""

_PADDED = 4
"""Factor by which the curve is padded with zeros, so that a parabola goes through the top of a peak."""

_CYCLES = 2.0
"""Cycles of a peak within the curve, at least: what is slower is not told from a drift."""

_TOO_LOW = 0.05
"""Amplitude, relative to the highest peak's, up to which a maximum is no peak: side lobes have 0.027."""

_STILL = 1e-9
"""Range, relative to the largest magnitude of a value, up to which a curve counts as constant."""


class Spectrum(NamedTuple):
    """The amplitudes of the harmonic parts of a curve.

    Attributes:
        frequencies: (k,) Hz, from 0 in equal steps.
        amplitudes: (k,) in the unit of the values: a sine of amplitude 1 has a peak of height 1.
    """

    frequencies: Floats
    amplitudes: Floats


class Peak(NamedTuple):
    """A peak of a spectrum.

    Attributes:
        frequency: Hz.
        amplitude: in the unit of the values.
    """

    frequency: float
    amplitude: float


def spectrum(time: Floats, values: Floats) -> Spectrum | None:
    """Find the amplitude spectrum of a curve.

    The straight line that fits best is subtracted, and the rest multiplied by Hann's window, whose peaks are
    four bins wide. Samples at unequal intervals are interpolated linearly.

    Args:
        time: (k,) s, ascending.
        values: (k,) in any unit; NaN is not allowed.

    Returns:
        None if there are fewer than `LEAST` values, or if they do not change.
    """
    count = len(time)
    if count < LEAST or not float(np.ptp(values)) > _STILL * float(np.abs(values).max()):
        return None
    even = np.linspace(time[0], time[-1], count)
    evened = np.interp(even, time, values)
    about = np.linspace(-1.0, 1.0, count)
    rest = evened - evened.mean() - about * (about @ evened) / (about @ about)
    window = np.hanning(count)
    size = 2 ** math.ceil(math.log2(_PADDED * count))
    amplitudes = np.abs(np.fft.rfft(rest * window, size)) * 2.0 / window.sum()
    step = (even[-1] - even[0]) / (count - 1)
    return Spectrum(np.fft.rfftfreq(size, step), amplitudes)


def peaks(found: Spectrum, duration: float, most: int) -> list[Peak]:
    """Return the highest peaks of a spectrum, the slowest first.

    Frequency and height are those of the parabola through the logarithms of the three largest amplitudes.

    Args:
        found: the spectrum.
        duration: s, of the curve.
        most: number of peaks.
    """
    amplitudes, step = found.amplitudes, float(found.frequencies[1])
    inside = amplitudes[1:-1]
    at = np.flatnonzero((inside > amplitudes[:-2]) & (inside >= amplitudes[2:])) + 1
    at = at[at * step * duration >= _CYCLES]
    at = at[amplitudes[at] > _TOO_LOW * amplitudes[at].max(initial=0.0)]
    highest = at[np.argsort(-amplitudes[at], kind="stable")[:most]]
    return sorted(_top(amplitudes, i, step) for i in highest.tolist())


def _top(amplitudes: Floats, i: int, step: float) -> Peak:
    """Return the top of the peak at an index."""
    before, here, after = np.log(np.maximum(amplitudes[i - 1 : i + 2], 1e-300)).tolist()
    bend = before - 2.0 * here + after
    shift = 0.5 * (before - after) / bend if bend else 0.0
    return Peak((i + shift) * step, math.exp(here - 0.25 * (before - after) * shift))
