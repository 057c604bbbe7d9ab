"""Whether every step of a scene's lesson can begin, for `softrod check`."""

from __future__ import annotations

import sim
from sim.errors import InputError
from sim.methods.registry import METHODS
from sim.motion.quantities import quantity
from sim.settings import CHOICES, scene_of_step, setting_of

from .session.ghost import REFERENCE
from .session.plots import Plot, wish_of


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
                Plot(wish_of(text), scene)
            except InputError as error:
                raise InputError(f"lesson.steps[{number}].plots[{i}]: {error}") from None
        for field, reading in (("goal", step.goal), ("collect", step.collect)):
            if reading is not None:
                try:
                    quantity(reading.quantity, scene)
                except InputError as error:
                    raise InputError(f"lesson.steps[{number}].{field}.quantity: {error}") from None
