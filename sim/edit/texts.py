"""A scene's name and its description."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import msgspec

from ..scene.lesson import Lesson, Question, Step
from ..scene.parts import Mass
from ..scene.types import Scene, shown_name
from ..scene.validate import validate
from ..store.files import is_built_in, safe_name
from ..text import Text
from .edit import Edit

UNNAMED = str.__str__(Text("my scene"))
"""Name of a scene made from a preset, until it gets another name; translated, but a plain str for files."""


def with_texts(scene: Scene, change: Callable[[str], str]) -> Scene:
    """Return a scene with other texts for readers: its title and description, and those of its lesson.

    Args:
        scene: the scene.
        change: returns what stands instead of a text; it is called in the order in which texts are read.
    """
    title, description = change(scene.title), change(scene.description)
    lesson = (
        Lesson(steps=tuple(step_with_texts(step, change) for step in scene.lesson.steps))
        if scene.lesson
        else None
    )
    return msgspec.structs.replace(scene, title=title, description=description, lesson=lesson)


def step_with_texts(step: Step, change: Callable[[str], str]) -> Step:
    """Return a step of a lesson with other texts for readers, see `with_texts`."""
    texts = {"title": change(step.title), "do": change(step.do), "watch": change(step.watch)}
    question = step.question
    if question is None:
        return msgspec.structs.replace(step, **texts)
    return msgspec.structs.replace(step, question=question_with_texts(question, change), **texts)


def question_with_texts(question: Question, change: Callable[[str], str]) -> Question:
    """Return a question with other texts, see `with_texts`."""
    text, choices = change(question.text), tuple(map(change, question.choices))
    return msgspec.structs.replace(question, text=text, choices=choices, because=change(question.because))


def set_texts(scene: Scene, name: str, description: str) -> Edit:
    """Give a scene another name and another description.

    Args:
        scene: the scene.
        name: the new name, made safe for a file, see `sim.store.files.safe_name`. The scene is saved under it
            and has no other title. If it is already the shown name, both are kept.
        description: the new text. Surrounding spaces and empty lines are removed.

    Raises:
        SceneError: the name is empty or that of a preset, or a text is too long; one sentence.
    """
    description = "\n".join(line.rstrip() for line in description.strip().splitlines())
    name = " ".join(name.split())
    # With a separate body, since the scene's may be large.
    validate(Scene(name=name, description=description, masses=(Mass(position=(0.0, 0.0)),)))
    changes: dict[str, str] = {}
    if name != shown_name(scene):
        changes |= {"name": safe_name(name), "title": ""}
    if description != scene.description:
        changes["description"] = description
    if not changes:
        return Edit("", scene)
    label = "scene renamed" if "name" in changes else "scene described"
    return Edit(label, msgspec.structs.replace(scene, **changes))


def renamed(scene: Scene, name: str) -> Edit:
    """Give a scene the name under which it was saved, and no other title."""
    if (scene.name, scene.title) == (name, ""):
        return Edit("", scene)
    return Edit("scene renamed", msgspec.structs.replace(scene, name=name, title=""))


def as_own(edit: Edit, before: Scene) -> Edit:
    """Return the edit; if it adds or removes parts of a preset, the scene is no longer that preset and gets a
    new name and an empty description. A lesson keeps its texts.

    Args:
        edit: an edit of `before`.
        before: the scene that was edited.
    """
    if not edit.moves_parts or before.lesson is not None or not is_built_in(before.name):
        return edit
    own = msgspec.structs.replace(edit.scene, name=UNNAMED, title="", description="")
    return replace(edit, scene=own)
