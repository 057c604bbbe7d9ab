"""A body built and changed by hand: by mouse, by touch, and by keys alone; undone, saved, sent, opened."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Locator

import sim
from app.session import commands
from sim.edit.build import extend, positions_of
from sim.edit.edit import Edit, Selection
from sim.store import files
from tests.amount import NIGHT
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point, box_of

SMALL = (820, 620)
COUNT = ".softrod-edit-count"
"""What is selected, and the place of what a tool waits for."""


def counts(desk: Desk) -> tuple[int, int, int]:
    """Masses, springs and joints of the body."""
    scene = desk.session.simulation.capture().scene
    return len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)


def becomes(desk: Desk, masses: int, springs: int, joints: int) -> None:
    """Wait until the body has so many parts, and the page shows them."""
    wanted = (masses, springs, joints)
    desk.until(lambda: counts(desk) == wanted, f"the body has {wanted}, not {counts(desk)}")
    desk.until(lambda: len(desk.masses()) == masses, "the page shows them")


def paused(open_page: OpenPage, scene: str = "tutorial-3.3", size: tuple[int, int] = SMALL) -> Desk:
    desk = open_page(scene, size=size, pixels=NIGHT)
    desk.tell(commands.Play(False))
    return desk


def tool(desk: Desk, name: str) -> None:
    """Take a tool by its button."""
    button = desk.page.locator(".softrod-edit").get_by_role("button", name=name, exact=True)
    if not button.is_visible():
        desk.page.locator(".softrod-edit").get_by_role("button", name="Edit", exact=True).click()
        desk.made_room()  # the tools push the body down
    button.click()
    desk.until(lambda: button.get_attribute("aria-pressed") == "true", f"{name} is taken")


def action(desk: Desk, name: str) -> None:
    """Press a button of the bar."""
    desk.page.locator(".softrod-edit-bar").get_by_role("button", name=name, exact=True).click()


def beside(desk: Desk, mass: int, dx: float, dy: float) -> Point:
    """A place so many pixels from a mass."""
    x, y = desk.place(mass)
    return x + dx, y + dy


def drag(desk: Desk, start: Point, end: Point) -> None:
    desk.page.mouse.move(*start)
    desk.page.mouse.down()
    desk.lead(start, end)
    desk.let_go()


def put_picture(desk: Desk, folder: Path, width: int = 40, height: int = 20) -> Locator:
    """Put a picture behind the body, once the tools are there."""
    path = folder / "bridge.png"
    Image.new("RGB", (width, height), (250, 80, 10)).save(path)
    desk.page.locator(".softrod-edit-bar input[type=file]").set_input_files(path)
    image = desk.page.locator(".softrod-underlay image")
    desk.until(lambda: image.count() == 1, "the picture is there")
    return image


def test_a_body_is_built_by_mouse_and_taken_back(open_page: OpenPage) -> None:
    """Clicks, drags and chains; `tests/app/test_edits.py` has what a gesture does to the body."""
    desk = paused(open_page)
    page = desk.page
    first = desk.session.simulation.capture().scene
    tool(desk, "Build")
    page.mouse.click(*beside(desk, 3, 60.0, 0.0))
    becomes(desk, 13, 11, 10)
    # On the grid, and at rest; a drag makes a spring and a mass, and a click goes on from there.
    x, y = desk.session.scene.masses[12].position
    assert (x % 20.0, y % 20.0) == pytest.approx((0.0, 0.0), abs=1e-3)
    drag(desk, desk.place(12), beside(desk, 12, 60.0, 0.0))
    becomes(desk, 14, 12, 10)
    page.mouse.click(*beside(desk, 13, 0.0, 60.0))
    becomes(desk, 15, 13, 10)
    page.mouse.click(*desk.place(12))
    becomes(desk, 15, 14, 10)
    page.keyboard.press("Escape")
    # From mass to mass.
    drag(desk, desk.place(14), desk.place(11))
    becomes(desk, 15, 15, 10)
    built = desk.session.simulation.capture().scene
    # Back to the very scene that it began with, by the button; and on again by keys.
    undo = page.locator(".softrod-edit").get_by_role("button", name="Undo", exact=True)
    for _ in range(len(desk.session.versions)):
        undo.click()
    desk.until(lambda: desk.session.simulation.capture().scene is first, "all is undone")
    desk.until(lambda: not undo.is_enabled(), "there is nothing left to undo")
    for _ in range(len(desk.session.versions)):
        page.keyboard.press("Control+y")
    desk.until(lambda: desk.session.simulation.capture().scene == built, "all is done again")


def test_a_joint_is_put_into_a_corner_and_turned_by_its_knob(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    # To the right, and down from there; of the corner the inner side.
    desk.tell(commands.Change(lambda moment, _: _extended(moment, 3, 60.0, 0.0)))
    desk.tell(commands.Change(lambda moment, _: _extended(moment, 12, 0.0, 60.0)))
    becomes(desk, 14, 13, 10)
    tool(desk, "Joint")
    page.mouse.move(*desk.place(12))
    page.mouse.move(*beside(desk, 12, -16.0, 12.0))
    page.mouse.click(*beside(desk, 12, -16.0, 12.0))
    becomes(desk, 14, 13, 11)
    (joint,) = desk.session.selection.joints

    def rests_at() -> float:
        return desk.session.scene.angular_springs[joint].rest_angle

    rest = rests_at()
    assert abs(rest) == pytest.approx(90.0, abs=0.1)
    # Its knob turns it, with Shift by steps; a double click takes the present angle.
    tip = desk.place(12)
    other = desk.place(13 if desk.session.scene.angular_springs[joint].b == 12 else 3)
    toward = math.atan2(other[1] - tip[1], other[0] - tip[0])
    knob = (tip[0] + 58.0 * math.cos(toward), tip[1] + 58.0 * math.sin(toward))
    mark = page.locator(".softrod-edit-knob")
    desk.until(lambda: mark.get_attribute("d"), "the page shows it")
    page.mouse.move(*knob)
    page.mouse.down()
    page.keyboard.down("Shift")
    turned = toward + 0.5
    desk.lead(knob, (tip[0] + 58.0 * math.cos(turned), tip[1] + 58.0 * math.sin(turned)), 4)
    desk.let_go()
    page.keyboard.up("Shift")
    desk.until(
        lambda: abs(math.remainder(rests_at(), 15.0)) < 1e-3 and abs(rests_at() - rest) > 20.0,
        "the joint rests at another angle",
    )
    page.mouse.dblclick(*beside(desk, 12, -16.0, 12.0))
    desk.until(lambda: rests_at() == pytest.approx(rest, abs=0.1), "it rests at the present one")


def test_the_view_stands_when_a_selection_makes_the_bar_higher(open_page: OpenPage) -> None:
    desk = paused(open_page, size=(1280, 800))
    tool(desk, "Select")
    bar = desk.page.locator(".softrod-edit-bar")
    seen, low = desk.camera(), box_of(bar)["height"]
    desk.page.keyboard.press("Control+a")
    desk.until(lambda: box_of(bar)["height"] > low + 20.0, "the bar has another row")
    desk.pause(0.3)  # in which the size of the canvas and of what covers it is looked at
    assert desk.camera().same(seen)


def _extended(moment: sim.Moment, mass: int, dx: float, dy: float) -> Edit:
    """One spring more, from a mass to a new one."""
    x, y = moment.rows[:2, mass].tolist()
    return extend(moment.scene, mass, (x + dx, y + dy), positions_of(moment))


def test_a_frame_selects_what_is_moved_pinned_and_cut_off(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    tool(desk, "Select")
    drag(desk, beside(desk, 6, -40.0, -9.0), beside(desk, 9, 40.0, 9.0))
    desk.until(lambda: desk.session.selection.masses == {6, 7, 8, 9}, "they are selected", limit=5.0)
    count = page.locator(COUNT).first
    desk.until(lambda: count.inner_text() == "9 parts", "the bar says how many")
    before = desk.simulation.positions
    page.keyboard.down("Alt")  # off the grid
    drag(desk, desk.place(8), beside(desk, 8, 31.0, 17.0))
    page.keyboard.up("Alt")
    # The first time it is asked what rests.
    page.get_by_role("button", name="Take the new lengths").click()
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "they are moved")
    moved = desk.simulation.positions - before
    assert np.flatnonzero(moved.any(1)).tolist() == [6, 7, 8, 9]
    np.testing.assert_allclose(moved[6:10], np.tile(moved[6], (4, 1)), atol=1e-6)
    assert np.hypot(*moved[6]) > 20.0
    action(desk, "Pin")
    desk.until(lambda: {a.mass for a in desk.session.scene.anchors} >= {6, 7, 8, 9}, "they are pinned")
    page.mouse.click(*beside(desk, 4, -60.0, 0.0))
    desk.until(lambda: not any(desk.session.selection), "a click beside all of it leaves nothing selected")
    tool(desk, "Cut")
    middle = (np.array(desk.place(2)) + desk.place(3)) / 2.0
    drag(desk, (middle[0] - 30.0, middle[1] - 5.0), (middle[0] + 30.0, middle[1] + 5.0))
    becomes(desk, 12, 10, 8)


def test_what_is_selected_has_a_folder_and_a_force_on_it_is_drawn(open_page: OpenPage) -> None:
    """`tests/app/test_selection_panel.py` has its numbers and buttons."""
    desk = open_page()
    desk.tell(commands.Play(False))
    arrows = desk.page.locator(".softrod-loads .softrod-forces")
    folder = desk.page.get_by_text("1 mass", exact=True).and_(desk.page.locator(":visible"))
    desk.tell(commands.Select(lambda *_: Selection(masses=frozenset({4}))))
    folder.first.wait_for()
    for label, text in (("Start x", "320"), ("Force y", "500")):
        desk.control(label).fill(text)
        desk.control(label).press("Enter")
    desk.until(lambda: desk.session.scene.masses[4].force == (0.0, 500.0), "the mass has a force")
    desk.until(lambda: abs(desk.simulation.positions[4, 0] - 320.0) < 1e-6, "and is elsewhere")
    arrows.wait_for(state="attached")
    desk.until(lambda: (arrows.bounding_box() or {"height": 0.0})["height"] > 30.0, "its arrow is drawn")

    def begins_at_its_mass() -> bool:
        box, (x, y) = arrows.bounding_box(), desk.place(4)
        return box is not None and abs(box["x"] + box["width"] / 2.0 - x) < 3.0 and abs(box["y"] - y) < 4.0

    desk.until(begins_at_its_mass, "it begins at the mass and points down")
    desk.tell(commands.Undo())
    desk.until(lambda: arrows.count() == 0, "without a force there is no arrow")
    desk.tell(commands.Select(lambda *_: Selection()))
    desk.until(lambda: folder.count() == 0, "nothing is selected any more")


def test_by_touch(open_page: OpenPage) -> None:
    """Fingers build, a long press selects, and two fingers move the view instead."""
    desk = open_page(size=(390, 844), phone=True, pixels=NIGHT)
    desk.tell(commands.Play(False))
    touch = desk.context.new_cdp_session(desk.page)

    def send(kind: str, *places: Point) -> None:
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def stroke(start: Point, end: Point) -> None:
        send("touchStart", start)
        for part in np.linspace(0.2, 1.0, 5):
            send("touchMove", (start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])))
        send("touchEnd")

    tool(desk, "Build")
    stroke(desk.place(11), beside(desk, 11, 60.0, 0.0))
    becomes(desk, 13, 12, 10)
    # The chain goes on with a tap.
    send("touchStart", beside(desk, 12, 0.0, -50.0))
    send("touchEnd")
    becomes(desk, 14, 13, 10)
    # A finger that rests selects what is under it.
    send("touchStart", desk.place(13))
    desk.until(lambda: desk.session.selection == Selection(masses=frozenset({13})), "it is selected")
    desk.until(lambda: desk.page.locator(COUNT).first.inner_text() == "1 mass", "the bar says so")
    desk.pause(0.7)
    send("touchEnd")
    assert counts(desk) == (14, 13, 10)
    # Two fingers are for the view.
    before = desk.camera().distance
    one, two = beside(desk, 5, 60.0, 0.0), beside(desk, 5, 90.0, 0.0)
    send("touchStart", one)
    send("touchStart", one, two)
    for i in range(1, 9):
        send("touchMove", (one[0] - 5.0 * i, one[1]), (two[0] + 5.0 * i, two[1]))
        desk.rest(1)
    send("touchEnd")
    desk.until(lambda: desk.camera().distance < before * 0.97, "the view is nearer")
    assert counts(desk) == (14, 13, 10)
    tool(desk, "Cut")
    middle = (np.array(desk.place(12)) + desk.place(13)) / 2.0
    stroke((middle[0] - 25.0, middle[1]), (middle[0] + 25.0, middle[1] + 3.0))
    becomes(desk, 14, 12, 10)


def test_by_keys_alone(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page, keys = desk.page, desk.page.keyboard

    def focus_body() -> None:
        for _ in range(40):
            if page.evaluate("document.activeElement?.classList.contains('softrod-body') ?? false"):
                return
            keys.press("Tab")
        raise AssertionError("the Tab key does not reach the body")

    keys.press("e")
    keys.press("b")
    focus_body()
    keys.press("ArrowLeft")  # from mass 0 to the last
    keys.press("+")
    becomes(desk, 13, 12, 10)
    keys.press("ArrowLeft")
    keys.press("ArrowLeft")
    keys.press("ArrowRight")
    keys.press("ArrowRight")
    # A spring from one to another: Enter, choose, Enter.
    keys.press("Escape")
    keys.press("Enter")
    for _ in range(4):
        keys.press("ArrowLeft")
    keys.press("Enter")
    desk.until(lambda: counts(desk)[1] == 13, "two masses are joined")
    spring = desk.session.scene.linear_springs[12]
    assert abs(spring.a - spring.b) == 4
    keys.press("Escape")
    keys.press("Escape")
    # Joints at its corners, a pin, and moves on the grid.
    joints = counts(desk)[2]
    keys.press("k")
    keys.press("Enter")
    desk.until(lambda: counts(desk)[2] > joints, "the corners are held")
    anchors = len(desk.session.scene.anchors)
    keys.press("p")
    desk.until(lambda: len(desk.session.scene.anchors) == anchors + 1, "it is pinned")
    held = {a.mass for a in desk.session.scene.anchors}
    mass = max(held)
    before = desk.simulation.positions
    keys.press("Alt+ArrowRight")
    page.get_by_role("button", name="Keep the rest lengths").press("Enter")
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "it is moved")
    focus_body()
    moved = desk.simulation.positions - before
    assert moved[mass, 0] > 0.0
    assert np.count_nonzero(moved) == 1
    keys.press("Control+z")
    desk.until(lambda: np.array_equal(desk.simulation.positions, before), "it is back")
    masses = counts(desk)[0]
    focus_body()
    keys.press("Delete")
    desk.until(lambda: counts(desk)[0] == masses - 1, "it is gone")
    keys.press("Control+z")
    desk.until(lambda: counts(desk)[0] == masses, "it is back again")
    keys.press("Control+a")
    desk.until(lambda: len(desk.session.selection.masses) == masses, "all is selected")
    live = page.locator(".softrod-tell").filter(has_text="selected")
    desk.until(lambda: live.count() == 1, "a screen reader hears of it")


def test_a_body_can_be_edited_while_it_runs(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    tool(desk, "Select")
    desk.until(lambda: desk.uncovered(desk.place(11)), "the view makes room for the tools")

    def selected() -> bool:
        place = desk.place(11)  # it moves, also below the buttons
        if not desk.uncovered(place):
            return False
        desk.page.mouse.click(*place)
        desk.rest(3)
        return desk.session.selection.masses == {11}

    desk.until(selected, "the last mass is selected")
    time = desk.simulation.time
    desk.page.keyboard.press("Delete")
    becomes(desk, 11, 10, 9)
    desk.page.keyboard.press("Control+z")
    becomes(desk, 12, 11, 10)
    desk.until(lambda: desk.simulation.time > time + 0.2, "the run goes on")
    assert not desk.notices()
    # What is too soft to keep its shape is offered the stiffness for it.
    desk.open_scene("rod")
    desk.tell(commands.Play(False), commands.Reset(), commands.SetValue("angular_stiffness", 1.0))
    offer = desk.page.locator(".softrod-edit-bar").get_by_text("times as stiff")
    assert not offer.is_visible()
    action(desk, "Keep this shape")
    desk.until(offer.is_visible, "it is offered")
    said = offer.inner_text()
    desk.until(lambda: [said in text for _, text in desk.notices()] == [True], "a notice says it, too")
    offer.click()
    desk.until(lambda: desk.session.scene.angular_springs[0].stiffness > 1.0, "it is stiffer")
    desk.until(lambda: not offer.is_visible() and not desk.notices(), "there is nothing more to offer")


def test_a_copy_is_pasted_into_another_page(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Select")
    desk.page.keyboard.press("Control+a")
    desk.until(lambda: len(desk.session.selection.masses) == 12, "all is selected")
    action(desk, "Copy")
    desk.until(
        lambda: desk.page.evaluate("localStorage.getItem('softrod-clipboard') !== null"), "it is copied"
    )
    desk.open("/?scene=box")
    masses, springs, joints = counts(desk)
    desk.page.keyboard.press("e")
    action(desk, "Paste")
    becomes(desk, masses + 12, springs + 11, joints + 10)


def test_a_picture_to_draw_over_stays_in_the_browser(open_page: OpenPage, tmp_path: Path) -> None:
    desk = paused(open_page)
    page = desk.page
    page.keyboard.press("e")
    image = put_picture(desk, tmp_path, 400, 200)

    def box() -> tuple[float, float, float, float]:
        return tuple(float(image.get_attribute(name) or 0.0) for name in ("x", "y", "width", "height"))  # type: ignore[return-value]

    x, y, wide, high = box()
    assert wide == pytest.approx(2.0 * high, rel=1e-3)
    # It moves by the pointer and by keys, and not the mass that is under the pointer.
    page.get_by_role("button", name="Move it").click()
    desk.made_room()
    x, y, wide, high = box()
    before = desk.simulation.positions
    drag(desk, desk.place(5), beside(desk, 5, 40.0, 30.0))
    desk.until(lambda: box()[0] == pytest.approx(x + 40.0, abs=1.0), "it is moved")
    assert box()[1] == pytest.approx(y + 30.0, abs=1.0)
    page.keyboard.press("ArrowLeft")
    desk.until(lambda: box()[0] < x + 39.0, "an arrow moves it back a little")
    np.testing.assert_array_equal(desk.simulation.positions, before)
    page.get_by_label("Size").fill("1")
    desk.until(lambda: box()[2] < 0.5 * wide, "it is smaller")
    page.get_by_label("Opacity").fill("0.8")
    desk.until(lambda: image.get_attribute("opacity") == "0.8", "it is stronger")
    # What is drawn over it is the body's, the picture is not.
    assert "image" not in files.encode_scene(desk.session.snapshot("x", with_pose=True)).decode()
    where = box()
    desk.open()
    page.keyboard.press("e")
    desk.until(lambda: image.count() == 1 and box() == pytest.approx(where, abs=0.6), "a reload keeps it")
    # A file that is no picture is said to be none.
    text = tmp_path / "notes.txt"
    text.write_text("no picture")
    page.locator(".softrod-edit-bar input[type=file]").set_input_files(text)
    page.get_by_text("notes.txt is not a picture").wait_for()
    page.get_by_role("button", name="Picture", exact=True).click()
    page.get_by_role("button", name="Take it away").click()
    desk.until(lambda: image.count() == 0, "it is gone")
