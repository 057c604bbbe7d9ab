"""What gestures of a page do to the body: edits, the selection, and what the page is told of them."""

from __future__ import annotations

import base64
import math

import msgspec
import numpy as np
import pytest

import sim
from app.features.edit.edits import Edits
from app.features.edit.messages import (
    Act,
    Copied,
    Gesture,
    Hold,
    Line,
    Marquee,
    Move,
    Place,
    Select,
    Selected,
    SetTexts,
    Stroke,
    TextsTaken,
    Turn,
    Versions,
)
from app.session import commands
from app.session.notices import Notice
from app.stage.sketch import Mapping
from app.ui.view import picture_of
from app.wire.messages import Key, read
from app.words import say, speaking
from sim.edit import build
from sim.edit.edit import Selection
from tests.app.letters import Letters
from tests.app.pages import SessionPage


class Page(SessionPage):
    """A session whose body is edited; it stands unless it is told to run."""

    def __init__(self, scene: sim.Scene) -> None:
        super().__init__(scene)
        self.notices: list[Notice] = []
        self.letters = Letters()
        self.edits = Edits(self.session, self.letters, self.notices.append)
        self.frames(2, commands.Play(False))

    def do(self, *gestures: Gesture | commands.Command) -> sim.Scene:
        """Do them one after the other; the scene as it is then."""
        for gesture in gestures:
            if isinstance(gesture, Gesture):
                self.edits.do(gesture)
            else:
                self.session.post(gesture)
            self.frames(1)
        self.edits.tell()
        return self.session.simulation.capture().scene

    def world(self, x: float, y: float) -> tuple[float, float]:
        """A point of the scene in the page's world."""
        mapping = Mapping.of(self.session.scene)
        wx, wy, _ = mapping.to_world(np.array([[x, y]]))[0]
        return float(wx), float(wy)

    def of_mass(self, mass: int, dx: float = 0.0, dy: float = 0.0) -> tuple[float, float]:
        x, y = self.session.simulation.positions[mass]
        return self.world(x + dx, y + dy)


def square(pinned: bool = False) -> sim.Scene:
    """Four masses around a hundred px, joined, in a frame in which y grows downwards."""
    corners = ((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0))
    return sim.Scene(
        name="square",
        masses=tuple(sim.Mass(position=at) for at in corners),
        linear_springs=tuple(
            sim.LinearSpring(a=i, b=(i + 1) % 4, stiffness=1000.0, damping=3.0, rest_length=100.0)
            for i in range(4)
        ),
        anchors=(sim.Anchor(mass=0),) if pinned else (),
        gravity=(0.0, 0.0),
        arrow_keys=sim.ArrowKeys(),
    )


@pytest.fixture
def page() -> Page:
    return Page(square())


def test_a_click_puts_down_a_mass_where_it_was_made(page: Page) -> None:
    scene = page.do(Place(*page.world(40.0, 30.0)))
    assert scene.masses[4].position == pytest.approx((40.0, 30.0))
    assert page.letters.last(Selected) == Selected(masses=(4,))
    assert page.letters.last(Versions) == Versions(undo="mass added", count=1)


def test_lines_join_masses_and_put_down_what_is_missing(page: Page) -> None:
    scene = page.do(Line(a=0, b=2))
    assert (scene.linear_springs[4].a, scene.linear_springs[4].b) == (0, 2)
    assert scene.linear_springs[4].rest_length == pytest.approx(math.hypot(100.0, 100.0))
    assert page.session.selection.masses == {2}
    assert page.do(Line(a=2, b=0)) is scene  # there is one already
    scene = page.do(Line(a=2, end=page.world(160.0, 100.0)))
    assert (scene.linear_springs[5].a, scene.linear_springs[5].b) == (2, 4)
    scene = page.do(Line(b=3, start=page.world(-50.0, 100.0)))
    assert {scene.linear_springs[6].a, scene.linear_springs[6].b} == {3, 5}
    scene = page.do(Line(start=page.world(300.0, 0.0), end=page.world(350.0, 0.0)))
    assert (scene.linear_springs[7].a, scene.linear_springs[7].b) == (6, 7)
    assert scene.linear_springs[7].rest_length == pytest.approx(50.0)
    assert page.session.selection.masses == {7}
    page.do(commands.Undo())
    assert len(page.session.scene.masses) == 6  # two masses and their spring are one step


def hold_keys(page: Page, *keys: Key) -> None:
    """Change all rest angles, and with "up" all rest lengths, as the arrow keys do."""
    page.frames(1, commands.Play(True))
    page.frames(20, commands.HoldKeys(frozenset(keys)))
    page.frames(1, commands.HoldKeys(frozenset()), commands.Play(False))
    assert page.simulation.rest_angle_shift != 0.0


