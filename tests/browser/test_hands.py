"""The mouse: masses and gizmos are dragged, the paper is moved and zoomed."""

from __future__ import annotations

import numpy as np

from app.session import commands
from app.session.hand import GIZMO
from tests.browser.conftest import OpenPage
from tests.browser.driver import Camera, Desk, Point
from tests.browser.looks import assert_shown

PAPER: Point = (150.0, 330.0)
"""A place on the screen where nothing is but paper."""


def camera_at_rest(desk: Desk) -> Camera:
    """The camera, once it no longer glides."""
    before = desk.camera()
    while True:
        desk.pause(0.06)
        now = desk.camera()
        if now.same(before):
            return now
        before = now


def off(desk: Desk, mass: int, place: Point) -> float:
    """How far in px of the scene a mass is from a place on the screen."""
    return float(np.abs(desk.simulation.positions[mass] - desk.scene_at(place)).max())


def test_the_ringed_mass_is_dragged_and_stays_where_it_is_left(open_page: OpenPage) -> None:
    desk = open_page()
    camera = desk.camera()
    start = desk.place(0)
    end = (start[0] + 110.0, start[1] + 40.0)
    desk.take(start)
    desk.lead(start, end)
    assert desk.session.hands.masses == (0,)
    assert desk.page.locator(".softrod-hint").count() == 0, "who drags need not be told to"
    desk.until(lambda: off(desk, 0, end) < 1.5, "the mass is at the pointer")
    desk.until(lambda: desk.simulation.positions[-1, 0] > 360.0, "the rope comes after it")
    desk.let_go()
    desk.until(lambda: not desk.session.hands.masses, "the mass is let go")
    left = desk.simulation.positions[0]
    steps = desk.simulation.step_count
    desk.until(lambda: desk.simulation.step_count > steps + 100, "time goes on")
    assert (desk.simulation.positions[0] == left).all()
    assert off(desk, 0, end) < 1.5
    assert desk.camera().same(camera)
    desk.tell(commands.Play(False))
    assert_shown(desk)

    # While the clock stands, the mass alone moves, and at once.
    before = desk.simulation.positions
    desk.drag(end, start)
    desk.until(lambda: off(desk, 0, start) < 1.5, "the mass is moved while paused")
    assert (desk.simulation.positions[1:] == before[1:]).all()
    assert_shown(desk)


def test_the_gizmo_moves_its_mass_freely_by_the_square_and_along_one_axis_by_an_arrow(
    open_page: OpenPage,
) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))  # the view goes after a rope that swings away
    desk.view("Arrows at held masses")
    desk.until(lambda: "/gizmos/0" in desk.tab.probe().nodes, "the gizmo is there")
    desk.rest(5)
    for grip, way, moved in (
        ((16.0, -16.0), (-120.0, 60.0), (-120.0, 60.0)),
        ((45.0, 0.0), (80.0, 50.0), (80.0, 0.0)),
        ((0.0, -45.0), (50.0, 70.0), (0.0, 70.0)),
    ):
        before = np.array(desk.place(0))
        start = (float(before[0]) + grip[0], float(before[1]) + grip[1])
        desk.take(start)
        end = (start[0] + way[0], start[1] + way[1])
        desk.lead(start, end)
        desk.until(lambda: desk.session.hands.masses == (0,), f"the gizmo's grip {grip} is in hand")
        assert desk.session.hands.is_full(GIZMO)
        wanted = before + moved
        desk.until(
            lambda wanted=wanted: np.abs(np.array(desk.place(0)) - wanted).max() < 2.0,
            f"the mass is led by the gizmo's grip {grip}",
        )
        if 0.0 in moved:
            still = moved.index(0.0)
            assert abs(desk.place(0)[still] - before[still]) < 0.01
        desk.let_go()
        desk.until(lambda: not desk.session.hands.masses, "the gizmo is let go")
        # The gizmo is where its mass is: the next grip is found from there.
        assert np.abs(np.array(desk.place(0)) - wanted).max() < 2.0


def test_the_paper_is_moved_and_zoomed_but_never_turned(open_page: OpenPage) -> None:
    desk = open_page()
    first = camera_at_rest(desk)
    x, y = PAPER
    # The paper goes along with the pointer, whichever button.
    for button in ("left", "right"):
        before, under = camera_at_rest(desk), desk.scene_at((x, y))
        desk.page.mouse.move(x, y)
        desk.rest(3)
        desk.page.mouse.down(button=button)
        desk.lead((x, y), (x + 60.0, y + 40.0))
        desk.page.mouse.up(button=button)
        after = camera_at_rest(desk)
        assert np.abs(after.target - before.target).max() > 0.1, button
        assert not after.turned(before), button
        assert after.distance == before.distance
        if button == "left":
            assert np.abs(desk.scene_at((x + 60.0, y + 40.0)) - under).max() < 2.0
    assert not desk.session.hands.masses

    # The wheel zooms, and what is under the cursor stays there.
    before, under = camera_at_rest(desk), desk.scene_at((x, y))
    desk.page.mouse.move(x, y)
    desk.page.mouse.wheel(0.0, -300.0)
    desk.until(lambda: desk.camera().distance < before.distance, "the wheel zooms")
    after = camera_at_rest(desk)
    assert not after.turned(before)
    assert np.abs(desk.scene_at((x, y)) - under).max() < 2.0
    assert not camera_at_rest(desk).turned(first)
