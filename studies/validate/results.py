"""Results of a validation: quantities, exact values, and whether targets are met."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sim import Integrator
from sim.scene.types import Method
from sim.solve.registry import METHODS, MethodInfo


@dataclass(frozen=True)
class Result:
    """One line of a table.

    Attributes:
        quantity: its name.
        exact: its exact value, or None where only the error has a meaning.
        softrod: its value by softrod.
        error: softrod less exact; in parts of the exact value, unless `unit` says otherwise.
        unit: unit of the error, empty for a relative one.
        slope: power with which the error goes with the step, the spacing or what else the case varies.
        target: what the error or the slope has to be, for people; empty without a target.
        met: whether the target is met.
    """

    quantity: str
    exact: float | None = None
    softrod: float | None = None
    error: float | None = None
    unit: str = ""
    slope: float | None = None
    target: str = ""
    met: bool = True


@dataclass(frozen=True)
class Case:
    """Results that belong together.

    Attributes:
        key: one word.
        title: a few words.
        notes: what is compared with what, a few sentences.
        run: yields the results; with True, only those that take little time.
    """

    key: str
    title: str
    notes: str
    run: Callable[[bool], Iterator[Result]]


def compared(quantity: str, exact: float, softrod: float, within: float | None = None) -> Result:
    """Return a result with its relative error, which has to be within ±`within` if that is given."""
    error = softrod / exact - 1.0
    if within is None:
        return Result(quantity, exact, softrod, error)
    return Result(quantity, exact, softrod, error, target=f"± {percent(within)}", met=abs(error) <= within)


def converging(
    quantity: str,
    sizes: Sequence[float],
    errors: Sequence[float],
    order: float,
    exactly: bool = True,
    unit: str = "",
) -> Result:
    """Return a result with the slope of the errors over the sizes, which has to be the order within 0.2.

    Args:
        sizes: of the step, or of whatever else the errors shrink with.
        order: the slope it has to be.
        exactly: if false, a steeper slope is good, too.
        unit: of the errors.
    """
    slope = fitted_slope(sizes, errors)
    low, high = order - 0.2, order + 0.2 if exactly else math.inf
    target = f"slope {order:g} ± 0.2" if exactly else f"slope ≥ {low:g}"
    return Result(quantity, error=errors[-1], unit=unit, slope=slope, target=target, met=low <= slope <= high)


def over_sizes(
    method: MethodInfo, sizes: Sequence[float], error: Callable[[float], float], order: float, what: str = ""
) -> Result:
    """Return a result with the slope of a method's errors over its step (s) or tolerance (px).

    Args:
        method: to which the sizes belong.
        sizes: in descending order.
        error: returns the error of a size.
        order: the lowest slope, less 0.2.
        what: put before the method's name.
    """
    if method.adaptive:
        said = f"tolerance {sizes[0]:g} to {sizes[-1]:g} px"
    else:
        said = f"dt = 1/{1.0 / sizes[0]:g} to 1/{1.0 / sizes[-1]:g} s"
    return converging(f"{what}{method.name}, {said}", sizes, [*map(error, sizes)], order, exactly=False)


def integrator_of(method: Method, size: float, between: float) -> Integrator:
    """Return a method with a step (s), or with a tolerance (px) and steps of the clock of `between` s."""
    if METHODS[method].adaptive:
        return Integrator(method=method, dt=between, tolerance=size)
    return Integrator(method=method, dt=size)


def fitted_slope(sizes: Sequence[float], errors: Sequence[float]) -> float:
    """Return the power p of errors = c sizes^p, by least squares of the logarithms."""
    return float(np.polyfit(np.log(sizes), np.log(np.abs(errors)), 1)[0])


def percent(part: float) -> str:
    """Return a relative error for people: in per cent, or as a power of ten where that is too small."""
    if part == 0.0:
        return "0"
    return f"{100.0 * part:.2g} %" if abs(part) >= 1e-5 else f"{part:.1e}"
