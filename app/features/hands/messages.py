"""Messages about hands."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from ...wire.messages import Coordinate, Hand, Index, Key, OwnBody


class Keys(OwnBody, frozen=True):
    """The held arrow keys; repeated while there are any."""

    held: Annotated[tuple[Key, ...], Meta(max_length=4)]


class At(OwnBody, frozen=True):
    """The places of hands; sent at every animation frame in which one has moved."""

    hands: Annotated[tuple[tuple[Hand, Coordinate, Coordinate], ...], Meta(min_length=1, max_length=10)]


class Grab(OwnBody, frozen=True):
    """A hand grabs a mass."""

    hand: Hand
    mass: Index
    x: Coordinate
    y: Coordinate


class Drop(OwnBody, frozen=True):
    """A hand releases its mass."""

    hand: Hand


class Pick(OwnBody, frozen=True):
    """A mass was clicked."""

    mass: Index
