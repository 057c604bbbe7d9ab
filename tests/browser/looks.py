"""What a page looks like, against what the solver has."""

from __future__ import annotations

import numpy as np

import sim
from app.stage.colors import palette
from tests.browser.driver import Desk

PRESETS = tuple(info.name for info in sim.list_scenes() if info.built_in and not info.group)
"""Those that wait for nobody: lessons begin their own steps."""


def colors_off(desk: Desk, dark: bool = False) -> list[float]:
    """How far the colour at each mass is from what it should be, in 0..255: the nearest pixel of a few."""
    picture = desk.picture(marks=False)
    scale = int(desk.page.evaluate("devicePixelRatio"))
    scene = desk.session.scene
    colors = palette(scene.view.colors, dark)
    held = {anchor.mass for anchor in scene.anchors if not anchor.driven}
    off = []
    for mass, (x, y) in enumerate(desk.at(desk.simulation.positions) * scale):
        wanted = colors.held if mass in held else colors.mass
        column, row = round(float(x)), round(float(y))
        patch = picture[max(0, row - 2) : row + 3, max(0, column - 2) : column + 3].reshape(-1, 3)
        off.append(float(np.abs(patch - wanted).max(1).min()) if len(patch) else 255.0)
    return off


def assert_shown(desk: Desk, dark: bool = False) -> None:
    """Every mass is in the page, and on the canvas if that is drawn, where the solver has it.

    The body has to stand still.
    """
    desk.until(lambda: _is_shown(desk), "the page's masses are where the solver has them")
    # A browser with little time shows a frame some time after it was drawn.
    if desk.pixels:
        desk.until(lambda: max(colors_off(desk, dark)) < 40.0, "every mass has its colour on the canvas")


def _is_shown(desk: Desk) -> bool:
    shown, wanted = desk.masses(), desk.simulation.positions
    return shown.shape == wanted.shape and np.allclose(shown, wanted, rtol=0.0, atol=0.05)
