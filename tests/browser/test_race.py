"""A race in the page: a rival is chosen, both run after a count-down with the camera, and one is first."""

from __future__ import annotations

import sim
from app.features.race.feature import BeginRace
from app.features.race.rivals import Rivals
from tests.browser.conftest import OpenPage
from tests.browser.driver import box_of


def test_a_worm_races_against_a_walker(open_page: OpenPage) -> None:
    desk = open_page("worm")
    page, session = desk.page, desk.session

    def rival() -> Rivals | None:
        return session.companions.get(Rivals)

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
        # It is rounded twice: to four digits on its way, and to whole pixels in the strip.
        return abs(float(output.inner_text().removesuffix(" px").replace("−", "-")) - theirs) <= 0.6

    desk.until(is_told, "and how far each is")
    page.get_by_role("button", name="Leave").click()
    desk.until(lambda: rival() is None, "the race is over")
    desk.until(lambda: page.locator(".softrod-race").is_hidden(), "so is its strip")
    desk.until(lambda: len(desk.instances("/second/masses")) == 0, "and the rival")


def test_a_race_ends_with_a_sentence_and_race_again_starts_both_over(open_page: OpenPage) -> None:
    desk = open_page("worm")
    page, session = desk.page, desk.session
    session.post(BeginRace((sim.load_scene("worm"),), 8.0))
    desk.until(lambda: page.locator(".softrod-race").is_visible(), "the strip is there")
    rival = session.companions.get(Rivals)
    assert rival is not None
    flag = page.locator(".softrod-finish text").first
    desk.until(lambda: flag.text_content() == "Finish, 8 px", "the finish is on the canvas")
    line = page.locator(".softrod-finish-line").first
    desk.until(
        lambda: abs(box_of(line)["x"] - desk.at([(rival.lines[0], 300.0)])[0, 0]) < 2.0, "it is where it is"
    )
    page.get_by_role("button", name="Play", exact=True).click()
    says, heard = page.locator(".softrod-race-says"), page.locator(".softrod-race .softrod-tell")
    both = "Both at once, after"
    desk.until(lambda: says.inner_text().startswith(both), "both are there")
    assert heard.inner_text() == says.inner_text()
    page.get_by_role("button", name="Race again").click()
    desk.until(lambda: says.inner_text() == "At the start", "both are back")
    assert not any(runner.is_done for runner in rival.runners)
    desk.until(lambda: session.playing, "they run after the count-down")
    desk.until(lambda: says.inner_text().startswith(both), "and are there again")


def test_a_third_body_joins_and_every_one_is_named(open_page: OpenPage) -> None:
    desk = open_page("tutorial-3.3")
    page, session = desk.page, desk.session
    session.post(BeginRace((sim.load_scene("triangle"),), 50.0))
    page.get_by_role("button", name="Add", exact=True).click()
    page.locator('[data-name="ring"] .softrod-open').first.click()
    rows = page.locator(".softrod-race-row b")
    desk.until(lambda: rows.count() == 3, "three are in the strip")
    assert rows.all_inner_texts() == ["Rope (3.3) (yours)", "Triangle", "Ring"]
    rivals = session.companions.get(Rivals)
    assert rivals is not None
    masses = sum(len(scene.masses) for scene in rivals.scenes)
    desk.until(lambda: len(desk.instances("/second/masses")) >= masses - 3, "both are drawn")
    tags = page.locator(".softrod-race-tag:visible")
    desk.until(lambda: tags.all_text_contents() == ["Triangle", "Ring"], "names are over the others")
    for tag, body in zip(tags.all(), rivals.bodies, strict=True):
        box, places = box_of(tag), desk.at(body.positions)
        assert abs(box["x"] + box["width"] / 2.0 - places[:, 0].mean()) < 20.0
        assert -40.0 < box["y"] + box["height"] - places[:, 1].min() < 0.0
    # Wherever one has looked, all are seen at their starts.
    desk.settle()
    seen = desk.camera()
    page.mouse.move(300.0, 200.0)
    page.mouse.wheel(0.0, 3000.0)
    desk.until(lambda: desk.camera().distance > 1.5 * seen.distance, "its user looks from far away")
    page.get_by_role("button", name="Start", exact=True).click()
    desk.until(lambda: desk.camera().distance < 1.2 * seen.distance, "the view goes back to them")
    assert all(desk.uncovered((x, y)) for body in rivals.bodies for x, y in desk.at(body.positions[:1]))
    page.get_by_role("button", name="Leave").click()
    desk.until(lambda: tags.count() == 0, "they go with the race")
