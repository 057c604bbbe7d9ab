"""Where a search looks: CMA-ES with restarts, which asks for generations of places and is told their scores.

The covariance matrix adaptation evolution strategy (Hansen 2016, "The CMA evolution strategy: a tutorial",
arXiv:1604.00772) needs no derivatives and goes by the order of the scores alone, so that runs which failed
can count as worst. Where a search has settled, a new one begins at a random place, with twice as many places
in a generation (Auger and Hansen 2005, "A restart CMA evolution strategy with increasing population size").
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Places = NDArray[np.float64]

WIDTH = 0.3
"""Standard deviation of the first generation, as a part of each range."""

SETTLED = 1e-5
"""A search has settled when all places of a generation are as near to each other, as a part of each range."""

WORST = math.inf


def usual_population(dimensions: int) -> int:
    """Places in a generation, by the tutorial's equation 48."""
    return 4 + math.floor(3.0 * math.log(dimensions))


class Search:
    """A search in the unit cube; it depends on nothing but its arguments and what it is told.

    Args:
        start: (n,) where it begins.
        population: places in the first generations.
        seed: of its random numbers, from 0.
    """

    def __init__(self, start: Sequence[float], population: int, seed: int) -> None:
        self._seed, self._restarts = seed, 0
        self._begin(np.array(start, float), population)

    def _begin(self, start: Places, population: int) -> None:
        # Here, not above: workers have no use for it.
        from cmaes import CMA

        bounds = np.tile([0.0, 1.0], (len(start), 1))
        (seed,) = np.random.SeedSequence([self._seed, self._restarts]).generate_state(1)
        self._cma = CMA(start, WIDTH, bounds=bounds, seed=int(seed), population_size=population)
        self._places: list[Places] = []

    def ask(self) -> list[list[float]]:
        """The places of the next generation."""
        self._places = [self._cma.ask() for _ in range(self._cma.population_size)]
        return [place.tolist() for place in self._places]

    def tell(self, scores: Sequence[float]) -> None:
        """The scores of the places that were asked for, the least the best; WORST for a run that failed."""
        places = np.array(self._places)
        self._cma.tell(list(zip(self._places, scores, strict=True)))
        if len(set(scores)) == 1 or float(np.ptp(places, axis=0).max()) < SETTLED:
            self._restarts += 1
            random = np.random.default_rng([self._seed, self._restarts])
            self._begin(random.random(places.shape[1]), 2 * self._cma.population_size)
