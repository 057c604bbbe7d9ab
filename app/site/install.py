"""What has a browser keep a gallery and install it: a manifest, its icons, and a service worker."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

from PIL import Image, ImageDraw

from ..bundle import bundle
from ..stage.looks import COLORS
from ..words import direction, language, say
from .folder import INDEX

MANIFEST, WORKER = "manifest.json", "offline.js"
ICONS = {f"icon-{size}.png": size for size in (192, 512)}
"""The icons by their names, with the pixels of their sides."""

_STATIC = Path(__file__).parent / "static"
_ICON = Path(__file__).parents[1] / "pages" / "sandbox" / "icon.svg"
_FINER = 4
"""By what an icon is drawn larger, so that its edges are smooth."""
_PART = 0.62
"""Part of the side that has the drawing: systems cut icons to circles."""


def manifest(title: str) -> bytes:
    """The manifest of a gallery, in the language that is spoken now."""
    paper = f"#{COLORS['paper'][0]}"
    told = {
        "name": title,
        "short_name": "softrod",
        "description": say("site-about"),
        "lang": language(),
        "dir": direction(),
        "start_url": INDEX,
        "scope": "./",
        "display": "standalone",
        "theme_color": paper,
        "background_color": paper,
        "icons": [
            {"src": file, "sizes": f"{size}x{size}", "type": "image/png", "purpose": "any maskable"}
            for file, size in ICONS.items()
        ],
    }
    return json.dumps(told, ensure_ascii=False, indent=1).encode()


def worker(digests: Mapping[str, str]) -> bytes:
    """The service worker of the files that have these digests, by their paths."""
    return f"self.FILES={json.dumps(digests)};\n{bundle(_STATIC / WORKER)}\n".encode()


def icon(size: int) -> bytes:
    """The page's icon on paper, as PNG."""
    side = _FINER * size
    image = Image.new("RGB", (side, side), f"#{COLORS['paper'][0]}")
    draw = ImageDraw.Draw(image)
    root = ElementTree.fromstring(_ICON.read_text(encoding="utf-8"))
    scale = _PART * side / float(root.attrib["viewBox"].split()[2])
    edge = (1.0 - _PART) * side / 2.0

    def disc(x: float, y: float, radius: float, color: str) -> None:
        box = [edge + scale * place for place in (x - radius, y - radius, x + radius, y + radius)]
        draw.ellipse(box, fill=color)

    for part in root:
        told = part.attrib
        stroke, width = told.get("stroke", ""), float(told.get("stroke-width", 0.0))
        if part.tag.endswith("circle"):
            x, y, radius = (float(told[name]) for name in ("cx", "cy", "r"))
            if stroke:
                disc(x, y, radius + width / 2.0, stroke)
            disc(x, y, radius - width / 2.0 if stroke else radius, told["fill"])
        else:
            numbers = [float(number) for number in re.findall(r"[\d.]+", told["d"])]
            line = [edge + scale * number for number in numbers]
            draw.line(line, stroke, round(scale * width), joint="curve")
    found = io.BytesIO()
    image.resize((size, size), Image.Resampling.LANCZOS).save(found, "PNG", optimize=True)
    return found.getvalue()
