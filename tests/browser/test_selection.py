"""The folder of what is selected, in a real page."""

from __future__ import annotations

from playwright.sync_api import Locator

import sim
from app.session import commands
from sim.edit.edit import Selection
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import assert_shown


def select(desk: Desk, **parts: set[int]) -> None:
    chosen = Selection(**{kind: frozenset(some) for kind, some in parts.items()})
    desk.tell(commands.Select(lambda *_: chosen))


def stiffnesses(desk: Desk) -> list[float]:
    scene: sim.Scene = desk.session.scene
    return [spring.stiffness for spring in scene.linear_springs[:3]]


def enter(desk: Desk, label: str, text: str) -> None:
    box = desk.control(label)
    box.fill(text)
    box.press("Enter")


def is_away(desk: Desk) -> bool:
    return desk.button("Rest as it is now").count() == 0


def labels(desk: Desk) -> Locator:
    return desk.page.locator("label:visible")


def test_numbers_of_what_is_selected_are_shown_set_and_taken_back(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.tell(commands.Play(False))
    before = stiffnesses(desk)
    select(desk, masses={4}, springs={0, 1})
    desk.page.get_by_text("1 mass, 2 springs", exact=True).and_(
        desk.page.locator(":visible")
    ).first.wait_for()
    desk.button("Rest as it is now").wait_for()
    assert_shown(desk)
    enter(desk, "Stiffness", "25000")
    desk.until(lambda: stiffnesses(desk) == [25_000.0, 25_000.0, before[2]], "both springs are stiffer")
    # Whatever was typed is one step.
    desk.tell(commands.Undo())
    desk.until(lambda: stiffnesses(desk) == before, "an undo takes it back")
    box = desk.control("Stiffness")
    desk.until(lambda: box.input_value() == f"{before[0]:g}", "the box shows it")
    desk.tell(commands.Redo())
    select(desk, springs={1, 2})
    desk.until(lambda: "Stiffness (mixed)" in labels(desk).all_inner_texts(), "they are not the same")
    assert desk.control("Stiffness (mixed)").input_value() == "25000"
    desk.control("Keep proportions").click()
    enter(desk, "Stiffness (mixed)", "50000")
    desk.until(lambda: stiffnesses(desk) == [25_000.0, 50_000.0, 2.0 * before[2]], "proportions are kept")
    enter(desk, "Stiffness (mixed)", "-1")
    desk.notice("Stiffness: 0 to")
    assert stiffnesses(desk)[1] == 50_000.0
    select(desk)
    desk.until(lambda: is_away(desk), "nothing is selected any more")


def test_a_force_on_a_mass_is_set_and_drawn_until_it_is_taken_back(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.tell(commands.Play(False))
    arrows = desk.page.locator(".softrod-loads .softrod-forces")
    assert arrows.count() == 0
    select(desk, masses={4})
    enter(desk, "Force y", "500")
    desk.until(lambda: desk.session.scene.masses[4].force == (0.0, 500.0), "the mass has a force")
    arrows.wait_for(state="attached")
    desk.until(lambda: (arrows.bounding_box() or {"height": 0.0})["height"] > 30.0, "its arrow is drawn")
    box, (x, y) = arrows.bounding_box(), desk.place(4)
    assert box is not None
    assert abs(box["x"] + box["width"] / 2.0 - x) < 3.0
    assert abs(box["y"] - y) < 4.0  # it begins at the mass and points down
    enter(desk, "Start x", "320")
    desk.until(lambda: desk.session.scene.masses[4].position[0] == 320.0, "the mass starts elsewhere")
    desk.until(lambda: abs(desk.simulation.positions[4, 0] - 320.0) < 1e-6, "and is there")
    desk.tell(commands.Undo(), commands.Undo())
    desk.until(lambda: arrows.count() == 0, "without a force there is no arrow")


def test_buttons_hold_masses_and_delete(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    select(desk, masses={6})
    desk.page.get_by_role("button", name="Pin", exact=True).click()
    desk.until(lambda: 6 in {a.mass for a in desk.session.scene.anchors}, "it is held")
    desk.page.get_by_role("button", name="Let go", exact=True).click()
    desk.until(lambda: 6 not in {a.mass for a in desk.session.scene.anchors}, "it is free")
    desk.button("Rest as it is now").click()
    desk.until(lambda: desk.session.versions.undoable == "rest as it is", "its springs rest as they are")
    desk.button("Delete").click()
    desk.until(lambda: len(desk.session.scene.masses) == 11, "it is gone")
    desk.until(lambda: is_away(desk), "and so is the folder")


def test_a_page_without_the_control_has_no_folder(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3", path="/?controls=play,body")
    select(desk, masses={6})
    desk.pause(0.5)
    assert is_away(desk)
