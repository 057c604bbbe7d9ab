"""The panel: controls reach the solver, show what it has, and only those of use are there."""

from __future__ import annotations

import numpy as np
import pytest

from app.page.viser import slider_box
from app.session import commands
from sim.edit.values import number, set_number
from sim.settings import setting_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import assert_shown

ALL = (
    "Linear stiffness",
    "Linear damping",
    "Angular stiffness",
    "Angular damping",
    "Rest length",
    "Rest angle",
    "Gravity",
    "Air friction",
    "Number of masses",
)
CONTROLS = {
    # Of 3.2 the angle comes from the template; a body drawn by hand has no number of masses.
    "tutorial-3.3": ALL,
    "tutorial-3.2": tuple("Angle template" if name == "Rest angle" else name for name in ALL),
    "tutorial-3.1": (),
    "ring": tuple(name for name in ALL if name != "Number of masses"),
}
PADS = {"tutorial-3.3": True, "tutorial-3.2": False, "tutorial-3.1": False, "ring": True}


def value(desk: Desk, key: str) -> float:
    """A setting as the solver has it."""
    scene = desk.session.scene
    return setting_of(scene, key).read(scene)


def test_a_slider_and_its_number_box_set_the_solver_and_each_other(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    desk.click_track("Angular stiffness", 0.4)
    desk.until(lambda: value(desk, "angular_stiffness") < 9_000.0, "the slider reaches the solver")
    stiffness = value(desk, "angular_stiffness")
    assert stiffness == pytest.approx(10.0 ** desk.slider_value("Angular stiffness"), rel=0.02)
    assert stiffness == pytest.approx(10.0 ** (1.0 + 0.4 * 5.0), rel=0.25)
    assert {joint.stiffness for joint in desk.session.scene.angular_springs} == {stiffness}
    box = desk.box("Angular stiffness")
    desk.until(lambda: float(box.input_value()) == stiffness, "the box shows what the slider set")

    desk.type_in("Angular stiffness", "2500")
    desk.until(lambda: value(desk, "angular_stiffness") == 2500.0, "the box reaches the solver")
    place = np.log10(2500.0)
    desk.until(
        lambda: abs(desk.slider_value("Angular stiffness") - place) < 0.02, "the slider shows what was typed"
    )
    # Others are as they were, and time was not started afresh.
    assert value(desk, "linear_stiffness") == 10_000.0
    assert desk.simulation.step_count > 0

    # Beyond the slider's end, up to what is allowed.
    desk.type_in("Gravity", "-800")
    desk.until(lambda: value(desk, "gravity") == -800.0, "gravity points up")
    desk.until(lambda: desk.slider_value("Gravity") == 0.0, "its slider is at its end")


def test_a_template_bends_every_joint_and_more_masses_build_another_body(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.2")
    desk.show("Play")
    desk.choose("Angle template", "90°")
    desk.until(lambda: desk.session.scene.template == 90, "the template reaches the solver")
    assert (desk.simulation.rest_angles == 90.0).all()
    # In a pose in which no mass hides another, as they do once the rod has curled up.
    desk.tell(commands.Play(False), commands.Reset(), commands.DoSteps(45))
    desk.until(lambda: desk.simulation.step_count == 45, "the rod bends")
    assert (desk.simulation.angles > 45.0).all()
    assert_shown(desk)

    desk.type_in("Number of masses", "20")
    desk.until(lambda: len(desk.simulation.positions) == 20, "the rod has 20 masses")
    assert (desk.simulation.rest_angles == 90.0).all()
    assert_shown(desk)
    desk.until(lambda: desk.box("Number of masses").input_value() == "20", "the box shows it")
    desk.click_track("Number of masses", 0.9)
    desk.until(lambda: len(desk.simulation.positions) > 45, "the rod has more masses")
    assert_shown(desk)


def test_numbers_can_be_typed_slowly(open_page: OpenPage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slider_box, "TOUCHED", 0.05)
    desk = open_page()
    desk.show("Play")
    wrong = []
    for label, key, text in (
        ("Gravity", "gravity", "-350"),
        ("Number of masses", "masses", "25"),
        ("Time step", "dt", "0.001"),
    ):
        if key == "dt":
            desk.show("Solver")
        box = desk.box(label)
        box.click()
        box.press("Control+a")
        for letter in text:
            desk.page.keyboard.press(letter)
            desk.pause(0.15)  # longer than the server leaves a control alone that its user touched
        desk.page.keyboard.press("Enter")
        desk.pause(0.5)
        if value(desk, key) != float(text) or float(desk.box(label).input_value() or "nan") != float(text):
            wrong.append(f"{label}: {text} was typed, the box has {desk.box(label).input_value()}")
    assert not wrong, wrong


def test_the_slider_of_the_number_of_masses_can_be_dragged(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    desk.control("Number of masses").scroll_into_view_if_needed()
    thumb, track = (
        desk.thumb("Number of masses").bounding_box(),
        desk.control("Number of masses").locator(".mantine-Slider-track").bounding_box(),
    )
    assert thumb is not None
    assert track is not None
    y = thumb["y"] + thumb["height"] / 2
    end = track["x"] + track["width"] + 6.0
    desk.page.mouse.move(thumb["x"] + thumb["width"] / 2, y)
    desk.page.mouse.down()
    for x in np.linspace(thumb["x"] + thumb["width"] / 2, end, 8):
        desk.page.mouse.move(float(x), y)
        desk.pause(0.1)  # the slider reports at its own pace
    desk.page.mouse.up()
    desk.until(lambda: len(desk.simulation.positions) == 60, "the slider is at its end", limit=5.0)


def test_only_controls_that_the_scene_can_use_are_there(open_page: OpenPage) -> None:
    desk = open_page()
    known = {*ALL, "Angle template"}
    for name, wanted in CONTROLS.items():
        desk.show("Play")
        if desk.session.scene.name != name:
            desk.open_scene(name)
        pad = desk.page.get_by_role("button", name="rest angle up")
        desk.until(lambda pad=pad, name=name: pad.is_visible() == PADS[name], f"the arrow pad of {name}")
        assert desk.page.get_by_text("Follow pointer", exact=True).is_visible()
        desk.show("Play")
        labels = desk.page.locator("label:visible")
        desk.until(
            lambda labels=labels, wanted=wanted: (
                sorted(text for text in labels.all_inner_texts() if text in known) == sorted(wanted)
            ),
            f"the controls of {name}",
        )
        assert desk.page.get_by_text("Every mass of this scene is held.").is_visible() == (not wanted)


def test_the_clock_runs_stands_steps_and_goes_back(open_page: OpenPage) -> None:
    desk = open_page()
    desk.button("Pause").click()
    desk.until(lambda: not desk.session.playing, "the button pauses")
    desk.button("Play").wait_for()
    steps = desk.simulation.step_count
    desk.button("1 step").click()
    desk.until(lambda: desk.simulation.step_count == steps + 1, "one step is done")
    desk.page.keyboard.press("Shift+N")
    desk.until(lambda: desk.simulation.step_count == steps + 11, "ten steps are done")
    desk.until(desk.clock_is_right, "the clock shows it")
    assert_shown(desk)
    desk.button("Reset").click()
    desk.until(lambda: desk.simulation.step_count == 0, "it is back at the start")
    assert_shown(desk)
    desk.button("Play").click()
    desk.until(lambda: desk.simulation.step_count > 40, "it runs again")
    desk.button("Pause").wait_for()

    for label, speed in (("⅛×", 0.125), ("½×", 0.5), ("4×", 4.0)):
        desk.page.get_by_label("Speed").select_option(label=label)
        desk.until(lambda speed=speed: desk.session.pacer.speed == speed, f"the speed is {speed}")


def test_a_click_on_a_mass_reads_out_its_joint(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False), commands.SetValue("rest_angle", 10.0), commands.Reset())
    desk.wait_drawn()
    assert desk.readout("joint0") == "of 10"
    desk.tell(commands.DoSteps(60))
    assert_shown(desk)
    x, y = desk.place(6)
    desk.page.mouse.move(x, y)
    desk.rest(4)
    desk.page.mouse.click(x, y)
    desk.until(lambda: desk.readout("joint5") == "of 10", "the joint of mass 6 is read out")
    angle = desk.simulation.angles[5]
    assert desk.readout("angle") == f"{angle:+.2f}°"
    assert abs(angle - desk.simulation.angles[0]) > 0.01  # so it is not the first one's


def test_the_page_can_be_dark(open_page: OpenPage) -> None:
    desk = open_page(pixels=True)
    desk.tell(commands.Play(False))
    text = "() => getComputedStyle(document.querySelector('.softrod-hud')).color"
    light = desk.page.evaluate(text)
    for dark in (True, False):
        desk.view("Dark")
        desk.until(lambda dark=dark: desk.tab.probe().looks.dark == dark, "the switch is turned")
        # A place with nothing but paper, one in the panel.
        x, y = (float(c) for c in desk.at([(100.0, 331.0)])[0])
        desk.until(
            lambda dark=dark, x=x, y=y: (
                (desk.picture()[round(y), [round(x), -20]].max(1) < 100.0) == dark
            ).all(),
            "paper and panel have the colour",
        )
        assert_shown(desk, dark=dark)
        assert (desk.page.evaluate(text) != light) == dark


def test_a_body_that_runs_away_is_stopped_and_explained(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    # A straight rope with nothing to straighten would stand on its tip, as a pencil does.
    desk.tell(commands.SetValue("rest_angle", 10.0))
    desk.until(lambda: abs(desk.simulation.angles[0]) > 0.5, "the rope bends")
    desk.type_in("Angular stiffness", "100000000")
    text = desk.notice("stability limit")
    assert "Angular stiffness".lower() in text.lower()
    assert desk.simulation.divergence is not None
    assert not desk.session.playing
    # Before it ran away, or with it, the meter said so.
    assert "unstable" in desk.hud()
    assert "stopped" in desk.hud()
    # What is left of it is a good state, and is what is shown.
    positions = desk.simulation.positions
    assert np.isfinite(positions).all()
    desk.until(
        lambda: np.allclose(desk.masses(), positions, rtol=1e-5, atol=0.05), "the last good state is shown"
    )
    # It says what to do, and that helps.
    desk.type_in("Angular stiffness", "10000")
    desk.show("Play")
    desk.button("Reset").click()
    desk.until(lambda: desk.simulation.divergence is None, "it is whole again")
    if not desk.session.playing:
        desk.button("Play").click()
    desk.until(lambda: desk.simulation.step_count > 100, "it runs again")
    desk.until(lambda: "limit" not in desk.hud(), "there is no meter far below the limit")
    assert not desk.notices()


def test_there_is_one_notice_of_a_runaway_and_none_once_it_is_over(open_page: OpenPage) -> None:
    desk = open_page()
    title = "The body exploded"
    for _ in range(2):
        desk.tell(
            commands.SetValue("angular_stiffness", 1e8),
            commands.SetValue("rest_angle", 10.0),
            commands.Play(True),
        )
        desk.until(lambda: desk.simulation.divergence is not None, "it runs away")
        desk.until(lambda: [shown for shown, _ in desk.notices()] == [title], "one notice says so")
        desk.pause(0.3)
        assert len(desk.notices()) == 1
        # What can be changed while it stands is not the end of that.
        desk.tell(commands.SetValue("angular_stiffness", 1e8), commands.Play(True))
        desk.until(lambda: desk.simulation.divergence is not None, "it runs away again")
        desk.pause(0.3)
        # The one before it takes a moment to fade.
        desk.until(lambda: len(desk.notices()) == 1, "there is still one notice")
        desk.tell(commands.SetValue("angular_stiffness", 1e4), commands.Reset())
        desk.until(lambda: not desk.notices(), "the notice is gone")
    desk.tell(commands.SetValue("angular_stiffness", 1e8), commands.Play(True))
    desk.until(lambda: desk.notices(), "it runs away once more")
    desk.show("Play")
    desk.open_scene("ring")
    desk.until(lambda: not desk.notices(), "another scene ends it")
    desk.until(lambda: desk.simulation.step_count > 40, "and plays")


def test_number_boxes_take_a_comma_and_say_what_they_do_not_take(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.show("Play")
    box = desk.box("Gravity")
    box.click()
    box.press("Control+a")
    desk.page.keyboard.type("9,81")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: value(desk, "gravity") == 9.81, "a comma is a point")
    # Too much, and too little: a word, and what is set.
    damping = desk.box("Linear damping")
    damping.fill("99999999999")
    desk.show("Play")
    desk.notice("Linear damping: 0 to ")
    desk.show("Play")
    desk.until(lambda: damping.input_value() == "40", "it shows what is set")
    desk.type_in("Angular stiffness", "-5")
    desk.notice("Angular stiffness: 0 to ")
    desk.until(lambda: desk.box("Angular stiffness").input_value() == "10000", "it shows what is set")
    assert value(desk, "angular_stiffness") == 10_000.0
    # Empty: as if it had not been touched.
    box.fill("")
    box.blur()
    desk.until(lambda: box.input_value() == "9.81", "the number comes back")
    assert value(desk, "gravity") == 9.81
    assert not desk.notices()


def test_the_play_tab_has_what_makes_most_of_a_scene(open_page: OpenPage) -> None:
    desk = open_page()
    desk.page.get_by_text("Rest angle", exact=True).wait_for()
    desk.type_in("Rest angle", "25")
    desk.until(lambda: value(desk, "rest_angle") == 25.0, "it reaches the solver")
    desk.show("Play")
    desk.until(lambda: desk.box("Rest angle").input_value() == "25", "and the other slider")
    desk.show("Play")
    desk.open_scene("tutorial-3.2")
    desk.choose("Angle template", "-45°")
    desk.until(lambda: desk.session.scene.template == -45, "a template, where there are some")


def test_a_scene_s_own_values_come_back(open_page: OpenPage) -> None:
    desk = open_page()
    mine = desk.session.scene
    desk.show("Play")
    desk.type_in("Gravity", "500")
    desk.type_in("Rest angle", "30")
    desk.until(lambda: value(desk, "rest_angle") == 30.0, "the body is changed")
    desk.show("Solver")
    desk.choose("Integrator", "Runge-Kutta 4")
    desk.until(lambda: desk.session.scene.integrator.method == "rk4", "so is the method")
    time = desk.simulation.time
    desk.show("Play")
    desk.button("Scene's own values").click()
    desk.until(lambda: value(desk, "gravity") == 2000.0, "the body is as it was opened")
    desk.until(lambda: desk.box("Gravity").input_value() == "2000", "its boxes, too")
    assert desk.session.scene.integrator.method == "rk4"
    desk.show("Solver")
    desk.button("Scene's own values").click()
    desk.until(lambda: desk.session.scene == mine, "and the solver")
    desk.until(lambda: desk.control("Integrator").input_value() == "Symplectic Euler", "its list, too")
    assert desk.simulation.time >= time


def test_the_meter_tells_of_a_change_while_the_clock_stands(open_page: OpenPage) -> None:
    desk = open_page()
    desk.view("Stability bar")
    desk.until(lambda: "limit" in desk.hud() and "unstable" not in desk.hud(), "the meter is green")
    desk.tell(commands.Play(False))
    desk.show("Play")
    desk.type_in("Angular stiffness", "100000000")
    desk.until(lambda: value(desk, "angular_stiffness") == 1e8, "the box reaches the solver")
    desk.until(lambda: "unstable" in desk.hud(), "the meter is red before it runs", limit=3.0)


def test_a_picture_that_does_not_change_is_not_sent(open_page: OpenPage) -> None:
    desk = open_page()

    def sent_in(seconds: float) -> int:
        before = desk.frames
        desk.pause(seconds)
        return desk.frames - before

    desk.until(lambda: sent_in(0.5) > 5, "what is sent is counted")
    desk.tell(commands.Play(False))
    desk.until(lambda: sent_in(1.2) == 0, "the last picture is sent, and what the browser is to keep")
    assert sent_in(1.0) == 0
    # At rest the clock goes on, but nothing moves.
    desk.tell(commands.SetValue("gravity", 0.0), commands.Reset(), commands.Play(True))
    desk.settled()
    desk.until(lambda: sent_in(1.2) == 0, "the last picture is sent")
    steps = desk.simulation.step_count
    assert sent_in(1.0) == 0
    assert desk.simulation.step_count > steps


def test_a_slider_of_parts_that_differ_says_so_and_what_it_does(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    note = desk.page.get_by_text("the others keep their ratio to it")
    desk.row("Linear stiffness").wait_for()
    assert note.count() == 0
    stiffness = number("linear_springs", "stiffness")
    desk.tell(commands.Change(lambda moment, _: set_number(moment.scene, stiffness, [3], 20.0)))
    desk.row("Linear stiffness (mixed)").wait_for()
    note.wait_for()
    assert desk.box("Linear stiffness (mixed)").input_value() == "10000", "the largest"
    desk.type_in("Linear stiffness (mixed)", "20000")
    desk.until(lambda: value(desk, "linear_stiffness") == 20_000.0, "it is set")
    springs = desk.session.scene.linear_springs
    assert [spring.stiffness for spring in springs[2:5]] == [20_000.0, pytest.approx(40.0), 20_000.0]
    desk.tell(commands.Undo(), commands.Undo())
    desk.row("Linear stiffness").wait_for()
    desk.until(lambda: note.count() == 0, "nothing is mixed any more")
