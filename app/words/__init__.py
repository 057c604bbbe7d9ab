"""What softrod says, in the language of whoever it says it to.

Texts are Fluent messages (https://projectfluent.org): a folder a language, `app/words/de`, and in it a file
for each part of the program. Whoever handles a page does so inside `speaking` its language; `say` gives a
text. A message that a language lacks is said in English.

A page is sent those messages only that its script names, as the text that `of_script` makes.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from babel.lists import format_list
from babel.numbers import format_decimal, get_decimal_symbol
from fluent.runtime import FluentBundle
from fluent.syntax import FluentParser, ast
from fluent.syntax.serializer import FluentSerializer
from fluent.syntax.visitor import Transformer

from .keys import Key

ENGLISH = "en"
"""The language in which texts are written first."""

PSEUDO = "en-XA"
"""English with accents and longer words. What stays plain is said by no message; what is cut has no room."""

FOLDER = Path(__file__).parent
_KEY = re.compile(r'["\']([a-z][a-z0-9]*(?:-[a-z0-9]+)+)(?:\.[a-z]+)?["\']')
_PLACE = re.compile(r"\{say ([a-z0-9-]+)((?:\.[a-z]+)?)\}")
_RANGE = re.compile(r"\s*([A-Za-z]{1,8}(?:-[A-Za-z0-9]{1,8})*|\*)\s*(?:;\s*q\s*=\s*([0-9.]{1,5}))?\s*")
_NAMED = re.compile(r"^language-(name|direction) = (.+)$", re.MULTILINE)
_VALUE = re.compile(r"\{ \$([A-Za-z]+)")
_ACCENTS = str.maketrans("aceinouyACDEINOSUYZdgklrstz", "àçéîñöüýÀÇÐÉÎÑÖŠÛÝŽðğķļŕšťž")

_now: ContextVar[str] = ContextVar("language", default=ENGLISH)


@dataclass(frozen=True, slots=True)
class Language:
    """A language that softrod speaks.

    Attributes:
        tag: by BCP 47, as in ``de``.
        name: what those who speak it call it.
        direction: ``ltr``, or ``rtl`` where text runs from right to left.
    """

    tag: str
    name: str
    direction: str


@cache
def languages() -> dict[str, Language]:
    """The languages by their tags, English first.

    All other files are read when somebody speaks a language: that takes some tenths of a second for each.
    """
    found = {}
    for path in sorted(FOLDER.glob("*/language.ftl"), key=lambda path: (path.parent.name != ENGLISH, path)):
        told, tag = dict(_NAMED.findall(path.read_text(encoding="utf-8"))), path.parent.name
        found[tag] = Language(tag, told["name"], told.get("direction", "ltr"))
    return found


def choose(asked: str, accepted: str = "") -> str:
    """The language to speak.

    Args:
        asked: the tag that somebody chose; anything else if nobody did.
        accepted: the header ``Accept-Language``, which may be anything.
    """
    if asked in languages() or asked == PSEUDO:
        return asked
    best, liked = ENGLISH, 0.0
    for part in accepted[:1000].split(","):
        if not (match := _RANGE.fullmatch(part)):
            continue
        tag = match[1].split("-")[0].lower()
        try:
            weight = float(match[2] or 1.0)
        except ValueError:
            continue
        if tag in languages() and liked < weight <= 1.0:
            best, liked = tag, weight
    return best


def language() -> str:
    """The tag of the language that is spoken now."""
    return _now.get()


def direction() -> str:
    """The direction of its text, ``ltr`` or ``rtl``."""
    return languages()[_now.get()].direction if _now.get() in languages() else "ltr"


@contextmanager
def speaking(tag: str) -> Iterator[None]:
    """Speak a language; nested calls return to the one before."""
    token = _now.set(tag)
    try:
        yield
    finally:
        _now.reset(token)


def say(key: Key, **values: str | float) -> str:
    """A text in the language that is spoken now.

    Args:
        key: the message's, or that of one of its attributes, as in ``play-step.hint``.
        values: what stands in its places; whole numbers choose between its plural forms.
    """
    return _text(_now.get(), key, **values)


def find(key: str, otherwise: str = "") -> str:
    """A text without places, by a key that is made of a name; something else where there is no such text."""
    name, _, attribute = key.partition(".")
    entry = messages(_now.get()).get(name)
    there = entry.value is not None if entry else False
    if entry and attribute:
        there = any(each.id.name == attribute for each in entry.attributes)
    return _text(_now.get(), key) if there else otherwise


def number(value: float, digits: int = 3) -> str:
    """A number with some significant digits at most, as the language that is spoken now writes it."""
    rounded = float(f"{value:.{digits}g}")
    return format_decimal(rounded, "#0.############", _locale(_now.get()))


def decimal(text: str) -> str:
    """A number that is written in English, as it is written in the language that is spoken now."""
    point = get_decimal_symbol(_locale(_now.get()))
    return text if point == "." else text.translate({ord(","): "\u202f", ord("."): point})


def listed(items: Sequence[str]) -> str:
    """Some texts as a list, as in "a, b and c"."""
    return format_list(list(items), locale="en_GB" if _locale(_now.get()) == ENGLISH else _now.get())


def _locale(tag: str) -> str:
    return ENGLISH if tag == PSEUDO else tag


def _text(tag: str, key: str, **values: str | float) -> str:
    bundle, (name, _, attribute) = bundle_of(tag), key.partition(".")
    message = bundle.get_message(name)
    pattern = message.attributes[attribute] if attribute else message.value
    assert pattern is not None, f"{key} has no text"
    return str(bundle.format_pattern(pattern, values)[0])


# ------------------------------------------------------------------------- files
@cache
def entries(tag: str) -> dict[str, ast.Message]:
    """The messages of a language by their names, those only that it has itself.

    Raises:
        ValueError: a file has an error, or two have the same message.
    """
    found: dict[str, ast.Message] = {}
    if tag == PSEUDO:
        return {name: Pseudo().visit(entry.clone()) for name, entry in entries(ENGLISH).items()}
    for path in sorted((FOLDER / tag).glob("*.ftl")):
        for entry in FluentParser(with_spans=False).parse(path.read_text(encoding="utf-8")).body:
            if isinstance(entry, ast.Junk):
                raise ValueError(f"{path.name} of {tag}: {entry.annotations[0].message} in {entry.content!r}")
            if isinstance(entry, ast.Message):
                if entry.id.name in found:
                    raise ValueError(f"{path.name} of {tag}: there are two messages {entry.id.name}")
                entry.comment = None
                found[entry.id.name] = entry
    return found


class Pseudo(Transformer):
    """Makes a message's text pseudo-English."""

    def visit_TextElement(self, node: ast.TextElement) -> ast.TextElement:
        node.value = pseudo(node.value)
        return node


def pseudo(text: str) -> str:
    """A text in pseudo-English, 40 percent longer."""
    return " ".join(word.translate(_ACCENTS) + "·" * round(0.4 * len(word)) for word in text.split(" "))


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
