"""A journal of runs: rows in the order in which they were done, from which the same command resumes.

The file has one JSON object per line: first a header that says what is computed, then an entry for each run
that is done. A line is written by one call; one that a power cut has torn is left out.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import ClassVar

import msgspec

import sim
from sim.errors import InputError
from sim.store.files import encode_scene, write_file

from ..reporting.report import make_folder
from .runs import Row


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A line after the first: the number of a run, from 0, and its row."""

    run: int
    row: Row


class Header(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The first line: what is computed, so that only the same is resumed. Subclasses are those of a command.

    Attributes:
        COMMAND: name of the command and of the file.
        NOUN: what the command does.
        OPTIONS: the option that each field comes from.
        scene, digest: name of the scene, and BLAKE2b of it.
        settings: assignments that hold in every run.
        duration: of a run, s.
        version: of the file's format.
    """

    COMMAND: ClassVar[str]
    NOUN: ClassVar[str]
    OPTIONS: ClassVar[dict[str, str]] = {
        "scene": "SCENE",
        "digest": "SCENE",
        "settings": "--set",
        "vary": "--vary",
        "version": "softrod",
    }

    scene: str
    digest: str
    settings: tuple[str, ...]
    duration: float
    version: int = 1

    def has(self, entry: Entry) -> bool:
        """Whether an entry can belong to one of its runs."""
        raise NotImplementedError

    def options_that_differ(self, other: Header) -> list[str]:
        """Return the options in which another header differs, each once."""
        names = (n for n in self.__struct_fields__ if getattr(self, n) != getattr(other, n))
        return list(dict.fromkeys(self.OPTIONS[name] for name in names))


class Journal:
    """The rows that are done, on the disk and in memory.

    Args:
        out: the folder; made if its parent exists.
        header: what is computed.

    Attributes:
        out: the folder.
        rows: by the number of the run.

    Raises:
        InputError: the folder cannot be made or written to, or has rows of something else.
    """

    def __init__(self, out: Path, header: Header) -> None:
        make_folder(out)
        self.out, self._path, self._header = out, out / f"{header.COMMAND}.jsonl", header
        self.rows: dict[int, Row] = {}
        lines = self.read()
        whole = b"".join([msgspec.json.encode(header) + b"\n", *lines])
        if not self._path.exists() or self._path.read_bytes() != whole:
            write_file(self._path, whole)

    def read(self) -> list[bytes]:
        """Take over the rows that are on the disk, and return their lines.

        Raises:
            InputError: the file cannot be read, or has rows of something else.
        """
        header = self._header
        try:
            first, *lines = self._path.read_bytes().splitlines(keepends=True)
        except (FileNotFoundError, ValueError):
            return []  # there is no file, or an empty one
        except OSError as error:
            raise InputError(f"{self._path}: the file cannot be read ({error.strerror or error})") from None
        try:
            there = msgspec.json.decode(first, type=type(header))
            whole = [line for line in lines if line.endswith(b"\n")]
            found = [msgspec.json.decode(line, type=Entry) for line in whole]
        except msgspec.DecodeError as error:
            raise InputError(f"{self._path}: this is not the file of a {header.NOUN} ({error})") from None
        if differ := header.options_that_differ(there):
            raise InputError(
                f"--out {self.out}: the {header.NOUN} that is there has another {' and '.join(differ)}; give "
                "the same options to go on with it, or another folder"
            )
        for number, entry in enumerate(found, start=2):
            if not header.has(entry):
                raise InputError(f"{self._path}: line {number} is not of a run of this {header.NOUN}")
        self.rows = {entry.run: entry.row for entry in found}
        return whole

    def add(self, number: int, row: Row) -> None:
        """Store the row of a run.

        Raises:
            InputError: it cannot be written.
        """
        line = msgspec.json.encode(Entry(number, row)) + b"\n"
        try:
            with self._path.open("ab") as file:
                file.write(line)
        except OSError as error:
            reason = error.strerror or error
            raise InputError(f"{self._path}: the file cannot be written ({reason})") from None
        self.rows[number] = row

    @property
    def is_mixed(self) -> bool:
        """Whether rows were computed by different machines or versions."""
        return len({row.by for row in self.rows.values()}) > 1


def digest_of(scene: sim.Scene) -> str:
    """Return BLAKE2b of a scene, which identifies it."""
    return hashlib.blake2b(encode_scene(scene), digest_size=16).hexdigest()
