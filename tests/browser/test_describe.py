"""What a screen reader reads of the body: descriptions on demand, and what happens."""

from __future__ import annotations

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
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("d")
    until(page, lambda: (card.text_content() or "").endswith("Nothing has changed since."), "the body again")
