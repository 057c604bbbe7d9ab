"""What a page is told of its plots."""

from __future__ import annotations

from ...wire.messages import Event


class ShowMeasures(Event, frozen=True, kw_only=True):
    """Turn to the Measure tab, where a plot is about to come."""


class Melody(Event, frozen=True, kw_only=True):
    """A plot is to be heard.

    Attributes:
        name: what is plotted.
        unit: of its values.
        values: of equal distance in time; None where there is none.
    """

    name: str
    unit: str
    values: tuple[float | None, ...]