def test_a_corner_gets_a_joint_at_its_present_angle_whatever_keys_have_added(page: Page) -> None:
    page.do(Hold(0, 1))
    hold_keys(page, "left")
    shift = page.simulation.rest_angle_shift
    present = build.angle_between(page.session.scene, 1, 2, build.positions_of(page.simulation.capture()))
    scene = page.do(Hold(1, 2))
    assert page.session.selection == Selection(joints=frozenset({1}))
    assert scene.angular_springs[0].rest_angle == pytest.approx(90.0)
    assert scene.angular_springs[1].rest_angle == pytest.approx(present - shift)
    assert page.do(Hold(1, 2)) is scene
    page.do(Hold(0, 2))
    assert "share no mass" in page.session.notices.pop().text
    page.do(Hold(0, 77))
    assert "spring 77 does not exist (0..3)" in page.session.notices.pop().text


def test_a_rest_angle_is_turned_and_the_present_one_is_taken(page: Page) -> None:
    page.do(Hold(0, 1), Turn(0, 30.0))
    assert page.session.scene.angular_springs[0].rest_angle == pytest.approx(30.0)
    page.do(Turn(0))
    assert page.session.scene.angular_springs[0].rest_angle == pytest.approx(90.0)
    page.do(Turn(0, 300.0))
    assert page.session.scene.angular_springs[0].rest_angle == pytest.approx(-60.0)
    page.do(Turn(5, 3.0))
    assert "joint 5 does not exist (0..0)" in page.session.notices.pop().text
    page.do(commands.Undo(), commands.Undo(), commands.Undo(), commands.Undo(), Turn(0))
    assert "joint 0 does not exist (there are none)" in page.session.notices.pop().text


def test_a_stroke_cuts_all_that_it_crosses_and_nothing_else(page: Page) -> None:
    scene = page.do(Stroke((page.world(50.0, -20.0), page.world(50.0, 50.0), page.world(130.0, 50.0))))
    assert [(spring.a, spring.b) for spring in scene.linear_springs] == [(2, 3), (3, 0)]
    assert page.letters.last(Versions).undo == "2 springs cut"
    assert page.do(Stroke((page.world(500.0, 0.0), page.world(500.0, 9.0)))) is scene


def test_clicks_and_frames_select(page: Page) -> None:
    page.do(Select(masses=(1,)))
    page.do(Select(springs=(2,), toggle=True))
    assert page.session.selection == Selection(frozenset({1}), frozenset({2}))
    page.do(Select(masses=(1,), toggle=True))
    assert page.session.selection == Selection(springs=frozenset({2}))
    (x0, y0), (x1, y1) = page.world(-9.0, -9.0), page.world(109.0, 9.0)
    page.do(Marquee((x0, x1), (y0, y1)))
    assert page.session.selection == Selection(frozenset({0, 1}), frozenset({0}))
    (x0, y0), (x1, y1) = page.world(91.0, 109.0), page.world(109.0, 91.0)
    page.do(Marquee((x0, x1), (y0, y1), add=True))
    assert page.session.selection == Selection(frozenset({0, 1, 2}), frozenset({0}))
    page.do(Hold(0, 1), Act("all"))
    assert page.session.selection == Selection(frozenset(range(4)), frozenset(range(4)), frozenset({0}))
    page.do(Select())
    assert not any(page.session.selection)
    assert len(page.session.versions) == 1  # selecting is nothing to undo
    page.do(Select(masses=(999,)))
    assert not any(page.session.selection)


def test_what_is_selected_is_moved_and_rests_if_that_is_wanted(page: Page) -> None:
    dx, dy = np.subtract(page.world(0.0, 40.0), page.world(0.0, 0.0)).tolist()
    page.do(Hold(1, 2), Select(springs=(2,)))  # with its masses 2 and 3
    scene = page.do(Move(dx, dy))
    assert scene.masses[2].position == pytest.approx((100.0, 140.0))
    assert scene.linear_springs[1].rest_length == 100.0
    np.testing.assert_allclose(page.simulation.positions[3], (0.0, 140.0), atol=1e-6)
    scene = page.do(commands.Undo(), Move(dx, dy, rest=True))
    assert scene.linear_springs[1].rest_length == pytest.approx(140.0)
    assert scene.linear_springs[2].rest_length == pytest.approx(100.0)
    page.do(commands.Undo())
    np.testing.assert_allclose(page.simulation.positions[3], (0.0, 100.0), atol=1e-6)
    page.do(Select(), Move(dx, dy))
    assert "nothing is selected" in page.session.notices.pop().text
    page.do(Move(dx, dy, under=0))
    np.testing.assert_allclose(page.simulation.positions[0], (0.0, 40.0), atol=1e-6)


