"""Makes the picture of all bodies in the docs from the page itself: `python -m tests.browser.sheet`."""

from __future__ import annotations

import argparse
import io
from pathlib import Path

import msgspec
from PIL import Image, ImageDraw, ImageFont
from playwright.sync_api import Browser, sync_playwright

import sim
from app.server.serve import serving
from app.session import commands
from tests.browser.conftest import FLAGS, browser_path
from tests.browser.driver import Desk, Served

OUT = Path(__file__).resolve().parents[2] / "docs" / "bodies.webp"

TIMES = {
    "rod": 0.3, "ring": 0.6, "triangle": 0.6, "box": 0.6, "octagon": 0.6, "hair-tuft": 0.5, "tree": 3.0,
    "flag-pole": 3.0, "cloth": 0.4, "jelly": 0.62, "air-balloon": 0.75, "water-balloon": 0.75, "pile": 2.0,
    "girder": 1.0, "bridge": 1.0,
}  # fmt: skip
"""The presets that are shown, in order, and at which time, s."""

LOADED = {"girder": 110.0}
"""Loads other than the preset's, kg: members have yielded under this one."""

COLUMNS = 5
TILE = (250, 190)
"""Room for a body, px."""
LABEL, GAP = 22, 6
"""Height of a name, and room around a tile, px."""

PAGE = (900, 640)
"""Size of the page, CSS px."""

QUALITY = 82
"""Of the WebP compression, 0 to 100."""

_BARE = """.softrod-hud, .softrod-dock, .softrod-overlay, .softrod-edge, .mantine-Notification-root {
  visibility: hidden !important; opacity: 0 !important;
}"""


def tile(desk: Desk, name: str, seconds: float) -> Image.Image:
    """The scene's frame as the page shows it at that time."""
    scene = sim.load_scene(name)
    if name in LOADED:
        scene = sim.set_value(scene, "load", LOADED[name])
    simulation = sim.Simulation(scene)
    simulation.step(round(seconds / simulation.dt))
    scene = msgspec.structs.replace(simulation.scene, pose=simulation.pose())
    desk.tell(commands.Play(False), commands.Open(scene))
    desk.until(lambda: desk.session.generation == desk.tab._generation, "the scene is up")
    desk.wait_drawn()
    desk.rest(4)
    xmin, ymin, xmax, ymax = scene.view.frame
    corners = desk.at([(xmin, ymin), (xmax, ymax)])
    (left, top), (right, bottom) = corners.min(0), corners.max(0)
    shot = desk.page.screenshot(
        style=_BARE, clip={"x": left, "y": top, "width": right - left, "height": bottom - top}
    )
    image = Image.open(io.BytesIO(shot)).convert("RGB")
    image.thumbnail(TILE, Image.Resampling.LANCZOS)
    return image


def sheet(browser: Browser, dark: bool) -> Image.Image:
    """All of them, each with its name."""
    width, height = TILE[0] + 2 * GAP, TILE[1] + LABEL + 2 * GAP
    rows = -(-len(TIMES) // COLUMNS)
    paper, ink = ("#141414", "#cbd5e1") if dark else ("#ffffff", "#334155")
    whole = Image.new("RGB", (COLUMNS * width, rows * height), paper)
    draw, font = ImageDraw.Draw(whole), ImageFont.load_default(15)
    with serving(sim.load_scene("rod"), "127.0.0.1", 0) as (server, ticker, compiler):
        compiler.start()
        compiler.wait()
        context = browser.new_context(viewport={"width": PAGE[0], "height": PAGE[1]}, device_scale_factor=1)
        desk = Desk(Served(f"http://127.0.0.1:{server.get_port()}", ticker), context)
        desk.open()
        if dark:
            desk.tab.perform("dark")
        for i, (name, seconds) in enumerate(TIMES.items()):
            image = tile(desk, name, seconds)
            x, y = i % COLUMNS * width, i // COLUMNS * height
            whole.paste(image, (x + (width - image.width) // 2, y + GAP + (TILE[1] - image.height) // 2))
            draw.text((x + width // 2, y + height - GAP), name, ink, font, anchor="md")
        context.close()
    return whole


def main() -> None:
    """Make the picture and write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=OUT, help="where the picture is written")
    parser.add_argument("--dark", action="store_true", help="on a dark page")
    arguments = parser.parse_args()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=browser_path(playwright), args=list(FLAGS))
        image = sheet(browser, arguments.dark)
        browser.close()
    image.save(arguments.out, quality=QUALITY, method=6)
    print(f"{arguments.out}: {image.width} x {image.height}, {arguments.out.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
