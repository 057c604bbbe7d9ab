"""Tables of measurements, as written by loggers, spreadsheets, video programs and softrod itself."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..text import Text
from .cells import is_gap, is_number, printable, value_of
from .clocks import (
    begins_with_start,
    is_clock,
    is_date,
    is_time_of_day,
    number_of,
    seconds_of,
    times_of_day,
    unit_since_1970,
)
from .grid import Grid, Heading, read_grid

Floats = NDArray[np.float64]

MAX_BYTES = 5_000_000
"""Largest size of a file that is read, bytes."""

_POINT = re.compile(r"(?:mass|point|masse|punkt|ball|body)[ _]?[a-z0-9]?", re.IGNORECASE)
"""Names of groups that are measured at the same time, and are not runs of their own."""
_FRAMES = ("frame", "frames", "bild", "index", "step", "sample", "image", "n", "i", "#", "nr", "no")
_NO_TIMES = ("x", "y", "z", "vx", "vy", "v", "ax", "ay", "a", "angle", "theta", "θ", "phi", "φ", "force")


@dataclass(frozen=True, eq=False)
class Column:
    """A column of a table.

    Attributes:
        name: from the header, without the unit; "column 3" if there is none.
        unit: from the header; empty if there is none.
        values: (k,) one for each time; NaN where the cell is empty.
    """

    name: str
    unit: str
    values: Floats

    @property
    def label(self) -> str:
        """Name and unit."""
        return f"{self.name} ({self.unit})" if self.unit else self.name


@dataclass(frozen=True, eq=False)
class Measurement:
    """The data of one measurement.

    Attributes:
        name: of the file, and of the run if it has several.
        time: (k,) s, increasing.
        columns: the other columns.
        is_absolute: whether the time is a time of day, or since 1970, rather than since the motion began.
        remarks: sentences on what was not read as one might expect.
    """

    name: str
    time: Floats
    columns: tuple[Column, ...]
    is_absolute: bool = False
    remarks: tuple[str, ...] = ()

    def column(self, name: str) -> Column:
        """Return a column by its name, or by its name with the unit.

        Raises:
            InputError: there is none.
        """
        for column in self.columns:
            if name in (column.name, column.label):
                return column
        known = ", ".join(column.name for column in self.columns)
        raise InputError(
            Text(
                "{file}: there is no column {name!r}; there are {known}",
                file=self.name,
                name=name,
                known=known,
            )
        )


def of_column(file: str, column: str, sentence: str) -> Text:
    """Return a sentence with the column of a file that it is about before it."""
    return Text("{file}, column {column!r}: {error}", file=file, column=column, error=sentence)


def read_measurements(path: str | Path) -> tuple[Measurement, ...]:
    """Read the table in a file; see `parse_measurements`.

    Raises:
        InputError: the file cannot be read, or it is not such a table.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except OSError as error:
        raise InputError(
            Text("{path}: it cannot be read ({reason})", path=str(path), reason=error.strerror or str(error))
        ) from None
    return parse_measurements(data, path.name)


