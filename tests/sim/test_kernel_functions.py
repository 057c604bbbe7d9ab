"""Roots, sines and hyperbolic tangents as kernels have them: right to the last digits."""

from __future__ import annotations

from collections.abc import Callable

import numba
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sim.engine.jit import FAST
from sim.engine.numerics.roots import inverse_root
from sim.engine.numerics.sines import sine
from sim.engine.numerics.tanhs import tanh

Function = Callable[[float], float]


def fast(function: Function) -> Function:
    """As most kernels have it, in a loop: the processor's own approximations are of vectors."""

    @numba.njit(error_model="numpy", fastmath=FAST)
    def in_a_loop(x: float) -> float:
        numbers = np.full(64, x)
        for i in range(64):
            numbers[i] = function(numbers[i])
        return numbers[17]

    return in_a_loop


def both(function: Function) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("function", [function, fast(function)], ids=["IEEE", "fast"])


# The first call may be compiled.
PATIENT = settings(derandomize=True, database=None)


@both(inverse_root)
@PATIENT
@given(st.floats(min_value=1e-37, max_value=1e38))
def test_inverse_roots_are_right_to_the_last_bit_but_one(function: Function, square: float) -> None:
    assert function(square) == pytest.approx(1.0 / np.sqrt(square), rel=4e-16, abs=0.0)


@both(inverse_root)
@PATIENT
@given(st.floats(min_value=0.0, max_value=1e-37))
def test_the_inverse_root_of_next_to_nothing_is_finite(function: Function, square: float) -> None:
    # So a spring of no length pulls at nothing, instead of making everything NaN.
    assert 1e18 < function(square) < 1e19
    assert function(square) * np.sqrt(square) <= 1.01


# The first example needs the most where the processor rounds products before it subtracts them.
@both(sine)
@example(278580043565617.0)
@PATIENT
@given(st.one_of(st.floats(-10.0, 10.0), st.floats(-1e15, 1e15)))
def test_sines_are_off_by_less_than_the_next_angle(function: Function, angle: float) -> None:
    assert abs(function(angle) - np.sin(angle)) <= 4e-16 + np.spacing(abs(angle))


@both(tanh)
@example(1e-300)
@example(-0.1733)
@example(19.9)
@PATIENT
@given(st.one_of(st.floats(-1.0, 1.0), st.floats(-25.0, 25.0), st.floats(allow_nan=False)))
def test_hyperbolic_tangents_are_right_to_the_last_digits(function: Function, x: float) -> None:
    assert abs(function(x) - np.tanh(x)) <= 1e-15 * abs(np.tanh(x))
    assert np.signbit(function(x)) == np.signbit(x)


@pytest.mark.parametrize("way", [lambda function: function, fast], ids=["IEEE", "fast"])
def test_bad_numbers_stay_bad(way: Callable[[Function], Function]) -> None:
    # The guard goes by them.
    for function in (inverse_root, sine, tanh):
        assert np.isnan(way(function)(np.nan))
    assert np.isnan(way(sine)(np.inf))
    assert not way(inverse_root)(np.inf) > 0.0
