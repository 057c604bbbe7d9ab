"""Which masses are near which springs, found with a k-d tree; for NumPy, and not for the kernels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Vectors = NDArray[np.complex128]
"""An array of vectors, each a complex number."""
Floats = NDArray[np.float64]
"""An array of real numbers."""
Indices = NDArray[np.int64]
"""An array of integers."""


def nearest_points(x: Vectors, a: Vectors, b: Vectors) -> Floats:
    """The point of each segment from a to b that is nearest to x, as a fraction of the way, 0..1."""
    way = b - a
    square = np.maximum(abs(way) ** 2, 1e-300)
    return np.clip(((x - a) * way.conjugate()).real / square, 0.0, 1.0)


def near_pairs(x: Vectors, masses: Indices, ends: Indices, distance: float) -> tuple[Indices, Indices]:
    """All pairs of a spring and a mass that are no farther apart than a distance.

    Args:
        x: positions, px.
        masses: indices in x of the masses, ascending.
        ends: (S, 2) indices in x of the ends of each spring.
        distance: px.

    Returns:
        (k,) the spring and the mass of each pair, in the order of springs and then of masses.
    """
    # Only scenes with contact need this import.
    from scipy.spatial import KDTree

    a, b = x[ends[:, 0]], x[ends[:, 1]]
    middle = 0.5 * (a + b)
    tree = KDTree(np.column_stack((x[masses].real, x[masses].imag)))
    around = tree.query_ball_point(
        np.column_stack((middle.real, middle.imag)), 0.5 * abs(b - a) + distance, return_sorted=True
    )
    spring = np.repeat(np.arange(len(ends)), [len(found) for found in around])
    mass = masses[np.concatenate([np.asarray(found, np.int64) for found in around])]
    t = nearest_points(x[mass], a[spring], b[spring])
    near = abs(x[mass] - a[spring] - t * (b - a)[spring]) <= distance
    return spring[near], mass[near]
