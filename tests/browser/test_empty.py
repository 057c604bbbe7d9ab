"""Where nothing is yet, the page says what to do next, and offers it."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.store import files
from tests.browser.conftest import OpenPage
from tests.browser.driver import middle_of


def test_an_empty_canvas_a_tab_without_plots_and_a_gallery_without_own_scenes(
    open_page: OpenPage, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    desk = open_page("empty")
    note = desk.page.locator(".softrod-empty")
    desk.until(lambda: "Nothing is built here yet" in note.inner_text(), "the canvas says so")
    desk.until(lambda: desk.uncovered(desk.place(0)), "it covers no mass")
    desk.button("Draw a body").click()
    desk.until(lambda: "Drag from a mass" in note.inner_text(), "it says how")
    # It is not in the way: a press on it is one on the canvas.
    middle = middle_of(note)
    desk.page.mouse.click(*middle)
    desk.until(lambda: len(desk.session.scene.masses) == 2, "a mass is put down there")
    desk.until(lambda: not note.is_visible(), "there is something now")
    desk.page.keyboard.press("e")

    # The Measure tab begins with a plot of a mass that moves, and so would a new one.
    desk.show("Measure")
    desk.page.get_by_text("Point at a plot to read values").wait_for()
    assert "mass1.x" in desk.page.locator(".softrod-plot-title").inner_text()
    desk.button("Remove").click()
    hint = desk.page.get_by_text("No plot is open.")
    hint.wait_for()
    assert "mass1.x" in hint.inner_text()
    desk.show("Play")
    desk.show("Measure")
    desk.button("New plot").click()
    desk.until(lambda: hint.count() == 0, "one is open, and only that one")
    assert desk.page.locator(".softrod-plot-title").count() == 1

    dialog = desk.gallery()
    own = dialog.get_by_text("You have saved no scene yet")
    own.wait_for()
    dialog.get_by_label("Find a scene").fill("flag")
    desk.until(lambda: not own.is_visible(), "it is not found")
    dialog.get_by_label("Find a scene").fill("")
    own.wait_for()
    begin = own.get_by_role("button", name="Start from nothing")
    assert begin.evaluate("it => it.tabIndex") == 0, "the Tab key reaches it"
    begin.click()
    desk.until(lambda: desk.session.scene.name == "empty", "it is opened")
    files.save_user_scene(desk.session.scene, "mine")
    desk.gallery()
    desk.card("mine").wait_for()
    assert own.count() == 0
