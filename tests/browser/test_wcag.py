"""What WCAG 2.2 asks of a page's layout and colours, measured on every page (`places.py`)."""

from __future__ import annotations

import io
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from app.classroom import kept
from tests.amount import part_of
from tests.browser import seen
from tests.browser.driver import box_of
from tests.browser.places import PLACES, Place, Places, places
from tests.browser.test_class import CONTRAST, a_lesson

GRAPHICS = (Path(__file__).parent / "graphics.js").read_text(encoding="utf-8")

LEAST = 24
"""Size of a target, CSS px: 2.5.8."""
SMALLEST = {"width": 320, "height": 256}
"""The window of 1280 x 1024 at four times the usual size: 1.4.10."""
DOUBLE = {"width": 640, "height": 512}
"""The same at twice the usual size: 1.4.4."""
LARGE = 32
"""Size of letters, px, in a browser whose user wishes them twice as large."""
DRAWN, READ = 3.0, 7.0
"""Least contrast of what is drawn: 1.4.11, and of letters where more is wished: 1.4.6."""

TEACHING = ("wall", "desk")
"""Made for large screens."""
SHEETS = ("sandbox", "phone", "lesson", "lesson on a phone")
"""Their panel is a sheet over the canvas in small windows."""

OVER = ".softrod-over, .softrod-menu, .softrod-box, .softrod-edit, .softrod-pad, .softrod-transport"
"""What is over the canvas while that sheet is closed."""

SPACED = """(on) => {
  document.adoptedStyleSheets = document.adoptedStyleSheets.filter((sheet) => !sheet.spaced);
  if (!on) return;
  const sheet = Object.assign(new CSSStyleSheet(), { spaced: true });
  sheet.replaceSync("* { line-height: 1.5 !important; letter-spacing: 0.12em !important }"
    + " * { word-spacing: 0.16em !important } p { margin-bottom: 2em !important }");
  document.adoptedStyleSheets.push(sheet);
}"""

SLIDE, LINES = 16 / 9, 44
"""Of the wall: width by height, and in how many lines of its smallest letters; see docs/access.md."""

STOPS = 25
"""Presses of Tab."""

HIDDEN = """() => {
  const at = document.activeElement;
  if (!at || at === document.body || at.matches("canvas, [role=application]")) return "";
  const { left, top, width, height } = (at.labels?.[0] ?? at).getBoundingClientRect();
  const seen = [0.1, 0.5, 0.9].some((i) => [0.1, 0.5, 0.9].some((j) => {
    const hit = document.elementFromPoint(left + i * width, top + j * height);
    return hit && (at.contains(hit) || hit.contains(at) || at.labels?.[0]?.contains(hit));
  }));
  return seen ? "" : `${at.localName} ${at.ariaLabel ?? at.textContent.slice(0, 40)}`;
}"""
"""What has the focus, if all of it is out of the window or under something."""

TEXTS = """() => {
  const found = {};
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const { parentElement: at, textContent } = walker.currentNode;
    const text = textContent.trim();
    if (!text || !at.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
    if (at.matches("script, style, option, title, noscript")) continue;
    if (at.getBoundingClientRect().width < 2) continue;
    found[text] ??= parseFloat(getComputedStyle(at).fontSize) * (at.currentCSSZoom ?? 1);
  }
  return found;
}"""


@pytest.fixture(scope="module")
def all_places(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Places]:
    folder = tmp_path_factory.mktemp("places")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kept, "classes_folder", lambda: folder)
        with places(browser, folder, a_lesson()) as made:
            yield made
    assert not made.errors


@pytest.fixture(scope="module", params=part_of(list(PLACES), 4))
def name(request: pytest.FixtureRequest) -> str:
    """A page's name; all tests of one page follow each other."""
    return request.param


def shown(all_places: Places, name: str, size: dict[str, int] | None = None) -> tuple[Page, Place]:
    """A page as it is when it is opened, in a window of a size."""
    place, page = PLACES[name], all_places.open(name)
    width, height = place.size
    page.set_viewport_size(size or {"width": width, "height": height})  # type: ignore[arg-type]
    page.wait_for_timeout(200)
    return page, place


def measured(page: Page, *questions: tuple[Any, ...]) -> list[str]:
    """What is wrong with a page, by these questions to `visible.js`.

    They are asked again if something is, as it may be about to take its place in another window.
    """
    first = _asked(page, questions)
    if not first:
        return []
    page.wait_for_timeout(500)
    again = _asked(page, questions)
    return [one for one in first if one in again]


def _asked(page: Page, questions: tuple[tuple[Any, ...], ...]) -> list[str]:
    return [
        f"{name}: {fault['kind']} {fault['words']!r} {fault['more']}"
        for name, *values in questions
        for fault in seen.ask(page, name, *values)
    ]


def test_every_target_can_be_hit(all_places: Places, name: str) -> None:
    """In all of its states."""
    page, _ = shown(all_places, name)
    found = {state: measured(page, ("crowded", LEAST)) for state in all_places.states(name)}
    all_places.close()
    assert not {state: faults for state, faults in found.items() if faults}


