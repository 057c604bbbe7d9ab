"""The sliders of a live file: which settings of the catalogue `sim.settings` it has, and what each sets."""

from __future__ import annotations

import math
from typing import Any

import sim
from sim.settings import CHOICES, SETTINGS, TEMPLATES, set_value, settings_of
from sim.settings.recipes import Setting

from ...words.settings import label_of, label_of_choice, options_of
from .data import body_data

TUTORIAL = "symplectic_euler"
"""The method by which a file moves a body exactly as softrod does."""

LAW = "force_law"
"""The one choice that a file has."""

_BELT, _STATIC = 12, 13
"""Where the script has the speed of a wall, and its coefficient of static friction."""

_SPEED, _TORQUE = 1, 2
"""Where the script has the speed of a motor, and its torque."""

_SETS: dict[str, tuple[str | float, ...]] = {
    "linear_stiffness": ("all", "stiffness"),
    "linear_damping": ("all", "damping"),
    "angular_stiffness": ("all", "jointStiffness"),
    "angular_damping": ("all", "jointDamping"),
    "rest_length_scale": ("stretch",),
    "rest_angle": ("turn",),
    "template": ("template",),
    "tempo": ("tempo",),
    "motor_torque": ("motors", _TORQUE),
    "motor_speed": ("motors", _SPEED, math.pi / 180.0),
    "gravity": ("gravity",),
    "air_friction": ("field", "airFriction"),
    "wind_speed": ("wind", "speed"),
    "wind_direction": ("wind", "direction"),
    "turbulence": ("gusts",),
    "drag_across": ("field", "medium", "across"),
    "drag_along": ("field", "medium", "along"),
    "ground_forward": ("field", "ground", "forward"),
    "ground_backward": ("field", "ground", "backward"),
    "ground_sideways": ("field", "ground", "sideways"),
    "wall_friction": ("walls",),
    "belt_speed": ("walls", _BELT),
    "static_friction": ("walls", _STATIC),
    "contact_stiffness": ("field", "contact", "stiffness"),
    "contact_friction": ("field", "contact", "friction"),
    "dt": (),  # a number of the clock
    LAW: ("field", "law"),
}
"""What sets a setting in the script: a function of `SETTERS` in `static/settings.js`, and its other names."""

KEYS = frozenset(_SETS)
"""Of the settings and choices that a file has."""

_HIDDEN = frozenset(("tolerance", "dt", "rest_angle", "turbulence"))
"""Settings whose absence a file does not mention: no file controls its error, and `_is_shown` has the reasons
of the others."""


def sliders(scene: sim.Scene) -> list[dict[str, Any]]:
    """Each `Setting` of `static/settings.js` that a scene has, in the order of the panel."""
    found = [_slider(scene, setting) for setting in settings_of(scene) if _is_shown(scene, setting)]
    choice = CHOICES[LAW]
    if choice.applies(scene):
        found.append(
            {
                "key": LAW,
                "label": label_of_choice(LAW),
                "unit": "",
                "value": choice.read(scene),
                "sets": _SETS[LAW],
                "options": [list(option) for option in options_of(LAW).items()],
            }
        )
    return found


def missing_labels(scene: sim.Scene) -> list[str]:
    """The settings of a scene that its file has no slider for, by their names for people, sorted."""
    return sorted(
        label_of(setting)
        for setting in settings_of(scene)
        if setting.key in SETTINGS.keys() - _HIDDEN and not _is_shown(scene, setting)
    )


def _is_shown(scene: sim.Scene, setting: Setting) -> bool:
    match setting.key:
        case "rest_angle":
            return scene.template is None
        case "dt":
            return scene.integrator.method == TUTORIAL
        case "turbulence":
            return setting.read(scene) > 0.0  # without any gusts there are none to scale
    return setting.key in KEYS


def _slider(scene: sim.Scene, setting: Setting) -> dict[str, Any]:
    low, high = setting.slider
    slider: dict[str, Any] = {
        "key": setting.key,
        "label": label_of(setting),
        "unit": setting.unit.replace("px", scene.view.unit),
        "low": low,
        "high": high,
        "logarithmic": setting.logarithmic,
        "value": setting.read(scene),
        "sets": _SETS[setting.key],
    }
    if setting.key == "template":
        by_template = (set_value(scene, "template", float(angle)) for angle in TEMPLATES)
        data = [body_data(sim.Simulation(other).capture()) for other in by_template]
        slider["options"] = [[angle, f"{angle}°"] for angle in sorted(TEMPLATES)]
        slider["stiffness"] = {
            str(angle): one["jointStiffness"][0] for angle, one in zip(TEMPLATES, data, strict=True)
        }
    return slider
