"""Rings of a heap for engines of rigid bodies: a capsule for each spring, as thick as contact is wide."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from sim import Scene

from ..heaps import RING
from ..runs import Floats


class Rings:
    """What the bodies of a heap have in common.

    Args:
        scene: a heap.

    Attributes:
        corners: (rings, 12, 2) px.
        radius: of a capsule, px.
        half: of the length of its axis, px.
        mass: kg.
        turning: stiffness between two capsules, kg px²/s² per radian; that of softrod's angular springs.
    """

    def __init__(self, scene: Scene) -> None:
        assert scene.contact is not None
        self.corners = np.array([mass.position for mass in scene.masses]).reshape(-1, RING, 2)
        self.radius = 0.5 * scene.contact.distance
        self.half = 0.5 * float(np.hypot(*(self.corners[0, 1] - self.corners[0, 0])))
        self.mass = scene.masses[0].mass
        self.turning = scene.angular_springs[0].stiffness * (2.0 * self.half) ** 2


def sides_of(ring: Floats) -> Iterator[tuple[Floats, float, float]]:
    """Middle, direction (radians) and length of each side of a ring."""
    for a, b in zip(ring, np.roll(ring, -1, 0), strict=True):
        along = b - a
        yield 0.5 * (a + b), math.atan2(along[1], along[0]), float(np.hypot(*along))


def walls_of(scene: Scene) -> list[tuple[Floats, Floats]]:
    """Ends of walls as thick as a capsule, so far out that its axis stops where softrod's wall is."""
    assert scene.contact is not None
    ends = []
    for wall in scene.walls:
        normal = np.array(wall.normal)
        along = np.array((-normal[1], normal[0]))
        middle = np.array(wall.point) - scene.contact.distance * normal
        ends.append((middle - 5000.0 * along, middle + 5000.0 * along))
    return ends
