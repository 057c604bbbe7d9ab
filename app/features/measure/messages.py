"""Messages about plots."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from ...wire.messages import Event, Number, OwnBody, State


class ShowMeasures(Event, frozen=True, kw_only=True):
    """Turn to the Measure tab, where a plot is about to appear."""


class HeardLine(Struct, frozen=True):
    """A line of a plot that is heard.

    Attributes:
        name: of its quantity.
        unit: of its values.
        bottom, top: the values of the lowest and of the highest tone.
        turns: whether it is an angle that goes round, and has circular tones instead.
        values: at equal intervals; None for gaps.
    """

    name: str
    unit: str
    bottom: float
    top: float
    turns: bool
    values: tuple[float | None, ...]


class Melody(Event, frozen=True, kw_only=True):
    """Play a plot as a melody.

    Attributes:
        plot: id of the control that draws it; empty where there is no plot.
        way: what passes while it is played: the time, of a plot over time or of one over its last line, or
            the frequency of a spectrum.
        number, count: the plot's place among those that are open, from 1, and how many these are.
        moments: the times or frequencies of the values.
        lines: what is heard; none without values.
    """

    plot: str = ""
    number: int = 1
    count: int = 1
    way: Literal["time", "path", "frequency"] = "time"
    moments: tuple[float, ...] = ()
    lines: tuple[HeardLine, ...] = ()


class Tones(State, frozen=True, kw_only=True):
    """The newest values of the plot that is heard while the body moves.

    Attributes:
        plot: id of the control that draws it; empty while none is heard.
        time: of the values, s.
        lines: each with one value.
    """

    plot: str = ""
    time: float = 0.0
    lines: tuple[HeardLine, ...] = ()


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
