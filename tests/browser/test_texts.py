"""The scene's name and description, edited where they stand."""

from __future__ import annotations

from playwright.sync_api import Locator

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, box_of

EVIL = "<img src=x onerror=window.pwned=1>"


def form(desk: Desk) -> Locator:
    return desk.page.locator("form.softrod-texts")


def begin(desk: Desk) -> None:
    """Open the form by keys, and wait until the name can be typed."""
    desk.button("Edit name and text").press("Enter")
    name = form(desk).get_by_label("Name")
    desk.until(lambda: name.evaluate("it => it === document.activeElement"), "the name has the focus")


def has_focus(desk: Desk) -> bool:
    return bool(desk.page.evaluate("document.activeElement.matches('.softrod-edit-texts')"))


def test_by_keys_alone(open_page: OpenPage) -> None:
    desk = open_page()
    keys, about = desk.page.keyboard, desk.page.locator("#softrod-about")
    before = desk.session.scene
    # Esc leaves the form and nothing else: the body runs on.
    begin(desk)
    keys.type("Never")
    keys.press("Escape")
    desk.until(lambda: has_focus(desk), "the button has the focus again")
    assert form(desk).count() == 0
    assert desk.session.playing
    assert desk.session.scene is before
    # A refusal keeps what was typed.
    begin(desk)
    keys.type("Ring")
    keys.press("Tab")
    keys.press("Control+a")
    keys.type(f"Mine: {EVIL}")
    keys.press("Control+Enter")
    desk.until(lambda: "built-in preset" in form(desk).inner_text(), "it says why not")
    keys.press("Control+a")
    keys.type("Newton's rope")
    keys.press("Enter")
    desk.chooser("Newton's rope").wait_for()
    desk.until(lambda: has_focus(desk), "the button has the focus again")
    assert form(desk).count() == 0
    assert about.locator("p").inner_text() == f"Mine: {EVIL}"
    assert desk.page.evaluate("window.pwned") is None
    scene = desk.session.scene
    assert (scene.name, scene.title) == ("Newton's rope", "")
    # It is one step of undo.
    keys.press("Control+z")
    desk.chooser(before.title).wait_for()
    assert about.locator("p").inner_text() == before.description
    keys.press("Control+y")
    desk.chooser("Newton's rope").wait_for()
    # Another scene is not given what was typed for this one.
    begin(desk)
    desk.tell(commands.Open(sim.load_scene("box")))
    desk.until(lambda: form(desk).count() == 0, "the form goes with its scene")
    # What it is called is what it is saved as.
    desk.tell(commands.Open(scene))
    desk.show("Share")
    desk.until(lambda: desk.control("Name").input_value() == "Newton's rope", "that is offered")


def test_by_touch(open_page: OpenPage) -> None:
    desk = open_page("empty", size=(390, 844), phone=True)
    desk.button("Edit name and text").tap()
    name, text = form(desk).get_by_label("Name"), form(desk).get_by_label("What it shows")
    assert name.input_value() == "Start from nothing"
    assert text.input_value() == desk.session.scene.description
    for field in (name, text):
        box = box_of(field)
        assert box["x"] >= 0 and box["x"] + box["width"] <= 390
        # Or the phone's browser would zoom.
        assert field.evaluate("it => parseFloat(getComputedStyle(it).fontSize)") >= 16
    name.fill("pocket")
    desk.button("Done").tap()
    desk.button("pocket: choose another scene").wait_for()
    assert form(desk).count() == 0
