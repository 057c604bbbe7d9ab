"""What is dragged, by taps alone: no pointer moves between a press and its release. And by keys alone."""

from __future__ import annotations

import numpy as np
import pytest
from playwright.sync_api import Locator

from app.session import commands
from sim.edit.edit import Selection
from sim.scene.parts import SpringMuscle
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point, box_of, middle_of

DESK, PHONE = (1280, 800), (390, 844)
TREMBLES = 350.0
"""Milliseconds after which a second tap near a thing is meant."""


def begin(open_page: OpenPage, scene: str = "tutorial-3.3", phone: bool = False, plays: bool = False) -> Desk:
    """A page on which taps stand for drags."""
    desk = open_page(scene, size=PHONE if phone else DESK, phone=phone)
    desk.tell(commands.Play(plays))
    desk.view("Access and language")
    switch = desk.page.get_by_role("checkbox", name="Tap instead of drag")
    if phone:
        switch.tap()
    else:
        switch.click()
    desk.page.keyboard.press("Escape")
    return desk


def tap(desk: Desk, at: Point) -> None:
    """By a finger where there is one, and else by the mouse, which does not move meanwhile."""
    if desk.page.evaluate("navigator.maxTouchPoints"):
        desk.page.touchscreen.tap(*at)
    else:
        desk.page.mouse.click(*at)


def note(desk: Desk) -> Locator:
    return desk.page.locator(".softrod-taps")


def said(desk: Desk, text: str) -> bool:
    """Whether a screen reader has heard it last."""
    return desk.page.get_by_role("status").filter(has_text=text).count() == 1


def pick_up(desk: Desk, at: Point, name: str) -> None:
    tap(desk, at)
    desk.until(lambda: f"Picked up: {name}" in note(desk).inner_text(), f"{name} is picked up")
    assert said(desk, f"Picked up: {name}")
    desk.page.wait_for_timeout(TREMBLES)


def put(desk: Desk, start: Point, end: Point, name: str) -> None:
    """Tap a thing, and tap where it goes."""
    pick_up(desk, start, name)
    tap(desk, end)
    desk.until(lambda: said(desk, "Put down"), "it is put down")
    assert note(desk).is_hidden()


def off(desk: Desk, mass: int, place: Point) -> float:
    return float(np.abs(desk.simulation.positions[mass] - desk.scene_at(place)).max())


@pytest.mark.parametrize("phone", [False, True])
def test_a_mass_and_an_anchor_go_where_they_are_tapped_to(open_page: OpenPage, phone: bool) -> None:
    desk = begin(open_page, phone=phone)
    for mass, up in ((0, 60.0), (11, -60.0)):  # the first is an anchor
        x, y = desk.place(mass)
        end = x + 40.0, y + up
        put(desk, (x + 2.0, y), end, f"mass {mass}")
        desk.until(lambda mass=mass, end=end: off(desk, mass, end) < 1.5, "it is there")
        assert not desk.session.hands.masses


def test_what_is_picked_up_can_be_put_back(open_page: OpenPage) -> None:
    desk = begin(open_page, plays=True)
    desk.tell(commands.SetValue("gravity", 0.0))
    before = desk.simulation.positions[0]
    pick_up(desk, desk.place(0), "mass 0")
    desk.until(lambda: desk.session.hands.masses == (0,), "a hand has it")
    desk.page.keyboard.press("Escape")
    desk.until(lambda: not desk.session.hands.masses, "Esc lets it go")
    assert desk.session.playing, "and does nothing else"
    pick_up(desk, desk.place(0), "mass 0")
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "buttons work meanwhile")
    assert desk.session.hands.masses == (0,)
    note(desk).get_by_role("button", name="Put back").click()
    desk.until(lambda: not desk.session.hands.masses, "a button lets it go")
    assert note(desk).is_hidden()
    pick_up(desk, desk.place(0), "mass 0")
    card = desk.page.locator(".softrod-mass-card")
    assert card.is_hidden()
    tap(desk, desk.place(0))
    desk.until(card.is_visible, "another tap on it makes a click of both")
    assert (desk.simulation.positions[0] == before).all()


def test_a_tap_that_slips_picks_up_what_stays_where_it_was(open_page: OpenPage) -> None:
    desk = begin(open_page)
    before = desk.simulation.positions
    x, y = desk.place(11)
    mouse = desk.page.mouse
    mouse.move(x, y)
    mouse.down()
    for slip in (3.0, 7.0, 10.0):
        mouse.move(x + slip, y)
    mouse.up()
    desk.until(lambda: "Picked up: mass 11" in note(desk).inner_text(), "it is a tap")
    assert (desk.simulation.positions == before).all()
    note(desk).get_by_role("button", name="Put back").click()
    desk.until(lambda: said(desk, "Put back"), "it is back")
    assert (desk.simulation.positions == before).all()
    # What goes farther is a drag.
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 20.0, y)
    mouse.move(x + 60.0, y)
    desk.until(lambda: off(desk, 11, (x + 60.0, y)) < 1.5, "it is with the pointer")
    mouse.up()
    assert note(desk).is_hidden()


