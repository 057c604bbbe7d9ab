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


def begin(
    open_page: OpenPage, scene: str = "tutorial-3.3", phone: bool = False, playing: bool = False
) -> Desk:
    """A page on which taps stand for drags."""
    desk = open_page(scene, size=PHONE if phone else DESK, phone=phone)
    desk.tell(commands.Play(playing))
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


def pick_up(desk: Desk, at: Point, name: str) -> None:
    tap(desk, at)
    desk.until(lambda: f"Picked up: {name}" in note(desk).inner_text(), f"{name} is picked up")
    assert desk.page.get_by_role("status").filter(has_text=f"Picked up: {name}").count() == 1, (
        "and said to be"
    )


def put(desk: Desk, start: Point, end: Point, name: str) -> None:
    """Tap a thing, and tap where it goes."""
    pick_up(desk, start, name)
    tap(desk, end)
    desk.until(lambda: desk.page.get_by_role("status").filter(has_text="Put down").count(), "it is put down")
    assert note(desk).is_hidden()


def off(desk: Desk, mass: int, place: Point) -> float:
    return float(np.abs(desk.simulation.positions[mass] - desk.scene_at(place)).max())


@pytest.mark.parametrize("phone", [False, True])
def test_a_mass_and_an_anchor_go_where_they_are_tapped_to(open_page: OpenPage, phone: bool) -> None:
    desk = begin(open_page, phone=phone)
    for mass in (0, 11):  # the first is an anchor
        x, y = desk.place(mass)
        end = x + 40.0, y + 60.0
        put(desk, (x + 2.0, y), end, f"mass {mass}")
        desk.until(lambda mass=mass, end=end: off(desk, mass, end) < 1.5, "it is there")
        assert not desk.session.hands.masses


def test_what_is_picked_up_can_be_put_back(open_page: OpenPage) -> None:
    desk = begin(open_page, playing=True)
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
    desk.until(mark.count, "it has a mark")
    if phone and not desk.page.locator(".softrod-muscles-wave").is_visible():
        desk.button("Muscles").tap()
    desk.made_room()
    before = muscle(desk)
    x, y = middle_of(mark)
    put(desk, (x, y), (x + 60.0, y + 20.0), "Muscle of spring 2")
    desk.until(
        lambda: np.hypot(*np.subtract(middle_of(mark), (x + 60.0, y + 20.0))) < 4.0, "the mark is there"
    )
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
    (left, top), (right, bottom) = desk.place(4), desk.place(7)
    low, high = min(top, bottom) - 30.0, max(top, bottom) + 30.0
    put(desk, (left - 8.0, low), (right + 8.0, high), "corner of a frame")
    desk.until(lambda: desk.session.selection.masses == {4, 5, 6, 7}, "all in it are selected")
    assert desk.session.selection.springs and desk.session.selection.joints
    start = desk.place(5)
    before = desk.simulation.positions
    put(desk, start, (start[0], start[1] + 60.0), "selection")
    desk.page.get_by_role("button", name="Keep").or_(desk.page.locator("dialog button")).first.wait_for()
