"""The law that a class's points follow."""

from __future__ import annotations

import math

import pytest

from app.classroom.law import power_law


def test_points_of_a_power_law_give_it_back() -> None:
    law = power_law([(x, 0.25 * x**-1.5) for x in (1e-3, 2.0, 70.0, 4e5)])
    assert law is not None
    assert law.exponent == pytest.approx(-1.5, abs=1e-12)
    assert law.factor == pytest.approx(0.25, rel=1e-12)


def test_it_is_the_line_of_least_squares_through_the_logarithms() -> None:
    # By hand: ln x = 0, 1, 2 and ln y = 0, 2, 1 have the slope 1/2 through (1, 1).
    law = power_law([(1.0, 1.0), (math.e, math.e**2), (math.e**2, math.e)])
    assert law is not None
    assert law.exponent == pytest.approx(0.5)
    assert law.factor == pytest.approx(math.exp(0.5))


@pytest.mark.parametrize(
    "points",
    [
        [], [(1.0, 2.0)], [(3.0, 1.0), (3.0, 2.0)], [(1.0, 2.0), (2.0, 0.0)], [(-1.0, 2.0), (2.0, 3.0)],
        [(1.0, 2.0), (2.0, math.nan)], [(1.0, 2.0), (math.inf, 3.0)],
    ],
)  # fmt: skip
def test_without_two_settings_and_positive_numbers_there_is_none(points: list[tuple[float, float]]) -> None:
    assert power_law(points) is None
