"""The Solver tab: methods, laws, energy, and a second body to compare with."""

from __future__ import annotations

from app.features.solver.panel import REFERENCE_LABEL
from app.words import say
from tests.browser.conftest import OpenPage


def test_what_the_solver_tab_tells_is_there_while_it_is_wanted(open_page: OpenPage) -> None:
    """`tests/app/test_panel.py` has what its lists and switches do to the session."""
    desk = open_page()
    desk.show("Solver")
    for switch, told in (
        ("Energy", "residual: the method's error"),
        ("Predictability", "errors grow, last second"),
        ("Tuning", "2.17 Hz, 0.46 s, damping ratio 0.027"),
    ):
        row = desk.page.get_by_text(told)
        assert row.count() == 0
        desk.control(switch).click()
        row.wait_for()
        desk.control(switch).click()
        desk.until(lambda row=row: row.count() == 0, f"it goes with its switch: {switch}")
    # It is among the commands, too, and the switch shows it.
    desk.control("Energy").blur()
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_placeholder("Find anything").fill("energy")
    desk.page.get_by_text("Energy: follow it, or stop").click()
    desk.until(desk.control("Energy").is_checked, "the energy is followed again")


def test_a_ghost_is_drawn_until_there_is_none(open_page: OpenPage) -> None:
    desk = open_page()
    desk.show("Solver")
    desk.choose("Compare with", say(REFERENCE_LABEL))
    desk.page.get_by_text("largest distance").wait_for()
    springs = len(desk.session.scene.linear_springs)
    desk.until(lambda: len(desk.instances("/body/ghost")) == springs, "the page shows its springs")
    desk.choose("Compare with", "nothing")
    desk.until(lambda: len(desk.instances("/body/ghost")) == 0, "and its picture goes with it")
