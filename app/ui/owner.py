"""The key of this computer's owner, which the terminal prints in the page's address."""

from __future__ import annotations

import contextlib
import functools
import os
import secrets
from pathlib import Path

from sim.store import files

FRAGMENT = "#owner="
"""Before the key in an address; browsers do not send what follows a #."""


def key_path() -> Path:
    """The file with the key, readable only by its owner."""
    return files.user_folder().parent / "owner-key"


def key() -> str:
    """The owner's key: the same at every start, if it can be stored."""
    return key_in(key_path())


def is_key(text: str) -> bool:
    """Return True if a page has the owner's key."""
    return secrets.compare_digest(text.encode(), key().encode())


@functools.lru_cache(maxsize=4)
def key_in(path: Path) -> str:
    """Read the key in a file, or make one."""
    made = secrets.token_urlsafe(16)
    with contextlib.suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with contextlib.suppress(FileExistsError), open(path, "x", opener=_private) as file:
            file.write(made)
        stored = path.read_text().strip()
        return stored if len(stored) >= len(made) else made
    return made


def _private(path: str, flags: int) -> int:
    return os.open(path, flags, 0o600)
