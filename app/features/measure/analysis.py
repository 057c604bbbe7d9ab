"""What a plot is analysed by: the amplitude spectrum of its quantities, or a curve fitted to each."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim.analysis.curves import CURVES, Curve, Number, fit_curve
from sim.analysis.spectrum import Spectrum, peaks, spectrum
from sim.errors import InputError

from ...session.plots import Plot, Span
from ...ui import readouts
from ...words import decimal, find, joined, number, say, upright
from ...words.english import of
from ...words.keys import Key

Floats = NDArray[np.float64]

NONE, SPECTRUM = "none", "spectrum"
OVER_TIME = (NONE, SPECTRUM, *CURVES)
"""What a plot over time can be analysed by."""

OVER_ANOTHER = (NONE, *(name for name in CURVES if "sine" not in name))
"""What a plot over another quantity can be."""


def label_of(kind: str) -> str:
    """What a kind of analysis is called."""
    return find(f"measure-analysis-{kind.replace(' ', '-')}", kind)


PEAKS = 5
"""Peaks of a spectrum that are labelled, at most."""

POINTS = 400
"""Points of a spectrum that are drawn."""

_SEEN = 0.02
"""Amplitude, relative to the largest, beyond the last of which a spectrum is not drawn."""

_ROUNDED = 2e-4
"""Part of a range by which places along it may be rounded."""

_NO_SPECTRUM: Key = "measure-spectrum-none"


class Fit(NamedTuple):
    """A curve fitted to a quantity, or why there is none.

    Attributes:
        curve: the curve; None if there is none.
        why_not: a sentence; empty if there is a curve.
        ends: where the points begin and end, along the axis.
    """

    curve: Curve | None
    why_not: str
    ends: tuple[float, float]

    def at(self, places: Floats) -> Floats:
        """Return its values, NaN where there were no points."""
        if self.curve is None:
            return np.full(len(places), np.nan)
        low, high = self.ends
        near = _ROUNDED * (high - low)
        return np.where((places >= low - near) & (places <= high + near), self.curve.at(places), np.nan)


def fits_of(plot: Plot, span: Span, name: str) -> tuple[Fit, ...]:
    """Fit a curve of a kind to what is in view of each quantity that is plotted upwards."""
    rows, count = plot.window(span), len(plot.spec.names)
    across = rows[:, 1 + count] if plot.spec.over else rows[:, 0]
    fits = []
    for values in rows.T[1 : 1 + count]:
        known = np.isfinite(values) & np.isfinite(across)
        x, y = across[known], values[known]
        ends = (float(x.min()), float(x.max())) if x.size else (0.0, 0.0)
        try:
            fits.append(Fit(fit_curve(name, x, y), "", ends))
        except InputError as error:
            fits.append(Fit(None, of(str(error)), ends))
    return tuple(fits)


def fits_text(plot: Plot, fits: Sequence[Fit]) -> str:
    """The numbers of fitted curves with their standard errors, as HTML."""
    over = plot.quantities[-1].unit if plot.spec.over else "s"
    lines = []
    for quantity, fit in zip(plot.quantities, fits, strict=False):
        if fit.curve is None:
            lines.append(f"{html.escape(quantity.name)}: {html.escape(fit.why_not)}")
            continue
        scatter = f"{readouts.grouped(fit.curve.deviation)} {quantity.unit}".strip()
        origin = f"{number(fit.curve.origin, 6)} {over}".strip()
        lines += [
            say("measure-fit-from", quantity=html.escape(quantity.name), place=html.escape(origin)),
            *(_said(each, quantity.unit, over) for each in fit.curve.numbers),
            say("measure-fit-deviation", deviation=html.escape(scatter)),
        ]
        in_view = fit.ends[1] - fit.ends[0]
        if any(number.name == "period" and number.value > in_view for number in fit.curve.numbers):
            lines.append(say("measure-fit-short"))
    return _text(lines)


def spectra_of(plot: Plot, span: Span) -> tuple[tuple[Spectrum | None, ...], float]:
    """The amplitude spectra of the quantities of a plot, and s of the frames in view that they are of.

    Rows that stand for several frames do not count.
    """
    rows = plot.window(span)
    rows = rows[rows[:, 0] >= plot.complete_since]
    found = tuple(
        None if np.isnan(values).any() else spectrum(rows[:, 0], values)
        for values in rows.T[1 : 1 + len(plot.spec.names)]
    )
    return found, float(np.ptp(rows[:, 0])) if len(rows) else 0.0


class DrawnSpectrum(NamedTuple):
    """What is drawn of the spectra of a plot.

    Attributes:
        frequencies: (k,) Hz.
        amplitudes: (quantities, k) NaN for a quantity without a spectrum.
        peaks: frequency, height and label of each.
        text: the peaks of each quantity, as HTML.
    """

    frequencies: Floats
    amplitudes: Floats
    peaks: tuple[tuple[float, float, str], ...]
    text: str


def draw_spectra(plot: Plot, span: Span, points: int = POINTS) -> DrawnSpectrum:
    """Find the spectra of a plot, and what is drawn of them."""
    spectra, duration = spectra_of(plot, span)
    some = [each for each in spectra if each is not None]
    if not some:
        return DrawnSpectrum(np.zeros(0), np.zeros((len(spectra), 0)), (), _text([say(_NO_SPECTRUM)]))
    frequencies = some[0].frequencies
    top = max(float(frequencies[each.amplitudes >= _SEEN * each.amplitudes.max()][-1]) for each in some)
    count = max(int(np.searchsorted(frequencies, _round_up(1.1 * top), side="right")), 2)
    starts = np.unique(np.linspace(0, count, min(points, count), endpoint=False).astype(np.int64))
    amplitudes = np.array(
        [
            np.maximum.reduceat(each.amplitudes[:count], starts)
            if each is not None
            else np.full(len(starts), np.nan)
            for each in spectra
        ]
    )
    marked, lines = [], []
    for quantity, each in zip(plot.quantities, spectra, strict=False):
        found = peaks(each, duration, PEAKS) if each is not None else []
        marked += [(peak.frequency, peak.amplitude, f"{number(peak.frequency, 4)} Hz") for peak in found]
        unit = f" {quantity.unit}" if quantity.unit else ""
        said = (
            upright(f"<b>{number(peak.frequency, 4)} Hz</b> ({readouts.grouped(peak.amplitude)}{unit})")
            for peak in found
        )
        none = say(_NO_SPECTRUM if each is None else "measure-spectrum-no-peak")
        lines.append(f"{html.escape(quantity.name)}: {joined(said) or none}")
    lines.append(say("measure-spectrum-of", seconds=number(duration)))
    return DrawnSpectrum(frequencies[starts], amplitudes, tuple(marked), _text(lines))


def _round_up(value: float) -> float:
    """The next number that is 1, 2 or 5 times a power of ten, so that the axis seldom changes."""
    power = 10.0 ** math.floor(math.log10(value)) if value > 0.0 else 1.0
    return next(power * factor for factor in (1.0, 2.0, 5.0, 10.0) if power * factor >= value)


def _text(lines: Sequence[str]) -> str:
    return f'<div class="softrod-text softrod-reading">{"<br>".join(lines)}</div>'


def _said(found: Number, unit: str, over: str) -> str:
    """A number with its standard error and its unit, as HTML."""
    power, along = found.unit
    unit = html.escape(_unit(unit if power else "", over, along)) if power or along else "°"
    name = find(f"measure-number-{found.name.replace(' ', '-')}", found.name)
    value = decimal(with_error(found.value, found.error))
    return f"{name} <b>{upright(f'{value} {unit}'.strip())}</b>"


def _unit(unit: str, over: str, along: int) -> str:
    """A unit times a power of another one."""
    if not along or not over:
        return unit
    unit, over = (f"({one})" if set(one) & {" ", "/"} else one for one in (unit, over))
    if along > 0:
        return f"{unit} {over}".strip()
    return f"{unit or '1'}/{over}{'²' if along == -2 else ''}"


def with_error(value: float, error: float) -> str:
    """A number and its standard error, with two digits of that: 9.812 ± 0.023."""
    if not error > 1e-7 * abs(value):  # nothing is noise
        return f"{value:.6g}"
    digits = 1 - math.floor(math.log10(error))
    if digits > 7 or digits < -5:
        places = digits + math.floor(math.log10(abs(value) or error))
        return f"{value:.{max(2, min(7, places))}e} ± {error:.1e}"
    return f"{round(value, digits):.{max(digits, 0)}f} ± {round(error, digits):.{max(digits, 0)}f}"
