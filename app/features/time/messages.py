"""What a page says of time."""

from __future__ import annotations

from ...wire.messages import Coordinate, OwnBody


class GoTo(OwnBody, frozen=True):
    """Show a moment of the past, s."""

    time: Coordinate


class Speed(OwnBody, frozen=True):
    """How fast time goes, simulated seconds per second."""

    speed: Coordinate
