"""Classes on disk: while one goes on, a file holds all of it, so that a server that ends goes on with it.

A class is a folder that only its owner can read, with the room as one file and the logs that were handed in
beside it. The file is replaced as a whole, so that it is never half written. When the class is ended, the
folder goes.
"""

from __future__ import annotations

import contextlib
import logging
import re
import shutil
from pathlib import Path

import msgspec
import platformdirs

from sim.scene.validate import consistent
from sim.store.files import write_atomically

from .room import Room

FILE, BODIES = "class.json", "bodies.json"

Bodies = dict[int, tuple[int, bytes]]
"""By a seat's number, the stop that its body is at, and the keepsake of its session."""

_CODE = re.compile(r"[A-Z]{4}")
_log = logging.getLogger(__name__)


def classes_folder() -> Path:
    """Where the classes are that go on; it need not exist."""
    return platformdirs.user_data_path("softrod", appauthor=False) / "classes"


def folder_of(code: str) -> Path:
    """The folder of a class."""
    return classes_folder() / code


def write(room: bytes, code: str) -> None:
    """Write a class's file.

    Args:
        room: as `encode` gives it.
        code: the class's.

    Raises:
        OSError: it cannot be written; what was there is as it was.
    """
    _write(code, FILE, room)


def write_bodies(bodies: Bodies, code: str) -> None:
    """Write where the pupils' bodies are.

    Raises:
        OSError: as `write`.
    """
    _write(code, BODIES, msgspec.json.encode(bodies))


def read_bodies(code: str) -> Bodies:
    """Where the pupils' bodies were; nothing if that cannot be read, since they can begin anew."""
    try:
        return msgspec.json.decode((folder_of(code) / BODIES).read_bytes(), type=Bodies)
    except (OSError, ValueError):
        return {}


def _write(code: str, name: str, data: bytes) -> None:
    folder = folder_of(code)
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_atomically(folder / name, data)


def encode(room: Room) -> bytes:
    """What is written of a room."""
    return msgspec.json.encode(room)


def read_all() -> list[Room]:
    """The classes that have not been ended; a file that cannot be read is left alone, and said in the log."""
    rooms = []
    with contextlib.suppress(OSError):
        for folder in sorted(classes_folder().iterdir()):
            if not _CODE.fullmatch(folder.name):
                continue
            try:
                room = msgspec.json.decode((folder / FILE).read_bytes(), type=Room)
                for scene in room.scenes:
                    consistent(scene)
            except (OSError, ValueError) as error:
                _log.warning("the class in %s cannot go on: %s", folder, error)
                continue
            if room.code == folder.name:
                rooms.append(room)
    return rooms


def forget(code: str) -> None:
    """Take away all that there is of a class on the disk.

    Raises:
        OSError: something of it is still there.
    """
    with contextlib.suppress(FileNotFoundError):
        shutil.rmtree(folder_of(code))
