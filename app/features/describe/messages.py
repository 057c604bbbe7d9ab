"""Messages about the description of a body."""

from __future__ import annotations

from typing import Literal

from ...wire.messages import Event, FromPage, Index


class Describe(FromPage, frozen=True):
    """Describe the part that is selected, or else a mass, or else the body.

    Attributes:
        mass: the one that keys have chosen, or that was clicked; None for none.
    """

    mass: Index | None = None


class FollowTouches(FromPage, frozen=True):
    """Say when the body touches something after it was free, or no longer."""

    on: bool


class Touched(Event, frozen=True, kw_only=True):
    """The body touches something after it was free."""

    by: Literal["floor", "wall", "body"]


class Described(Event, frozen=True, kw_only=True):
    """What the body, or a part of it, is like, in words."""

    text: str
