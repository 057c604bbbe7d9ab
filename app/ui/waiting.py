"""What waits for the ticker or for a thread: so much at most, and nothing is left out without a word."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Generic, TypeVar

from ..session.notices import Notice

MOST = 100
"""Requests of one page that wait at most; beyond that the page is not a person."""

TOO_MUCH = Notice(
    "warning", "That was too much at once", "What was asked for last is not done: do it again in a moment."
)

T = TypeVar("T")


class Waiting(Generic[T]):
    """A queue that takes nothing more once it is full, and says so once.

    Args:
        refuse: tells the page's user.
        most: how much it takes.
    """

    def __init__(self, refuse: Callable[[Notice], None], most: int = MOST) -> None:
        self._refuse, self._most = refuse, most
        self._items: deque[T] = deque()
        self._told = False

    def __len__(self) -> int:
        return len(self._items)

    def add(self, item: T) -> None:
        """Take something, if there is room; any thread may call."""
        if len(self._items) < self._most:
            self._items.append(item)
        elif not self._told:
            self._told = True
            self._refuse(TOO_MUCH)

    def take(self) -> T:
        """The first of what waits; there must be one."""
        item = self._items.popleft()
        self._told = self._told and bool(self._items)
        return item

    def clear(self) -> None:
        """Forget all of it."""
        self._items.clear()
        self._told = False
