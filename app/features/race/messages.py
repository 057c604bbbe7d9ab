"""Messages to a page about its race."""

from __future__ import annotations

from typing import Literal

from ...wire.messages import Event, State

Out = Literal["", "exploded", "fell", "away", "misfit", "late"]
"""What has kept a body from the finish; "away": the other way, "misfit": the terrain is not for it."""


class Race(State, frozen=True, kw_only=True, omit_defaults=True):
    """The race of the body against others, if there is one.

    Attributes:
        on: whether there is.
        names: of the body and of the others.
        ways: distance of each along x since the start, px.
        seconds: simulated, since then.
        fair: whether nobody has moved or changed the body between start and end.
        finish: way of each from the start to the finish along x, px; negative to the left.
        lines: x of the finish of each, px.
        arrived: seconds that each took to the finish; null while it is on its way.
        outs: what has kept each from the finish; empty while nothing has.
        masses: how many the second body of a picture has of each of the others.
        more: whether another body can be added.
    """

    on: bool = False
    names: tuple[str, ...] = ()
    ways: tuple[float, ...] = ()
    seconds: float = 0.0
    fair: bool = True
    finish: float = 0.0
    lines: tuple[float, ...] = ()
    arrived: tuple[float | None, ...] = ()
    outs: tuple[Out, ...] = ()
    masses: tuple[int, ...] = ()
    more: bool = False


class RaceAnswer(Event, frozen=True, kw_only=True):
    """Whether a race begins: why not, in a sentence, or an empty text."""

    problem: str
