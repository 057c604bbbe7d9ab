"""How everything looks that is drawn of a body, in the page, in pictures, replays and models.

Python reads this module, scripts read `static/looks.js`, and styles read the variables of `style_rules`.
After a change here, `python -m app.stage.looks` writes `static/looks.js` anew; a test says when it is old.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from sim.kernels.core.waves import SHARPNESS as SHARPNESS
from sim.store.link import PATH

# ------------------------------------------------------------------------- colours
COLORS = {
    "paper": ("ffffff", "141414"),
    "grid": ("eef1f5", "1c2028"),
    "line": ("dde3ea", "272d38"),
    "ink": ("1e293b", "05070b"),
    "text": ("334155", "cbd5e1"),
    "brand": ("4263eb", "748ffc"),
    "on-brand": ("ffffff", "0b1020"),
    "key": ("f6f8fb", "1a2230"),
    "warn": ("c2410c", "ff922b"),
    "mass": ("fbbf24", "ffc947"),
    "held": ("475569", "94a3b8"),
    "rest": ("8592a6", "8b98ab"),
    "pulled": ("e8352b", "ff6b5e"),
    "pushed": ("1971c2", "4dabf7"),
    "torque-plus": ("f08c00", "ffa94d"),
    "torque-minus": ("8e44ad", "cc8ee8"),
    "liquid": ("1c8fe0", "1c8fe0"),
    "muscle": ("e0457b", "ff7aa8"),
    "force": ("c2185b", "ff7eb6"),
    "velocity": ("00796b", "3ce0c4"),
    "torque": ("7c4a03", "ffe066"),
    "second": ("0ca678", "38d9a9"),
}
"""Each on white and on dark paper, sRGB. `line` is of every fifth line of the grid, and of edges; `brand`
also of the driven mass, a ghost and gas; `second` of a second body."""

TUTORIAL_COLORS = {
    "mass": ("ff2020", "ff2020"),
    "rest": ("40a020", "5cd63c"),
    "pulled": ("e67700", "ffd43b"),
}
"""Instead, in the tutorial's scheme: green springs and red masses; a pulled spring must differ from both."""


# ------------------------------------------------------------------------- behind the body
@dataclass(frozen=True)
class Layer:
    """How lines or areas are drawn.

    Attributes:
        color: name of its colour.
        opacity: from 0 to 1.
        width: pixels of a line; 0 for an area that is filled, None where what is drawn has its own.
        round: whether lines end in half circles.
    """

    color: str
    opacity: float = 1.0
    width: float | None = 0.0
    round: bool = False


LAYERS = {
    "grid": Layer("grid", width=1.0),
    "major": Layer("line", width=1.0),
    "medium": Layer("liquid", 0.1),
    "ripple": Layer("liquid", 0.45, width=1.3, round=True),
    "ground": Layer("text", 0.07),
    "grain": Layer("text", 0.4, width=1.6, round=True),
    "wall": Layer("text", 0.1),
    "hatch": Layer("text", 0.55, width=1.2),
    "surface": Layer("text", width=2.0),
    "skin": Layer("text", 0.13, width=None, round=True),
    "gas": Layer("brand", 0.12),
    "liquid": Layer("liquid", 0.35),
    "wind": Layer("text", 0.35, width=1.4, round=True),
}
"""What is behind the body, from the back to the front."""

ARROW = 2.4
"""Width of an arrow's shaft, pixels."""

HEAD, SIDE = 10.0, 4.2
"""Pixels of the head of an arrow at most, along and to either side."""

DENSE = 5.0
"""Pixels between two lines of the grid below which it has only every fifth."""

HATCH, STROKE = 13.0, 8.0
"""Pixels between two strokes of the hatching of a wall, about, and their reach along and into the wall."""

STREAKS, STREAK, PARTS, POINT = 150.0, 44.0, 8, 4.0
"""Pixels between two streaks of the wind, about; the length of one in the mean wind, its straight parts, and
pixels of its point."""

RIPPLES, RIPPLE, CREST = 90.0, 20.0, 2.4
"""Pixels between two ripples of a medium, about; the length of one, and the height of its crests."""

