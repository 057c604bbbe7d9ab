"""How good a heap of rings is, by the places of its masses alone."""

from __future__ import annotations

import numpy as np

from .plain import Floats
from .scenes import HEAPS

RING = 12
"""Masses of a ring."""

FAR = 1e5
"""px; a heap with a mass that far away has run away."""


class Pile:
    """What is seen of a heap while it falls.

    Args:
        name: of the scene.

    Attributes:
        deepest: the deepest that a mass was closer to another ring's springs than contact begins, px.
    """

    EVERY = 6
    """It is looked at every so many frames."""

    def __init__(self, name: str) -> None:
        scene = HEAPS[name]()
        assert scene.contact is not None
        self._distance = scene.contact.distance
        self._now = self._before = np.empty((0, 2))
        self.deepest = 0.0

    def look(self, positions: Floats) -> None:
        """Take it as it is.

        Raises:
            ArithmeticError: a mass is nowhere.
        """
        if not np.abs(positions).max() < FAR:
            raise ArithmeticError("ran away")
        self._before, self._now = self._now, positions.copy()
        self.deepest = max(self.deepest, self._distance - self._nearest())

    def _pairs(self) -> list[tuple[Floats, Floats]]:
        """Corners of a ring, and masses of others within its bounds and the distance of contact."""
        rings = self._now.reshape(-1, RING, 2)
        low, high = rings.min(1) - self._distance, rings.max(1) + self._distance
        found = []
        for i, ring in enumerate(rings):
            near = ((self._now >= low[i]) & (self._now <= high[i])).all(1)
            near[RING * i : RING * (i + 1)] = False
            found.append((ring, self._now[near]))
        return found

    def _nearest(self) -> float:
        """The least distance of a mass from a spring of another ring, px."""
        least = self._distance
        for ring, others in self._pairs():
            a, along = ring, np.roll(ring, -1, 0) - ring
            to = others[:, None] - a
            part = np.clip((to * along).sum(-1) / (along**2).sum(-1), 0.0, 1.0)
            least = min(least, np.hypot(*np.moveaxis(to - part[..., None] * along, -1, 0)).min(initial=least))
        return float(least)

    def inside(self) -> int:
        """Masses that are inside a ring which is not theirs, by the number of its sides to their right."""
        count = 0
        for ring, others in self._pairs():
            (ax, ay), (bx, by) = ring.T, np.roll(ring, -1, 0).T
            x, y = others[:, :1], others[:, 1:]
            across = (ay > y) != (by > y)
            rise = np.where(ay == by, 1.0, by - ay)
            count += int(((across & (x < ax + (y - ay) * (bx - ax) / rise)).sum(1) % 2).sum())
        return count

    def speed(self, seconds: float) -> float:
        """Root mean square of the speeds between the last two looks, px/s."""
        return float(np.sqrt((((self._now - self._before) / seconds) ** 2).sum(1).mean()))
