"""What a page says of modes, and is told of them."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from ...wire.messages import Numbers, OwnBody, State


class PutMode(OwnBody, frozen=True):
    """The body is to be put into a mode, with a part of the amplitude of a full bar."""

    mode: Annotated[int, Meta(ge=0, le=99)]
    part: Annotated[float, Meta(ge=0.0, le=1.0)]


class DriveMode(OwnBody, frozen=True):
    """A mode is to be driven as long as a bar is pressed; none (-1) from then on."""

    mode: Annotated[int, Meta(ge=-1, le=99)]


class Modes(State, frozen=True, kw_only=True, omit_defaults=True):
    """The slow vibrations of the body, where the page looks at them.

    Attributes:
        on: whether it does.
        number: of the shapes that belong to them.
        trouble: why there are none, in a sentence without a full stop; empty while they are looked for, too.
        frequencies: Hz, the slowest first.
        damping: ratios, 1 where a vibration is critically damped.
        full: amplitudes of full bars, px.
        driven: the mode that is driven, or -1.
    """

    on: bool = False
    number: int = 0
    trouble: str = ""
    frequencies: tuple[float, ...] = ()
    damping: tuple[float, ...] = ()
    full: tuple[float, ...] = ()
    driven: int = -1


class ModeShapes(Numbers, frozen=True, kw_only=True):
    """Shapes of the modes, see `modes.feature.encode_shapes`; none while nobody looks."""


class ModeLevels(Numbers, frozen=True, kw_only=True):
    """How much of each mode is in the motion now, see `modes.feature.encode_levels`."""
