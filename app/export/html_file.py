"""One HTML file that shows a body anywhere and without a server.

Its content security policy lets the file load nothing and connect to nobody, and run only the scripts whose
digests it names. What comes from a scene is text in it, never markup.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from urllib.parse import quote

import numpy as np
from numpy.typing import NDArray

import sim

from ..stage.looks import FRACTIONS, SPEEDS, used_rules
from ..stage.plan import encode_plan
from ..stage.shapes import meshes
from ..stage.sketch import Floats, Sketch
from ..words import element, language, say, way_of
from ..words.english import name_of, of
from ..words.keys import Key
from .clip import ClipFrame
from .picture import webp
from .window import bounds

_MESHES = ("disc", "ring", "pin", "bar", "slice")

_PICTURE = (480, 300)
"""Pixels of the picture that a file shows where scripts do not run."""

_PLAIN = "body>:not(header),#bar button{display:none !important}noscript img{max-width:100%;height:auto}"
"""Style of a file where scripts do not run, as in a phone's preview: nothing that would not answer."""

_FASTEST = 2.0
"""The largest speed of a file's clock, s/s."""


@dataclass(frozen=True)
class Bar:
    """What stands over the title of a file and leads to others.

    Attributes:
        html: of the bar.
        style: of what is in it.
        script: a module that runs before the file's own.
    """

    html: str
    style: str
    script: str


def html_file(
    frame: ClipFrame,
    body: str,
    style: str,
    script: str,
    data: Mapping[str, object],
    note: str = "",
    early: str = "",
    bar: Bar | None = None,
) -> bytes:
    """The file, in UTF-8.

    Args:
        frame: the scene, whose title and description the file begins with, and the moment that is seen where
            scripts do not run.
        body: what follows these, as HTML.
        style, script: of the file; the script is a module.
        data: what the script reads, by the ids of the elements that hold it as JSON.
        note: a sentence before the description.
        early: a script that is no module and runs before anything is shown.
        bar: what leads to other files, for one that is not alone.
    """
    scene = frame.scene
    title = html.escape(name_of(scene))
    width, height = _PICTURE
    picture = f"data:image/webp;base64,{base64.b64encode(webp(frame, _PICTURE)).decode()}"
    noted = f'<p class="note">{html.escape(note)}</p>\n' if note else ""
    over = f"\n{bar.html}" if bar else ""
    header = f"""<header>{over}
<h1>{title}</h1>
{noted}<p>{html.escape(of(scene.description))}</p>
<p role="alert"></p>
<noscript><p>{said("live-picture")}</p>
<img src="{picture}" width="{width}" height="{height}" alt="{title}"></noscript>
</header>"""
    styles, scripts = ([style, bar.style], [bar.script, script]) if bar else ([style], [script])
    return document(
        name_of(scene),
        f"{header}\n{body}",
        styles,
        scripts,
        data,
        early,
        plain=_PLAIN,
        of_site=bar is not None,
    )


def document(
    title: str,
    body: str,
    styles: Sequence[str],
    scripts: Sequence[str],
    data: Mapping[str, object],
    early: str = "",
    images: str = "data:",
    plain: str = "",
    of_site: bool = False,
) -> bytes:
    """A file that loads nothing but images from where it may, in UTF-8, in the language that is spoken now.

    Args:
        title: shown as text.
        body: as HTML.
        styles, scripts: the scripts are modules.
        data: as for `html_file`.
        early: a script that is no module and runs before anything is shown.
        images: from where it may load images, as its policy has it.
        plain: a style where scripts do not run.
        of_site: whether it may be installed with the site that it belongs to.
    """
    every = [early, *scripts] if early else list(scripts)
    assert not any("</script" in script.lower() for script in every)
    styles = used_rules(styles, "\n".join((body, *every)))
    policy = "; ".join(
        (
            "default-src 'none'",
            f"script-src {' '.join(map(_digest, every))}",
            f"style-src {' '.join(map(_digest, [*styles, plain]))}",
            f"img-src {images}",
            "base-uri 'none'",
            "form-action 'none'",
            *(("manifest-src 'self'", "worker-src 'self'") if of_site else ()),
        )
    )
    head = "\n".join(
        ([f"<script>{early}</script>"] if early else [])
        + [f"<style>{style}</style>" for style in styles]
        + [f"<noscript><style>{plain}</style></noscript>"]
    )
    held = [
        f'<script type="application/json" id="{id}">{_safe(value)}</script>' for id, value in data.items()
    ]
    words = filter(None, [element("\n".join(scripts), language())])
    end = "\n".join([*words, *held] + [f'<script type="module">{script}</script>' for script in scripts])
    text = f"""<!doctype html>
<html {way_of(language())}>
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="softrod">
<title>{html.escape(title)}</title>
<link rel="icon" href="{_favicon()}">
{head}
</head>
<body>
{body}
{end}
</body>
</html>
"""
    return text.encode()


def said(key: Key) -> str:
    """A text as HTML."""
    return html.escape(say(key))


def speed_options() -> str:
    """The options of a list of speeds, up to what a browser computes in time."""
    return "".join(
        f'<option value="{speed:g}"{" selected" * (speed == 1)}>{FRACTIONS.get(speed, int(speed))}×</option>'
        for speed in SPEEDS
        if speed <= _FASTEST
    )


def icon(**paths: str) -> str:
    """An icon of outlines in 24 by 24, each with its name as its class."""
    found = "".join(f'<path class="{name}" d="{path}"/>' for name, path in paths.items())
    return f'<svg viewBox="0 0 24 24" aria-hidden="true">{found}</svg>'


@cache
def _favicon() -> str:
    """The page's icon in an address of its own: a browser would ask a file's server for one otherwise."""
    svg = (Path(__file__).parents[1] / "pages" / "sandbox" / "icon.svg").read_text(encoding="utf-8")
    return f"data:image/svg+xml,{quote(' '.join(svg.split()), safe=' /:=')}"


def _digest(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def _safe(value: object) -> str:
    """JSON in which nothing ends the element that it stands in."""
    return json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def stage(scene: sim.Scene, places: Floats) -> dict[str, object]:
    """The `Stage` of `static/paint.js`.

    Args:
        scene: what is shown.
        places: (k, 2) px, where its masses are, which may be beyond the scene's frame.
    """
    sketch = Sketch.plain(scene)
    xmin, ymin, xmax, ymax = scene.view.frame
    return {
        "size": max(xmax - xmin, ymax - ymin),
        "box": bounds(sketch, scene.view.frame, places),
        "springs": sketch.spring_shape,
        "meshes": {
            name: [line.round(4).ravel().tolist() for line in meshes()[name].outlines]
            for name in (*_MESHES, sketch.spring_shape, *(["belly"] if len(sketch.muscles) else []))
        },
    }


def plans(scene: sim.Scene) -> list[NDArray[np.float32]]:
    """The plan of a body on white and on dark paper."""
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    return [encode_plan(0, Sketch.plain(scene, dark), rest) for dark in (False, True)]


def packed(arrays: NDArray[np.float32]) -> str:
    """Arrays as text that a script can unpack."""
    return base64.b64encode(zlib.compress(arrays.tobytes(), 9)).decode()
