"""Where a body will rest with the number that a slider is just getting: found beside the frames."""

from __future__ import annotations

import threading
import time

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.equilibrium import loaded_equilibrium
from sim.compiling.compiler import FOR_FALLBACK, is_ready

MAX_MASSES = 200
"""Masses of a body whose pose at rest is looked for."""
SHOWN_FOR = 0.6
"""Seconds after the last change of a number for which its pose at rest is shown."""
_QUICK = 0.05
"""Seconds of computing up to which a pose at rest is found; what takes longer is not looked for again."""


class RestPosePreview:
    """The pose at rest of a session's body while a slider moves.

    It is found by a thread that is there only meanwhile, from the pose that the body has. Of numbers that
    come while it works, the last one counts.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._asked: sim.Scene | None = None
        self._works = False
        self._until = -np.inf
        self._slow = 0  # number of masses of a body that takes too long
        self._found: NDArray[np.float64] | None = None

    def look(self, simulation: sim.Simulation, now: float) -> None:
        """A number of the body has changed, at some time, s."""
        masses = len(simulation.scene.masses)
        if masses > MAX_MASSES or masses == self._slow or not is_ready(FOR_FALLBACK):
            return
        places = tuple((float(x), float(y)) for x, y in simulation.positions)
        pose = sim.Pose(positions=places, velocities=((0.0, 0.0),) * masses, damage=simulation.damage)
        with self._lock:
            if now > self._until:
                self._found = None
            self._until = now + SHOWN_FOR
            self._asked = msgspec.structs.replace(simulation.scene, pose=pose)
            if self._works:
                return
            self._works = True
        threading.Thread(target=self._run, name="softrod-rest-pose", daemon=True).start()

    def positions(self, masses: int, now: float) -> NDArray[np.float64] | None:
        """(n, 2) where the masses will rest, px; None where no number has just changed, or nothing rests."""
        found = self._found
        return found if found is not None and now <= self._until and len(found) == masses else None

    def _run(self) -> None:
        while True:
            with self._lock:
                scene, self._asked = self._asked, None
                if scene is None:
                    self._works = False
                    return
            began = time.thread_time()
            try:
                found = np.array(loaded_equilibrium(scene)[0].positions)
            except sim.InputError:
                found = None  # it falls, or comes to no rest
            if time.thread_time() - began > _QUICK:
                self._slow = len(scene.masses)
            self._found = found
