"""Messages about modes, both ways."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from ...wire.messages import Numbers, OwnBody, State


class PutMode(OwnBody, frozen=True):
    """Put the body into a mode, with a part of the amplitude of a full bar."""

    mode: Annotated[int, Meta(ge=0, le=99)]
    part: Annotated[float, Meta(ge=0.0, le=1.0)]


class DriveMode(OwnBody, frozen=True):
    """Drive a mode while a bar is pressed; stop driving (-1) when it is released."""

    mode: Annotated[int, Meta(ge=-1, le=99)]


class Modes(State, frozen=True, kw_only=True, omit_defaults=True):
    """The slow vibrations of the body, while the strip of modes is open.

    Attributes:
        on: whether it is.
        number: of the shapes that belong to them.
        trouble: why there are none, in a sentence without a full stop; also empty while they are computed.
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
    """Shapes of the modes, see `modes.feature.encode_shapes`; empty while the strip is closed."""


class ModeLevels(Numbers, frozen=True, kw_only=True):
    """How much of each mode is in the present motion, see `modes.feature.encode_levels`."""
