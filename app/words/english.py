"""Texts that are known by their English, in the language that is spoken now: those of presets and lessons.

A scene keeps its texts as they were written, so it can be saved, shared and shown to several people, each in
a language of their own. `of` is for where a text is shown. A language's folder has a file a preset,
`app/words/de/scenes/rope.json`: an object with English texts and what they are in that language.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import msgspec

from sim.edit.texts import step_with_texts, with_texts
from sim.scene.lesson import Step
from sim.scene.types import Scene, shown_name

from . import ENGLISH, FOLDER, PSEUDO, language, pseudo

SCENES = "scenes"
"""The folder of a language with the texts of presets."""


@cache
def catalogue(tag: str) -> dict[str, str]:
    """What texts are in a language, by their English; those that the language lacks are left out."""
    return {english: own for path in files(tag) for english, own in read(path).items() if own}


def files(tag: str) -> list[Path]:
    """The files of a language's texts."""
    return sorted((FOLDER / tag / SCENES).glob("*.json"))


def read(path: Path) -> dict[str, str]:
    """What a file of texts has.

    Raises:
        ValueError: it is no object with texts.
    """
    try:
        return msgspec.json.decode(path.read_bytes(), type=dict[str, str])
    except msgspec.DecodeError as error:
        raise ValueError(f"{path.parent.parent.name}/{SCENES}/{path.name}: {error}") from None


def of(text: str) -> str:
    """A text in the language that is spoken now; as it is if the language has no other."""
    tag = language()
    if tag == ENGLISH:
        return text
    return pseudo(text) if tag == PSEUDO else catalogue(tag).get(text, text)


def name_of(scene: Scene) -> str:
    """The name under which a scene is shown."""
    return of(shown_name(scene))


def step_of(step: Step) -> Step:
    """A step of a lesson, with its texts in the language that is spoken now."""
    return step if language() == ENGLISH else step_with_texts(step, of)


def written(text: str, scene: Scene) -> str:
    """What a scene has itself for a text that came back from a form, if nobody has changed it there."""
    if language() == ENGLISH:
        return text
    known: dict[str, str] = {}
    with_texts(scene, lambda own: known.setdefault(of(own), own))
    return known.get(text, text)
