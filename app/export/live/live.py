"""The live file: a body that moves, is dragged and has sliders, in one HTML file without a server."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

import sim
from sim.motion.motion import key_rates_of
from sim.motion.quantities import ENERGY_UNIT, unit_in
from sim.scene.types import keys_of

from ...bundle import bundle, compact_style
from ...stage.looks import ICONS, style_rules
from ...words import joined, listed, say
from ...words.english import name_of
from ...words.keys import Key
from ..body.features import features_of
from ..body.program import check_forces
from ..clip import ClipFrame
from ..html_file import Bar, html_file, icon, packed, plans, said, speed_options, stage
from .data import body_data
from .lesson import derived_of, lesson_data, lesson_notes, scenes_of_runs, scenes_of_steps
from .sliders import TUTORIAL, missing_labels, sliders

DARK = "[data-dark]*"
"""Selects dark paper, see `static/dark.js`."""

_ARROWS: list[tuple[str, str, Key]] = [
    ("left", "←", "live-arrow-left"),
    ("up", "↑", "live-arrow-up"),
    ("down", "↓", "live-arrow-down"),
    ("right", "→", "live-arrow-right"),
]
"""The arrow keys, each with its sign and what it does."""

_WORKS: dict[str, Key] = {
    "left": "live-arrow-left.works",
    "up": "live-arrow-up.works",
    "down": "live-arrow-down.works",
    "right": "live-arrow-right.works",
}
"""What says what an arrow key does to what keys work."""

_FOLDER = Path(__file__).parent / "static"
_APP = Path(__file__).parents[2]
"""The folder with the dialogs and lessons that look the same in a file."""


def live_html(moment: sim.Moment, bar: Bar | None = None) -> tuple[bytes, list[str]]:
    """The file, in UTF-8, and what it cannot do: sentences without a full stop, in the language spoken now.

    Args:
        moment: in which the body begins.
        bar: what leads to other files, for one that is not alone.

    Raises:
        InputError: a position or a velocity is not a finite number, or it does not know a force or the force
            law.
    """
    scene = moment.scene
    check_forces(scene, "a live file")
    title = html.escape(name_of(scene))
    has = features_of(scene, *scenes_of_steps(scene), *scenes_of_runs(scene))
    has |= {"HAS_DERIVED": bool(derived_of(scene)), "HAS_LESSON": scene.lesson is not None}
    style, script = _looks(has["HAS_LESSON"]), _script(*(name for name, needed in has.items() if needed))
    notes = _notes(scene)
    note = say("live-notes", notes=joined(notes, "language-semicolon")) if notes else ""
    play, reset = icon(play=ICONS["play"], pause=ICONS["pause"]), icon(reset=ICONS["reset"])
    arrows = "".join(
        f'<button type="button" data-softrod-key="{key}" aria-label="{html.escape(label)}">{sign}</button>'
        for key, sign, label in _arrows(scene)
    )
    card = charts = folds = ""
    if has["HAS_LESSON"]:
        lesson, answers = said("live-lesson"), said("live-answers")
        card = f'<section id="lesson" class="softrod-lesson" aria-label="{lesson}"></section>\n'
        charts = '<div id="charts"></div>\n'
        folds = f'<details id="answers" hidden><summary>{answers}</summary></details>\n'
    follow = f'aria-label="{said("live-follow.hint")}" aria-pressed="false"'
    body = f"""<main class="stage">
