"""One HTML file that shows a body anywhere and without a server.

The file may load nothing and talk to nobody (its policy says so), and runs only the script whose digest it
names. What comes from a scene is text in it, never markup.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import zlib
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

import sim
from sim.scene.types import shown_name

from ..drawing.plan import encode_plan
from ..drawing.shapes import meshes
from ..drawing.sketch import Floats, Sketch
from .window import bounds

_MESHES = ("disc", "ring", "pin", "bar", "slice")


def html_file(
    scene: sim.Scene, body: str, style: str, script: str, data: Mapping[str, object], note: str = ""
) -> bytes:
    """The file, in UTF-8.

    Args:
        scene: whose title and description it begins with.
        body: what follows these, as HTML.
        style, script: of the file; the script is a module.
        data: what the script reads, by the ids of the elements that hold it as JSON.
        note: a sentence before the description.
    """
    assert "</script" not in script.lower()
    title = html.escape(shown_name(scene))
    policy = "; ".join(
        (
            "default-src 'none'",
            f"script-src '{_digest(script)}'",
            f"style-src '{_digest(style)}'",
            "base-uri 'none'",
            "form-action 'none'",
        )
    )
    told = f'<p class="note">{html.escape(note)}</p>\n' if note else ""
    held = "\n".join(
        f'<script type="application/json" id="{id}">{_safe(value)}</script>' for id, value in data.items()
    )
    text = f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="softrod">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<header>
<h1>{title}</h1>
{told}<p>{html.escape(scene.description)}</p>
<p role="alert"></p>
<noscript><p>The motion is shown by a script, which this browser does not run.</p></noscript>
</header>
{body}
{held}
<script type="module">{script}</script>
</body>
</html>
"""
    return text.encode()


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _safe(value: object) -> str:
    """JSON in which nothing ends the element that it stands in."""
    return json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def stage(scene: sim.Scene, places: Floats) -> dict[str, object]:
    """The `Stage` of `static/paint.js`.

    Args:
        scene: what is shown.
        places: (k, 2) px, some of which its masses take up beside the scene's frame.
    """
    sketch = Sketch.plain(scene)
    xmin, ymin, xmax, ymax = scene.view.frame
    return {
        "size": max(xmax - xmin, ymax - ymin),
        "box": bounds(sketch, scene.view.frame, places),
        "springs": sketch.spring_shape,
        "meshes": {
            name: [line.round(4).ravel().tolist() for line in meshes()[name].outlines]
            for name in (*_MESHES, sketch.spring_shape)
        },
    }


def plans(scene: sim.Scene) -> list[NDArray[np.float32]]:
    """The plan of a body on white and on dark paper."""
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    return [encode_plan(0, Sketch.plain(scene, dark), rest) for dark in (False, True)]


def packed(arrays: NDArray[np.float32]) -> str:
    """Arrays as text that a script can unpack."""
    return base64.b64encode(zlib.compress(arrays.tobytes(), 9)).decode()
