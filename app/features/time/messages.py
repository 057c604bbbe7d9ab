"""Messages about time."""

from __future__ import annotations

from ...wire.messages import Coordinate, OwnBody


class GoTo(OwnBody, frozen=True):
    """Show a moment of the past, s."""

    time: Coordinate


class Speed(OwnBody, frozen=True):
    """Set the speed, simulated seconds per second."""

    speed: Coordinate
