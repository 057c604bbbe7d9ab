"""Work in the background, in one thread, which leaves pages at least half of the interpreter."""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable
from contextvars import copy_context
from functools import partial

_log = logging.getLogger(__name__)

LONGEST_PAUSE = 0.05
"""Seconds that a worker pauses at most, to let pages have the interpreter."""


class BackgroundWorker:
    """Does one piece of work after the other, in a thread that starts with the first one.

    It is a daemon thread: unfinished work is dropped when the program ends.
    """

    def __init__(self) -> None:
        self._waiting: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None

    def submit(self, work: Callable[[], None]) -> None:
        """Queue some work, which speaks the language that is spoken now; it may not raise."""
        self._waiting.put(partial(copy_context().run, work))
        with self._lock:
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="softrod-background", daemon=True)
                self._thread.start()

    def _run(self) -> None:
        while True:
            work = self._waiting.get()
            try:
                work()
            except Exception:
                _log.exception("work in the background has failed")


class YieldGil:
    """Pauses for as long as was worked since the last pause."""

    def __init__(self) -> None:
        self._since = time.perf_counter()

    def pause(self) -> None:
        """Pause now, for `LONGEST_PAUSE` at most."""
        time.sleep(min(time.perf_counter() - self._since, LONGEST_PAUSE))
        self._since = time.perf_counter()


file_worker = BackgroundWorker()
"""Makes files for all pages, so that none of them waits for another's film."""
