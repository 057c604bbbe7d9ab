"""The looks of a body and its surroundings in the page, in pictures, replays and models.

Python uses this module, scripts use `looks.js`, and styles use the variables of `style_rules`. After a change
here, run `python -m app.stage.looks`, which writes `looks.js`; a test fails if it is outdated.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from sim.engine.numerics.waves import SHARPNESS as SHARPNESS
from sim.store.link import PATH

from ..bundle import compact_style

# ------------------------------------------------------------------------- colours
COLORS = {
    "paper": ("ffffff", "141414"),
    "panel": ("ffffff", "1a1e25"),
    "float": ("ffffff", "20252e"),
    "key": ("f3f6fa", "252b35"),
    "key-over": ("e8edf4", "303846"),
    "grid": ("eef1f5", "1f232b"),
    "line": ("dde3ea", "2e3642"),
    "edge": ("7c899d", "7686a0"),
    "ink": ("1e293b", "05070b"),
    "text": ("334155", "dbe2ec"),
    "strong": ("1e293b", "f3f6fa"),
    "quiet": ("56647a", "a3afc0"),
    "brand": ("4263eb", "8098ff"),
    "brand-over": ("3552d6", "98acff"),
    "brand-word": ("3552d6", "9fb1ff"),
    "brand-soft": ("e9edfd", "2a3355"),
    "on-brand": ("ffffff", "0b1020"),
    "good": ("1f7a3d", "5fd38d"),
    "good-bar": ("2b954e", "3fb56e"),
    "good-soft": ("e6f4ea", "16301f"),
    "warn": ("b93f0b", "ffa463"),
    "warn-soft": ("fdf0e7", "37251a"),
    "bad": ("c92a2a", "ff8f8f"),
    "call": ("7a4f00", "ffd479"),
    "call-soft": ("fff4d6", "3a2f16"),
    "call-edge": ("b7791f", "c8922f"),
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
"""Colours on white and on dark paper, sRGB.

Surfaces from the paper up: `paper` is the canvas, `panel`, `key` a button and `key-over` one under the
pointer, `float` a bar, a menu or a dialog. `line` divides, and is every fifth line of the grid; `edge` bounds
what is pressed. `brand` means: press or drag this; also the driven mass, a ghost and gas. `good`, `warn` and
`bad` judge, always with a word or a sign too; `call` is a raised hand. `second` is a second body."""

TUTORIAL_COLORS = {
    "mass": ("ff2020", "ff2020"),
    "rest": ("40a020", "5cd63c"),
    "pulled": ("e67700", "ffd43b"),
}
"""Other colours of the tutorial's scheme: green springs and red masses; a pulled spring must differ from
both."""

SHADES = {
    "veil": ("rgb(15 23 42 / 42%)", "rgb(0 0 0 / 60%)"),
    "qr": ("#fff", "#fff"),
    "sheet": ("#fff", "#fff"),
    "sheet-text": ("#000", "#000"),
    "sheet-line": ("#ddd", "#ddd"),
}
"""Colours of styles alone: over which a dialog stands; the ground of a QR code, white for every camera; what
is printed, on white paper even where the page is dark."""

MORE = {
    "line": ("b4bfce", "465266"),
    "edge": ("475569", "b4c0d0"),
    "text": ("1e293b", "f3f6fa"),
    "strong": ("0b1220", "ffffff"),
    "quiet": ("334155", "dbe2ec"),
    "brand": ("2a3fae", "a5b6ff"),
    "brand-over": ("22348f", "bccaff"),
    "brand-word": ("2a3fae", "bccaff"),
    "good": ("14532b", "86efac"),
    "good-bar": ("1f7a3d", "5fd38d"),
    "warn": ("7f2a06", "ffc299"),
    "bad": ("8f1616", "ffb4b4"),
    "call": ("5c3b00", "ffe3a3"),
    "call-edge": ("8a5a12", "e0ae5a"),
}
"""Other colours for who wishes more contrast: 7 to 1 for letters, 4.5 to 1 for the edges of controls."""

FORCED = {
    **dict.fromkeys(("paper", "panel", "float", "key", "key-over"), "Canvas"),
    **dict.fromkeys(("brand-soft", "good-soft", "warn-soft", "call-soft"), "Canvas"),
    **dict.fromkeys(("text", "strong", "quiet", "edge", "good", "warn", "bad", "call"), "CanvasText"),
    **dict.fromkeys(("brand", "brand-over", "call-edge"), "Highlight"),
    "on-brand": "HighlightText",
    **dict.fromkeys(("brand-word", "good-bar"), "LinkText"),
    "grid": "color-mix(in srgb, CanvasText 14%, Canvas)",
    "line": "color-mix(in srgb, CanvasText 40%, Canvas)",
}
"""Colours where the system forces its own (`forced.css`); those of the body stay."""

# ------------------------------------------------------------------------- sizes and times
FONT = '"Inter", system-ui, -apple-system, "Segoe UI", Roboto, sans-serif'
"""Of all words; a file that is saved carries no Inter, and has the system's letters."""

