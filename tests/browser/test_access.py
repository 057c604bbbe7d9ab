"""The page Access of the View menu: language, letters that are no keys, motion, contrast."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, box_of, middle_of, sandboxes
from tests.browser.test_wcag import pale

WORDS = "pack my box with five dozen liquor jugs, 0 or 10. Then go on: quit? "
SHOWN = "document.body.innerText.replace('drag me\\n', '')"
"""What a page says, but for the hint, which goes by itself."""
MANY = 15 * WORDS
"""More than 200 words."""


def opened(desk: Desk, entry: str = "Access and language") -> None:
    """Open the page Access."""
    desk.view(entry)
    desk.page.locator("dialog.softrod-access").wait_for()


def test_another_language_keeps_the_body_and_what_can_be_undone(open_page: OpenPage) -> None:
    desk = open_page()
    desk.changed = True
    desk.tell(commands.SetValue("gravity", 321.0))
    desk.until(lambda: desk.session.scene.gravity[1] == 321.0, "the body has been changed")
    desk.until(desk.is_kept, "the page has it")
    opened(desk)
    desk.page.locator("dialog.softrod-access select").first.select_option("de")
    desk.page.wait_for_function("document.documentElement.lang === 'de' && window.__softrod?.fitted() > 0")
    desk.client = max(sandboxes(desk.served.ticker))
    desk.until(lambda: desk.session.scene.gravity[1] == 321.0, "the body is there again")
    assert desk.tab.language == "de"
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: desk.session.scene.gravity[1] != 321.0, "what was done before is undone")


def test_another_language_keeps_the_step_of_a_lesson(open_page: OpenPage) -> None:
    desk = open_page("lesson-hooke")
    desk.changed = True
    count = desk.page.locator(".softrod-lesson-count")
    for name in ("100 px", "Check my answer", "Next step"):
        desk.page.get_by_role("button", name=name).click()
    expect(count).to_contain_text("2 of 4")
    opened(desk)
    desk.page.locator("dialog.softrod-access select").first.select_option("de")
    expect(count).to_contain_text("2 von 4")
    desk.page.get_by_role("button", name="Zurück", exact=True).click()
    expect(desk.page.get_by_text("Das ist richtig.")).to_be_visible()


def test_arrows_choose_a_tab_that_was_reached_by_the_tab_key(open_page: OpenPage) -> None:
    desk = open_page()
    tabs = desk.page.get_by_role("tab")
    for _ in range(60):
        desk.page.keyboard.press("Tab")
        if desk.page.evaluate("document.activeElement.matches('[role=tab]')"):
            break
    desk.page.keyboard.press("ArrowRight")
    expect(tabs.nth(1)).to_have_attribute("aria-selected", "true")
    expect(tabs.nth(1)).to_be_focused()


def test_a_language_from_right_to_left_has_the_panel_at_the_left_and_time_and_numbers_as_ever(
    open_page: OpenPage,
) -> None:
    desk = open_page("rope", path="/?lang=ar")
    parts = "panel label number unit play clock"
    names = ["canvas", *(f".softrod-{part}" for part in parts.split())]
    at = desk.page.evaluate(
        """(names) => Object.fromEntries(names.map((name) => {
          const { left, right } = document.querySelector(name).getBoundingClientRect();
          return [name, { left, right }];
        }))""",
        names,
    )
    assert at[".softrod-panel"]["left"] == 0
    assert at["canvas"]["left"] >= at[".softrod-panel"]["right"] - 1
    assert at[".softrod-number"]["right"] <= at[".softrod-unit"]["left"] < at[".softrod-label"]["left"]
    assert at[".softrod-play"]["right"] < at[".softrod-clock"]["left"]


@pytest.mark.parametrize("size", [(1280, 800), (390, 844)])
def test_from_right_to_left_all_that_lies_over_the_canvas_is_mirrored(
    open_page: OpenPage, size: tuple[int, int]
) -> None:
    """But for the bar of time, whose play button and order are those of all languages."""
    phone = size[0] < 600
    names = ["menu-lid", "box-lid", "edit", "hud", "scale", *(["scene", "pad"] if phone else [])]
    found = {}
    for tag in ("en", "ar"):
        desk = open_page("rope", size, phone=phone, path=f"/?lang={tag}")
        desk.tell(commands.Play(False))
        desk.made_room()
        canvas = box_of(desk.page.locator("canvas").first)
        middle = canvas["x"] + canvas["width"] / 2.0
        at = {name: middle_of(desk.page.locator(f".softrod-{name}").first)[0] - middle for name in names}
        found[tag] = {name: side > 0.0 for name, side in at.items()}
        undo = desk.page.locator(".softrod-edit-step svg").first
        turned = undo.evaluate("(svg) => getComputedStyle(svg).scale")
        assert turned == {"en": "none", "ar": "-1 1"}[tag]
        play = desk.page.locator(".softrod-play svg").first
        assert play.evaluate("(svg) => getComputedStyle(svg).scale") == "none"
    assert found["ar"] == {name: not side for name, side in found["en"].items()}


def test_an_axis_has_its_title_in_the_direction_of_its_words(open_page: OpenPage) -> None:
    desk = open_page("rope", path="/?lang=ar")
    desk.page.keyboard.press("g")
    desk.page.locator(".softrod-chart text.softrod-axis").filter(has_text="،").first.wait_for()
    words, unit = desk.page.evaluate(
        """() => {
          const titles = [...document.querySelectorAll(".softrod-chart text.softrod-axis")];
          const text = titles.find((one) => one.textContent.includes("،"));
          return [1, text.textContent.length - 2].map((at) => text.getStartPositionOfChar(at).x);
        }"""
    )
    assert unit < words


def test_what_is_said_or_typed_does_nothing_while_letters_are_no_keys(open_page: OpenPage) -> None:
    desk = open_page()
    desk.changed = True
    opened(desk)
    letters = desk.page.locator("dialog.softrod-access select").nth(1)
    letters.select_option("never")
    desk.page.keyboard.press("Escape")
    desk.page.evaluate("document.activeElement.blur()")
    desk.tell(commands.Play(False))
    desk.until(lambda: "Paused" in desk.page.evaluate(SHOWN), "the page is as it stays")
    desk.rest(2)
    before = desk.page.evaluate(SHOWN), desk.simulation.time, desk.session.scene
    desk.page.keyboard.type(MANY)
    desk.rest(3)
    assert (desk.page.evaluate(SHOWN), desk.simulation.time, desk.session.scene) == before
    # Keys that are no letters go on working, and with the focus on the body letters do if that is wished.
    opened(desk)
    letters = desk.page.locator("dialog.softrod-access select").nth(1)
    letters.select_option("body")
    desk.page.keyboard.press("Escape")
    desk.page.evaluate("document.activeElement.blur()")
    desk.page.keyboard.press("n")
    desk.rest(2)
    assert desk.simulation.time == before[1]
    desk.page.locator(".softrod-body").focus()
    desk.page.keyboard.press("n")
    desk.until(lambda: desk.simulation.time > before[1], "a step")


def test_where_less_motion_is_wished_what_is_opened_stands_until_it_is_played(open_page: OpenPage) -> None:
    desk = open_page("rope")
    desk.changed = True
    desk.page.emulate_media(reduced_motion="reduce")
    desk.page.evaluate("new Promise((done) => setTimeout(done, 100))")
    desk.page.evaluate("sessionStorage.clear(); Storage.prototype.setItem = () => {}")
    desk.open()
    says = desk.page.get_by_text("the body stands until you press Play")
    assert desk.simulation.time == 0.0 and not desk.session.playing
    desk.until(lambda: says.is_visible(), "it says so")
    desk.page.locator(".softrod-play").click()
    desk.until(lambda: desk.simulation.time > 0.0, "it is played")
    desk.until(lambda: not says.is_visible(), "it is no longer said")
    # Another scene stands, too; without that wish it moves at once.
    desk.tell(commands.Open(sim.load_scene("tree")))
    desk.until(lambda: says.is_visible(), "the other body stands")
    assert desk.simulation.time == 0.0
    desk.page.emulate_media(reduced_motion="no-preference")
    desk.until(lambda: not desk.session.stands, "the server knows")
    desk.tell(commands.Open(sim.load_scene("rope")), commands.Play(True))
    desk.until(lambda: desk.simulation.time > 0.0, "it moves")


def test_more_contrast_is_kept_by_the_device(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(1280, 800))
    desk.changed = True
    for look in ("light", "dark"):
        if look == "dark":
            desk.view("Dark")
            desk.until(lambda: desk.tab.probe().looks.dark, "it is dark")
        else:
            opened(desk)
            desk.page.get_by_label("More contrast").check()
            desk.page.keyboard.press("Escape")
            assert desk.page.evaluate("JSON.parse(localStorage['softrod-access']).contrast")
        for tab in ("Play", "Measure", "Solver", "Share"):
            desk.show(tab)
            desk.rest(2)
            assert pale(desk.page, 7.0) == [], (look, tab)


def test_a_line_above_the_canvas_and_the_scale_bar_keep_out_of_each_other_s_way(open_page: OpenPage) -> None:
    desk = open_page("rope", (360, 740), phone=True, path="/?lang=fr")
    desk.tell(commands.Play(False))
    desk.until(lambda: "en pause" in desk.hud(), "nothing comes any more")
    line = "se déplace avec NumPy jusqu’à ce que la méthode soit compilée : 3 parties sur 7 prêtes"
    hud, scale = desk.page.locator(".softrod-hud"), desk.page.locator(".softrod-scale-text")

    hud.evaluate("(hud, line) => hud.insertAdjacentHTML('afterbegin', `${line}<br>`)", line)

    def is_below() -> bool:
        above, below = box_of(hud), box_of(scale)
        return above["y"] + above["height"] <= below["y"] + 1.0

    desk.until(is_below, "the bar is below the line")


def test_a_closed_list_shows_numbers_and_units_in_their_order(open_page: OpenPage) -> None:
    desk = open_page("rope", path="/?lang=ar")
    desk.page.get_by_role("tab").nth(1).click()
    chosen = desk.page.locator(".softrod-panel select:visible option:checked").filter(has_text="10 s").first
    assert chosen.evaluate("(option) => getComputedStyle(option).unicodeBidi") == "plaintext"


def test_the_body_is_described_at_a_key_for_eyes_and_ears(open_page: OpenPage) -> None:
    desk = open_page("rope")
    desk.tell(commands.Play(False))
    desk.page.keyboard.press("d")
    card = desk.page.locator(".softrod-described")
    card.wait_for()
    first = card.locator("p").inner_text()
    assert first.startswith("A chain of 12 masses, with 11 springs and 10 joints.")
    assert desk.page.locator(".softrod-tell").filter(has_text=first).count() == 1
    desk.page.keyboard.press("d")
    desk.until(lambda: "Nothing has changed since." in card.inner_text(), "it says what has changed")
    desk.page.keyboard.press("Escape")
    desk.until(lambda: not card.is_visible(), "Esc closes it")


def test_a_german_page_reads_and_writes_numbers_with_a_comma(open_page: OpenPage) -> None:
    desk = open_page("rope", path="/?lang=de")
    box = desk.page.locator(".softrod-number").first
    for typed, value, shown in (("1,5", 1.5, "1,5"), ("2.5", 2.5, "2,5"), ("1,125", 1.125, "1,125")):
        box.fill(typed)
        box.press("Enter")

        def is_set(value: float = value) -> bool:
            return {joint.rest_angle for joint in desk.session.scene.angular_springs} == {value}

        desk.until(is_set, f"{typed} is read")
        desk.until(lambda shown=shown: box.input_value() == shown, "it is shown so")
