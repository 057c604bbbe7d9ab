"""Where a measurement says that masses were, to be drawn over a body."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sim.design.matching import Match
from sim.design.parameters import start_of
from sim.scene.types import Scene


def places_of(
    matches: Sequence[Match], scene: Scene, scale: float = 1.0, origin: tuple[float, float] = (0.0, 0.0)
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """The places of masses that were measured; a coordinate that was not is that of the mass's start.

    Args:
        matches: columns of one measurement, see `matched`.
        scene: that they were matched with.
        scale: how many of the scene's lengths are one of those measured, where the units do not say it.
        origin: where the scene's zero is in what was measured, in the unit's lengths.

    Returns:
        (k,) rows of the measurement, and (k, 2) places there, px.
    """
    by_mass: dict[int, dict[int, NDArray[np.float64]]] = {}
    for each in matches:
        if each.quantity.kind.of == "mass" and each.quantity.kind.what in ("x", "y"):
            axis = "xy".index(each.quantity.kind.what)
            size = each.scale if each.scale is not None else scale
            lengths = each.column.values * each.unit.factor - origin[axis]
            by_mass.setdefault(each.quantity.index, {})[axis] = each.sign * (lengths * size - each.offset)
    rows, places = [np.zeros(0, np.intp)], [np.zeros((0, 2))]
    starts = start_of(scene)[0]
    for mass, axes in by_mass.items():
        known = next(iter(axes.values()))
        both = np.column_stack([axes.get(axis, np.full(known.size, starts[mass][axis])) for axis in (0, 1)])
        there = np.flatnonzero(np.isfinite(both).all(axis=1))
        rows.append(there)
        places.append(both[there])
    return np.concatenate(rows), np.concatenate(places)
