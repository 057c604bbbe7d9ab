"""Folders and files of reports: a file is written only if it says something else than the one there."""

from __future__ import annotations

import gzip
import io
import re
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from sim.errors import InputError
from sim.files import write_atomically

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Drawing = tuple[str, "Callable[[], Figure]"]
"""The caption of a figure, and what draws it."""

PALETTE = 128
"""Colours that a figure is written with; the shades of its edges make the file three times as large."""


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
    try:
        write_atomically(path, content)
    except OSError as error:
        raise InputError(f"{path}: the file cannot be written ({error.strerror or error})") from None
