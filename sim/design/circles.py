"""Lengths that measured positions imply, compared with the scene's."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..scene.types import Scene

Floats = NDArray[np.float64]

# Unless noted, doubling or halving one of these numbers fails no test.
_FEWEST = 8
"""Smallest number of points through which a circle is fitted."""
_FAR = 0.02
"""Relative difference of a radius above which it is reported."""
_SURE = 4.0
"""Smallest significance of that difference, in standard deviations."""


def circle_through(places: Floats) -> tuple[float, float] | None:
    """Return the radius of the circle closest to some positions, and its standard deviation.

    The sum of squared distances from the circle is minimised (a geometric fit; Gander, Golub & Strebel 1994),
    starting from the algebraic fit of Taubin (1991). None if they lie on no circle.

    Args:
        places: (k, 2).
    """
    from scipy.optimize import least_squares

    if places.shape[0] < _FEWEST:
        return None
    middle = places.mean(axis=0)
    x, y = (places - middle).T
    z = x * x + y * y
    size = float(z.mean())
    if size == 0.0:
        return None
    weight = np.column_stack(((z - size) / (2.0 * np.sqrt(size)), x, y))
    _, _, rows = np.linalg.svd(weight, full_matrices=False)
    a = rows[2, 0] / (2.0 * np.sqrt(size))
    if a == 0.0:
        return None
    centre = -rows[2, 1:] / (2.0 * a)
    radius = float(np.sqrt(centre @ centre + size))

    def off(of: Floats) -> Floats:
        return np.hypot(x - of[0], y - of[1]) - of[2]

    found = least_squares(off, [*centre, radius], x_scale=max(radius, 1e-300))
    try:
        spread = np.linalg.inv(found.jac.T @ found.jac) * 2.0 * found.cost / (places.shape[0] - 3)
    except np.linalg.LinAlgError:
        return None
    return float(found.x[2]), float(np.sqrt(spread[2, 2]))


def rods_to_anchors(scene: Scene) -> Iterator[tuple[int, int]]:
    """Yield masses that swing at the end of one spring whose other end is held, and that spring."""
    held = {anchor.mass for anchor in scene.anchors}
    for mass in range(len(scene.masses)):
        springs = [s for s, each in enumerate(scene.linear_springs) if mass in (each.a, each.b)]
        if mass not in held and len(springs) == 1:
            each = scene.linear_springs[springs[0]]
            if (each.b if each.a == mass else each.a) in held:
                yield mass, springs[0]


def other_radius(places: Floats, fitted: Floats) -> tuple[float, float] | None:
    """Return the radius on which a mass was measured, and that of a run, if they differ significantly.

    Args:
        places, fitted: (k, 2) each; rows with NaN are left out.
    """
    there = np.isfinite(places).all(axis=1) & np.isfinite(fitted).all(axis=1)
    measured, run = circle_through(places[there]), circle_through(fitted[there])
    if measured is None or run is None:
        return None
    off = abs(measured[0] - run[0])
    if off <= max(_FAR * run[0], _SURE * measured[1]) or _SURE * measured[1] > 0.5 * measured[0]:
        return None
    return measured[0], run[0]


def all_are_angles(dimensions: Sequence[str]) -> bool:
    """Return whether only angles and angular velocities were measured."""
    return all(each in ("°", "°/s") for each in dimensions)
