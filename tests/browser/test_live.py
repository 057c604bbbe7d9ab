"""The live file in a browser: opened from the disk without a network, dragged, tuned, and by keys alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, ViewportSize

import sim
from app.export.live.live import live_html
from tests.browser.driver import Point, until

Open = Callable[..., Page]


@pytest.fixture
def open_file(browser: Browser, tmp_path: Path) -> Iterator[Open]:
    """Opens the live file of a preset, and looks after the test whether it asked for anything."""
    asked: list[str] = []
    errors: list[str] = []
    contexts = []

    def open_one(name: str, size: tuple[int, int] = (880, 580), has_touch: bool = False) -> Page:
        path = tmp_path / f"{name}.html"
        path.write_bytes(live_html(sim.Simulation(sim.load_scene(name)).capture())[0])
        viewport: ViewportSize = {"width": size[0], "height": size[1]}
        context = browser.new_context(viewport=viewport, offline=True, has_touch=has_touch)
        contexts.append(context)
        page = context.new_page()
        page.on("request", lambda request: asked.append(request.url))
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda message: errors.append(message.text))
        page.goto(path.as_uri())
        until(page, lambda: page.evaluate("window.__softrod?.now().body.time > 0"), "the body moves")
        return page

    yield open_one
    for context in contexts:
        context.close()
    assert not errors
    assert [url for url in asked if not url.startswith("file:")] == []
    assert len(asked) == len(contexts)


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


def test_sliders_keys_and_buttons_do_what_they_say(open_file: Open) -> None:
    page = open_file("tutorial-3.3")
    slider = page.get_by_label("Linear stiffness")
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
    page.keyboard.press("Space")
    assert "let go" in said.inner_text()


def test_by_touch_on_a_phone_and_nothing_lies_over_another(open_file: Open) -> None:
    page = open_file("rope", size=(390, 844), has_touch=True)
    page.get_by_role("button", name="Pause").click()
    x, y = place(page, 11)
    touch = {"pointerType": "touch", "pointerId": 5, "isPrimary": True, "bubbles": True, "cancelable": True}
    canvas = page.locator("canvas")
    # What a finger does; a capture needs a real one.
    page.evaluate("HTMLCanvasElement.prototype.setPointerCapture = () => {}")
    canvas.dispatch_event("pointerdown", {**touch, "clientX": x + 10.0, "clientY": y + 10.0})
    canvas.dispatch_event("pointermove", {**touch, "clientX": x + 80.0, "clientY": y - 60.0})
    until(page, lambda: abs(place(page, 11)[0] - x - 80.0) < 4.0, "the mass follows the finger")
    canvas.dispatch_event("pointerup", {**touch, "clientX": x + 80.0, "clientY": y - 60.0})
    boxes = [page.locator(what).bounding_box() for what in (".stage", "aside", ".bar")]
    tops = [(box["y"], box["y"] + box["height"]) for box in boxes if box is not None]
    assert len(tops) == 3
    assert all(one[1] <= other[0] + 1.0 for one, other in zip(sorted(tops), sorted(tops)[1:], strict=False))
    assert tops[0][1] - tops[0][0] > 300.0
    assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_a_body_that_runs_away_is_stopped_and_begins_anew(open_file: Open) -> None:
    page = open_file("tutorial-3.3")
    page.get_by_label("Linear stiffness").focus()
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
    page.get_by_label("Linear stiffness").focus()
    page.keyboard.press("Home")
    page.get_by_role("button", name="Go back").click()
    until(page, lambda: not stopped.is_visible(), "it is as it was before")
    time = number(page, "time")
    page.get_by_role("button", name="Play").click()
    until(page, lambda: number(page, "time") > time + 0.1, "it moves again")
