"""What the steps of a lesson set."""

from __future__ import annotations

from ..errors import SettingError
from ..scene.types import Scene
from . import apply_assignments


def scene_of_step(scene: Scene, number: int) -> Scene:
    """The scene with what a step of its lesson sets.

    Args:
        scene: one with a lesson.
        number: of the step, counted from 0.

    Raises:
        SettingError: there is no such step, or something that it sets cannot be set; names the field.
    """
    steps = scene.lesson.steps if scene.lesson else ()
    if not 0 <= number < len(steps):
        raise SettingError(f"lesson.steps: step {number} does not exist")
    for i, assignment in enumerate(steps[number].settings):
        try:
            scene = apply_assignments(scene, (assignment,))
        except SettingError as error:
            raise SettingError(f"lesson.steps[{number}].settings[{i}]: {error}") from None
    return scene
