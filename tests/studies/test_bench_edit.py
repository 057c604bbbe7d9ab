"""The benchmark of edits: its cloth, and what it prints."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from sim.scene.validate import validate
from studies.bench import editing
from tests.app.pages import SessionPage


def test_the_cloth_is_a_large_body() -> None:
    scene = validate(editing.cloth())
    parts = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
    assert parts == (2550, 9899, 4898)


@pytest.mark.parametrize("what", editing.EDITS)
def test_every_edit_is_one_each_time(what: str) -> None:
    page = SessionPage(editing.cloth())
    moment = page.session.simulation.capture()
    made = [editing.EDITS[what](moment, i).scene for i in range(2)]
    assert all(scene != moment.scene and validate(scene) for scene in made)
    label = editing.EDITS[what](moment, 0).label
    assert label.startswith("1 ") or "added" in label or " set: 1 " in label


def test_what_is_measured_is_printed(monkeypatch: pytest.MonkeyPatch) -> None:
    some = dict(list(editing.EDITS.items())[:1])
    monkeypatch.setattr(editing, "EDITS", some)
    console = Console(file=io.StringIO(), width=100)
    editing.bench_edit(console, 1)
    assert isinstance(console.file, io.StringIO)
    row, last = console.file.getvalue().splitlines()[-2:]
    assert row.split()[:3] == ["a", "spring's", "stiffness"]
    assert all(float(number) > 0.0 for number in row.split()[3:7])
    assert last.startswith("selecting a spring: ")
