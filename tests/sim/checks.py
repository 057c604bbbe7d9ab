"""What many tests ask: for sentences, for values that must be there, for derivatives and orders."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
import pytest
from numpy.typing import NDArray

T = TypeVar("T")
Floats = NDArray[np.float64]


def known(value: T | None) -> T:
    """The value, which must not be None."""
    assert value is not None
    return value


def refusal(error: type[Exception], act: Callable[..., object], *arguments: Any, **named: Any) -> str:
    """The one line with which a call is refused."""
    with pytest.raises(error) as caught:
        act(*arguments, **named)
    said = str(caught.value)
    assert said
    assert "\n" not in said
    return said


def derivative(function: Callable[[float], Any], step: float) -> Floats:
    """The derivative of a function at 0, by differences of order 4."""
    one, back, two, far = (np.asarray(function(k * step), float) for k in (1.0, -1.0, 2.0, -2.0))
    return (8.0 * (one - back) - (two - far)) / (12.0 * step)


def jacobian(function: Callable[[Floats], Any], at: Floats, step: float, columns: Any = None) -> Floats:
    """(..., k) the derivatives of a function by its flat arguments, or by those at some `columns`."""

    def moved(j: int, by: float) -> Floats:
        to = at.copy()
        to[j] += by
        return to

    chosen = range(at.size) if columns is None else columns
    slopes = [derivative(lambda by, j=j: function(moved(j, by)), step) for j in chosen]
    return np.moveaxis(np.array(slopes), 0, -1)


def order(steps: Sequence[float], errors: Sequence[float]) -> float:
    """The power of the step that errors go with, by the line through their logarithms."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
