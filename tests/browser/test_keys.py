"""Keys: what is held acts and stops, what is pressed once acts once, and none of it moves the camera."""

from __future__ import annotations

import numpy as np

from app.pages.sandbox.features import COMMANDS
from app.session import commands
from app.ui.commands import key_lines, text_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, middle_of

NOTHING: frozenset[str] = frozenset()


def hold(desk: Desk, key: str, what: str) -> None:
    """Hold a key until the solver has it."""
    desk.page.keyboard.down(key)
    desk.until(lambda: what in desk.simulation.keys, f"{key} reaches the solver")


def release(desk: Desk, key: str) -> None:
    """Release a key, and wait until the solver knows."""
    desk.page.keyboard.up(key)
    desk.until(lambda: desk.simulation.keys == NOTHING, f"the solver hears that {key} is released")


def assert_stays(desk: Desk) -> None:
    """Neither rest angles nor rest lengths change while time goes on."""
    angle, scale = desk.simulation.rest_angles[0], desk.simulation.rest_length_scale
    steps = desk.simulation.step_count
    desk.until(lambda: desk.simulation.step_count > steps + 60, "time goes on")
    assert (desk.simulation.rest_angles[0], desk.simulation.rest_length_scale) == (angle, scale)


def test_held_arrows_change_rest_angle_and_length_until_released(open_page: OpenPage) -> None:
    desk = open_page()
    camera = desk.camera()
    desk.show("Play")
    hold(desk, "ArrowRight", "right")
    desk.until(lambda: desk.simulation.rest_angles[0] > 6.0, "the rest angle grows")
    release(desk, "ArrowRight")
    assert_stays(desk)
    angle = float(desk.simulation.rest_angles[0])
    desk.until(lambda: desk.readout("rest angle") == f"{angle:+.2f}°", "the readout shows the rest angle")
    desk.until(lambda: abs(desk.slider_value("Curl of every joint") - angle) < 1.0, "the slider shows it")
    desk.until(
        lambda: abs(float(desk.box("Curl of every joint").input_value()) - angle) < 1e-3, "so does its box"
    )

    before = desk.simulation.rest_length_scale
    hold(desk, "ArrowUp", "up")
    desk.until(lambda: desk.simulation.rest_length_scale > 1.05 * before, "the springs grow")
    release(desk, "ArrowUp")
    scale = desk.simulation.rest_length_scale
    desk.until(lambda: abs(float(desk.box("Rest length").input_value()) - scale) < 1e-3, "the box shows it")
    assert_stays(desk)

    # viser moves the camera with these; here it stays where it is, as it does with the arrows.
    letters = ("KeyW", "KeyA", "KeyQ")
    for key in letters:
        desk.page.keyboard.down(key)
    desk.pause(0.2)
    for key in letters:
        desk.page.keyboard.up(key)
    assert desk.camera().same(camera)


def test_keys_that_are_pressed_once(open_page: OpenPage) -> None:
    desk = open_page()
    press = desk.page.keyboard.press
    press("Space")
    desk.until(lambda: not desk.session.playing, "Space pauses")
    desk.until(lambda: "paused" in desk.hud(), "the page says so")
    steps = desk.simulation.step_count
    press("KeyN")
    desk.until(lambda: desk.simulation.step_count == steps + 1, "N does one step")
    desk.pause(0.2)
    assert desk.simulation.step_count == steps + 1
    press("Space")
    desk.until(lambda: desk.simulation.step_count > steps + 50, "Space resumes")
    press("KeyF")
    desk.until(lambda: desk.control("Follow the pointer").is_checked(), "F follows, and the switch shows it")
    press("KeyF")
    desk.until(lambda: not desk.control("Follow the pointer").is_checked(), "and stops following")
    press("Escape")
    desk.until(lambda: not desk.session.playing, "Esc pauses")
    press("Escape")
    desk.pause(0.2)
    assert not desk.session.playing
    desk.tell(commands.SetValue("rest_angle", 20.0))
    press("KeyR")
    desk.until(lambda: desk.simulation.step_count == 0, "R goes back to the start")
    assert np.allclose(desk.simulation.positions[:, 0], 300.0)
    desk.until(lambda: desk.clock() == "0.00 s", "the clock is back, too")

    # 0 shows the whole scene again.
    first = desk.at(desk.simulation.positions)
    desk.drag((150.0, 330.0), (190.0, 360.0))
    desk.page.mouse.wheel(0.0, 200.0)
    desk.until(lambda: np.abs(desk.at(desk.simulation.positions) - first).max() > 20.0, "the paper is moved")
    desk.pause(0.4)
    press("Digit0")
    desk.until(lambda: np.abs(desk.at(desk.simulation.positions) - first).max() < 0.5, "0 shows all")


