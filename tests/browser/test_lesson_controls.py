"""Pages with the controls that their address or their scene names; `tests/app/test_controls.py` has which."""

from __future__ import annotations

import msgspec

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk


def tabs(desk: Desk) -> list[str]:
    """The panel's tabs; folded, it has one of its own."""
    return [tab for tab in desk.page.get_by_role("tab").all_inner_texts() if tab != "softrod"]


def test_what_an_address_leaves_out_is_neither_there_nor_reached_by_keys(open_page: OpenPage) -> None:
    desk = open_page(path="/?controls=keys,gravity,rest_angle,view")
    assert tabs(desk) == ["Play"]
    labels = [text for text in desk.page.locator("label:visible").all_inner_texts() if text]
    assert labels == ["Gravity", "Curl of every joint"]
    assert desk.page.locator(".softrod-pad:not([hidden])").count() == 1
    for left_out in (".softrod-transport", ".softrod-edit"):
        assert not desk.page.locator(left_out).is_visible()
    desk.button("View").click()  # it fails out of view
    desk.page.keyboard.press("Escape")
    desk.page.keyboard.press("o")
    desk.page.keyboard.press("e")
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "the keys of the body work: Space pauses")
    desk.rest(3)
    assert not desk.page.locator("dialog[open]").count()
    assert not desk.page.locator(".softrod-edit-bar").is_visible()
    # The address goes before the scene.
    scene = sim.load_scene("ring")
    view = msgspec.structs.replace(scene.view, controls=("solver",))
    desk.tell(commands.Open(msgspec.structs.replace(scene, view=view)))
    desk.rest(3)
    assert tabs(desk) == ["Play"]


def test_a_scene_says_which_controls_there_are_while_it_is_shown(open_page: OpenPage) -> None:
    desk = open_page()
    everything = tabs(desk)
    scene = sim.load_scene("ring")
    for names, shown in ((("play",), []), (("files", "help"), ["Share"]), (None, everything)):
        view = msgspec.structs.replace(scene.view, controls=names)
        desk.tell(commands.Open(msgspec.structs.replace(scene, view=view)))
        desk.until(lambda shown=shown: tabs(desk) == shown, f"the tabs are {shown}")
        there = int(names is None)
        desk.until(lambda there=there: desk.button("Instruments").count() == there, "and so the instruments")
    # The page is as before: the channel works, and what is said of the scene.
    desk.chooser("Ring").wait_for()
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "Space pauses")


def test_a_page_without_a_panel_has_the_bar_of_time_and_the_display(open_page: OpenPage) -> None:
    desk = open_page(path="/?controls=play")
    color = "getComputedStyle(document.querySelector('.softrod-hud')).color"
    desk.until(lambda: desk.page.evaluate(color) == "rgb(51, 65, 85)", "the display has softrod's colour")
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "the bar is there")
    desk.until(lambda: "paused" in desk.hud(), "and so is the display")
    desk.until(desk.clock_is_right, "and the clock")
