"""The live file in a browser: opened from the disk without a network, dragged, tuned, and by keys alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

import sim
from app.export.live.live import live_html
from app.words import PSEUDO, pseudo, speaking
from tests.app.html_pages import held, plain_of
from tests.browser.conftest import Visits
from tests.browser.driver import Point, until

Open = Callable[..., Page]


@pytest.fixture
def open_file(visit: Visits, tmp_path: Path) -> Iterator[Open]:
    """Opens the live file of a preset, and looks after the test whether it asked for anything."""

    def open_one(name: str, **how: Any) -> Page:
        path = tmp_path / f"{name}.html"
        path.write_bytes(live_html(sim.Simulation(sim.load_scene(name)).capture())[0])
        page = visit(path.as_uri(), **how)
        until(page, lambda: page.evaluate("window.__softrod?.now().body.time > 0"), "the body moves")
        return page

    yield open_one
    assert [path.as_uri() for path in tmp_path.iterdir()] == visit.asked


def place(page: Page, mass: int) -> Point:
    """Where a mass is on the screen."""
    return tuple(  # type: ignore[return-value]
        page.evaluate(
            """(mass) => {
              const { body } = __softrod.now(), on = __softrod.place();
              const { left, top } = document.querySelector("canvas").getBoundingClientRect();
              const { plan } = __softrod;
              const x = (body.positions[2 * mass] - plan().x) * plan().scale;
              const y = (body.positions[2 * mass + 1] - plan().y) * plan().scale * plan().flip;
              return [left + on.x + on.step * x, top + on.y - on.step * y];
            }""",
            mass,
        )
    )


def number(page: Page, what: str) -> float:
    return float(page.evaluate(f"__softrod.now().body.{what}"))


def test_a_mass_is_dragged_and_the_body_follows(open_file: Open) -> None:
    page = open_file("tutorial-3.3")
    x, y = place(page, 0)
    before = number(page, "positions[22]")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 120.0, y + 40.0, steps=8)
    until(page, lambda: abs(place(page, 0)[0] - x - 120.0) < 2.0, "the mass is where the pointer is")
    until(page, lambda: number(page, "positions[22]") > before + 40.0, "its other end follows")
    page.mouse.up()


@pytest.mark.parametrize("by", ["key", "button"])
def test_a_buggy_is_driven(by: str, open_file: Open) -> None:
    page = open_file("buggy")
    x = number(page, "positions[0]")
    page.evaluate("""() => {
      window.strokes = {};
      const { prototype } = CanvasRenderingContext2D, { stroke } = prototype, Path = Path2D;
      window.Path2D = class extends Path { constructor(d) { super(d); this.d = d; } };
      prototype.stroke = function (path) {
        if (path?.d?.includes("A")) strokes[this.globalAlpha] = path.d;
        return stroke.call(this, path);
      };
    }""")
    until(
        page, lambda: page.evaluate("Object.keys(strokes).some((alpha) => alpha < 1)"), "pale arcs are drawn"
    )
    assert not page.evaluate("strokes[1]"), "none of a motor that rests"
    hold(page, "right", by)
    until(page, lambda: number(page, "positions[0]") > x + 30.0, "it drives to the right")
    clockwise = page.evaluate("[...strokes[1].matchAll(/A\\S+ \\S+ 0 1 (\\d)/g)].map(([, way]) => way)")
    assert clockwise == ["1", "1"]
    page.evaluate("__softrod.now().body.motors.forEach((motor) => (motor[1] *= -1))")
    until(
        page,
        lambda: " 0 1 0 " in page.evaluate("strokes[1]"),
        "as a slider may have it, they turn the other way",
    )
    let_go(page, "right")
    until(page, lambda: number(page, "steered[0]") == 0.0, "it is let go")


@pytest.mark.parametrize("by", ["key", "button"])
def test_a_hopper_stretches_and_is_pushed(by: str, open_file: Open) -> None:
    page = open_file("hopper")
    x, y, long = (number(page, name) for name in ("positions[0]", "positions[7]", "stretched[1]"))
    assert long == 1.0
    hold(page, "up", by)
    until(page, lambda: number(page, "positions[7]") < y - 20.0, "its top rises")
    until(page, lambda: 1.49 < number(page, "stretched[1]") <= 1.5, "its legs are as long as they can be")
    let_go(page, "up")
    until(page, lambda: number(page, "stretched[1]") < 1.01, "its legs are as they were")
    hold(page, "right", by)
    until(page, lambda: number(page, "positions[0]") > x + 30.0, "it is pushed to the right")
    let_go(page, "right")


def hold(page: Page, key: str, by: str) -> None:
    """Hold an arrow key, or its button."""
    if by == "key":
        page.keyboard.down(f"Arrow{key.capitalize()}")
        return
    box = page.locator(f"[data-softrod-key={key}]").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 5.0, box["y"] + 5.0)
    page.mouse.down()


def let_go(page: Page, key: str) -> None:
    """Hold it no longer."""
    page.keyboard.up(f"Arrow{key.capitalize()}")
    page.mouse.up()


def test_sliders_keys_and_buttons_do_what_they_say(open_file: Open) -> None:
    page = open_file("tutorial-3.3")
    slider = page.get_by_label("Stretching stiffness")
    slider.focus()
    page.keyboard.press("End")
    assert number(page, "stiffness[3]") == 1e6
    until(page, lambda: "unstable" in page.locator("#numbers").inner_text(), "the limit is told")
    page.keyboard.press("Home")
    assert number(page, "stiffness[3]") == 100.0
    slider.blur()
    page.keyboard.press("r")  # it may have exploded
    page.keyboard.down("ArrowUp")
    until(page, lambda: number(page, "scale") > 1.05, "the springs grow while Up is held")
    page.keyboard.up("ArrowUp")
    page.get_by_role("button", name="Pause").click()
    until(page, lambda: "paused" in page.locator("#hud").inner_text(), "it says so")
    time = number(page, "time")
    page.keyboard.press("n")
    assert number(page, "time") == pytest.approx(time + 0.0025)
    page.get_by_role("button", name="Reset").click()
    assert number(page, "time") < 1.0
    assert number(page, "stiffness[3]") == 100.0  # what was set stays
    assert number(page, "scale") == 1.0


def test_by_keys_alone(open_file: Open) -> None:
    page = open_file("cloth")
    page.keyboard.press("Tab")
    said = page.locator("#says")
    assert "mass 0" in said.inner_text()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    assert "mass 3" in said.inner_text()
    page.keyboard.press("Space")
    before = number(page, "positions[6]")
    for _ in range(4):
        page.keyboard.press("Shift+ArrowRight")
    until(page, lambda: number(page, "positions[6]") > before + 60.0, "the mass goes where it is moved")
    height = place(page, 3)[1]
    for _ in range(4):
        page.keyboard.press("Shift+ArrowUp")
    until(page, lambda: place(page, 3)[1] < height - 20.0, "and up where y grows downwards")
    page.keyboard.press("Space")
    assert "let go" in said.inner_text()


def test_looks_and_the_pointer_that_is_followed_by_keys(open_file: Open) -> None:
    page = open_file("tutorial-3.2")
    paper = "getComputedStyle(document.body).backgroundColor"
    height = "document.querySelector('h1').getBoundingClientRect().height"
    before = page.evaluate(f"[{paper}, {height}]")
    page.keyboard.press("d")
    page.keyboard.press("z")
    dark, larger = page.evaluate(f"[{paper}, {height}]")
    assert (before[0], dark) == ("rgb(255, 255, 255)", "rgb(20, 20, 20)")
    assert larger > 1.3 * before[1]
    page.keyboard.press("z")
    assert page.evaluate(height) == before[1]
    page.keyboard.press("?")
    assert page.get_by_role("dialog").get_by_text("follows the pointer").is_visible()
    page.keyboard.press("Escape")
    page.keyboard.press("f")
    follow = page.get_by_role("button", name="Follow the pointer")
    until(page, lambda: follow.get_attribute("aria-pressed") == "true", "it follows")
    driven = page.evaluate("__softrod.plan().driven")
    x, y = place(page, driven)
    page.mouse.move(x - 90.0, y - 60.0, steps=5)
    until(page, lambda: abs(place(page, driven)[0] - x + 90.0) < 2.0, "the ringed mass is at the pointer")
    page.keyboard.press("f")
    page.mouse.move(x, y, steps=5)
    until(page, lambda: follow.get_attribute("aria-pressed") == "false", "it does not any more")
    assert abs(place(page, driven)[0] - x) > 20.0


def test_by_touch_on_a_phone_and_nothing_lies_over_another(open_file: Open) -> None:
    page = open_file("rope", size=(390, 844), has_touch=True)
    page.get_by_role("button", name="Pause").click()
    # Two fingers, each with a mass.
    fingers = page.context.new_cdp_session(page)
    starts = [place(page, mass) for mass in (3, 11)]

    def touch(kind: str, x: float, y: float) -> None:
        points = [{"x": at[0] + way * x, "y": at[1] + way * y, "id": i} for i, (at, way) in pairs]
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    pairs = list(enumerate(zip(starts, (-1.0, 1.0), strict=True)))
    touch("touchStart", 0.0, 0.0)
    for part in (0.25, 0.5, 0.75, 1.0):
        touch("touchMove", 60.0 * part, -50.0 * part)
    for (_, (start, way)), mass in zip(pairs, (3, 11), strict=True):
        until(
            page,
            lambda mass=mass, start=start, way=way: (
                abs(place(page, mass)[0] - start[0] - way * 60.0) < 4.0
                and abs(place(page, mass)[1] - start[1] + way * 50.0) < 4.0
            ),
            f"mass {mass} follows its finger",
        )
    fingers.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    until(page, lambda: not page.locator("canvas.holds").count(), "nothing is held")
    boxes = [page.locator(what).bounding_box() for what in (".stage", "aside", ".bar")]
    tops = [(box["y"], box["y"] + box["height"]) for box in boxes if box is not None]
    assert len(tops) == 3
    assert all(one[1] <= other[0] + 1.0 for one, other in zip(sorted(tops), sorted(tops)[1:], strict=False))
    assert tops[0][1] - tops[0][0] > 300.0
    assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_the_first_look_stands_where_less_motion_is_wished_and_letters_may_be_no_keys(
    visit: Visits, tmp_path: Path
) -> None:
    path = tmp_path / "rope.html"
    path.write_bytes(live_html(sim.Simulation(sim.load_scene("rope")).capture())[0])
    page = visit(path.as_uri(), reduced_motion="reduce")
    says = page.get_by_text("the body stands until you press Play")
    says.wait_for()
    page.wait_for_timeout(200)
    assert number(page, "time") == 0.0
    page.locator("#view").click()
    page.get_by_role("button", name="Letters as keys").click()
    page.keyboard.press("Escape")
    page.evaluate("document.activeElement.blur()")
    before = page.locator("html").get_attribute("class"), page.locator("body").inner_text()
    page.keyboard.type(15 * "pack my box with five dozen liquor jugs, 0 or 10. Then go on: quit? ")
    assert (page.locator("html").get_attribute("class"), page.locator("body").inner_text()) == before
    assert number(page, "time") == 0.0
    assert not page.evaluate("document.documentElement.hasAttribute('data-dark')")
    page.locator("#play").click()
    until(page, lambda: number(page, "time") > 0.0, "it is played")
    assert says.is_hidden()


def test_a_body_that_runs_away_is_stopped_and_begins_anew(open_file: Open) -> None:
    page = open_file("tutorial-3.3")
    page.get_by_label("Stretching stiffness").focus()
    page.keyboard.press("End")
    x, y = place(page, 0)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 200.0, y, steps=4)
    stopped = page.locator("#stopped")
    until(page, stopped.is_visible, "it explodes, and says so")
    page.mouse.up()
    assert "which the linear springs set" in stopped.inner_text()
    assert page.evaluate("__softrod.now().body.positions.every(Number.isFinite)")
    page.get_by_label("Stretching stiffness").focus()
    page.keyboard.press("Home")
    page.get_by_role("button", name="Go back").click()
    until(page, lambda: not stopped.is_visible(), "it is as it was before")
    time = number(page, "time")
    page.get_by_role("button", name="Play").click()
    until(page, lambda: number(page, "time") > time + 0.1, "it moves again")


def test_a_lesson_runs_what_it_asked_about(visit: Visits, tmp_path: Path) -> None:
    path = tmp_path / "lesson.html"
    path.write_bytes(live_html(sim.Simulation(sim.load_scene("lesson-hooke")).capture())[0])
    page = visit(path.as_uri())
    until(page, lambda: page.evaluate("Boolean(window.__softrod)"), "the file's script has begun")
    hangs, gravity = "__softrod.now().body.positions[3]", "__softrod.now().shown.body.gravity[1]"
    assert (page.evaluate(hangs), page.evaluate(gravity)) == (220.0, 1000.0)
    page.get_by_role("button", name="200 px").click()
    page.get_by_role("button", name="It will be there").click()
    until(page, lambda: page.evaluate(hangs) > 290.0, "it falls further than it would have")
    assert page.evaluate(gravity) == 2000.0
    page.get_by_role("button", name="Check my answer").click()
    page.get_by_role("button", name="Next step").click()
    until(page, lambda: page.evaluate(gravity) == 1000.0, "the next step begins as it says")
    page.get_by_role("button", name="Just as long").click()
    until(page, lambda: page.evaluate(hangs) > 360.0, "the mass is let go from far below")


SHOWN = """() => [...document.querySelectorAll("body *")]
  .filter((one) => !one.matches("script, style, noscript *, output, option, code"))
  .filter((one) => !one.matches(".softrod-close, .softrod-lesson :not(.softrod-line)"))
  .flatMap((one) => [...[...one.childNodes].filter(({ nodeType }) => nodeType === 3).map(({ data }) => data),
    ...["aria-label", "title"].map((name) => one.getAttribute(name) ?? "")])"""
"""What a file shows and says, but for numbers, choices, and what the page's dialogs and lessons show, too."""


def test_a_file_says_all_in_its_language(visit: Visits, tmp_path: Path) -> None:
    path, scene = tmp_path / "lesson.html", sim.load_scene("lesson-hooke")
    with speaking(PSEUDO):
        path.write_bytes(live_html(sim.Simulation(scene).capture())[0])
    page = visit(path.as_uri())
    until(page, lambda: page.evaluate("Boolean(window.__softrod)"), "the file's script has begun")
    about = held(path.read_text(encoding="utf-8"), "about")
    own = {setting["label"] for setting in about["settings"]}
    shown: list[str] = page.evaluate(SHOWN)
    page.locator("#answers summary").click()
    page.get_by_role("button", name=pseudo("200 px")).click()
    page.locator(".softrod-first").first.click()
    until(page, lambda: page.evaluate("__softrod.now().body.time > 1"), "it moves")
    page.keyboard.press("?")
    shown += page.evaluate(SHOWN)
    page.evaluate("__softrod.now().clock.advance(1, 500, [], { factor: 1, angle: 0 })")
    until(page, page.locator("#stopped").is_visible, "it explodes")
    shown += page.evaluate(SHOWN)
    assert set(plain_of(shown)) <= own
    assert len({text for text in shown if "·" in text}) > 40
