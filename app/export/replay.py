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
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

import sim
from sim.scene.types import shown_name

from ..drawing.looks import FRACTIONS, ICONS, SPEEDS, style_rules
from ..drawing.plan import encode_damage, encode_plan
from ..drawing.sketch import Sketch
from .bundle import bundle
from .clip import Clip, Shot
from .outlines import outlines
from .window import MARGIN, bounds

RATE = 60.0
"""Frames a second; fewer of a large body."""

MOST_NUMBERS = 1_500_000
"""Coordinates in a file, two bytes each before they are packed."""

STEPS = 65535
"""Steps of a coordinate between the least and the greatest of a clip."""

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


class _Store:
    """Arrays one after the other, each at a multiple of four bytes."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def add(self, array: NDArray[np.float32] | NDArray[np.uint8]) -> tuple[int, int]:
        """Where it begins, and how many numbers it has."""
        at = len(self._bytes)
        self._bytes += np.ascontiguousarray(array).tobytes()
        self._bytes += bytes(-len(self._bytes) % 4)
        return at, array.size

    def packed(self) -> str:
        return base64.b64encode(zlib.compress(bytes(self._bytes), 9)).decode()


def _described(clip: Clip) -> tuple[dict[str, object], str]:
    """What the script is told, see static/replay.js, and the arrays."""
    store, scene = _Store(), clip.scene
    masses = len(scene.masses)
    second = any(shot.picture.ghost is not None for shot in clip.shots)
    numbers = masses * (4 if second else 2)
    interval = 1.0 / RATE
    while clip.count(interval) * numbers > MOST_NUMBERS and clip.count(interval) > 2:
        interval *= 1.25
    shots = list(clip.at(interval))
    rows = np.array([_row(shot, second) for shot in shots])
    least, quantum, differences = _quantised(rows)
    sketch = Sketch.plain(scene)
    meshes = (*_MESHES, sketch.spring_shape)
    xmin, ymin, xmax, ymax = scene.view.frame
    left, right, low, high = bounds(sketch, scene.view.frame, clip.places())
    middle, half = ((left + right) / 2.0, (low + high) / 2.0), MARGIN / 2.0
    heads = [
        (p.rest_length_scale, p.rest_angle_shift, p.ghost is not None) for p in (s.picture for s in shots)
    ]
    about = {
        "frames": len(shots),
        "interval": interval,
        "start": shots[0].picture.time,
        "numbers": numbers,
        "masses": masses,
        "size": max(xmax - xmin, ymax - ymin),
        "box": [
            middle[0] - half * (right - left),
            middle[0] + half * (right - left),
            middle[1] - half * (high - low),
            middle[1] + half * (high - low),
        ],
        "least": least,
        "quantum": quantum,
        "springs": sketch.spring_shape,
        "meshes": {mesh: [line.round(4).ravel().tolist() for line in outlines(mesh)] for mesh in meshes},
        "plans": _plans(shots, store),
        "damages": _damages(shots, store),
        "heads": store.add(_floats(heads)),
        "low": store.add((differences & 0xFF).astype(np.uint8)),
        "high": store.add((differences >> 8).astype(np.uint8)),
    }
    return about, store.packed()


def _floats(values: ArrayLike) -> NDArray[np.float32]:
    return np.asarray(values, np.float32)


def _row(shot: Shot, second: bool) -> NDArray[np.float64]:
    """(k,) coordinates of a moment; a second body that is not there lies where the first one does."""
    positions, ghost = shot.picture.positions, shot.picture.ghost
    if not second:
        return positions.ravel()
    return np.concatenate((positions.ravel(), (positions if ghost is None else ghost).ravel()))


def _quantised(rows: NDArray[np.float64]) -> tuple[list[float], list[float], NDArray[np.uint16]]:
    """Least x and y, px, px of a step, and (k, frames) differences from frame to frame, modulo 65536."""
    least = [float(rows[:, axis::2].min()) for axis in (0, 1)]
    most = [float(rows[:, axis::2].max()) for axis in (0, 1)]
    quantum = [max(high - low, 1e-9) / STEPS for low, high in zip(least, most, strict=True)]
    axes = rows.shape[1] // 2
    steps = np.rint((rows - np.tile(least, axes)) / np.tile(quantum, axes)).astype(np.int64)
    differences = np.diff(steps, axis=0, prepend=0) % 65536
    return least, quantum, differences.astype(np.uint16).T


def _plans(shots: list[Shot], store: _Store) -> list[dict[str, object]]:
    """Of each scene, in the order of the frames, its plans on white and on dark paper."""
    found: list[dict[str, object]] = []
    scene: sim.Scene | None = None
    for number, shot in enumerate(shots):
        if shot.scene is scene:
            continue
        scene = shot.scene
        rest = np.array([joint.rest_angle for joint in scene.angular_springs])
        light, dark = (store.add(encode_plan(0, Sketch.plain(scene, night), rest)) for night in (False, True))
        found.append({"from": number, "light": light, "dark": dark})
    return found


def _damages(shots: list[Shot], store: _Store) -> list[dict[str, object]]:
    """Each change of what has yielded and broken."""
    found: list[dict[str, object]] = []
    last: NDArray[np.float32] | None = None
    for number, shot in enumerate(shots):
        damage = encode_damage(0, shot.picture)
        if last is None or not np.array_equal(damage, last):
            found.append({"from": number, "at": store.add(damage)})
            last = damage
    return found
