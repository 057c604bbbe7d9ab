"""The inverse of a square root that forces are made of."""

from __future__ import annotations

from collections.abc import Callable

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim.kernels.core.roots import inverse_root
from sim.kernels.engine.jit import FAST


@numba.njit(error_model="numpy", fastmath=FAST)
def fast_inverse_root(square: float) -> float:
    """As most kernels have it, in a loop: the processor's own approximation is of vectors."""
    squares = np.full(64, square)
    roots = np.empty(64)
    for i in range(64):
        roots[i] = inverse_root(squares[i])
    return roots[17]


both = pytest.mark.parametrize("root", [inverse_root, fast_inverse_root], ids=["IEEE", "fast"])
Root = Callable[[float], float]

# The first call may be compiled.
PATIENT = settings(derandomize=True, database=None)


@both
@PATIENT
@given(st.floats(min_value=1e-37, max_value=1e38))
def test_it_is_right_to_the_last_bit_but_one(root: Root, square: float) -> None:
    assert root(square) == pytest.approx(1.0 / np.sqrt(square), rel=4e-16, abs=0.0)


@both
@PATIENT
@given(st.floats(min_value=0.0, max_value=1e-37))
def test_of_next_to_nothing_it_stays_finite(root: Root, square: float) -> None:
    # So a spring of no length pulls at nothing, instead of making everything NaN.
    assert 1e18 < root(square) < 1e19
    assert root(square) * np.sqrt(square) <= 1.01


@both
def test_bad_numbers_stay_bad(root: Root) -> None:
    # The guard goes by them.
    assert np.isnan(root(np.nan))
    assert not root(np.inf) > 0.0
