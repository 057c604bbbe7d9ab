"""What a page is told of a race."""

from __future__ import annotations

from ...wire.messages import Event, State


class Race(State, frozen=True, kw_only=True, omit_defaults=True):
    """The race of the body against another one, if there is one.

    Attributes:
        on: whether there is.
        names: of the body and of the other one.
        ways: px that each has come along x since the start.
        seconds: simulated, since then.
        fair: whether nobody has moved or changed the body since then.
        out: why the other one takes part no more; empty while it does.
    """

    on: bool = False
    names: tuple[str, str] = ("", "")
    ways: tuple[float, float] = (0.0, 0.0)
    seconds: float = 0.0
    fair: bool = True
    out: str = ""


class RaceAnswer(Event, frozen=True, kw_only=True):
    """Whether a race begins: a sentence that says why not, or nothing."""

    problem: str
