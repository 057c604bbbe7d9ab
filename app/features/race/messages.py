"""Messages to a page about its race."""

from __future__ import annotations

from ...wire.messages import Event, State


class Race(State, frozen=True, kw_only=True, omit_defaults=True):
    """The race of the body against another one, if there is one.

    Attributes:
        on: whether there is.
        names: of the body and of the other one.
        ways: distance of each along x since the start, px.
        seconds: simulated, since then.
        fair: whether nobody has moved or changed the body since then.
        out: why the other one is out of the race; empty while it is not.
    """

    on: bool = False
    names: tuple[str, str] = ("", "")
    ways: tuple[float, float] = (0.0, 0.0)
    seconds: float = 0.0
    fair: bool = True
    out: str = ""


class RaceAnswer(Event, frozen=True, kw_only=True):
    """Whether a race begins: why not, in a sentence, or an empty text."""

    problem: str
