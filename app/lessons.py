"""Lessons: a check that every step can begin, for `softrod check`; their codes; goals in words."""

from __future__ import annotations

import contextlib
import hashlib
import re
from collections.abc import Iterator

import msgspec

import sim
from sim.errors import InputError
from sim.motion.quantities import quantity
from sim.scene.lesson import Goal, Reading, Step, StepRun
from sim.settings import CHOICES, scene_of_run, scene_of_step, setting_of
from sim.solve.registry import METHODS

from .session.ghost import REFERENCE
from .session.plots import Plot, parse_plot

MAX_TOLD = 3
"""Pulls of a run that are told one by one."""

_NAME = re.compile(r"(?:(mass|spring|joint)(\d+)|[a-z]+)\.([a-z_]+)", re.ASCII)
"""The name of a quantity: what it is of, with its number, and what it is."""

_WORDS = {"elongation": "stretch", "dt over limit": "time step, as a part of its limit"}
"""Of quantities, for pupils."""


def check_lesson(scene: sim.Scene) -> None:
    """Check what each step sets, shows and plots, one after the other.

    Raises:
        SettingError: something cannot be set, or has no slider; names the field.
        InputError: something cannot be plotted, compared or measured; names the field.
    """
    for number, step in enumerate(scene.lesson.steps if scene.lesson else ()):
        place = f"lesson.steps[{number}]"
        scene_of_run(scene, number)
        scene = scene_of_step(scene, number)
        for i, key in enumerate(step.controls):
            if key not in CHOICES or not CHOICES[key].applies(scene):
                with _at(f"{place}.controls[{i}]"):
                    setting_of(scene, key)
        if step.ghost is not None and step.ghost not in (REFERENCE, *METHODS):
            known = ", ".join((REFERENCE, *METHODS))
            raise InputError(f"{place}.ghost: {step.ghost!r} is not one of {known}")
        for i, text in enumerate(step.plots or ()):
            with _at(f"{place}.plots[{i}]"):
                Plot(parse_plot(text), scene)
        for field, reading in (("goal", step.goal), ("collect", step.collect)):
            if reading is not None:
                with _at(f"{place}.{field}.quantity"):
                    quantity(reading.quantity, scene)


@contextlib.contextmanager
def _at(place: str) -> Iterator[None]:
    """Have errors name the field."""
    try:
        yield
    except (sim.SettingError, InputError) as error:
        raise type(error)(f"{place}: {error}") from None


def lesson_code(scene: sim.Scene) -> str:
    """Eight hexadecimal digits that link answers to the lesson of a scene.

    They depend on questions, choices, predictions and the number of masses. The rest of a lesson may be
    corrected without losing its answers.
    """
    steps = scene.lesson.steps if scene.lesson is not None else ()
    asked = [
        (step.question.text, step.question.choices, step.predict) if step.question else ("", (), step.predict)
        for step in steps
    ]
    return hashlib.sha256(msgspec.json.encode((len(scene.masses), asked))).hexdigest()[:8]


def read_masses(step: Step, scene: sim.Scene) -> tuple[int, ...]:
    """The masses that a step reads: those of its plots, of its goal, and of what it collects.

    Of a joint they are the ends of its springs that it does not share, of a spring both ends, of a formula
    those of its quantities.
    """
    names = [name for text in step.plots or () for name in (*parse_plot(text).names, parse_plot(text).over)]
    names += [reading.quantity for reading in (step.goal, step.collect) if reading is not None]
    found: set[int] = set()
    springs = scene.linear_springs
    for each in (each for name in names for each in _measured(name, scene)):
        if each.kind.of in ("mass", "body"):
            found.update(each.indices)
        elif each.kind.of == "spring":
            found |= {springs[each.index].a, springs[each.index].b}
        elif each.kind.of == "joint":
            joint = scene.angular_springs[each.index]
            one, other = ({springs[s].a, springs[s].b} for s in (joint.a, joint.b))
            found |= one ^ other
    return tuple(sorted(found))


