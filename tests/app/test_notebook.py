"""The live page in a notebook, and the notebook among the examples."""

from __future__ import annotations

import json
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib
import matplotlib.pyplot as plt
import pytest

import app
import sim
from app.notebook import Shown
from sim.errors import SceneError

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.ipynb"))


@pytest.fixture
def shown() -> Iterator[Shown]:
    shown = app.show(sim.load_scene("ring"), height=400)
    yield shown
    shown.close()


def test_a_scene_is_shown_at_an_address_that_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    shown = app.show(sim.load_scene("rod"))
    shown.close()
    assert shown.url in capsys.readouterr().out


def test_a_notebook_on_this_machine_may_frame_it(shown: Shown) -> None:
    with urllib.request.urlopen(shown.url) as answer:
        frames = answer.headers["Content-Security-Policy"]
    # Notebooks are at any port, but on this machine.
    assert frames == "frame-ancestors http://localhost:* http://127.0.0.1:*"
    drawn = shown._repr_html_()
    assert f'<iframe src="{shown.url}"' in drawn
    assert 'height="400"' in drawn
    assert shown.scene().name == "ring"


def test_closing_ends_the_server_and_keeps_the_scene(shown: Shown) -> None:
    shown.close()
    shown.close()
    with pytest.raises(OSError):
        urllib.request.urlopen(shown.url)
    assert "closed" in repr(shown)
    assert "iframe" not in shown._repr_html_()
    assert shown.scene().name == "ring"


def test_a_scene_that_is_not_valid_is_not_shown() -> None:
    with pytest.raises(SceneError):
        app.show(sim.Scene(name="nothing", masses=()))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_examples_have_no_output_and_run(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cells: list[dict[str, Any]] = json.loads(path.read_text(encoding="utf-8"))["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert code
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in code)
    matplotlib.use("Agg")
    names: dict[str, Any] = {}
    try:
        for number, cell in enumerate(code):
            exec(compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec"), names)
    finally:
        plt.close("all")
        if "shown" in names:
            names["shown"].close()
    assert capsys.readouterr().out
