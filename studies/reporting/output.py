"""What the studies share: a progress bar that Ctrl-C ends, tables in three forms, and the files of a report.

A file is written only if it says something else than the one that is there.
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
from importlib.metadata import version
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from rich.console import Console, RenderableType
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table

from sim.csv_text import csv_text
from sim.errors import InputError
from sim.store.files import write_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Drawing = tuple[str, "Callable[[], Figure]"]
"""The caption of a figure, and what draws it."""

PALETTE = 128
"""Colours that a figure is written with; the shades of its edges make the file three times as large."""


class Watch:
    """A progress bar around something long, which Ctrl-C ends without an error.

    Attributes:
        interrupted: whether it did.
    """

    def __init__(self, console: Console, total: float) -> None:
        columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
        self._bar = Progress(*columns, console=console, transient=True)
        self._task = self._bar.add_task("", total=total)
        self.interrupted = False

    def __enter__(self) -> Watch:
        self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        self._bar.stop()
        self.interrupted = isinstance(error, KeyboardInterrupt)
        return self.interrupted

    def say(self, what: str, done: float | None = None, of: float | None = None) -> None:
        """Say what is being done and, if given, how much of how much of it all is."""
        self._bar.update(self._task, description=what, completed=done, total=of)

    def advance(self, parts: float = 1.0) -> None:
        """So many parts more are done."""
        self._bar.advance(self._task, parts)

    def print(self, shown: RenderableType) -> None:
        """Print something above the bar, and an empty line."""
        self._bar.console.print(shown)
        self._bar.console.print()


# ------------------------------------------------------------------------- tables
Rows = Iterable[Sequence[str]]


def table(headings: Sequence[str], rows: Rows, align: str = "l", title: str | None = None) -> Table:
    """A table for the terminal; rows that end in "missed" stand out.

    Args:
        headings: of the columns.
        rows: their cells.
        align: "l" or "r" for each column; the last ones, where it is shorter, are to the right.
        title: above it.
    """
    shown = Table(title=title, title_justify="left", title_style="bold", box=None, padding=(0, 2, 0, 0))
    for heading, side in zip(headings, align.ljust(len(headings), "r"), strict=True):
        shown.add_column(heading, justify="left" if side == "l" else "right")
    for row in rows:
        shown.add_row(*row, style="bold red" if row[-1] == "missed" else "")
    return shown


def grid(headings: Sequence[str], rows: Rows, align: str = "l") -> str:
    """The same in Markdown."""
    rule = ["---" if side == "l" else "--:" for side in align.ljust(len(headings), "r")]
    lines = [headings, rule, *([cell.replace("|", "\\|") for cell in row] for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def comma_separated(
    headings: Sequence[str], rows: Iterable[Iterable[object]], decimal_comma: bool = False
) -> str:
    """The same as CSV, floats with all their digits and nothing for None."""
    return csv_text([headings, *rows], decimal_comma, "{:.17g}".format)


def captioned(figures: Sequence[tuple[str, str]]) -> str:
    """Figures in Markdown, by name and caption, each with the caption below."""
    return "\n\n".join(f"![{text}]({name}.png)\n\n*{text}*" for name, text in figures)


def page(*blocks: str, more: Sequence[str] = ()) -> str:
    """A page of Markdown: blocks that are not empty, and at the end the `provenance` with `more` packages."""
    return "\n\n".join([*filter(None, blocks), provenance(*more)]) + "\n"


def provenance(*more: str) -> str:
    """What the results were computed with: processor, versions (also of `more` packages), date."""
    versions = ", ".join(f"{name} {version(name)}" for name in ("softrod", "numpy", "numba", "scipy", *more))
    today = datetime.date.today().isoformat()
    return f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}, {versions}; {today}"


def _processor() -> str:
    """The processor's name, as far as the system tells it."""
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


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
    """Write a table of comma-separated values, packed by gzip.

    Raises:
        InputError: it cannot be written.
    """
    _write(path, gzip.compress(text.encode(), mtime=0), gzip.decompress)


def write_figures(out: Path, drawings: Mapping[str, Drawing], dpi: int = 160) -> list[tuple[str, str]]:
    """Draw figures and write each as NAME.png.

    Args:
        out: folder.
        drawings: by name.
        dpi: resolution.

    Returns:
        Name and caption of each.

    Raises:
        InputError: one cannot be written.
    """
    for name, (_, draw) in drawings.items():
        _write(out / f"{name}.png", encoded(draw(), dpi), _pixels)
    return [(name, caption) for name, (caption, _) in drawings.items()]


def encoded(figure: Figure, dpi: int = 160) -> bytes:
    """The figure as a PNG of few colours, without a date."""
    from PIL import Image

    drawn, packed = io.BytesIO(), io.BytesIO()
    figure.savefig(drawn, format="png", dpi=dpi)
    image = Image.open(drawn).convert("RGB")
    few = image.quantize(PALETTE, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    few.save(packed, "png", optimize=True)
    return packed.getvalue()


def _pixels(data: bytes) -> tuple[tuple[int, int], bytes]:
    """Size and colours of a picture, however it is packed."""
    from PIL import Image

    image = Image.open(io.BytesIO(data)).convert("RGB")
    return image.size, image.tobytes()


def _write(path: Path, content: bytes, said: Callable[[bytes], object]) -> None:
    """Write a file, whole or not at all, unless the one that is there says the same."""
    try:
        if said(path.read_bytes()) == said(content):
            return
    except (OSError, EOFError, SyntaxError, ValueError, zlib.error):
        pass  # there is none, or it is something else
    write_file(path, content)
