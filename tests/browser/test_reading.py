"""The card beside a clicked mass: what it says, where it stands, and how it goes."""

from __future__ import annotations

import numpy as np

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point, box_of


def click(desk: Desk, point: Point) -> None:
    """Point somewhere and click."""
    desk.take(point)
    desk.let_go()


def values(desk: Desk) -> dict[str, str]:
    """What the card says, by names."""
    card = desk.page.locator(".softrod-mass-card")
    return dict(zip(card.locator("dt").all_inner_texts(), card.locator("dd").all_inner_texts(), strict=True))


def test_a_clicked_mass_has_its_joint_beside_it(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3", size=(1000, 640))
    card = desk.page.locator(".softrod-mass-card")
    desk.tell(commands.Play(False), commands.SetValue("rest_angle", 20.0))
    assert card.is_hidden()
    click(desk, desk.place(5))
    card.wait_for()
    assert card.locator("b").inner_text() == "Joint 4"
    desk.until(lambda: values(desk)["rest angle"] == "20.0°", "the card says the rest angle")
    assert values(desk)["stiffness"] == "10,000 kg/s²"
    assert values(desk)["angle"] == f"{desk.simulation.angles[4]:.1f}°".replace("-", "−")
    # It stands on no mass and on nothing else that is to be read, and what it says is said once.
    box = box_of(card)
    places = desk.at(desk.simulation.positions)
    apart = np.abs(places - (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2))
    assert (apart > (box["width"] / 2, box["height"] / 2)).any(axis=1).all()
    assert box["y"] > box_of(desk.page.locator(".softrod-hud"))["y"]
    assert not desk.page.locator(".softrod-angle").is_visible()
    # A mass without a joint says where it is.
    click(desk, desk.place(0))
    desk.until(lambda: card.locator("b").inner_text() == "Mass 0", "the card is the other mass's")
    assert values(desk).keys() == {"x", "y", "speed"}
    # The same mass again, Escape, and the paper: each puts it away, and Escape does nothing else.
    click(desk, desk.place(0))
    card.wait_for(state="hidden")
    desk.tell(commands.Play(True))
    click(desk, desk.place(0))
    card.wait_for()
    desk.page.keyboard.press("Escape")
    card.wait_for(state="hidden")
    assert desk.session.playing
    desk.tell(commands.Play(False))
    click(desk, desk.place(0))
    card.wait_for()
    click(desk, (520.0, 420.0))
    card.wait_for(state="hidden")


def test_the_card_goes_with_its_body(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3", size=(1000, 640))
    card = desk.page.locator(".softrod-mass-card")
    desk.tell(commands.Play(False))
    click(desk, desk.place(5))
    card.wait_for()
    desk.tell(commands.Open(sim.load_scene("ring")))
    card.wait_for(state="hidden")


APART = """mass => new Promise((done) => {
  const apart = [], places = [];
  window.__softrod.afterRedraws(() => {
    const at = window.__softrod.instances("/body/masses").slice(16 * mass + 12, 16 * mass + 15);
    const [x, y] = window.__softrod.project([at])[0];
    const ring = document.querySelector(".softrod-mass-mark circle");
    apart.push(Math.hypot(x - ring.getAttribute("cx"), y - ring.getAttribute("cy")));
    places.push([x, y]);
    if (places.length < 40) return true;
    const ways = places.slice(1).map(([x, y], i) => Math.hypot(x - places[i][0], y - places[i][1]));
    done({ apart: Math.max(...apart), moved: Math.max(...ways) });
    return false;
  });
})"""
"""How far the ring around a mass is from the mass as the canvas shows it, px, at most in so many pictures;
and how far that moves from one to the next."""


def test_marks_are_where_the_canvas_shows_the_body_however_fast_it_moves(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3", size=(1000, 640))
    desk.tell(commands.Play(False))
    last = len(desk.simulation.positions) - 1
    click(desk, desk.place(last))
    desk.page.locator(".softrod-mass-mark circle").wait_for()
    desk.tell(commands.Play(True))
    found = desk.page.evaluate(APART, last)
    assert found["moved"] > 3.0
    assert found["apart"] < 1.0
