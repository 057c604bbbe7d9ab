"""Messages about the description of a body."""

from __future__ import annotations

from ...wire.messages import Event, FromPage, Index


class Describe(FromPage, frozen=True):
    """Describe the part that is selected, or else a mass, or else the body.

    Attributes:
        mass: the one that keys have chosen, or that was clicked; None for none.
    """

    mass: Index | None = None


class Described(Event, frozen=True, kw_only=True):
    """What the body, or a part of it, is like, in words."""

    text: str
