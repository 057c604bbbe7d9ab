"""Lessons: a check that every step can begin, for `softrod check`; their codes; goals in words."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Iterator

import msgspec

import sim
from sim.errors import InputError
from sim.methods.registry import METHODS
from sim.motion.quantities import quantity
from sim.scene.lesson import Goal, Reading
from sim.settings import CHOICES, scene_of_run, scene_of_step, setting_of

from .session.ghost import REFERENCE
from .session.plots import Plot, parse_plot


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


def reading_text(reading: Reading, scene: sim.Scene) -> str:
    """A reading in words, as in "period of mass1.y"."""
    return f"period of {reading.quantity}" if reading.of == "period" else reading.quantity


def goal_text(goal: Goal, scene: sim.Scene) -> str:
    """A goal in words, as in "period of mass1.y: 1.98 to 2.02 s"."""
    try:
        unit = "s" if goal.of == "period" else quantity(goal.quantity, scene).unit
    except InputError:
        unit = ""
    low, high = (None if bound is None else f"{bound:.6g}" for bound in (goal.low, goal.high))
    span = f"{low} to {high}" if low and high else f"at least {low}" if low else f"at most {high}"
    held = f", for {goal.seconds:g} s" if goal.seconds else ""
    return f"{reading_text(goal, scene)}: {span} {unit}".rstrip() + held
