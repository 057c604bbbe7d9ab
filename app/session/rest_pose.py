"""Where a body will come to rest with the number that a slider is being moved to."""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.equilibrium import loaded_equilibrium
from sim.compiling.compiler import for_balance, is_ready

from .analysis import Analysis

MAX_MASSES = 200
"""Masses up to which a pose at rest is computed."""
SHOWN_FOR = 0.6
"""Seconds after the last change of a number for which the pose at rest is shown."""
_QUICK = 0.05
"""Seconds of computing beyond which a body of so many masses is not tried again."""


class RestPosePreview:
    """The pose at rest of a session's body while a slider moves, computed beside the frames."""

    def __init__(self) -> None:
        self._analysis = Analysis("softrod-rest-pose", self._find)
        self._until = -np.inf
        self._slow = 0  # masses of a body that takes too long
        self._found: NDArray[np.float64] | None = None

    def update(self, simulation: sim.Simulation, now: float) -> None:
        """Compute the pose at rest after a number of the body has changed, at a wall time, s."""
        masses = len(simulation.scene.masses)
        if (
            masses > MAX_MASSES
            or masses == self._slow
            or not is_ready(for_balance(simulation.tables[0].body))
        ):
            return
        if now > self._until:
            self._found = None
        self._until = now + SHOWN_FOR
        self._analysis.start(simulation)

    def positions(self, masses: int, now: float) -> NDArray[np.float64] | None:
        """(n, 2) where the masses will rest, px; None if no number has just changed, or there is no rest."""
        result, _ = self._analysis.take()
        if result is not None:
            (self._found,) = result
        found = self._found
        return found if found is not None and now <= self._until and len(found) == masses else None

    def _find(self, scene: sim.Scene) -> tuple[NDArray[np.float64] | None]:
        began = time.thread_time()
        try:
            found = np.array(loaded_equilibrium(scene)[0].positions)
        except sim.InputError:
            found = None  # it falls, or never comes to rest
        if time.thread_time() - began > _QUICK:
            self._slow = len(scene.masses)
        return (found,)
