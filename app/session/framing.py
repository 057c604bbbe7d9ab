"""Where a body moves, so that the view can show it as large as its motion lets it be."""

from __future__ import annotations

from concurrent.futures import Future

import numpy as np
from numpy.typing import NDArray

import sim
from sim.errors import InputError
from sim.scene.types import Scene

from ..background import BackgroundWorker, YieldGil
from .pacing import is_large

SECONDS = 3.0
"""Simulated seconds in which a body shows where it moves."""

STEP = 1.0 / 30.0
"""Simulated seconds between two looks at it."""

MAX_GROWTH = 4.0
"""Size of the view, in that of the body at the beginning; the view goes after a body that moves farther."""

Bounds = NDArray[np.float64]

_worker = BackgroundWorker()


def motion_bounds(scene: Scene) -> Bounds:
    """The box around all places at which a body is in the first seconds of its motion.

    Of a body that explodes, is large or travels far it is a box around its beginning.

    Args:
        scene: the scene, as it is opened.

    Returns:
        (2, 2) px: the least x and y, and the largest ones.
    """
    simulation = sim.Simulation(scene)
    radii = np.array([mass.radius for mass in scene.masses])
    first = bounds = _box(simulation.positions, radii)
    if is_large(scene):
        return first
    size, pace = max(np.ptp(first, axis=0).max(), 1e-9), YieldGil()
    for _ in range(round(SECONDS / STEP)):
        simulation.advance(STEP)
        if simulation.divergence is not None:
            return first
        now = _box(simulation.positions, radii)
        bounds = np.array((np.minimum(bounds[0], now[0]), np.maximum(bounds[1], now[1])))
        if np.ptp(bounds, axis=0).max() > MAX_GROWTH * size:
            return first + np.array([[-0.5], [0.5]]) * size
        pace.pause()
    return bounds


def _box(positions: NDArray[np.float64], radii: NDArray[np.float64]) -> Bounds:
    around = radii[:, None]
    return np.array(((positions - around).min(0), (positions + around).max(0)))


class Framing:
    """The bounds of the body that a page has opened, computed in the background."""

    def __init__(self) -> None:
        self._opening = -1
        self._found: Future[Bounds] = Future()

    def bounds(self, opening: int, scene: Scene, compiled: bool) -> Bounds | None:
        """(2, 2) px, as `motion_bounds`; None until they are known, and where they cannot be.

        Args:
            opening: number of the opened scene.
            scene: that scene.
            compiled: whether its kernels are there; else this would compile them, too, and both take longer.
        """
        if opening != self._opening and compiled:
            self._opening, found = opening, Future()
            self._found = found
            _worker.submit(lambda: _compute(scene, found))
        known = opening == self._opening and self._found.done() and self._found.exception() is None
        return self._found.result() if known else None


def _compute(scene: Scene, found: Future[Bounds]) -> None:
    try:
        found.set_result(motion_bounds(scene))
    except InputError as error:
        found.set_exception(error)
