"""Messages about plots."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from ...wire.messages import Event, Number, OwnBody


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


class InView(OwnBody, frozen=True):
    """Which part of a plot over time is in view now.

    Attributes:
        plot: id of its control.
        part: from and to, simulated s; null for all of it.
    """

    plot: Annotated[str, Meta(max_length=60)]
    part: tuple[Number, Number] | None


class Seen(OwnBody, frozen=True):
    """In which tab somebody sees plots now; they are not sent otherwise."""

    tab: Literal["measure", "lesson", ""]
