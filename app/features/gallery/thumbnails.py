"""The small pictures of the gallery. `python -m app.features.gallery.thumbnails` makes those of the presets.

They are stored among the page's files, with the digest of the scene file that each was made from.
"""

from __future__ import annotations

import hashlib
import io
from pathlib import Path

import msgspec
import numpy as np

import sim
from sim.store.files import built_in_files, read_scene, write_atomically

from ...export.painter import Painter
from ...stage.plan import Picture
from ...stage.sketch import Floats

FOLDER = Path(__file__).parent / "thumbnails"
SIZE = (264, 176)
"""Pixels of a picture."""

ROOM = 1.3
"""Sides of what is shown, in sides of the body."""

LEAST = 0.4
"""Smallest sides of what is shown, in sides of the scene's frame."""

AFTER = 0.6
"""Simulated seconds after which a preset has its picture taken: most have left their first pose by then."""

MADE = frozenset(path.stem for path in FOLDER.glob("*.webp"))
"""Names of the pictures; those on dark paper end with -dark."""

DIGESTS = FOLDER / "made-from.json"


def picture(scene: sim.Scene, dark: bool, shown: Picture | None = None) -> bytes:
    """A picture of a scene, WebP.

    Args:
        scene: what is shown.
        dark: whether on dark paper.
        shown: the moment that is shown; the scene's start unless given.
    """
    shown = shown or Picture.at_start(scene)
    view = msgspec.structs.replace(scene.view, frame=_frame(scene, shown.positions))
    painter = Painter(msgspec.structs.replace(scene, view=view), SIZE, dark, grid=False)
    stream = io.BytesIO()
    painter.paint(shown).save(stream, "WEBP", quality=80, method=6)
    return stream.getvalue()


def _frame(scene: sim.Scene, positions: Floats) -> tuple[float, float, float, float]:
    """The part of a scene that has its body, and room around it; all of the scene's frame if it has walls."""
    left, top, right, bottom = scene.view.frame
    if scene.walls:
        return scene.view.frame
    low, high = positions.min(axis=0), positions.max(axis=0)
    least = LEAST * np.array((right - left, bottom - top))
    half = np.maximum(ROOM * (high - low), least) / 2.0
    (x0, y0), (x1, y1) = (low + high) / 2.0 - half, (low + high) / 2.0 + half
    return float(x0), float(y0), float(x1), float(y1)


def digests() -> dict[str, str]:
    """Names of the presets, and what their files have now."""
    return {path.stem: hashlib.sha256(path.read_bytes()).hexdigest()[:16] for path in built_in_files()}


def file_name(name: str, dark: bool) -> str:
    """The file of a preset's picture."""
    return f"{name}-dark.webp" if dark else f"{name}.webp"


def write() -> None:
    """Make the pictures of presets whose files have changed, and delete those of presets that are gone."""
    FOLDER.mkdir(exist_ok=True)
    wanted = digests()
    known = msgspec.json.decode(DIGESTS.read_bytes(), type=dict[str, str]) if DIGESTS.exists() else {}
    for path in built_in_files():
        name = path.stem
        files = [FOLDER / file_name(name, dark) for dark in (False, True)]
        if known.get(name) == wanted[name] and all(file.exists() for file in files):
            continue
        scene = read_scene(path)
        simulation = sim.Simulation(scene)
        simulation.advance(AFTER)
        for dark, file in zip((False, True), files, strict=True):
            write_atomically(file, picture(scene, dark, Picture.of(simulation)))
        print(f"{name}: made")
    names = {file_name(name, dark) for name in wanted for dark in (False, True)}
    for file in FOLDER.glob("*.webp"):
        if file.name not in names:
            file.unlink()
    write_atomically(DIGESTS, msgspec.json.format(msgspec.json.encode(wanted)) + b"\n")


if __name__ == "__main__":
    write()
