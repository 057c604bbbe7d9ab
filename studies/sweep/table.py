"""The table of a sweep: the varied settings and the measures of each run, with their units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from sim.store.files import write_file

from ..reporting.report import csv_of
from .grid import Grid, with_unit
from .measures import MEASURES
from .runs import Row


def write_sweep_table(
    out: Path, grid: Grid, measures: Sequence[str], rows: Mapping[int, Row], decimal_comma: bool = False
) -> None:
    """Write `table.csv`: the rows that are done, in the order of the grid.

    Raises:
        InputError: it cannot be written.
    """
    headings = [heading(grid, key) for key in (*(axis.key for axis in grid.axes), *measures)]
    points = grid.points
    cells = ([*points[n], *map(_cell, rows[n].values)] for n in sorted(rows))
    write_file(out / "table.csv", csv_of(headings, cells, decimal_comma).encode())


def heading(grid: Grid, name: str) -> str:
    """Return the name of a measure or a setting with its unit; lengths are in the scene's own unit."""
    unit = MEASURES[name].unit if name in MEASURES else grid.unit(name)
    return with_unit(name, unit.replace("px", grid.scene.view.unit))


def _cell(value: object) -> object:
    return {True: "yes", False: "no"}[value] if isinstance(value, bool) else value
