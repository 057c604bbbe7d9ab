"""Tables of what was measured, as phyphox, Tracker, spreadsheets and softrod itself write them."""

from __future__ import annotations

import csv
import math
import re
import unicodedata
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from .units import is_unit

Floats = NDArray[np.float64]

MAX_BYTES = 5_000_000
"""Size of the largest file that is read."""
MAX_ROWS = 20_000
MAX_COLUMNS = 200

_DELIMITERS = ("\t", ";", ",", " ")
_COMMENTS = ("#", "%", "//")
_NUMBER = re.compile(r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_NO_NUMBER = re.compile(r"[-+]?(?:nan|inf(?:inity)?|[∞])", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"(.*?)\s*[(\[]([^()\[\]]*)[)\]]\s*")
_AFTER_SLASH = re.compile(r"(.*?\S)\s+/\s+(\S.*)")

_TIMES = ("t", "time", "zeit", "temps", "tiempo", "tempo")
"""What the column of the time is called, in the languages that exports often are in."""
_SECONDS = {"": 1.0, "s": 1.0, "sec": 1.0, "ms": 1e-3, "min": 60.0}


@dataclass(frozen=True, eq=False)
class Column:
    """A column of a table.

    Attributes:
        name: from the header, without the unit; "column 3" where there is none.
        unit: from the header; empty where there is none.
        values: (k,) one for each time; NaN where the place is empty.
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
    """A table of what was measured.

    Attributes:
        name: of the file.
        time: (k,) s, growing.
        columns: the others.
    """

    name: str
    time: Floats
    columns: tuple[Column, ...]

    def column(self, name: str) -> Column:
        """A column by its name, or by its name with the unit.

        Raises:
            InputError: there is none.
        """
        for column in self.columns:
            if name in (column.name, column.label):
                return column
        known = ", ".join(column.name for column in self.columns)
        raise InputError(f"{self.name}: there is no column {name!r}; there are {known}")


def read_measurement(path: str | Path) -> Measurement:
    """The table in a file; see `parse_measurement`.

    Raises:
        InputError: there is no such file, or it is no such table.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except OSError as error:
        raise InputError(f"{path}: it cannot be read ({error.strerror or error})") from None
    return parse_measurement(data, path.name)


def parse_measurement(data: bytes, name: str) -> Measurement:
    """A table of numbers over time.

    Cells stand between tabs, semicolons, commas or spaces; numbers have decimal points or commas. Lines that
    begin with #, % or // are left out. A header may name the columns, with units as in "x (cm)", "x [cm]" or
    "x / cm"; units may also be a line of their own below it, and names of several points, as of Tracker, one
    above it. The time is the column that is called so, or the first. An empty place is a gap.

    Args:
        data: the file.
        name: the file's, for messages.

    Raises:
        InputError: it is not such a table. The sentence names the line, and the column if it is one.
    """
    if len(data) > MAX_BYTES:
        raise InputError(f"{name}: it is larger than {MAX_BYTES // 1_000_000} MB")
    lines = [
        (number, line.strip(" \ufeff"))
        for number, line in enumerate(re.split(r"\r\n?|\n", _decoded(data, name)), 1)
        if line.strip() and not line.lstrip().startswith(_COMMENTS)
    ]
    cells = _split(lines)
    first = next((i for i, (_, row) in enumerate(cells) if _is_data(row)), None)
    if first is None:
        raise InputError(f"{name}: no line of it has a time and a number, with the same sign between cells")
    head, body = [row for _, row in cells[:first]], cells[first:]
    width = max(len(row) for _, row in body)
    if width > MAX_COLUMNS:
        raise InputError(f"{name}: it has {width} columns, more than {MAX_COLUMNS}")
    if len(body) > MAX_ROWS:
        raise InputError(f"{name}: it has {len(body)} rows, more than {MAX_ROWS}")
    names = _names(head, width)
    numbers = np.array(
        [
            [_value(row[i] if i < len(row) else "", name, line, names[i][0]) for i in range(width)]
            for line, row in body
        ]
    )
    return _table(name, names, numbers, [line for line, _ in body])


def _table(name: str, names: list[tuple[str, str]], numbers: Floats, lines: list[int]) -> Measurement:
    """The table of columns; rows without a time or without anything else are left out."""
    clock = next((i for i, (each, _) in enumerate(names) if _plain(each) in _TIMES), 0)
    heading, unit = names[clock]
    if unit not in _SECONDS:
        raise InputError(f"{name}: the time {heading!r} is in {unit!r}, not in s, ms or min")
    others = [i for i in range(len(names)) if i != clock and not np.isnan(numbers[:, i]).all()]
    full = ~np.isnan(numbers[:, clock]) & ~np.isnan(numbers[:, others]).all(axis=1)
    if not full.any():
        raise InputError(f"{name}: no line of it has a time and a number")
    time = numbers[full, clock] * _SECONDS[unit]
    kept = np.array(lines)[full]
    back = np.flatnonzero(np.diff(time) <= 0.0)
    if back.size:
        raise InputError(
            f"{name}, line {kept[back[0] + 1]}, column {heading!r}: the time {time[back[0] + 1]:g} s "
            f"does not come after {time[back[0]]:g} s"
        )
    columns = tuple(Column(*names[i], numbers[full, i]) for i in others)
    return Measurement(name, time, columns)


def _decoded(data: bytes, name: str) -> str:
    has_mark = data[:2] in (b"\xff\xfe", b"\xfe\xff")
    for encoding in ("utf-16",) if has_mark else ("utf-8-sig", "cp1252"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise InputError(f"{name}: it is not a text")


def _split(lines: list[tuple[int, str]]) -> list[tuple[int, list[str]]]:
    """The cells of each line, cut where most lines become numbers."""
    best: list[list[str]] = []
    most = -1
    texts = [line for _, line in lines]
    for delimiter in _DELIMITERS:
        rows = _cut(texts, delimiter)
        count = sum(map(_is_data, rows))
        if count > most:
            best, most = rows, count
    return [(number, row) for (number, _), row in zip(lines, best, strict=True)]


def _cut(lines: list[str], delimiter: str) -> list[list[str]]:
    if delimiter == " ":
        return [line.split() for line in lines]
    # One line at a time: a quotation mark that is never closed must not swallow what comes after it.
    return [[cell.strip() for cell in next(csv.reader([line], delimiter=delimiter))] for line in lines]


def _is_data(row: list[str]) -> bool:
    """Whether a line has at least two numbers, the first cell among them or empty."""
    filled = [cell for cell in row if cell]
    found = sum(bool(_NUMBER.fullmatch(cell) or _NO_NUMBER.fullmatch(cell)) for cell in filled)
    return found >= 2 and (found == len(filled) or bool(_NUMBER.fullmatch(row[0])))


def _value(cell: str, name: str, line: int, column: str) -> float:
    if not cell:
        return math.nan
    if _NO_NUMBER.fullmatch(cell):
        raise InputError(
            f"{name}, line {line}, column {column!r}: {cell} is not a finite number; leave the place of a "
            "missing value empty"
        )
    value = float(cell.replace(",", ".")) if _NUMBER.fullmatch(cell) else math.nan
    if not math.isfinite(value):
        raise InputError(f"{name}, line {line}, column {column!r}: {cell[:40]!r} is not a finite number")
    return value


def _names(head: list[list[str]], width: int) -> list[tuple[str, str]]:
    """Names and units of columns, by the lines above the first numbers."""
    rows = [row + [""] * (width - len(row)) for row in head if len(row) <= width]
    units = [""] * width
    if len(rows) >= 2 and all(cell == "" or _is_unit(cell) for cell in rows[-1]) and any(rows[-1]):
        units = [cell.strip("()[] ") for cell in rows.pop()]
    top = rows[-1] if rows else [""] * width
    groups = _groups(rows[-2], top) if len(rows) >= 2 else [""] * width
    found: list[tuple[str, str]] = []
    taken: set[str] = set()
    for i, (cell, group, unit) in enumerate(zip(top, groups, units, strict=True)):
        match = _IN_BRACKETS.fullmatch(cell) or _AFTER_SLASH.fullmatch(cell)
        base, given = match.groups() if match else (cell, "")
        base = " ".join(part for part in (group, base or f"column {i + 1}") if part)
        while base in taken:
            base += "'"
        taken.add(base)
        found.append((base, unicodedata.normalize("NFKC", (given or unit).strip()).replace("−", "-")))
    return found


def _groups(row: list[str], below: list[str]) -> list[str]:
    """Names that stand above several columns each, as Tracker has them; the time has none."""
    if sum(bool(cell) for cell in row) < 1 or len([cell for cell in row if cell]) == len(row):
        return [""] * len(row)
    current, found = "", []
    for cell, name in zip(row, below, strict=True):
        current = cell or current
        found.append("" if _plain(_bare(name)) in _TIMES else current)
    return found


def _bare(cell: str) -> str:
    match = _IN_BRACKETS.fullmatch(cell) or _AFTER_SLASH.fullmatch(cell)
    return match.group(1) if match else cell


def _plain(name: str) -> str:
    return name.strip().lower()


def _is_unit(cell: str) -> bool:
    return is_unit(cell.strip("()[] ")) or cell.strip("()[] ") in _SECONDS
