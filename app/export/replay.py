"""A replay: one HTML file that shows a clip, anywhere and without a server."""

from __future__ import annotations

import html
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..bundle import bundle, compact_style
from ..stage.looks import BY_SYSTEM, ICONS, style_rules
from ..stage.plan import encode_damage, encode_frame
from ..stage.sketch import Floats
from ..wire.sections import joined
from ..words.english import name_of
from .clip import Clip, ClipFrame
from .html_file import html_file, icon, packed, plans, said, speed_options, stage

RATE = 60.0
"""Frames a second; fewer of a large body."""

MAX_NUMBERS = 1_200_000
"""Coordinates in a file."""

STEPS = 65536
"""Steps, at least, to which coordinates are rounded between the least and the greatest one of a clip."""

_FOLDER = Path(__file__).parent / "static"
_ICONS = {"play": ICONS["play"], "pause": ICONS["pause"], "again": ICONS["reset"]}


def replay_html(clip: Clip) -> bytes:
    """The file, in UTF-8, of at most some 4 MB."""
    scene = clip.scene
    about, data = _described(clip)
    title = name_of(scene)
    style, script = _looks()
    icons = icon(**_ICONS)
    body = f"""<main><canvas id="canvas" role="img" aria-label="{html.escape(title)}"></canvas>
<div class="bar">
<button id="play" type="button" data-icon="play" aria-label="{said("live-play")}">{icons}</button>
<input id="time" type="range" min="0" max="1" step="any" value="0" aria-label="{said("replay-time")}">
<output id="clock" for="time" aria-live="off" translate="no"></output>
<select id="speed" aria-label="{said("live-speed")}">{speed_options()}</select>
</div></main>"""
    return html_file(clip.frames[0], body, style, script, {"about": about, "data": data})


@cache
def _looks() -> tuple[str, str]:
    """The styles and the script."""
    script = bundle(_FOLDER / "replay.js")
    colors = style_rules(BY_SYSTEM)
    return colors + compact_style(_FOLDER / "file.css", _FOLDER / "replay.css"), script


def _described(clip: Clip) -> tuple[dict[str, object], str]:
    """The `About` of `static/replay.js`, and arrays as pages get them: plans, damages, frames."""
    scene = clip.scene
    bodies = 2 if any(frame.picture.ghost is not None for frame in clip.frames) else 1
    interval = 1.0 / RATE
    while clip.count(interval) * 2 * bodies * len(scene.masses) > MAX_NUMBERS and clip.count(interval) > 2:
        interval *= 1.25
    frames = list(clip.at(interval))
    every: dict[int, list[NDArray[np.float32]]] = {}
    damages: dict[int, NDArray[np.float32]] = {}
    for number, (frame, before) in enumerate(zip(frames, [None, *frames], strict=False)):
        if before is None or frame.scene is not before.scene:
            every[number] = plans(frame.scene)
        damage = encode_damage(0, frame.picture)
        if before is None or not np.array_equal(damage, encode_damage(0, before.picture)):
            damages[number] = damage
    about: dict[str, object] = {
        "frames": len(frames),
        "interval": interval,
        **stage(scene, clip.places()),
        "plans": list(every),
        "damages": list(damages),
    }
    arrays = joined(*(plan for both in every.values() for plan in both), *damages.values(), *_encoded(frames))
    return about, packed(arrays)


def _encoded(frames: list[ClipFrame]) -> list[NDArray[np.float32]]:
    """Frames in which positions have no more digits than can be seen, so that they take less when packed."""
    places = np.concatenate([frame.picture.positions for frame in frames])
    quantum = 2.0 ** np.floor(np.log2(max(float(np.ptp(places, axis=0).max()), 1e-9) / STEPS))

    def rounded(positions: Floats) -> Floats:
        return np.round(positions / quantum) * quantum

    arrays = []
    for picture in (frame.picture for frame in frames):
        ghost = None if picture.ghost is None else rounded(picture.ghost)
        rough = replace(picture, positions=rounded(picture.positions), ghost=ghost)
        arrays.append(encode_frame(0, rough))
    return arrays