def parse_measurements(data: bytes, name: str) -> tuple[Measurement, ...]:
    """Parse a table of numbers over time: one measurement, or one for each run where runs are side by side.

    Cells are separated by tabs, semicolons, commas, bars or spaces, or by the sign in a first line "sep=".
    Decimal signs are points or commas, the same throughout a table, and thousands may be grouped. Lines that
    begin with #, %, // or ; are skipped. A header may name the columns, with units as in "x (cm)", "x [cm]"
    or "x / cm"; units may also be on a line of their own below it, and names of points or runs above or in
    it. The time is the column named so or in a unit of time, otherwise the first: in s or another unit, as
    h:mm:ss, with a date, or since 1970. Empty cells, "-", "NaN", "n/a" and the like are gaps.

    Args:
        data: contents of the file.
        name: name of the file, for messages.

    Raises:
        InputError: it is not such a table, or is ambiguous. The message names the line, and the column if
            there is one.
    """
    name = printable(name)
    if len(data) > MAX_BYTES:
        raise InputError(Text("{name}: it is larger than {most} MB", name=name, most=MAX_BYTES // 1_000_000))
    return tuple(_Table(read_grid(data, name), name).measurements())


class _Table:
    """Columns of numbers; some of them are clocks.

    Args:
        grid: the cells.
        name: name of the file.
    """

    def __init__(self, grid: Grid, name: str) -> None:
        self._name, self._decimal = name, grid.decimal
        self._lines = [line for line, _ in grid.rows]
        self._cells = list(zip(*(row for _, row in grid.rows), strict=True))
        self._headings = grid.headings
        self._remarks: list[str] = []
        self._times: set[int] = set()
        """Columns of clock times."""
        self._left_out: set[int] = set()
        """Clocks that are not used as the time."""
        self._values = [self._numbers(i) for i in range(len(grid.headings))]

    def measurements(self) -> Iterator[Measurement]:
        """Yield one for each run."""
        clocks = self._clocks()
        others = [i for i in self._filled() if i not in clocks and i not in self._left_out]
        if all(self._same(clocks[0], other) for other in clocks[1:]):
            yield self._measurement(clocks[0], others, "")
            return
        runs: dict[str, list[tuple[int, list[int]]]] = {}
        for number, part in enumerate(self._parts(clocks, others), 1):
            runs.setdefault(self._run_of(*part) or f"run {number}", []).append(part)
        for run, parts in runs.items():
            yield self._together(parts, run if len(runs) > 1 else "")

    def _run_of(self, clock: int, others: list[int]) -> str:
        """Return the name of the run in which some columns were measured; empty if there is none."""
        groups = {self._headings[i].group for i in (clock, *others)} - {""}
        if groups and all(map(_POINT.fullmatch, groups)):
            return "points"
        return groups.pop() if len(groups) == 1 else ""

    # --------------------------------------------------------------------- the cells
    def _numbers(self, i: int) -> Floats:
        """Return (k,) the numbers of a column; NaN for gaps, and all NaN if it is text.

        Raises:
            InputError: one is not a finite number.
        """
        cells = self._cells[i]
        filled = [k for k, cell in enumerate(cells) if not is_gap(cell)]
        found = np.full(len(cells), math.nan)
        if any(is_time_of_day(cells[k]) for k in filled) and not any(is_number(cells[k]) for k in filled):
            try:
                found[filled] = times_of_day([cells[k] for k in filled])
            except ValueError as error:
                raise InputError(of_column(self._name, self._label(i), str(error))) from None
            self._times.add(i)
        elif any(is_number(cells[k]) for k in filled):
            found[filled] = [value_of(cells[k], self._decimal) for k in filled]
        elif filled:
            label = self._label(i)
            if is_date(cells[filled[0]]):
                said = Text("Column {column!r} has a date without a time and is left out.", column=label)
            else:
                said = Text("Column {column!r} has no number and is left out.", column=label)
            self._remarks.append(said)
            return found
        wrong = next((k for k in filled if not math.isfinite(found[k])), None)
        if wrong is not None:
            raise InputError(
                Text(
                    "{place}: {cell!r} is not a finite number",
                    place=self._place(wrong, i),
                    cell=printable(cells[wrong]),
                )
            )
        return found

    def _label(self, i: int) -> str:
        return self._headings[i].name or Text("column {number}", number=i + 1)

    def _place(self, row: int, i: int) -> str:
        return Text(
            "{file}, line {line}, column {column!r}",
            file=self._name,
            line=self._lines[row],
            column=self._label(i),
        )

    def _filled(self) -> list[int]:
        return [i for i, each in enumerate(self._values) if not np.isnan(each).all()]

    def _same(self, i: int, j: int) -> bool:
        return bool(np.array_equal(self._seconds(i), self._seconds(j), equal_nan=True))

    # --------------------------------------------------------------------- which are clocks
    def _clocks(self) -> list[int]:
        """Return the columns that are the time.

        Raises:
            InputError: there is none, or it is ambiguous.
        """
        filled, headings = self._filled(), self._headings
        named = [
            i
            for i in filled
            if is_clock(headings[i].name) and (not headings[i].unit or self._unit(i) is not None)
        ]
        wrong = next((i for i in filled if is_clock(headings[i].name) and i not in named), None)
        if not named and wrong is not None:
            unit = headings[wrong].unit
            raise InputError(
                Text(
                    "{file}: the time {column!r} is in {unit!r}, and not in s, ms, min or h",
                    file=self._name,
                    column=headings[wrong].name,
                    unit=unit,
                )
            )
        found = named or [i for i in filled if self._unit(i) is not None and i not in self._times]
        found = found or sorted(self._times)
        # "t1" beside "t" is no clock.
        bare = [i for i in found if not number_of(headings[i].name)]
        found = bare or found
        since_start = [i for i in found if begins_with_start(headings[i].name)]
        found = self._without(found, since_start)
        found = self._without(found, [i for i in found if not self._is_absolute(i)])
        found = found or [self._first(filled)]
        self._leave_out(found[0], sorted(self._times - {*found}))
        return found

    def _without(self, clocks: list[int], better: list[int]) -> list[int]:
        """Return the better ones of some clocks, if there are any; add remarks on those left out."""
        if not better:
            return clocks
        self._leave_out(better[0], [i for i in clocks if i not in better])
        return better

    def _leave_out(self, time: int, clocks: list[int]) -> None:
        """Leave out clocks that are not the time, and add remarks."""
        for i in clocks:
            if i not in self._left_out:
                self._left_out.add(i)
                self._remarks.append(
                    Text(
                        "The time is {time!r}; the other clock {column!r} is left out.",
                        time=self._label(time),
                        column=self._label(i),
                    )
                )

    def _first(self, filled: list[int]) -> int:
        """Return the first column, for tables in which nothing is called the time."""
        i = filled[0]
        heading = self._headings[i]
        name = heading.name.lower()
        if heading.unit or name in (*_NO_TIMES, *_FRAMES):
            raise InputError(
                Text(
                    "{file}: no column is called the time, and the first one is {column!r} in {unit}; "
                    "call one t (s)",
                    file=self._name,
                    column=heading.name,
                    unit=heading.unit,
                )
                if heading.unit
                else Text(
                    "{file}: no column is called the time, and the first one is {column!r}; call one t (s)",
                    file=self._name,
                    column=heading.name,
                )
            )
        if heading.name:
            self._remarks.append(
                Text("No column is called the time: {column!r} is taken for it, in s.", column=heading.name)
            )
        return i

    def _unit(self, i: int) -> float | None:
        return seconds_of(self._headings[i].unit)

    def _is_absolute(self, i: int) -> bool:
        """Return whether a clock shows the time of day, or the time since 1970."""
        unit, first = self._unit(i) or 1.0, self._values[i][~np.isnan(self._values[i])][0]
        if i in self._times:
            return bool(first >= 3600.0)
        return unit_since_1970(float(first)) is not None if not self._headings[i].unit else first * unit > 1e8

    def _seconds(self, i: int) -> Floats:
        """Return (k,) the time of a clock, s.

        Raises:
            InputError: its unit cannot be determined.
        """
        values = self._values[i]
        if i in self._times:
            return values
        unit = self._unit(i)
        if unit is None:
            unit = self._unit_by_others(i)
        return values * unit

    def _unit_by_others(self, i: int) -> float:
        """Return the seconds in the unit of a clock that names none: since 1970, or as another clock runs."""
        values = self._values[i]
        own = unit_since_1970(float(values[~np.isnan(values)][0]))
        if own is not None:
            return own
        for other in self._filled():
            if other == i or not is_clock(self._headings[other].name) or not self._is_absolute(other):
                continue
            both = ~np.isnan(values) & ~np.isnan(self._values[other])
            here, there = np.ptp(values[both]), float(np.ptp(self._seconds(other)[both]))
            if here > 0.0 and there > 0.0:
                unit = next(
                    (u for u in (1.0, 1e-3, 1e-6, 1e-9) if abs(here * u - there) < 0.05 * there), None
                )
                if unit is None:
                    raise InputError(
                        Text(
                            "{file}: {column!r} has no unit, and {other!r} goes at another rate",
                            file=self._name,
                            column=self._label(i),
                            other=self._label(other),
                        )
                    )
                return unit
        return 1.0

    # --------------------------------------------------------------------- columns of each clock
    def _parts(self, clocks: list[int], others: list[int]) -> list[tuple[int, list[int]]]:
        """Return each clock with the other columns that were measured by it.

        Raises:
            InputError: these cannot be determined.
        """
        # Either each clock is next to its columns, or numbers or groups in the names assign them.
        bounds = [*clocks, len(self._headings)]
        after = [(c, [i for i in others if c < i < end]) for c, end in zip(clocks, bounds[1:], strict=True)]
        if others and others[0] > clocks[0] and all(columns for _, columns in after):
            return after
        before = [
            (c, [i for i in others if begin < i < c])
            for begin, c in zip([-1, *clocks[:-1]], clocks, strict=True)
        ]
        if others and others[-1] < clocks[-1] and all(columns for _, columns in before):
            return before
        for key in (lambda i: number_of(self._headings[i].name), lambda i: self._headings[i].group):
            keys = [key(c) for c in clocks]
            if len({*keys}) == len(keys) and {key(i) for i in others} == {*keys}:
                return [
                    (c, [i for i in others if key(i) == mine]) for c, mine in zip(clocks, keys, strict=True)
                ]
        names = " and ".join(repr(self._label(c)) for c in clocks)
        raise InputError(
            Text(
                "{file}: there are several clocks, {names}, and it is not told which column goes with which",
                file=self._name,
                names=names,
            )
        )

    def _together(self, parts: list[tuple[int, list[int]]], run: str) -> Measurement:
        """Merge the measurements of one run, by one clock or several, at all of their times."""
        each = [self._measurement(clock, columns, run) for clock, columns in parts]
        if len(each) == 1:
            return each[0]
        time = np.unique(np.concatenate([one.time for one in each]))
        columns: dict[str, Column] = {}
        for one in each:
            at = np.searchsorted(time, one.time)
            for column in one.columns:
                values = np.full(time.size, math.nan)
                values[at] = column.values
                name = _not_in(columns, column.name)
                columns[name] = Column(name, column.unit, values)
        return replace(each[0], time=time, columns=tuple(columns.values()))

    def _measurement(self, clock: int, others: Sequence[int], run: str) -> Measurement:
        """Return the measurement by one clock.

        Raises:
            InputError: a number has no time, or the time does not increase.
        """
        name = f"{self._name}, {run}" if run else self._name
        seconds = self._seconds(clock)
        there = self._any(others)
        lost = np.flatnonzero(there & np.isnan(seconds))
        if lost.size:
            raise InputError(
                Text(
                    "{file}, line {line}: it has numbers, but no time",
                    file=self._name,
                    line=self._lines[lost[0]],
                )
            )
        full = np.flatnonzero(there)
        if not full.size:
            raise InputError(Text("{name}: no line of it has a time and a number", name=name))
        time = seconds[full]
        back = np.flatnonzero(np.diff(time) <= 0.0)
        if back.size:
            place = self._place(int(full[back[0] + 1]), clock)
            raise InputError(
                Text(
                    "{place}: the time {time:.12g} s does not come after {earlier:.12g} s",
                    place=place,
                    time=time[back[0] + 1],
                    earlier=time[back[0]],
                )
            )
        labels = self._labels(clock, others, run)
        columns = tuple(
            Column(label, self._headings[i].unit, self._values[i][full])
            for label, i in zip(labels, others, strict=True)
        )
        return Measurement(name, time, columns, self._is_absolute(clock), tuple(self._remarks))

    def _any(self, columns: Sequence[int]) -> NDArray[np.bool_]:
        """Return (k,) whether a line has a number in any of some columns."""
        found = np.zeros(len(self._lines), np.bool_)
        for i in columns:
            found |= ~np.isnan(self._values[i])
        return found

    def _labels(self, clock: int, columns: Sequence[int], run: str) -> list[str]:
        """Return a unique name for each of some columns, with the group unless that is the whole run.

        With several runs, a final number is the clock's, not a part's: "x2" beside "t2" is x.
        """
        found: list[str] = []
        number = number_of(self._headings[clock].name) if run else ""
        for i in columns:
            heading: Heading = self._headings[i]
            whole = heading.group in (run, self._headings[clock].group) and not _POINT.fullmatch(
                heading.group
            )
            name = heading.name or f"column {i + 1}"
            if run:
                name = name.rstrip("'") or name
            if number and name.endswith(number):
                name = name.removesuffix(number).rstrip(" _") or name
            label = " ".join(part for part in ("" if whole else heading.group, name) if part)
            found.append(_not_in(found, label))
        return found


def _not_in(taken: Collection[str], name: str) -> str:
    """Return a name, with a mark for each time that it is already taken."""
    while name in taken:
        name += "'"
    return name
