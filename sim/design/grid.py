"""Tables as texts: their lines, cells and headings, and where the numbers begin."""

from __future__ import annotations

import csv
import re
import unicodedata
from collections import Counter
from dataclasses import dataclass

from ..errors import InputError
from ..text import Text
from .cells import decimal_signs, is_gap, is_number, known_signs, printable
from .clocks import is_clock, is_date, is_time_of_day, seconds_of, unit_in_name
from .units import is_unit

MAX_ROWS = 20_000
"""Largest number of rows of a table; larger ones are refused."""
MAX_COLUMNS = 200
"""Largest number of columns of a table; larger ones are refused."""

Row = tuple[int, list[str]]
"""Line number and cells of a line."""

_DELIMITERS = ("\t", ";", ",", "|", " ")
_COMMENTS = ("#", "%", "//")
_TOLD = re.compile(r"\ufeff?\"?sep=(.)\"?", re.IGNORECASE)
"""A first line that tells spreadsheets the delimiter."""
_FORMULA = re.compile(r"=.|@[A-Z]+(?:\(|$)")
_CYRILLIC = re.compile(rb"[\xa8\xb8\xc0-\xff]{3}")
"""Three letters of code page 1251 in a row; in 1252 they would be three accented ones."""
_LONGEST = 100_000
"""Largest number of characters in a line."""
# Unless noted, doubling or halving one of these numbers fails no test.
_SAMPLE = 1000
"""Number of lines from which the delimiter is determined."""
_LONGEST_HEADING = 5
"""Largest number of lines of a heading in quotation marks."""

_IN_BRACKETS = re.compile(
    r"(?:(?P<group>[^:()\[\]]{1,60}):\s*)?(?P<name>.*?)\s*[(\[]\s*(?P<unit>[^()\[\]]*?)\s*[)\]]\s*(?P<after>.*)",
    re.DOTALL,
)
_AFTER_SLASH = re.compile(r"(?P<name>.*?\S)\s+/\s+(?P<unit>\S.*)", re.DOTALL)
_LAST_UNIT = re.compile(r"(?P<name>.*) \[(?P<unit>[^\[\]]*)\]", re.DOTALL)
_QUANTITY = re.compile(
    r"\b(?:(?:joint|spring|mass)\d+|body(?:\[[\d., ]+\])?|energy|stability)\.[a-z_]+", re.ASCII
)
_RUN = r"(?:run|trial|set|lauf|durchlauf|messung|versuch|essai|опыт)\s*#?\s*\d+"
_IS_RUN = re.compile(_RUN, re.IGNORECASE)
_OF_RUN = re.compile(rf"(?P<name>.+?)[\s,:_-]+(?P<run>{_RUN})", re.IGNORECASE | re.DOTALL)


@dataclass(frozen=True)
class Heading:
    """The heading of a column.

    Attributes:
        group: of several columns, such as a point or a run; empty if there is none.
        name: without group and unit; empty if there is none.
        unit: empty if there is none.
    """

    group: str
    name: str
    unit: str


@dataclass(frozen=True)
class Grid:
    """A table as text.

    Attributes:
        headings: the heading of each column.
        rows: the lines with numbers, each with one cell per heading.
        decimal: the decimal sign, "." or ",".
    """

    headings: list[Heading]
    rows: list[Row]
    decimal: str


def read_grid(data: bytes, name: str) -> Grid:
    """Read the cells of a table.

    Args:
        data: contents of the file.
        name: name of the file, for messages.

    Raises:
        InputError: it is not a table, or its numbers are ambiguous. The message names the line.
    """
    lines = _lines(_decoded(data, name))
    told = _TOLD.fullmatch(lines[0][1].strip()) if lines else None
    rows = _split(lines[1:] if told else lines, told[1] if told else "", name)
    head, body = _parted(rows, name)
    width = max(len(row) for _, row in body)
    if width > MAX_COLUMNS:
        raise InputError(
            Text("{name}: it has {width} columns, more than {most}", name=name, width=width, most=MAX_COLUMNS)
        )
    if len(body) > MAX_ROWS:
        raise InputError(
            Text("{name}: it has {count} rows, more than {most}", name=name, count=len(body), most=MAX_ROWS)
        )
    headings, named = _headings(head, width)
    for line, row in body:
        if named and any(row[named:]):
            raise InputError(
                Text(
                    "{name}, line {line}: it has {count} cells below {named} names; where a comma "
                    "stands between cells, the decimal sign is a point",
                    name=name,
                    line=line,
                    count=len(row),
                    named=named,
                )
            )
    filled = [(line, row + [""] * (width - len(row))) for line, row in body]
    return Grid(headings, filled, _decimal(filled, name))


