"""The hyperbolic tangent that friction is made of."""

from __future__ import annotations

from collections.abc import Callable

import numba
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sim.kernels.core.tanhs import tanh
from sim.kernels.engine.jit import FAST


@numba.njit(error_model="numpy", fastmath=FAST)
def fast_tanh(x: float) -> float:
    """As walls have it, in a loop."""
    numbers = np.full(64, x)
    for i in range(64):
        numbers[i] = tanh(numbers[i])
    return numbers[17]


both = pytest.mark.parametrize("tangent", [tanh, fast_tanh], ids=["IEEE", "fast"])


@both
@example(1e-300)
@example(-0.1733)
@example(19.9)
@settings(derandomize=True, database=None)
@given(st.one_of(st.floats(-1.0, 1.0), st.floats(-25.0, 25.0), st.floats(allow_nan=False)))
def test_it_is_right_to_the_last_digits(tangent: Callable[[float], float], x: float) -> None:
    assert abs(tangent(x) - np.tanh(x)) <= 1e-15 * abs(np.tanh(x))
    assert np.signbit(tangent(x)) == np.signbit(x)


@both
def test_bad_numbers_stay_bad(tangent: Callable[[float], float]) -> None:
    # The guard goes by them.
    assert np.isnan(tangent(np.nan))
