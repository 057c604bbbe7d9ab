"""Messages about the card beside a clicked mass."""

from __future__ import annotations

from ...wire.messages import OwnBody, State


class CloseCard(OwnBody, frozen=True):
    """The card was closed."""


class MassCard(State, frozen=True, kw_only=True):
    """What the card beside a mass says.

    Attributes:
        mass: it stands beside; -1 without a card.
        joint: whose angle it says; -1 for none.
        title: what is read.
        rows: names and values.
    """

    mass: int = -1
    joint: int = -1
    title: str = ""
    rows: tuple[tuple[str, str], ...] = ()
