"""Whether every step of a scene's lesson can begin, for `softrod check`."""

from __future__ import annotations

import sim
from sim.errors import InputError
from sim.lesson_settings import scene_of_step

from .session.plots import Plot, wish_of


def check_lesson(scene: sim.Scene) -> None:
    """Try what each step sets and plots, one after the other.

    Raises:
        SettingError: something cannot be set.
        InputError: something cannot be plotted; both name the field.
    """
    for number, step in enumerate(scene.lesson.steps if scene.lesson else ()):
        scene = scene_of_step(scene, number)
        for i, text in enumerate(step.plots or ()):
            try:
                Plot(wish_of(text), scene)
            except InputError as error:
                raise InputError(f"lesson.steps[{number}].plots[{i}]: {error}") from None
