"""What undo leads to, kept for pages that come back after a reload or an outage.

A page gets it back by a secret in its keepsake. It is lost with the server, and where others need the room.
"""

from __future__ import annotations

import threading

from ...session.versions import Versions

MAX_PAGES, MAX_BYTES = 64, 128_000_000
"""Pages of which it is kept at most, and what all of it may take; the newest always is."""

_lock = threading.Lock()
_pasts: dict[str, Versions] = {}  # the oldest first


def keep(secret: str, versions: Versions) -> None:
    """A page has this to undo; it goes on changing it."""
    with _lock:
        _pasts.pop(secret, None)
        _pasts[secret] = versions
        while len(_pasts) > 1 and (
            len(_pasts) > MAX_PAGES or sum(each.bytes for each in _pasts.values()) > MAX_BYTES
        ):
            del _pasts[next(iter(_pasts))]


def of(secret: str) -> Versions | None:
    """What the page with that secret had to undo, for another connection of it; None if it is lost."""
    with _lock:
        found = _pasts.get(secret)
        return found.copy() if found is not None else None
