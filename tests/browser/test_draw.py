"""What is drawn: every mass where the solver has it, in every preset, with no complaint from WebGL.

The fixture that opens pages also samples, after each test, whether there were errors in the page.
"""

from __future__ import annotations

import numpy as np
import pytest

import sim
from app.session import commands
from app.stage.colors import palette
from app.stage.plan import Picture
from app.stage.sketch import Sketch
from app.ui.view import kinds_of
from tests.amount import NIGHT, part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import PRESETS, assert_shown

SHOWN = ("tutorial-3.3", "ring", "hair-tuft", "flag-pole", "box")
SOME = ("tutorial-3.3", "flag-pole")
"""With and without the tutorial's colours, narrow and wide."""


def one_of_each_kind() -> list[str]:
    """Presets that differ in the nodes that viser is asked for."""
    kinds: dict[object, str] = {}
    for name in PRESETS:
        scene = sim.load_scene(name)
        meshes = kinds_of(Sketch(scene, palette("softrod", dark=False)))
        kinds.setdefault(tuple(meshes.items()), name)
    return list(kinds.values())


def test_the_masses_are_drawn_where_the_solver_has_them(open_page: OpenPage) -> None:
    desk = open_page(pixels=True)
    desk.tell(commands.Play(False), commands.SetValue("rest_angle", 20.0), commands.DoSteps(100))
    assert_shown(desk)
    before = desk.masses()
    assert np.ptp(before[:, 0]) > 20.0  # no longer straight
    # Later the solver has them elsewhere, and so has the page.
    desk.tell(commands.Reset())
    assert_shown(desk)
    assert np.abs(desk.masses() - before).max() > 20.0
    # Where nothing is, there is paper, with the thin lines of the grid.
    x, y = (round(float(c)) for c in desk.at([(100.0, 331.0)])[0])
    patch = desk.picture()[y - 4 : y + 5, x - 4 : x + 5].reshape(-1, 3).min(1)
    assert patch.min() > 210.0
    assert np.median(patch) > 235.0


def test_every_kind_of_body_opens_and_is_drawn(open_page: OpenPage) -> None:
    """`tests/app/test_drawing.py` has where the parts of every preset are."""
    desk = open_page(pixels=True)
    desk.tell(commands.Play(False))
    for name in part_of(one_of_each_kind(), 3):
        scene = sim.load_scene(name)
        desk.tell(commands.Open(scene), commands.DoSteps(100))
        assert_shown(desk)
        # viser 1.1.1 at times draws a new node once before its buffers are ready; after that all is well.
        desk.complaints.clear()
        desk.page.evaluate("window.__softrod.render()")
        desk.rest(2)
        assert not desk.complaints
        start = Picture.at_start(scene).positions
        all_held = len(desk.simulation.anchors) == len(start)
        assert (np.abs(desk.simulation.positions - start).max() > 0.5) != all_held
        desk.chooser(desk.session.scene.title).wait_for()


@pytest.mark.parametrize("phone", [False, True], ids=["desktop", "phone"])
def test_screenshots_show_the_whole_body(open_page: OpenPage, phone: bool) -> None:
    desk = open_page(size=(390, 844) if phone else (1280, 760), phone=phone, pixels=True, smooth=NIGHT)
    desk.tell(commands.Play(False))
    bodies = part_of(SOME if phone else SHOWN, 2)
    for name in bodies:
        looks_whole(desk, name, f"{'phone' if phone else 'desktop'}-{name}")
    if not phone:
        desk.view("Dark")
        desk.until(lambda: desk.tab.probe().looks.dark, "it is dark")
        desk.show("Play")
        for name in bodies[:2]:
            looks_whole(desk, name, f"desktop-{name}-dark", dark=True)
        # So are the paper, where nothing else is, and the panel.
        x, y = (round(float(c)) for c in desk.at([(100.0, 331.0)])[0])
        picture = desk.picture()
        # Most of a column of the panel is neither letters nor an edge.
        assert picture[y, x].max() < 100.0
        assert float(np.median(picture[:, -20].max(1))) < 100.0


def looks_whole(desk: Desk, name: str, look: str, dark: bool = False) -> None:
    """Open a body, keep its picture, and look whether it is there, and nothing lies over it."""
    desk.tell(commands.Open(sim.load_scene(name)), commands.DoSteps(400))
    assert_shown(desk, dark=dark)
    desk.picture(save=f"{look}.png")
    # Neither the panel, which on a phone is a sheet over the lower half, nor the head-up display.
    places = desk.at(desk.simulation.positions).tolist()
    assert not [mass for mass, (x, y) in enumerate(places) if not desk.uncovered((x, y))], look
