"""Going back in time, and coming back after a reload or an outage."""

from __future__ import annotations

from contextlib import ExitStack

import numpy as np
import pytest
from playwright.sync_api import Browser

import sim
from app.server.serve import serving
from app.session import commands, history
from tests.browser.conftest import DESKTOP, OpenPage
from tests.browser.driver import Desk, Served, rough_context

SMALL = (820, 620)
_SLIDE = """(slider, value) => {
  slider.value = value;
  for (const kind of ["input", "change"]) slider.dispatchEvent(new Event(kind));
}"""


def assert_shows(desk: Desk, positions: np.ndarray) -> None:
    def shows() -> bool:
        masses = desk.masses()
        return masses.shape == positions.shape and np.allclose(masses, positions, atol=0.5)

    desk.until(shows, "the page shows that moment")


def test_the_bar_goes_back_and_on_from_there(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("rest_angle", 12.0))
    desk.until(lambda: desk.simulation.time > 2.5, "it runs for a while")
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "it pauses")
    end, last = desk.simulation.time, desk.simulation.positions
    slider = desk.page.get_by_label("Time shown")
    slider.evaluate(_SLIDE, 1.0)
    desk.until(lambda: abs(desk.simulation.time - 1.0) < 0.03, "it is one second after the start")
    desk.until(desk.clock_is_right, "the clock shows it")
    assert "looking back" in desk.hud()
    assert_shows(desk, desk.simulation.positions)
    assert np.abs(desk.simulation.positions - last).max() > 1.0

    time = desk.simulation.time
    desk.page.keyboard.press("Period")
    desk.until(lambda: 0.0 < desk.simulation.time - time < 0.1, "one frame forward")
    desk.page.keyboard.press("Comma")
    desk.until(lambda: desk.simulation.time == time, "and back")
    slider.evaluate(_SLIDE, end)
    desk.until(lambda: desk.simulation.time == end, "nothing is lost: it is back at the end")
    assert (desk.simulation.positions == last).all()

    desk.button("Back 1 s").click()
    desk.until(lambda: abs(desk.simulation.time - end + 1.0) < 0.05, "one second back")
    desk.tell(commands.SetValue("rest_angle", -12.0))
    desk.button("Go on from here").click()
    desk.until(lambda: desk.session.playing, "it goes on")
    desk.page.get_by_text("what happened before you went back").wait_for()
    desk.until(lambda: len(desk.instances("/body/ghost")) == len(last) - 1, "what came before is a thin line")
    desk.until(lambda: desk.simulation.time > end + 0.5, "until it is over")
    desk.until(lambda: len(desk.instances("/body/ghost")) == 0, "then the line goes")
    desk.button("Take the line away").click()
    desk.until(lambda: desk.session.abandoned_future is None, "it is forgotten")
    desk.until(lambda: desk.button("Take the line away").count() == 0, "and so is its button")


def test_the_bar_goes_to_what_is_no_longer_stored_by_pointer_and_keys(
    open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(history, "SPAN", 30)
    desk = open_page()
    desk.tell(commands.Speed(4.0))
    desk.until(lambda: desk.simulation.time > 6.0, "it runs for a while")
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "it pauses")
    end, slider = desk.simulation.time, desk.page.get_by_label("Time shown")
    assert len(desk.session.history) < 60
    box = slider.bounding_box()
    assert box is not None
    desk.page.mouse.click(box["x"] + 0.3 * box["width"], box["y"] + box["height"] / 2)
    desk.until(lambda: desk.simulation.time < 0.4 * end, "it is at a third")
    desk.until(desk.clock_is_right, "the clock shows it")
    assert_shows(desk, desk.simulation.positions)
    time = desk.simulation.time
    desk.button("Forward 1 frame").focus()
    desk.page.keyboard.press("Tab")
    desk.page.keyboard.press("ArrowRight")
    desk.until(lambda: abs(desk.simulation.time - time - 1.0) < 0.2, "an arrow goes on by a second")
    desk.page.keyboard.press("PageUp")
    desk.until(lambda: desk.simulation.time == end, "and a page by a minute, or to the end")
    desk.page.keyboard.press("Home")
    desk.until(lambda: desk.simulation.time == 0.0, "to the start")


