"""The one thread that makes files for all pages, so that none of them waits for another's film."""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable

_log = logging.getLogger(__name__)

LONGEST_BREATH = 0.05
"""Seconds that a worker pauses at most, to let pages have the interpreter."""


class Workshop:
    """Does one piece of work after the other; the thread is there from the first one on.

    It is no obstacle to the end of the program: what is half made then, nobody waits for.
    """

    def __init__(self) -> None:
        self._waiting: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None

    def submit(self, work: Callable[[], None]) -> None:
        """Have something done after all that waits; it may not raise."""
        self._waiting.put(work)
        with self._lock:
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="softrod-export", daemon=True)
                self._thread.start()

    def _run(self) -> None:
        while True:
            work = self._waiting.get()
            try:
                work()
            except Exception:
                _log.exception("a file could not be made")


class Breath:
    """Pauses for as long as was worked since the last pause: pages get at least half of the interpreter."""

    def __init__(self) -> None:
        self._since = time.perf_counter()

    def take(self) -> None:
        """Pause now."""
        time.sleep(min(time.perf_counter() - self._since, LONGEST_BREATH))
        self._since = time.perf_counter()


workshop = Workshop()
