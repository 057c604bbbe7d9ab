"""What the page offers where there is room, when the body is out of view, and on paper."""

from __future__ import annotations

import itertools
import re

import numpy as np
import pytest

from app.session import commands
from tests.amount import part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, box_of, middle_of


def test_words_stand_beside_the_icons_where_there_is_room(open_page: OpenPage) -> None:
    desk = open_page(size=(1280, 700))
    word = desk.button("Reset").locator("span")
    assert word.is_visible()
    # Nothing is cut off, and nothing lies over its neighbour.
    boxes = [box_of(part) for part in desk.page.locator(".softrod-transport > *").all() if part.is_visible()]
    edges = [(box["x"], box["x"] + box["width"]) for box in boxes]
    assert all(end <= begin for (_, end), (begin, _) in itertools.pairwise(edges)), edges
    desk.page.set_viewport_size({"width": 800, "height": 600})
    desk.until(lambda: not word.is_visible(), "the words give way")
    assert desk.button("Reset").is_visible()


def test_an_arrow_at_the_edge_leads_back_to_a_body_that_is_out_of_view(open_page: OpenPage) -> None:
    """To the left, and above and below, beside what else lies there; with the tools open and without."""
    desk = open_page(size=(1100, 760))
    desk.tell(commands.Play(False))
    arrow = desk.page.locator(".softrod-edge")
    assert not arrow.is_visible()
    for key, start, end in (
        ("", (600.0, 300.0), (20.0, 300.0)),
        ("", (600.0, 650.0), (20.0, 10.0)),
        ("", (600.0, 40.0), (20.0, 690.0)),
        ("e", (600.0, 40.0), (20.0, 690.0)),
    ):
        if key:
            desk.page.keyboard.press(key)
            desk.page.keyboard.press("q")
        desk.page.mouse.move(*start)
        desk.rest(3)
        desk.page.mouse.down()
        desk.lead(start, end, 4)
        desk.page.mouse.up()
        desk.until(lambda: arrow.is_visible(), "the arrow is there")
        assert box_of(arrow)["x"] < 60.0, "the body is to the left"
        arrow.click()  # it fails if something else is over it
        desk.until(lambda: not arrow.is_visible(), "the arrow is gone")
        assert all(desk.uncovered((x, y)) for x, y in desk.at(desk.simulation.positions))