def test_in_the_smallest_window_all_is_there_and_scrolled_one_way(all_places: Places, name: str) -> None:
    if name in TEACHING:
        pytest.skip("it is made for large screens")
    page, _ = shown(all_places, name, SMALLEST)
    questions = ("sideways",), ("cut",)
    if name not in SHEETS:
        assert measured(page, *questions, ("unreached", "body")) == []
        return
    handle = page.locator(".softrod-handle")
    # A lesson begins with its question, and all else with the body.
    assert handle.get_attribute("aria-expanded") == str("lesson" in name).lower()
    for within in (OVER, ".softrod-panel, .softrod-transport"):
        wanted = str(within != OVER).lower()
        if handle.get_attribute("aria-expanded") != wanted:
            handle.click()
            page.wait_for_timeout(200)
        assert handle.get_attribute("aria-expanded") == wanted
        assert measured(page, *questions, ("unreached", within)) == []


@pytest.mark.parametrize("name", part_of(("lesson", "live lesson", "lesson on a phone"), 3))
def test_in_the_smallest_window_a_step_of_a_lesson_is_done(all_places: Places, name: str) -> None:
    """Read, answered, run, its plot read, and left: all of it is scrolled to, and nothing lies over it."""
    all_places.close()
    page, _ = shown(all_places, name, SMALLEST)
    page.get_by_role("button", name="100 px").click()
    if name == "live lesson":
        page.get_by_role("button", name="It will be there").click()
    page.locator(":is(.softrod-play, #play)").click()
    plot = page.locator(":is(.softrod-chart, .chart canvas)").first
    plot.scroll_into_view_if_needed()
    box = box_of(plot)
    assert box["x"] >= 0.0 and box["x"] + box["width"] <= SMALLEST["width"]
    assert box["height"] <= SMALLEST["height"]
    page.get_by_role("button", name="Check my answer").click()
    expect(page.locator(".softrod-verdict")).to_contain_text("That is right.")
    page.get_by_role("button", name="Next step").click()
    expect(page.locator(".softrod-lesson-count")).to_contain_text("2 of 4")
    all_places.close()


@pytest.mark.parametrize("name", ["seat"])
def test_in_the_smallest_window_each_phase_of_a_class_is_usable(all_places: Places, name: str) -> None:
    all_places.close()
    page, _ = shown(all_places, name, SMALLEST)
    questions = ("sideways",), ("cut",), ("unreached", "body")
    found = {state: measured(page, *questions) for state in all_places.states(name)}
    all_places.close()
    assert {state: faults for state, faults in found.items() if faults} == {}


def test_at_twice_the_size_nothing_is_cut_or_covered(all_places: Places, name: str) -> None:
    page, _ = shown(all_places, name, DOUBLE)
    questions = ("sideways",), ("cut",), *([] if name in TEACHING else [("unreached", "body")])
    assert measured(page, *questions) == []


def test_controls_and_marks_stand_out_also_where_the_system_forces_colours(
    all_places: Places, name: str
) -> None:
    page, _ = shown(all_places, name)
    dim: list[str] = []
    for scheme, forced in (("light", "none"), ("light", "active"), ("dark", "active")):
        page.emulate_media(color_scheme=scheme, forced_colors=forced)  # type: ignore[arg-type]
        page.wait_for_timeout(300)
        dim += [f"{scheme}, {forced}: {one}" for one in dim_graphics(page)]
        if forced == "active":
            dim += [f"{scheme}, {forced}: {one}" for one in pale(page, 4.5)]
    page.emulate_media(color_scheme="light", forced_colors="none")
    assert not dim


def test_where_more_contrast_is_wished_letters_have_it(all_places: Places, name: str) -> None:
    page, _ = shown(all_places, name)
    found = []
    for scheme in ("light", "dark"):
        page.emulate_media(contrast="more", color_scheme=scheme)  # type: ignore[arg-type]
        page.wait_for_timeout(300)
        found += pale(page, READ)
    page.emulate_media(contrast="no-preference", color_scheme="light")
    assert not found


def test_with_the_spaces_that_a_reader_sets_nothing_is_cut(all_places: Places, name: str) -> None:
    """1.4.12: of lines, paragraphs, letters and words."""
    page, _ = shown(all_places, name)
    page.evaluate(SPACED, True)
    faults = [fault for fault in measured(page, ("cut",)) if "…' cut" not in fault]
    page.evaluate(SPACED, False)
    assert faults == []


def test_what_has_the_focus_is_seen(all_places: Places, name: str) -> None:
    """2.4.11: nothing lies over all of it."""
    page, _ = shown(all_places, name)
    hidden = set()
    for _ in range(STOPS):
        page.keyboard.press("Tab")
        if fault := page.evaluate(HIDDEN):
            hidden.add(fault)
    all_places.close()
    assert hidden == set()


