"""Messages to a page about what is measured on its canvas."""

from __future__ import annotations

from ...wire.messages import Numbers, State


class Tools(State, frozen=True, kw_only=True):
    """What is measured on the canvas.

    Attributes:
        traced: masses whose paths are drawn.
        seconds: length of a path in simulated time, s.
        chosen: the mass that was clicked last, or -1.
        coordinates: whether a label shows position and speed of a mass.
    """

    traced: tuple[int, ...] = ()
    seconds: int = 5
    chosen: int = -1
    coordinates: bool = False


class Arrows(Numbers, frozen=True, kw_only=True):
    """Forces, velocities and torques, see `encode` in arrows.py; empty while no arrows are shown."""
