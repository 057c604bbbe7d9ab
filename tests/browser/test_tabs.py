"""Several tabs on one server, and none: each is its own, and nobody computes for nobody."""

from __future__ import annotations

import numpy as np
from playwright.sync_api import Browser

from tests.browser.conftest import OpenPage, Serve


def test_two_tabs_are_separate_and_closing_one_in_a_drag_frees_it(open_page: OpenPage) -> None:
    # Small, since both draw at the same time.
    one, other = open_page(size=(720, 460)), open_page(size=(720, 460))
    assert one.session is not other.session
    # A control of one is not the other's.
    one.show("Play")
    one.type_in("Gravity", "500")
    one.until(lambda: one.session.scene.gravity == (0.0, 500.0), "gravity is set in one tab")
    other.show("Play")
    other.pause(0.3)
    assert other.session.scene.gravity == (0.0, 2000.0)
    assert other.box("Gravity").input_value() == "2000"

    # Nor is a drag.
    start = one.place(0)
    end = (start[0] + 100.0, start[1] + 30.0)
    held = other.simulation.positions[0]
    one.take(start)
    one.lead(start, end)
    one.until(lambda: one.simulation.positions[0, 0] > 380.0, "the mass is dragged in one tab")
    assert (other.simulation.positions[0] == held).all()
    other.rest(2)
    assert np.abs(other.masses()[0] - held).max() < 0.05

    # In the middle of it the tab is closed.
    assert one.session.hands.masses == (0,)
    gone, tabs = one.simulation, one.served.ticker.tabs
    assert len(tabs) == 2
    one.page.close()
    other.until(lambda: len(tabs) == 1, "the closed tab is gone")
    steps = other.simulation.step_count
    other.until(lambda: other.simulation.step_count > steps + 60, "the other goes on")
    stopped = gone.step_count
    other.pause(0.3)
    assert gone.step_count == stopped


def test_a_page_that_it_does_not_know_says_so(browser: Browser, serve: Serve) -> None:
    context = browser.new_context()
    page = context.new_page()
    page.add_init_script("Object.defineProperty(window, '__viserMutable', { get: () => ({}), set() {} })")
    page.goto(serve("tutorial-3.3").url)
    page.get_by_role("alert").get_by_text("This page cannot draw").wait_for()
    context.close()


def test_a_folded_panel_leaves_the_clock_and_the_display(open_page: OpenPage) -> None:
    desk = open_page()
    desk.page.get_by_role("button", name="Collapse panel area").click()
    desk.until(lambda: not desk.page.get_by_role("tab", name="Solver").is_visible(), "the panel is folded")
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "the bar is still there")
    desk.until(lambda: "paused" in desk.hud(), "and so is the display")
    desk.until(desk.clock_is_right, "and the clock")