def test_a_second_tap_of_a_hand_that_trembles_changes_nothing(open_page: OpenPage) -> None:
    desk = begin(open_page)
    x, y = desk.place(11)
    for _ in range(2):
        desk.page.mouse.click(x, y)
    desk.until(lambda: "Picked up: mass 11" in note(desk).inner_text(), "it is picked up")
    desk.page.wait_for_timeout(TREMBLES)
    assert note(desk).is_visible()
    tap(desk, (x, y))
    desk.until(note(desk).is_hidden, "a later tap puts it back")


def test_a_tool_puts_down_the_selection_that_a_tap_picked_up(open_page: OpenPage) -> None:
    desk = begin(open_page)
    tool(desk, "Select")
    pick_up(desk, desk.place(5), "selection")
    anchors = desk.session.scene.anchors
    desk.page.locator(".softrod-edit-bar").get_by_role("button", name="Pin").click()
    desk.until(lambda: len(desk.session.scene.anchors) == len(anchors) + 1, "it is pinned")
    assert note(desk).is_hidden()


def test_a_tap_beside_all_masses_says_that_nothing_is_there(open_page: OpenPage) -> None:
    desk = begin(open_page, phone=True)
    tap(desk, (80.0, 300.0))
    nothing = "There is nothing to pick up here; a body that is paused is easier to tap."
    desk.until(lambda: note(desk).inner_text() == nothing and said(desk, nothing), "it says so")
    pick_up(desk, desk.place(0), "mass 0")
    assert note(desk).get_by_role("button", name="Put back").is_visible()
    scale, over = box_of(desk.page.locator(".softrod-scale")), box_of(note(desk))
    below = over["y"] >= scale["y"] + scale["height"]
    assert below or over["x"] + over["width"] <= scale["x"], "the scale bar is seen, too"


def test_without_the_switch_a_tap_is_a_click(open_page: OpenPage) -> None:
    desk = open_page(size=DESK)
    desk.tell(commands.Play(False))
    tap(desk, desk.place(0))
    desk.until(desk.page.locator(".softrod-mass-card").is_visible, "it is picked")
    assert note(desk).is_hidden()


def muscle(desk: Desk) -> SpringMuscle:
    found = desk.session.simulation.capture().scene.linear_springs[2].muscle
    assert isinstance(found, SpringMuscle)
    return found


@pytest.mark.parametrize("phone", [False, True])
def test_a_muscles_mark_goes_to_another_time_and_strength(open_page: OpenPage, phone: bool) -> None:
    desk = begin(open_page, phone=phone)
    desk.tell(commands.Select(lambda *_: Selection(springs=frozenset({2}))))
    desk.page.keyboard.press("u")
    mark = desk.page.locator('.softrod-muscle[aria-label^="Muscle of spring 2"]')
    desk.page.locator(".softrod-muscles").wait_for()
    if phone:
        desk.page.locator(".softrod-muscles-fold").tap()
    mark.wait_for()
    desk.made_room()
    before = muscle(desk)
    x, y = middle_of(mark)
    put(desk, (x, y), (x + 60.0, y + 20.0), "Muscle of spring 2")
    desk.until(lambda: middle_of(mark) == pytest.approx((x + 60.0, y + 20.0), abs=4.0), "the mark is there")
    desk.until(lambda: muscle(desk).phase != before.phase, "when")
    assert muscle(desk).amplitude < before.amplitude - 0.02, "and how far"
    now = muscle(desk)
    mark.focus()
    desk.page.keyboard.press("ArrowRight")
    desk.page.keyboard.press("ArrowUp")
    desk.until(lambda: muscle(desk).phase != now.phase and muscle(desk).amplitude > now.amplitude, "by keys")


@pytest.mark.parametrize("phone", [False, True])
def test_a_modes_bar_goes_to_the_height_that_is_tapped(open_page: OpenPage, phone: bool) -> None:
    desk = begin(open_page, "bridge", phone=phone)
    desk.page.keyboard.press("v")
    bar = desk.page.locator(".softrod-mode").nth(1)
    bar.wait_for()
    desk.made_room()
    box = box_of(bar.locator(".softrod-mode-box"))
    x = box["x"] + box["width"] / 2.0

    def level() -> float:
        seen = box_of(bar.locator(".softrod-mode-fill"))
        return seen["height"] / box["height"]

    put(desk, (x, box["y"] + 0.9 * box["height"]), (x, box["y"] + 0.3 * box["height"]), "Mode 2")
    desk.until(lambda: abs(level() - 0.7) < 0.05, "its level is there")
    assert desk.session.versions.undoable == "mode 2"
    desk.pause(0.4)  # as long as a press that drives a mode
    assert desk.page.locator(".softrod-mode-driven").count() == 0
    bar.focus()
    desk.page.keyboard.press("End")
    desk.until(lambda: level() > 0.95, "a key moves it, too")


