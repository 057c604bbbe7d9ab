"""What goes wrong while one edits by hand: a focus that has nowhere to go, tools in the way, a late question.

Presses that are lost and keys meant for something else are in tests/page/edits.test.mjs.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import sim
from app.session import commands
from sim.edit.edit import Selection
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.test_edit import COUNT, becomes, beside, drag, paused, put_picture, tool


def pick(desk: Desk, **parts: set[int]) -> None:
    chosen = Selection(**{kind: frozenset(some) for kind, some in parts.items()})
    desk.tell(commands.Select(lambda *_: chosen))
    shown = sum(len(some) for some in parts.values())
    desk.until(
        lambda: desk.page.locator(COUNT).first.inner_text().startswith(str(shown)),
        "it is selected",
    )


def test_the_focus_has_somewhere_to_go(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    focused = "document.activeElement?.ariaLabel ?? ''"
    tool(desk, "Build")
    page.locator(".softrod-edit-bar").get_by_role("button", name="Done").press("Enter")
    desk.until(lambda: page.evaluate(focused) == "Edit", "the pencil has it, since the bar is gone")
    page.keyboard.press("e")
    pick(desk, masses={2})
    page.locator(".softrod-edit-bar").get_by_role("button", name="Delete").press("Enter")
    becomes(desk, 11, 9, 7)
    desk.until(lambda: page.evaluate(focused) == "Edit", "and since the button is gone")
    # A dialog gives it back to the body, at the mass that was chosen.
    page.locator(".softrod-body").focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    live = page.locator(".softrod-live")
    desk.until(lambda: "mass 3, " in live.inner_text(), "a mass is chosen")
    before = desk.simulation.positions
    page.keyboard.press("Alt+ArrowRight")
    page.get_by_role("button", name="Keep the rest lengths").press("Enter")
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "it is moved")
    desk.until(lambda: "mass 3, " in live.inner_text(), "it is still chosen")
    before = desk.simulation.positions
    page.keyboard.press("Alt+ArrowRight")
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "it is moved again")
    assert np.flatnonzero((desk.simulation.positions != before).any(1)).tolist() == [3]
    # The last mass goes, and the one before it is chosen.
    for _ in range(4):
        page.keyboard.press("ArrowLeft")
    desk.until(lambda: "mass 10, " in live.inner_text(), "the last one is chosen")
    page.keyboard.press("Delete")
    becomes(desk, 10, 8, 6)
    desk.until(lambda: "mass 9, " in live.inner_text(), "another one is chosen")
    page.keyboard.press("Delete")
    becomes(desk, 9, 7, 5)
    assert not desk.notices()


def test_a_phone_has_room_for_the_body_beside_the_tools(open_page: OpenPage, tmp_path: Path) -> None:
    desk = open_page("box", size=(390, 844), phone=True)
    desk.tell(commands.Play(False), commands.Reset())
    tool(desk, "Select")
    seen = lambda: all(desk.uncovered((x, y)) for x, y in desk.at(desk.simulation.positions))  # noqa: E731
    desk.until(seen, "nothing lies over the masses")
    desk.page.keyboard.press("Control+a")
    # Nor over the scale bar, whether or not the page says that it is paused.
    scale, strip = desk.page.locator(".softrod-scale"), desk.page.locator(".softrod-edit")
    low = "e => e.getBoundingClientRect().bottom"
    for on in (True, False):
        desk.tell(commands.Play(on))
        desk.until(
            lambda: strip.evaluate("e => e.getBoundingClientRect().top") > scale.evaluate(low),
            "the strip is below the scale bar",
        )
    count = desk.page.locator(COUNT).first
    desk.until(lambda: count.inner_text() == "24 parts", "the bar has a short word for all of it")
    assert seen()
    # What is to be done with a picture comes into view.
    put_picture(desk, tmp_path)
    size = desk.page.get_by_text("Size", exact=True)
    desk.until(lambda: 0.0 < (size.bounding_box() or {}).get("x", 0.0) < 150.0, "its controls are there")


def test_a_question_about_a_body_that_is_gone_goes_too(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Select")
    pick(desk, masses={2})
    desk.page.keyboard.press("Alt+ArrowRight")
    dialog = desk.page.get_by_role("dialog", name="Moved masses")
    dialog.wait_for()
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: dialog.count() == 0, "the question is gone")
    desk.until(lambda: len(desk.masses()) == len(desk.session.scene.masses), "the page shows the ring")
    assert not desk.session.versions.redoable
    assert not desk.notices()


def test_moving_a_picture_takes_no_keys_of_others(open_page: OpenPage, tmp_path: Path) -> None:
    desk = paused(open_page, size=(1100, 760))
    page = desk.page
    page.keyboard.press("e")
    image = put_picture(desk, tmp_path)
    button = page.get_by_role("button", name="Move it")
    button.click()
    desk.rest(3)  # marks are drawn with the canvas
    x = image.get_attribute("x")
    desk.gallery()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowRight")
    desk.rest(3)
    assert image.get_attribute("x") == x
    page.keyboard.press("Escape")
    desk.until(lambda: page.get_by_role("dialog").count() == 0, "the gallery is closed")
    assert button.get_attribute("aria-pressed") == "true"
    # It is stored when it rests, and not at every move.
    page.evaluate(
        """() => {
          const real = Storage.prototype.setItem;
          window.stored = 0;
          Storage.prototype.setItem = function (name, text) {
            if (name === "softrod-picture") window.stored += 1;
            real.call(this, name, text);
          };
        }"""
    )
    drag(desk, desk.place(5), beside(desk, 5, 40.0, 30.0))
    desk.until(lambda: page.evaluate("window.stored") > 0, "it is stored")
    assert page.evaluate("window.stored") < 4
    playing = desk.session.playing
    page.keyboard.press("Escape")
    desk.until(lambda: button.get_attribute("aria-pressed") == "false", "Esc ends it")
    assert desk.session.playing == playing


def test_the_tools_stay_where_they_are_when_the_clock_runs(open_page: OpenPage) -> None:
    desk = open_page(size=(1100, 760))
    desk.tell(commands.Play(False))
    tool(desk, "Build")
    desk.until(lambda: "paused" in desk.hud(), "the page says that it is paused")
    cut = desk.page.locator(".softrod-edit").get_by_role("button", name="Cut")
    desk.rest(3)
    before = cut.bounding_box()
    desk.tell(commands.Play(True))
    desk.until(lambda: "paused" not in desk.hud(), "it runs")
    desk.rest(10)
    assert cut.bounding_box() == before


def test_a_screen_reader_hears_what_was_undone(open_page: OpenPage) -> None:
    desk = paused(open_page)
    live = desk.page.locator(".softrod-tell")
    heard = lambda text: live.get_by_text(text, exact=True).count() == 1  # noqa: E731
    tool(desk, "Build")
    desk.page.mouse.click(*beside(desk, 5, 60.0, 0.0))
    desk.until(lambda: heard("mass added"), "it hears what was done")
    desk.page.keyboard.press("p")
    desk.until(lambda: heard("1 mass pinned"), "and what was done next")
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: heard("Undone: 1 mass pinned"), "and that this was undone")
    desk.page.keyboard.press("Control+y")
    desk.until(lambda: heard("1 mass pinned"), "and that it is done again")
    tool(desk, "Select")
    desk.page.mouse.click(*desk.place(3))
    desk.until(lambda: live.filter(has_text="mass 3").count() == 1, "and which mass is selected")
