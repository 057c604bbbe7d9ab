"""Muscles in the page: made by a key, dragged by mouse, chosen by touch, moved by keys, undone."""

from __future__ import annotations

import pytest
from playwright.sync_api import Locator

from app.session import commands
from sim.edit.edit import Selection
from sim.edit.muscles import crest
from sim.scene.parts import SpringMuscle
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point


def select(desk: Desk, springs: set[int], joints: set[int]) -> None:
    parts = Selection(springs=frozenset(springs), joints=frozenset(joints))
    desk.tell(commands.Select(lambda *_: parts))
    count = len(springs) + len(joints)
    desk.until(
        lambda: (
            desk.page.locator(".softrod-muscle-on").count() in (count, 0) and desk.session.selection == parts
        ),
        "the parts are selected",
    )


def spring(desk: Desk, index: int) -> SpringMuscle:
    muscle = desk.session.simulation.capture().scene.linear_springs[index].muscle
    assert isinstance(muscle, SpringMuscle)
    return muscle


def said(muscle: SpringMuscle) -> str:
    """What the mark of a muscle says."""
    return f"+{round(100.0 * muscle.amplitude)} % at {crest(muscle):.2f} of the beat"


def place(mark: Locator) -> Point:
    box = mark.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2.0, box["y"] + box["height"] / 2.0


def mark(desk: Desk, name: str) -> Locator:
    return desk.page.locator(f'.softrod-muscle[aria-label^="Muscle of {name}"]')


def test_muscles_by_hand(open_page: OpenPage) -> None:
    """From a rope without any to muscles that are moved in every way, and back."""
    desk = open_page(size=(900, 720), phone=True)  # with a touch screen beside the mouse
    page = desk.page
    desk.tell(commands.Play(False))
    first = desk.session.simulation.capture().scene
    assert page.locator(".softrod-muscles").count() == 0
    select(desk, {2, 5}, {3})
    page.keyboard.press("u")
    desk.until(lambda: page.locator(".softrod-muscle-on").count() == 3, "three marks are there and selected")
    desk.until(lambda: len(desk.instances("/body/muscles")) == 2, "two springs have bellies")
    desk.until(lambda: len(desk.instances("/body/halos")) == 1, "and one joint a halo")
    page.get_by_role("button", name="Spread").click()
    desk.until(lambda: spring(desk, 5).phase == 270.0, "the second spring comes half a beat later")
    two = mark(desk, "spring 5")
    desk.until(lambda: place(two)[0] > place(mark(desk, "spring 2"))[0] + 150.0, "its mark is there")

    # Nothing is selected; a mark is pointed at, and dragged with all that is selected then: itself.
    x, y = place(two)
    page.mouse.click(x - 100.0, y)
    desk.until(lambda: not any(desk.session.selection), "a click beside all marks selects none")
    steps = len(desk.session.versions)
    page.mouse.move(x, y)
    desk.until(
        lambda: page.locator(".softrod-muscle-marks path").get_attribute("d"), "it is shown on the body"
    )
    page.mouse.down()
    desk.lead((x, y), (x - 90.0, y - 20.0))
    desk.let_go()
    desk.until(
        lambda: two.get_attribute("aria-valuetext") == said(spring(desk, 5)), "all of the drag is done"
    )
    assert spring(desk, 5).amplitude > 0.25 and 300.0 < spring(desk, 5).phase < 350.0
    assert spring(desk, 5).phase % 5.0 == pytest.approx(0.0, abs=1e-6)
    assert spring(desk, 2) == SpringMuscle(phase=90.0)
    assert len(desk.session.versions) == steps + 1

    # By keys, from mark to mark.
    two.focus()
    page.keyboard.press("Home")
    page.keyboard.press("End")
    before = spring(desk, 5).amplitude
    page.keyboard.press("ArrowDown")
    desk.until(lambda: spring(desk, 5).amplitude == pytest.approx(before - 0.02), "an arrow makes it smaller")
    assert not desk.session.simulation.keys

    # By touch, and what only the selected one has.
    page.touchscreen.tap(*place(mark(desk, "spring 2")))
    desk.until(
        lambda: desk.session.selection.springs == {2} or desk.session.selection.joints, "one is chosen"
    )
    select(desk, {2}, set())
    page.get_by_label("Wave of the selected muscles").select_option("pulse")
    desk.until(lambda: spring(desk, 2).wave == "pulse", "it has another wave")
    page.get_by_label("Tempo in Hz").fill("2.5")
    page.keyboard.press("Enter")

    def beat() -> float:
        scene = desk.session.simulation.capture().scene
        return scene.beat.frequency if scene.beat else -1.0

    desk.until(lambda: beat() == 2.5, "the tempo is another one")
    page.locator(".softrod-muscles-fold").click()
    for _ in range(len(desk.session.versions)):
        desk.tell(commands.Undo())
    desk.until(lambda: desk.session.simulation.capture().scene is first, "all of it is undone")
    desk.until(lambda: page.locator(".softrod-muscles").is_hidden(), "there is nothing left to show")


def test_on_a_phone_neighbours_are_moved_as_a_group(open_page: OpenPage) -> None:
    desk = open_page("worm", size=(390, 844), phone=True)
    page = desk.page
    desk.tell(commands.Play(False))
    page.get_by_role("button", name="Muscles").tap()
    groups = page.get_by_role("button", name="7 groups")
    desk.until(lambda: groups.get_attribute("aria-pressed") == "true", "they are in groups")
    group = mark(desk, "group 3, joints 8 to 11")
    page.touchscreen.tap(*place(group))
    desk.until(lambda: desk.session.selection.joints == {8, 9, 10, 11}, "all of the group are selected")

    def joints() -> list[tuple[float, float]]:
        scene = desk.session.simulation.capture().scene
        return [
            (joint.muscle.amplitude, joint.muscle.phase) for joint in scene.angular_springs if joint.muscle
        ]

    before = joints()
    group.focus()
    page.keyboard.press("ArrowUp")
    desk.until(lambda: joints() != before, "they move")
    grown = [k for k, (old, new) in enumerate(zip(before, joints(), strict=True)) if new[0] > old[0] + 1.0]
    assert grown == [8, 9, 10, 11]
    assert [phase for _, phase in joints()] == pytest.approx([phase for _, phase in before])
    page.get_by_role("button", name="28 muscles").tap()
    desk.until(lambda: page.locator(".softrod-muscle").count() == 28, "each is there alone")
    assert page.locator(".softrod-muscle-on").count() == 4
    # A control that is asked for is seen: the strip makes room for the sheet.
    page.get_by_role("button", name="Find anything").locator("visible=true").tap()
    page.keyboard.type("gravity")
    page.get_by_role("option").filter(has_text="Gravity").first.tap()
    desk.until(lambda: desk.box("Gravity").is_visible(), "the sheet is back")
    assert page.locator(".softrod-muscles-wave").is_hidden()