def test_moves_by_keys_are_one_step(page: Page) -> None:
    page.do(*[Move(0.1, 0.0, under=1, keys=True)] * 5)
    assert len(page.session.versions) == 1
    page.do(Move(0.1, 0.0, under=1))
    assert len(page.session.versions) == 2


def test_the_joint_of_a_moved_corner_rests_as_it_is_under_shifted_angles(page: Page) -> None:
    page.do(Hold(0, 1))
    hold_keys(page, "left")
    page.do(Move(0.5, 0.3, under=2, rest=True), Act("rest"))
    loads = page.simulation.loads
    assert np.abs(loads.torques).max() < 1e-6  # nothing pulls
    assert page.simulation.rest_angle_shift != 0.0


def test_actions_need_no_place(page: Page) -> None:
    assert {a.mass for a in page.do(Act("pin", mass=1)).anchors} == {1}
    assert {a.mass for a in page.do(Select(masses=(1, 2)), Act("pin")).anchors} == {1, 2}
    assert not page.do(Act("pin")).anchors
    scene = page.do(Act("duplicate"))
    assert len(scene.masses) == 6
    assert len(scene.linear_springs) == 5
    assert page.session.selection.masses == {4, 5}
    assert page.session.versions.undoable == "2 masses duplicated"
    page.do(commands.Undo(), Act("duplicate", mass=1))
    assert page.session.versions.undoable == "1 mass duplicated"
    page.do(commands.Undo(), commands.Redo(), commands.Undo(), Select(masses=(1, 2)), Act("duplicate"))
    scene = page.do(Act("remove"))
    assert len(scene.masses) == 4
    scene = page.do(Act("corners"))  # nothing is selected: everywhere
    assert len(scene.angular_springs) == 4
    page.do(Act("corners"))
    assert "no corner without" in page.session.notices.pop().text
    assert len(page.do(Act("triangulate")).linear_springs) == 5
    page.do(Act("triangulate"))
    assert "nothing left to brace" in page.session.notices.pop().text
    page.do(Act("remove"))
    assert page.session.notices.pop().text == "nothing is selected"
    page.do(Act("remove", mass=3))
    assert len(page.session.scene.masses) == 3


def test_what_is_under_the_pointer_is_meant_where_nothing_is_selected(page: Page) -> None:
    assert {a.mass for a in page.do(Act("pin", under=3)).anchors} == {3}
    assert {a.mass for a in page.do(Select(masses=(1,)), Act("pin", under=2)).anchors} == {1, 3}
    assert {a.mass for a in page.do(Act("pin", mass=2)).anchors} == {1, 2, 3}
    dx = page.world(10.0, 0.0)[0] - page.world(0.0, 0.0)[0]
    page.do(Move(dx, 0.0, under=2))
    np.testing.assert_allclose(page.simulation.positions[1:3, 0], (110.0, 100.0))


def pasted(page: Page, text: str, x: float = 0.0, y: float = 0.0) -> None:
    page.edits.paste(f"{x:.6f},{y:.6f},{base64.b64encode(text.encode()).decode()}")
    page.frames(1)


def test_what_is_copied_is_pasted_into_another_page(page: Page) -> None:
    page.do(Select(masses=(1, 2)), Act("copy"))
    text = page.letters.last(Copied).text
    assert text.startswith('{"type":"softrod-fragment"')  # by which the script knows it
    other = Page(sim.load_scene("tutorial-3.3"))
    n = len(other.session.scene.masses)
    pasted(other, text, 0.2, 0.1)
    assert len(other.session.scene.masses) == n + 2
    assert other.session.selection.masses == {n, n + 1}
    middle = Mapping.of(other.session.scene).to_scene(0.2, 0.1)
    assert other.simulation.positions[n:].mean(0) == pytest.approx(middle)
    page.do(Select(), Act("copy"))
    assert "nothing is selected" in page.notices.pop().text


@pytest.mark.parametrize("text", ["", "{}", "hello", '{"type":"softrod-fragment","masses":[]}', "[" * 5000])
def test_what_is_no_fragment_is_refused_in_one_sentence(page: Page, text: str) -> None:
    before = page.simulation.capture().scene
    pasted(page, text)
    assert page.simulation.capture().scene is before
    if text:
        (notice,) = page.notices
        assert notice.title == "That cannot be pasted"
        assert len(notice.text.splitlines()) == 1
    page.edits.paste("0,0,*")
    page.edits.paste("1e9,0,e30=")
    assert len(page.notices) == bool(text)