CODE_FONT = "ui-monospace, Menlo, Consolas, monospace"
"""Of links and commands, which are copied."""

TYPE = ((12, 16), (14, 20), (16, 24), (20, 28), (28, 36), (40, 48))
"""Sizes of letters and of their lines, px: notes, controls, what is read, titles, heads, what is shown."""

LETTERS = 16.0
"""Size of letters, px, unless the browser's user wishes larger ones: with these, all grow."""

GAPS = (4, 8, 12, 16, 20, 24, 32, 48)
"""Distances, px."""

RADII = (6, 8, 12, 16)
"""Inside a control, a control, a bar or card, a dialog or sheet, px: the holder is rounder than the held."""

HEIGHTS = {"least": 24, "panel": 32, "bar": 40, "thumb": 48}
"""Of what is pressed, px: at least, in the panel, in a bar, and under a thumb, as on all touch screens."""

TIMES = {"press": 80, "appear": 150, "move": 240}
"""Milliseconds: of a press, of what appears, of sheet and view; 0 where less motion is wished."""

CURVE = "cubic-bezier(.2, .8, .2, 1)"
"""How what moves comes to rest."""

SHADOWS = {
    "bar": (
        "0 1px 2px rgb(15 23 42 / 6%), 0 4px 12px rgb(15 23 42 / 6%)",
        "0 1px 2px rgb(0 0 0 / 40%), 0 4px 12px rgb(0 0 0 / 30%), 0 0 0 1px var(--softrod-line)",
    ),
    "menu": (
        "0 2px 4px rgb(15 23 42 / 6%), 0 8px 28px rgb(15 23 42 / 16%)",
        "0 8px 28px rgb(0 0 0 / 55%), 0 0 0 1px var(--softrod-line)",
    ),
    "dialog": (
        "0 24px 72px rgb(15 23 42 / 28%)",
        "0 24px 72px rgb(0 0 0 / 65%), 0 0 0 1px var(--softrod-line)",
    ),
}
"""Shadows, on white and on dark, where each has a line, since shadows vanish there."""

OF_STYLES = (
    "COLORS",
    "MORE",
    "FORCED",
    "TUTORIAL_COLORS",
    "SHADES",
    "FONT",
    "CODE_FONT",
    "TYPE",
    "LETTERS",
    "GAPS",
    "RADII",
    "HEIGHTS",
)
OF_STYLES += ("TIMES", "CURVE", "SHADOWS", "BY_SYSTEM", "OF_STYLES", "PATH")
"""What scripts do not use."""


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
    "rail": Layer("text", 0.3, width=5.0, round=True),
    "skin": Layer("text", 0.13, width=None, round=True),
    "gas": Layer("brand", 0.12),
    "liquid": Layer("liquid", 0.35),
    "wind": Layer("text", 0.35, width=1.4, round=True),
}
"""Layers behind the body, from back to front."""

ARROW = 2.4
"""Width of an arrow's shaft, pixels."""

RESTS = 0.4
"""Opacity of the arrow of a motor or a force while no key works it."""

WORKS = 0.05
"""Effort of keys from which on what they work is drawn as working."""

ARC_BEYOND = 7.0
"""Pixels between a mass and the arc of a motor about it."""

ARC_OPEN = 1.3
"""Radians that the arc leaves open, at the second spring of its joint."""

ARC_HEAD = 9.0
"""Length of its head, pixels."""

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

ROPE = 0.5
"""Width of a rope, in thicknesses of its spring."""

ROPE_PIECES = 12
"""Straight pieces of which a rope is drawn."""

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


BY_SYSTEM = "@media (prefers-color-scheme: dark){*}"
"""For `style_rules`, on a page that is dark where its system is."""


_VARIABLE = re.compile(r"--softrod-([a-z0-9-]+):[^;{}]*;?")
_USED = re.compile(r"var\(--softrod-([a-z0-9-]+)|[\"'`](?:--softrod-)?([a-z0-9-]+)[\"'`]")


