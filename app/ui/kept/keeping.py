"""The state of a page as its browser stores it, for a reload, an outage or a restart of the server."""

from __future__ import annotations

import base64
import zlib
from typing import Annotated

import msgspec
from msgspec import Meta

from ...session.plots import PlotSpec

MAX_BYTES = 8_000_000
"""Size of an unpacked text from a page: a scene of the largest size and what belongs to it."""


class Looks(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How the page and its tables look, as far as the server decides it.

    Attributes:
        dark: light text on a dark page.
        gizmos: arrows at held masses, which drag them along one axis.
        meter: show the stability meter always, not only near the limit.
        commas: tables are saved with decimal commas.
    """

    dark: bool = False
    gizmos: bool = False
    meter: bool = False
    commas: bool = False


DEFAULT_LOOKS = Looks()


class SavedPage(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The saved session, how the page looked, and which plots were open.

    Attributes:
        undo: secret by which the server finds the undo history; empty if there was none.
    """

    session: msgspec.Raw
    looks: Looks = DEFAULT_LOOKS
    plots: tuple[PlotSpec, ...] = ()
    undo: Annotated[str, Meta(pattern="^([0-9a-f]{32})?$")] = ""


def encode(session: bytes, looks: Looks, plots: tuple[PlotSpec, ...] = (), undo: str = "") -> bytes:
    """Encode the state of a page for its browser, as JSON."""
    return msgspec.json.encode(SavedPage(session=msgspec.Raw(session), looks=looks, plots=plots, undo=undo))


def decode(letters: str) -> SavedPage | None:
    """Decode what a page sends back; None if it is invalid. Nothing in it is trusted."""
    try:
        return msgspec.json.decode(unpacked(letters), type=SavedPage)
    except (ValueError, RecursionError):
        return None


def unpacked(letters: str) -> bytes:
    """Decompress a text from a page, up to MAX_BYTES.

    Raises:
        ValueError: it is not base64 of compressed data.
    """
    try:
        return zlib.decompressobj().decompress(base64.b64decode(letters, validate=True), MAX_BYTES)
    except zlib.error as error:
        raise ValueError(str(error)) from None


class ChunkAssembler:
    """Joins a text that arrives in parts."""

    def __init__(self) -> None:
        self._letters: list[str] = []

    @property
    def size(self) -> int:
        """Characters of the unfinished text."""
        return sum(map(len, self._letters))

    def add(self, number: int, of: int, letters: str) -> str | None:
        """Add a part, and return the text if that was the last one; start over if a part is missing."""
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