def test_space_pauses_after_a_click_wherever_the_focus_is(open_page: OpenPage) -> None:
    """In the panel's controls; `tests/page/keys.test.mjs` has all kinds of elements, texts among them."""
    desk = open_page()

    def plays(what: str) -> None:
        playing = desk.session.playing
        desk.page.keyboard.press("Space")
        desk.until(lambda: desk.session.playing is not playing, f"Space acts after a click on {what}")

    desk.show("Play")
    plays("a tab")
    box = desk.box("Stretching damping")
    box.click()
    plays("a number's box")
    assert box.input_value() == "40"
    desk.show("Solver")
    chooser = desk.page.locator(".softrod-panel select:visible").first
    before = chooser.input_value()
    desk.page.mouse.move(*middle_of(chooser))
    desk.choose("Compare with", "a near-exact solution")
    plays("a choice")
    assert chooser.input_value() == before
    desk.show("Play")
    switch = desk.page.locator("input[type=checkbox]:visible").first
    switch.click()
    was = switch.is_checked()
    plays("a switch")
    assert switch.is_checked() is was
    # What was reached by keys is pressed.
    desk.page.keyboard.press("Shift+Tab")
    desk.page.keyboard.press("Tab")
    desk.page.keyboard.press("Space")
    desk.until(lambda: switch.is_checked() is not was, "Space switches")


def test_help_and_what_finds_anything_list_the_keys(open_page: OpenPage) -> None:
    desk = open_page()
    desk.view("Help")
    dialog = desk.page.get_by_role("dialog")
    text = dialog.inner_text()
    for key, what in key_lines(COMMANDS):
        assert key in text
        assert what in text
    # Keys act on the page behind only once the dialog is gone.
    desk.page.keyboard.press("KeyN")
    desk.pause(0.2)
    assert desk.session.playing
    dialog.get_by_role("button", name="Close", exact=True).last.click()
    desk.until(lambda: dialog.count() == 0, "the help goes away")

    desk.pause(0.5)  # the dialog hands the keyboard back when it has faded away
    desk.page.keyboard.press("Control+k")
    palette = desk.page.get_by_role("option")
    desk.until(lambda: palette.count() > 0, "the palette opens")
    for name, row in COMMANDS.items():
        if row.listed:
            label = text_of(name)
            desk.page.keyboard.press("Control+a")
            desk.page.keyboard.insert_text(label)
            listed = palette.all_inner_texts()
            keys = f"key {' or '.join(row.keys)}" if row.keys else ""
            assert any(label in text and keys in text for text in listed), label
    desk.page.keyboard.press("Control+a")
    desk.page.keyboard.type("1 step")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: not desk.session.playing, "the palette's command is done")
    steps = desk.simulation.step_count
    desk.pause(0.2)
    assert desk.simulation.step_count == steps
    # A slider that is found has the focus, and so has the menu's button after a search from the open menu.
    focused = "[document.activeElement.type, document.activeElement.ariaLabel].join()"
    desk.page.keyboard.press("Control+k")
    desk.page.keyboard.type("Air friction")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: desk.page.evaluate(focused) == "range,", "the slider has the focus")
    desk.page.get_by_role("button", name="View", exact=True).press("Enter")
    desk.page.keyboard.press("Control+k")
    desk.page.keyboard.press("Escape")
    desk.until(lambda: desk.page.evaluate(focused) == "button,View", "the focus comes back")


def test_the_arrow_pad_holds_a_key_while_a_finger_is_on_it(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 844), phone=True)
    button = desk.page.get_by_role("button", name="Right", exact=True)
    button.scroll_into_view_if_needed()
    x, y = middle_of(button)
    touch = desk.context.new_cdp_session(desk.page)
    touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": x, "y": y}]})
    desk.until(lambda: desk.simulation.keys == {"right"}, "the button holds the key")
    desk.until(lambda: desk.simulation.rest_angles[0] > 15.0, "it is held for longer than a press")
    touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    desk.until(lambda: desk.simulation.keys == NOTHING, "it is released")


def test_the_keys_stand_on_what_they_drive(open_page: OpenPage) -> None:
    desk = open_page("crane")
    cap, works = desk.page.locator(".softrod-cap"), desk.page.locator(".softrod-driven .softrod-arrow").last
    desk.until(lambda: cap.all_text_contents() == ["↑ ↓"], "the motor has its keys")
    assert works.get_attribute("d") == ""
    hold(desk, "ArrowUp", "up")
    desk.until(
        lambda: " 0 1 0 " in (works.get_attribute("d") or ""), "the arc says that it turns anticlockwise"
    )
    assert "softrod-on" in (cap.get_attribute("class") or "")
    release(desk, "ArrowUp")
    desk.until(lambda: works.get_attribute("d") == "", "it rests")
