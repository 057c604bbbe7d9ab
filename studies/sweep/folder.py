"""The folder of a sweep: the rows as they come, what they are of, and the table at the end.

`sweep.jsonl` has one JSON object per line: first what is swept, then a row for each run that is done, in the
order in which they were. A line is written by one call, and one that a power cut has torn is left out.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from pathlib import Path

import msgspec

from sim.errors import InputError
from sim.store.files import encode_scene, write_file

from ..reporting.output import comma_separated, make_folder
from .grid import Grid
from .measures import MEASURES
from .runs import Row


class Plan(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is swept, so that the same and nothing else goes on.

    Attributes:
        scene, digest: name of the scene, and BLAKE2b of it.
        settings: assignments that hold in every run.
        vary: keys and values of the axes.
        measures: names.
        duration: of a run, s.
        version: of the file's format.
    """

    scene: str
    digest: str
    settings: tuple[str, ...]
    vary: tuple[tuple[str, tuple[str, ...]], ...]
    measures: tuple[str, ...]
    duration: float
    version: int = 1


class Line(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A line of `sweep.jsonl` after the first: the number of a run, from 0, and its row."""

    run: int
    row: Row


OPTIONS = {
    "scene": "SCENE",
    "digest": "SCENE",
    "settings": "--set",
    "vary": "--vary",
    "measures": "--measure",
    "duration": "--duration",
    "version": "softrod",
}
"""What on the command line each field of a plan comes from."""


def make_plan(grid: Grid, measures: tuple[str, ...], duration: float) -> Plan:
    """What is swept."""
    digest = hashlib.blake2b(encode_scene(grid.scene), digest_size=16).hexdigest()
    vary = tuple((axis.key, axis.values) for axis in grid.axes)
    return Plan(grid.scene.name, digest, grid.settings, vary, measures, duration)


class Folder:
    """The rows of a sweep, on the disk and here.

    Args:
        out: the folder; made if its parent exists.
        plan: what is swept.

    Attributes:
        rows: by the number of the run.

    Raises:
        InputError: the folder cannot be made or written to, or has a sweep of something else.
    """

    def __init__(self, out: Path, plan: Plan) -> None:
        make_folder(out)
        self._out, self._path = out, out / "sweep.jsonl"
        self.rows: dict[int, Row] = {}
        lines = self._read(plan)
        whole = b"".join([msgspec.json.encode(plan) + b"\n", *lines])
        if not self._path.exists() or self._path.read_bytes() != whole:
            write_file(self._path, whole)

    def _read(self, plan: Plan) -> list[bytes]:
        """Take over the rows that are there, and return their lines."""
        try:
            first, *lines = self._path.read_bytes().splitlines(keepends=True)
        except (FileNotFoundError, ValueError):
            return []  # there is no file, or an empty one
        except OSError as error:
            raise InputError(f"{self._path}: the file cannot be read ({error.strerror or error})") from None
        try:
            there = msgspec.json.decode(first, type=Plan)
            whole = [line for line in lines if line.endswith(b"\n")]
            found = [msgspec.json.decode(line, type=Line) for line in whole]
        except msgspec.DecodeError as error:
            raise InputError(f"{self._path}: this is not the file of a sweep ({error})") from None
        differ = [OPTIONS[f] for f in Plan.__struct_fields__ if getattr(there, f) != getattr(plan, f)]
        if differ:
            raise InputError(
                f"--out {self._out}: the sweep that is there has another "
                f"{' and '.join(dict.fromkeys(differ))}; give the same options to go on with it, or another "
                "folder"
            )
        runs = math.prod(len(values) for _, values in plan.vary)
        for number, line in enumerate(found, start=2):
            if not 0 <= line.run < runs or len(line.row.values) != len(plan.measures):
                raise InputError(f"{self._path}: line {number} is not of a run of this sweep")
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

    def write_table(self, grid: Grid, measures: Sequence[str], decimal_comma: bool = False) -> None:
        """Write `table.csv`: the rows that there are, in the order of the grid.

        Raises:
            InputError: it cannot be written.
        """
        text = comma_separated(headings(grid, measures), cells(grid, self.rows), decimal_comma)
        write_file(self._out / "table.csv", text.encode())


def headings(grid: Grid, measures: Sequence[str]) -> list[str]:
    """Names and units of the columns."""
    return [heading(grid, key) for key in (*(axis.key for axis in grid.axes), *measures)]


def heading(grid: Grid, name: str) -> str:
    """The name of a measure or a setting, with its unit in brackets if it has one.

    Lengths are in the scene's own unit.
    """
    unit = MEASURES[name].unit if name in MEASURES else grid.unit(name)
    return f"{name} [{unit.replace('px', grid.scene.view.unit)}]" if unit else name


def cells(grid: Grid, rows: dict[int, Row]) -> list[list[object]]:
    """The cells of the table: values as they were asked for, measures, yes and no."""
    points = grid.points
    words = {True: "yes", False: "no"}
    return [
        [*points[n], *(words[v] if isinstance(v, bool) else v for v in rows[n].values)] for n in sorted(rows)
    ]
