"""Carries messages between page and server, each inside a `app.viser_inside.SoftrodMessage`."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import TypeVar

import msgspec
import viser

from .. import viser_inside as viser_inside
from ..viser_inside import SoftrodMessage
from .messages import FromPage, Numbers, State, ToPage, read

_encode = msgspec.json.Encoder().encode
_event_numbers = itertools.count()


_S = TypeVar("_S", bound=State)


def encoded(message: ToPage) -> SoftrodMessage:
    """Encode a message; a state or numbers replace those of the same kind that still wait to be sent."""
    kind = type(message)
    key = f"softrod-{kind.__name__ if isinstance(message, (State, Numbers)) else next(_event_numbers)}"
    if not isinstance(message, Numbers):
        return SoftrodMessage(_encode(message).decode(), key=key)
    fields = msgspec.structs.asdict(message)
    numbers = fields.pop("numbers")
    return SoftrodMessage(_encode({"tell": kind.__struct_config__.tag, **fields}).decode(), numbers, key)


class Mail:
    """Sends messages to the script of one page; any thread may send.

    Args:
        client: the page.
    """

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._states: dict[type[State], State] = {}

    def send(self, message: ToPage) -> None:
        """Send a message; a state only if it differs from the last one of its kind."""
        if isinstance(message, State):
            if self._states.get(type(message)) == message:
                return
            self._states[type(message)] = message
        self.send_encoded(encoded(message))

    def send_encoded(self, message: SoftrodMessage) -> None:
        """Hand an encoded message to viser."""
        viser_inside.send(self._client, message)

    def last_sent(self, kind: type[_S]) -> _S | None:
        """The state of a kind that was sent last."""
        state = self._states.get(kind)
        return state if isinstance(state, kind) else None


def listen(client: viser.ClientHandle, receive: Callable[[FromPage], None]) -> None:
    """Call back with every message of a page, on viser's event loop, where nothing may block."""

    def take(text: str) -> None:
        if (message := read(text)) is not None:
            receive(message)

    viser_inside.listen(client, take)