def grips(desk: Desk) -> Locator:
    return desk.page.locator(".softrod-instrument[aria-label^=Ruler] .softrod-grip")


@pytest.mark.parametrize("phone", [False, True])
def test_a_ruler_comes_by_a_tap_and_its_end_goes_onto_a_mass(open_page: OpenPage, phone: bool) -> None:
    desk = begin(open_page, phone=phone)
    tap(desk, middle_of(desk.page.locator(".softrod-box-lid")))
    tool = desk.page.locator(".softrod-box-tools button").filter(has_text="Ruler")
    tap(desk, middle_of(tool))
    grips(desk).first.wait_for()
    tap(desk, middle_of(desk.page.locator(".softrod-box-lid")))
    put(desk, middle_of(grips(desk).first), desk.place(7), "Ruler")
    desk.until(lambda: "At mass 7" in (grips(desk).first.get_attribute("aria-label") or ""), "it is there")
    grips(desk).nth(1).focus()
    before = middle_of(grips(desk).nth(1))
    desk.page.keyboard.press("Shift+ArrowUp")
    desk.until(lambda: middle_of(grips(desk).nth(1))[1] < before[1] - 5.0, "by keys")


def tool(desk: Desk, name: str) -> None:
    button = desk.page.locator(".softrod-edit").get_by_role("button", name=name, exact=True)
    if not button.is_visible():
        desk.page.locator(".softrod-edit").get_by_role("button", name="Edit", exact=True).click()
    button.click()
    desk.made_room()


@pytest.mark.parametrize("phone", [False, True])
def test_a_frame_has_two_corners_that_are_tapped_and_the_selection_is_moved(
    open_page: OpenPage, phone: bool
) -> None:
    desk = begin(open_page, phone=phone)
    tool(desk, "Select")
    xs, ys = zip(*map(desk.place, (4, 5, 6, 7)), strict=True)
    start, end = (min(xs) - 60.0, min(ys) - 5.0), (max(xs) + 40.0, max(ys) + 5.0)
    put(desk, start, end, "corner of a frame")
    desk.until(lambda: desk.session.selection.masses == {4, 5, 6, 7}, "all in it are selected")
    assert desk.session.selection.springs and desk.session.selection.joints
    desk.made_room()  # for the buttons of what is selected
    before = desk.simulation.positions
    x, y = desk.place(4)
    put(desk, (x, y), (x + 30.0, y), "selection")
    desk.page.get_by_role("button", name="Take the new lengths").click()
    desk.until(lambda: desk.simulation.positions[7][0] > before[7][0] + 10.0, "all of them are moved")
    assert (desk.simulation.positions[8] == before[8]).all()


def test_a_frame_by_keys_selects_what_is_between_masses_too(open_page: OpenPage) -> None:
    desk = begin(open_page)
    tool(desk, "Select")
    desk.page.locator(".softrod-body").focus()
    for _ in range(4):
        desk.page.keyboard.press("ArrowRight")
    for _ in range(3):
        desk.page.keyboard.press("Shift+Enter")
        desk.page.keyboard.press("ArrowRight")
    desk.until(
        lambda: desk.session.selection == Selection(*map(frozenset, ({4, 5, 6}, {4, 5}, {4}))),
        "springs between the masses, and the joint between those, are selected",
    )


def test_a_cut_and_a_rest_angle_are_made_by_taps(open_page: OpenPage) -> None:
    desk = begin(open_page)
    tool(desk, "Joint")
    desk.tell(commands.Select(lambda *_: Selection(joints=frozenset({4}))))
    knob = desk.page.locator(".softrod-edit-knob")
    knob.wait_for()
    x, y = middle_of(knob)
    mx, my = desk.place(5)
    put(desk, (x, y), (mx + 70.0, my), "rest angle of a joint")
    desk.until(
        lambda: abs(abs(desk.session.scene.angular_springs[4].rest_angle) - 90.0) < 3.0, "it is turned"
    )
    desk.tell(commands.Undo())
    tool(desk, "Cut")
    (x, y), (_, below) = desk.place(7), desk.place(8)
    middle = (y + below) / 2.0
    put(desk, (x - 60.0, middle), (x + 60.0, middle), "end of a cut")
    desk.until(lambda: len(desk.session.scene.linear_springs) == 10, "the spring is cut")


