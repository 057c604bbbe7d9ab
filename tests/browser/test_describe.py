"""What a screen reader reads of the body: descriptions on demand, and what happens."""

from __future__ import annotations

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import until


def test_d_describes_the_mass_that_keys_chose_and_without_one_the_body(open_page: OpenPage) -> None:
    desk = open_page("rod")
    desk.tell(commands.Play(False))
    card, page = desk.page.locator(".softrod-described p"), desk.page
    page.locator(".softrod-body").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("d")
    until(page, lambda: (card.text_content() or "").startswith("Mass 1, "), "the chosen mass is described")
    page.keyboard.press("Shift+D")
    until(page, lambda: "A chain of" in (card.text_content() or ""), "the body is described")
    spoken = page.locator("main [role=status]").filter(has_text="A chain of")
    until(page, lambda: spoken.count() == 1, "a screen reader reads it")
    page.keyboard.press("Escape")
    assert not card.is_visible()
    page.keyboard.press("d")
    card.wait_for()
    page.get_by_role("button", name="Close the description").focus()
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.className") == "softrod-body", "where it was before"
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("Shift+D")
    until(page, lambda: (card.text_content() or "").endswith("Nothing has changed since."), "the body again")


def test_what_happens_is_said_in_few_words_once_that_is_wished(open_page: OpenPage) -> None:
    desk = open_page()
    page, live = desk.page, desk.page.locator(".softrod-news")
    floor = sim.Wall(point=(300.0, 300.0), normal=(0.0, -1.0), bounciness=0.6, restitution="constant")
    ball = sim.Mass(position=(300.0, -100.0))
    desk.tell(commands.Open(sim.Scene(name="ball", masses=(ball,), gravity=(0.0, 1000.0), walls=(floor,))))
    desk.tell(commands.Play(False))
    desk.rest(2)
    assert live.text_content() == ""
    desk.view("Access and language")
    page.get_by_label("Spoken events").check()
    page.keyboard.press("Escape")
    before = page.locator(".softrod-live").text_content()
    page.keyboard.press("r")
    page.keyboard.press("Space")
    until(page, lambda: live.text_content() == "The body touches the floor.", "it falls on the floor")
    until(page, lambda: (live.text_content() or "").startswith("The body has come to rest."), "it rests")
    page.keyboard.press("Space")
    until(page, lambda: live.text_content() == "Paused.", "it is paused")
    # Nothing else says the same.
    assert page.locator(".softrod-live").text_content() == before
    desk.view("Access and language")
    page.get_by_label("Spoken events").uncheck()
    page.keyboard.press("Escape")
    page.keyboard.press("Space")
    until(page, lambda: page.locator(".softrod-live").text_content() == "Running", "as ever")
    assert live.text_content() == "Paused."


def test_the_body_is_described_without_a_keyboard(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(390, 844), phone=True)
    desk.view("Describe the body")
    card = desk.page.locator(".softrod-described")
    desk.until(lambda: "A chain of 12 masses" in card.inner_text(), "it is described")
    card.get_by_role("button").tap()
    desk.until(card.is_hidden, "and closed")
