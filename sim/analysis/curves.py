"""Curves fitted to measured values by least squares: line, parabola, sine, decaying sine, exponential."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..text import Text
from .spectrum import spectrum

Floats = NDArray[np.float64]

SPARE = 3
"""Points by which there are to be more than numbers of the curve, so that standard errors mean something."""

_EVALUATIONS = 400
"""Evaluations of the curve, at most, after which the search has not converged."""

_STEEPEST = 30.0
"""Largest number of time constants in the range of the points: of a faster decay they have no middle."""


class Number(NamedTuple):
    """A number of a fitted curve.

    Attributes:
        name: what it is.
        value: in its unit.
        error: its standard error, in the same unit.
        unit: power of the unit of the values, and of that along the axis: (1, -1) for a slope. (0, 0) is °.
    """

    name: str
    value: float
    error: float
    unit: tuple[int, int]


@dataclass(frozen=True)
class Curve:
    """A curve that was fitted.

    Attributes:
        name: of its kind, one of `CURVES`.
        numbers: with their standard errors.
        deviation: root mean square of the deviations of the points, in the unit of the values.
        origin: place on the axis from which its numbers count: that of the first point.
        at: gives its values, from an array of places along the axis.
    """

    name: str
    numbers: tuple[Number, ...]
    deviation: float
    origin: float
    at: Callable[[Floats], Floats]


class _Kind(NamedTuple):
    """A kind of curve, over u: 0 at the first of the points and 1 at the last.

    Attributes:
        needs, fails: why it cannot be fitted.
        values: of u and the numbers of the curve.
        slopes: derivatives of the values by the numbers, one column each.
        starts: numbers to search from, of u and the values that the curve is fitted to.
        numbers: name, unit and value of what is reported, of the numbers and the range of the points.
    """

    needs: Text
    fails: Text
    values: Callable[..., Floats]
    slopes: Callable[..., Floats]
    starts: Callable[[Floats, Floats], list[float]]
    numbers: Callable[[Floats, float], list[tuple[str, tuple[int, int], float]]]


def fit_curve(name: str, x: Floats, y: Floats) -> Curve:
    """Fit a curve to points by least squares, all with the same weight.

    Its numbers are over the distance from the first point, as in a + b (x - x0). Errors follow from the
    deviations of the points, which are taken for independent.

    Args:
        name: its kind, one of `CURVES`.
        x: (k,) places along the axis, ascending for a sine; NaN is not allowed.
        y: (k,) values.

    Raises:
        InputError: there are too few points, or the fit does not converge.
    """
    from scipy.optimize import OptimizeWarning, curve_fit

    kind = CURVES[name]
    low, reach = (float(x.min()), float(np.ptp(x))) if x.size else (0.0, 0.0)
    least = _count(kind) + SPARE
    if (points := len(np.unique(x))) < least:
        raise InputError(kind.needs.with_parts(least=least, points=points))
    size, middle = float(np.ptp(y)), float(y.mean())
    size = size if size > 0.0 else max(abs(middle), 1.0)
    u, v = (x - low) / reach, (y - middle) / size
    failed = InputError(kind.fails)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", OptimizeWarning)
            found, covariance = curve_fit(
                kind.values, u, v, kind.starts(u, v), jac=kind.slopes, maxfev=_EVALUATIONS
            )
    except (RuntimeError, ValueError, FloatingPointError):  # ValueError: it went where there are no numbers
        raise failed from None
    if not (np.isfinite(found).all() and np.isfinite(covariance).all()):
        raise failed
    return Curve(
        name,
        _numbers(kind, found, covariance, low, reach, size, middle),
        size * float(np.sqrt(np.mean((kind.values(u, *found) - v) ** 2))),
        low,
        lambda places: middle + size * kind.values((places - low) / reach, *found),
    )


def _count(kind: _Kind) -> int:
    """Return the number of numbers of a curve: those after u."""
    return kind.values.__code__.co_argcount - 1


def _numbers(
    kind: _Kind, found: Floats, covariance: Floats, low: float, reach: float, size: float, middle: float
) -> tuple[Number, ...]:
    """Return what is reported, with errors by the derivatives of each number."""

    def report(numbers: Floats) -> Floats:
        return np.array([value for _, _, value in kind.numbers(numbers, reach)])

    said = report(found)
    steps = 1e-4 * np.sqrt(np.diag(covariance)) + 1e-9 * (np.abs(found) + 1e-9)
    by = np.array(
        [(report(found + step) - report(found - step)) / (2.0 * step.sum()) for step in np.diag(steps)]
    ).T
    errors = np.sqrt(np.einsum("ij,jk,ik->i", by, covariance, by).clip(0.0))
    numbers = []
    for (name, unit, _), value, error in zip(kind.numbers(found, reach), said, errors, strict=True):
        factor = size ** unit[0]
        offset = middle if name in _LEVELS else 0.0
        numbers.append(Number(name, float(value * factor + offset), float(error * factor), unit))
    return tuple(numbers)


_LEVELS = ("start", "offset")
"""Numbers to which the mean of the values is added."""


# ------------------------------------------------------------------------- the curves
def _line(u: Floats, a: float, b: float) -> Floats:
    return a + b * u


def _parabola(u: Floats, a: float, b: float, c: float) -> Floats:
    return a + b * u + c * u * u


def _sine(u: Floats, offset: float, cosine: float, sine: float, omega: float) -> Floats:
    return offset + cosine * np.cos(omega * u) + sine * np.sin(omega * u)


def _decaying(u: Floats, offset: float, cosine: float, sine: float, omega: float, rate: float) -> Floats:
    return offset + np.exp(-_bounded(rate * u)) * (cosine * np.cos(omega * u) + sine * np.sin(omega * u))


def _exponential(u: Floats, offset: float, size: float, rate: float) -> Floats:
    return offset + size * np.exp(-_bounded(rate * u))


def _bounded(exponents: Floats) -> Floats:
    """Keep a search that goes astray within the numbers there are."""
    return np.clip(exponents, -300.0, 300.0)


def _sine_slopes(u: Floats, offset: float, cosine: float, sine: float, omega: float) -> Floats:
    c, s = np.cos(omega * u), np.sin(omega * u)
    return np.stack([np.ones_like(u), c, s, u * (sine * c - cosine * s)], axis=1)


def _decaying_slopes(
    u: Floats, offset: float, cosine: float, sine: float, omega: float, rate: float
) -> Floats:
    less = np.exp(-_bounded(rate * u))[:, None]
    swing = _sine_slopes(u, offset, cosine, sine, omega)
    away = (cosine * swing[:, 1] + sine * swing[:, 2])[:, None]
    return np.hstack([swing[:, :1], less * swing[:, 1:], -u[:, None] * less * away])


def _exponential_slopes(u: Floats, offset: float, size: float, rate: float) -> Floats:
    less = np.exp(-_bounded(rate * u))
    return np.stack([np.ones_like(u), less, -size * u * less], axis=1)


def _powers(u: Floats, *numbers: float) -> Floats:
    return np.vander(u, len(numbers), increasing=True)


def _sine_starts(u: Floats, v: Floats) -> list[float]:
    """Of all frequencies near the spectrum's highest peak, the one whose sine fits best."""
    found = spectrum(u, v)
    peak = 1.0 if found is None else found.frequencies[int(found.amplitudes[1:].argmax()) + 1]
    # The window makes a peak of less than a few cycles wide, and the line that is subtracted moves it.
    best = (math.inf, 0.0, np.zeros(3))
    for frequency in np.arange(max(peak - 2.0, 0.25), peak + 2.1, 0.25).tolist():
        omega = math.tau * frequency
        columns = _sine_slopes(u, 0.0, 0.0, 0.0, omega)[:, :3]
        numbers = np.linalg.lstsq(columns, v, rcond=None)[0]
        rest = float(((columns @ numbers - v) ** 2).sum())
        # Half a cycle can be fitted by a slow sine of any size.
        if rest < best[0] and math.hypot(*numbers[1:]) < 2.0:
            best = rest, omega, numbers
    _, omega, numbers = best
    return [*numbers.tolist(), omega]


