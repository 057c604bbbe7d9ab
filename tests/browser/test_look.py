"""How it all looks: every control in every state, and the page at five sizes, light and dark.

By night they are compared with pictures in `pictures/`, a quarter as large. After a change that is meant,
`SOFTROD_NIGHT=1 SOFTROD_PICTURES=new uv run pytest tests/browser/test_look.py` makes those anew.
"""

from __future__ import annotations

import io
import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page

from app.session import commands
from tests.amount import NIGHT
from tests.browser.conftest import OpenPage, Visits
from tests.browser.driver import ARTIFACTS
from tests.browser.look import page as look_sheet

PICTURES = Path(__file__).parent / "pictures"
NEW = os.environ.get("SOFTROD_PICTURES") == "new"
SMALLER = 4
"""By what a picture that is kept is smaller."""

LEVELS, PLACES = 20.0, 3
"""Another system's letters differ by less than so many of 255 levels in the mean of eight by eight pixels,
but in a few places."""

SIZES = {(1280, 720): False, (1920, 1080): False, (390, 844): True, (844, 390): True, (640, 360): False}
"""The sizes, CSS px, and whether a finger presses there."""


def compare(name: str, shot: bytes) -> None:
    """Compare a picture of a page with the one that is kept."""
    image = Image.open(io.BytesIO(shot)).convert("RGB").reduce(SMALLER)
    path = PICTURES / f"{name}.webp"
    if NEW:
        PICTURES.mkdir(exist_ok=True)
        image.save(path, lossless=True)
        return
    kept = Image.open(path).convert("RGB")
    if image.size != kept.size:
        ARTIFACTS.mkdir(exist_ok=True)
        image.save(ARTIFACTS / f"{name}.png")
        raise AssertionError(f"{name}: it has {image.size} px in place of {kept.size}")
    parts = (np.asarray(one.reduce(2), float) for one in (image, kept))
    differs = np.abs(np.subtract(*parts)).max(axis=2) > LEVELS
    if differs.sum() > PLACES:
        ARTIFACTS.mkdir(exist_ok=True)
        image.save(ARTIFACTS / f"{name}.png")
        first = [(int(x) * 2 * SMALLER, int(y) * 2 * SMALLER) for y, x in np.argwhere(differs)[:5]]
        raise AssertionError(f"{name}: {differs.sum()} places differ, at px {first} and others")


def sheet(visit: Visits, folder: Path, dark: bool) -> Page:
    """The sheet in a browser."""
    path = folder / "look.html"
    path.write_text(look_sheet(dark), encoding="utf-8")
    page = visit(path.as_uri(), size=(1160, 900))
    page.wait_for_selector("html[data-ready]")
    return page


@pytest.mark.parametrize("dark", (False, True))
def test_every_control_is_in_the_sheet_in_every_state(visit: Visits, tmp_path: Path, dark: bool) -> None:
    page = sheet(visit, tmp_path, dark)
    assert not page.evaluate("missing"), "kinds of controls that the sheet does not show"
    for state in ("hover", "held", "by keys", "disabled"):
        figures = page.locator("section").filter(has_text="Slider").locator("figure").filter(has_text=state)
        assert figures.count() == 1
    # A state looks different from rest.
    for section in ("Button", "Primary", "Danger", "Icon button", "List", "Number", "Text"):
        box = page.locator("section").filter(has=page.get_by_role("heading", name=section, exact=True))
        idle, *others = (
            figure.screenshot(style="figcaption { visibility: hidden }")
            for figure in box.locator("figure").all()
        )
        assert idle not in others, section
    if NIGHT:
        page.evaluate("document.fonts.ready")
        compare(f"controls-{'dark' if dark else 'light'}", page.screenshot(full_page=True))


@pytest.mark.skipif(not NIGHT, reason="pictures are compared by night")
@pytest.mark.parametrize("dark", (False, True))
@pytest.mark.parametrize("size", SIZES)
def test_the_page_looks_as_it_is_to(open_page: OpenPage, size: tuple[int, int], dark: bool) -> None:
    desk = open_page("rope", size=size, phone=SIZES[size])
    if dark:
        desk.tab.perform("dark")
        desk.until(lambda: desk.tab.probe().looks.dark, "it is dark")
    desk.tell(commands.Play(False), commands.Reset())
    desk.until(lambda: desk.simulation.time == 0.0, "it stands at the start")
    desk.page.mouse.move(size[0] / 3, 2.0)
    desk.settle()
    desk.wait_drawn()
    desk.pause(1.0)
    look = "dark" if dark else "light"
    # Words over the body stand where there was room while it moved.
    compare(
        f"page-{size[0]}x{size[1]}-{look}",
        desk.page.screenshot(style=".softrod-overlay { visibility: hidden }", scale="css"),
    )
