"""Pages in pseudo-English, whose words have accents and are longer: all is said by messages, and has room."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page

import sim
from app.export.clip import Clip
from app.export.live.live import live_html
from app.export.replay import replay_html
from app.export.teacher_sheet import sheet_html
from app.session.plots import OFFERED
from app.site import pages
from app.site.entries import shown
from app.site.folder import Folder
from app.words import PSEUDO, speaking
from sim.motion.quantities import COUNTED
from tests.amount import part_of
from tests.app.clips import swing
from tests.browser import seen
from tests.browser.conftest import OpenPage, Serve, Visits
from tests.browser.driver import Desk
from tests.browser.layout import TOUCHED

SIZES = tuple(TOUCHED)
QUANTITIES = "|".join(
    rf"\b{of}{'[0-9]+' if of in COUNTED else ''}\.(?:{'|'.join(offered)})\b"
    for of, offered in OFFERED.items()
)
"""A pattern of the names of quantities, which are the same in all languages."""


def faults(page: Page) -> set[tuple[str, ...]]:
    """What is plain or cut on a page as it is now; a list of names that ends in dots is neither."""
    page.wait_for_timeout(300)
    questions = (("plain", QUANTITIES), ("cut",))
    found = {(what, *one.values()) for what, *given in questions for one in seen.ask(page, what, *given)}
    return {one for one in found if not one[2].endswith("…")}


def tab(number: int) -> Callable[[Desk], None]:
    def show(desk: Desk) -> None:
        if (folded := desk.page.locator(".softrod-unfold")).is_visible():
            folded.click()
        desk.page.get_by_role("tab").nth(number).click()

    return show


def key(letter: str) -> Callable[[Desk], None]:
    return lambda desk: desk.page.keyboard.press(letter)


def menu(desk: Desk) -> None:
    hide = desk.page.locator(".softrod-panel-head > button").last
    # In a small window the panel lies over what stands at the right.
    if desk.page.evaluate("innerHeight < 380") and hide.is_visible():
        hide.click()
    desk.page.locator(".softrod-menu-lid").click()


def access(desk: Desk) -> None:
    menu(desk)
    desk.page.locator(".softrod-menu-list button").nth(-2).click()


def edit(desk: Desk) -> None:
    desk.page.locator(".softrod-edit button").first.click()
    desk.page.keyboard.press("Control+a")


STATES: dict[str, Callable[[Desk], None]] = {
    "first": lambda _: None,
    **{f"tab {number}": tab(number) for number in range(4)},
    "menu": menu,
    "access": access,
    "help": key("?"),
    "gallery": key("o"),
    "described": key("d"),
    "edit": edit,
}
"""States of a page, and what leads to each; Escape leads back."""


CASES = [(scene, size) for scene in ("heart", "lesson-hooke") for size in SIZES]


@pytest.mark.parametrize(("scene", "size"), part_of(CASES, 10))
def test_the_sandbox(open_page: OpenPage, scene: str, size: tuple[int, int]) -> None:
    desk = open_page(scene, size=size, phone=TOUCHED[size], path=f"/?lang={PSEUDO}")
    for name, lead in STATES.items():
        lead(desk)
        assert faults(desk.page) == set(), name
        desk.page.keyboard.press("Escape")


def made(name: str, folder: Path) -> Path:
    """A file in pseudo-English."""
    with speaking(PSEUDO):
        match name.split():
            case ["replay"]:
                data = replay_html(Clip(swing(sim.rope(masses=5, length=200.0))))
            case ["sheet"]:
                data = sheet_html(sim.load_scene("lesson-hooke"))
            case ["site"]:
                Folder(folder, made := pages.files(shown(["rope", "lesson-hooke"], own=False), "")).write(
                    made.items()
                )
                return folder / "index.html"
            case _:
                data = live_html(sim.Simulation(sim.load_scene(name)).capture())[0]
    (file := folder / "file.html").write_bytes(data)
    return file


@pytest.mark.parametrize("name", part_of(["buggy", "lesson-hooke", "replay", "sheet", "site"], 5))
def test_a_file(visit: Visits, tmp_path: Path, name: str) -> None:
    page = visit(made(name, tmp_path).as_uri())
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        assert faults(page) == set(), (width, height)


@pytest.mark.parametrize("path", ["check", "video"])
def test_a_page_without_a_body(visit: Visits, serve: Serve, path: str) -> None:
    page = visit(f"{serve('rope').url}/{path}?lang={PSEUDO}")
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        assert faults(page) == set(), (width, height)
