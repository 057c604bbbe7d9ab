"""Messages about the description of a body."""

from __future__ import annotations

from ...wire.messages import Event


class Described(Event, frozen=True, kw_only=True):
    """What the body is like, in words."""

    text: str
