"""Scenes stored under a short code, for addresses that can be typed and shown as a QR code.

The code is derived from the contents, so the same scene has the same code whenever it is shared.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import threading
from pathlib import Path

from ..errors import SceneError
from ..scene.types import Scene
from ..text import Text
from .files import encode_scene, read_scene, take_out, user_folder, write_atomically

LETTERS = "23456789BCDFGHJKMNPQRSTVWXZ"
"""Letters of codes: easily distinguished, and without vowels, so that they form no words."""

SHORTEST = 4
"""Number of letters of a code, unless two scenes would share it."""

MAX_KEPT = 1000
"""Maximum number of scenes; the one not shared or opened for the longest time is deleted first."""

MAX_BYTES = 500_000
"""Maximum size of a scene's file, bytes; larger ones are sent as files."""

MAX_KEPT_BYTES = 50_000_000
"""Maximum size of all stored scenes, bytes."""

_CODE = re.compile(rf"[{LETTERS}]{{{SHORTEST},12}}")

# Pages of one server may share at the same time.
_one_at_a_time = threading.Lock()


def shared_folder() -> Path:
    """Return the folder of shared scenes; it may not exist yet."""
    return user_folder().parent / "shared"


def share_scene(scene: Scene) -> str:
    """Store a scene and return its code.

    Raises:
        SceneError: it is not valid or too large, or the file cannot be written.
    """
    data = encode_scene(scene)
    if len(data) > MAX_BYTES:
        raise SceneError(
            Text(
                "{scene!r} takes {count} bytes, more than the {most} that are kept for a short "
                "address; send the scene as a file",
                scene=scene.name,
                count=len(data),
                most=MAX_BYTES,
            )
        )
    letters = letters_of(hashlib.sha256(data).digest())
    try:
        with _one_at_a_time:
            shared_folder().mkdir(parents=True, exist_ok=True)
            for length in range(SHORTEST, len(letters)):
                path = _path(letters[:length])
                if not path.exists():
                    write_atomically(path, data)
                    newest = sorted(shared_folder().glob("*.json"), key=lambda one: -one.stat().st_mtime_ns)
                    take_out(newest, MAX_KEPT, MAX_KEPT_BYTES)
                elif path.read_bytes() != data:
                    continue
                os.utime(path)
                return letters[:length]
    except OSError as error:
        reason = error.strerror or str(error)
        raise SceneError(
            Text(
                "{folder}: the scene cannot be kept there ({reason})",
                folder=str(shared_folder()),
                reason=reason,
            )
        ) from None
    raise SceneError(Text("{folder}: no short code is left", folder=str(shared_folder())))


def shared_scene(code: str) -> Scene:
    """Return the scene stored under a code, ignoring case.

    Raises:
        SceneError: there is none, or its file is not a valid scene.
    """
    code = code.upper()
    path = _path(code)
    if not _CODE.fullmatch(code) or not path.is_file():
        raise SceneError(
            Text(
                "no scene is kept under {code!r} here: it was mistyped, is another server's, "
                "or was taken out after {most} others",
                code=code[:20],
                most=MAX_KEPT,
            )
        )
    scene = read_scene(path)
    with contextlib.suppress(OSError):
        os.utime(path)
    return scene


def _path(code: str) -> Path:
    return shared_folder() / f"{code}.json"


def letters_of(digest: bytes) -> str:
    """Return the longest code for a digest; shorter ones are its beginnings."""
    number, letters = int.from_bytes(digest), ""
    for _ in range(12):
        number, digit = divmod(number, len(LETTERS))
        letters += LETTERS[digit]
    return letters
