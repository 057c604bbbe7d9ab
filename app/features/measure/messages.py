"""What a page says of its plots, and what it is sent."""

from __future__ import annotations

from typing import Literal

from ...wire.messages import Event, OwnBody


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


class Seen(OwnBody, frozen=True):
    """In which tab somebody sees plots now; they are not sent otherwise."""

    tab: Literal["measure", "lesson", ""]
