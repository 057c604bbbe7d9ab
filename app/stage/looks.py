"""The looks of a body and its surroundings in the page, in pictures, replays and models.

Python uses this module, scripts use `looks.js`, and styles use the variables of `style_rules`. After a change
here, run `python -m app.stage.looks`, which writes `looks.js`; a test fails if it is outdated.
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
"""Colours on white and on dark paper, sRGB. `line` is for every fifth line of the grid, and edges; `brand`
also for the driven mass, a ghost and gas; `second` for a second body."""

TUTORIAL_COLORS = {
    "mass": ("ff2020", "ff2020"),
    "rest": ("40a020", "5cd63c"),
    "pulled": ("e67700", "ffd43b"),
}
"""Other colours of the tutorial's scheme: green springs and red masses; a pulled spring must differ from
both."""


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
"""Layers behind the body, from back to front."""

ARROW = 2.4
"""Width of an arrow's shaft, pixels."""

HEAD = 10.0
"""Largest length of the head of an arrow, pixels."""

SIDE = 4.2
"""Half the width of such a head, pixels."""

DENSE = 5.0
"""Distance of the lines of the grid, pixels, below which only every fifth is drawn."""

HATCH = 13.0
"""Mean distance of the strokes of a wall's hatching, pixels."""

STROKE = 8.0
"""Length of such a stroke along and into the wall, pixels."""

STREAKS = 150.0
"""Mean distance of the streaks of the wind, pixels."""

STREAK = 44.0
"""Length of a streak in the mean wind, pixels."""

PARTS = 8
"""Straight parts of a streak."""

POINT = 4.0
"""Length of the point of a streak, pixels."""

RIPPLES = 90.0
"""Mean distance of the ripples of a medium, pixels."""

RIPPLE = 20.0
"""Length of a ripple, pixels."""

CREST = 2.4
"""Height of its crests, pixels."""

GRAINS = 36.0
"""Mean distance of the grains of the ground, pixels."""

GRAIN = 3.0
"""Length of the longest grain, pixels."""

# ------------------------------------------------------------------------- the body
# Radii, in that of the mass.
FILL = 0.8
SHINE = 0.22
RING = 1.75  # around a driven mass
PIN = 2.0  # of a support
WEDGE = 2.6  # of a joint

FULL_DEVIATION = 30.0
"""Degrees off the rest angle at which a wedge has its full colour."""

WIDEST = 1.2
"""Largest half angle of a triangle of a wedge, radians; beyond it would become a needle."""

THINNEST = 0.5
"""Thickness of the most stretched coil, in that at rest."""

THICKEST = 1.2
"""Thickness of the most squeezed coil, in that at rest."""

YIELDED = 0.002
"""Relative permanent change of rest length from which on a spring counts as yielded, as in the definition of
the proof strength of metals."""

CREASE = 0.34
"""Width of the line along a yielded spring, in that of the spring."""

BELLY = 1.25
"""Width of a muscle along a spring, in that of the spring."""

HALO = 1.7
"""Radius of a muscle around the mass of a joint, in that of the mass."""

BREATH = 0.25
"""Relative change of either with the muscle's wave."""

GHOST_WIDTH = 0.025
"""Width of a ghost's springs, in the world."""

# ------------------------------------------------------------------------- what is shown of the scene
MARGIN = 1.04
"""Room around the scene's frame."""

NEAR = 0.2
"""Distance from the frame within which walls are shown with it, in its size."""

STRIP = 0.05
"""Visible depth of such a wall, in the size of the frame."""

# ------------------------------------------------------------------------- controls
SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0)
"""Speeds to choose from, simulated seconds per second."""

FRACTIONS = {0.125: "⅛", 0.25: "¼", 0.5: "½"}
"""Texts of speeds that are not whole numbers."""

ICONS = {
    "play": "M7 4v16l13-8z",
    "pause": "M6 4h4v16H6zM14 4h4v16h-4z",
    "reset": "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
}
"""Filled outlines of 24 by 24."""

LINK_PATH = PATH
"""End of the path of a link to a scene."""


def style_rules(dark: str) -> str:
    """The colours as variables of CSS, as in --softrod-text, and the layers as classes of SVG.

    Args:
        dark: wraps a rule for dark paper, with * in place of the rule.
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
    """The text of `looks.js`."""
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
