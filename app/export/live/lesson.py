"""A lesson as the script of a live file has it; see `static/course.js` for the fields."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import msgspec

import sim
from sim.errors import InputError
from sim.motion.formulas import Call, Measured, Node, Number
from sim.motion.quantities import PARTS, Quantity, quantity
from sim.scene.lesson import Step
from sim.settings import CHOICES, SETTINGS, scene_of_run, scene_of_step

from ...lessons import goal_text, lesson_code, quantity_text
from ...session.plots import PlotSpec, parse_plot
from ...words import listed, say
from ...words.english import step_of
from ...words.settings import label_of, label_of_choice
from .sliders import KEYS, TUTORIAL

MEASURED = frozenset(
    (
        *(("joint", what) for what in ("angle", "rest_angle", "rate", "torque")),
        *(("spring", what) for what in ("length", "elongation", "force")),
        *(("mass", what) for what in ("x", "y", "vx", "vy", "speed")),
        *(("energy", what) for what in ("kinetic", "linear", "angular")),
    )
)
"""What a file can measure, as `static/quantities.js` does."""

OF_MASSES = {"mass": ("mass", "momentum_x", "momentum_y"), "body": tuple(PARTS["body"])}
"""What a file computes of one mass, and of masses together, as `static/derived.js` does."""

OF_STEP = "stability.dt_over_limit"
"""What a file has of a body that moves by steps of the scene's length."""


def lesson_data(
    scene: sim.Scene, about: dict[str, Any], moving: Callable[[sim.Moment], dict[str, Any]]
) -> dict[str, Any]:
    """The `Lesson` of a scene that has one.

    Args:
        scene: whose lesson it is.
        about: what the file says of its body.
        moving: what a step can change of that, for the moment with which the step begins.

    Raises:
        SettingError: a step cannot begin.
    """
    assert scene.lesson is not None
    xmin, ymin, xmax, ymax = scene.view.frame
    return {
        "code": lesson_code(scene),
        "frame": {"left": xmin, "top": ymin, "width": xmax - xmin, "height": ymax - ymin},
        "steps": [
            _step(step, at, scene_of_run(scene, number), about, moving)
            for number, (step, at) in enumerate(zip(scene.lesson.steps, scenes_of_steps(scene), strict=True))
        ],
        **({"derived": derived} if (derived := derived_of(scene)) else {}),
    }


def derived_of(scene: sim.Scene) -> dict[str, Any]:
    """What the steps of a scene's lesson measure that a file computes, by its name: what `static/derived.js`
    computes, and whether it is an angle that goes on beyond half a turn. Nothing without a lesson."""
    names = set()
    for step in scene.lesson.steps if scene.lesson is not None else ():
        specs = [parse_plot(text) for text in step.plots or ()]
        names |= {name for spec in specs for name in (*spec.names, spec.over)}
        names |= {step.goal.quantity} if step.goal is not None else set()
    found = {}
    for name in sorted(name for name in names - {"", OF_STEP} if is_measured(name, scene)):
        one = quantity(name, scene)
        if one.formula or _is_of_masses(one):
            node = _node(one.formula.tree, one.leaves, scene) if one.formula else _leaf(one, scene)
            found[name] = {"node": node, "unwrapped": one.unwrapped}
    return found


def _node(tree: Node, leaves: Sequence[Quantity], scene: sim.Scene) -> Any:
    """The `Node` of a formula."""
    match tree:
        case Number(value):
            return value
        case Measured(index):
            return _leaf(leaves[index], scene)
        case Call(do, of):
            return [do, *(_node(each, leaves, scene) for each in of)]


def _leaf(one: Quantity, scene: sim.Scene) -> Any:
    """The `Node` of a quantity that is no formula."""
    if not _is_of_masses(one):
        return one.name
    return {"what": one.kind.what, "masses": one.indices or tuple(range(len(scene.masses)))}


def _is_of_masses(one: Quantity) -> bool:
    return one.kind.what in OF_MASSES.get(one.kind.of, ())


