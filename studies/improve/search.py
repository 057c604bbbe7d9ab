"""CMA-ES with restarts: asks for generations of points in the unit cube, and learns from their scores.

The covariance matrix adaptation evolution strategy (Hansen 2016, "The CMA evolution strategy: a tutorial",
arXiv:1604.00772) needs no derivatives and depends only on the order of the scores, so that failed runs can
count as worst. When a search has converged, a new one begins at a random point, with twice as many points
in a generation (Auger and Hansen 2005, "A restart CMA evolution strategy with increasing population size").
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]

WIDTH = 0.3
"""Standard deviation of the first generation, as a part of each range."""

CONVERGED = 1e-5
"""A search has converged when all points of a generation are this close, as a part of each range."""

WORST = math.inf


def default_population(dimensions: int) -> int:
    """Return the number of points in a generation, by the tutorial's equation 48."""
    return 4 + math.floor(3.0 * math.log(dimensions))


class Search:
    """A search in the unit cube; it depends on nothing but its arguments and the scores.

    Args:
        start: (n,) initial point.
        population: points in the first generations.
        seed: of its random numbers, from 0.
    """

    def __init__(self, start: Sequence[float], population: int, seed: int) -> None:
        self._seed, self._restarts = seed, 0
        self._begin(np.array(start, float), population)

    def _begin(self, start: Points, population: int) -> None:
        # Here, not above: workers have no use for it.
        from cmaes import CMA

        bounds = np.tile([0.0, 1.0], (len(start), 1))
        (seed,) = np.random.SeedSequence([self._seed, self._restarts]).generate_state(1)
        self._cma = CMA(start, WIDTH, bounds=bounds, seed=int(seed), population_size=population)
        self._points: list[Points] = []

    def ask(self) -> list[list[float]]:
        """Return the points of the next generation."""
        self._points = [self._cma.ask() for _ in range(self._cma.population_size)]
        return [point.tolist() for point in self._points]

    def tell(self, scores: Sequence[float]) -> None:
        """Take the scores of the points of a generation, the lowest the best; WORST for a failed run."""
        points = np.array(self._points)
        self._cma.tell(list(zip(self._points, scores, strict=True)))
        if len(set(scores)) == 1 or float(np.ptp(points, axis=0).max()) < CONVERGED:
            self._restarts += 1
            random = np.random.default_rng([self._seed, self._restarts])
            self._begin(random.random(points.shape[1]), 2 * self._cma.population_size)
