"""Walls, fillings, wind and broken springs in the page."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

import sim
from app.session import commands
from tests.app.worlds import GUSTS, balloon, chain_under_load
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

UNDERLAY = ".softrod-underlay"


def path(desk: Desk, kind: str) -> str:
    """The outline of a kind of thing behind the body."""
    return desk.page.locator(f"{UNDERLAY} .softrod-{kind}").get_attribute("d") or ""


def wind(desk: Desk) -> tuple[str, str]:
    """The streaks of the wind, and how far they have drifted."""
    moved = desk.page.locator(f"{UNDERLAY} .softrod-wind").get_attribute("transform") or ""
    return path(desk, "wind"), moved


def listen(desk: Desk) -> Callable[[], str]:
    """What screen readers are told from now on; a busy page may say something else soon after."""
    desk.page.evaluate("""
      window.live = [];
      const region = document.querySelector(".softrod-live");
      const note = () => window.live.push(region.textContent);
      new MutationObserver(note).observe(region, { childList: true, characterData: true, subtree: true });
    """)
    return lambda: "; ".join(desk.page.evaluate("window.live"))


def color(desk: Desk, place: tuple[float, float]) -> np.ndarray:
    """The colour that most of the surroundings of a place of the scene have."""
    x, y = (round(float(c)) for c in desk.at([place])[0])
    return np.median(desk.picture(marks=False)[y - 6 : y + 7, x - 6 : x + 7].reshape(-1, 3), axis=0)


def test_what_breaks_and_is_whole_again_is_told_to_screen_readers(open_page: OpenPage) -> None:
    desk = open_page()
    live = listen(desk)
    desk.tell(commands.Open(chain_under_load()))
    desk.until(lambda: "1 spring broken" in live(), "the load breaks one")
    assert "1 spring broken" in desk.hud()
    desk.tell(commands.GoTo(0.02))
    desk.until(lambda: "No springs broken" in live(), "back in time none is")


CORNER = (40.0, 300.0)
"""A place on the screen where there is no body, and nothing over the canvas."""


def test_floor_and_filling_are_behind_the_body_at_any_zoom(open_page: OpenPage) -> None:
    desk = open_page(pixels=True)
    desk.tell(commands.Play(False), commands.Open(balloon(liquid=True)))
    desk.until(lambda: path(desk, "wall") and path(desk, "liquid"), "floor and liquid are drawn")
    desk.wait_drawn()
    paper = color(desk, (500.0, 450.0))
    water, ground = color(desk, (305.0, 305.0)), color(desk, (300.0, 592.0))
    assert paper.min() > 230.0
    assert water[2] - water[0] > 40.0  # blue
    assert paper.min() - ground.max() > 8.0
    before = path(desk, "liquid")
    desk.tell(commands.DoSteps(40))
    desk.until(lambda: path(desk, "liquid") != before, "the liquid falls with its loop")
    desk.page.mouse.move(400.0, 300.0)
    seen, drawn = desk.camera(), path(desk, "wall")
    desk.page.mouse.wheel(0.0, 400.0)
    desk.until(lambda: not desk.camera().same(seen), "the view is wider")
    desk.until(lambda: path(desk, "wall") != drawn, "the floor is still over all of it")
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: not path(desk, "wall") + path(desk, "liquid"), "a ring has nothing around it")
    assert path(desk, "grid")
    desk.settle()
    desk.wait_drawn()
    paper = color(desk, tuple(desk.scene_at(CORNER)))
    desk.tell(commands.Open(sim.load_scene("swimmer")))
    desk.until(lambda: path(desk, "medium") and path(desk, "ripple"), "a swimmer is in water")
    desk.settle()
    desk.wait_drawn()
    water = color(desk, tuple(desk.scene_at(CORNER)))
    assert water[2] - water[0] > paper[2] - paper[0] + 10.0
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: not path(desk, "medium") + path(desk, "ripple"), "a ring is in none")


def test_the_wind_drifts_with_the_clock_and_stands_for_those_who_want_it_so(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False), commands.Open(balloon(wind=GUSTS, air_friction=0.01)))
    desk.until(lambda: all(wind(desk)), "the wind is drawn")
    before = wind(desk)
    desk.pause(0.3)
    assert wind(desk) == before  # the clock stands
    desk.tell(commands.DoSteps(20))
    desk.until(lambda: wind(desk) != before, "the wind goes on with the clock")
    desk.page.emulate_media(reduced_motion="reduce")
    desk.tell(commands.DoSteps(1))
    desk.wait_drawn()
    before = wind(desk)
    desk.tell(commands.DoSteps(20))
    desk.wait_drawn()
    assert wind(desk) == before