FORGED = (
    '{"do":"place","x":1e9,"y":0}',
    '{"do":"place","x":NaN,"y":0}',
    '{"do":"place","x":"1","y":0}',
    '{"do":"line","a":-1,"b":0}',
    '{"do":"line","a":1.5,"b":0}',
    '{"do":"hold","a":1}',
    '{"do":"stroke","points":[[0,0]]}',
    '{"do":"stroke","points":' + str([[0, 0]] * 65) + "}",
    '{"do":"select","masses":' + str(list(range(101))) + "}",
    '{"do":"turn","joint":0,"angle":1e5}',
    '{"do":"do","what":"explode"}',
    '{"do":"move","x":0,"y":0,"rest":1}',
    '{"do":"gesture"}',
    '{"do":"setTexts","name":"' + "a" * 201 + '","description":""}',
    '{"do":"setTexts","name":"a","description":"' + "b" * 8001 + '"}',
    '{"do":"setTexts","name":"a"}',
    '{"do":"setTexts","name":1,"description":""}',
)


@pytest.mark.parametrize("text", FORGED)
def test_forged_gestures_are_no_gestures(text: str) -> None:
    assert read(text) is None


@pytest.mark.parametrize(
    "gesture",
    [
        Line(a=999_999, b=0),
        Line(a=0, b=999_999),
        Line(a=0, b=0),
        Line(a=999_999, end=(0.0, 0.0)),
        Line(a=0, end=(1e7, 0.0)),
        Place(1e7, 1e7),
        Move(1e7, 0.0, under=0),
        Move(0.0, 0.0, under=999_999),
        Act("remove", mass=999_999),
        Act("pin", mass=999_999),
        Act("duplicate", mass=999_999),
        Turn(999_999),
        Stroke(((0.0, 0.0), (1e7, 1e7))),
    ],
)
def test_what_cannot_be_done_leaves_all_as_it_was(page: Page, gesture: Gesture) -> None:
    decoded = read(msgspec.json.encode(gesture).decode())
    assert decoded == gesture
    before = page.simulation.capture().scene
    scene = page.do(gesture)
    assert scene is before
    for notice in page.session.notices:
        assert len(notice.text.splitlines()) == 1
        assert "Error" not in notice.text
    page.frames(5, commands.Play(True))
    assert np.isfinite(page.simulation.positions).all()


def test_what_is_told_is_told_once(page: Page) -> None:
    page.do(Place(0.1, 0.1))
    count = len(page.letters.sent)
    page.frames(3, commands.Play(True))
    page.edits.tell()
    assert len(page.letters.sent) == count


def test_what_is_added_after_the_arrow_keys_is_at_rest(page: Page) -> None:
    hold_keys(page, "up", "left")
    assert page.simulation.rest_length_scale > 1.2
    page.do(Act("rest"), Line(a=0, b=2), Line(a=2, end=page.of_mass(2, 40.0, 10.0)), Select(), Act("corners"))
    page.do(Line(a=1, end=page.of_mass(1, 30.0, -30.0)), Select(), Act("triangulate"))
    page.do(Move(0.1, 0.1, under=3, rest=True))
    loads = page.simulation.loads
    assert len(page.session.scene.linear_springs) > 7
    assert np.abs(loads.torques).max() < 1e-6
    moment = page.simulation.capture()
    at = moment.positions
    for spring in moment.scene.linear_springs:
        present = math.dist(at[spring.a], at[spring.b])
        assert spring.rest_length * moment.rest_length_scale == pytest.approx(present)


def test_name_and_description_are_edits_like_others(page: Page) -> None:
    before = page.session.scene
    page.edits.do(SetTexts("A & <b>b</b>", "Two\nlines."))
    page.frames(1)
    assert page.letters.last(TextsTaken) == TextsTaken(refused="")
    scene = page.session.scene
    assert (scene.name, scene.title, scene.description) == ("A & -b-b-b", "", "Two\nlines.")
    assert page.do(commands.Undo()) is before
    assert page.do(commands.Redo()) == scene
    page.edits.do(SetTexts("", "Lost?"))
    page.frames(1)
    assert page.letters.last(TextsTaken).refused == "Name: it must not be empty."
    assert page.session.scene is scene
    assert not page.session.notices


def test_a_body_that_was_built_from_a_preset_has_none_of_its_texts() -> None:
    page = Page(sim.load_scene("empty"))
    scene = page.do(Place(0.1, 0.1))
    assert (scene.name, scene.title, scene.description) == ("my scene", "", "")
    with speaking("es"):
        page.edits.do(SetTexts("mi escena", ""))  # as the form has it
        page.frames(1)
        assert page.session.scene is scene
    # The preset is back with its parts.
    assert page.do(commands.Undo()).title == "Start from nothing"


