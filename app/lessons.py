"""Lessons: whether every step can begin, for `softrod check`, goals in words, and how answers know them."""

from __future__ import annotations

import hashlib

import msgspec

import sim
from sim.errors import InputError
from sim.methods.registry import METHODS
from sim.motion.quantities import quantity
from sim.scene.lesson import Goal, Reading
from sim.settings import CHOICES, scene_of_step, setting_of

from .session.ghost import REFERENCE
from .session.plots import Plot, parse_plot


def check_lesson(scene: sim.Scene) -> None:
    """Try what each step sets, shows and plots, one after the other.

    Raises:
        SettingError: something cannot be set, or has no slider.
        InputError: something cannot be plotted or compared with; both name the field.
    """
    for number, step in enumerate(scene.lesson.steps if scene.lesson else ()):
        scene = scene_of_step(scene, number)
        for i, key in enumerate(step.controls):
            try:
                if key not in CHOICES or not CHOICES[key].applies(scene):
                    setting_of(scene, key)
            except sim.SettingError as error:
                raise sim.SettingError(f"lesson.steps[{number}].controls[{i}]: {error}") from None
        if step.ghost is not None and step.ghost not in (REFERENCE, *METHODS):
            known = ", ".join((REFERENCE, *METHODS))
            raise InputError(f"lesson.steps[{number}].ghost: {step.ghost!r} is not one of {known}")
        for i, text in enumerate(step.plots or ()):
            try:
                Plot(parse_plot(text), scene)
            except InputError as error:
                raise InputError(f"lesson.steps[{number}].plots[{i}]: {error}") from None
        for field, reading in (("goal", step.goal), ("collect", step.collect)):
            if reading is not None:
                try:
                    quantity(reading.quantity, scene)
                except InputError as error:
                    raise InputError(f"lesson.steps[{number}].{field}.quantity: {error}") from None


def lesson_code(scene: sim.Scene) -> str:
    """Eight hexadecimal digits by which answers know the lesson of a scene.

    They are others for other questions, choices, predictions or masses. What else a lesson has may be mended
    without losing its answers.
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
