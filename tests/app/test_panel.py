"""The panel without a browser: which controls a scene has, what they set, and what they show."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

import sim
from app.features.solver.panel import REFERENCE_LABEL
from app.session import commands
from app.session.ghost import REFERENCE
from app.session.notices import Notice
from app.viser_inside import element_id
from app.wire.from_page import Perform
from app.wire.to_page import ControlLook, PageState
from app.words import say
from sim.edit.edit import Selection
from sim.edit.values import number, set_number
from sim.settings import setting_of
from tests.app.whole import WholePage
from tests.app.worlds import GUSTS, balloon

ALL = [
    "Curl of every joint", "Bending stiffness", "Stretching stiffness", "Stretching damping",
    "Bending damping", "Rest length", "Gravity", "Air friction", "Number of masses",
]  # fmt: skip
ALL_KEYS = ("left", "right", "up", "down")
TOUCHING = ["Friction of walls", "Bounciness of walls"]


@pytest.mark.parametrize(
    ("scene", "sliders", "lists", "pad"),
    [
        ("tutorial-3.3", ALL, ["Air brakes"], True),
        # Its angle comes from a template.
        ("tutorial-3.2", ALL[1:], ["Air brakes", "Angle template"], False),
        ("tutorial-3.1", [], [], False),
        # It was drawn by hand.
        ("ring", ALL[:-1], ["Air brakes"], True),
        (
            balloon(wind=GUSTS, air_friction=0.01),
            ["Wind speed", "Gas pressure", "Stretching stiffness", "Stretching damping", "Rest length",
             "Gravity", "Air friction", "Wind direction", "Turbulence", *TOUCHING],
            ["Air brakes", "Bounces", "Friction at rest"], False,
        ),
    ],
    ids=["tutorial-3.3", "tutorial-3.2", "tutorial-3.1", "ring", "balloon"],
)  # fmt: skip
def test_only_controls_that_the_scene_can_use_are_there(
    scene: str | sim.Scene, sliders: list[str], lists: list[str], pad: bool
) -> None:
    page = WholePage("rod")
    page.shown(commands.Open(sim.load_scene(scene) if isinstance(scene, str) else scene))
    assert sorted(page.gui.labels("slider", tab="Play")) == sorted(sliders)
    assert sorted(page.gui.labels("dropdown", tab="Play")) == sorted(lists)
    assert ("Every mass of this scene is held." in page.gui.text()) == (not sliders)
    assert page.client.mail.last(PageState).arrows == (ALL_KEYS if pad else ())


def test_the_pad_has_the_keys_that_drive_something() -> None:
    page = WholePage("rod")
    for name, keys in (("buggy", ("left", "right")), ("crane", ("up", "down")), ("pile", ())):
        page.shown(commands.Open(sim.load_scene(name)))
        assert page.client.mail.last(PageState).arrows == keys


def test_the_law_of_the_air_is_chosen_where_there_is_air() -> None:
    page = WholePage("rod")
    page.enter("Air friction", 0.0)
    slider: Any = page.gui["Air friction"]
    assert "Air brakes" not in page.gui.labels("dropdown", tab="Play")
    page.enter("Air friction", 0.004)
    assert page.gui["Air friction"] is slider  # which may be just moving
    assert page.gui["Air brakes"].value == "alike in all directions"
    page.enter("Air brakes", "in proportion to speed")
    assert (page.scene.air_law, page.scene.air_friction) == ("linear", 4.0)
    assert page.gui["Air friction"].value == 4.0
    told = [one for one in page.client.mail.sent if isinstance(one, ControlLook)]
    slider = page.gui["Air friction"]
    *_, look = (look for look in told if look.id == element_id(slider))
    assert (look.unit, look.own) == ("kg/s", None)
    page.shown(Perform("undo"))
    assert (page.scene.air_law, page.scene.air_friction) == ("isotropic", 0.004)
    assert page.gui["Air brakes"].value == "alike in all directions"


def test_a_slider_sets_the_solver_and_shows_what_it_has() -> None:
    page = WholePage()
    page.enter("Bending stiffness", 2500.0)
    assert {joint.stiffness for joint in page.scene.angular_springs} == {2500.0}
    assert page.gui["Bending stiffness"].value == 2500.0
    # Its box goes beyond the slider's end, up to what is allowed.
    page.enter("Gravity", -800.0)
    assert page.scene.gravity == (0.0, -800.0)
    assert page.gui["Gravity"].value == -800.0 < page.gui["Gravity"].min


def test_the_page_is_told_what_a_slider_s_box_allows_and_the_scene_s_own_value() -> None:
    page = WholePage()
    slider: Any = page.gui["Bending stiffness"]
    told = (one for one in page.client.mail.sent if isinstance(one, ControlLook))
    (look,) = (look for look in told if look.id == element_id(slider))
    of = setting_of(page.scene, "angular_stiffness")
    assert (look.unit, look.low, look.high, look.logarithmic) == (of.unit, of.low, of.high, True)
    assert look.own == of.read(page.scene)


def test_a_number_out_of_range_is_not_taken() -> None:
    """The page says why (`tests/browser/test_numbers.py`)."""
    page = WholePage()
    slider = page.gui["Stretching damping"]
    for wrong in (99_999_999_999.0, -5.0):
        slider.enter(wrong)
        page.shown()
        assert slider.value == 40.0
    assert page.scene.linear_springs[0].damping == 40.0


def test_undo_is_seen_in_sliders_and_lists() -> None:
    page = WholePage("tutorial-3.2")
    page.enter("Gravity", 700.0)
    page.enter("Angle template", "90°")
    assert page.scene.template == 90
    assert (page.simulation.rest_angles == 90.0).all()
    page.shown(commands.Undo())
    assert page.gui["Angle template"].value == f"{page.scene.template}°" != "90°"
    page.shown(commands.Undo())
    assert page.gui["Gravity"].value == page.scene.gravity[1] == 2000.0
    page.shown(commands.Redo())
    assert page.gui["Gravity"].value == 700.0


def test_a_slider_of_parts_that_differ_says_so_and_what_it_does() -> None:
    page = WholePage()
    note = "the others keep their ratio to it"
    assert note not in page.gui.text()
    stiffness = number("linear_springs", "stiffness")
    page.shown(commands.Change(lambda moment, _: set_number(moment.scene, stiffness, [3], 20.0)))
    assert "Stretching stiffness" not in page.gui
    assert note in page.gui.text()
    box = page.gui["Stretching stiffness (mixed)"]
    assert box.value == 10_000.0, "the largest"
    box.enter(20_000.0)
    page.shown()
    assert [spring.stiffness for spring in page.scene.linear_springs[2:5]] == [20_000.0, 40.0, 20_000.0]
    page.shown(commands.Undo(), commands.Undo())
    assert "Stretching stiffness" in page.gui
    assert note not in page.gui.text()


def test_the_buttons_for_the_scene_s_own_values_bring_back_body_and_solver_each() -> None:
    page = WholePage()
    mine = page.scene
    page.gui["Gravity"].enter(500.0)
    page.gui["Integrator"].enter("Runge-Kutta 4")
    page.shown()
    of_solver, of_body = (one for one in page.gui.there if one.label == "Scene's own values")
    assert of_body.is_in(page.gui["Play"])
    of_body.enter()
    page.shown()
    assert page.gui["Gravity"].value == page.scene.gravity[1] == 2000.0
    assert page.scene.integrator.method == "rk4"
    of_solver.enter()
    page.shown()
    assert page.scene == mine
    assert page.gui["Integrator"].value == "Symplectic Euler"


def test_a_method_brings_its_own_dial() -> None:
    page = WholePage()
    assert ("Time step" in page.gui, "Tolerance" in page.gui) == (True, False)
    page.enter("Integrator", "Auto")
    assert page.scene.integrator.method == "auto"
    assert ("Time step" in page.gui, "Tolerance" in page.gui) == (False, True)
    page.gui["Tolerance"].enter(0.002)
    page.enter("Force law", "Conservative")
    assert (page.scene.integrator.tolerance, page.scene.force_law) == (0.002, "conservative")


@pytest.mark.parametrize(
    ("switch", "told"),
    [("Energy", "residual: the method's error"), ("Predictability", "errors grow, last second")],
)
def test_energy_and_predictability_are_told_while_they_are_wanted(switch: str, told: str) -> None:
    page = WholePage()
    assert told not in page.gui.text()
    for on in (True, False):
        page.gui[switch].enter(on)
        page.frames(100)
        assert (told in page.gui.text()) == on
    # It is among the commands, too, and the switch shows it.
    page.shown(Perform("energy"))
    assert page.gui["Energy"].value


def test_the_ghost_is_chosen_with_its_law_and_step_and_another_scene_has_none() -> None:
    page = WholePage()
    assert ("Ghost's law" in page.gui, "Ghost's step" in page.gui) == (False, False)
    page.enter("Compare with", say(REFERENCE_LABEL))
    assert page.session.ghost is not None
    assert page.session.ghost.method == REFERENCE
    assert ("Ghost's law" in page.gui, "Ghost's step" in page.gui) == (True, False)
    page.enter("Compare with", "Symplectic Euler")
    page.enter("Ghost's step", "a quarter")
    page.enter("Ghost's law", "Angle law")
    assert (page.session.ghost.law, page.session.ghost.finer) == ("angle", 4)
    assert "Symplectic Euler, step / 4, Force law: Angle law" in page.gui.text()
    assert "largest distance" in page.gui.text()
    page.shown(commands.Open(sim.load_scene("ring")))
    assert page.session.ghost is None
    page.enter("Compare with", "Symplectic Euler")
    assert (page.session.ghost.law, page.session.ghost.finer) == ("", 1)
    assert page.gui["Ghost's law"].value == "the same"
    page.enter("Compare with", "nothing")
    assert page.session.ghost is None


def test_the_meter_tells_of_a_change_while_the_clock_stands() -> None:
    page = WholePage()
    page.shown(commands.Play(False), Perform("meter"))
    assert "of the limit" in page.hud
    assert "unstable" not in page.hud
    page.gui["Bending stiffness"].enter(1e8)
    page.shown()
    assert "unstable" in page.hud


def test_there_is_one_notice_of_a_runaway_and_none_once_it_is_over() -> None:
    page = WholePage()
    for end in (commands.Reset(), commands.BackBeforeDivergence(), commands.Open(sim.load_scene("ring"))):
        for _ in range(2):  # what can be changed while it stands is not the end of that
            page.frames(
                60,
                commands.SetValue("angular_stiffness", 1e8),
                commands.SetValue("rest_angle", 10.0),
                commands.Play(True),
            )
            assert [notice.title for notice in page.notices] == ["The body exploded"]
        page.frames(2, commands.SetValue("angular_stiffness", 1e4), end)
        assert not page.notices
        assert page.session.playing == (not isinstance(end, commands.BackBeforeDivergence))


def test_a_page_without_the_control_has_no_folder_of_what_is_selected() -> None:
    for query, there in (("", True), ("controls=play,body", False)):
        page = WholePage(query=query)
        page.shown(commands.Select(lambda *_: Selection(masses=frozenset({6}))))
        assert ("1 mass" in page.gui) == there


def test_what_is_wrong_with_a_scene_s_list_of_controls_is_said_once() -> None:
    page = WholePage()
    scene = sim.load_scene("ring")
    everything = page.gui.labels("tab")

    def with_controls(*names: str) -> commands.Open:
        return commands.Open(
            msgspec.structs.replace(scene, view=msgspec.structs.replace(scene.view, controls=names))
        )

    for names, tabs in ((("play",), []), (("files", "help"), ["Share"])):
        page.shown(with_controls(*names))
        assert page.gui.labels("tab") == tabs
    page.shown(with_controls("play", "kees"))
    assert page.gui.labels("tab") == everything
    (notice,) = page.notices
    assert notice.title == "All controls are shown"
    assert "there is no control called 'kees'" in notice.text
    page.shown(Perform("dark"))  # the panel is made anew
    assert len(page.notices) == 1


def test_a_notice_is_there_for_as_long_as_it_takes_to_read_it() -> None:
    page = WholePage("rod")
    for text in ("", 500 * "x"):
        page.tab.notify(Notice("error", "Title", text))
    page.tab.notify(Notice("error", "It exploded", "", "runaway"))
    page.session.notice_still_applies = lambda about: True
    page.frames(1)
    assert [notice.auto_close_seconds for notice in page.notices] == pytest.approx([8.3, 38.3, None])
