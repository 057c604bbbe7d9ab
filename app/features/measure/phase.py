"""A plot of quantities over another one, as SVG: viser's plots can only be over something that grows."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...session.plots import MIN_PART
from ...words import decimal

Floats = NDArray[np.float64]

WIDTH, HEIGHT = 310.0, 240.0
LEFT, RIGHT, TOP, BOTTOM = 58.0, 12.0, 10.0, 40.0
BESIDE, DIGIT = 24.0, 7.5
LABEL = 60.0
"""Width of the label of a peak."""
_ABOVE = 1.1
"""Factor by which an axis is longer, for the label of the highest peak."""
TICKS = 5
"""Marks of an axis, about."""


def ticks(low: float, high: float) -> list[float]:
    """Round numbers in a range, with equal steps of 1, 2 or 5 times a power of ten."""
    rough = (high - low) / TICKS
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * factor for factor in (1.0, 2.0, 5.0, 10.0) if power * factor >= rough)
    return [step * i for i in range(math.ceil(low / step), math.floor(high / step) + 1)]


def phase_svg(
    x: Floats,
    ys: Floats,
    past: int | None,
    colors: Sequence[str],
    labels: tuple[str, str],
    name: str,
    turned: bool = False,
    fits: Sequence[tuple[Floats, Floats]] = (),
    peaks: Sequence[tuple[float, float, str]] = (),
) -> str:
    """The plot; a disc marks the moment that is shown, and what is ahead of it is pale.

    Args:
        x: (k,) values along the axis to the right.
        ys: (quantities, k) values of each quantity that is plotted upwards.
        past: how many of the k are not ahead of the moment that is shown; None if they are of no moments.
        colors: of each quantity, as CSS has them.
        labels: of the axes, to the right and upwards.
        name: what it is, for screen readers.
        turned: whether values of `ys` grow downwards.
        fits: curves over it, each by its places to the right and upwards.
        peaks: of a spectrum: place to the right, height and label, which is left out where there is no room.
    """
    ranges = [_range(x), _range(ys)]
    (x_low, x_high), (y_low, y_high) = ranges
    if past is None and x.size:
        x_low, x_high, y_low, y_high = float(x[0]), float(x[-1]), 0.0, _ABOVE * y_high
    y_bottom, y_top = (y_high, y_low) if turned else (y_low, y_high)
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    marks = {value: decimal(f"{value:.6g}") for value in ticks(y_low, y_high)}
    left = max(LEFT, BESIDE + DIGIT * max(map(len, marks.values()), default=0))

    def across(value: float) -> float:
        return left + (right - left) * (value - x_low) / (x_high - x_low)

    def up(value: float) -> float:
        return bottom - (bottom - TOP) * (value - y_bottom) / (y_top - y_bottom)

    lines, texts = [], []
    for value in ticks(x_low, x_high):
        at = across(value)
        lines.append(f"M{at:.1f} {TOP}V{bottom}")
        texts.append(
            f'<text x="{at:.1f}" y="{bottom + 15}" text-anchor="middle">{decimal(f"{value:g}")}</text>'
        )
    for value, mark in marks.items():
        at = up(value)
        lines.append(f"M{left:g} {at:.1f}H{right}")
        texts.append(f'<text x="{left - 5:g}" y="{at + 4:.1f}" text-anchor="end">{mark}</text>')
    middle_x, middle_y = 0.5 * (left + right), 0.5 * (TOP + bottom)
    to_right, upwards = map(html.escape, labels)
    title = 'text-anchor="middle" class="softrod-axis"'
    texts.append(f'<text x="{middle_x}" y="{HEIGHT - 6}" {title}>{to_right}</text>')
    texts.append(f'<text transform="translate(11 {middle_y}) rotate(-90)" {title}>{upwards}</text>')

    def places(x: Floats, y: Floats) -> list[str]:
        return [
            f"{across(a):.1f} {up(b):.1f}" if math.isfinite(a) and math.isfinite(b) else ""
            for a, b in zip(x.tolist(), y.tolist(), strict=True)
        ]

    curves = []
    for y, color in zip(ys, colors, strict=True):
        points = places(x, y)
        ahead = points[max(past - 1, 0) :] if past is not None else []
        for part, kind in ((ahead, "softrod-ahead"), (points[:past], "")):
            if len(part) > 1 and (path := _path(part)):
                curves.append(f'<path class="{kind}" d="{path}" style="stroke:{color}"/>')
        if past and points[past - 1]:
            cx, cy = points[past - 1].split()
            curves.append(f'<circle cx="{cx}" cy="{cy}" r="4" style="fill:{color}"/>')
    curves += [f'<path class="softrod-fit" d="{_path(places(*fit))}"/>' for fit in fits]
    free: list[float] = []
    for value, height, label in sorted(peaks, key=lambda peak: -peak[1]):
        at = across(value)
        if all(abs(at - other) >= LABEL for other in free):
            free.append(at)
            at = min(max(at, left + 0.5 * LABEL), right - 0.5 * LABEL)
            y, label = up(height) - 5.0, html.escape(label)
            texts.append(f'<text x="{at:.1f}" y="{y:.1f}" text-anchor="middle">{label}</text>')
    # For phase.js, which reads the values under the pointer.
    edges = f"{left:g} {right:g} {bottom:g} {TOP:g}"
    ends = " ".join(f"{end:.9g}" for end in (x_low, x_high, y_bottom, y_top))
    return (
        f'<svg class="softrod-phase" data-edges="{edges}" data-ends="{ends}" data-right="{to_right}" '
        f'data-up="{upwards}" viewBox="0 0 {WIDTH:g} {HEIGHT:g}" role="img" '
        f'aria-label="{html.escape(name)}"><path class="softrod-phase-grid" d="{"".join(lines)}"/>'
        f'<g aria-hidden="true">{"".join(texts)}</g>{"".join(curves)}</svg>'
    )


def _path(points: list[str]) -> str:
    """A line through points, with gaps where there is none."""
    runs = [run for run in "L".join(points).replace("LL", "M").split("M") if run.strip("L")]
    return "".join("M" + run.strip("L") for run in runs)


def _range(values: Floats) -> tuple[float, float]:
    """A little more than the range of values; some range where there is none."""
    finite = values[np.isfinite(values)]
    if not finite.size:
        return 0.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    # Values that hardly differ are told apart by no marks.
    size = max(abs(low), abs(high))
    more = 0.05 * (high - low) if high - low > MIN_PART * size else 0.05 * size or 1.0
    return low - more, high + more
