"""A gallery as a site: from the disk, from a server of plain files, by keys, by links, on a phone."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from msgspec.structs import replace
from playwright.sync_api import Page

import sim
from app.site import pages
from app.site.entries import shown
from app.site.folder import Folder
from app.site.install import ICONS
from tests.browser.conftest import Visits
from tests.browser.driver import until
from tests.browser.sites import served

Open = Callable[..., Page]

PLACE = "pluginfile.php/7/a class/content/1"
"""As a server for courses may have it."""

WICKED = '<img src="https://school.example/" onerror="window.hurt=1"><b>'


def make_site(root: Path) -> Path:
    """A gallery of some presets and a file that tries to do harm."""
    sim.save_scene(
        replace(sim.load_scene("box"), title="", name="x", description=f"{WICKED} in it"),
        root / f"{WICKED[:4]}.json",
    )
    out = root / PLACE
    out.parent.mkdir(parents=True)
    names = ["rope", "tree", "ring", "rod", "flag-pole", "lesson-hooke", "lesson-chaos", "tutorial-3.3"]
    made = pages.files(shown([*names, str(root / f"{WICKED[:4]}.json")], own=False), "Springs")
    Folder(out, made).write(made.items())
    return out


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a server serves; the gallery is deep inside of it."""
    root = tmp_path_factory.mktemp("root")
    make_site(root)
    return root


@pytest.fixture
def open_index(visit: Visits, root: Path) -> Iterator[Open]:
    """Opens the index, and looks after the test whether anything has left its folder."""
    bases = {f"{(root / PLACE).as_uri()}/"}

    def open_one(address: str = "", base: str = min(bases), **how: Any) -> Page:
        bases.add(base)
        return visit(f"{base}index.html{address}", **how)

    yield open_one
    inside = r"(index\.html(#.*)?|[a-z0-9.-]+\.html|pictures/(light|dark)/[a-z0-9.-]+\.webp"
    inside += r"|manifest\.json|offline\.js|icon-\d+\.png)"
    inside = f"({'|'.join(map(re.escape, bases))}){inside}|data:image/(svg|webp).*"
    assert [address for address in visit.asked if not re.fullmatch(inside, address)] == []


def lives(page: Page, name: str) -> None:
    """Wait until the page is that of a scene, and its body moves; in a lesson, is there to be predicted."""
    page.wait_for_url(f"**/{name}.html")
    least = 0.0 if name.startswith("lesson") else 1e-9
    until(page, lambda: page.evaluate(f"window.__softrod?.now().body.time >= {least}"), f"{name} moves")


def cards(page: Page) -> list[str]:
    """The cards that are shown."""
    return [one.get_attribute("href") or "" for one in page.locator("li a:visible").all()]


def focused(page: Page) -> str:
    return str(page.evaluate("document.activeElement.id"))


