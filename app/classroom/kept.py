"""Classes on disk: a running class is stored completely, so that a restarted server can resume it.

A class is a folder that only its owner can read, with a file of the room and the logs that were handed in.
The file is replaced as a whole, so that it is never incomplete. When the class is ended, the folder is
deleted. A lock next to the folder keeps two servers from running the same class.
"""

from __future__ import annotations

import contextlib
import logging
import re
import secrets
import shutil
from collections.abc import Collection, Mapping
from pathlib import Path

import msgspec
import platformdirs
from filelock import BaseFileLock, FileLock, Timeout

from sim.store.files import decode_scene, write_atomically

from .room import Room

FILE = "class.json"
BODIES = "bodies.json"
LOGS = "logs"

Bodies = dict[int, tuple[int, bytes]]
"""By the number of a seat: the stop of its body, and the keepsake of its session."""

_CODE = re.compile(r"[A-Z]{4}")
_GOING = ".going-"
_log = logging.getLogger(__name__)


def classes_folder() -> Path:
    """Return the folder of all running classes; it need not exist."""
    return platformdirs.user_data_path("softrod", appauthor=False) / "classes"


def folder_of(code: str) -> Path:
    """Return the folder of a class."""
    return classes_folder() / code


class Held(Exception):
    """Another server runs the class."""


def hold(code: str) -> BaseFileLock | None:
    """Keep other servers from a class until the lock is released or the process ends.

    Returns:
        the lock; None if the file system has no locks or the folder cannot be written: then writing the
        class will fail, too.

    Raises:
        Held: another server has it.
    """
    lock = FileLock(classes_folder() / f"{code}.lock", mode=0o600, thread_local=False)
    try:
        classes_folder().mkdir(mode=0o700, parents=True, exist_ok=True)
        lock.acquire(blocking=False)
    except Timeout:
        raise Held(code) from None
    except (OSError, NotImplementedError) as error:
        _log.warning("the class %s cannot be locked: %s", code, error)
        return None
    return lock


def release(lock: BaseFileLock | None) -> None:
    """Let other servers run a class."""
    if lock is not None:
        lock.release()


def remove_lock(lock: BaseFileLock | None) -> None:
    """Delete the lock of a class that was deleted; `lock` as `hold` returned it."""
    if lock is not None:
        # While it is held: whoever waits for it then finds no class.
        Path(lock.lock_file).unlink(missing_ok=True)
        lock.release()


def write(
    room: bytes, code: str, logs: Mapping[str, bytes] | None = None, gone: Collection[str] = ()
) -> None:
    """Write a class.

    Args:
        room: as `encode` returns it.
        code: the class's.
        logs: those that the room refers to and that are not on the disk yet, by their names.
        gone: names of logs that the room no longer refers to.

    Raises:
        OSError: it cannot be written; the class's file is as it was.
    """
    folder = folder_of(code)
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    for name, log in (logs or {}).items():
        (folder / LOGS).mkdir(mode=0o700, exist_ok=True)
        write_atomically(log_path(code, name), log)
    write_atomically(folder / FILE, room)
    for name in gone:
        log_path(code, name).unlink(missing_ok=True)


def log_path(code: str, name: str) -> Path:
    """Return the path of a log that was handed in."""
    return folder_of(code) / LOGS / name


def write_bodies(bodies: Bodies, code: str) -> None:
    """Write the pupils' bodies, if the class has a folder.

    Raises:
        OSError: they cannot be written; the file is as it was.
    """
    if (folder := folder_of(code)).is_dir():
        write_atomically(folder / BODIES, msgspec.json.encode(bodies))


def read_bodies(code: str) -> Bodies:
    """Read the pupils' bodies; nothing if that fails, since they can start again."""
    path = folder_of(code) / BODIES
    try:
        return msgspec.json.decode(path.read_bytes(), type=Bodies)
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, RecursionError) as error:
        _log.warning("the bodies of the class %s start again: %s: %s", code, path, error)
        return {}


def encode(room: Room) -> bytes:
    """Return a room as it is written."""
    return msgspec.json.encode(room)


def codes() -> list[str]:
    """Return the codes of the classes on the disk."""
    try:
        return sorted(folder.name for folder in classes_folder().iterdir() if _CODE.fullmatch(folder.name))
    except FileNotFoundError:
        return []
    except OSError as error:
        _log.warning("classes that have not been ended cannot go on: %s", error)
        return []


def read(code: str) -> Room | None:
    """Read a class; None if that fails, which is logged, and the file is left alone."""
    folder = folder_of(code)
    try:
        room = msgspec.json.decode(_with_present_scenes((folder / FILE).read_bytes()), type=Room)
    except (OSError, ValueError, RecursionError) as error:
        _log.warning("the class in %s cannot go on: %s", folder, error)
        return None
    return room if room.code == code else None


def _with_present_scenes(data: bytes) -> bytes:
    """Return the file of a class with its scenes in the present format.

    Raises:
        ValueError: it is no such file, or one of its scenes is not valid.
    """
    fields = msgspec.json.decode(data, type=dict[str, msgspec.Raw])
    scenes = msgspec.json.decode(fields.get("scenes", b"[]"), type=list[msgspec.Raw])
    present = [decode_scene(bytes(scene), "scene", places=False) for scene in scenes]
    return msgspec.json.encode({**fields, "scenes": present})


def forget(code: str) -> None:
    """Delete a class from the disk.

    Raises:
        OSError: some of it could not be deleted, and is where it was.
    """
    folder = folder_of(code)
    # Under another name, nobody writes anything into the folder meanwhile.
    away = folder.with_name(f"{_GOING}{secrets.token_hex(8)}")
    try:
        folder.rename(away)
    except FileNotFoundError:
        return
    try:
        shutil.rmtree(away)
    except FileNotFoundError:
        # A server that was just started deletes such folders, too.
        shutil.rmtree(away, ignore_errors=True)
    except OSError:
        with contextlib.suppress(OSError):
            away.rename(folder)
        raise


def sweep() -> None:
    """Delete what is left of classes that were being deleted when a server was killed."""
    for folder in classes_folder().glob(f"{_GOING}*"):
        shutil.rmtree(folder, ignore_errors=True)
