"""Pages with the controls of a prepared lesson."""

from __future__ import annotations

import msgspec

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk


def tabs(desk: Desk) -> list[str]:
    """The panel's tabs; folded, it has one of its own."""
    return [tab for tab in desk.page.get_by_role("tab").all_inner_texts() if tab != "softrod"]


def test_an_address_says_which_controls_there_are(open_page: OpenPage) -> None:
    desk = open_page(path="/?controls=keys,gravity,rest_angle,view")
    assert tabs(desk) == ["Play"]
    assert desk.button("View").count()
    desk.page.get_by_text("Gravity", exact=True).wait_for()
    labels = [text for text in desk.page.locator("label:visible").all_inner_texts() if text]
    assert labels == ["Gravity", "Rest angle"]
    assert desk.page.get_by_role("button", name="rest angle up").is_visible()
    assert not desk.page.locator(".softrod-transport").is_visible()
    desk.button("View").click()  # it fails out of view
    desk.page.keyboard.press("Escape")
    desk.type_in("Gravity", "12")
    desk.until(lambda: desk.session.scene.gravity == (0.0, 12.0), "it reaches the solver")
    desk.box("Gravity").blur()
    # The gallery is left out, for its key as well; the keys of the body work.
    desk.page.keyboard.press("o")
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "Space pauses")
    desk.rest(3)
    assert not desk.page.locator("dialog[open]").count()
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
    desk.button("Ring").wait_for()
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "Space pauses")
    wrong = msgspec.structs.replace(scene.view, controls=("play", "kees"))
    desk.tell(commands.Open(msgspec.structs.replace(scene, view=wrong)))
    assert "there is no control called 'kees'" in desk.notice("All controls are shown")
    assert tabs(desk) == everything
    desk.view("Dark")
    desk.until(
        lambda: desk.tab.probe().looks.dark and desk.tab.probe().generation >= 0, "the page is made anew"
    )
    desk.rest(5)
    assert not desk.notices(), "it is said once"


def test_a_folded_panel_leaves_the_page_its_colours(open_page: OpenPage) -> None:
    desk = open_page(path="/?controls=play")
    color = "getComputedStyle(document.querySelector('.softrod-hud')).color"
    desk.until(lambda: desk.page.evaluate(color) == "rgb(51, 65, 85)", "the display has softrod's colour")
