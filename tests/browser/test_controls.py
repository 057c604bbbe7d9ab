"""The panel, the bar of time and a click on the body: they reach the solver, and show what it has."""

from __future__ import annotations

import numpy as np
import pytest

from app.session import commands
from sim.settings import setting_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, middle_of
from tests.browser.looks import assert_shown


def value(desk: Desk, key: str) -> float:
    """A setting as the solver has it."""
    scene = desk.session.scene
    return setting_of(scene, key).read(scene)


def test_sliders_boxes_and_lists_reach_the_solver_and_each_other(open_page: OpenPage) -> None:
    """`tests/app/test_panel.py` has which there are, and what the server makes of their values."""
    desk = open_page("tutorial-3.2")
    desk.tell(commands.Play(False))
    desk.show("Play")
    desk.click_track("Bending stiffness", 0.4)
    box = desk.box("Bending stiffness")
    desk.until(
        lambda: value(desk, "angular_stiffness") == float(box.input_value()) < 9_000.0, "the box shows it"
    )
    assert value(desk, "angular_stiffness") == pytest.approx(10.0 ** (1.0 + 0.4 * 5.0), rel=0.25)
    desk.type_in("Bending stiffness", "2500")
    desk.until(lambda: value(desk, "angular_stiffness") == 2500.0, "the box reaches the solver")
    desk.until(
        lambda: abs(desk.slider_value("Bending stiffness") - np.log10(2500.0)) < 0.02, "the slider shows it"
    )
    desk.choose("Angle template", "90°")
    desk.until(lambda: desk.session.scene.template == 90, "the template reaches the solver")
    desk.type_in("Number of masses", "20")
    desk.until(lambda: len(desk.simulation.positions) == 20, "the rod has 20 masses")
    # In a pose in which no mass hides another, as they do once the rod has curled up.
    desk.tell(commands.DoSteps(45))
    assert_shown(desk)


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


def test_a_click_on_a_mass_reads_out_its_joint_beside_its_arc(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False), commands.SetValue("rest_angle", 15.0), commands.DoSteps(150))
    desk.wait_drawn()
    assert desk.readout("joint0") == "of 10"
    x, y = desk.place(6)
    desk.page.mouse.move(x, y)
    desk.rest(4)
    desk.page.mouse.click(x, y)
    desk.until(lambda: desk.readout("joint5") == "of 10", "the joint of mass 6 is read out")
    angle = desk.simulation.angles[5]
    assert desk.readout("angle") == f"{angle:+.2f}°"
    assert abs(angle - desk.simulation.angles[0]) > 0.01  # so it is not the first one's
    label = desk.page.locator(".softrod-angle")
    said = f"{angle:.1f}°".replace("-", "−")
    desk.until(lambda: label.text_content() == said, "so does the arc")
    assert said in desk.page.locator(".softrod-mass-card").inner_text()
    desk.page.keyboard.press("Escape")
    label.wait_for()
    middle = np.array(middle_of(label))
    assert np.linalg.norm(middle - (x, y)) < 90.0


def test_a_body_that_runs_away_is_stopped_explained_and_taken_back(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Play")
    # A straight rope with nothing to straighten would stand on its tip, as a pencil does.
    desk.tell(commands.SetValue("rest_angle", 10.0))
    desk.until(lambda: desk.simulation.time > 1.0, "it runs for a while")
    desk.type_in("Bending stiffness", "100000000")
    desk.until(lambda: desk.notices(), "it explodes")
    (notice,) = desk.notices()
    assert "stability limit" in notice[1]
    assert "unstable" in desk.hud() and "stopped" in desk.hud()
    # What is left of it is a good state, and is what is shown.
    positions = desk.simulation.positions
    desk.until(
        lambda: np.allclose(desk.masses(), positions, rtol=1e-5, atol=0.05), "the last good state is shown"
    )
    back = desk.button("Go back to just before it")
    back.click()
    desk.until(lambda: desk.simulation.divergence is None, "it is whole again")
    positions = desk.simulation.positions
    desk.until(lambda: np.allclose(desk.masses(), positions, rtol=1e-5, atol=0.05), "that is shown")
    desk.until(lambda: not desk.notices() and back.count() == 0, "nothing is said any more")
    read = desk.page.locator("[role=status]")
    desk.until(lambda: "exploded" not in " ".join(read.all_text_contents()), "nor read out")
