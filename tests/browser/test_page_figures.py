"""The figures of pages side by side (`page_figures.py`)."""

from __future__ import annotations

from tests.browser.page_figures import Figures, report


def test_pages_are_compared_by_their_medians() -> None:
    old = [Figures(*10 * (value,)) for value in (3e3, 1e3, 2e3)]
    new = [Figures(*10 * (value,)) for value in (1e3, 1e3, 9e3)]
    lines = report({"old": old, "new": new}).splitlines()
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    assert cells[0] == ["", "old", "new", "ratio"]
    assert cells[2] == ["files", "2000", "1000", "0.50"]
    assert cells[3] == ["kB by HTTP", "2", "1", "0.50"]
    assert len({len(line) for line in lines}) == 1
