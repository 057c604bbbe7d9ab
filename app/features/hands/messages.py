"""What a page says of its hands."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from ...wire.messages import Coordinate, Hand, Index, Key, OwnBody


class Keys(OwnBody, frozen=True):
    """The arrow keys that are held; repeated while any of them is."""

    held: Annotated[tuple[Key, ...], Meta(max_length=4)]


class At(OwnBody, frozen=True):
    """Where hands are; sent at every animation frame in which one moved."""

    hands: Annotated[tuple[tuple[Hand, Coordinate, Coordinate], ...], Meta(min_length=1, max_length=10)]


class Grab(OwnBody, frozen=True):
    """A hand takes hold of a mass."""

    hand: Hand
    mass: Index
    x: Coordinate
    y: Coordinate


class Drop(OwnBody, frozen=True):
    """A hand lets go."""

    hand: Hand


class Pick(OwnBody, frozen=True):
    """A mass was clicked."""

    mass: Index
