"""Operations on saved scenes other than saving: none overwrites a scene or deletes it at once.

A deleted scene is moved to a separate folder, which keeps the latest ones. By default, the scenes are those
in the user's own folder.
"""

from __future__ import annotations

import itertools
import re
import threading
import time
from pathlib import Path

from ..errors import SceneError
from ..text import Text
from .files import read_scene, save_user_scene, take_out, user_folder, user_path

MAX_IN_TRASH, MAX_TRASH_BYTES = 50, 50_000_000
"""Maximum number of deleted scenes that are kept, and of their bytes; the newest is always kept."""

_TRASHED = re.compile(r"\d{20}-(.+)\.json")

# Pages of one server may do this at the same time.
_one_at_a_time = threading.RLock()


def trash_folder(folder: Path | None = None) -> Path:
    """Return the folder of a folder's deleted scenes; it may not exist yet."""
    return (folder or user_folder()) / "trash"


def rename_user_scene(name: str, wanted: str, folder: Path | None = None) -> str:
    """Rename a scene and return the name used, see `sim.store.files.safe_name`.

    Raises:
        SceneError: it does not exist, the name is not usable or taken, or a file cannot be written.
    """
    with _one_at_a_time:
        old, new = user_path(name, folder), user_path(wanted, folder)
        if new == old:
            return old.stem
        if new.exists():
            raise SceneError(
                Text("there is a scene called {name!r} already; choose another name", name=new.stem)
            )
        used = save_user_scene(read_scene(old), wanted, folder)
        _remove(old)
        return used


def duplicate_user_scene(name: str, folder: Path | None = None, source: Path | None = None) -> str:
    """Duplicate a scene and return the name of the copy.

    Args:
        name: of the scene.
        folder: where the copy is saved.
        source: the folder from which it is copied; the same by default.

    Raises:
        SceneError: it does not exist, or the copy cannot be written.
    """
    with _one_at_a_time:
        path = user_path(name, source or folder)
        return save_user_scene(read_scene(path), _free_name(path.stem, folder), folder)


def trash_user_scene(name: str, folder: Path | None = None) -> str:
    """Delete a scene and return the key by which `restore_user_scene` finds it.

    Raises:
        SceneError: it does not exist, or cannot be deleted.
    """
    with _one_at_a_time:
        path, trash = user_path(name, folder), trash_folder(folder)
        trashed = trash / f"{time.time_ns():020d}-{path.stem}.json"
        try:
            trash.mkdir(parents=True, exist_ok=True)
            path.rename(trashed)
            # Their names begin with the time of deletion.
            take_out(sorted(trash.glob("*.json"), reverse=True), MAX_IN_TRASH, MAX_TRASH_BYTES)
        except OSError as error:
            raise SceneError(
                Text("{name!r} cannot be deleted ({reason})", name=name, reason=error.strerror or str(error))
            ) from None
        return trashed.name


def restore_user_scene(trashed: str, folder: Path | None = None) -> str:
    """Restore a deleted scene and return its name: another one if its own has been taken meanwhile.

    Raises:
        SceneError: it is no longer there, or cannot be moved.
    """
    match = _TRASHED.fullmatch(trashed)
    path = trash_folder(folder) / trashed
    with _one_at_a_time:
        if match is None or path.name != trashed or not path.is_file():
            raise SceneError(Text("that scene is no longer in the trash"))
        name = _free_name(match[1], folder)
        if name == match[1]:
            try:
                path.rename(user_path(name, folder))
            except OSError as error:
                raise SceneError(
                    Text(
                        "{name!r} cannot be brought back ({reason})",
                        name=name,
                        reason=error.strerror or str(error),
                    )
                ) from None
            return name
        used = save_user_scene(read_scene(path), name, folder)
        _remove(path)
        return used


def _free_name(name: str, folder: Path | None) -> str:
    """Return the name itself, or the first of "name 2", "name 3", ... that is not taken."""
    base = re.sub(r" \d{1,4}$", "", name)
    others = (f"{base[:54].rstrip(' .-_')} {number}" for number in itertools.count(2))
    return next(each for each in itertools.chain((name,), others) if not user_path(each, folder).exists())


def _remove(path: Path) -> None:
    try:
        path.unlink()
    except OSError as error:
        raise SceneError(
            Text("{name!r} cannot be deleted ({reason})", name=path.name, reason=error.strerror or str(error))
        ) from None
