"""What is taken home: a picture of the page, a film, a model, and a replay that plays without a server."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
from msgspec.structs import replace
from PIL import Image

import sim
from app.export.clip import Clip
from app.export.replay import replay_html
from app.session import commands
from app.stage.colors import palette
from tests.app.clips import swing
from tests.browser.conftest import OpenPage, Visits
from tests.browser.driver import Desk, until

_LAYER = """() => {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("class", "softrod-overlay softrod-of-the-test");
  svg.innerHTML = '<rect class="softrod-square" x="60" y="300" width="20" height="20"/>';
  document.body.append(svg);
  const style = document.createElement("style");
  style.textContent = ".softrod-square { fill: rgb(1 200 30); stroke: none; transform: translate(40px, 0) }";
  document.head.append(style);
}"""


def download(desk: Desk, button: str) -> tuple[str, bytes]:
    """Press a button of the Share tab, and return the file's name and content."""
    with desk.page.expect_download() as started:
        desk.button(button).click()
    return started.value.suggested_filename, Path(started.value.path()).read_bytes()


def test_a_picture_has_the_body_and_all_that_lies_under_and_over_it(open_page: OpenPage) -> None:
    desk = open_page("water-balloon", pixels=True)
    desk.tell(commands.DoSteps(150))
    desk.wait_drawn()
    desk.page.evaluate(_LAYER)
    with desk.page.expect_download() as started:
        desk.page.keyboard.press("i")
    assert started.value.suggested_filename == "Water balloon.png"
    image = np.asarray(Image.open(started.value.path()).convert("RGB")).astype(float)
    box = desk.page.evaluate(
        "(({ width, height }) => [width, height])(__softrod.canvas().getBoundingClientRect())"
    )
    assert image.shape[:2] == (2 * box[1], 2 * box[0])

    def at(x: float, y: float) -> np.ndarray:
        return image[round(2 * y), round(2 * x)]

    # The discs, by WebGL, where the solver has them.
    colors = palette("softrod", dark=False)
    places = desk.at(desk.simulation.positions).tolist()
    off = [np.abs(at(x, y) - colors.mass).max() for x, y in places]
    # The mark of the joint that is read out lies over one or two of them.
    assert sum(value > 40.0 for value in off) <= 2
    # A mark of somebody else, dressed by a style sheet and moved by it.
    assert at(110.0, 310.0).tolist() == [1, 200, 30]
    assert (at(70.0, 310.0) != (1, 200, 30)).any()
    # Liquid under the body, and the floor below.
    x, y = desk.at([desk.simulation.positions.mean(0)])[0]
    patch = image[round(2 * y) - 20 : round(2 * y) + 20, round(2 * x) - 20 : round(2 * x) + 20].reshape(-1, 3)
    assert np.abs(np.median(patch, axis=0) - (175.0, 216.0, 244.0)).max() < 8.0
    floor = np.median(image[-30:-4].reshape(-1, 3), axis=0)
    assert np.abs(floor - (234.0, 235.0, 237.0)).max() < 4.0
    # The scale bar's text and the title are there: ink in both upper corners.
    assert image[20:70, 20:200].min() < 90.0
    assert image[10:80, -240:-30].min() < 90.0
    # And the page goes on.
    desk.tell(commands.DoSteps(50))
    desk.wait_drawn()