def test_show_all_shows_a_body_that_has_left_the_scene_s_frame(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    # The view is the user's, and goes after nobody.
    seen = desk.camera()
    desk.page.mouse.move(300.0, 300.0)
    desk.page.mouse.wheel(0.0, -100.0)
    desk.until(lambda: not desk.camera().same(seen), "it is zoomed")
    x, y = desk.simulation.positions[0]
    desk.tell(commands.DragStart(0, x, y), commands.Point(x + 1500.0, y, late=True), commands.DragEnd())
    desk.wait_drawn()
    assert not desk.uncovered(desk.place(0))
    desk.page.keyboard.press("0")
    desk.until(lambda: desk.uncovered(desk.place(0)), "all of it is in view")


def test_a_scene_is_opened_anew(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("angular_stiffness", 500.0))
    box, chooser = map(box_of, (desk.button("Open anew"), desk.chooser("Rope (3.3)")))
    assert box["height"] > 20.0
    assert abs(box["y"] - chooser["y"]) < 4.0
    assert box["x"] > chooser["x"] + chooser["width"]
    desk.button("Open anew").click()
    desk.until(
        lambda: desk.session.scene.angular_springs[0].stiffness == 10_000.0, "it is as its file has it"
    )


INSIDE = """names => [...document.querySelectorAll(names)].filter(e => e.checkVisibility()).map(e => {
  const box = e.getBoundingClientRect();
  const over = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  const cut = box.x < 0 || box.y < 0 || box.right > innerWidth || box.bottom > innerHeight;
  return [e.ariaLabel ?? e.className, !cut && (e.contains(over) || over?.contains(e))];
})"""
"""Whether each of some elements is in view with nothing over it, by its name."""


def is_seen(desk: Desk, names: str, count: int) -> bool:
    """Whether there are so many of some elements at least, and each is in view with nothing over it."""
    found = desk.page.evaluate(INSIDE, names)
    return len(found) >= count and all(inside for _, inside in found)


def test_on_a_low_screen_what_a_button_opens_is_whole(open_page: OpenPage) -> None:
    desk = open_page(size=(640, 360), phone=True)
    for width, height in part_of(((640, 360), (568, 320)), 2):
        desk.page.set_viewport_size({"width": width, "height": height})
        for name, entries, count in (
            ("View", ".softrod-menu-list button", 6),
            ("Instruments", ".softrod-box-tools button", 3),
        ):
            desk.button(name).click()
            desk.until(lambda names=entries, least=count: is_seen(desk, names, least), f"{name} is whole")
            desk.page.keyboard.press("Escape")


def test_a_page_stays_dark_when_it_goes_to_another_scene_s_address(open_page: OpenPage) -> None:
    desk = open_page()
    desk.view("Dark")
    desk.page.wait_for_function("sessionStorage.getItem('softrod-dark') === '1'")
    desk.open("/s?scene=ring")
    desk.until(lambda: desk.tab.probe().looks.dark, "so is the other scene")
    desk.until(desk.is_kept, "it is kept")
    desk.open("/s?scene=ring")
    desk.pause(0.3)
    assert desk.tab.probe().looks.dark, "and it is after a reload"


SMALL_SCREENS = ((844, 390), (390, 844), (360, 640), (683, 384))


def test_on_a_small_screen_all_of_the_bar_the_tools_and_the_body_is_in_reach(open_page: OpenPage) -> None:
    sizes = part_of(SMALL_SCREENS, 2)  # one that is wide and one that is not
    desk = open_page(size=sizes[0], phone=True)
    desk.tell(commands.Play(False))

    def seen(names: str, count: int) -> bool:
        return is_seen(desk, names, count)

    def body() -> bool:
        return all(desk.uncovered((x, y)) for x, y in desk.at(desk.simulation.positions))

    def is_low() -> bool:
        return desk.page.locator(".softrod-transport").evaluate("bar => bar.offsetHeight < 90")

    bar = ".softrod-transport :is(button, input, .softrod-clock, select)"
    for width, height in sizes:
        desk.page.set_viewport_size({"width": width, "height": height})
        desk.until(lambda: seen(bar, 5), "the bar of time is whole")
        desk.until(is_low, "it is one row")
        desk.until(body, "the body is in view")
        desk.button("Edit").click()
        desk.until(lambda: seen(".softrod-edit button", 8), "the tools are whole")
        desk.until(body, "so is the body beside them")
        assert abs(desk.place(11)[1] - desk.place(0)[1]) > 70.0
        assert seen(bar, 5)
        desk.button("Done").scroll_into_view_if_needed()
        desk.until(
            lambda: seen(".softrod-edit-bar > button:last-of-type", 1), "nothing is over the last button"
        )
        desk.button("Done").click()


SMALL = """least => [...document.querySelectorAll("body *")].filter(e => {
  const words = [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim());
  const said = e instanceof HTMLInputElement ? e.value : words;
  if (!said || !e.checkVisibility() || !e.getBoundingClientRect().width) return false;
  if (e.matches(".softrod-live, .softrod-tell, option, [aria-hidden] *") || e.type === "range") return false;
  return parseFloat(getComputedStyle(e).fontSize) * e.currentCSSZoom < least;
}).map(e => `${e.tagName} ${e.className} ${e.value ?? e.textContent}`.slice(0, 90))"""
"""Texts that are seen and are smaller than so many pixels."""


def test_for_a_projector_all_that_is_read_is_large(open_page: OpenPage) -> None:
    """From the command palette, on a screen of 1920 by 1080; and it is there again after a reload."""
    desk = open_page(size=(1920, 1080))
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_role("option").filter(has_text="Larger, for a projector").click()
    desk.until(lambda: desk.page.locator("html.softrod-projector").count() == 1, "all is larger")
    desk.page.keyboard.press("g")
    desk.page.locator(".softrod-chart").wait_for()
    for tab in ("Play", "Measure", "Solver", "Share"):
        desk.show(tab)
        desk.rest(3)
        assert not desk.page.evaluate(SMALL, 23.9), tab
    desk.show("Play")
    # What is beside the panel is not below it, and its sliders are where they seem to be.
    panel, canvas = (desk.page.locator(one).first for one in (".softrod-panel", "canvas"))
    assert box_of(panel)["width"] >= 560.0

    def are_beside() -> bool:
        left = box_of(canvas)
        return abs(left["x"] + left["width"] - box_of(panel)["x"]) < 1.0

    desk.until(are_beside, "the canvas ends where the panel begins")
    desk.show("Play")
    desk.click_track("Gravity", 0.5)
    desk.until(
        lambda: abs(desk.slider_value("Gravity") - 2500.0) < 60.0, "the slider is where it was clicked"
    )
    desk.show("Solver")
    desk.button("View").click()
    assert not desk.page.evaluate(SMALL, 23.9)
    desk.page.keyboard.press("Escape")
    desk.open()
    assert desk.page.locator("html.softrod-projector").count() == 1
    desk.page.keyboard.press("z")
    desk.until(lambda: box_of(desk.page.locator(".softrod-panel"))["width"] < 400.0, "as before")
    canvas = desk.page.locator("canvas").first
    desk.until(lambda: box_of(canvas)["width"] > 1500.0, "the canvas has its place again")


@pytest.mark.parametrize("dark", part_of((False, True), 2))
def test_on_paper_there_are_the_body_its_title_and_the_time(open_page: OpenPage, dark: bool) -> None:
    desk = open_page(size=(1000, 700), pixels=True)
    if dark:
        desk.view("Dark")
        desk.until(lambda: desk.tab.probe().looks.dark, "it is dark")
        desk.wait_drawn()
    desk.tell(commands.Play(False))
    desk.until(desk.clock_is_right, "the clock shows where it stands")
    time = desk.clock()
    seen = desk.camera()
    desk.page.emulate_media(media="print")
    heading = desk.page.locator(".softrod-paper")
    desk.until(lambda: heading.inner_text().startswith("Rope (3.3)\n"), "the heading is there")
    assert time in heading.inner_text()
    assert not desk.page.locator(".softrod-dock").is_visible()
    assert not desk.page.get_by_role("tab").first.is_visible()
    picture = desk.picture("paper-dark.png" if dark else "paper.png")
    assert np.median(picture) > 250.0
    body = picture[picture.shape[0] // 4 :]
    reddish = body[:, :, 0] - body[:, :, 1:].max(2)
    assert (reddish > 160.0).sum() > 300  # the masses, which are not pale
    assert (body.max(2) < 120.0).mean() < 0.02  # and no dark grid
    assert desk.camera().same(seen)  # the canvas has another size, but what is drawn in it has not
    desk.page.emulate_media(media="screen")
    desk.until(lambda: desk.page.locator(".softrod-dock").is_visible(), "the page is back")
    overlay = desk.page.locator(".softrod-overlay")
    desk.until(lambda: overlay.get_attribute("viewBox") is None, "the marks are as before")


def test_on_a_phone_the_bar_of_time_is_the_foot_and_never_moves_while_the_sheet_does(
    open_page: OpenPage,
) -> None:
    desk = open_page(size=(390, 844), phone=True)
    bar, sheet = desk.page.locator(".softrod-transport"), desk.page.locator(".softrod-panel")

    def stands() -> bool:
        box = box_of(bar)
        return box["y"] + box["height"] == pytest.approx(844.0, abs=1.0)

    def is_high(least: float, most: float) -> None:
        desk.until(lambda: least <= 844.0 - box_of(sheet)["y"] <= most, f"it takes {least} to {most} px")
        assert stands()

    is_high(300.0, 0.45 * 844.0 + 2.0)
    desk.show("Share")
    desk.button("3D model").scroll_into_view_if_needed()
    assert stands()
    # A finger drags it by its handle, and it goes on to the height at which it was thrown.
    x, y = middle_of(desk.page.locator(".softrod-handle"))
    for way, least, most in ((-120.0, 780.0, 806.0), (120.0, 300.0, 400.0), (120.0, 120.0, 150.0)):
        x, y = middle_of(desk.page.locator(".softrod-handle"))
        desk.drag((x, y), (x, y + way))
        is_high(least, most)
    # A tab that is pressed is wanted in sight.
    desk.show("Play")
    is_high(300.0, 400.0)
    desk.button("More of time").click()
    desk.until(lambda: desk.button("1 step").is_visible(), "the rest of the bar is there")
    assert stands()


def test_on_paper_there_are_also_the_plots_and_the_step_of_a_lesson(open_page: OpenPage) -> None:
    desk = open_page("lesson-hooke", size=(1000, 700), pixels=True)
    desk.page.locator("svg.softrod-chart").wait_for()
    desk.until(lambda: desk.page.locator(".softrod-reading").count() == 1, "the plot is drawn")
    title = desk.page.locator(".softrod-lesson h2").inner_text()
    desk.page.emulate_media(media="print")
    below = desk.page.locator(".softrod-paper-below")
    desk.until(lambda: title in below.inner_text(), "the step is on paper")
    assert "stretch of spring 0" in below.inner_text()
    assert "How far below its start does the mass come to rest, if gravity is doubled?" in below.inner_text()
    assert below.locator("figure svg path").count() > 1
    assert desk.page.locator(".softrod-panel").evaluate("e => getComputedStyle(e).visibility") == "hidden"
    box, canvas = box_of(below), box_of(desk.page.locator("canvas").first)
    assert canvas["y"] + canvas["height"] <= box["y"] + 1.0
    assert box["y"] + box["height"] <= 700.0
    desk.picture("paper-lesson.png")


def test_four_plots_stand_below_the_body_on_one_page(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(703, 1032))
    desk.page.keyboard.press("g")
    desk.show("Measure")
    for _ in range(3):
        desk.button("New plot").click()
    charts = desk.page.locator(".softrod-panel svg.softrod-chart path.softrod-chart-line")
    desk.until(lambda: charts.count() >= 4, "four are drawn")
    printed = desk.page.pdf(format="A4", prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page\b(?!s)", printed)) == 1
    desk.page.emulate_media(media="print")
    figures = desk.page.locator(".softrod-paper-plots figure")
    desk.until(lambda: figures.count() == 4, "they are on paper")
    body = box_of(desk.page.locator("canvas").first)
    boxes = [box_of(figures.nth(i)) for i in range(4)]
    tops = [body["y"] + body["height"], *(box["y"] + box["height"] for box in boxes)]
    assert body["height"] > 200.0
    for box, above in zip(boxes, tops, strict=False):
        assert box["y"] >= above - 1.0
        assert box["width"] > 700.0
        assert box["height"] > 140.0
    assert tops[-1] <= 1033.0


def test_what_is_said_over_the_body_covers_no_mass(open_page: OpenPage) -> None:
    desk = open_page(pixels=True)
    desk.tell(commands.Play(False))
    desk.wait_drawn()
    word = desk.page.locator(".softrod-hud b")
    word.wait_for()
    # The view is moved until a mass is in the middle of the word.
    wanted = np.array(middle_of(word))
    begin = np.array((400.0, 300.0))

    def is_there() -> bool:
        end = begin + wanted - desk.place(11)
        desk.page.mouse.move(*begin)
        desk.page.mouse.down()
        desk.page.mouse.move(*end, steps=4)
        desk.page.mouse.up()
        desk.rest(3)
        return bool(np.hypot(*(desk.place(11) - wanted)) < 4.0)

    desk.until(is_there, "the mass is there")
    desk.rest(3)
    with_word = desk.picture(marks=False)
    desk.page.add_style_tag(content=".softrod-hud b { visibility: hidden }")
    desk.rest(1)
    without = desk.picture(marks=False)
    differs = np.abs(with_word - without).max(2) > 40.0
    x, y = desk.place(11)
    rows, columns = np.nonzero(differs)
    assert len(rows) > 20, "the word is seen"
    assert np.hypot(columns - x, rows - y).min() > 3.0, "but not over the mass"


@pytest.mark.parametrize(("size", "times"), [((1280, 720), 1.6), ((390, 844), 1.2)])
def test_letters_are_as_large_as_the_browser_s_user_wishes_and_nothing_leaves_the_window(
    open_page: OpenPage, size: tuple[int, int], times: float
) -> None:
    desk = open_page(size=size, phone=size[0] < 600)
    label = desk.page.get_by_text("Bending stiffness", exact=True)
    usual, seen = box_of(label)["height"], "[innerWidth, document.documentElement.scrollWidth]"
    letters = desk.page.context.new_cdp_session(desk.page)
    letters.send("Page.setFontSizes", {"fontSizes": {"standard": 32}})
    try:
        desk.open()
        desk.until(lambda: box_of(label)["height"] > times * usual, "they are larger")
        width, reached = desk.page.evaluate(seen)
        assert reached <= width
        box = box_of(desk.page.locator(".softrod-panel"))
        assert box["x"] >= -0.5
        assert box["x"] + box["width"] <= width + 0.5
        assert desk.uncovered(desk.place(0)), "the body is beside it"
    finally:
        letters.send("Page.setFontSizes", {"fontSizes": {"standard": 16}})
    desk.open()
    desk.until(lambda: box_of(label)["height"] < 1.1 * usual, "as before")
