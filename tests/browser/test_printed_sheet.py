"""A teacher's sheet fits on one side of paper."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser

import sim
from app.export.teacher_sheet import sheet_html
from app.words import languages, speaking
from sim.store.files import built_in_folder
from tests.amount import part_of

LESSONS = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))


LONGEST = ("lesson-worm-floor", "fr")
"""Of the sheets with the most words, which are this lesson's; it is tried every day."""

CASES = [case for name in LESSONS for tag in languages() if (case := (name, tag)) != LONGEST]


@pytest.mark.parametrize(("name", "tag"), [LONGEST, *part_of(CASES, 24)])
def test_every_lesson_s_sheet_is_one_side(name: str, tag: str, browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "sheet.html"
    with speaking(tag):
        path.write_bytes(sheet_html(sim.load_scene(name)))
    page = browser.new_page()
    page.goto(path.as_uri())
    printed = page.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page\b(?!s)", printed)) == 1
    page.close()