def test_the_scene_before_comes_back_and_is_fitted_to_the_window(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    desk.tell(commands.Play(False))
    desk.made_room()
    first, seen = desk.session.simulation.capture(), desk.camera()
    desk.tell(commands.Open(sim.load_scene("bridge")))
    desk.until(lambda: len(desk.masses()) == len(desk.session.scene.masses) != 12, "the page shows the other")
    desk.settle()
    other = desk.camera()
    desk.page.mouse.move(*desk.place(0))
    desk.page.mouse.wheel(0.0, -400.0)
    desk.until(lambda: desk.camera().distance < 0.9 * other.distance, "its user looks closer")
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: desk.session.simulation.capture().scene is first.scene, "the first is back")
    desk.until(lambda: len(desk.masses()) == 12, "the page shows it")
    desk.until(lambda: desk.camera().same(seen), "from where it was seen before")


def test_a_reload_comes_back_to_where_it_was_with_what_can_be_undone(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    desk.tell(commands.Open(sim.load_scene("ring")), commands.SetValue("linear_stiffness", 7000.0))
    desk.view("Dark")
    desk.until(lambda: desk.simulation.time > 0.5, "it runs")
    desk.tell(commands.Play(False))
    where, time = desk.simulation.positions, desk.simulation.time
    kept = """() => {
        const { looks, session } = JSON.parse(sessionStorage.getItem("softrod") ?? "{}");
        return [session?.moment?.time, session?.wishes.playing, looks?.dark ?? false];
    }"""
    desk.until(lambda: desk.page.evaluate(kept) == [time, False, True], "the browser keeps it")
    desk.open()
    desk.until(lambda: desk.session.scene.name == "ring", "the scene is back")
    desk.until(lambda: desk.simulation.time == time, "and the time")
    assert (desk.simulation.positions == where).all()
    assert not desk.session.playing
    desk.until(lambda: desk.tab.probe().looks.dark, "and the dark")
    assert desk.viewed("Dark"), "its switch says so"
    assert_shows(desk, where)
    assert not desk.notices()
    stiffness = lambda: sim.settings.SETTINGS["linear_stiffness"].read(desk.session.scene)  # noqa: E731
    assert stiffness() == 7000.0
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: stiffness() != 7000.0, "it can still be taken back")


def test_a_server_that_is_started_anew_has_the_page_back(browser: Browser) -> None:
    scene = sim.load_scene("tutorial-3.3")
    with ExitStack() as rest:
        with serving(scene, "127.0.0.1", 0) as (server, ticker, _):
            port = server.get_port()
            served = Served(f"http://127.0.0.1:{port}", ticker)
            context = rough_context(browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]})
            rest.callback(context.close)
            desk = Desk(served, context)
            desk.open()
            desk.tell(commands.SetValue("rest_angle", 15.0), commands.DoSteps(100))
            where, time = desk.simulation.positions, desk.simulation.time
            kept = "() => JSON.parse(sessionStorage.getItem('softrod') ?? 'null')?.session.moment?.time"
            desk.until(lambda: desk.page.evaluate(kept) == time, "the browser keeps it")
        desk.page.get_by_text("Reconnecting").wait_for()
        _, served.ticker, _ = rest.enter_context(serving(scene, "127.0.0.1", port))
        desk.client = desk.until(lambda: list(served.ticker.tabs), "the page connects by itself")[0]
        desk.until(lambda: desk.tab.session is not None, "the tab has its session")
        desk.until(lambda: desk.simulation.time == time, "it is where it was")
        assert (desk.simulation.positions == where).all()
        assert_shows(desk, where)
        assert not desk.page.get_by_text("Reconnecting").is_visible()