def test_a_part_of_a_plot_is_enlarged_by_taps_and_by_keys(open_page: OpenPage) -> None:
    desk = begin(open_page, "rod", plays=True)
    desk.page.keyboard.press("g")
    chart = desk.page.locator(".softrod-chart").first
    chart.wait_for()
    desk.until(lambda: desk.simulation.time > 2.0, "there is something to see")
    desk.tell(commands.Play(False))

    def part() -> list[float]:
        """From when to when it is, s; nothing for all."""
        return desk.page.evaluate("window.__softrod.charts()[0].zoom || []")

    chart.scroll_into_view_if_needed()
    box = box_of(chart)
    y = box["y"] + box["height"] / 2.0
    put(desk, (box["x"] + 0.5 * box["width"], y), (box["x"] + 0.75 * box["width"], y), "end of the part")
    first = desk.until(part, "a part is shown")
    assert 0.3 < first[0] < first[1] < desk.simulation.time
    chart.focus()
    desk.page.keyboard.press("ArrowUp")
    (low, high), length = first, first[1] - first[0]
    middle = [low + 0.25 * length, high - 0.25 * length]
    desk.until(lambda: part() == pytest.approx(middle), "the middle half of it")
    desk.pause(0.2)  # the server sends no more than that
    desk.page.keyboard.press("ArrowDown")
    desk.until(lambda: part() == pytest.approx(first), "all of it")
    desk.page.keyboard.press("ArrowLeft")
    desk.until(
        lambda: part() == pytest.approx([low - 0.25 * length, high - 0.25 * length]), "an earlier part"
    )
    desk.page.keyboard.press("Home")
    desk.until(lambda: not part(), "all of it")
    assert desk.simulation.rest_length_scale == 1.0, "the arrows are not the body's"


def test_the_view_is_moved_by_buttons(open_page: OpenPage) -> None:
    """Without the switch; the menu's keys reach them, too."""
    desk = open_page(size=DESK)
    desk.tell(commands.Play(False))
    desk.button("View").click()
    (x, y), far = desk.place(0), desk.camera().distance
    for name, way in (("Farther right", (-1, 0)), ("Farther down", (0, -1))):
        desk.page.get_by_role("menuitem", name=name).click()
        desk.until(lambda x=x, y=y: desk.place(0) != (x, y), "the view moves")
        now = desk.place(0)
        assert tuple(np.sign(np.round(np.subtract(now, (x, y))))) == way
        x, y = now
    desk.page.get_by_role("menuitem", name="Nearer").focus()
    desk.page.keyboard.press("Enter")
    desk.until(lambda: desk.camera().distance == pytest.approx(far / 1.25), "it is nearer")


def test_a_tap_on_the_bar_of_time_goes_there(open_page: OpenPage) -> None:
    """Without the switch, as a slider does; its arrows go by a second."""
    desk = open_page(size=DESK)
    desk.until(lambda: desk.simulation.time > 1.5, "it runs for a while")
    desk.tell(commands.Play(False))
    end = desk.simulation.time
    slider = desk.page.get_by_label("Time shown")
    box = box_of(slider)
    tap(desk, (box["x"] + 0.5 * box["width"], box["y"] + box["height"] / 2.0))
    desk.until(lambda: desk.simulation.time == pytest.approx(end / 2.0, abs=0.1), "half of it")
    desk.page.keyboard.press("Tab")
    slider.focus()
    desk.page.keyboard.press("ArrowRight")
    desk.until(lambda: desk.simulation.time > end / 2.0 + 0.4, "a second later, or the end")


def test_steps_of_a_lesson_are_ordered_by_taps_and_keys(open_page: OpenPage) -> None:
    """Without the switch, by buttons."""
    desk = open_page("lesson-hooke", size=DESK)
    desk.page.keyboard.press("Control+k")
    desk.page.keyboard.type("make a lesson")
    desk.page.keyboard.press("Enter")
    titles = desk.page.locator(".softrod-making-title")
    titles.nth(1).wait_for()
    second = titles.nth(1).inner_text().removeprefix("2. ")
    tap(desk, middle_of(titles.nth(1)))
    tap(desk, middle_of(desk.button("Move up")))
    desk.until(lambda: titles.nth(0).inner_text() == f"1. {second}", "by taps")
    titles.nth(0).focus()
    desk.page.keyboard.press("Alt+ArrowDown")
    desk.until(lambda: titles.nth(1).inner_text() == f"2. {second}", "by keys")


def test_the_sheet_of_a_phone_comes_to_all_of_its_heights_by_taps(open_page: OpenPage) -> None:
    desk = begin(open_page, phone=True)
    panel = "document.documentElement.dataset.softrodPanel"
    for height in ("full", "closed", "half"):
        desk.page.locator(".softrod-handle").tap()
        desk.until(lambda height=height: desk.page.evaluate(panel) == height, f"it is {height}")