def _measured(name: str, scene: sim.Scene) -> tuple[sim.Quantity, ...]:
    """What is measured for a quantity; nothing if the scene does not have it."""
    try:
        return quantity(name, scene).measured
    except InputError:
        return ()


def quantity_text(name: str) -> str:
    """A quantity in words, as in "stretch of spring 0"."""
    return reading_text(Reading(quantity=name))


def reading_text(reading: Reading, scene: sim.Scene | None = None) -> str:
    """A reading in words, as in "stretch of spring 0" or "period of mass 1"."""
    name = _NAME.fullmatch(reading.quantity)
    if name is None:
        return f"period of {reading.quantity}" if reading.of == "period" else reading.quantity
    what, owner = name[3].replace("_", " "), f"{name[1]} {name[2]}" if name[1] else ""
    if reading.quantity.startswith("body."):
        owner = "the body"
    if reading.of == "period":
        return f"period of {owner or what}"
    return f"{_WORDS.get(what, what)} of {owner}" if owner else _WORDS.get(what, what)


def reading_unit(reading: Reading, scene: sim.Scene) -> str:
    """The unit of a reading; empty for one that the scene does not have."""
    try:
        return "s" if reading.of == "period" else quantity(reading.quantity, scene).unit
    except InputError:
        return ""


def goal_text(goal: Goal, scene: sim.Scene) -> str:
    """A goal in words, as in "period of mass1.y: 1.98 to 2.02 s"."""
    unit = reading_unit(goal, scene)
    low, high = (None if bound is None else f"{bound:.6g}" for bound in (goal.low, goal.high))
    span = f"{low} to {high}" if low and high else f"at least {low}" if low else f"at most {high}"
    held = f", for {goal.seconds:g} s" if goal.seconds else ""
    return f"{reading_text(goal, scene)}: {span} {unit}".rstrip() + held


def run_text(run: StepRun, scene: sim.Scene) -> str:
    """A run in words, as in "Gravity 2000 px/s²; mass 1 is pulled 150 px down and let go"."""
    said = []
    for assignment in run.settings:
        key, _, value = assignment.partition("=")
        if key in CHOICES:
            said.append(f"{CHOICES[key].label}: {CHOICES[key].options.get(value, value)}")
            continue
        try:
            setting = setting_of(scene, key)
        except sim.SettingError:
            said.append(assignment)
        else:
            said.append(f"{setting.label} {value} {setting.unit.replace('px', scene.view.unit)}".rstrip())
    few = run.pulls if len(run.pulls) <= MAX_TOLD else ()
    if len(run.pulls) > len(few):
        said.append(f"{len(run.pulls)} masses are pulled aside and let go")
    for pull in few:
        x, y = pull.by
        down = y if scene.view.y_down else -y
        ways = [(abs(x), "right" if x > 0.0 else "left"), (abs(down), "down" if down > 0.0 else "up")]
        way = " and ".join(
            f"{round(by) if by >= 1.0 else by:g} {scene.view.unit} {word}" for by, word in ways if by
        )
        said.append(f"mass {pull.mass} is pulled {way} and let go")
    for circle in dict.fromkeys(one.circle for one in run.leads):
        led = [str(one.mass) for one in run.leads if one.circle == circle]
        who = f"masses {', '.join(led)} are" if len(led) > 1 else f"mass {led[0]} is"
        around = f"a circle of {circle.radius:g} {scene.view.unit}"
        said.append(f"{who} led round {around}, {circle.frequency:g} times a second")
    resting = [str(one.joint) for one in run.muscles if not (one.muscle and one.muscle.amplitude)]
    if resting:
        said.append(f"the muscle at joint {', '.join(resting)} rests")
    if moving := len(run.muscles) - len(resting):
        said.append(f"{moving} muscles move at another moment or by another angle")
    return f"{'; '.join(said)}."
