"""Several pointers at once: fingers, a pen beside a palm, and a release that never reaches the page."""

from __future__ import annotations

import numpy as np
import pytest

from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point
from tests.browser.test_hands import camera_at_rest, off


class Board:
    """The fingers and the pen on a page."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._protocol = desk.context.new_cdp_session(desk.page)
        self._fingers: dict[int, Point] = {}

    def put(self, finger: int, at: Point) -> None:
        """Put a finger down, or move it."""
        self.put_all({finger: at})

    def put_all(self, places: dict[int, Point]) -> None:
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

    def pen(self, kind: str, at: Point, pressed: bool, pointer: str = "pen") -> None:
        """Move, press or release the pen, or the mouse."""
        button = {"button": "left" if kind != "mouseMoved" or pressed else "none", "buttons": int(pressed)}
        event = {"type": kind, "x": at[0], "y": at[1], "pointerType": pointer, "clickCount": 1, **button}
        self._protocol.send("Input.dispatchMouseEvent", event)
        self._desk.rest(1)

    def stroke(self, start: Point, end: Point) -> None:
        """Draw with the pen."""
        self.pen("mouseMoved", start, False)
        self.pen("mousePressed", start, True)
        for part in (0.3, 0.6, 1.0):
            at = (start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1]))
            self.pen("mouseMoved", at, True)
        self.pen("mouseReleased", end, False)


def still(open_page: OpenPage, scene: str = "tutorial-3.3") -> tuple[Desk, Board]:
    """A page whose clock stands, and what touches it."""
    desk = open_page(scene, phone=True)
    desk.tell(commands.Play(False))
    return desk, Board(desk)


def beside(desk: Desk, mass: int, x: float, y: float) -> Point:
    """A place on the screen, px off a mass."""
    place = desk.place(mass)
    return place[0] + x, place[1] + y


def test_every_finger_drags_a_mass_of_its_own(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    camera = desk.camera()
    ends = {
        2: beside(desk, 2, -40.0, 50.0),
        6: beside(desk, 6, 10.0, 90.0),
        10: beside(desk, 10, 60.0, -40.0),
    }
    for mass in ends:
        board.put(mass, desk.place(mass))
    desk.until(lambda: desk.session.hands.masses == (2, 6, 10), "three masses are in hand")
    for mass, end in ends.items():
        board.put(mass, end)
    desk.until(lambda: max(off(desk, mass, end) for mass, end in ends.items()) < 1.5, "each is at its finger")
    board.lift(6)
    desk.until(lambda: desk.session.hands.masses == (2, 10), "one is let go, and only that")
    board.put(2, beside(desk, 2, 0.0, 30.0))
    desk.until(lambda: off(desk, 2, (ends[2][0], ends[2][1] + 30.0)) < 1.5, "the others go on")
    assert desk.camera().same(camera)
    board.lift(2)
    board.lift(10)
    desk.until(lambda: not desk.session.hands.masses, "all are let go")
    assert not desk.simulation.grabbed


def test_a_thumb_that_rests_keeps_no_other_finger_from_a_mass(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    tab = desk.page.get_by_role("tab", name="Play").bounding_box()
    dock = desk.page.locator(".softrod-clock").bounding_box()
    assert tab and dock
    places = {
        "panel": (tab["x"] + tab["width"] / 2, tab["y"] + tab["height"] / 2),
        "bar": (dock["x"] + dock["width"] / 2, dock["y"] + dock["height"] / 2),
        "canvas": (40.0, 330.0),
    }
    for resting, place in places.items():
        board.put(0, place)
        desk.pause(0.4)  # longer than it takes to put two fingers down at once
        board.put(1, desk.place(8))
        desk.until(
            lambda: desk.session.hands.masses == (8,), f"the mass is in hand, a thumb on the {resting}"
        )
        end = beside(desk, 8, 15.0, 10.0)
        board.put(1, end)
        desk.until(lambda end=end: off(desk, 8, end) < 1.5, "it comes with the finger")
        board.lift(1)
        board.lift(0)
        desk.until(lambda: not desk.session.hands.masses, "it is let go")


def test_two_fingers_that_come_down_together_zoom_even_if_one_meets_a_mass(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    before = camera_at_rest(desk)
    mass = desk.place(8)
    board.put_all({0: beside(desk, 8, -120.0, 90.0), 1: mass})
    for i in range(1, 6):
        board.put(1, (mass[0] + 12.0 * i, mass[1] - 9.0 * i))
    assert not desk.session.hands.masses
    desk.until(lambda: desk.camera().distance < 0.97 * before.distance, "the view is zoomed")


def test_a_pen_builds_under_a_resting_palm(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    camera = desk.camera()
    desk.page.keyboard.press("e")
    masses = len(desk.session.scene.masses)
    end = desk.place(11)
    # The palm rests for longer than any press lasts, then comes down just before the pen, and last beside it.
    board.put(0, (60.0, 400.0))
    desk.pause(0.8)
    board.stroke(end, (end[0] + 90.0, end[1] - 60.0))
    desk.until(lambda: len(desk.session.scene.masses) == masses + 1, "a mass is built")
    board.lift(0)
    desk.pause(0.8)
    board.put(0, (60.0, 400.0))
    board.stroke((end[0] + 90.0, end[1] - 60.0), (end[0] + 90.0, end[1] - 130.0))
    desk.until(lambda: len(desk.session.scene.masses) == masses + 2, "another is")
    board.lift(0)
    board.pen("mouseMoved", (end[0] + 90.0, end[1] - 130.0), False)
    board.pen("mousePressed", (end[0] + 90.0, end[1] - 130.0), True)
    board.put(0, (60.0, 400.0))
    board.put(0, (90.0, 380.0))
    board.pen("mouseMoved", (end[0] + 150.0, end[1] - 130.0), True)
    board.pen("mouseReleased", (end[0] + 150.0, end[1] - 130.0), False)
    desk.until(lambda: len(desk.session.scene.masses) == masses + 3, "and a third")
    board.lift(0)
    assert desk.camera().same(camera)


def test_a_palm_beside_a_pen_takes_no_mass(open_page: OpenPage) -> None:
    desk, board = still(open_page)
    board.pen("mouseMoved", desk.place(3), False)
    board.pen("mousePressed", desk.place(3), True)
    desk.until(lambda: desk.session.hands.masses == (3,), "the pen has a mass")
    before = desk.simulation.positions[8]
    board.put(0, desk.place(8))
    board.put(0, beside(desk, 8, 40.0, 0.0))
    end = beside(desk, 3, 30.0, 30.0)
    board.pen("mouseMoved", end, True)
    desk.until(lambda: off(desk, 3, end) < 1.5, "it comes with the pen")
    board.pen("mouseReleased", end, False)
    desk.until(lambda: not desk.session.hands.masses, "it is let go")
    assert (desk.simulation.positions[8] == before).all()


@pytest.mark.parametrize("pointer", ["mouse", "pen"])
def test_a_release_that_never_reaches_the_page_ends_the_drag(open_page: OpenPage, pointer: str) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    board = Board(desk)
    for loss in ("no button", "another window"):
        start = desk.place(11)
        end = (start[0] - 40.0, start[1] - 30.0)
        board.pen("mouseMoved", start, False, pointer)
        board.pen("mousePressed", start, True, pointer)
        board.pen("mouseMoved", end, True, pointer)
        desk.until(lambda end=end: off(desk, 11, end) < 1.5, "the mass is at the pointer")
        if loss == "no button":
            board.pen("mouseMoved", (end[0] + 80.0, end[1] + 60.0), False, pointer)
        else:
            desk.page.evaluate("window.dispatchEvent(new Event('blur'))")
        desk.until(lambda: not desk.session.hands.masses, "the mass is let go")
        board.pen("mouseMoved", (end[0] + 90.0, end[1] + 70.0), False, pointer)
        desk.rest(3)
        assert off(desk, 11, end) < 1.5


def test_a_release_that_never_reaches_the_page_ends_the_move_of_the_view(open_page: OpenPage) -> None:
    desk = open_page()
    board = Board(desk)
    board.pen("mouseMoved", (150.0, 330.0), False, "mouse")
    board.pen("mousePressed", (150.0, 330.0), True, "mouse")
    board.pen("mouseMoved", (190.0, 330.0), True, "mouse")
    board.pen("mouseMoved", (192.0, 330.0), False, "mouse")
    before = camera_at_rest(desk)
    board.pen("mouseMoved", (300.0, 380.0), False, "mouse")
    after = camera_at_rest(desk)
    assert np.allclose(after.target, before.target)


PRESS = """([x, y]) => window.__softrod.canvas().dispatchEvent(new PointerEvent("pointerdown", {
  pointerId: 1, pointerType: "mouse", isPrimary: true, button: 0, buttons: 1,
  clientX: x, clientY: y, bubbles: true, cancelable: true,
}))"""


def test_a_press_of_a_pointer_that_was_never_released_ends_what_it_held(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.page.evaluate(PRESS, list(desk.place(11)))
    desk.until(lambda: desk.session.hands.masses == (11,), "the mass is in hand")
    desk.page.evaluate(PRESS, list(desk.place(5)))
    desk.until(lambda: desk.session.hands.masses == (5,), "another one is, and only that")


def test_a_release_that_never_reaches_the_page_leaves_an_instrument_in_its_box(open_page: OpenPage) -> None:
    desk = open_page()
    desk.button("Instruments").click()
    ruler = desk.button("Ruler")
    box = ruler.bounding_box()
    assert box is not None
    board, x, y = Board(desk), box["x"] + 20.0, box["y"] + 20.0
    board.pen("mouseMoved", (x, y), False, "mouse")
    board.pen("mousePressed", (x, y), True, "mouse")
    for step in (2.0, 60.0, 200.0):
        board.pen("mouseMoved", (x + step, y), False, "mouse")
    assert ruler.get_attribute("aria-pressed") == "false"
