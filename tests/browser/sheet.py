"""Makes pictures for the docs from the page itself.

`python -m tests.browser.sheet` makes one of all bodies, with `--motion` one of those with muscles in a beat.
"""

from __future__ import annotations

import argparse
import io
from pathlib import Path
from unittest import mock

import msgspec
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from playwright.sync_api import Browser, sync_playwright

import sim
from app.server.serve import serving
from app.session import commands, framing
from app.session.framing import Bounds
from sim.compiling.compiler import ENTRY_POINTS
from tests.browser.conftest import FLAGS, browser_path
from tests.browser.driver import Desk, Served

DOCS = Path(__file__).resolve().parents[2] / "docs"

TIMES = {
    "rod": 0.3, "ring": 0.6, "triangle": 0.6, "box": 0.6, "octagon": 0.6, "hair-tuft": 0.5, "tree": 3.0,
    "flag-pole": 3.0, "cloth": 0.4, "jelly": 0.62, "air-balloon": 0.75, "water-balloon": 0.75, "pile": 2.0,
    "girder": 1.0, "bridge": 1.0, "worm": 2.0, "walker": 2.3, "swimmer": 1.5, "heart": 0.0, "hand": 1.2,
}  # fmt: skip
"""The presets that are shown, in order, and at which time, s."""

LOADED = {"girder": 110.0}
"""Loads other than the preset's, kg: members have yielded under this one."""

MOVING = ("worm", "walker", "swimmer", "heart", "hand")
"""The presets that are shown in motion, in order."""
SETTLED, ROOM = 2.0, 25.0
"""After how many beats that begins, and px around them."""

COLUMNS, MOMENTS = 5, 6
"""Bodies in a row; or moments of a beat."""
TILE = (250, 190)
"""Room for a body, px."""
LABEL, GAP = 22, 6
"""Height of a name, and room around a tile, px."""

FAINT = 100
"""Difference of a colour from the paper's, summed over its three parts, that no grid and no filling has."""

PAGE = (900, 640)
"""Size of the page, CSS px."""

QUALITY = 82
"""Of the WebP compression, 0 to 100."""

_BARE = """.softrod-hud, .softrod-dock, .softrod-overlay, .softrod-edge, .softrod-box, .softrod-box-lid,
.softrod-edit, .softrod-edit-bar, .softrod-menu, .softrod-notices, .softrod-panel {
  visibility: hidden !important; opacity: 0 !important;
}"""


def tile(desk: Desk, scene: sim.Scene) -> Image.Image:
    """The scene's frame as the page shows it."""
    desk.tell(commands.Play(False), commands.Open(scene))
    desk.until(lambda: desk.session.generation == desk.tab.probe().generation, "the scene is up")
    xmin, ymin, xmax, ymax = scene.view.frame
    desk.settle()

    def drawn() -> Image.Image | None:
        """The page, once the masses that are in view are in it: viser draws when it has the time."""
        desk.page.evaluate("window.__softrod.render()")
        desk.rest(4)
        corners = desk.at([(xmin, ymin), (xmax, ymax)])  # the camera may have been on its way
        (left, top), (right, bottom) = corners.min(0), corners.max(0)
        places = (desk.at(scene.pose.positions if scene.pose else ()) - (left, top)).astype(int)
        clip = {"x": left, "y": top, "width": right - left, "height": bottom - top}
        shot = desk.page.screenshot(style=_BARE, clip=clip)  # type: ignore[arg-type]
        image = Image.open(io.BytesIO(shot)).convert("RGB")
        pixels = np.asarray(image, int)
        seen = [(x, y) for x, y in places if 0 <= x < image.width and 0 <= y < image.height]
        colors = np.array([np.abs(pixels[y, x] - pixels[0, 0]).sum() for x, y in seen])
        return image if (colors > FAINT).mean() > 0.5 else None

    image = desk.until(drawn, "the body is drawn")
    assert image
    image.thumbnail(TILE, Image.Resampling.LANCZOS)
    return image


