"""The Solver tab: methods, laws, energy, and a second body to compare with."""

from __future__ import annotations

import numpy as np

import sim
from app.page.solver.solver_panel import REFERENCE_LABEL
from app.session import commands
from app.session.ghost import REFERENCE
from tests.browser.between_frames import BetweenFrames
from tests.browser.conftest import OpenPage
from tests.browser.looks import assert_shown


def test_method_and_law_are_chosen_and_bring_their_own_dial(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.show("Solver")
    sliders = desk.page.locator("label:visible")
    assert desk.control("Integrator").input_value() == "Symplectic Euler"
    assert "Time step" in sliders.all_inner_texts()
    time = desk.simulation.time
    desk.choose("Integrator", "Auto")
    desk.until(lambda: desk.session.scene.integrator.method == "auto", "the method reaches the solver")
    desk.until(lambda: "Tolerance" in sliders.all_inner_texts(), "a tolerance is there to set")
    assert "Time step" not in sliders.all_inner_texts()
    desk.choose("Force law", "Conservative")
    desk.until(lambda: desk.session.scene.force_law == "conservative", "the law reaches the solver")
    desk.until(lambda: desk.simulation.time > time + 0.2, "the clock went on")
    desk.type_in("Tolerance", "0.002")
    desk.until(lambda: desk.session.scene.integrator.tolerance == 0.002, "so does the tolerance")
    desk.tell(commands.Play(False))
    assert_shown(desk)


def test_the_energy_is_shown_while_it_is_wanted(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.show("Solver")
    assert desk.page.get_by_text("residual: the method's error").count() == 0
    desk.control("Energy").click()
    desk.until(lambda: desk.session.follows_energy, "the energy is followed")
    row = desk.page.get_by_text("residual: the method's error")
    row.wait_for()
    desk.simulation.move(0, (420.0, 150.0))
    desk.until(lambda: desk.page.get_by_text("work of your hand").count() == 1, "the anchor did work")
    desk.control("Energy").click()
    desk.until(lambda: not desk.session.follows_energy, "the energy is followed no more")
    desk.until(lambda: row.count() == 0, "and are not shown")
    # It is among the commands, too.
    desk.control("Energy").blur()
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_placeholder("Search").fill("energy")
    desk.page.get_by_text("Energy: follow it, or stop").click()
    desk.until(lambda: desk.session.follows_energy, "the energy is followed again")
    desk.until(desk.control("Energy").is_checked, "and the switch shows it")


def test_how_fast_errors_grow_is_told_while_it_is_wanted(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.show("Solver")
    desk.control("Predictability").click()
    row = desk.page.get_by_text("errors grow, last second")
    row.wait_for()
    assert desk.page.get_by_text("a shorter time step makes them smaller.").is_visible()
    assert_shown(desk)
    desk.control("Predictability").click()
    desk.until(lambda: desk.session.foresight is None, "it is wanted no more")
    desk.until(lambda: row.count() == 0, "and is not shown")


def test_a_ghost_does_the_same_by_another_method(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3", pixels=True)
    desk.show("Solver")
    desk.choose("Compare with", REFERENCE_LABEL)
    desk.until(lambda: desk.session.ghost is not None, "there is a ghost")
    ghost = desk.session.ghost
    assert ghost is not None
    assert ghost.method == REFERENCE
    second = BetweenFrames(ghost.simulation)
    x, y = desk.simulation.positions[0].tolist()
    desk.tell(commands.DragStart(0, x, y), commands.Point(x + 120.0, y, late=True))
    desk.until(lambda: ghost.worst > 0.01, "they part")
    desk.tell(commands.DragEnd())
    # Both were led to the same place.
    desk.until(
        lambda: np.abs(second.positions[0] - desk.simulation.positions[0]).max() < 1e-9,
        "both are held in the same place",
    )
    desk.page.get_by_text("largest distance").wait_for()
    springs = len(desk.session.scene.linear_springs)
    desk.until(lambda: len(desk.instances("/body/ghost")) == springs, "the page shows its springs")
    desk.picture(save="ghost.png")
    desk.tell(commands.Play(False), commands.Reset())
    assert ghost.distance == 0.0
    desk.choose("Compare with", "Symplectic Euler")
    desk.choose("Ghost's step", "a quarter")
    finer = desk.until(
        lambda: desk.session.ghost and desk.session.ghost.finer == 4, "the ghost's step is finer"
    )
    assert finer
    desk.page.get_by_text("Symplectic Euler, step / 4").wait_for()
    desk.choose("Ghost's law", "Angle law")
    desk.page.get_by_text("Symplectic Euler, step / 4, angle law", exact=True).wait_for()
    # Another scene has no ghost, and the next one nothing of this one.
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.choose("Compare with", "Symplectic Euler")
    another = desk.until(lambda: desk.session.ghost, "there is another ghost")
    assert another is not None
    assert (another.law, another.finer) == ("", 1)
    desk.until(lambda: desk.control("Ghost's law").input_value() == "the same", "as its controls say")
    desk.choose("Compare with", "nothing")
    desk.until(lambda: desk.session.ghost is None, "the ghost is gone")
    desk.until(lambda: "/body/ghost" not in desk.tab.probe().nodes, "and its picture, too")


def test_tuning_is_told_while_it_is_wanted_and_its_buttons_can_be_undone(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    desk.show("Solver")
    page, session = desk.page, desk.session
    row = page.get_by_text("slowest elastic one")
    assert not desk.button("Critically damp").is_visible()
    desk.control("Tuning").click()
    row.wait_for(timeout=60_000.0)
    page.get_by_text("2.17 Hz, 0.46 s, damping ratio 0.027").wait_for()
    # Stable as it is: told, and nothing changes.
    stable = desk.button("Make it stable at this time step")
    stable.click()
    assert "Nothing was changed" in desk.notice("It is stable")
    assert session.versions.undoable == ""
    desk.tell(commands.Play(False))
    desk.tell(commands.SetValue("dt", 0.008))
    desk.until(lambda: session.scene.integrator.dt == 0.008, "a step that is too long")
    stable.click()
    desk.until(lambda: session.versions.undoable == "Made stable at 8 ms", "it is made stable")
    desk.until(lambda: session.stability.limit > 0.008, "and the meter says so")
    desk.tell(commands.Undo())
    desk.until(lambda: session.scene.linear_springs[3].stiffness == 10_000.0, "as it was")
    desk.tell(commands.SetValue("dt", 0.0025))
    desk.until(lambda: session.scene.integrator.dt == 0.0025, "a step that is short enough")
    damp = desk.button("Critically damp")
    color = "button => getComputedStyle(button).color"
    before = damp.evaluate(color)
    damp.hover()
    desk.until(lambda: damp.evaluate("button => button.matches(':hover')"), "the pointer is over it")
    assert damp.evaluate(color) == before
    damp.click()
    assert "as far as its time step of 2.5 ms bears" in desk.notice("Not critical yet")
    desk.until(lambda: session.versions.undoable == "Damped as far as 2.5 ms bears", "it is damped")
    desk.until(lambda: session.stability.limit > 0.0025, "and stable")
    desk.tell(commands.Undo())
    desk.tell(commands.SetChoice("method", "auto"))
    desk.until(lambda: not stable.is_visible(), "a method that needs no help")
    damp.click()
    desk.until(lambda: session.versions.undoable == "Critically damped", "it is damped")
    page.get_by_text("damping ratio 1", exact=False).first.wait_for()
    desk.tell(commands.Undo())
    desk.until(lambda: session.scene.linear_springs[3].damping == 40.0, "as it was")
    page.get_by_text("2.17 Hz, 0.46 s, damping ratio 0.027").wait_for()
    # What is typed beside the table, the body does.
    calm = desk.control("Calm after (s)")
    desk.until(lambda: calm.input_value() == "6.18", "the box has what the table tells")
    calm.fill("1.5")
    calm.press("Enter")
    desk.until(lambda: session.versions.undoable == "Calm after 1.5 s", "it is calm sooner")
    page.get_by_text("1.5 s, to a tenth").wait_for()
    desk.tell(commands.Undo())
    desk.until(lambda: calm.input_value() == "6.18", "as it was")
    desk.control("Tuning").click()
    desk.until(lambda: row.count() == 0, "nothing is told any more")
    desk.until(lambda: not damp.is_visible(), "and the buttons are gone")
