"""The power law that a class's points follow, by least squares of the logarithms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class PowerLaw:
    """y = factor * x ** exponent."""

    factor: float
    exponent: float


def power_law(points: Sequence[tuple[float, float]]) -> PowerLaw | None:
    """Fit a power law to points: a straight line through their logarithms, by least squares.

    Args:
        points: (x, y) each, in any units.

    Returns:
        None if a number is not positive or not finite, or if all points have the same x.
    """
    found = np.array(points, float).reshape(-1, 2)
    if len(found) < 2 or not np.isfinite(found).all() or (found <= 0.0).any():
        return None
    x, y = np.log(found).T
    away = x - x.mean()
    # Settings that differ only by rounding are the same.
    if np.abs(away).max() < 1e-6:
        return None
    exponent = float(away @ y / (away @ away))
    return PowerLaw(float(np.exp(y.mean() - exponent * x.mean())), exponent)
