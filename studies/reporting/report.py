"""A report: sections of text, tables and figures, written as Markdown, PNG and packed CSV.

A file is written only if its content differs from that of the one that is there.
"""

from __future__ import annotations

import datetime
import gzip
import io
import os
import platform
import re
import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import rich.table

from sim.errors import InputError
from sim.store.csv_text import csv_text
from sim.store.files import write_file

if TYPE_CHECKING:
    import matplotlib.figure
    from rich.console import Console

MAX_COLORS = 128
"""Colours that a figure is written with; all shades of its edges would make the file three times as large."""


# ------------------------------------------------------------------------- sections
@dataclass(frozen=True)
class Table:
    """A table of texts.

    Attributes:
        headings: of the columns.
        rows: cells.
        align: "l" or "r" for each column; the last ones, where it is shorter, are aligned to the right.
        title: shown above it in the terminal.
    """

    headings: Sequence[str]
    rows: Sequence[Sequence[str]]
    align: str = "l"
    title: str | None = None

    @property
    def _sides(self) -> str:
        return self.align.ljust(len(self.headings), "r")

    def __rich__(self) -> rich.table.Table:
        """Return the table for the terminal; rows that end in "missed" stand out."""
        shown = rich.table.Table(
            title=self.title, title_justify="left", title_style="bold", box=None, padding=(0, 2, 0, 0)
        )
        for heading, side in zip(self.headings, self._sides, strict=True):
            shown.add_column(heading, justify="left" if side == "l" else "right")
        for row in self.rows:
            shown.add_row(*row, style="bold red" if row[-1] == "missed" else "")
        return shown

    def markdown(self) -> str:
        """Return the table in Markdown."""
        rule = ["---" if side == "l" else "--:" for side in self._sides]
        rows = ([cell.replace("|", "\\|") for cell in row] for row in self.rows)
        return "\n".join(f"| {' | '.join(line)} |" for line in (self.headings, rule, *rows))


@dataclass(frozen=True)
class Figure:
    """A figure in a file of its own.

    Attributes:
        name: of the file, without ending.
        caption: shown below it; empty for none.
        draw: draws it.
        dpi: resolution.
        alt: read to those who cannot see it; the caption unless given.
    """

    name: str
    caption: str
    draw: Callable[[], matplotlib.figure.Figure]
    dpi: int = 160
    alt: str = ""

    def markdown(self) -> str:
        """Return the figure in Markdown, with its caption below."""
        image = f"![{self.alt or self.caption}]({self.name}.png)"
        return f"{image}\n\n*{self.caption}*" if self.caption else image

    def write(self, out: Path) -> None:
        """Draw it and write it into a folder.

        Raises:
            InputError: it cannot be written.
        """
        _write(out / f"{self.name}.png", encoded(self.draw(), self.dpi), _pixels)


Section = str | Table | Figure
"""Text in Markdown, a table or a figure; empty text is left out."""


def markdown(sections: Iterable[Section]) -> str:
    """Return sections as a page of Markdown."""
    return "\n\n".join(each if isinstance(each, str) else each.markdown() for each in sections if each)


def bullets(items: Iterable[str]) -> str:
    """Return a list in Markdown; empty where there are no items."""
    return "\n".join(f"- {item}" for item in items)


def write_report(
    out: Path,
    name: str,
    sections: Iterable[Section],
    tables: Mapping[str, str],
    console: Console,
    packages: Sequence[str] = (),
) -> bool:
    """Write a report: tables, then figures, then a page with all sections and what computed them.

    Ctrl-C while figures are drawn leaves out the missing ones.

    Args:
        out: folder.
        name: of the page, without ending.
        sections: of the page.
        tables: CSV by name, without ending.
        console: is shown where the report is.
        packages: whose versions matter, besides those of all reports.

    Returns:
        Whether all figures are there.

    Raises:
        InputError: a file cannot be written.
    """
    for stem, text in tables.items():
        write_table(out / f"{stem}.csv.gz", text)
    shown = [section for section in sections if section]
    figures = [section for section in shown if isinstance(section, Figure)]
    try:
        with console.status("figures"):
            while figures:
                figures[0].write(out)
                figures.pop(0)
    except KeyboardInterrupt:
        console.print("Interrupted: figures are missing.")
        missing = "**Interrupted: a figure is missing.**"
        shown = [missing if section in figures else section for section in shown]
    write_page(out / f"{name}.md", markdown([*shown, provenance(*packages)]) + "\n")
    console.print(f"written to {out}")
    return not figures


def provenance(*packages: str) -> str:
    """Return what the results were computed with: processor, versions (also of more packages), date."""
    names = ("softrod", "numpy", "numba", "scipy", *packages)
    versions = ", ".join(f"{name} {version(name)}" for name in names)
    today = datetime.date.today().isoformat()
    return f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}, {versions}; {today}"


def _processor() -> str:
    """Return the processor's name, as far as the system knows it."""
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


# ------------------------------------------------------------------------- CSV
def csv_of(headings: Sequence[str], rows: Iterable[Iterable[object]], decimal_comma: bool = False) -> str:
    """Return a table as CSV: floats with all their digits, and nothing for None."""
    return csv_text([headings, *rows], decimal_comma, "{:.17g}".format)


def csv_of_records(kind: type[Any], records: Iterable[Any], columns: Mapping[str, str] | None = None) -> str:
    """Return dataclass instances as CSV, a row for each.

    Args:
        kind: their class.
        records: the instances.
        columns: heading and attribute of each column; unless given, the fields of the class.
    """
    chosen = columns or {field.name: field.name for field in fields(kind)}
    return csv_of([*chosen], ([getattr(each, name) for name in chosen.values()] for each in records))


# ------------------------------------------------------------------------- files
def make_folder(out: Path) -> None:
    """Make the folder of `--out`, unless it is there.

    Raises:
        InputError: it cannot be made.
    """
    try:
        out.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(f"--out {out}: the folder cannot be made ({error.strerror or error})") from None


def write_page(path: Path, text: str) -> None:
    """Write a page of Markdown, unless all but the date of its last line is there.

    Raises:
        InputError: it cannot be written.
    """
    _write(path, text.encode(), lambda data: re.sub(rb"; \d{4}-\d\d-\d\d\n$", b"", data))


def write_table(path: Path, text: str) -> None:
    """Write CSV, packed by gzip.

    Raises:
        InputError: it cannot be written.
    """
    _write(path, gzip.compress(text.encode(), mtime=0), gzip.decompress)


def encoded(figure: matplotlib.figure.Figure, dpi: int = 160) -> bytes:
    """Return a figure as a PNG of few colours, without a date."""
    from PIL import Image

    drawn = io.BytesIO()
    packed = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=dpi)
    image = Image.open(drawn).convert("RGB")
    few = image.quantize(MAX_COLORS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    few.save(packed, "png", optimize=True)
    return packed.getvalue()


def _pixels(data: bytes) -> tuple[tuple[int, int], bytes]:
    """Return size and colours of a picture, however it is packed."""
    from PIL import Image

    image = Image.open(io.BytesIO(data)).convert("RGB")
    return image.size, image.tobytes()


def _write(path: Path, content: bytes, meaning: Callable[[bytes], object]) -> None:
    """Write a file, whole or not at all, unless the one that is there means the same."""
    try:
        if meaning(path.read_bytes()) == meaning(content):
            return
    except (OSError, EOFError, SyntaxError, ValueError, zlib.error):
        pass  # there is none, or it is something else
    write_file(path, content)
