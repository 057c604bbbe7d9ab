"""Rows of runs as they come, in a file from which the same command goes on.

The file has one JSON object per line: first what is computed, then a row for each run that is done, in the
order in which they were. A line is written by one call, and one that a power cut has torn is left out.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import ClassVar, Protocol

import msgspec

import sim
from sim.errors import InputError
from sim.store.files import encode_scene, write_file

from ..reporting.output import make_folder
from .runs import Row


class Line(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A line after the first: the number of a run, from 0, and its row."""

    run: int
    row: Row


class Plan(Protocol):
    """What is computed, so that the same and nothing else goes on; a `msgspec.Struct`.

    Attributes:
        COMMAND: which has a file of its name.
        WORD: what it does is called.
        OPTIONS: what on the command line each field comes from.
    """

    COMMAND: ClassVar[str]
    WORD: ClassVar[str]
    OPTIONS: ClassVar[Mapping[str, str]]
    __struct_fields__: ClassVar[tuple[str, ...]]

    def fits(self, line: Line) -> bool:
        """Whether a line can be of one of its runs."""
        ...


class KeptRows:
    """The rows that are done, on the disk and here.

    Args:
        out: the folder; made if its parent exists.
        plan: what is computed.

    Attributes:
        out: the folder.
        rows: by the number of the run.

    Raises:
        InputError: the folder cannot be made or written to, or has rows of something else.
    """

    def __init__(self, out: Path, plan: Plan) -> None:
        make_folder(out)
        self.out, self._path, self._plan = out, out / f"{plan.COMMAND}.jsonl", plan
        self.rows: dict[int, Row] = {}
        lines = self.read()
        whole = b"".join([msgspec.json.encode(plan) + b"\n", *lines])
        if not self._path.exists() or self._path.read_bytes() != whole:
            write_file(self._path, whole)

    def read(self) -> list[bytes]:
        """Take over the rows that are on the disk, and return their lines.

        Raises:
            InputError: the file cannot be read, or has rows of something else.
        """
        plan = self._plan
        try:
            first, *lines = self._path.read_bytes().splitlines(keepends=True)
        except (FileNotFoundError, ValueError):
            return []  # there is no file, or an empty one
        except OSError as error:
            raise InputError(f"{self._path}: the file cannot be read ({error.strerror or error})") from None
        try:
            there = msgspec.json.decode(first, type=type(plan))
            whole = [line for line in lines if line.endswith(b"\n")]
            found = [msgspec.json.decode(line, type=Line) for line in whole]
        except msgspec.DecodeError as error:
            raise InputError(f"{self._path}: this is not the file of a {plan.WORD} ({error})") from None
        differ = [plan.OPTIONS[f] for f in plan.__struct_fields__ if getattr(there, f) != getattr(plan, f)]
        if differ:
            raise InputError(
                f"--out {self.out}: the {plan.WORD} that is there has another "
                f"{' and '.join(dict.fromkeys(differ))}; give the same options to go on with it, or another "
                "folder"
            )
        for number, line in enumerate(found, start=2):
            if not plan.fits(line):
                raise InputError(f"{self._path}: line {number} is not of a run of this {plan.WORD}")
        self.rows = {line.run: line.row for line in found}
        return whole

    def add(self, number: int, row: Row) -> None:
        """Keep the row of a run.

        Raises:
            InputError: it cannot be written.
        """
        line = msgspec.json.encode(Line(number, row)) + b"\n"
        try:
            with self._path.open("ab") as file:
                file.write(line)
        except OSError as error:
            reason = error.strerror or error
            raise InputError(f"{self._path}: the file cannot be written ({reason})") from None
        self.rows[number] = row


def digest_of(scene: sim.Scene) -> str:
    """BLAKE2b of a scene, to know it by."""
    return hashlib.blake2b(encode_scene(scene), digest_size=16).hexdigest()
