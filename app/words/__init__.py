"""What softrod says, in the language of whoever it says it to.

Texts are Fluent messages (https://projectfluent.org): a folder a language, `app/words/de`, and in it a file
for each part of the program. Whoever handles a page does so inside `speaking` its language; `say` gives a
text. A message that a language lacks is said in English.

A page is sent those messages only that its script names, as the text that `of_script` makes.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterable
from functools import cache, reduce
from typing import Literal

from fluent.runtime import FluentBundle
from fluent.syntax import FluentParser, ast
from fluent.syntax.serializer import FluentSerializer
from fluent.syntax.visitor import Transformer

from sim.text import Text

from . import spoken
from .english import of
from .keys import Key
from .spoken import (
    ENGLISH,
    PSEUDO,
    choose,
    decimal,
    direction,
    language,
    languages,
    listed,
    number,
    pseudo,
    quoted,
    speaking,
    upright,
)  # fmt: skip

__all__ = [
    "ENGLISH", "PSEUDO", "bundle_of", "choose", "decimal", "direction", "element", "entries", "find",
    "joined", "language", "languages", "listed", "localized", "messages", "number", "of", "of_script",
    "pseudo", "quoted", "say", "speaking", "upright", "way_of",
]  # fmt: skip

_KEY = re.compile(r'["\']([a-z][a-z0-9]*(?:-[a-z0-9]+)+)(?:\.[a-z]+)?["\']')
_PLACE = re.compile(r"\{say ([a-z0-9-]+)((?:\.[a-z]+)?)\}")
_VALUE = re.compile(r"\{ \$([A-Za-z]+)")


def say(key: Key, **values: str | float) -> str:
    """A text in the language that is spoken now.

    Args:
        key: the message's, or that of one of its attributes, as in ``play-step.hint``.
        values: what stands in its places; whole numbers choose between its plural forms.
    """
    return _text(language(), key, **values)


def joined(
    items: Iterable[str], by: Literal["language-comma", "language-semicolon"] = "language-comma"
) -> str:
    """Some texts after one another, as in "a, b, c"; empty ones are left out."""
    told = [item for item in items if item]
    return reduce(lambda before, after: say(by, before=before, after=after), told) if told else ""


def find(key: str, otherwise: str = "") -> str:
    """A text without places, by a key that is made of a name; something else where there is no such text."""
    name, _, attribute = key.partition(".")
    entry = messages(language()).get(name)
    there = entry.value is not None if entry else False
    if entry and attribute:
        there = any(each.id.name == attribute for each in entry.attributes)
    return _text(language(), key) if there else otherwise


def _text(tag: str, key: str, **values: str | float) -> str:
    bundle, (name, _, attribute) = bundle_of(tag), key.partition(".")
    message = bundle.get_message(name)
    pattern = message.attributes[attribute] if attribute else message.value
    assert pattern is not None, f"{key} has no text"
    own = {name: of(value) if isinstance(value, Text) else value for name, value in values.items()}
    return str(bundle.format_pattern(pattern, own)[0])


# ------------------------------------------------------------------------- files
@cache
def entries(tag: str) -> dict[str, ast.Message]:
    """The messages of a language by their names, those only that it has itself.

    Raises:
        ValueError: a file has an error, or two have the same message.
    """
    if tag == PSEUDO:
        return {name: Pseudo().visit(entry.clone()) for name, entry in entries(ENGLISH).items()}
    found, faults = parsed(tag)
    if faults:
        raise ValueError("\n".join(faults))
    return {name: entry for name, (_, entry) in found.items()}


def parsed(tag: str) -> tuple[dict[str, tuple[str, ast.Message]], list[str]]:
    """The messages that a language has itself, each with the name of its file, and what is wrong with the
    files, a sentence each."""
    found: dict[str, tuple[str, ast.Message]] = {}
    faults: list[str] = []
    for path in sorted((spoken.FOLDER / tag).glob("*.ftl")):
        for entry in FluentParser(with_spans=False).parse(path.read_text(encoding="utf-8")).body:
            if isinstance(entry, ast.Junk):
                faults.append(f"{path.name} of {tag}: {entry.annotations[0].message} in {entry.content!r}")
            if isinstance(entry, ast.Message):
                entry.comment = None
                first, _ = found.setdefault(name := entry.id.name, (path.name, entry))
                if found[name][1] is not entry:
                    faults.append(f"{path.name} of {tag}: the message {name} is there already, in {first}")
    return found, faults


class Pseudo(Transformer):
    """Makes a message's text pseudo-English."""

    def visit_TextElement(self, node: ast.TextElement) -> ast.TextElement:
        node.value = pseudo(node.value)
        return node


@cache
def messages(tag: str) -> dict[str, ast.Message]:
    """All messages; texts that the language lacks, of whole messages or of their attributes, are English."""
    found = dict(entries(ENGLISH))
    for name, own in entries(tag).items():
        if (english := found.get(name)) is not None:
            own, had = own.clone(), {each.id.name for each in own.attributes}
            own.value = own.value or english.value
            own.attributes += [each for each in english.attributes if each.id.name not in had]
        found[name] = own
    return found


@cache
def bundle_of(tag: str) -> FluentBundle:
    # Marks around what stands in a text's places, which keep its direction, matter where directions mix.
    mixes = tag in languages() and languages()[tag].direction == "rtl"
    bundle = FluentBundle([tag], use_isolating=mixes)
    bundle.add_resource(ast.Resource(list(messages(tag).values())))
    return bundle


# ------------------------------------------------------------------------- what is sent to a page
def of_script(script: str, tag: str) -> str:
    """The messages, as Fluent's text, whose keys stand as strings in a script."""
    named = {match[1] for match in _KEY.finditer(script)} & entries(ENGLISH).keys()
    serializer, all_of = FluentSerializer(), messages(tag)
    return "".join(serializer.serialize_entry(all_of[name]) for name in sorted(named))


def localized(page: str, tag: str, script: str = "") -> str:
    """A page in a language.

    Args:
        page: HTML, in English; ``{say class-title}`` is where a text stands, and ``{words}`` where those do
            that its script says. What stands in a text's places is for a script to fill, as in ``{count}``.
        tag: the language.
        script: the page's.
    """

    def fill(match: re.Match[str]) -> str:
        values = _VALUE.findall(FluentSerializer().serialize_entry(messages(tag)[match[1]]))
        return html.escape(_text(tag, match[1] + match[2], **{name: f"{{{name}}}" for name in values}))

    said = _PLACE.sub(fill, page)
    return said.replace('<html lang="en"', f"<html {way_of(tag)}", 1).replace(
        "{words}", element(script, tag, _offered()), 1
    )


def way_of(tag: str) -> str:
    """The attributes of an element whose text is in a language."""
    way = languages()[tag].direction if tag in languages() else "ltr"
    return f'lang="{tag}"' if way == "ltr" else f'lang="{tag}" dir="{way}"'


def element(script: str, tag: str, offered: str = "") -> str:
    """The element that holds what a page's script says; nothing if it says nothing.

    Args:
        script: the page's.
        tag: the language.
        offered: an attribute that lists the languages that can be chosen there.
    """
    texts = of_script(script, tag)
    return f'<script type="text/plain" id="words" {way_of(tag)}{offered}>{texts}</script>' if texts else ""


def _offered() -> str:
    """The languages as an attribute, which `words.js` reads."""
    names = ";".join(f"{each.tag}={each.name}" for each in languages().values())
    return f' data-languages="{html.escape(names)}"'
