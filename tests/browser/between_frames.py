"""A solver as a test may see it: between two frames of the ticker, which runs in a thread of its own."""

from __future__ import annotations

import threading
from typing import Any

import sim

FRAME_LOCK = threading.RLock()
"""Held by the ticker while it makes a frame (see the fixture `frames_are_whole`), and here while a solver is
looked at: in the middle of a frame a body may have its new number of masses, and the old one's places."""


class BetweenFrames:
    """A solver as it is between two frames: whatever is read or called of it waits for the frame's end."""

    def __init__(self, simulation: sim.Simulation) -> None:
        self._simulation = simulation

    def __getattr__(self, name: str) -> Any:
        with FRAME_LOCK:
            found = getattr(self._simulation, name)
        if not callable(found):
            return found

        def call(*arguments: Any) -> Any:
            with FRAME_LOCK:
                return found(*arguments)

        return call
