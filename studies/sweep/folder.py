"""The folder of a sweep: the rows as they come, what they are of, and the table at the end."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import ClassVar

import msgspec

from sim.store.files import write_file

from ..reporting.output import comma_separated
from .grid import Grid
from .kept import KeptRows, Line, digest_of
from .measures import MEASURES
from .runs import Row


class Plan(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is swept; see `studies.sweep.kept.Plan`.

    Attributes:
        scene, digest: name of the scene, and BLAKE2b of it.
        settings: assignments that hold in every run.
        vary: keys and values of the axes.
        measures: names.
        duration: of a run, s.
        version: of the file's format.
    """

    COMMAND: ClassVar[str] = "sweep"
    WORD: ClassVar[str] = "sweep"
    OPTIONS: ClassVar[Mapping[str, str]] = {
        "scene": "SCENE",
        "digest": "SCENE",
        "settings": "--set",
        "vary": "--vary",
        "measures": "--measure",
        "duration": "--duration",
        "version": "softrod",
    }

    scene: str
    digest: str
    settings: tuple[str, ...]
    vary: tuple[tuple[str, tuple[str, ...]], ...]
    measures: tuple[str, ...]
    duration: float
    version: int = 1

    def fits(self, line: Line) -> bool:
        """Whether a line can be of one of its runs."""
        runs = math.prod(len(values) for _, values in self.vary)
        return 0 <= line.run < runs and len(line.row.values) == len(self.measures)


def make_plan(grid: Grid, measures: tuple[str, ...], duration: float) -> Plan:
    """What is swept."""
    vary = tuple((axis.key, axis.values) for axis in grid.axes)
    return Plan(grid.scene.name, digest_of(grid.scene), grid.settings, vary, measures, duration)


class Folder(KeptRows):
    """The rows of a sweep, and its table."""

    def write_table(self, grid: Grid, measures: Sequence[str], decimal_comma: bool = False) -> None:
        """Write `table.csv`: the rows that there are, in the order of the grid.

        Raises:
            InputError: it cannot be written, or the rows cannot be read.
        """
        self.read()  # an interruption may have come when one was on the disk, but not here yet
        text = comma_separated(headings(grid, measures), cells(grid, self.rows), decimal_comma)
        write_file(self.out / "table.csv", text.encode())


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