def test_each_button_gives_its_file_and_what_it_cannot_do_is_told(open_page: OpenPage) -> None:
    """What is in the files is tested in `tests/app`."""
    desk = open_page("ring")
    desk.until(lambda: desk.simulation.time > 0.5, "some time passes")
    desk.tell(commands.Play(False))
    desk.wait_drawn()
    desk.show("Share")
    for button, wanted, begins in (
        ("Save a log", "ring-log.jsonl", b'{"format":"softrod-log"'),
        ("GIF", "ring.gif", b"GIF89a"),
        ("3D model", "ring.glb", b"glTF"),
        ("Animated model", "ring.motion.glb", b"glTF"),
        ("Replay file", "ring.html", b"<!doctype html>"),
        ("Picture", "Ring.png", b"\x89PNG"),
        ("CSV", "ring.zip", b"PK"),
        ("C", "ring.c.zip", b"PK"),
        ("JavaScript", "ring.js", b"//"),
    ):
        name, data = download(desk, button)
        assert (name, data[: len(begins)]) == (wanted, begins)
    # What the page shows is in the last frame, or after it.
    name, data = download(desk, "Keyframes")
    assert name == "ring.motion.csv"
    rows = np.loadtxt(io.BytesIO(data), delimiter=",", skiprows=1)
    steps = np.abs(np.diff(rows[-3:, 1:], axis=0)).max()
    assert np.abs(rows[-1, 1:].reshape(-1, 2) - desk.simulation.positions).max() < 2.0 * steps
    name, data = download(desk, "JSON")
    assert json.loads(data)["masses"]["position"] == desk.simulation.positions.tolist()
    name, data = download(desk, "Python")
    compile(data, name, "exec")
    desk.until(lambda: "It steps by symplectic Euler" in str(desk.notices()), "it says what is another in it")
    desk.tell(commands.Reset())
    desk.button("GIF").click()
    desk.until(lambda: "press Play" in str(desk.notices()), "there is no past to show")


def test_a_replay_plays_from_a_file_without_a_network(visit: Visits, tmp_path: Path) -> None:
    evil = "</script><script>window.evil = 1</script><img src=x onerror='window.evil = 1'>"
    scene = replace(sim.rope(masses=5, length=200.0), title=evil)
    shots = swing(scene, 1.25)
    path = tmp_path / "replay.html"
    path.write_bytes(replay_html(Clip(shots)))
    page = visit(path.as_uri(), (600, 500), color_scheme="dark")
    page.wait_for_function("window.__softrod !== undefined")
    # It plays by itself, and ends in the pose in which the clip ends.
    until(page, lambda: page.evaluate("__softrod.shown().time > 2.3"), "it plays")
    until(page, lambda: not page.evaluate("__softrod.playing()"), "it has ended")
    assert page.locator("#clock").inner_text() == "3.25 s"
    ended = np.array(page.evaluate("Array.from(__softrod.shown().positions)")).reshape(-1, 2)
    assert np.abs(ended - shots[-1].picture.positions).max() < 0.01
    # Keys, buttons, the slider and the speed.
    page.keyboard.press("Home")
    until(page, lambda: page.evaluate("__softrod.shown().time === 2"), "the beginning")
    page.keyboard.press("ArrowRight")
    until(
        page, lambda: abs(page.evaluate("__softrod.shown().time") - 2.1) < 1e-6, "a tenth of a second later"
    )
    page.locator("#time").fill("0.5")
    until(page, lambda: page.locator("#clock").inner_text() == "2.50 s", "where the slider is")
    assert not page.evaluate("__softrod.playing()")
    page.locator("#speed").select_option("2")
    page.get_by_role("button", name="Play").click()
    until(page, lambda: page.locator("#clock").inner_text() == "3.25 s", "it goes on to the end")
    page.get_by_role("button", name="Play again").wait_for()
    # Dark paper, and the yellow of a mass where the first one stands.
    image = np.asarray(Image.open(io.BytesIO(page.locator("canvas").screenshot())).convert("RGB")).astype(int)
    assert np.median(image.reshape(-1, 3), axis=0).max() < 45
    yellow = (np.abs(image - palette("softrod", dark=True).mass).max(2) < 12).sum()
    assert yellow > 30
    # Nothing of the title was markup, and nothing was fetched.
    assert page.evaluate("window.evil") is None
    assert page.title() == evil
    assert page.locator("h1").inner_text() == evil
    assert visit.asked == [path.as_uri()]
