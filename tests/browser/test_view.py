"""The view: the body is large in its canvas, and is not lost when it goes away."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from app.session import commands
from tests.amount import part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import box_of

SIZES = ((1280, 720), (390, 844))


@pytest.mark.parametrize("size", part_of(SIZES, 1))
def test_the_motion_of_a_body_fills_the_free_canvas_with_an_eighth_around_it(
    open_page: OpenPage, size: tuple[int, int]
) -> None:
    desk = open_page("bridge", size=size, phone=size[0] < 600)
    desk.tell(commands.Play(False))
    canvas, dock = desk.page.locator("canvas").first, desk.page.locator(".softrod-dock")

    def fills() -> bool:
        left, right, low, high = desk.state.view
        corners = [desk.tab.probe().mapping.to_scene(*corner) for corner in ((left, low), (right, high))]
        (x0, y0), (x1, y1) = desk.at(np.array(corners))
        width, bottom = box_of(canvas)["width"], box_of(dock)["y"]
        inside = min(x0, x1) >= 0.0 and max(y0, y1) <= bottom
        return inside and 0.7 < max(abs(x1 - x0) / width, abs(y1 - y0) / bottom) < 0.85

    desk.until(fills, "the motion fills three quarters of the canvas")


def test_the_view_goes_after_a_body_that_leaves_it_unless_its_user_has_chosen_another(
    open_page: OpenPage,
) -> None:
    desk = open_page("ring")
    seen = desk.camera()
    x, y = desk.simulation.positions[0]
    desk.tell(commands.DragStart(0, x, y), commands.Point(x + 1500.0, y, late=True), commands.DragEnd())
    desk.until(lambda: not desk.camera().same(seen), "the view moves")
    desk.until(lambda: desk.uncovered(desk.place(0)), "the body is in view again")
    desk.settle()
    desk.page.mouse.move(300.0, 300.0)
    seen = desk.camera()
    desk.page.mouse.wheel(0.0, -100.0)
    desk.until(lambda: not desk.camera().same(seen), "its user zooms")
    desk.pause(0.5)
    chosen = desk.camera()
    desk.tell(commands.DragStart(0, x, y), commands.Point(x - 1500.0, y, late=True), commands.DragEnd())
    desk.pause(0.6)
    assert desk.camera().same(chosen)
    desk.tell(commands.Open(sim.load_scene("rope")))
    desk.until(lambda: desk.uncovered(desk.place(0)), "another scene is shown whole")


def test_the_frame_of_the_page_is_in_its_language(open_page: OpenPage) -> None:
    desk = open_page("rope", path="/?lang=de")
    page = desk.page
    page.get_by_role("tab", name="Löser").wait_for()
    assert page.get_by_role("tab").all_inner_texts() == ["Spielen", "Messen", "Löser", "Teilen"]
    play = page.locator(".softrod-play")
    desk.until(lambda: play.get_attribute("title") == "Pause (Leertaste)", "a key has its German name")
    desk.tell(commands.Play(False))
    desk.until(lambda: page.locator(".softrod-hud b").all_inner_texts() == ["Pause"], "the body is paused")
    assert page.locator(".softrod-label").first.inner_text() == "Krümmung jedes Gelenks"
    number = page.get_by_role("spinbutton").first
    number.fill("nichts")
    number.press("Enter")
    desk.until(lambda: "„nichts“ ist keine Zahl." in page.inner_text("body"), "it says why not")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.get_by_role("combobox", name="Alles finden").fill("letzte änderung")
    found = page.locator(".softrod-found-row")
    desk.until(lambda: "Taste Strg Z" in found.first.inner_text(), "it is found by its German name")
