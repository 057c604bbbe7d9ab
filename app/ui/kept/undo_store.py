"""The undo histories of pages, in memory, for pages that come back after a reload or an outage.

A page finds its history by a secret in its saved state. Histories are lost when the server stops, and the
oldest are dropped when there are too many.
"""

from __future__ import annotations

import threading

from ...session.versions import Versions

MAX_PAGES = 64
"""Pages whose histories are stored."""

MAX_BYTES = 128_000_000
"""Memory of all histories; the newest one is stored even if it is larger."""

_lock = threading.Lock()
_histories: dict[str, Versions] = {}  # the oldest first


def store(secret: str, versions: Versions) -> None:
    """Store the history of a page, which may go on changing it."""
    with _lock:
        _histories.pop(secret, None)
        _histories[secret] = versions
        while len(_histories) > 1 and (
            len(_histories) > MAX_PAGES or sum(each.bytes for each in _histories.values()) > MAX_BYTES
        ):
            del _histories[next(iter(_histories))]


def copy_of(secret: str) -> Versions | None:
    """Copy the history of a page for another connection; None if it is lost."""
    with _lock:
        found = _histories.get(secret)
        return found.copy() if found is not None else None