def frame_of(scene: sim.Scene) -> Bounds:
    """What the view shows here in place of where the body moves: tiles of one body are of one scale."""
    return np.reshape(scene.view.frame, (2, 2))


def at_time(name: str, seconds: float) -> sim.Scene:
    """A preset as it is at a time, s."""
    scene = sim.load_scene(name)
    if name in LOADED:
        scene = sim.set_value(scene, "load", LOADED[name])
    simulation = sim.Simulation(scene)
    simulation.step(round(seconds / simulation.dt))
    beat = simulation.scene.beat
    if beat:  # its time begins anew
        phase = (beat.phase + 360.0 * beat.frequency * simulation.time) % 360.0
        beat = msgspec.structs.replace(beat, phase=phase)
    return msgspec.structs.replace(simulation.scene, pose=simulation.pose(), beat=beat)


def in_beats() -> dict[str, sim.Scene]:
    """What is shown of those in motion, each seen from near in all of its moments."""
    found: dict[str, sim.Scene] = {}
    for name in MOVING:
        beat = sim.load_scene(name).beat
        assert beat
        scenes = [at_time(name, (SETTLED + k / MOMENTS) / beat.frequency) for k in range(MOMENTS)]
        places = np.array([scene.pose.positions for scene in scenes if scene.pose]).reshape(-1, 2)
        low, high = places.min(0) - ROOM, places.max(0) + ROOM
        size = np.maximum(high - low, (high - low)[::-1] * np.array(TILE) / TILE[::-1])
        frame = tuple(map(float, (*(0.5 * (low + high - size)), *(0.5 * (low + high + size)))))
        for k, scene in enumerate(scenes):
            view = msgspec.structs.replace(scene.view, frame=frame)
            label = f"{name}, {k} / {MOMENTS}" if k else name
            found[label] = msgspec.structs.replace(scene, view=view)
    return found


def sheet(browser: Browser, tiles: dict[str, sim.Scene], columns: int, dark: bool) -> Image.Image:
    """All of them, each with its label."""
    width, height = TILE[0] + 2 * GAP, TILE[1] + LABEL + 2 * GAP
    rows = -(-len(tiles) // columns)
    paper, ink = ("#141414", "#cbd5e1") if dark else ("#ffffff", "#334155")
    whole = Image.new("RGB", (columns * width, rows * height), paper)
    draw, font = ImageDraw.Draw(whole), ImageFont.load_default(15)
    with (
        mock.patch.object(framing, "motion_bounds", frame_of),
        serving(sim.load_scene("rod"), "127.0.0.1", 0) as (server, ticker, compiler),
    ):
        compiler.want(ENTRY_POINTS)
        compiler.start()
        compiler.wait()
        context = browser.new_context(viewport={"width": PAGE[0], "height": PAGE[1]}, device_scale_factor=1)
        desk = Desk(Served(f"http://127.0.0.1:{server.get_port()}", ticker), context)
        desk.open()
        if dark:
            desk.tab.perform("dark")
        for i, (label, scene) in enumerate(tiles.items()):
            image = tile(desk, scene)
            x, y = i % columns * width, i // columns * height
            whole.paste(image, (x + (width - image.width) // 2, y + GAP + (TILE[1] - image.height) // 2))
            draw.text((x + width // 2, y + height - GAP), label, ink, font, anchor="md")
        context.close()
    return whole


def main() -> None:
    """Make the picture and write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--motion", action="store_true", help="bodies with muscles in a beat")
    parser.add_argument("--out", type=Path, help="where the picture is written")
    parser.add_argument("--dark", action="store_true", help="on a dark page")
    arguments = parser.parse_args()
    moves = arguments.motion
    tiles = in_beats() if moves else {name: at_time(name, seconds) for name, seconds in TIMES.items()}
    out: Path = arguments.out or DOCS / ("muscles.webp" if moves else "bodies.webp")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=browser_path(playwright.chromium), args=list(FLAGS)
        )
        image = sheet(browser, tiles, MOMENTS if moves else COLUMNS, arguments.dark)
        browser.close()
    image.save(out, quality=QUALITY, method=6)
    print(f"{out}: {image.width} x {image.height}, {out.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
