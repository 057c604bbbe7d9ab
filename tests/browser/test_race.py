"""A race in the page: a rival is chosen, both run after a count-down, and the camera goes with them."""

from __future__ import annotations

from app.features.race.rival import Rival
from tests.browser.conftest import OpenPage


def test_a_worm_races_against_a_walker(open_page: OpenPage) -> None:
    desk = open_page("worm")
    page, session = desk.page, desk.session

    def rival() -> Rival | None:
        return session.companions.get(Rival)

    assert page.locator(".softrod-race").count() == 0
    page.keyboard.press("a")
    link = page.get_by_label("Link to the scene to race against")
    link.fill("http://softrod.example/s#1.nonsense")
    page.keyboard.press("Enter")
    desk.until(
        lambda: "The link is broken" in page.locator(".softrod-gallery").inner_text(), "it says why not"
    )
    page.locator('[data-name="walker"] .softrod-open').first.click()
    desk.until(lambda: rival() is not None and not session.playing, "both stand at their starts")
    desk.until(lambda: page.locator(".softrod-race").is_visible(), "the strip is there")
    desk.until(lambda: len(desk.instances("/second/masses")) > 30, "the walker is drawn, too")
    assert page.locator(".softrod-gallery").is_hidden()
    assert "Changes of this body" in page.locator(".softrod-race-rule").inner_text()

    def floor() -> float:
        """Where a place of the floor is on the screen."""
        return float(desk.at([(300.0, 500.0)])[0, 0])

    desk.view("Camera goes with the body")
    before = floor()
    page.keyboard.press("a")
    desk.until(lambda: page.locator(".softrod-count").is_visible(), "there is a count-down")
    desk.until(lambda: session.playing, "then both run")
    desk.until(lambda: floor() < before - 5.0, "the camera goes with them")
    assert page.evaluate("sessionStorage['softrod-chase']") == "1", "also after a reload"
    page.keyboard.press("Space")
    desk.until(lambda: not session.playing, "both stand")
    other = rival()
    assert other is not None
    said = page.locator(".softrod-race-says")
    desk.until(lambda: f"after {other.seconds:.1f} s" in said.inner_text(), "it says who is ahead")
    output = page.locator(".softrod-race-theirs output")

    def is_told() -> bool:
        _, theirs = other.ways(session.simulation)
        return abs(float(output.inner_text().removesuffix(" px").replace("−", "-")) - theirs) <= 0.5

    desk.until(is_told, "and how far each is")
    page.get_by_role("button", name="Leave").click()
    desk.until(lambda: rival() is None, "the race is over")
    desk.until(lambda: page.locator(".softrod-race").is_hidden(), "so is its strip")
    desk.until(lambda: len(desk.instances("/second/masses")) == 0, "and the rival")
