"""The law that a class's points follow: a power law, by least squares in logarithms."""

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
    """The power law that points are closest to: the straight line of least squares through their logarithms.

    Args:
        points: (x, y) each, in any units.

    Returns:
        None where a number is not positive or not finite, or where all points have the same x.
    """
    found = np.array(points, float).reshape(-1, 2)
    if len(found) < 2 or not np.isfinite(found).all() or (found <= 0.0).any():
        return None
    x, y = np.log(found).T
    away = x - x.mean()
    # What differs by rounding alone is the same setting.
    if np.abs(away).max() < 1e-6:
        return None
    exponent = float(away @ y / (away @ away))
    return PowerLaw(float(np.exp(y.mean() - exponent * x.mean())), exponent)
