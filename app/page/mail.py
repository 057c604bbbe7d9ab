"""What the server sends to the page's script beside the body, and what the script asks it for."""

from __future__ import annotations

import itertools
import re
from typing import Annotated, Any, Literal

import msgspec
import numpy as np
import viser
from msgspec import Meta, Struct

MAIL = "/softrod/mail/"
"""Beginning of the names of the nodes that carry it; the rest is the kind."""

_ASK = re.compile(r"\d{1,15}\|ask\|(\{.{2,1000}\})", re.DOTALL)

_SceneName = Annotated[str, Meta(min_length=1, max_length=200)]


class Ask(Struct, frozen=True, forbid_unknown_fields=True, tag_field="do", tag=str.lower):
    """What the script asks for; the tag is the name of the class."""


class Share(Ask, frozen=True):
    """A link to the scene, with the present pose or without; `origin` is the page's, for the QR code."""

    pose: bool
    origin: Annotated[str, Meta(pattern=r"^https?://[A-Za-z0-9.\[\]:-]{1,250}$")]


class Offer(Ask, frozen=True):
    """Have the page open one of its dialogs, if it has the control for it."""

    what: Literal["gallery"]


class Scenes(Ask, frozen=True):
    """All scenes, and pictures of the user's own."""

    dark: bool


class OpenScene(Ask, frozen=True, tag="open"):
    """Open a scene by its name."""

    name: _SceneName


class Change(Ask, frozen=True):
    """Do something with one of the user's own scenes; `name` is that of a deleted one for "restore"."""

    how: Literal["rename", "duplicate", "delete", "restore"]
    name: _SceneName
    to: Annotated[str, Meta(max_length=200)] = ""


_decode = msgspec.json.Decoder(Share | Offer | Scenes | OpenScene | Change).decode


def parse_ask(message: object) -> Ask | None:
    """What a message of the script asks for; None if it is no such message, or makes no sense."""
    match = _ASK.fullmatch(message) if isinstance(message, str) else None
    if match is None:
        return None
    try:
        return _decode(match[1])
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return None


class Mail:
    """Sends JSON to one page's script; any thread may send.

    Of two letters of one kind that follow each other within a frame only the second arrives: what must not be
    lost has a kind of its own.
    """

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._nodes: dict[str, Any] = {}
        self._numbers = itertools.count(1)

    def send(self, kind: str, **content: Any) -> None:
        """Send a letter of a kind."""
        # The number has two equal letters differ: viser would drop the second.
        data = msgspec.json.encode({"number": next(self._numbers), **content})
        with self._client.atomic():
            if kind not in self._nodes:
                self._nodes[kind] = self._client.scene.add_point_cloud(
                    MAIL + kind, np.zeros((1, 3)), (0, 0, 0), precision="float32", visible=False
                )
            self._nodes[kind].colors = np.frombuffer(data, np.uint8)
