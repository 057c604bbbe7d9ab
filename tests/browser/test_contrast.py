"""All text can be read: contrast of at least 4.5 : 1, or 3 : 1 where it is large (WCAG 2.2, 1.4.3)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SCRIPT = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
TABS = ("Play", "Body", "Solver", "Files", "View")


def judged(desk: Desk) -> list[dict[str, Any]]:
    """Each visible text with its contrast and the least that it needs."""
    return desk.page.evaluate(SCRIPT)


def poor(desk: Desk, where: str) -> list[tuple[str, dict[str, Any]]]:
    """The texts that are too pale."""
    found = judged(desk)
    assert len(found) > 8, where
    return [(where, one) for one in found if one["ratio"] < one["needed"]]


@pytest.mark.parametrize("look", ["light", "dark", "projector"])
def test_every_text_stands_out(open_page: OpenPage, look: str) -> None:
    desk = open_page(size=(1280, 760))
    if look == "projector":
        desk.page.keyboard.press("p")
    if look == "dark":
        desk.show("View")
        desk.control("Dark").click()
        desk.until(lambda: desk.tab._dark, "it is dark")
        desk.pause(0.5)  # the colours fade into one another
    pale: list[tuple[str, dict[str, Any]]] = []
    for tab in TABS:
        desk.show(tab)
        desk.pause(0.3)
        pale += poor(desk, tab)
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_placeholder("Search").wait_for()
    desk.pause(0.8)  # it fades in
    pale += poor(desk, "all commands")
    desk.page.keyboard.press("Escape")
    desk.tell(commands.SetValue("angular_stiffness", 1e8), commands.SetValue("rest_angle", 10.0))
    desk.until(lambda: desk.notices(), "it runs away")
    desk.pause(0.5)
    pale += poor(desk, "a notice, and a way back")
    desk.show("Play")
    desk.button("Help").click()
    desk.page.get_by_role("dialog").wait_for()
    desk.pause(0.5)
    pale += poor(desk, "help")
    assert not pale, pale


def test_pale_text_is_found(open_page: OpenPage) -> None:
    desk = open_page()
    pale = ".softrod-clock { color: #999 !important }"
    desk.page.add_style_tag(content=pale)
    assert [one for _, one in poor(desk, "the page") if one["text"].endswith(" s")]
