"""What a page is told of a table that is fitted."""

from __future__ import annotations

from ...wire.messages import Numbers


class Measured(Numbers, frozen=True, kw_only=True):
    """Where a table says that masses were: time, x and y of each place; none where no table is open."""


class Fan(Numbers, frozen=True, kw_only=True):
    """Bodies that go with what was measured about as well as the fitted one: (frames, draws, masses, 2)
    places, px, from time 0 on; none where no fit is shown.

    Attributes:
        draws, masses: how many.
        rate: frames a second.
    """

    draws: int = 0
    masses: int = 0
    rate: float = 0.0
