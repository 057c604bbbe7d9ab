"""Whatever changes the scene is a step of undo: sliders, choices, another scene; and a reload keeps what was
made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from sim.settings import setting_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.test_edit import SMALL, becomes, beside, drag, paused, tool


def value(desk: Desk, key: str) -> float:
    """A setting as the solver has it."""
    scene = desk.session.scene
    return setting_of(scene, key).read(scene)


def test_a_slider_goes_back_and_forth(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    before, stood = value(desk, "gravity"), desk.slider_value("Gravity")
    desk.click_track("Gravity", 0.9)
    desk.until(lambda: value(desk, "gravity") != before, "the slider reaches the solver")
    after, stands = value(desk, "gravity"), desk.slider_value("Gravity")
    time = desk.simulation.time
    # The focus is still on the slider.
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: value(desk, "gravity") == before, "it is as before")
    desk.until(lambda: desk.slider_value("Gravity") == pytest.approx(stood), "the slider shows it")
    box = desk.box("Gravity")
    desk.until(lambda: float(box.input_value()) == pytest.approx(before), "and so does its box")
    desk.page.keyboard.press("Control+y")
    desk.until(lambda: value(desk, "gravity") == after, "it is set again")
    desk.until(lambda: desk.slider_value("Gravity") == pytest.approx(stands), "the slider shows that, too")
    desk.until(lambda: desk.simulation.time > time, "the run goes on meanwhile")


def test_a_choice_is_taken_back(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.2")
    desk.show("Play")
    before = desk.session.scene.template
    box = desk.control("Angle template")
    stood = box.input_value()
    box.click()
    options = desk.page.get_by_role("option").and_(desk.page.locator(":visible"))
    options.filter(has_not_text=stood).last.click()
    desk.until(lambda: desk.session.scene.template != before, "another template bends it")
    desk.page.keyboard.press("Escape")
    desk.page.mouse.click(*beside(desk, 0, 0.0, -60.0))
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: desk.session.scene.template == before, "the one before does again")
    desk.until(lambda: box.input_value() == stood, "the box shows it")


def test_the_scene_before_comes_back_and_is_fitted_to_the_window(open_page: OpenPage) -> None:
    desk = paused(open_page)
    first, seen = desk.session.simulation.capture(), desk.camera()
    desk.open_scene("bridge")
    desk.until(lambda: len(desk.masses()) == len(desk.session.scene.masses) != 12, "the page shows the other")
    desk.page.mouse.move(*beside(desk, 0, 0.0, 0.0))
    desk.page.mouse.wheel(0.0, -400.0)
    desk.until(lambda: desk.camera().distance < 0.9 * seen.distance, "its user looks closer")
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: desk.session.simulation.capture().scene is first.scene, "the first is back")
    np.testing.assert_array_equal(desk.simulation.positions, first.positions)
    desk.until(lambda: len(desk.masses()) == 12, "the page shows it")
    desk.until(lambda: desk.camera().same(seen), "from where it was seen before")
    desk.page.keyboard.press("Control+y")
    desk.until(lambda: desk.session.scene.name == "bridge", "and the other one again")


def test_a_reload_keeps_what_was_built(open_page: OpenPage) -> None:
    desk = paused(open_page, size=SMALL)
    tool(desk, "Build")
    drag(desk, desk.place(11), beside(desk, 11, 60.0, 0.0))
    becomes(desk, 13, 12, 10)
    desk.page.keyboard.press("Escape")
    built, where = desk.session.simulation.capture().scene, desk.simulation.positions
    script = "sessionStorage.getItem('softrod') ?? ''"
    desk.until(lambda: desk.page.evaluate(script).count('"position"') >= 13, "it is kept")
    desk.open()
    becomes(desk, 13, 12, 10)
    scene = desk.session.simulation.capture().scene
    assert (scene.masses, scene.linear_springs) == (built.masses, built.linear_springs)
    np.testing.assert_allclose(desk.simulation.positions, where, atol=1e-6)
    # It can still be taken back.
    desk.page.keyboard.press("Control+z")
    becomes(desk, 12, 11, 10)
    desk.page.keyboard.press("Control+y")
    becomes(desk, 13, 12, 10)
    # It can be built on.
    tool(desk, "Build")
    drag(desk, desk.place(12), beside(desk, 12, 40.0, 30.0))
    becomes(desk, 14, 13, 10)
