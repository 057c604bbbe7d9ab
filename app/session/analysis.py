"""Analyses of a session's body that run beside its frames."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

import msgspec

import sim

T = TypeVar("T")


class Analysis(Generic[T]):
    """An analysis of a scene, in a thread that exists only while there is one to analyse.

    Args:
        name: of the thread.
        analyse: what is done with a scene; must not raise.
    """

    def __init__(self, name: str, analyse: Callable[[sim.Scene], T]) -> None:
        self._name, self._analyse = name, analyse
        self._lock = threading.Lock()
        self._waiting: sim.Scene | None = None
        self._result: T | None = None
        self._is_running = False

    def take(self) -> tuple[T | None, bool]:
        """The newest result, once, or None if there is no new one; and whether another is to come."""
        with self._lock:
            result, self._result = self._result, None
            return result, self._is_running

    def start(self, simulation: sim.Simulation) -> None:
        """Analyse a body in its present pose, at zero speed.

        Of bodies that come while the thread is busy, the last one is analysed.
        """
        places = tuple((float(x), float(y)) for x, y in simulation.positions)
        still = ((0.0, 0.0),) * len(places)
        pose = sim.Pose(positions=places, velocities=still, damage=simulation.damage)
        with self._lock:
            self._waiting = msgspec.structs.replace(simulation.scene, pose=pose)
            if self._is_running:
                return
            self._is_running = True
        threading.Thread(target=self._run, name=self._name, daemon=True).start()

    def _run(self) -> None:
        while True:
            with self._lock:
                scene, self._waiting = self._waiting, None
                if scene is None:
                    self._is_running = False
                    return
            result = self._analyse(scene)
            with self._lock:
                self._result = result