def _decoded(data: bytes, name: str) -> str:
    has_mark = data[:2] in (b"\xff\xfe", b"\xfe\xff")
    eight_bits = "cp1251" if _CYRILLIC.search(data) else "cp1252"
    for encoding in ("utf-16",) if has_mark else ("utf-8-sig", eight_bits):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise InputError(Text("{name}: it is not a text", name=name))


def _lines(text: str) -> list[tuple[int, str]]:
    """Return the non-empty lines with their numbers; a heading that spans several counts as one line."""
    lines = [(number, line.strip(" \ufeff")) for number, line in enumerate(re.split(r"\r\n?|\n", text), 1)]
    found: list[tuple[int, str]] = []
    at = 0
    while at < len(lines):
        number, line = lines[at]
        size = 1
        if not found and line.count('"') % 2:
            rest = (i for i in range(1, _LONGEST_HEADING) if at + i < len(lines))
            size = next((i + 1 for i in rest if lines[at + i][1].count('"') % 2), 1)
        line = " ".join(text for _, text in lines[at : at + size])
        if line.strip():
            found.append((number, line))
        at += size
    return found


def _split(lines: list[tuple[int, str]], told: str, name: str) -> list[Row]:
    """Split lines other than comments at the delimiter that gives most of the first lines numbers."""
    best, most = "", (0, 0)
    for delimiter in (told,) if told else _DELIMITERS:
        rows = _rows(lines[:_SAMPLE], delimiter, name)
        count = (
            sum(_is_data(row) for _, row in rows),
            sum(len(row) > 1 and _is_all_data(row) for _, row in rows),
        )
        if count[0] and count > most:
            best, most = delimiter, count
    if not best:
        raise InputError(
            Text("{name}: no line of it has a time and a number, with the same sign between cells", name=name)
        )
    return _rows(lines, best, name)


def _rows(lines: list[tuple[int, str]], delimiter: str, name: str) -> list[Row]:
    """Return the cells of each line that is not a comment.

    A comment just above the first numbers with a cell for each is their heading, as written by NumPy.
    """
    rows: list[Row] = []
    comment = ""
    for number, line in lines:
        if _is_comment(line, delimiter):
            comment = line.lstrip('"#%/; ')
            continue
        row = _cut(line, delimiter, number, name)
        if comment and not rows and _is_data(row):
            names = _cut(comment, delimiter, number, name)
            if _are_names(names, len(row)):
                rows.append((number - 1, names))
        rows.append((number, row))
    return rows


def _is_comment(line: str, delimiter: str) -> bool:
    text = line.lstrip(' "')
    if text.startswith("#") and is_gap(re.split(r"[\t;,| ]", text)[0].rstrip('"')):
        return False
    return text.startswith(_COMMENTS) or (text.startswith(";") and delimiter != ";")


def _cut(line: str, delimiter: str, number: int, name: str) -> list[str]:
    if len(line) > _LONGEST:
        raise InputError(
            Text(
                "{name}, line {number}: it is longer than {most} letters",
                name=name,
                number=number,
                most=_LONGEST,
            )
        )
    if delimiter == " ":
        return line.split()
    # One line at a time: an unclosed quotation mark must not swallow the lines after it.
    cells = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    return [cell.strip() for cell in cells]


def _is_data(row: list[str]) -> bool:
    """Return whether a line has at least two numbers or times, and starts with one or has nothing else."""
    filled = [cell for cell in row if not is_gap(cell) and not is_date(cell)]
    found = sum(map(_is_value, filled))
    return found >= 2 and (found == len(filled) or _is_value(filled[0]))


def _is_all_data(row: list[str]) -> bool:
    """Return whether a line has numbers and nothing else but gaps."""
    return any(map(_is_value, row)) and all(map(_is_value_or_gap, row))


def _is_value(cell: str) -> bool:
    return is_number(cell) or is_time_of_day(cell)


def _is_value_or_gap(cell: str) -> bool:
    return _is_value(cell) or is_gap(cell)


def _parted(rows: list[Row], name: str) -> tuple[list[Row], list[Row]]:
    """Return the lines above the numbers, and those with numbers; lines of gaps alone are neither."""
    first = next(i for i, (_, row) in enumerate(rows) if _is_data(row))
    width = Counter(len(row) for _, row in rows[first:]).most_common(1)[0][0]
    while first and all(map(_is_value_or_gap, rows[first - 1][1])):
        first -= 1
    for i, (line, row) in enumerate(rows[:first]):
        if len(row) != width:
            continue
        formula = next(filter(_FORMULA.match, row), None)
        if formula is not None:
            raise InputError(
                Text(
                    "{name}, line {line}: {formula!r} is a formula, and not a number",
                    name=name,
                    line=line,
                    formula=printable(formula),
                )
            )
        below_names = i > 0 and _are_names(rows[i - 1][1], width)
        if any(map(_is_value, row)) and (below_names or _is_value(row[0])) and not is_clock(row[0]):
            at, wrong = next(
                (at, cell) for at, later in rows[i:first] for cell in later if not _is_value_or_gap(cell)
            )
            raise InputError(
                Text("{name}, line {at}: {cell!r} is not a number", name=name, at=at, cell=printable(wrong))
            )
    return rows[:first], [(line, row) for line, row in rows[first:] if not all(map(is_gap, row))]


