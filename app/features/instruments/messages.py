"""What a page is told of what is measured on the canvas."""

from __future__ import annotations

from ...wire.messages import Numbers, State


class Tools(State, frozen=True, kw_only=True):
    """What is measured on the canvas.

    Attributes:
        traced: masses whose path is drawn.
        seconds: of a path.
        chosen: the mass that was clicked last, or -1.
        coordinates: whether a mass is read out beside it.
    """

    traced: tuple[int, ...] = ()
    seconds: int = 5
    chosen: int = -1
    coordinates: bool = False


class Arrows(Numbers, frozen=True, kw_only=True):
    """Forces, velocities and torques, see `measure.arrows.encode`; no numbers where nobody looks at any."""