GRAINS, GRAIN = 36.0, 3.0
"""Pixels between two grains of the ground, about, and the length of the longest."""

# ------------------------------------------------------------------------- the body
FILL, SHINE, RING, PIN, WEDGE = 0.8, 0.22, 1.75, 2.0, 2.6
"""Radii in those of the mass: of its fill and its shine, of the ring around a driven one, of a support, and
of the wedge of a joint."""

FULL_DEVIATION = 30.0
"""Degrees off the rest angle at which a wedge has its full colour."""

WIDEST = 1.2
"""Radians beyond which half a wedge's triangle would become a needle."""

THINNEST, THICKEST = 0.5, 1.2
"""Of a coil as it is stretched and squeezed, in its thickness at rest."""

YIELDED = 0.002
"""Part of its rest length by which that of a spring has moved for good once it has yielded, as the proof
strength of metals is defined."""

CREASE = 0.34
"""Width of the line along a spring that has yielded, in that of the spring."""

BELLY, HALO, BREATH = 1.25, 1.7, 0.25
"""Of muscles: the width of a belly along a spring, in that of the spring; the radius of a halo around the
mass of a joint, in that of the mass; and by how much either grows and shrinks."""

GHOST_WIDTH = 0.025
"""Width of a ghost's springs, in the world."""

# ------------------------------------------------------------------------- what is shown of the scene
MARGIN = 1.04
"""Room around the scene's frame."""

NEAR, STRIP = 0.2, 0.05
"""How near to the frame a wall is shown with it, and how deep, as parts of its size."""

# ------------------------------------------------------------------------- controls
SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0)
"""Speeds to choose from, in that of the clock."""

FRACTIONS = {0.125: "⅛", 0.25: "¼", 0.5: "½"}
"""How speeds are written that are no whole numbers."""

ICONS = {
    "play": "M7 4v16l13-8z",
    "pause": "M6 4h4v16H6zM14 4h4v16h-4z",
    "reset": "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
}
"""Filled outlines of 24 by 24."""

LINK_PATH = PATH
"""How the path of a link to a scene ends."""


def style_rules(dark: str) -> str:
    """The colours as variables of CSS, as in --softrod-text, and the layers as classes of SVG.

    Args:
        dark: what makes a rule hold on dark paper, with * in place of the rule.
    """
    light, night = (
        ":root{" + ";".join(f"--softrod-{name}:#{pair[k]}" for name, pair in COLORS.items()) + "}"
        for k in (0, 1)
    )
    arrow = f":root{{--softrod-arrow-width:{ARROW:g}px}}"
    return "\n".join((light, dark.replace("*", night), arrow, *map(_layer_rule, LAYERS)))


def _layer_rule(name: str) -> str:
    layer = LAYERS[name]
    color = f"var(--softrod-{layer.color})"
    if layer.width == 0.0:
        return f".softrod-{name}{{fill:{color};fill-opacity:{layer.opacity:g};stroke:none}}"
    width = "" if layer.width is None else f";stroke-width:{layer.width:g}px"
    ends = ";stroke-linecap:round" if layer.round else ""
    return f".softrod-{name}{{stroke:{color};opacity:{layer.opacity:g}{width}{ends}}}"


def script() -> str:
    """The text of `static/looks.js`."""
    lines = [
        "// @ts-check",
        "/** Written by `python -m app.stage.looks`; app/stage/looks.py says what each is. */",
    ]
    for name, value in globals().items():
        if name.isupper() and name not in ("COLORS", "TUTORIAL_COLORS", "PATH"):
            lines.append(f"export const {name} = {_text(value)};")
    return "\n".join((*lines, ""))


def _text(value: object) -> str:
    if isinstance(value, dict):
        rows = (f"  {json.dumps(str(key))}: {_text(one)},\n" for key, one in value.items())
        return f"{{\n{''.join(rows)}}}"
    return json.dumps(value, default=asdict, ensure_ascii=False)


if __name__ == "__main__":
    Path(__file__).with_name("looks.js").write_text(script(), encoding="utf-8")
