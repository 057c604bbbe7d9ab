"""How messages travel: each in one message of viser's own kind, see `app.viser_inside.SoftrodMessage`."""

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
_numbers = itertools.count()


_S = TypeVar("_S", bound=State)


def encoded(message: ToPage) -> SoftrodMessage:
    """A message as it travels; of states and numbers, the last one takes the place of those that wait."""
    kind = type(message)
    key = f"softrod-{kind.__name__ if isinstance(message, (State, Numbers)) else next(_numbers)}"
    if not isinstance(message, Numbers):
        return SoftrodMessage(_encode(message).decode(), key=key)
    fields = msgspec.structs.asdict(message)
    numbers = fields.pop("numbers")
    return SoftrodMessage(_encode({"tell": kind.__struct_config__.tag, **fields}).decode(), numbers, key)


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
        self.send(encoded(message))

    def send(self, message: SoftrodMessage) -> None:
        """Hand a message to viser."""
        viser_inside.send(self._client, message)

    def told(self, kind: type[_S]) -> _S | None:
        """The state of a kind that the page was told last."""
        state = self._told.get(kind)
        return state if isinstance(state, kind) else None


def listen(client: viser.ClientHandle, heard: Callable[[FromPage], None]) -> None:
    """Have everything that a page says heard, on viser's event loop, where nothing may block."""

    def take(text: str) -> None:
        if (said := read(text)) is not None:
            heard(said)

    viser_inside.listen(client, take)
