"""Editing a scene's lesson: adding, ordering and changing its steps."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from msgspec import UNSET
from numpy.typing import NDArray

from ..errors import InputError, SceneError, SettingError, no_part, of_field, span
from ..motion.quantities import quantity
from ..scene.lesson import MAX_PULLS, Lead, Lesson, Pull, Reading, RunMuscle, Step, StepRun
from ..scene.parts import Circle, Mass
from ..scene.types import Scene
from ..scene.validate import validate
from ..settings import CHOICES, apply_assignments, scene_of_step, setting_of, settings_of
from ..solve.registry import METHODS
from ..store.files import is_built_in
from ..text import Text
from .edit import Edit

Floats = NDArray[np.float64]

PULLED = 0.5
"""Pixels from its start beyond which a mass counts as pulled. Doubled or halved, no test fails."""

OWN_LESSON = str.__str__(Text("my lesson"))
"""Name of a preset after its lesson is changed, until it gets another name; see `.texts.UNNAMED`."""

FIRST_TASK = "Let it run, and watch."
"""Task of a new step until another is written: a step always says what to do."""


def add_step(scene: Scene, at: int) -> Edit:
    """Insert a new step into the lesson, or begin a lesson with it.

    Args:
        scene: the scene.
        at: number of the new step, counted from 0. It has the settings of the step before it.

    Raises:
        SceneError: there is no such place, or the lesson already has 20 steps.
    """
    steps = list(_steps(scene))
    if not 0 <= at <= len(steps):
        raise SceneError(
            Text(
                "{where}: a step can be put in at 0..{count}, not at {at}",
                where="lesson.steps",
                count=len(steps),
                at=at,
            )
        )
    settings = steps[max(0, at - 1)].settings if steps else ()
    steps.insert(at, Step(title=f"Step {at + 1}", do=FIRST_TASK, settings=settings))
    return _edit(f"step {at + 1} added", scene, steps)


def copy_step(scene: Scene, number: int) -> Edit:
    """Insert a copy of a step after it.

    Raises:
        SceneError: there is no such step, or the lesson already has 20 steps.
    """
    steps, step = list(_steps(scene)), _step(scene, number)
    steps.insert(number + 1, step)
    return _edit(f"step {number + 1} duplicated", scene, steps)


def remove_step(scene: Scene, number: int) -> Edit:
    """Remove a step from the lesson; removing the only one removes the lesson.

    Raises:
        SceneError: there is no such step.
    """
    _step(scene, number)
    return _edit(f"step {number + 1} removed", scene, [s for i, s in enumerate(_steps(scene)) if i != number])


def move_step(scene: Scene, number: int, to: int) -> Edit:
    """Move a step to another place in the lesson.

    Args:
        scene: the scene.
        number: of the step.
        to: its new number.

    Raises:
        SceneError: there is no such step, or no such place.
    """
    steps, step = list(_steps(scene)), _step(scene, number)
    _step(scene, to)
    if to == number:
        return Edit("", scene)
    steps.insert(to, steps.pop(number))
    return _edit(f"“{step.title}” moved to step {to + 1}", scene, steps)


def change_step(scene: Scene, number: int, label: str, **changes: Any) -> Edit:
    """Change a step.

    Args:
        scene: the scene.
        number: of the step.
        label: what is changed.
        changes: new values of fields of `Step`.

    Raises:
        SceneError: there is no such step, a value is invalid for a step, or it refers to a quantity or a
            setting that the scene does not have; names the field.
    """
    steps, step = list(_steps(scene)), _step(scene, number)
    changed = msgspec.structs.replace(step, **changes)
    if changed == step:
        return Edit("", scene)
    where = f"lesson.steps[{number}]"
    if (question := changes.get("question")) is not None and not 2 <= len(question.choices) <= 5:
        raise SceneError(
            Text("{where}: a question has 2 to 5 answers to choose from", where=f"{where}.question.choices")
        )
    steps[number] = changed
    edit = _edit(f"{label} of step {number + 1}", scene, steps)
    for field in ("goal", "collect"):
        reading: Reading | None = changes.get(field)
        if reading is not None:
            try:
                quantity(reading.quantity, scene)
            except InputError as error:
                raise SceneError(of_field(f"{where}.{field}.quantity", str(error))) from None
    for i, key in enumerate(changes.get("controls", ())):
        if not (key in CHOICES and CHOICES[key].applies(scene)):
            try:
                setting_of(scene, key)
            except SettingError as error:
                raise SceneError(of_field(f"{where}.controls[{i}]", str(error))) from None
    return edit


def begin_as(scene: Scene, number: int, now: Scene, opened: Scene) -> Edit:
    """Make a step begin with the current settings.

    Every step then sets everything that any of them sets, so that the state at its beginning depends neither
    on the previous step nor on the slider positions when the scene is saved. The other steps set what they
    did not set before to its value when the scene was opened.

    Args:
        scene: the scene with the lesson.
        number: of the step.
        now: the same scene with its current settings.
        opened: the scene as it was opened.

    Raises:
        SceneError: there is no such step.
    """
    _step(scene, number)
    steps = list(_steps(scene))
    here, before = settings_to_set(scene, now, opened), _values(opened)
    for i, each in enumerate(steps):
        settings = here
        if i != number:
            own = _by_key(each.settings)
            known = {key: own.get(key, before.get(key)) for key in here}
            settings = {key: value for key, value in own.items() if key not in here}
            settings |= {key: value for key, value in known.items() if value is not None}
            if not METHODS[settings.get("method", opened.integrator.method)].adaptive:
                settings.pop("tolerance", None)
        steps[i] = msgspec.structs.replace(each, settings=_assignments(settings))
    if tuple(steps) == _steps(scene):
        return Edit("", scene)
    return _edit(f"beginning of step {number + 1}", scene, steps)


def run_as(scene: Scene, number: int, now: Scene, positions: Floats, opened: Scene) -> Edit:
    """Make a step run the current case: with these settings, and masses released where they are.

    Every step then sets what this run changes, so that the next one does not begin with the change.

    Args:
        scene: the scene with the lesson.
        number: of the step.
        now: the same scene with its current settings.
        positions: (n, 2) px, where its masses are; those not at the step's start are pulled there.
        opened: the scene as it was opened.

    Raises:
        SceneError: there is no such step, nothing differs from its beginning, or too many masses are
            elsewhere.
        SettingError: the step cannot begin.
    """
    _step(scene, number)
    where = f"lesson.steps[{number}].run"
    begins = scene_of_step(msgspec.structs.replace(opened, lesson=scene.lesson), number)
    before = _values(begins)
    changed = {key: value for key, value in _values(now).items() if value != before.get(key)}
    # A body whose muscles were changed has no recipe any more, and has numbers that the step cannot set.
    chosen = {key: value for key, value in changed.items() if key in CHOICES}
    there = _values(apply_assignments(begins, _assignments(chosen)))
    changed = {key: value for key, value in changed.items() if key in there and value != there[key]} | chosen
    # Settings of a recipe also change muscles and the positions where masses start.
    settled = apply_assignments(begins, _assignments(changed))
    starts = np.array(settled.pose.positions if settled.pose else [mass.position for mass in settled.masses])
    moved = positions - starts if positions.shape == starts.shape else np.zeros_like(starts)
    pulls = tuple(
        Pull(mass=int(i), by=(round(float(moved[i, 0]), 1), round(float(moved[i, 1]), 1)))
        for i in np.flatnonzero(np.hypot(*moved.T) > PULLED)
    )
    if len(pulls) > MAX_PULLS:
        raise SceneError(
            Text(
                "{where}: {count} masses are elsewhere; a run pulls {most} at most",
                where=f"{where}.pulls",
                count=len(pulls),
                most=MAX_PULLS,
            )
        )
    muscles = tuple(
        RunMuscle(joint=j, muscle=one.muscle or None)
        for j, (one, other) in enumerate(zip(now.angular_springs, settled.angular_springs, strict=False))
        if one.muscle != other.muscle
    )
    if not (changed or pulls or muscles):
        raise SceneError(
            Text(
                "{where}: all is as it is when the step begins; change a number or drag a mass first",
                where=where,
            )
        )
    led = _step(scene, number).run
    run = StepRun(
        settings=_assignments(changed), pulls=pulls, leads=led.leads if led else (), muscles=muscles
    )
    usual, steps = _values(opened), []
    for i, each in enumerate(_steps(scene)):
        own = _by_key(each.settings)
        missing = {key: usual[key] for key in changed if key not in own and key in usual}
        settings = (*each.settings, *_assignments(missing))
        steps.append(
            msgspec.structs.replace(each, settings=settings, **({"run": run} if i == number else {}))
        )
    return _edit(f"run of step {number + 1}", scene, steps)


def lead_in_run(scene: Scene, number: int, mass: int, radius: float, frequency: float) -> Edit:
    """Make the run of a step lead a mass round a circle, from its position when the run begins.

    Args:
        scene: the scene with the lesson.
        number: of the step.
        mass: index of the mass.
        radius, frequency: of its circle, px and Hz, see `Circle`; with a radius of 0 it is no longer led.

    Raises:
        SceneError: there is no such step or mass, or a number is out of its range; names the field.
    """
    step = _step(scene, number)
    run = step.run or StepRun()
    leads = [lead for lead in run.leads if lead.mass != mass]
    where = f"lesson.steps[{number}].run.leads"
    if not 0 <= mass < len(scene.masses):
        raise SceneError(of_field(f"{where}.mass", no_part("mass", mass, len(scene.masses))))
    if radius != 0.0:
        if len(leads) >= MAX_PULLS:
            raise SceneError(Text("{where}: a run leads {most} masses at most", where=where, most=MAX_PULLS))
        for name, value, low, high in (("radius", radius, 0.0, 1e4), ("frequency", frequency, -100.0, 100.0)):
            if not low <= value <= high:
                raise SceneError(
                    Text(
                        "{where}: {value:g} is not in {low:g}..{high:g}",
                        where=f"{where}.{name}",
                        value=value,
                        low=low,
                        high=high,
                    )
                )
        leads.append(Lead(mass=mass, circle=Circle(radius=radius, frequency=frequency)))
    changed = msgspec.structs.replace(run, leads=tuple(leads))
    steps = list(_steps(scene))
    steps[number] = msgspec.structs.replace(step, run=UNSET if changed == StepRun() else changed)
    return _edit(f"run of step {number + 1}", scene, steps)


def _assignments(values: dict[str, str]) -> tuple[str, ...]:
    return tuple(f"{key}={value}" for key, value in values.items())


def settings_to_set(scene: Scene, now: Scene, opened: Scene) -> dict[str, str]:
    """Return the settings, by key, of a step that begins as the scene is now: those that any step sets, and
    those that differ from when the scene was opened; see `begin_as` for the arguments. They can be applied in
    this order."""
    here, before = _values(now), _values(opened)
    if now.template is not None:
        here.pop("rest_angle", None)  # the template sets it, and would be removed by setting it
    named = {key for each in _steps(scene) for key in _by_key(each.settings)}
    return {key: value for key, value in here.items() if key in named or value != before.get(key)}


def remove_lesson(scene: Scene) -> Edit:
    """Remove the lesson."""
    return _edit("lesson deleted", scene, []) if scene.lesson is not None else Edit("", scene)


# ------------------------------------------------------------------------- inside
def _values(scene: Scene) -> dict[str, str]:
    """Return the values of all choices and settings of a scene by key, as `--set` takes them."""
    values = {key: choice.read(scene) for key, choice in CHOICES.items() if choice.applies(scene)}
    for setting in settings_of(scene):
        value = setting.read(scene)
        values[setting.key] = str(int(value)) if setting.integer else repr(float(value))
    return values


def _steps(scene: Scene) -> tuple[Step, ...]:
    return scene.lesson.steps if scene.lesson is not None else ()


def _step(scene: Scene, number: int) -> Step:
    steps = _steps(scene)
    if not 0 <= number < len(steps):
        raise SceneError(
            Text(
                "{where}: step {number} does not exist ({span})",
                where="lesson.steps",
                number=number,
                span=span(len(steps)),
            )
        )
    return steps[number]


def _by_key(settings: tuple[str, ...]) -> dict[str, str]:
    """Return assignments by key; the last one of a key counts."""
    return {key.strip(): value.strip() for key, _, value in (each.partition("=") for each in settings)}


def _edit(label: str, scene: Scene, steps: list[Step]) -> Edit:
    """Return an edit that gives a scene these steps; a preset gets a new name.

    Raises:
        SceneError: the steps are invalid; names the field.
    """
    lesson = Lesson(steps=tuple(steps)) if steps else None
    if len(steps) > 20:
        raise SceneError(Text("{where}: a lesson has 20 steps at most", where="lesson.steps"))
    # With a separate body, since the scene's may be large: it has as many masses as are moved.
    moved = [one.mass for step in steps if step.run for one in (*step.run.pulls, *step.run.leads)]
    masses = (Mass(position=(0.0, 0.0)),) * min(1 + max(moved, default=0), len(scene.masses))
    validate(Scene(name="lesson", masses=masses, lesson=lesson))
    own = {"name": OWN_LESSON, "title": ""} if is_built_in(scene.name) else {}
    return Edit(label, msgspec.structs.replace(scene, lesson=lesson, **own))
