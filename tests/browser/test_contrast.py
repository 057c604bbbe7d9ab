"""All text can be read: contrast of at least 4.5 : 1, or 3 : 1 where it is large (WCAG 2.2, 1.4.3)."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

import sim
from app.session import commands
from sim.edit.edit import Selection
from sim.store import files
from tests.amount import part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SCRIPT = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
CALM = """async () => {
  // A hint, which is not judged, comes and goes for eight seconds.
  const moving = () => document.getAnimations().some(
    ({ playState, effect }) => playState === "running" && effect?.getComputedTiming().iterations !== Infinity
      && !effect?.target?.matches(".softrod-hint"));
  for (let calm = 0; calm < 5; ) {
    await new Promise(requestAnimationFrame);
    calm = moving() ? 0 : calm + 1;
  }
}"""


def judged(desk: Desk) -> list[dict[str, Any]]:
    """Each visible text with its contrast and the least that it needs, when all has faded in."""
    desk.page.evaluate(CALM)
    return desk.page.evaluate(SCRIPT)


def poor(desk: Desk, where: str) -> list[tuple[str, dict[str, Any]]]:
    """The texts that are too pale."""
    found = judged(desk)
    assert len(found) > 8, where
    return [(where, one) for one in found if one["ratio"] < one["needed"]]


def put_on(desk: Desk, look: str) -> None:
    """Have the page look like that; for a projector the colours are the same (`tests/app/test_styles.py`)."""
    if look == "dark":
        desk.view("Dark")
        desk.until(lambda: desk.tab.probe().looks.dark, "it is dark")


def open_view(desk: Desk) -> None:
    desk.button("View").click()


def open_gallery(desk: Desk) -> None:
    """With the buttons of an own scene, and what was done to one."""
    files.save_user_scene(sim.rope(), "mine")
    desk.gallery()
    desk.card("mine").get_by_role("button", name="Delete mine").click()
    desk.page.get_by_role("button", name="Undo").wait_for()


def open_link(desk: Desk) -> None:
    desk.tab.perform("share")
    desk.page.get_by_label("Link to this scene").wait_for()


def open_palette(desk: Desk) -> None:
    desk.page.keyboard.press("Control+k")
    desk.page.get_by_placeholder("Find anything").wait_for()


def run_away(desk: Desk) -> None:
    """A notice, and a way back."""
    changes = (commands.SetValue("angular_stiffness", 1e8), commands.SetValue("rest_angle", 10.0))
    desk.tell(*changes, commands.Play(True))
    desk.until(lambda: desk.notices(), "it runs away")


def open_help(desk: Desk) -> None:
    desk.view("Help")
    desk.page.get_by_role("dialog").wait_for()


PLACES: tuple[tuple[str, Callable[[Desk], None]], ...] = (
    ("Measure", lambda desk: desk.show("Measure")),
    ("Share", lambda desk: desk.show("Share")),
    ("the View menu", open_view),
    ("the gallery", open_gallery),
    ("Play", lambda desk: desk.show("Play")),
    ("Solver", lambda desk: desk.show("Solver")),
    ("a link", open_link),
    ("all commands", open_palette),
    ("help", open_help),
    # Its way back takes the place of the tools.
    ("a notice", run_away),
)
HALVES = [(look, places) for places in (PLACES[:4], PLACES[4:]) for look in ("light", "dark")]


@pytest.mark.parametrize(("look", "places"), part_of(HALVES, 4))
def test_every_text_stands_out(
    open_page: OpenPage, look: str, places: tuple[tuple[str, Callable[[Desk], None]], ...]
) -> None:
    desk = open_page(size=(1280, 760))
    put_on(desk, look)
    desk.page.keyboard.press("g")
    desk.page.locator(".softrod-chart").wait_for()
    pale: list[tuple[str, dict[str, Any]]] = []
    for name, go in places:
        go(desk)
        pale += poor(desk, name)
        desk.page.keyboard.press("Escape")
    assert not pale, pale


@pytest.mark.parametrize("look", part_of(("dark", "light"), 2))
def test_every_text_of_the_tools_stands_out(open_page: OpenPage, look: str, tmp_path: Path) -> None:
    """The strip, with a tool in hand and something to undo; the bar, with a picture's controls; the folder
    of what is selected; the rest angle beside its knob; the question that is asked once; the tuning."""
    desk = open_page(size=(1280, 760))
    put_on(desk, look)
    page = desk.page
    desk.tell(commands.Play(False), commands.SetValue("gravity", 500.0))
    page.keyboard.press("e")
    page.keyboard.press("k")
    desk.tell(commands.Select(lambda *_: Selection(joints=frozenset({4}))))
    page.get_by_text("rests at").wait_for()
    pale = poor(desk, "a joint")
    page.keyboard.press("s")
    page.keyboard.press("Control+a")
    desk.button("Rest as it is now").wait_for()
    Image.new("RGB", (40, 20)).save(tmp_path / "bridge.png")
    page.locator(".softrod-edit-bar input[type=file]").set_input_files(tmp_path / "bridge.png")
    page.locator(".softrod-edit-bar").get_by_role("button", name="Move it").click()
    shown = {one["text"] for one in judged(desk)}
    assert shown >= {"Undo", "Cut", "Triangulate", "Opacity", "Take it away", "Let go", "Radius"}
    pale += poor(desk, "all is selected")
    desk.show("Solver")
    desk.control("Tuning").click()
    desk.button("Critically damp").wait_for()
    desk.until(lambda: "Hz" in page.locator("body").inner_text(), "its numbers are there")
    page.mouse.move(5.0, 300.0)
    tip = page.get_by_text("what the stiffnesses mean: frequencies")
    desk.until(
        lambda: tip.count() == 0, "what the switch does is no longer said, which is pale while it goes"
    )
    pale += poor(desk, "the tuning")
    desk.button("Critically damp").hover()
    pale += poor(desk, "a button under the pointer")
    page.keyboard.press("Alt+ArrowRight")
    page.get_by_role("dialog", name="Moved masses").wait_for()
    pale += poor(desk, "a question")
    assert not pale, pale


def test_pale_text_is_found(open_page: OpenPage) -> None:
    desk = open_page()
    pale = ".softrod-clock { color: #999 !important }"
    desk.page.add_style_tag(content=pale)
    assert [one for _, one in poor(desk, "the page") if one["text"].endswith(" s")]