def test_all_letters_grow_with_those_of_the_browser(all_places: Places, name: str) -> None:
    place = PLACES[name]
    if place.touch:
        pytest.skip("phones enlarge the whole page")
    if name == "wall":
        pytest.skip("its letters are as large as there is room anyway: the next test measures them")
    page, _ = shown(all_places, name)
    usual = page.evaluate(TEXTS)
    page.context.new_cdp_session(page).send("Page.setFontSizes", {"fontSizes": {"standard": LARGE}})
    page.reload()
    page.wait_for_function(place.ready)
    page.wait_for_timeout(600)
    large = page.evaluate(TEXTS)
    faults = measured(page, ("cut",))
    all_places.close()
    both = usual.keys() & large.keys()
    assert both
    assert {text: (usual[text], large[text]) for text in both if large[text] < 1.95 * usual[text]} == {}
    assert faults == []


def test_the_wall_s_letters_are_those_of_a_slide_in_each_phase(all_places: Places) -> None:
    page, place = shown(all_places, "wall")
    least = min(place.size[1], place.size[0] / SLIDE) / LINES
    found, small = 0, {}
    for phase in all_places.states("wall"):
        texts = page.evaluate(TEXTS)
        found += len(texts)
        small |= {(phase, text): size for text, size in texts.items() if size < least - 0.01}
    all_places.close()
    assert found > 20
    assert small == {}


TARGETS = """() => Object.fromEntries([...document.querySelectorAll("button, select, input, summary")]
  .filter((element) => element.checkVisibility({ visibilityProperty: true }) && element.type !== "range")
  .map((element) => {
    const { width, height } = element.getBoundingClientRect();
    const name = `${element.ariaLabel ?? ""} ${element.textContent} ${element.className}`;
    return [name, [Math.min(width, 48), height]];
  }))"""
"""Sizes of what can be pressed, px; of widths 48 are enough."""


@pytest.mark.parametrize("name", ["phone", "lesson on a phone"])
def test_larger_enlarges_all_that_a_phone_shows_and_no_target_shrinks(all_places: Places, name: str) -> None:
    all_places.close()
    page, _ = shown(all_places, name)
    usual, sizes = page.evaluate(TEXTS), page.evaluate(TARGETS)
    page.keyboard.press("z")
    page.wait_for_timeout(600)
    large, after = page.evaluate(TEXTS), page.evaluate(TARGETS)
    faults = measured(page, ("sideways",), ("unreached", "body"))
    all_places.close()
    both = usual.keys() & large.keys()
    assert len(both) > 10
    assert {text: (usual[text], large[text]) for text in both if large[text] < 1.35 * usual[text]} == {}
    shared = sizes.keys() & after.keys()
    shrunk = {one for one in shared if any(b < a - 1.0 for a, b in zip(sizes[one], after[one], strict=True))}
    assert shrunk == set()
    assert faults == []


# ------------------------------------------------------------------------- colours
def pale(page: Page, least: float) -> list[str]:
    """The texts with less contrast; where they are large, two thirds of it will do."""
    return [
        f"{one['text']!r} {one['ratio']}"
        for one in page.evaluate(CONTRAST)
        if one["ratio"] < (least * one["needed"] / 4.5)
    ]


def luminance(colors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of sRGB colours, 0..255, as WCAG has it."""
    parts = colors / 255.0
    parts = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return parts @ (0.2126, 0.7152, 0.0722)


def stands_out(picture: NDArray[np.float64], box: tuple[int, int, int, int]) -> bool:
    """Whether something in a box has a contrast of 3 to 1 with what is around it."""
    left, top, width, height = box
    whole = luminance(picture[top - 3 : top + height + 3, left - 3 : left + width + 3])
    around = float(np.median(np.concatenate((whole[0], whole[-1], whole[:, 0], whole[:, -1]))))
    inner = whole[3:-3, 3:-3]
    ratio = (np.maximum(inner, around) + 0.05) / (np.minimum(inner, around) + 0.05)
    return int((ratio >= DRAWN).sum()) >= 6


def dim_graphics(page: Page) -> list[str]:
    """The controls and marks that do not stand out; twice, as a line may come or go while one looks."""
    first = _dim_now(page)
    again = _dim_now(page) if first else []
    return [one for one in first if one in again]


def _dim_now(page: Page) -> list[str]:
    found = page.evaluate(GRAPHICS)
    image = Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB")
    check = partial(stands_out, np.asarray(image, float))
    return [f"{one['name']} at {one['box']}" for one in found if not check(tuple(one["box"]))]


def test_what_does_not_stand_out_is_found(browser: Browser) -> None:
    page = browser.new_page()
    page.set_content(
        "<style>body { margin: 20px } input { border: 1px solid #ddd; display: block; margin: 9px }</style>"
        "<input aria-label='pale'><input aria-label='dark' style='border-color: #555'>"
        "<button style='width: 9px; height: 9px; padding: 0'>a</button>"
        "<button style='width: 9px; height: 9px; padding: 0'>b</button>"
        "<p style='color: #888'>grey</p>"
    )
    assert [one.split()[1] for one in dim_graphics(page)] == ["pale"]
    assert [one.split()[0] for one in pale(page, READ)] == ["'grey'"]
    assert len(measured(page, ("crowded", LEAST))) == 2
    page.close()
