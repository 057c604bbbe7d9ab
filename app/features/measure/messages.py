"""Messages about plots."""

from __future__ import annotations

from typing import Literal

from ...wire.messages import Event, OwnBody


class ShowMeasures(Event, frozen=True, kw_only=True):
    """Turn to the Measure tab, where a plot is about to appear."""


class Melody(Event, frozen=True, kw_only=True):
    """Play a plot as a melody.

    Attributes:
        name: what is plotted.
        unit: of its values.
        values: at equal intervals of time; None for gaps.
    """

    name: str
    unit: str
    values: tuple[float | None, ...]


class FirstPlot(OwnBody, frozen=True):
    """The Measure tab is shown for the first time: it is to begin with a plot."""


class Seen(OwnBody, frozen=True):
    """In which tab somebody sees plots now; they are not sent otherwise."""

    tab: Literal["measure", "lesson", ""]
