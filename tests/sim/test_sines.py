"""The sine that gusts are made of."""

from __future__ import annotations

from collections.abc import Callable

import numba
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sim.kernels.core.sines import sine
from sim.kernels.engine.jit import FAST


@numba.njit(error_model="numpy", fastmath=FAST)
def fast_sine(angle: float) -> float:
    """As gusts have it, in a loop."""
    angles = np.full(64, angle)
    sines = np.empty(64)
    for i in range(64):
        sines[i] = sine(angles[i])
    return sines[17]


both = pytest.mark.parametrize("sines", [sine, fast_sine], ids=["IEEE", "fast"])


# The first example needs the most where the processor rounds products before it subtracts them.
@both
@example(278580043565617.0)
@settings(derandomize=True, database=None)
@given(st.one_of(st.floats(-10.0, 10.0), st.floats(-1e15, 1e15)))
def test_it_is_off_by_less_than_the_next_angle(sines: Callable[[float], float], angle: float) -> None:
    assert abs(sines(angle) - np.sin(angle)) <= 4e-16 + np.spacing(abs(angle))


@both
def test_bad_numbers_stay_bad(sines: Callable[[float], float]) -> None:
    # The guard goes by them.
    assert np.isnan(sines(np.nan))
    assert np.isnan(sines(np.inf))
