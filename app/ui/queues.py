"""Bounded queues of work for the ticker or for threads: when one is full, the page's user is told so."""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from functools import partial
from typing import Any, Generic, TypeVar

from ..session.notices import Notice
from ..words import language, say, speaking

_log = logging.getLogger(__name__)

MAX_WAITING = 100
"""Requests of one page that may wait; no person makes more."""

threads = ThreadPoolExecutor(8, thread_name_prefix="softrod-request")
"""Threads of all pages for work that would block the event loop, such as reading, packing and drawing scenes.
Some of it waits until a step of a heavy body is done; eight keep other pages from waiting for that, too."""

T = TypeVar("T")


def too_much() -> Notice:
    """Make the notice that requests are ignored."""
    return Notice("warning", say("ui-too-much"), say("ui-too-much.text"))


class BoundedQueue(Generic[T]):
    """A queue that refuses items while it is full, with one notice for all of them in the language in which
    the queue is made.

    Args:
        refuse: shows the notice to the page's user.
        max_items: its capacity.
    """

    def __init__(self, refuse: Callable[[Notice], None], max_items: int = MAX_WAITING) -> None:
        self._refuse, self._max_items = refuse, max_items
        self._items: deque[T] = deque()
        self._has_refused = False
        self._language = language()

    def __len__(self) -> int:
        return len(self._items)

    def add(self, item: T) -> None:
        """Append an item, or refuse it; any thread may call."""
        if len(self._items) < self._max_items:
            self._items.append(item)
        elif not self._has_refused:
            self._has_refused = True
            with speaking(self._language):
                self._refuse(too_much())

    def take(self) -> T:
        """Remove and return the first item.

        Raises:
            IndexError: it is empty.
        """
        item = self._items.popleft()
        self._has_refused = self._has_refused and bool(self._items)
        return item

    def clear(self) -> None:
        """Remove all items."""
        self._items.clear()
        self._has_refused = False


class SerialQueue:
    """Runs the work of one page in order, one at a time, so that no page occupies all `threads`.

    All of it runs in the context in which the queue is made, which has the language of the page's user.

    Args:
        refuse: shows a notice to the page's user when too much is waiting.
    """

    def __init__(self, refuse: Callable[[Notice], None]) -> None:
        self._waiting: BoundedQueue[Callable[[], None]] = BoundedQueue(refuse)
        self._lock = threading.Lock()
        self._context = copy_context()
        self._busy = False

    def submit(self, work: Callable[..., None], *arguments: Any) -> None:
        """Call a function in another thread, after everything that waits."""
        with self._lock:
            self._waiting.add(partial(work, *arguments))
            if self._busy:
                return
            self._busy = True
        threads.submit(self._run_next)

    def _run_next(self) -> None:
        with self._lock:
            work = self._waiting.take()
        try:
            self._context.run(work)
        except Exception:  # a defect, or a page that was closed meanwhile
            _log.exception("a request of a page failed")
        with self._lock:
            self._busy = more = len(self._waiting) > 0
        if more:
            threads.submit(self._run_next)
