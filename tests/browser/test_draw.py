"""What is drawn: every mass where the solver has it, in every preset, with no complaint from WebGL.

The fixture that opens pages also looks, after each test, whether there were errors in the page.
"""

from __future__ import annotations

import numpy as np
import pytest

from app import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import PRESETS, assert_shown

SHOWN = ("tutorial-3.3", "ring", "hair-tuft", "flag-pole", "box")


def test_the_masses_are_drawn_where_the_solver_has_them(open_page: OpenPage) -> None:
    desk = open_page()
    desk.page.keyboard.down("ArrowRight")
    desk.until(lambda: abs(desk.simulation.rest_angles[0]) > 8.0, "the rope curls")
    desk.page.keyboard.up("ArrowRight")
    desk.tell(commands.Play(False))
    assert_shown(desk)
    before = desk.masses()
    assert np.ptp(before[:, 0]) > 20.0  # no longer straight

    # Later the solver has them elsewhere, and so has the page.
    desk.tell(commands.Reset())
    assert_shown(desk)
    assert np.abs(desk.masses() - before).max() > 20.0
    # Where nothing is, there is paper.
    x, y = desk.at([(100.0, 331.0)])[0]
    assert desk.picture()[round(y), round(x)].min() > 235.0


def test_every_preset_opens_and_is_drawn(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    for name in PRESETS:
        desk.choose("Scene", name)
        desk.until(lambda name=name: desk.session.scene.name == name, f"{name} is opened")
        assert_shown(desk)
        start = desk.simulation.positions
        desk.tell(commands.DoSteps(100))
        assert_shown(desk)
        all_held = len(desk.simulation.anchors) == len(start)
        assert (np.abs(desk.simulation.positions - start).max() > 0.5) != all_held
        assert desk.control("Scene").input_value() == name


def test_webgl_has_nothing_to_complain_of(open_page: OpenPage) -> None:
    desk = open_page()
    for name in PRESETS:
        desk.choose("Scene", name)
        desk.until(lambda name=name: desk.session.scene.name == name, f"{name} is opened")
        desk.wait_drawn()
    desk.show("View")
    for control in ("Gizmos", "Dark", "Gizmos", "Dark"):
        desk.control(control).click()
        desk.rest(3)
        desk.wait_drawn()
    assert not desk.complaints, f"{len(desk.complaints)} times: {desk.complaints[0]}"


@pytest.mark.parametrize("phone", [False, True], ids=["desktop", "phone"])
def test_screenshots_show_the_whole_body(open_page: OpenPage, phone: bool) -> None:
    desk = open_page(size=(390, 844) if phone else (1280, 760), phone=phone)
    shape = "phone" if phone else "desktop"
    desk.tell(commands.Play(False))
    for name in SHOWN:
        desk.choose("Scene", name)
        desk.until(lambda name=name: desk.session.scene.name == name, f"{name} is opened")
        desk.tell(commands.DoSteps(400))
        assert_shown(desk)
        desk.picture(save=f"{shape}-{name}.png")
        # Neither the panel, which on a phone is a sheet over the lower half, nor a notice hides any of it.
        hidden = [mass for mass, place in enumerate(places(desk)) if not desk.uncovered(place)]
        assert not hidden, f"{name}: {hidden}"
    desk.show("View")
    desk.control("Dark").click()
    desk.until(lambda: desk.tab._dark, "it is dark")
    for name in SHOWN:
        desk.show("Play")
        desk.choose("Scene", name)
        desk.until(lambda name=name: desk.session.scene.name == name, f"{name} is opened")
        desk.tell(commands.DoSteps(400))
        assert_shown(desk, dark=True)
        desk.picture(save=f"{shape}-{name}-dark.png")


def places(desk: Desk) -> list[tuple[float, float]]:
    """Where on the screen all masses are."""
    return [(float(x), float(y)) for x, y in desk.at(desk.simulation.positions)]
