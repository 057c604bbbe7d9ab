"""How messages travel: each in one message of viser's own kind, which viser's page never sees.

viser 1.1.1 leads every subclass of its `Message` to whoever registered for it, and a page's script takes this
one out of the queue (`app/page/body/canvas.js`). Nothing public does: `_messages`, `_websock_connection`.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import msgspec
import viser
import viser._messages

from .from_page import FromPage, read
from .to_page import State, ToPage

_encode = msgspec.json.Encoder().encode
_numbers = itertools.count()


@dataclass(init=False)
class SoftrodMessage(viser._messages.Message, include_in_scene_serialization=False):
    """Carries a message, JSON, either way."""

    text: str

    def __init__(self, text: str, key: str = "") -> None:
        self.text = text
        self._key = key

    def redundancy_key(self) -> str:
        """Of messages with the same key that wait to be sent, viser keeps the last one."""
        return self._key


_S = TypeVar("_S", bound=State)


class Mail:
    """What one page is told; any thread may tell it.

    Args:
        client: the page.
    """

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._told: dict[type[State], State] = {}

    def tell(self, message: ToPage) -> None:
        """Tell the page something; a state only if it is another one than before."""
        if isinstance(message, State):
            if self._told.get(type(message)) == message:
                return
            self._told[type(message)] = message
            key = f"softrod-{type(message).__name__}"
        else:
            key = f"softrod-{next(_numbers)}"
        self.send(_encode(message).decode(), key)

    def told(self, kind: type[_S]) -> _S | None:
        """The state of a kind that the page was told last."""
        state = self._told.get(kind)
        return state if isinstance(state, kind) else None

    def send(self, text: str, key: str) -> None:
        """Send JSON; it takes the place of what waits under the same key."""
        self._client._websock_connection.queue_message(SoftrodMessage(text, key))


def listen(client: viser.ClientHandle, heard: Callable[[FromPage], None]) -> None:
    """Have everything that a page says heard, on viser's event loop, where nothing may block."""

    def take(_: int, message: SoftrodMessage) -> None:
        if (said := read(message.text)) is not None:
            heard(said)

    client._websock_connection.register_handler(SoftrodMessage, take)
