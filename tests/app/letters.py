"""What a page is told, without a page."""

from __future__ import annotations

from functools import cache, reduce
from operator import or_
from typing import Any, TypeVar
from unittest.mock import MagicMock

import msgspec

from app.pages.sandbox import features  # noqa: F401  with all their messages
from app.wire import to_page  # noqa: F401  with its messages, too
from app.wire.carrier import Letter, Mail
from app.wire.messages import Event, State, ToPage, messages


@cache
def _decoder() -> Any:
    """Made with the first message, when all features that a test imports have been loaded."""
    return msgspec.json.Decoder(reduce(or_, (*messages(State), *messages(Event))))


_T = TypeVar("_T", bound=ToPage)


class Letters(Mail):
    """Keeps what would be sent.

    Attributes:
        sent: all of it, as it arrives; of numbers, the message that carries them.
        keys: of the messages; with the same key, a later one takes the place of an earlier one that waits.
    """

    def __init__(self) -> None:
        super().__init__(MagicMock())
        self.sent: list[Any] = []
        self.keys: list[str] = []

    def send_letter(self, letter: Letter) -> None:
        self.sent.append(_decoder().decode(letter.text) if letter.numbers is None else letter)
        self.keys.append(letter.key)

    def last(self, kind: type[_T]) -> _T:
        """The last message of a kind."""
        return [message for message in self.sent if isinstance(message, kind)][-1]
