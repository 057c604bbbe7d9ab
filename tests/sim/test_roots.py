"""The inverse of a square root that forces are made of."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim.kernels.roots import inverse_root

# The first call may be compiled.
PATIENT = settings(deadline=None, derandomize=True, database=None)


@PATIENT
@given(st.floats(min_value=1e-37, max_value=1e38))
def test_it_is_right_to_the_last_bit_but_one(square: float) -> None:
    assert inverse_root(square) == pytest.approx(1.0 / np.sqrt(square), rel=4e-16, abs=0.0)


@PATIENT
@given(st.floats(min_value=0.0, max_value=1e-37))
def test_of_next_to_nothing_it_stays_finite(square: float) -> None:
    # So a spring of no length pulls at nothing, instead of making everything NaN.
    assert 1e18 < inverse_root(square) < 1e19
    assert inverse_root(square) * np.sqrt(square) <= 1.01


def test_bad_numbers_stay_bad() -> None:
    # The guard goes by them.
    assert np.isnan(inverse_root(np.nan))
    assert not inverse_root(np.inf) > 0.0
