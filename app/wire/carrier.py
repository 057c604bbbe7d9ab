"""Carries messages between page and server as letters, by viser's connection or by a line."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import NamedTuple, TypeVar

import msgspec
import numpy as np
import viser
from numpy.typing import NDArray

from sim.text import Text

from .. import viser_inside as viser_inside
from ..viser_inside import SoftrodMessage
from ..words.english import of
from .messages import FromPage, Numbers, State, ToPage, read


def _said(value: object) -> str:
    """What the page is sent of a sentence of `sim`: what it is in the language that is spoken now."""
    if isinstance(value, Text):
        return of(value)
    raise NotImplementedError(f"{type(value).__name__} cannot be sent")


_encode = msgspec.json.Encoder(enc_hook=_said).encode
_event_numbers = itertools.count()


_S = TypeVar("_S", bound=State)


class Letter(NamedTuple):
    """A message as it travels.

    Attributes:
        text: JSON.
        numbers: what the JSON does not have.
        key: of waiting letters with the same key, only the last one is sent.
    """

    text: str
    numbers: NDArray[np.float32] | None
    key: str


Post = Callable[[Letter], None]
"""Hands a letter to a connection; any thread may call."""


def encoded(message: ToPage) -> Letter:
    """Encode a message; a state or numbers replace those of the same kind that still wait to be sent."""
    kind = type(message)
    key = f"softrod-{kind.__name__ if isinstance(message, (State, Numbers)) else next(_event_numbers)}"
    if not isinstance(message, Numbers):
        return Letter(_encode(message).decode(), None, key)
    fields = msgspec.structs.asdict(message)
    numbers = fields.pop("numbers")
    return Letter(_encode({"tell": kind.__struct_config__.tag, **fields}).decode(), numbers, key)


class Mail:
    """Sends messages to the script of one page; any thread may send.

    Args:
        post: hands letters to the page's connection.
    """

    def __init__(self, post: Post) -> None:
        self._post = post
        self._states: dict[type[State], State] = {}

    def send(self, message: ToPage) -> None:
        """Send a message; a state only if it differs from the last one of its kind."""
        if isinstance(message, State):
            if self._states.get(type(message)) == message:
                return
            self._states[type(message)] = message
        self.send_letter(encoded(message))

    def send_letter(self, letter: Letter) -> None:
        """Hand an encoded message to the connection."""
        self._post(letter)

    def last_sent(self, kind: type[_S]) -> _S | None:
        """The state of a kind that was sent last."""
        state = self._states.get(kind)
        return state if isinstance(state, kind) else None


def by_viser(client: viser.ClientHandle) -> Post:
    """The post by viser's connection of a page."""
    return lambda letter: viser_inside.send(client, SoftrodMessage(*letter))


def listen(client: viser.ClientHandle, receive: Callable[[FromPage], None]) -> None:
    """Call back with every message of a page, on viser's event loop, where nothing may block."""

    def take(text: str) -> None:
        if (message := read(text)) is not None:
            receive(message)

    viser_inside.listen(client, take)
