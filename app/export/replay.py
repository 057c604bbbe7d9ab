"""A replay: one HTML file that shows a clip, anywhere and without a server.

The file may load nothing and talk to nobody (its policy says so), and runs only the script whose digest it
names. What comes from a scene is text in it, never markup.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import zlib
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import sim
from sim.scene.types import shown_name

from ..drawing.looks import FRACTIONS, ICONS, SPEEDS, style_rules
from ..drawing.plan import encode_damage, encode_frame, encode_plan, joined
from ..drawing.shapes import meshes
from ..drawing.sketch import Floats, Sketch
from .bundle import bundle
from .clip import Clip, Shot
from .window import bounds

RATE = 60.0
"""Frames a second; fewer of a large body."""

MOST_NUMBERS = 1_200_000
"""Coordinates in a file."""

STEPS = 65536
"""To how many steps at least positions are kept between the least and the greatest coordinate of a clip."""

_FOLDER = Path(__file__).parent / "static"
_MESHES = ("disc", "ring", "pin", "bar", "slice")
_ICONS = {"play": ICONS["play"], "pause": ICONS["pause"], "again": ICONS["reset"]}
_FASTEST = 2.0


def replay_html(clip: Clip) -> bytes:
    """The file, in UTF-8, of at most some 4 MB."""
    scene = clip.scene
    about, data = _described(clip)
    title = shown_name(scene)
    style, script = _looks()
    policy = "; ".join(
        (
            "default-src 'none'",
            f"script-src '{_digest(script)}'",
            f"style-src '{_digest(style)}'",
            "base-uri 'none'",
            "form-action 'none'",
        )
    )
    icons = "".join(f'<path class="{name}" d="{path}"/>' for name, path in _ICONS.items())
    speeds = "".join(
        f'<option value="{speed:g}"{" selected" * (speed == 1)}>{FRACTIONS.get(speed, int(speed))}×</option>'
        for speed in SPEEDS
        if speed <= _FASTEST
    )
    text = f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="softrod">
<title>{html.escape(title)}</title>
<style>{style}</style>
</head>
<body>
<header>
<h1>{html.escape(title)}</h1>
<p>{html.escape(scene.description)}</p>
<p role="alert"></p>
<noscript><p>The motion is shown by a script, which this browser does not run.</p></noscript>
</header>
<canvas id="canvas" role="img" aria-label="{html.escape(title)}"></canvas>
<div class="bar">
<button id="play" type="button" data-icon="play" aria-label="Play">
<svg viewBox="0 0 24 24" aria-hidden="true">{icons}</svg></button>
<input id="time" type="range" min="0" max="1" step="any" value="0" aria-label="Time shown">
<output id="clock" for="time"></output>
<select id="speed" aria-label="Speed">{speeds}</select>
</div>
<script type="application/json" id="about">{_safe(about)}</script>
<script type="application/json" id="data">{_safe(data)}</script>
<script type="module">{script}</script>
</body>
</html>
"""
    return text.encode()


@cache
def _looks() -> tuple[str, str]:
    """The styles and the script."""
    script = bundle(_FOLDER / "replay.js")
    assert "</script" not in script.lower()
    colors = style_rules("@media (prefers-color-scheme: dark){*}")
    return colors + (_FOLDER / "replay.css").read_text(encoding="utf-8"), script


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _safe(value: object) -> str:
    """JSON in which nothing ends the element that it stands in."""
    return json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def _described(clip: Clip) -> tuple[dict[str, object], str]:
    """What the script is told, see static/replay.js, and arrays as pages get them: plans, damages, frames."""
    scene = clip.scene
    bodies = 2 if any(shot.picture.ghost is not None for shot in clip.shots) else 1
    interval = 1.0 / RATE
    while clip.count(interval) * 2 * bodies * len(scene.masses) > MOST_NUMBERS and clip.count(interval) > 2:
        interval *= 1.25
    shots = list(clip.at(interval))
    plans: dict[int, list[NDArray[np.float32]]] = {}
    damages: dict[int, NDArray[np.float32]] = {}
    for number, (shot, before) in enumerate(zip(shots, [None, *shots], strict=False)):
        if before is None or shot.scene is not before.scene:
            plans[number] = _plans(shot.scene)
        damage = encode_damage(0, shot.picture)
        if before is None or not np.array_equal(damage, encode_damage(0, before.picture)):
            damages[number] = damage
    sketch = Sketch.plain(scene)
    shapes = {
        name: [line.round(4).ravel().tolist() for line in meshes()[name].outlines]
        for name in (*_MESHES, sketch.spring_shape)
    }
    xmin, ymin, xmax, ymax = scene.view.frame
    about = {
        "frames": len(shots),
        "interval": interval,
        "size": max(xmax - xmin, ymax - ymin),
        "box": bounds(sketch, scene.view.frame, clip.places()),
        "springs": sketch.spring_shape,
        "meshes": shapes,
        "plans": list(plans),
        "damages": list(damages),
    }
    arrays = joined(*(plan for both in plans.values() for plan in both), *damages.values(), *_frames(shots))
    return about, base64.b64encode(zlib.compress(arrays.tobytes(), 9)).decode()


def _plans(scene: sim.Scene) -> list[NDArray[np.float32]]:
    """The plan of a body on white and on dark paper."""
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    return [encode_plan(0, Sketch.plain(scene, dark), rest) for dark in (False, True)]


def _frames(shots: list[Shot]) -> list[NDArray[np.float32]]:
    """Frames in which positions have no more digits than can be seen, so that they take less when packed."""
    places = np.concatenate([shot.picture.positions for shot in shots])
    quantum = 2.0 ** np.floor(np.log2(max(float(np.ptp(places, axis=0).max()), 1e-9) / STEPS))

    def rounded(positions: Floats) -> Floats:
        return np.round(positions / quantum) * quantum

    frames = []
    for picture in (shot.picture for shot in shots):
        ghost = None if picture.ghost is None else rounded(picture.ghost)
        rough = replace(picture, positions=rounded(picture.positions), ghost=ghost)
        frames.append(encode_frame(0, rough))
    return frames