def test_long_texts_are_read() -> None:
    good = {"do": "setTexts", "name": "a" * 200, "description": '"\n' * 4000}
    assert read(msgspec.json.encode(good).decode()) == SetTexts(good["name"], good["description"])


def test_a_body_keeps_its_shape_in_one_step_of_undo() -> None:
    page = Page(sim.load_scene("rod"))
    before = page.simulation.positions.copy()
    scene = page.do(Act("keep"))
    assert page.session.versions.undoable == "keep this shape"
    page.frames(60, commands.Play(True))
    assert np.abs(page.simulation.positions - before).max() < 2e-3  # of a tolerance of 0.1
    assert page.do(commands.Play(False), commands.Undo()).linear_springs != scene.linear_springs


def test_in_motion_it_stops_where_it_is_and_starts_there() -> None:
    page = Page(sim.load_scene("rod"))
    page.frames(20, commands.Play(True))
    page.frames(1, commands.Play(False))
    there = page.simulation.positions.copy()
    page.do(Act("keep"))
    assert np.abs(page.simulation.velocities).max() == 0.0
    page.frames(60, commands.Play(True))
    assert np.abs(page.simulation.positions - there).max() < 2e-3  # of a tolerance of 0.1
    page.frames(1, commands.Play(False), commands.Reset())
    assert np.abs(page.simulation.positions - there).max() < 1e-9


def test_a_shape_that_cannot_be_kept_is_refused_with_the_motion_and_an_offer() -> None:
    masses = tuple(sim.Mass(position=(100.0 * i, 0.0)) for i in range(3))
    springs = tuple(sim.LinearSpring(a=i, b=i + 1, stiffness=1e4, rest_length=100.0) for i in range(2))
    arm = sim.Scene(
        name="arm",
        masses=masses,
        linear_springs=springs,
        angular_springs=(sim.AngularSpring(a=0, b=1, stiffness=5.0),),
        anchors=(sim.Anchor(mass=0), sim.Anchor(mass=1)),
        gravity=(0.0, 1000.0),
    )
    page = Page(arm)
    page.do(Act("keep"))
    said = page.session.notices.pop().text
    assert said.startswith("Joint 0 would need 2.31 times its stiffness. The button")
    assert page.letters.last(Versions).stiffen == pytest.approx(2.309, abs=1e-3)
    assert picture_of(page.session).ghost is None
    scene = page.do(Act("stiffen"))
    assert scene.angular_springs[0].stiffness == pytest.approx(5.0 * 4.0 / math.sqrt(3.0))
    assert page.letters.last(Versions).stiffen == 0.0
    # Without the joint it turns; the way that it goes is drawn until something else is done.
    page.do(commands.Undo(), Select(joints=(0,)), Act("remove"), Act("keep"))
    said = page.session.notices.pop().text
    assert said.startswith("Nothing keeps")
    assert said.endswith("The line shows where it goes.")
    shown = picture_of(page.session).ghost
    assert shown is not None
    assert shown[2, 1] != 0.0
    assert shown[:2].tolist() == [[0.0, 0.0], [100.0, 0.0]]
    # The line stays where it is, while the body leaves the shape.
    page.frames(5, commands.Play(True))
    page.frames(1, commands.Play(False))
    assert page.simulation.positions[2, 1] > 1.0
    still = picture_of(page.session).ghost
    assert still is not None
    assert np.array_equal(still, shown)
    page.do(Act("pin", mass=2))
    assert picture_of(page.session).ghost is None
    # So it is for another body, or for this one as it was with other masses.
    for after in (commands.Open(sim.load_scene("ring")), commands.Undo()):
        page.frames(1, commands.Open(arm), commands.Play(False))
        page.do(Place(0.0, 0.0), Select(joints=(0,)), Act("remove"), Act("keep"))
        assert picture_of(page.session).ghost is not None
        page.frames(1, after)
        assert picture_of(page.session).ghost is None
        page.session.notices.clear()


def test_who_draws_a_body_and_lets_it_go_is_told_once_what_keeps_it() -> None:
    page = Page(sim.load_scene("empty"))
    page.do(Place(0.1, 0.1), Line(a=0, end=(0.3, 0.1), start=(0.0, 0.0)))
    assert not page.notices
    for _ in range(2):
        page.do(commands.Play(True))
        page.do(commands.Play(False), commands.Reset())
    assert [notice.text for notice in page.notices] == [say("edit-sags.text")]