def _are_names(row: list[str], width: int) -> bool:
    return len(row) == width and not any(map(_is_value, row)) and all(row)


def _decimal(rows: list[Row], name: str) -> str:
    """Return the decimal sign of all numbers.

    Raises:
        InputError: numbers differ in it, or it is ambiguous.
    """
    numbers = (
        (line, cell)
        for line, row in rows
        for cell in row
        if not cell.isdecimal() and not is_time_of_day(cell) and is_number(cell)
    )
    certain, unclear = known_signs(numbers)
    if len(certain) > 1:
        (line, cell), (other, earlier) = sorted(certain.values(), reverse=True)
        raise InputError(
            Text(
                "{name}, line {line}: {cell!r} has another decimal sign than {earlier!r} in line {other}",
                name=name,
                line=line,
                cell=cell,
                earlier=earlier,
                other=other,
            )
        )
    if certain:
        return next(iter(certain))
    if unclear and decimal_signs(unclear[1])[0] == ",":
        line, cell = unclear
        plain = cell.replace(",", "")
        raise InputError(
            Text(
                "{name}, line {line}: {cell!r} may be {plain} or {other}; write it in one of these ways",
                name=name,
                line=line,
                cell=cell,
                plain=plain,
                other=cell.replace(",", "."),
            )
        )
    return "."


# ------------------------------------------------------------------------- headings
def _headings(head: list[Row], width: int) -> tuple[list[Heading], int]:
    """Return the heading of each column, and the number of columns named, 0 without any headings."""
    rows = [row + [""] * (width - len(row)) for _, row in head if len(row) <= width and any(row)]
    named = [len(row) for _, row in head if any(row)]
    units = [""] * width
    if len(rows) >= 2 and all(cell == "" or _is_unit(cell) for cell in rows[-1]):
        units = [cell.strip("()[] ") for cell in rows.pop()]
    top = rows[-1] if rows else [""] * width
    above = rows[-2] if len(rows) >= 2 else [""] * width
    headings = [_heading(cell, unit) for cell, unit in zip(top, units, strict=True)]
    if 0 < len([cell for cell in above if cell]) < width or _IS_RUN.fullmatch(above[0]):
        headings = _grouped(headings, above)
    return headings, named[-1] if named and named[-1] > 1 else 0


def _own_formula(cell: str) -> tuple[str, str] | None:
    """Return name and unit if a heading is softrod's own formula, as in "mass1.x - mass0.x [px]", or has
    brackets in its name."""
    name, unit = cell.removeprefix("'"), ""
    if match := _LAST_UNIT.fullmatch(name):
        name, unit = match["name"], match["unit"]
    found = list(_QUANTITY.finditer(name))
    if not found or not ("[" in name or re.search(r"[-+*/^(]", _QUANTITY.sub("", name))):
        return None
    # "mass1.x / cm" and "mass1.x (cm)" are a quantity with a unit.
    is_formula = unit or len(found) > 1 or name[: found[0].start()].strip()
    return (name, unit) if is_formula else None


def _heading(cell: str, unit: str) -> Heading:
    if formula := _own_formula(cell):
        return Heading("", *map(printable, formula))
    group = ""
    match = _IN_BRACKETS.fullmatch(cell)
    after = match["after"].strip() if match else ""
    if match and (_IS_RUN.fullmatch(after) or not after.strip("'")):
        group, name, unit = match["group"] or "", match["name"], match["unit"] or unit
        if after.strip("'"):
            group = after
        else:
            name += after
    elif match := _AFTER_SLASH.fullmatch(cell):
        name, unit = match["name"], match["unit"]
    else:
        name, given = unit_in_name(cell)
        unit = unit or given
    if not group and (run := _OF_RUN.fullmatch(name)):
        group, name = run["run"], run["name"]
    unit = unicodedata.normalize("NFKC", unit.strip()).replace("−", "-")
    return Heading(printable(group), printable(name), printable(unit))


def _grouped(headings: list[Heading], above: list[str]) -> list[Heading]:
    """Add group names from the line above, each over several columns, as in Tracker and DataStudio."""
    current, found = "", []
    for each, cell in zip(headings, above, strict=True):
        current = printable(cell) or current
        found.append(Heading(each.group or current, each.name, each.unit))
    return found


def _is_unit(cell: str) -> bool:
    text = cell.strip("()[] ")
    return is_unit(text) or seconds_of(text) is not None
