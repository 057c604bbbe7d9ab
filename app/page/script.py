"""What is told to the page's script (in `static`), and the messages that it sends.

viser puts the content of an HTML element into the page as it is: what comes from users is escaped.
"""

from __future__ import annotations

import html
import math
import re

from ..session import commands
from ..session.commands import Command
from .colors import Palette
from .drawing import WORLD_SIZE, Mapping

_KEYS = {"U": "up", "D": "down", "L": "left", "R": "right"}
_NUMBER = r"-?\d{1,7}(?:\.\d{1,6})?"
_MESSAGE = re.compile(
    rf"\d{{1,15}}\|(?:keys\|([UDLR]{{0,4}})|at\|({_NUMBER}),({_NUMBER})|do\|([a-z]{{1,10}}))"
)

ONCE: dict[str, Command] = {
    "play": commands.Play(),
    "pause": commands.Play(False),
    "step": commands.DoSteps(1),
    "reset": commands.Reset(),
}
"""Commands that the script sends by a word; `follow` is the tab's, which knows the switch."""


def style_html(colors: Palette, dark: bool, sliders: list[tuple[str, str]], bare: str) -> str:
    """The styles in a palette's colours.

    Args:
        colors: the palette.
        dark: whether the page is dark.
        sliders: ids of sliders, each with that of the number box that stands in place of the slider's own.
        bare: id of a slider without any box.
    """
    rows = ",".join(f'div:has(>[id="{slider}"])' for slider, _ in sliders)
    boxes = ",".join(f'.mantine-NumberInput-root:has([id="{box}"])' for _, box in sliders)
    own = ",".join(
        f'div:has(>[id="{slider}"])>.mantine-InputWrapper-root' for slider in (bare, *(s for s, _ in sliders))
    )
    hide = f"{own}{{display:none}}"
    if sliders:
        hide += f"{rows}{{padding-right:5.6em}}{boxes}{{width:5.2em;margin:-1.75em 0 0 auto;z-index:4}}"
    root = {
        "text": colors.css("text"),
        "line": colors.css("grid_major"),
        "brand": colors.css("driven"),
        "key": "#1a2230" if dark else "#f6f8fb",
        "warn": "#ff922b" if dark else "#c2410c",
    }
    variables = ";".join(f"--softrod-{name}:{value}" for name, value in root.items())
    return f"<style>:root{{{variables}}}{hide}</style>"


def state_html(channel: str, scene: str, frame: tuple[float, float, float, float], follow: bool) -> str:
    """What the script has to know.

    Args:
        channel: id of the hidden text element that it sends through.
        scene: another text for every scene, or for every time that it is to be fitted to the window.
        frame: xmin, ymin, xmax, ymax of the scene, px.
        follow: whether the driven mass follows the pointer.
    """
    size = WORLD_SIZE / max(frame[2] - frame[0], frame[3] - frame[1])
    width, height = (frame[2] - frame[0]) * size, (frame[3] - frame[1]) * size
    return (
        f'<div id="softrod-state" hidden data-channel="{html.escape(channel)}" '
        f'data-scene="{html.escape(scene)}" '
        f'data-width="{width:.6f}" '
        f'data-height="{height:.6f}" data-follow="{int(follow)}"></div>'
    )


def parse(message: object, mapping: Mapping) -> Command | str | None:
    """A message of the script as a command, "follow" for the switch, or None for nonsense.

    Args:
        message: the value of the hidden text element, which any client can set to anything.
        mapping: from the page's world to px.
    """
    match = _MESSAGE.fullmatch(message) if isinstance(message, str) else None
    if match is None:
        return None
    keys, x, y, word = match.groups()
    if keys is not None:
        return commands.HoldKeys(frozenset(_KEYS[key] for key in keys))
    if word is not None:
        return word if word == "follow" else ONCE.get(word)
    point = mapping.to_scene(float(x), float(y))
    return commands.Point(*point) if all(map(math.isfinite, point)) else None