def test_from_the_disk_by_keys_alone(open_index: Open, tmp_path: Path) -> None:
    page = open_index(accept_downloads=True)
    count = page.locator("#count")
    assert count.inner_text() == "9 scenes"
    assert page.evaluate("window.hurt") is None
    page.keyboard.press("/")
    page.keyboard.type("WIND pole")
    assert count.inner_text() == "1 of 9 scenes"
    assert cards(page) == ["flag-pole.html"]
    page.keyboard.press("ControlOrMeta+A")
    page.keyboard.type("nothing of the kind")
    assert page.get_by_text("No scene has all of these words.").is_visible()
    assert cards(page) == []
    page.keyboard.press("Escape")
    assert count.inner_text() == "9 scenes"
    page.keyboard.type("lesson")  # letters search, wherever the focus is
    assert cards(page) == ["lesson-hooke.html", "lesson-chaos.html"]
    page.keyboard.press("ArrowDown")
    assert focused(page) == "at=lesson-hooke"
    page.keyboard.press("ArrowRight")
    assert focused(page) == "at=lesson-chaos"
    assert page.evaluate("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    page.keyboard.press("Enter")
    lives(page, "lesson-chaos")
    # What is chosen on one page holds on all.
    page.keyboard.press("d")
    paper = "getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(paper) == "rgb(20, 20, 20)"
    page.get_by_role("link", name=re.compile("Before: ")).click()
    lives(page, "lesson-hooke")
    assert page.evaluate(paper) == "rgb(20, 20, 20)"
    page.keyboard.press("o")
    page.wait_for_url("**/index.html*")
    until(page, lambda: focused(page) == "at=lesson-hooke", "the way back leads to the card")
    assert cards(page) == ["lesson-hooke.html", "lesson-chaos.html"]
    assert page.evaluate(paper) == "rgb(20, 20, 20)"
    assert page.get_by_role("button", name="Dark page").get_attribute("aria-pressed") == "true"


def test_a_page_saved_as_one_file_lives_alone(open_index: Open, visit: Visits, tmp_path: Path) -> None:
    page = open_index("#scene=ring", accept_downloads=True)
    lives(page, "ring")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save this page as one file").click()
    assert download.value.suggested_filename == "ring.html"
    saved = tmp_path / "alone.html"
    download.value.save_as(saved)
    alone = visit(saved.as_uri())
    assert visit.asked.pop() == saved.as_uri()
    lives(alone, "alone")
    assert alone.locator("nav, a").count() == 0
    assert alone.get_by_role("heading", level=1).inner_text() == sim.load_scene("ring").title


def test_where_scripts_do_not_run_a_picture_is_seen_and_nothing_that_would_not_answer(
    open_index: Open, visit: Visits
) -> None:
    page = open_index(java_script_enabled=False)
    dead = page.locator("button, input, select, canvas").locator("visible=true")
    assert dead.count() == 0
    page.get_by_role("link", name="Rope").first.click()
    assert dead.count() == 0
    picture = page.get_by_role("img", name="Rope")
    assert picture.evaluate("async (image) => (await image.decode(), image.naturalWidth)") == 480
    assert "Open the file in a web browser" in page.locator("header").inner_text()
    page.get_by_role("link", name="Tree").click()
    assert page.get_by_role("img", name="Tree").is_visible()
    assert visit.errors == []


def test_from_a_server_deep_inside_in_the_dark_on_a_phone(open_index: Open, root: Path) -> None:
    with served(root) as port:
        base = f"http://127.0.0.1:{port}/{quote(PLACE)}/"
        phone = {"size": (390, 844), "has_touch": True, "color_scheme": "dark"}
        page = open_index("#search=rope", base, **phone)
        assert page.locator("#search").input_value() == "rope"
        shown_images = "[...document.images].filter((image) => image.checkVisibility())"
        until(
            page,
            lambda: page.evaluate(f"{shown_images}.every((image) => image.naturalWidth > 100)"),
            "they load",
        )
        assert page.evaluate(f"{shown_images}.every((image) => image.src.includes('/dark/'))")
        assert page.evaluate(f"{shown_images}.length") == len(cards(page)) > 1
        # None of a picture that is not shown was loaded.
        loaded = page.evaluate("performance.getEntriesByType('resource').map(({ name }) => name)")
        assert loaded
        assert all("/dark/" in name for name in loaded if name.endswith(".webp"))
        page.locator("#search").fill("")
        # Two columns, and nothing to the right of the window.
        left = {round(one.bounding_box()["x"]) for one in page.locator("li a:visible").all()}  # type: ignore[index]
        assert len(left) == 2
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        page.get_by_role("link", name="Lessons 2").tap()
        heading = page.get_by_role("heading", name="Lessons")
        tools = page.locator("#tools").bounding_box()
        place = heading.bounding_box()
        assert tools is not None
        assert place is not None
        assert place["y"] >= tools["y"] + tools["height"] - 1.0
        page.goto(f"{base}index.html#scene=tutorial-3.3")
        lives(page, "tutorial-3.3")
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        page.goto(f"{base}index.html#scene={quote('<i>')}")
        assert "There is no scene called <i> here." in page.locator("main").inner_text()
        page.goto(f"{base}index.html#at=ring")
        until(page, lambda: focused(page) == "at=ring", "the card has the focus")


KEPT = "All of it is on this device now"
STORED = """async () => {
  const found = [];
  for (const name of await caches.keys()) {
    for (const { url } of await (await caches.open(name)).keys()) found.push(url);
  }
  return found;
}"""
"""The addresses of all that the browser has stored for the site."""


def test_after_one_visit_all_of_it_opens_without_a_network(visit: Visits, tmp_path: Path) -> None:
    make_site(tmp_path)
    base = f"/{quote(PLACE)}/"
    with served(tmp_path) as port:
        site = f"http://127.0.0.1:{port}{base}"
        page = visit(f"{site}index.html")
        page.get_by_text(KEPT).wait_for()
        # A browser can install it.
        found = page.context.new_cdp_session(page).send("Page.getAppManifest")
        manifest = json.loads(found["data"])
        assert found["errors"] == []
        assert (manifest["name"], manifest["display"], manifest["lang"]) == ("Springs", "standalone", "en")
        assert found["manifest"]["startUrl"] == f"{site}index.html"
        assert found["manifest"]["scope"] == site
        assert [icon["url"] for icon in found["manifest"]["icons"]] == [f"{site}{icon}" for icon in ICONS]
    # The server has stopped, and there is no network, either.
    page.context.set_offline(True)
    before = len(visit.errors)
    names = [href.removesuffix(".html") for href in cards(page)]
    assert len(names) == 9
    for start in (site, f"{site}index.html#search=", f"{site}index.html?from=home"):
        page.goto(start)
        assert page.locator("#count").inner_text() == "9 scenes"
        page.wait_for_function("[...document.images].some((image) => image.naturalWidth > 100)")
    for name in names:
        page.goto(f"{site}{name}.html")
        lives(page, name)
    page.keyboard.press("o")
    page.wait_for_url("**/index.html*")
    # As where a server leaves out what names end with.
    page.goto(f"{site}ring")
    page.wait_for_function("window.__softrod?.now().body.time >= 0")
    assert len(visit.errors) == before


TAKEN_OVER = """() => new Promise(
  (done) => navigator.serviceWorker.addEventListener("controllerchange", () => done(), { once: true })
)"""


def test_another_publication_replaces_the_one_that_is_kept(visit: Visits, tmp_path: Path) -> None:
    """Two galleries on a site, one of which is published anew."""
    for name in ("a", "b"):
        made = pages.files(shown(["ring", "rope"], own=False), f"First {name}")
        Folder(tmp_path / name, made).write(made.items())
    with served(tmp_path) as port:
        site = f"http://127.0.0.1:{port}"
        page = visit(f"{site}/a/")
        page.get_by_text(KEPT).wait_for()
        page.goto(f"{site}/b/")
        page.get_by_text(KEPT).wait_for()
        first = page.evaluate(STORED)
        made = pages.files(shown(["ring", "box"], own=False), "Second a")
        Folder(tmp_path / "a", made).write(made.items())
        page.goto(f"{site}/a/")
        # The browser looks for another one by itself, and that takes over once it has all files.
        page.evaluate(TAKEN_OVER)
        page.goto(f"{site}/a/")
        assert page.get_by_role("heading", level=1).inner_text() == "Second a"
        page.wait_for_function(
            f"async () => !(await ({STORED})()).some((url) => url.includes('/a/rope.html'))"
        )
        now = page.evaluate(STORED)
        # Nothing of the old one is left, and what is the same was not fetched again.
        assert len(now) == len(first)
        assert [url for url in now if "/b/" in url] == [url for url in first if "/b/" in url]
        same = {url for url in now if "/pictures/" in url and "ring" in url}
        assert same < set(first)
        # A login page or a web filter answers for the server: none of that is kept, and the old one goes on.
        made = pages.files(shown(["ring"], own=False), "Third a")
        Folder(tmp_path / "a", made).write(made.items())
        (tmp_path / "a" / "ring.html").write_text("Who are you?")
        page.goto(f"{site}/a/")
        page.evaluate("navigator.serviceWorker.getRegistration().then((it) => it.update()).catch(() => 0)")
        page.wait_for_function(
            "navigator.serviceWorker.getRegistration().then((it) => !it.installing && !it.waiting)"
        )
        page.goto(f"{site}/a/ring.html")
        lives(page, "ring")
        page.context.set_offline(True)
        page.goto(f"{site}/b/rope.html")
        lives(page, "rope")
