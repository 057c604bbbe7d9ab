"""Number boxes and sliders: what is typed is set whole, and one visit is one step of undo."""

from __future__ import annotations

import pytest

from app.session import commands
from app.ui.viser import slider_box
from sim.settings import setting_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, middle_of


def value(desk: Desk, key: str) -> float:
    """A setting as the solver has it."""
    scene = desk.session.scene
    return setting_of(scene, key).read(scene)


def begin(desk: Desk, label: str) -> None:
    """Click into a box, and select what is in it."""
    box = desk.box(label)
    box.click()
    box.press("Control+a")


def steps(desk: Desk) -> int:
    """Steps of undo."""
    return len(desk.session.versions)


def let_pass(desk: Desk, seconds: float) -> None:
    """Set the session's clock on, as if so much time went by, s."""
    clock = desk.session.clock
    desk.session.clock = lambda: clock() + seconds


def test_a_number_is_set_whole_however_it_is_typed(
    open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(slider_box, "TOUCHED", 0.05)  # so the server shows what is set while it is typed
    desk = open_page("bridge")
    desk.show("Play")
    seen: set[float] = set()
    setting, old = "linear_stiffness", value(desk, "linear_stiffness")
    take = desk.session.post

    def note(command: commands.Command) -> None:
        if isinstance(command, commands.SetValue):
            seen.add(command.value)
        take(command)

    desk.session.post = note  # type: ignore[method-assign]
    begin(desk, "Stretching stiffness")
    desk.page.keyboard.type("150000", delay=120)
    assert value(desk, setting) == old
    assert desk.box("Stretching stiffness").input_value() == "150000"
    desk.page.keyboard.press("Enter")
    desk.until(lambda: value(desk, setting) == 150_000.0, "Enter sets it")
    assert desk.session.simulation.damage is None or not desk.session.simulation.damage.broken
    # Left for another control.
    begin(desk, "Stretching stiffness")
    desk.page.keyboard.type("2e5", delay=100)
    desk.page.keyboard.press("Tab")
    desk.until(lambda: value(desk, setting) == 200_000.0, "leaving the box sets it")
    desk.until(lambda: desk.box("Stretching stiffness").input_value() == "200000", "the box shows it")
    # Left for the canvas, which does not take the focus.
    begin(desk, "Stretching stiffness")
    desk.page.keyboard.type("1.234.567,5", delay=50)
    desk.page.mouse.click(*desk.at([(10.0, 10.0)])[0])
    desk.until(lambda: value(desk, setting) == 1_234_567.5, "so does a press elsewhere")
    begin(desk, "Stretching stiffness")
    desk.page.keyboard.type("160000")
    desk.until(lambda: value(desk, setting) == 160_000.0, "and so does a pause")
    desk.page.keyboard.type("0")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: value(desk, setting) == 1_600_000.0, "after which the text goes on")
    assert seen == {150e3, 200e3, 1_234_567.5, 160e3, 1600e3}
    # A button that counts, after a number that is not set yet.
    begin(desk, "Gravity")
    desk.page.keyboard.type("500")
    desk.page.keyboard.press("ArrowUp")
    desk.until(lambda: 500.0 < value(desk, "gravity") < 600.0, "an arrow counts on from what was typed")


