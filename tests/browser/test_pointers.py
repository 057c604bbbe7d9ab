"""Several pointers at once: fingers, and a pen beside a palm.

What a page makes of presses that come in other orders, or are lost, is in tests/page/pointers.test.mjs.
"""

from __future__ import annotations

import numpy as np

from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point, middle_of
from tests.browser.test_hands import camera_at_rest, off


class Board:
    """The fingers, the pen and the mouse on a page."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._protocol = desk.context.new_cdp_session(desk.page)
        self._fingers: dict[int, Point] = {}

    def put(self, places: dict[int, Point]) -> None:
        """Put fingers down at once, or move them."""
        kind = "touchMove" if places.keys() <= self._fingers.keys() else "touchStart"
        self._fingers |= places
        self._touch(kind, self._fingers)

    def lift(self, finger: int) -> None:
        """Lift a finger."""
        self._touch("touchEnd", {finger: self._fingers.pop(finger)})  # here, those that are lifted

    def _touch(self, kind: str, fingers: dict[int, Point]) -> None:
        points = [{"x": x, "y": y, "id": finger} for finger, (x, y) in fingers.items()]
        self._protocol.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        self._desk.rest(2)

    def point(self, kind: str, at: Point, pressed: bool, pointer: str = "pen") -> None:
        """Move, press or release the pen, or the mouse."""
        button = {"button": "left" if kind != "mouseMoved" or pressed else "none", "buttons": int(pressed)}
        event = {"type": kind, "x": at[0], "y": at[1], "pointerType": pointer, "clickCount": 1, **button}
        self._protocol.send("Input.dispatchMouseEvent", event)
        self._desk.rest(1)


def still(open_page: OpenPage) -> tuple[Desk, Board]:
    """A page whose clock stands, and what touches it."""
    desk = open_page(phone=True)
    desk.tell(commands.Play(False))
    return desk, Board(desk)


def beside(desk: Desk, mass: int, x: float, y: float) -> Point:
    """A place on the screen, px off a mass."""
    place = desk.place(mass)
    return place[0] + x, place[1] + y


def test_every_finger_drags_a_mass_of_its_own_and_a_palm_beside_a_pen_none(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    camera = desk.camera()
    ways = {2: (-40.0, 50.0), 6: (10.0, 90.0), 10: (60.0, -40.0)}
    ends = {mass: beside(desk, mass, *way) for mass, way in ways.items()}
    for mass in ends:
        board.put({mass: desk.place(mass)})
        board.put({mass: beside(desk, mass, 6.0, 0.0)})
    desk.until(lambda: desk.session.hands.masses == (2, 6, 10), "three masses are in hand")
    for mass, end in ends.items():
        board.put({mass: end})
    desk.until(lambda: max(off(desk, mass, end) for mass, end in ends.items()) < 1.5, "each is at its finger")
    board.lift(6)
    desk.until(lambda: desk.session.hands.masses == (2, 10), "one is let go, and only that")
    for mass in (2, 10):
        board.lift(mass)
    desk.until(lambda: not desk.session.hands.masses, "all are let go")
    assert not desk.simulation.grabbed
    board.point("mouseMoved", desk.place(3), False)
    board.point("mousePressed", desk.place(3), True)
    board.point("mouseMoved", beside(desk, 3, 6.0, 0.0), True)
    desk.until(lambda: desk.session.hands.masses == (3,), "the pen has a mass")
    before = desk.simulation.positions[8]
    for x in (0.0, 40.0):
        board.put({0: beside(desk, 8, x, 0.0)})
    end = beside(desk, 3, 30.0, 30.0)
    board.point("mouseMoved", end, True)
    desk.until(lambda: off(desk, 3, end) < 1.5, "it comes with the pen")
    assert (desk.simulation.positions[8] == before).all()
    assert desk.camera().same(camera)


def test_two_fingers_zoom_even_if_one_meets_a_mass_and_a_lost_release_ends_a_move_of_the_view(
    open_page: OpenPage,
) -> None:
    desk, board = still(open_page)
    before = camera_at_rest(desk)
    mass = desk.place(8)
    board.put({0: beside(desk, 8, -120.0, 90.0), 1: mass})
    for i in range(1, 6):
        board.put({1: (mass[0] + 12.0 * i, mass[1] - 9.0 * i)})
    assert not desk.session.hands.masses
    desk.until(lambda: desk.camera().distance < 0.97 * before.distance, "the view is zoomed")
    for finger in (0, 1):
        board.lift(finger)
    before = camera_at_rest(desk)
    board.point("mouseMoved", (150.0, 330.0), False, "mouse")
    board.point("mousePressed", (150.0, 330.0), True, "mouse")
    board.point("mouseMoved", (190.0, 330.0), True, "mouse")
    board.point("mouseMoved", (192.0, 330.0), False, "mouse")
    moved = camera_at_rest(desk)
    assert np.abs(moved.target - before.target).max() > 0.1
    board.point("mouseMoved", (300.0, 380.0), False, "mouse")
    assert np.allclose(camera_at_rest(desk).target, moved.target)


def test_a_finger_that_scrolls_over_a_slider_leaves_it_and_one_that_slides_or_taps_moves_it(
    open_page: OpenPage,
) -> None:
    desk = open_page(size=(390, 844), phone=True)
    board = Board(desk)
    track = desk.page.get_by_role("slider", name="Bending stiffness").first
    before = desk.slider_value("Bending stiffness")
    x, y = middle_of(track)
    # Upwards, to scroll.
    board.put({1: (x + 80.0, y)})
    for up in (10.0, 40.0, 90.0):
        board.put({1: (x + 82.0, y - up)})
    board.lift(1)
    desk.pause(0.2)
    assert desk.slider_value("Bending stiffness") == before
    # To the side, from where it stands.
    x, y = middle_of(track)
    board.put({1: (x, y)})
    for right in (8.0, 40.0, 60.0):
        board.put({1: (x + right, y + 1.0)})
    board.lift(1)
    desk.until(lambda: desk.slider_value("Bending stiffness") > before, "it slides")
    moved = desk.slider_value("Bending stiffness")
    # A tap.
    board.put({1: (x - 60.0, y)})
    board.lift(1)
    desk.until(lambda: desk.slider_value("Bending stiffness") < moved, "it goes to the tap")