def _step(
    step: Step,
    scene: sim.Scene,
    asked: sim.Scene,
    about: dict[str, Any],
    moving: Callable[[sim.Moment], dict[str, Any]],
) -> dict[str, Any]:
    def differing(begun: sim.Scene) -> dict[str, Any]:
        begins = moving(sim.Simulation(begun).capture())
        differs = {key: value for key, value in begins.items() if key != "body" and value != about[key]}
        return {**differs, "body": {k: v for k, v in begins["body"].items() if v != about["body"][k]}}

    step = step_of(step)
    question = msgspec.to_builtins(step.question) if step.question is not None else None
    goal = step.goal if step.goal is not None and is_measured(step.goal.quantity, scene) else None
    return {
        "title": step.title,
        "do": step.do,
        "watch": step.watch,
        "question": question,
        "controls": step.controls,
        "plots": [_plot(spec, scene) for spec in map(parse_plot, step.plots or ()) if _is_drawn(spec, scene)],
        "predict": step.predict or 0,
        "goal": msgspec.to_builtins(goal) if goal is not None else None,
        "goalText": goal_text(goal, scene) if goal is not None else "",
        "about": differing(scene),
        "run": differing(asked) if step.run else None,
    }


def is_measured(name: str, scene: sim.Scene) -> bool:
    """Whether a file can measure a quantity of that name."""
    if name == OF_STEP:
        return scene.integrator.method == TUTORIAL
    try:
        found = quantity(name, scene).measured
    except InputError:  # that of a ghost
        return False
    return all((one.kind.of, one.kind.what) in MEASURED or _is_of_masses(one) for one in found)


def _is_drawn(spec: PlotSpec, scene: sim.Scene) -> bool:
    return all(is_measured(name, scene) for name in (*spec.names, *filter(None, [spec.over])))


def _plot(spec: PlotSpec, scene: sim.Scene) -> dict[str, Any]:
    """The `Plot` of `static/chart.js`."""
    quantities = [quantity(name, scene) for name in spec.names]
    return {
        "names": spec.names,
        "words": tuple(map(quantity_text, spec.names)),
        "units": [one.unit for one in quantities],
        "over": spec.over,
        "overWords": quantity_text(spec.over) if spec.over else "",
        "overUnit": quantity(spec.over, scene).unit if spec.over else "",
        "turned": scene.view.y_down and all(one.kind.vertical for one in quantities),
    }


def scenes_of_steps(scene: sim.Scene) -> list[sim.Scene]:
    """What the steps of a scene's lesson begin with; nothing without a lesson.

    Raises:
        SettingError: a step cannot begin.
    """
    steps = scene.lesson.steps if scene.lesson is not None else ()
    return [scene_of_step(scene, number) for number in range(len(steps))]


def scenes_of_runs(scene: sim.Scene) -> list[sim.Scene]:
    """What the steps of a scene's lesson run with after their questions; nothing without a lesson.

    Raises:
        SettingError: a step cannot begin.
    """
    steps = scene.lesson.steps if scene.lesson is not None else ()
    return [scene_of_run(scene, number) for number, step in enumerate(steps) if step.run]


def lesson_notes(scene: sim.Scene) -> list[str]:
    """What a file leaves out of a scene's lesson: see `live-notes` of `app/words`."""
    steps = scene.lesson.steps if scene.lesson is not None else ()
    begins = list(zip(steps, scenes_of_steps(scene), strict=True))
    named = {key: label_of(setting) for key, setting in SETTINGS.items()}
    named |= {key: label_of_choice(key) for key in CHOICES}
    controls = {key for step in steps for key in step.controls if key not in KEYS}
    missing = {named.get(key, key) for key in controls}
    plots = {text for step, at in begins for text in step.plots or () if not _is_drawn(parse_plot(text), at)}
    notes = []
    if missing:
        notes.append(say("live-note-controls", settings=listed(sorted(missing))))
    if plots:
        notes.append(say("live-note-plots", quantities=listed(sorted(plots))))
    if any(step.ghost for step in steps):
        notes.append(say("live-note-ghost"))
    if any(step.arrows for step in steps):
        notes.append(say("live-note-arrows"))
    if any(step.goal is not None and not is_measured(step.goal.quantity, at) for step, at in begins):
        notes.append(say("live-note-goals"))
    if any(step.collect is not None for step in steps):
        notes.append(say("live-note-runs"))
    return notes
