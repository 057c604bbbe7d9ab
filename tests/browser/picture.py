"""Makes the animated picture of the README from the page itself: `python -m tests.browser.picture`.

The page's simulation goes by a clock that is advanced here, one frame of the picture at a time, so that the
motion is smooth and the same on a machine of any speed. Everything else is as a user has it: the pointer
drags the ringed mass, and the arrow keys curl the rope and straighten it again.
"""

from __future__ import annotations

import argparse
import io
import math
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from unittest import mock

import msgspec
from PIL import Image
from playwright.sync_api import Browser, sync_playwright

import sim
from app.pages.sandbox import tab
from app.server.serve import serving
from app.session.pacing import LONGEST_FRAME
from app.session.session import FRAME, Session
from sim.compiling.compiler import ENTRY_POINTS
from tests.browser.conftest import FLAGS, browser_path
from tests.browser.driver import Desk, Point, Served

OUT = Path(__file__).resolve().parents[2] / "docs" / "softrod.webp"

SCENE = "tutorial-3.3"

PAGE = (960, 600)
"""Size of the page, CSS px: small enough for its texts to be read in the picture."""

SIZE = (768, 480)
"""Size of the picture, px."""

FRAMES = 72
"""Frames of the picture, which is a loop."""

TICKS = 3
"""Frames of the page, 1/60 s each, for one frame of the picture."""

LOOPS_BEFORE = 2
"""Loops that are not recorded. The rope starts from rest; with these keys its motion repeats to within 4 px
after two loops. With keys at other times it can take longer, or never repeat."""

SWINGS = 2
"""How often the pointer swings in one loop; about as fast as the rope swings by itself."""

REGION = (75.0, 60.0, 525.0, 510.0)
"""The part of the scene that the page shows, px: closer than the scene's own."""

REACH = 70.0
"""How far the pointer swings to either side, px of the scene."""

KEYS = {12: ("right", "→"), 44: ("left", "←")}
"""Frames of the picture from which on an arrow key is held, `HELD` frames each."""

HELD = 18

QUALITY = 75
"""Of the WebP compression, 0 to 100."""

_INPUTS = """() => {
  const arrow = document.createElement("div");
  arrow.id = "picture-pointer";
  arrow.style.cssText = "position:fixed;left:0;top:0;z-index:1000;pointer-events:none";
  arrow.innerHTML = `<svg width="22" height="30" viewBox="0 0 22 30"><path fill="#111" stroke="#fff"
    stroke-width="1.6" d="M2 2v21l5-4.6 3.3 7.8 3.6-1.5-3.3-7.6h7z"/></svg>`;
  document.body.append(arrow);
  const key = document.createElement("div");
  key.id = "picture-key";
  key.style.cssText = "position:fixed;left:24px;bottom:24px;width:56px;height:56px;border-radius:10px;" +
    "border:2px solid #5b6475;background:#f4f6fa;color:#2b3445;font:600 26px/52px system-ui,sans-serif;" +
    "text-align:center;z-index:1000;pointer-events:none;visibility:hidden";
  document.body.append(key);
  addEventListener("pointermove", event => {
    arrow.style.transform = `translate(${event.clientX - 2}px, ${event.clientY - 2}px)`;
  }, true);
}"""
"""A screenshot shows neither the pointer nor the key that is held: this draws them."""

_SHOW_KEY = """text => {
  const key = document.getElementById("picture-key");
  key.textContent = text;
  key.style.visibility = text ? "visible" : "hidden";
}"""


