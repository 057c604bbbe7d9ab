"""The live file: a body that moves, is dragged and has sliders, in one HTML file without a server."""

from __future__ import annotations

import html
import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import sim
from sim.motion.stepping import presses_of
from sim.scene.types import shown_name
from sim.settings import TEMPLATES, set_value, settings_of
from sim.settings.recipes import Setting

from ...drawing.looks import FRACTIONS, ICONS, SPEEDS, style_rules
from ..bundle import bundle
from ..html_file import Bar, html_file, packed, plans, stage
from .data import body_data

KEYS = (
    "linear_stiffness",
    "linear_damping",
    "angular_stiffness",
    "angular_damping",
    "rest_length_scale",
    "rest_angle",
    "template",
    "gravity",
    "air_friction",
    "wind_speed",
    "wall_friction",
    "contact_stiffness",
    "contact_friction",
)
"""Settings that a file has sliders for, as in `static/settings.js`."""

TUTORIAL = "symplectic_euler"

DARK = '@media (prefers-color-scheme: dark){html:not([data-theme="light"])*}html[data-theme="dark"]*'
"""Where the paper is dark: as the system has it, or as the file's own attribute says."""

_FOLDER = Path(__file__).parent / "static"


def live_html(moment: sim.Moment, bar: Bar | None = None) -> tuple[bytes, list[str]]:
    """The file, in UTF-8, and what it cannot do: sentences without a full stop.

    Args:
        moment: in which the body begins.
        bar: what leads to other files, for one that is not alone.

    Raises:
        InputError: a position or a velocity is not a finite number.
    """
    scene = moment.scene
    title = html.escape(shown_name(scene))
    style, script = _looks()
    notes = _notes(scene)
    note = f"In this file {'; '.join(notes)}." if notes else ""
    speeds = "".join(
        f'<option value="{speed:g}"{" selected" * (speed == 1)}>{FRACTIONS.get(speed, int(speed))}×</option>'
        for speed in SPEEDS
        if speed <= 2.0
    )
    icon = '<svg viewBox="0 0 24 24" aria-hidden="true">{}</svg>'
    play = icon.format("".join(f'<path class="{name}" d="{ICONS[name]}"/>' for name in ("play", "pause")))
    reset = icon.format(f'<path d="{ICONS["reset"]}"/>')
    arrows = "".join(
        f'<button type="button" value="{key}" aria-label="{label}">{sign}</button>'
        for key, sign, label in (
            ("up", "↑", "Up: longer"),
            ("left", "←", "Left: rest angles less"),
            ("down", "↓", "Down: shorter"),
            ("right", "→", "Right: rest angles more"),
        )
    )
    body = f"""<div class="stage">
<canvas id="canvas" tabindex="0" role="application" aria-label="{title}"></canvas>
<p id="hud"></p>
</div>
<aside aria-label="Settings">
<div id="sliders"></div>
<div id="pad" hidden>{arrows}</div>
<dl id="numbers"></dl>
</aside>
<div class="bar">
<button id="play" type="button" data-icon="play" aria-label="Play">{play}</button>
<button id="step" type="button" aria-label="One step">+1</button>
<button id="reset" type="button" aria-label="Reset">{reset}</button>
<select id="speed" aria-label="Speed">{speeds}</select>
<output id="clock"></output>
</div>
<p id="says" class="hidden" role="status"></p>"""
    return html_file(scene, body, style, script, {"about": _about(moment)}, note, bar), notes


@cache
def _looks() -> tuple[str, str]:
    """The styles and the script."""
    colors = style_rules(DARK)
    return colors + (_FOLDER / "live.css").read_text(encoding="utf-8"), bundle(_FOLDER / "live.js")


def _about(moment: sim.Moment) -> dict[str, Any]:
    """What the script is told, see `About` in `static/live.js`."""
    scene = moment.scene
    keys = {key: _per_second(scene, key) if scene.arrow_keys is not None else None for key in ("up", "right")}
    return {
        **stage(scene, np.array(moment.positions)),
        "body": body_data(moment),
        "method": TUTORIAL if scene.integrator.method == TUTORIAL else "verlet",
        "dt": scene.integrator.dt,
        "settings": [_setting(scene, setting) for setting in settings_of(scene) if _is_shown(scene, setting)],
        **keys,
        "joint": 0 if scene.angular_springs else -1,
        "unit": scene.view.unit,
        "speed": 1.0,
        "plans": [packed(plan) for plan in plans(scene)],
    }


def _per_second(scene: sim.Scene, key: str) -> dict[str, float]:
    """What a held key does in a second, as `Presses` of `static/steps.js`."""
    presses, steps = presses_of(scene, frozenset((key,))), 1.0 / scene.integrator.dt
    return {"factor": math.exp(min(math.log(presses.factor) * steps, 700.0)), "angle": presses.angle * steps}


def _is_shown(scene: sim.Scene, setting: Setting) -> bool:
    has_template = setting.key == "rest_angle" and scene.template is not None
    return setting.key in KEYS and not has_template


def _setting(scene: sim.Scene, setting: Setting) -> dict[str, Any]:
    low, high = setting.slider
    told: dict[str, Any] = {
        "key": setting.key,
        "label": setting.label,
        "unit": setting.unit.replace("px", scene.view.unit),
        "low": low,
        "high": high,
        "logarithmic": setting.logarithmic,
        "value": setting.read(scene),
    }
    if setting.key == "template":
        by_template = (set_value(scene, "template", float(angle)) for angle in TEMPLATES)
        data = [body_data(sim.Simulation(other).capture()) for other in by_template]
        told["stiffness"] = {
            str(angle): one["jointStiffness"][0] for angle, one in zip(TEMPLATES, data, strict=True)
        }
    return told


def _notes(scene: sim.Scene) -> list[str]:
    """What the file does otherwise than softrod, or cannot do."""
    notes = []
    if scene.integrator.method != TUTORIAL:
        notes.append("the body moves by velocity Verlet, without error control")
    if scene.bodies:
        notes.append("the shape of the body is fixed")
    if scene.lesson is not None:
        notes.append("the lesson's steps are left out")
    return notes