def _decaying_starts(u: Floats, v: Floats) -> list[float]:
    """A sine, and the decay of its amplitude from the first half to the second."""
    start = _sine_starts(u, v)
    first, second = (v[half] - start[0] for half in (u < 0.5, u >= 0.5))
    ratio = float(first.std() / second.std()) if second.std() > 0.0 else 1.0
    rate = 2.0 * math.log(min(max(ratio, 1e-3), 1e3))
    more = math.exp(0.5 * rate)
    return [start[0], start[1] * more, start[2] * more, start[3], rate]


def _exponential_starts(u: Floats, v: Floats) -> list[float]:
    """Of some rates, the one whose exponential fits best."""
    best = (math.inf, [0.0, 0.0, 1.0])
    for size in np.geomspace(0.1, _STEEPEST, 12).tolist():
        for rate in (size, -size):
            # Counted from where it is largest.
            columns = np.stack([np.ones_like(u), np.exp(-rate * (u if rate > 0.0 else u - 1.0))], axis=1)
            (offset, much), *_ = np.linalg.lstsq(columns, v, rcond=None)
            rest = float(((columns @ (offset, much) - v) ** 2).sum())
            if rest < best[0]:
                best = rest, [float(offset), float(much * (1.0 if rate > 0.0 else math.exp(rate))), rate]
    return best[1]