def used_rules(styles: Sequence[str], rest: str) -> list[str]:
    """Styles without the variables that nothing names: a file has only what it uses.

    Args:
        styles: all of a file's.
        rest: its other text. A script names a variable by the end of its name, as a text.
    """
    used = {name for both in _USED.findall("\n".join((*styles, rest))) for name in both}
    return [_VARIABLE.sub(lambda match: match[0] if match[1] in used else "", style) for style in styles]


def style_rules(dark: str) -> str:
    """All that styles use, as variables of CSS, layers as classes of SVG, and the rules of forced colours.

    The variables begin with --softrod-:

        paper, text, brand, ...     each of `COLORS` and of `SHADES`, light and dark
        font, font-code             families
        type-1 ... type-6           sizes of letters: 12, 14, 16, 20, 28, 40 px, or larger as the browser's
        line-1 ... line-6           heights of their lines: 16, 20, 24, 28, 36, 48 px, as well
        gap-4, -8, -12, -16, -20, -24, -32, -48
        radius-6, -8, -12, -16
        height-least, -panel, -bar, -thumb    24, 32, 40, 48 px; -panel and -bar 48 on touch screens
        press, appear, move         times; 0 where less motion is wished
        curve                       how what moves comes to rest
        shadow-bar, -menu, -dialog  in the dark with a line
        arrow-width                 of the shafts on the canvas
        pale                        opacity of words that matter less

    Colours are those of `MORE` where the root has the attribute data-softrod-contrast or the system asks for
    more contrast, and of `FORCED` where it forces its own.

    Args:
        dark: wraps a rule for dark paper, with * in place of the rule.
    """
    light, night = (
        {name: f"#{pair[k]}" for name, pair in COLORS.items()}
        | {name: pair[k] for name, pair in SHADES.items()}
        | {f"shadow-{name}": pair[k] for name, pair in SHADOWS.items()}
        for k in (0, 1)
    )
    more = [{name: f"#{pair[k]}" for name, pair in MORE.items()} | {"pale": "1"} for k in (0, 1)]
    sizes = {
        "pale": "0.8",
        "arrow-width": f"{ARROW:g}px",
        "font": FONT,
        "font-code": CODE_FONT,
        "curve": CURVE,
    }
    for i, (size, line) in enumerate(TYPE, start=1):
        sizes |= {f"type-{i}": f"{size / LETTERS:g}rem", f"line-{i}": f"{line / LETTERS:g}rem"}
    for name, pixels in (("gap", GAPS), ("radius", RADII)):
        sizes |= {f"{name}-{size}": f"{size}px" for size in pixels}
    sizes |= {f"height-{name}": f"{size}px" for name, size in HEIGHTS.items()}
    thumb = f"{HEIGHTS['thumb']}px"
    touch = f"@media (pointer: coarse){{{_root({'height-panel': thumb, 'height-bar': thumb})}}}"
    times = {name: f"{milliseconds}ms" for name, milliseconds in TIMES.items()}
    still = f"@media (prefers-reduced-motion: reduce){{{_root(dict.fromkeys(TIMES, '0s'))}}}"
    switched = [_root(colors).replace(":root", ":root[data-softrod-contrast]", 1) for colors in more]
    asked = _root(more[0]) + dark.replace("*", _root(more[1]))
    forced = {name: f"{color} !important" for name, color in FORCED.items()}
    rules = (
        _root(light | sizes | times),
        dark.replace("*", _root(night)),
        switched[0],
        dark.replace("*", switched[1]),
        f"@media (prefers-contrast: more){{{asked}}}",
        f"@media (forced-colors: active){{{_root(forced)}}}",
        still,
        touch,
    )
    return "\n".join(
        (*rules, *map(_layer_rule, LAYERS), compact_style(Path(__file__).with_name("forced.css")))
    )


def _root(variables: dict[str, str]) -> str:
    return ":root{" + ";".join(f"--softrod-{name}:{value}" for name, value in variables.items()) + "}"


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
        if name.isupper() and not name.startswith("_") and name not in OF_STYLES:
            lines.append(f"export const {name} = {_text(value)};")
    return "\n".join((*lines, ""))


def _text(value: object) -> str:
    if isinstance(value, dict):
        rows = (f"  {json.dumps(str(key))}: {_text(one)},\n" for key, one in value.items())
        return f"{{\n{''.join(rows)}}}"
    return json.dumps(value, default=asdict, ensure_ascii=False)


if __name__ == "__main__":
    Path(__file__).with_name("looks.js").write_text(script(), encoding="utf-8")