class Clock:
    """Time for the page's simulation, s."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        """The time."""
        return self.now


class Unhurried(Session):
    """A session whose frames take all the computing that they need, so that no machine is too slow."""

    def tick(self, budget: float, longest: float = LONGEST_FRAME) -> None:
        """See `Session.tick`."""
        super().tick(math.inf, longest)


class Film:
    """The page in motion.

    Args:
        desk: the page.
        clock: that of its simulation.
    """

    def __init__(self, desk: Desk, clock: Clock) -> None:
        self._desk, self._clock = desk, clock
        self._page = desk.page
        self._start = desk.place(0)
        self._reach = desk.at([(REACH, 0.0)])[0, 0] - desk.at([(0.0, 0.0)])[0, 0]
        desk.page.evaluate(_INPUTS)
        desk.take(self._start)

    def _pointer(self, part: float) -> Point:
        """Where the pointer is after a part of the loop."""
        x, y = self._start
        return x + self._reach * math.sin(2.0 * math.pi * SWINGS * part), y

    def _hold(self, key: str, sign: str, down: bool) -> None:
        """Press or release an arrow key, and wait until the simulation has it."""
        keyboard, name = self._page.keyboard, f"Arrow{key.title()}"
        if down:
            keyboard.down(name)
        else:
            keyboard.up(name)
        self._page.evaluate(_SHOW_KEY, sign if down else "")
        self._desk.until(
            lambda: (key in self._desk.session.simulation.keys) == down, f"{name} arrives in the simulation"
        )

    def loop(self) -> Iterator[None]:
        """Go once round; after each frame of the picture the page shows it."""
        for frame in range(FRAMES):
            for start, (key, sign) in KEYS.items():
                if frame in (start, start + HELD):
                    self._hold(key, sign, down=frame == start)
            for tick in range(TICKS):
                self._page.mouse.move(*self._pointer((frame + (tick + 1) / TICKS) / FRAMES))
                self._desk.rest(2)
                self._advance()
            self._desk.wait_drawn()
            yield

    def _advance(self) -> None:
        """Let the time of one frame pass."""
        session, before = self._desk.session, self._desk.simulation.time
        self._clock.now += FRAME
        self._desk.until(
            lambda: session.simulation.time > before + 0.5 * FRAME, "the simulation takes its steps"
        )

    def shot(self) -> Image.Image:
        """The page as it is, in the size of the picture."""
        image = Image.open(io.BytesIO(self._page.screenshot())).convert("RGB")
        return image.resize(SIZE, Image.Resampling.LANCZOS)


def record(browser: Browser) -> list[Image.Image]:
    """The frames of the picture."""
    clock = Clock()
    scene = sim.load_scene(SCENE)
    scene = msgspec.structs.replace(scene, view=msgspec.structs.replace(scene.view, frame=REGION))
    with (
        mock.patch.object(tab, "Session", partial(Unhurried, clock=clock)),
        serving(scene, "127.0.0.1", 0) as (server, ticker, compiler),
    ):
        compiler.want(ENTRY_POINTS)
        compiler.start()
        compiler.wait()  # or the page would say what is being compiled
        context = browser.new_context(viewport={"width": PAGE[0], "height": PAGE[1]})
        desk = Desk(Served(f"http://127.0.0.1:{server.get_port()}", ticker), context)
        desk.open()
        film = Film(desk, clock)
        for _ in range(LOOPS_BEFORE):
            for _ in film.loop():
                pass
        frames = [film.shot() for _ in film.loop()]
        context.close()
    return frames


def main() -> None:
    """Record the picture and write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=OUT, help="where the picture is written")
    parser.add_argument("--frames", type=Path, help="a folder for the frames, as PNG files")
    arguments = parser.parse_args()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=browser_path(playwright.chromium), args=list(FLAGS)
        )
        frames = record(browser)
        browser.close()
    milliseconds = round(1000 * TICKS * FRAME)
    first, *others = frames
    first.save(
        arguments.out, save_all=True, append_images=others, duration=milliseconds, loop=0,
        quality=QUALITY, method=6, minimize_size=True,
    )  # fmt: skip
    if arguments.frames is not None:
        arguments.frames.mkdir(parents=True, exist_ok=True)
        for i, frame in enumerate(frames):
            frame.save(arguments.frames / f"{i:03}.png")
    print(f"{arguments.out}: {len(frames)} frames, {arguments.out.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
