"""Messages to a page about a table that is fitted."""

from __future__ import annotations

from ...wire.messages import Numbers


class Measured(Numbers, frozen=True, kw_only=True):
    """The measured places of a table: time, x and y of each; empty without a table."""


class Fan(Numbers, frozen=True, kw_only=True):
    """Bodies that fit the table about as well as the fitted one: (frames, draws, masses, 2) places, px,
    from time 0 on; empty without a fit.

    Attributes:
        draws, masses: how many.
        rate: frames a second.
    """

    draws: int = 0
    masses: int = 0
    rate: float = 0.0
