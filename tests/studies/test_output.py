"""Reports are written anew only where they say something else."""

from __future__ import annotations

import gzip
import io
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure as Drawing
from PIL import Image
from rich.console import Console

from sim.errors import InputError
from studies.reporting.figures import BLUE, ORANGE, new_figure, tidy
from studies.reporting.progress import ProgressBar
from studies.reporting.report import (
    Figure,
    Table,
    csv_of,
    encoded,
    provenance,
    write_page,
    write_report,
    write_table,
)


def drawn(color: str = BLUE, height: float = 1.0) -> Drawing:
    figure, axes = new_figure(3.0, 2.0)
    axes.plot(np.linspace(0.0, height, 20), color=color)
    tidy(axes)
    return figure


def touched(path: Path) -> int:
    """What changes whenever a file is written, as each is a new one under the old name."""
    return path.stat().st_ino


def test_a_progress_bar_takes_an_interruption_and_no_error() -> None:
    text = io.StringIO()
    with ProgressBar(Console(file=text), 2) as calm:
        calm.say("one", 1, 3)
        calm.advance()
        calm.print("found")
    assert not calm.interrupted
    assert text.getvalue().startswith("found\n\n")
    with ProgressBar(Console(file=text), 2) as stopped:
        raise KeyboardInterrupt
    assert stopped.interrupted
    with pytest.raises(ZeroDivisionError), ProgressBar(Console(file=text), 2):
        raise ZeroDivisionError


def test_tables_in_three_forms() -> None:
    rows = [("a|b", "c", "1", "met"), ("d", "e", "2", "missed")]
    table = Table(("what", "how", "much", ""), rows, "ll")
    assert table.markdown().splitlines() == [
        "| what | how | much |  |",
        "| --- | --- | --: | --: |",
        "| a\\|b | c | 1 | met |",
        "| d | e | 2 | missed |",
    ]
    shown = table.__rich__()
    assert [column.justify for column in shown.columns] == ["left", "left", "right", "right"]
    assert [row.style for row in shown.rows] == ["", "bold red"]
    assert csv_of(("a", "b"), [(0.1, None), ("x,y", 2)]) == 'a,b\n0.10000000000000001,\n"x,y",2\n'


def test_figures_are_the_same_every_time() -> None:
    assert encoded(drawn()) == encoded(drawn())


def test_figures_have_few_colours_and_those_that_were_asked_for() -> None:
    image = Image.open(io.BytesIO(encoded(drawn()))).convert("RGB")
    colors = image.getcolors(1 << 24)
    assert colors is not None
    assert len(colors) <= 128
    asked = tuple(bytes.fromhex(BLUE[1:]))
    assert min(max(abs(a - b) for a, b in zip(color, asked, strict=True)) for _, color in colors) <= 8  # type: ignore[arg-type]


def test_a_figure_is_written_only_if_it_looks_different(tmp_path: Path) -> None:
    def write(figure: Drawing) -> None:
        Figure("line", "A line.", lambda: figure).write(tmp_path)

    path = tmp_path / "line.png"
    write(drawn())
    first = touched(path)
    write(drawn())
    assert touched(path) == first
    # Another packer's file of the same picture.
    Image.open(path).convert("RGB").save(path, compress_level=1)
    packed, first = path.read_bytes(), touched(path)
    write(drawn())
    assert (path.read_bytes(), touched(path)) == (packed, first)
    for other in (drawn(ORANGE), drawn(height=2.0)):
        before = path.read_bytes()
        write(other)
        assert path.read_bytes() != before


def test_a_page_is_written_only_if_more_than_its_date_is_new(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    today = provenance()
    line, _, date = today.rpartition("; ")
    assert len(date) == len("2000-01-01")
    path.write_text(f"# Page\n\n{line}; 2000-01-01\n")
    write_page(path, f"# Page\n\n{line}; {date}\n")
    assert path.read_text().endswith("; 2000-01-01\n")
    write_page(path, f"# Page\n\none more\n\n{line}; {date}\n")
    assert path.read_text() == f"# Page\n\none more\n\n{line}; {date}\n"


def test_a_table_is_written_only_if_its_text_is_new(tmp_path: Path) -> None:
    path = tmp_path / "table.csv.gz"
    path.write_bytes(gzip.compress(b"a,b\n1,2\n", 1, mtime=5))
    old = path.read_bytes()
    write_table(path, "a,b\n1,2\n")
    assert path.read_bytes() == old
    write_table(path, "a,b\n1,3\n")
    written = path.read_bytes()
    assert gzip.decompress(written) == b"a,b\n1,3\n"
    assert written[4:8] == bytes(4)  # no time in it


@pytest.mark.parametrize("rubbish", [b"", b"\x1f\x8b\x08", b"\x89PNG\r\n\x1a\n", b"\xff" * 100])
def test_what_is_no_report_is_written_over(rubbish: bytes, tmp_path: Path) -> None:
    for name in ("line.png", "table.csv.gz", "page.md"):
        (tmp_path / name).write_bytes(rubbish)
    Figure("line", "A line.", drawn).write(tmp_path)
    write_table(tmp_path / "table.csv.gz", "a\n")
    write_page(tmp_path / "page.md", "# Page\n")
    assert Image.open(tmp_path / "line.png").size == (480, 320)
    assert gzip.decompress((tmp_path / "table.csv.gz").read_bytes()) == b"a\n"
    assert (tmp_path / "page.md").read_text() == "# Page\n"


def test_a_file_that_cannot_be_written_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "page.md").mkdir()
    with pytest.raises(InputError, match="the file cannot be written"):
        write_page(tmp_path / "page.md", "# Page\n")


def test_a_report_has_all_sections_and_leaves_out_what_is_empty(tmp_path: Path) -> None:
    text = io.StringIO()
    sections = ["# Title", "", Table(("a",), [("1",)]), Figure("line", "A line.", drawn)]
    assert write_report(tmp_path, "page", sections, {"rows": "a\n1\n"}, Console(file=text), ["pillow"])
    page = (tmp_path / "page.md").read_text()
    head = "# Title\n\n| a |\n| --- |\n| 1 |\n\n![A line.](line.png)\n\n*A line.*\n\n"
    assert page.startswith(head) and "pillow" in page.removeprefix(head)
    assert {path.name for path in tmp_path.iterdir()} == {"page.md", "rows.csv.gz", "line.png"}
    assert "written to" in text.getvalue()
