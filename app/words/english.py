"""Texts that are known by their English, in the language that is spoken now.

They are those of presets and lessons, and the sentences of `sim`. A scene keeps its texts as they were
written, so it can be saved, shared and shown to several people, each in a language of their own. `of` is for
where a text is shown.

A language's folder has a file a preset, `app/words/de/scenes/rope.json`, and `app/words/de/sim.json`: objects
with English texts and what they are in that language. Of a sentence it is the template, see `sim.text`.
"""

from __future__ import annotations

import re
import string
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from sim.edit.texts import step_with_texts, with_texts
from sim.scene.lesson import Step
from sim.scene.types import Scene, shown_name
from sim.text import Text

from . import spoken
from .spoken import ENGLISH, PSEUDO, decimal, language, pseudo, quoted

SCENES = "scenes"
"""The folder of a language with the texts of presets."""

SIM = "sim.json"
"""The file of a language with the sentences of `sim`."""


_WORD = re.compile(r"[^\W\d_]+(?![\w.(\[=])")
"""A word, and no address of a part, as in ``mass3.y``."""


@cache
def catalogue(tag: str) -> dict[str, str]:
    """What texts are in a language, by their English; those that the language lacks are left out."""
    return {english: own for path in files(tag) for english, own in read(path).items() if own}


def files(tag: str) -> list[Path]:
    """The files of a language's texts that are known by their English."""
    folder = spoken.FOLDER / tag
    return [*sorted((folder / SCENES).glob("*.json")), *folder.glob(SIM)]


def read(path: Path) -> dict[str, str]:
    """What a file of texts has.

    Raises:
        ValueError: it is no object with texts.
    """
    try:
        return msgspec.json.decode(path.read_bytes(), type=dict[str, str])
    except msgspec.DecodeError as error:
        raise ValueError(f"{path}: {error}") from None


class _Filled(string.Formatter):
    """Fills a template with texts and numbers as the language writes them."""

    def convert_field(self, value: Any, conversion: str | None) -> Any:
        """See `string.Formatter`; a text in a place is said in the same language."""
        said = of(value) if isinstance(value, Text) else value
        return (
            quoted(said)
            if conversion == "r" and isinstance(said, str)
            else super().convert_field(said, conversion)
        )

    def format_field(self, value: Any, format_spec: str) -> str:
        """See `string.Formatter`."""
        text = super().format_field(value, format_spec)
        return decimal(text) if isinstance(value, float) else text


def _pseudo_template(template: str) -> str:
    """A template whose text is in pseudo-English."""
    pieces = []
    for literal, name, form, conversion in string.Formatter().parse(template):
        pieces.append(pseudo(literal).replace("{", "{{").replace("}", "}}"))
        if name is not None:
            how = (f"!{conversion}" if conversion else "") + (f":{form}" if form else "")
            pieces.append(f"{{{name}{how}}}")
    return "".join(pieces)


def of(text: str) -> str:
    """A text in the language that is spoken now; as it is if the language has no other."""
    tag = language()
    if tag == ENGLISH:
        return str.__str__(text)
    if isinstance(text, Text):
        own = catalogue(tag).get(text.template, text.template)
        template = _pseudo_template(own) if tag == PSEUDO else own
        return _Filled().vformat(template, (), text.parts)
    return pseudo(text) if tag == PSEUDO else catalogue(tag).get(text, text)


def refusal(error: Exception) -> str:
    """What an error says, as a sentence."""
    return sentence(of(str(error)))


def without_field(text: str, field: str) -> str:
    """A refusal in the language that is spoken now, without the field that stands before it.

    Args:
        text: the refusal, of the kind ``lesson.steps[0].title: it must not be empty``.
        field: as it stands there, without the colon; languages differ in the space before that.
    """
    return re.sub(rf"{re.escape(field)}\s*:\s*", "", of(text), count=1)


def sentence(text: str) -> str:
    """A text with a capital letter and a full stop; a name or an address at its beginning stays as it is."""
    first = text[:1]
    if _WORD.match(text):
        first = "İ" if first == "i" and language() == "tr" else first.upper()
    return f"{first}{text[1:]}{'' if text.endswith(('.', '?', '؟')) else '.'}"


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
    known = {name_of(scene): shown_name(scene)}
    with_texts(scene, lambda own: known.setdefault(of(own), own))
    return known.get(text, text)
