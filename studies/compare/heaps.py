"""How good a heap of rings is, judged by the positions of its masses alone."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sim import Scene

from .measure import Judge
from .runs import FRAME, Floats, Point

RING = 12
"""Masses of a ring."""

FAR = 1e5
"""px; a heap with a mass that far away has run away."""

LOOK_EVERY = 6
"""Frames from one measurement of the overlap to the next."""


def judge_heap(scene: Scene) -> Judge:
    """Measure overlap, masses inside other rings, and speed in the path of a heap."""
    assert scene.contact is not None
    contact = scene.contact.distance

    def judge(point: Point, path: Floats) -> None:
        if not np.abs(path).max() < FAR:
            raise ArithmeticError("ran away")
        looks = (*path[:-2:LOOK_EVERY], *path[-2:])
        point.overlap = contact - min(nearest(positions, contact) for positions in looks)
        point.inside = inside(path[-1], contact)
        speeds = (path[-1] - path[-2]) / FRAME
        point.speed = float(np.sqrt((speeds**2).sum(1).mean()))

    return judge


def _pairs(positions: Floats, contact: float) -> Iterator[tuple[Floats, Floats]]:
    """Yield the corners of each ring, and the masses of others within its bounds, widened by `contact`."""
    rings = positions.reshape(-1, RING, 2)
    low = rings.min(1) - contact
    high = rings.max(1) + contact
    for i, ring in enumerate(rings):
        near = ((positions >= low[i]) & (positions <= high[i])).all(1)
        near[RING * i : RING * (i + 1)] = False
        yield ring, positions[near]


def nearest(positions: Floats, contact: float) -> float:
    """Return the smallest distance of a mass from a spring of another ring, px; that of contact at most."""
    smallest = contact
    for ring, others in _pairs(positions, contact):
        along = np.roll(ring, -1, 0) - ring
        to = others[:, None] - ring
        part = np.clip((to * along).sum(-1) / (along**2).sum(-1), 0.0, 1.0)
        away = np.hypot(*np.moveaxis(to - part[..., None] * along, -1, 0))
        smallest = min(smallest, away.min(initial=smallest))
    return float(smallest)


def inside(positions: Floats, contact: float) -> int:
    """Count the masses inside another ring, which have an odd number of its sides to their right."""
    count = 0
    for ring, others in _pairs(positions, contact):
        (ax, ay), (bx, by) = ring.T, np.roll(ring, -1, 0).T
        x, y = others[:, :1], others[:, 1:]
        across = (ay > y) != (by > y)
        rise = np.where(ay == by, 1.0, by - ay)
        count += int(((across & (x < ax + (y - ay) * (bx - ax) / rise)).sum(1) % 2).sum())
    return count