<canvas id="canvas" tabindex="0" role="application" aria-label="{title}"></canvas>
<div id="hud"></div>
<div id="stopped" role="alert" hidden>
<strong>{said("live-exploded")}</strong>
<p id="cause"></p>
<button id="back" type="button">{said("live-back")}</button>
</div>
</main>
<aside aria-label="{said("live-side")}">
{card}<div id="sliders"></div>
{charts}<details id="others" hidden><summary>{said("live-others")}</summary></details>
<div id="numbers"></div>
{folds}</aside>
<section class="bar" aria-label="{said("live-time")}">
<p id="stands" hidden>{said("time-stands")}</p>
<button id="play" type="button" data-icon="play" aria-label="{said("live-play")}">{play}</button>
<button id="step" type="button" aria-label="{said("live-step")}">+1</button>
<button id="reset" type="button" aria-label="{said("live-reset")}">{reset}</button>
<select id="speed" aria-label="{said("live-speed")}">{speed_options()}</select>
<button id="follow" type="button" {follow}>{said("live-follow")}</button>
<div id="pad" hidden>{arrows}</div>
<output id="clock" aria-live="off" translate="no"></output>
<button id="view" type="button" aria-label="{said("live-view")}">?</button>
</section>
<p id="says" class="hidden" role="status"></p>"""
    return html_file(
        ClipFrame.of(moment), body, style, script, {"about": _about(moment, has)}, note, early_script(), bar
    ), notes


def _arrows(scene: sim.Scene) -> list[tuple[str, str, str]]:
    """The arrow keys of the pad, those that do anything: each with its sign and what it does."""
    known, works = keys_of(scene), scene.arrow_keys is None
    return [
        (key, sign, say(_WORKS[key], work=_worked_by(scene, key)) if works else say(does))
        for key, sign, does in _ARROWS
        if key in known
    ]


def _worked_by(scene: sim.Scene, key: str) -> str:
    """What an arrow key does to what keys work."""
    springs, joints = scene.linear_springs, scene.angular_springs
    worked: dict[Key, Sequence[Any]] = {
        "live-work-motors": [joint.motor for joint in joints],
        "live-work-muscles": [part.muscle for part in (*springs, *joints) if scene.beat],
        "live-work-forces": scene.masses,
    }
    return listed(
        [
            say(does)
            for does, parts in worked.items()
            if any(part and part.keys and key in part.keys.split("-") for part in parts)
        ]
    )


@cache
def early_script() -> str:
    """What makes the paper dark before anything is shown."""
    return bundle(_FOLDER / "dark.js")


@cache
def _looks(has_lesson: bool) -> str:
    """The styles."""
    lesson = ["features/lesson/lesson.css"] if has_lesson else []
    shared = ("export/static/file.css", "ui/dialogs.css", *lesson)
    files = (*(_APP / name for name in shared), _FOLDER / "live.css")
    return f"{style_rules(DARK)}\n{compact_style(*files)}"


@cache
def _script(*features: str) -> str:
    """The script of scenes with these features and no others."""
    return bundle(
        _FOLDER / "live.js",
        {name: name in features for name in (*features_of(), "HAS_DERIVED", "HAS_LESSON")},
    )


def _about(moment: sim.Moment, has: Mapping[str, bool]) -> dict[str, Any]:
    """The `About` of `static/live.js`; `has`: the features of the script."""
    scene = moment.scene
    moving = partial(_moving, has=has)
    about = moving(moment)
    keys = {key: _per_second(scene, key) if scene.arrow_keys is not None else None for key in ("up", "right")}
    about |= stage(scene, np.array(moment.positions)) | keys
    about |= {
        "joint": 0 if scene.angular_springs else -1,
        "unit": scene.view.unit,
        "energyUnit": unit_in(ENERGY_UNIT, scene.view.unit),
        "lesson": lesson_data(scene, about, moving) if scene.lesson is not None else None,
    }
    return about


def _moving(moment: sim.Moment, has: Mapping[str, bool]) -> dict[str, Any]:
    """The part of it that a step of a lesson can change."""
    scene = moment.scene
    return {
        "body": body_data(moment, has),
        "method": TUTORIAL if scene.integrator.method == TUTORIAL else "verlet",
        "dt": scene.integrator.dt,
        "settings": sliders(scene),
        "plans": [packed(plan) for plan in plans(scene)],
    }


def _per_second(scene: sim.Scene, key: str) -> dict[str, float]:
    """The effect of a held key in a second, the `Presses` of `static/steps.js`."""
    presses, steps = key_rates_of(scene, frozenset((key,))), 1.0 / scene.integrator.dt
    return {"factor": math.exp(min(math.log(presses.factor) * steps, 700.0)), "angle": presses.angle * steps}


def _notes(scene: sim.Scene) -> list[str]:
    """How the file differs from softrod: see `live-notes` of `app/words`."""
    notes = []
    begins = scenes_of_steps(scene)
    if any(at.integrator.method != TUTORIAL for at in (scene, *begins)):
        notes.append(say("live-note-verlet"))
    if scene.bodies:
        notes.append(say("live-note-shape"))
    if missing := missing_labels(scene):
        notes.append(say("live-note-sliders", settings=listed(missing)))
    if scene.lesson is not None:
        notes += lesson_notes(scene)
    return notes
