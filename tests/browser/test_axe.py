"""The rules of axe-core, which find what keeps people from using a page."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page

import sim
from app.export.live.live import live_html
from tests.amount import part_of
from tests.browser.conftest import OpenPage, Serve, Visits
from tests.browser.driver import Desk
from tests.page.check import NODE, NPM

AXE = "axe-core@4.14.1"
"""It is fetched from npm."""

RUN = """() => axe.run(document).then(({violations}) =>
    violations.flatMap(({id, nodes}) => nodes.map(({html}) => `${id}: ${html.slice(0, 200)}`)))"""


@pytest.fixture(scope="module")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """axe-core's script."""
    folder = tmp_path_factory.mktemp("axe")
    npm = [NODE, NPM / "npm-cli.js", "--loglevel=error", "--prefer-offline", "--no-audit"]
    subprocess.run([*npm, "install", "--prefix", folder, AXE], check=True, capture_output=True)
    return Path(folder, "node_modules", "axe-core", "axe.min.js").read_text(encoding="utf-8")


def found(page: Page, axe: str) -> list[str]:
    """What axe-core finds on a page."""
    page.evaluate(axe)
    return page.evaluate(RUN)


def gallery(desk: Desk) -> None:
    desk.page.keyboard.press("o")
    desk.page.locator("dialog[open]").wait_for()


def access(desk: Desk) -> None:
    desk.page.locator(".softrod-menu-lid").click()
    desk.page.locator(".softrod-menu-list button").nth(-2).click()
    desk.page.locator("dialog.softrod-access").wait_for()


def edit(desk: Desk) -> None:
    desk.page.locator(".softrod-edit button").first.click()
    desk.page.locator("html[data-softrod-tool=build]").wait_for()


def described(desk: Desk) -> None:
    desk.page.keyboard.press("d")
    desk.page.locator(".softrod-described").wait_for()


STATES: dict[str, tuple[str, Callable[[Desk], object]]] = {
    "play": ("rope", lambda _: None),
    "measure": ("rope", lambda desk: desk.page.get_by_role("tab").nth(1).click()),
    "solver": ("rope", lambda desk: desk.page.get_by_role("tab").nth(2).click()),
    "edit": ("rope", edit),
    "described": ("rope", described),
    "gallery": ("rope", gallery),
    "access": ("rope", access),
    "lesson": ("lesson-hooke", lambda _: None),
}
"""States of a page: its scene, and what leads to it."""

CASES = [(state, look, tag) for look in ("light", "dark") for tag in ("en", "de") for state in STATES]


@pytest.mark.parametrize(("state", "look", "tag"), part_of(CASES, 6))
def test_nothing_is_found_on_a_page(open_page: OpenPage, axe: str, state: str, look: str, tag: str) -> None:
    scene, lead = STATES[state]
    desk = open_page(scene, path=f"/?lang={tag}")
    if look == "dark":
        desk.page.locator(".softrod-menu-lid").click()
        desk.page.locator(".softrod-menu-list button").first.click()
        desk.page.locator('html[data-mantine-color-scheme="dark"]').wait_for()
    lead(desk)
    assert found(desk.page, axe) == []


@pytest.mark.parametrize("name", ["cradle", "lesson-hooke"])
def test_nothing_is_found_in_a_live_file(visit: Visits, axe: str, tmp_path: Path, name: str) -> None:
    file = tmp_path / "live.html"
    file.write_bytes(live_html(sim.Simulation(sim.load_scene(name)).capture())[0])
    page = visit(file.as_uri(), bypass_csp=True)
    assert found(page, axe) == []


@pytest.mark.parametrize("path", ["check", "video", "?as=seat&room=abcd", "?as=wall&room=abcd"])
def test_nothing_is_found_on_pages_without_a_body(visit: Visits, serve: Serve, axe: str, path: str) -> None:
    page = visit(f"{serve('rope').url}/{path}", bypass_csp=True)
    page.wait_for_timeout(500)
    assert found(page, axe) == []
