"""What a browser keeps of its page, and gives back after a reload, an outage or a restart of the server."""

from __future__ import annotations

import base64
import zlib
from typing import Annotated

import msgspec
from msgspec import Meta

from ...session.plots import PlotSpec

MAX_BYTES = 8_000_000
"""Of what a page gives back, unpacked: a scene of the largest size, and what belongs to it."""


class Looks(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How the page and its tables look, as far as that is the server's.

    Attributes:
        dark: light on dark.
        gizmos: arrows that drag held masses along one axis.
        meter: always the stability meter, not only where it matters.
        commas: tables that are saved have decimal commas.
    """

    dark: bool = False
    gizmos: bool = False
    meter: bool = False
    commas: bool = False


PLAIN = Looks()
"""How a new page looks."""


class Kept(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A keepsake of the session, how the page and its tables looked, and which plots were open.

    Attributes:
        undo: a secret by which the server knows what there was to undo; empty if there was nothing.
    """

    session: msgspec.Raw
    looks: Looks = PLAIN
    plots: tuple[PlotSpec, ...] = ()
    undo: Annotated[str, Meta(pattern="^([0-9a-f]{32})?$")] = ""


def encode(session: bytes, looks: Looks, plots: tuple[PlotSpec, ...] = (), undo: str = "") -> bytes:
    """What the browser is to keep, JSON."""
    return msgspec.json.encode(Kept(session=msgspec.Raw(session), looks=looks, plots=plots, undo=undo))


def decode(letters: str) -> Kept | None:
    """What a page gives back; None if it makes no sense. Nothing in it is trusted."""
    try:
        return msgspec.json.decode(unpacked(letters), type=Kept)
    except (ValueError, RecursionError):
        return None


def unpacked(letters: str) -> bytes:
    """What a page has packed, at most MAX_BYTES of it.

    Raises:
        ValueError: it was not packed so.
    """
    try:
        return zlib.decompressobj().decompress(base64.b64decode(letters, validate=True), MAX_BYTES)
    except zlib.error as error:
        raise ValueError(str(error)) from None


class Parts:
    """Puts together what comes in parts."""

    def __init__(self) -> None:
        self._letters: list[str] = []

    @property
    def size(self) -> int:
        """Letters of what is not whole yet."""
        return sum(map(len, self._letters))

    def add(self, number: int, of: int, letters: str) -> str | None:
        """The whole, once the last part is there; None before that, or if a part is missing."""
        if number == 1:
            self._letters = []
        if number != len(self._letters) + 1 or number > of:
            self._letters = []
            return None
        self._letters.append(letters)
        if number < of:
            return None
        text, self._letters = "".join(self._letters), []
        return text
