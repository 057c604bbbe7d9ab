"""A gallery and its pages in Firefox: from the disk and from a server of plain files.

By day this is tested where a Firefox is installed; `tests/run.sh --night` installs one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote

import pytest

from tests.amount import NIGHT
from tests.browser.firefox import Firefox, firefox, firefox_path
from tests.browser.sites import served
from tests.browser.test_site import PLACE, make_site

pytestmark = pytest.mark.skipif(not NIGHT and firefox_path() is None, reason="there is no Firefox")

LIVES = "window.__softrod?.now().body.time > 0"
PAPER = "getComputedStyle(document.body).backgroundColor"
CARDS = "[...document.querySelectorAll('li:not([hidden]) a')].map((card) => card.getAttribute('href'))"
IN_SIGHT = """[...document.images].filter(
  (one) => one.checkVisibility() && one.getBoundingClientRect().top < innerHeight)"""
MASS = """(() => {
  const { body } = __softrod.now(), on = __softrod.place(), plan = __softrod.plan();
  const { left, top } = document.querySelector("canvas").getBoundingClientRect();
  const [x, y] = [body.positions[0] - plan.x, body.positions[1] - plan.y].map((value) => value * plan.scale);
  return [left + on.x + on.step * x, top + on.y - on.step * y * plan.flip];
})()"""
"""Where the first mass is on the screen."""


@pytest.fixture
def tab() -> Iterator[Firefox]:
    with firefox() as tab:
        yield tab


def test_the_index_and_its_pages_in_firefox(tab: Firefox, tmp_path: Path) -> None:
    folder = make_site(tmp_path)
    disk = f"{folder.as_uri()}/"
    with served(tmp_path) as port:
        for base in (disk, f"http://127.0.0.1:{port}/{quote(PLACE)}/"):
            search_and_drag(tab, base)
            check(tab, base)


def check(tab: Firefox, base: str) -> None:
    """Nothing has been asked for but what is in the folder, and there were no errors."""
    assert not tab.errors
    inside = r"[a-z0-9.-]+\.html(#.*)?|pictures/(light|dark)/[a-z0-9.-]+\.webp|(data|blob):.*"
    assert [one for one in tab.asked if not re.fullmatch(inside, one.removeprefix(base))] == []
    tab.asked.clear()


def search_and_drag(tab: Firefox, base: str) -> None:
    """Find a scene by keys, drag its body, and go back, with a dark page."""
    tab.size(880, 580)
    tab.open(f"{base}index.html")
    assert tab.run("window.hurt ?? 'no harm'") == "no harm"
    tab.until(f"{IN_SIGHT}.length && {IN_SIGHT}.every((one) => one.naturalWidth)", "pictures load")
    tab.type("/", *"rope (3.3)")
    assert tab.run(CARDS) == ["tutorial-3.3.html"]
    tab.until("location.hash === '#search=rope+%283.3%29'", "the address has the search")
    tab.type("Down", "Enter")
    tab.until(f"document.title === 'Rope (3.3)' && {LIVES}", "the body moves")
    x, y = tab.run(MASS)
    before = tab.run("__softrod.now().body.positions[22]")
    tab.drag((x, y), (x + 120.0, y + 40.0))
    tab.until(f"Math.abs({MASS}[0] - {x + 120.0}) < 2", "the mass is where the pointer is")
    tab.until(f"__softrod.now().body.positions[22] > {before} + 40", "the other end follows")
    tab.release()
    tab.type("d")
    assert tab.run(PAPER) == "rgb(20, 20, 20)"
    tab.click("#bar .all")
    tab.until("document.activeElement?.id === 'at=tutorial-3.3'", "the way back leads to the card")
    assert tab.run(PAPER) == "rgb(20, 20, 20)"
    assert tab.run(CARDS) == ["tutorial-3.3.html"]
    tab.type("Escape")
    assert len(tab.run(CARDS)) == 9
    tab.click("#dark")
    assert tab.run(PAPER) == "rgb(255, 255, 255)"
    tab.size(390, 844)
    assert tab.run("document.documentElement.scrollWidth") <= 390
    tab.open(f"{base}index.html#scene=lesson-hooke")
    tab.until(
        "location.pathname.endsWith('/lesson-hooke.html') && window.__softrod?.now()",
        "a link leads to a scene",
    )
    assert tab.run("document.documentElement.scrollWidth") <= 390
