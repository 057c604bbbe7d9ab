"""Plots as sound: which values are heard, and between which bounds.

Pitch, sides and clicks are the script's (`app/ui/pitch.js`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import sim

from ...session.plots import Plot, Span
from .analysis import DrawnSpectrum
from .messages import HeardLine, Melody, Tones
from .plots import called

Floats = NDArray[np.float64]

NOTES = 240
"""Values of a melody, at most."""

_TURN = 360.0
"""Degrees of a turn, beyond which an angle in view is heard by circular tones."""

_JUMP = 180.0
"""Degrees by which two values next to each other differ where an angle jumps."""


def melody(plot: Plot, span: Span, control: str) -> Melody:
    """The past of a plot, as it is in view.

    Args:
        plot: over time, or over another quantity, which is heard, too.
        span: of its time.
        control: the id of what draws it.
    """
    rows = plot.level(plot.window(span).T).T
    if not len(rows):
        return Melody(plot=control)
    count = min(NOTES, len(rows))
    times = np.linspace(rows[0, 0], rows[-1, 0], count)
    notes = np.column_stack([np.interp(times, rows[:, 0], column) for column in rows.T])  # as it is drawn
    before = np.searchsorted(rows[:, 0], times, side="right") - 1
    for i, quantity in enumerate(plot.quantities, start=1):
        if _bounds(rows[:, [i]], quantity.unit)[2]:
            notes[:, i] = rows[before, i]  # between the two sides of a jump there is nothing
    return Melody(
        plot=control,
        way="path" if plot.spec.over else "time",
        moments=tuple(times.tolist()),
        lines=_lines(plot, rows, notes),
    )


def spectrum_melody(plot: Plot, drawn: DrawnSpectrum, control: str) -> Melody:
    """The spectra of a plot, from the lowest frequency to the highest; see `melody`."""
    quantities = plot.quantities[: len(plot.spec.names)]
    tops = {
        unit: max(
            (float(np.nanmax(a)) for q, a in zip(quantities, drawn.amplitudes, strict=True)
             if q.unit == unit and np.isfinite(a).any()),
            default=0.0,
        )
        for unit in plot.units
    }  # fmt: skip
    return Melody(
        plot=control,
        way="frequency",
        moments=tuple(drawn.frequencies.tolist()),
        lines=tuple(
            _line(plot, quantity, (0.0, tops[quantity.unit]), False, amplitudes)
            for quantity, amplitudes in zip(quantities, drawn.amplitudes, strict=True)
        )
        if drawn.frequencies.size
        else (),
    )


def tones(plot: Plot, span: Span, control: str) -> Tones:
    """The newest values of a plot, between the bounds of what is in view; see `melody`."""
    rows = plot.level(plot.window(span).T).T
    if not len(rows):
        return Tones(plot=control)
    return Tones(plot=control, time=float(rows[-1, 0]), lines=_lines(plot, rows, rows[-1:]))


def _lines(plot: Plot, rows: Floats, notes: Floats) -> tuple[HeardLine, ...]:
    """Each quantity of a plot at some moments, between the bounds that its axis has in view."""
    count = len(plot.spec.names)
    upwards, across = plot.quantities[:count], plot.quantities[count:]
    lines = []
    for i, quantity in enumerate(plot.quantities, start=1):
        axis = [k for k, q in enumerate(upwards, start=1) if q.unit == quantity.unit] if i <= count else [i]
        low, high, turns = _bounds(rows[:, axis], quantity.unit)
        is_turned = quantity not in across and plot.turned[plot.units.index(quantity.unit)]
        lines.append(_line(plot, quantity, (high, low) if is_turned else (low, high), turns, notes[:, i]))
    return tuple(lines)


def _bounds(values: Floats, unit: str) -> tuple[float, float, bool]:
    """The lowest and the highest of some values, and whether they are angles that go round."""
    finite = values[np.isfinite(values)]
    if not finite.size:
        return 0.0, 0.0, False
    low, high = float(finite.min()), float(finite.max())
    if unit != "°":
        return low, high, False
    steps = np.abs(np.diff(values, axis=0))
    return low, high, high - low > _TURN or bool((steps[np.isfinite(steps)] > _JUMP).any())


def _line(
    plot: Plot,
    quantity: sim.Quantity,
    ends: tuple[float, float],
    turns: bool,
    values: Sequence[float] | Floats,
) -> HeardLine:
    heard = tuple(float(f"{v:.6g}") if np.isfinite(v) else None for v in values)
    return HeardLine(called(plot, quantity), quantity.unit, *ends, turns, heard)
