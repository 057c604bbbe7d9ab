"""Folders and files of reports."""

from __future__ import annotations

from pathlib import Path

from sim.errors import InputError
from sim.files import write_atomically


def make_folder(out: Path) -> None:
    """Make the folder of `--out`, unless it is there.

    Raises:
        InputError: it cannot be made.
    """
    try:
        out.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(f"--out {out}: the folder cannot be made ({error.strerror or error})") from None


def write(path: Path, content: bytes) -> None:
    """Write a file, whole or not at all.

    Raises:
        InputError: it cannot be written.
    """
    try:
        write_atomically(path, content)
    except OSError as error:
        raise InputError(f"{path}: the file cannot be written ({error.strerror or error})") from None