def test_what_cannot_be_set_is_told_and_the_box_shows_what_is(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.show("Play")
    box = desk.box("Gravity")
    for text, told in (
        ("2x4", "“2x4” is not a number"),
        ("1,234", "1,234 could be 1.234 or 1234"),
        ("-99999999999", "At least −1\u202f000\u202f000 px/s²."),
    ):
        desk.type_in("Gravity", text)
        why = desk.row("Gravity").locator(".softrod-why")
        desk.until(lambda told=told, why=why: told in why.inner_text(), "it is said below the box")
        assert box.input_value() == "2000"
        assert box.get_attribute("aria-invalid") == "true"
    assert value(desk, "gravity") == 2000.0
    # Left empty, and by Escape: as if it had not been touched.
    box.fill("")
    box.blur()
    desk.until(lambda: box.input_value() == "2000", "the number comes back")
    # What others set meanwhile is shown once the box is left.
    begin(desk, "Gravity")
    desk.page.keyboard.type("7")
    desk.tell(commands.SetValue("gravity", 900.0))
    desk.pause(0.6)
    assert box.input_value() == "7"
    desk.page.keyboard.press("Escape")
    desk.until(lambda: box.input_value() == "900", "the box shows what is set")
    assert value(desk, "gravity") == 900.0
    assert not desk.notices()


def test_one_visit_to_a_box_and_one_press_of_a_slider_are_one_step_of_undo(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.show("Play")
    begin(desk, "Gravity")
    for text in ("500", "600"):
        desk.page.keyboard.press("Control+a")
        desk.page.keyboard.type(text)
        desk.page.keyboard.press("Enter")
        desk.until(lambda text=text: value(desk, "gravity") == float(text), "it is set")
        let_pass(desk, 3.0)
    assert steps(desk) == 1
    begin(desk, "Air friction")
    begin(desk, "Gravity")
    desk.page.keyboard.type("700")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: value(desk, "gravity") == 700.0, "it is set")
    assert steps(desk) == 2
    desk.tell(commands.Undo(), commands.Undo())
    assert value(desk, "gravity") == 2000.0

    for label, key in (("Gravity", "gravity"), ("Number of masses", "masses")):
        before = value(desk, key)
        desk.until(
            lambda label=label, before=before: desk.slider_value(label) == before, "the slider shows it"
        )
        x, y = middle_of(desk.thumb(label))
        for _ in range(2):
            desk.page.mouse.move(x, y)
            desk.page.mouse.down()
            for to in (x + 20.0, x + 40.0):
                was = value(desk, key)
                desk.page.mouse.move(to, y, steps=3)
                desk.rest(2)  # the thumb is where the last move put it
                desk.until(
                    lambda key=key, label=label, was=was: was != value(desk, key) == desk.slider_value(label),
                    "the last move has come",
                )
                let_pass(desk, 3.0)
            desk.page.mouse.up()
            x += 40.0
        assert steps(desk) == 2
        # The focus is still on the slider.
        desk.page.keyboard.press("Control+z")
        desk.page.keyboard.press("Control+z")
        desk.until(lambda key=key, before=before: value(desk, key) == before, "it is as before")
        desk.until(
            lambda label=label, before=before: desk.slider_value(label) == before, "the slider shows it"
        )


def test_the_number_of_a_slider_runs_with_it_and_its_ends_are_seen_while_it_is_held(
    open_page: OpenPage,
) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.show("Play")
    before = value(desk, "angular_stiffness")
    x, y = middle_of(desk.thumb("Bending stiffness"))
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    desk.page.mouse.move(x - 30.0, y, steps=4)
    desk.until(
        lambda: (
            value(desk, "angular_stiffness")
            == pytest.approx(10.0 ** desk.slider_value("Bending stiffness"), rel=0.02)
            != pytest.approx(before, rel=0.02)
        ),
        "the value is where the thumb is",
    )
    desk.until(
        lambda: float(desk.box("Bending stiffness").input_value()) == value(desk, "angular_stiffness"),
        "the number is the value",
    )
    ends = desk.row("Bending stiffness").locator(".softrod-ends span").first
    assert ends.is_visible()
    desk.page.mouse.up()
    desk.until(lambda: not ends.is_visible(), "the ends go")
    # A double click brings the scene's own number back.
    desk.thumb("Bending stiffness").dblclick()
    desk.until(lambda: value(desk, "angular_stiffness") == before, "it is as the scene has it")


def test_on_a_phone_a_button_changes_the_sign_since_its_keypad_has_none(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 844), phone=True)
    desk.tell(commands.Play(False))
    box, sign = desk.box("Curl of every joint"), desk.button("Change the sign")
    assert sign.count() == 0
    box.tap()
    desk.page.keyboard.type("12")  # over what was there
    sign.tap()
    assert box.input_value() == "-12"
    assert box.evaluate("it => it === document.activeElement"), "its keypad stays"
    desk.page.keyboard.press("Enter")
    desk.until(lambda: value(desk, "rest_angle") == -12.0, "it is set")
    # What cannot be negative has none.
    desk.box("Bending stiffness").tap()
    assert sign.count() == 0