def _swing(numbers: Floats, reach: float) -> list[tuple[str, tuple[int, int], float]]:
    offset, cosine, sine, omega = numbers[:4].tolist()
    return [
        ("offset", (1, 0), offset),
        ("amplitude", (1, 0), math.hypot(cosine, sine)),
        ("period", (0, 1), math.tau * reach / abs(omega)),
        # Of a sine: 0 where the first point is on the way up through the middle.
        ("phase", (0, 0), math.degrees(math.atan2(cosine, math.copysign(1.0, omega) * sine))),
    ]


CURVES: dict[str, _Kind] = {
    "line": _Kind(
        Text("a line takes {least} points at least, and {points} are in view", least=0, points=0),
        Text("the fit of a line does not converge: what is in view is no such curve"),
        _line,
        _powers,
        lambda u, v: [float(v[0]), float(v[-1] - v[0])],
        lambda n, reach: [("start", (1, 0), n[0]), ("slope", (1, -1), n[1] / reach)],
    ),
    "parabola": _Kind(
        Text("a parabola takes {least} points at least, and {points} are in view", least=0, points=0),
        Text("the fit of a parabola does not converge: what is in view is no such curve"),
        _parabola,
        _powers,
        lambda u, v: [float(v[0]), float(v[-1] - v[0]), 0.0],
        lambda n, reach: [
            ("start", (1, 0), n[0]),
            ("slope at the start", (1, -1), n[1] / reach),
            ("second derivative", (1, -2), 2.0 * n[2] / reach**2),
        ],
    ),
    "sine": _Kind(
        Text("a sine takes {least} points at least, and {points} are in view", least=0, points=0),
        Text("the fit of a sine does not converge: what is in view is no such curve"),
        _sine,
        _sine_slopes,
        _sine_starts,
        _swing,
    ),
    "decaying sine": _Kind(
        Text("a decaying sine takes {least} points at least, and {points} are in view", least=0, points=0),
        Text("the fit of a decaying sine does not converge: what is in view is no such curve"),
        _decaying,
        _decaying_slopes,
        _decaying_starts,
        lambda n, reach: [*_swing(n, reach), ("decay rate", (0, -1), n[4] / reach)],
    ),
    "exponential": _Kind(
        Text("an exponential takes {least} points at least, and {points} are in view", least=0, points=0),
        Text("the fit of an exponential does not converge: what is in view is no such curve"),
        _exponential,
        _exponential_slopes,
        _exponential_starts,
        lambda n, reach: [
            ("offset", (1, 0), n[0]),
            ("size", (1, 0), n[1]),
            ("decay rate", (0, -1), n[2] / reach),
        ],
    ),
}
"""The kinds of curves, by their names."""
