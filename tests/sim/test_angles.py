"""Angles of vectors, many at a time."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.engine.numerics.angles import angle_of

COORDINATE = st.floats(-1e6, 1e6) | st.floats(allow_nan=False, allow_infinity=False)


@given(COORDINATE, COORDINATE)
def test_an_angle_is_that_of_the_library(x: float, y: float) -> None:
    if max(abs(x), abs(y)) > 1e-290:
        assert angle_of(x, y) == pytest.approx(math.atan2(y, x), rel=1e-15, abs=1e-300)


def test_angles_all_around() -> None:
    angles = np.linspace(-math.pi, math.pi, 100_001)[1:-1]
    off = [angle_of(math.cos(a), math.sin(a)) - math.atan2(math.sin(a), math.cos(a)) for a in angles.tolist()]
    assert np.abs(off).max() <= 5e-16


@pytest.mark.parametrize("vector", [(0.0, 0.0), (-1.0, 0.0), (-1.0, -0.0), (1.0, -0.0), (1e-310, 0.0)])
def test_angles_on_the_axis(vector: tuple[float, float]) -> None:
    x, y = vector
    found = angle_of(x, y)
    assert found == math.atan2(y, x) and math.copysign(1.0, found) == math.copysign(1.0, y)


@pytest.mark.parametrize("vector", [(math.nan, 1.0), (1.0, math.nan), (math.nan, 0.0), (0.0, math.nan)])
def test_what_is_no_vector_has_no_angle(vector: tuple[float, float]) -> None:
    assert math.isnan(angle_of(*vector))
