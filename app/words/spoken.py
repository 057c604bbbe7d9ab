"""Languages: which there are, which one is spoken now, and how numbers and lists are written in it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from babel.lists import format_list
from babel.numbers import format_decimal, get_decimal_symbol

ENGLISH = "en"
"""The language in which texts are written first."""

PSEUDO = "en-XA"
"""English with accents and longer words. What stays plain is said by no message; what is cut has no room."""

FOLDER = Path(__file__).parent
"""The texts, a folder a language."""

_RANGE = re.compile(r"\s*([A-Za-z]{1,8}(?:-[A-Za-z0-9]{1,8})*|\*)\s*(?:;\s*q\s*=\s*([0-9.]{1,5}))?\s*")
_NAMED = re.compile(r"^language-(name|direction|quoted) = (.+)$", re.MULTILINE)
_ACCENTS = str.maketrans("aceinouyACDEINOSUYZdgklrstz", "àçéîñöüýÀÇÐÉÎÑÖŠÛÝŽðğķļŕšťž")

_now: ContextVar[str] = ContextVar("language", default=ENGLISH)


@dataclass(frozen=True, slots=True)
class Language:
    """A language that softrod speaks.

    Attributes:
        tag: by BCP 47, as in ``de``.
        name: what those who speak it call it.
        direction: ``ltr``, or ``rtl`` where text runs from right to left.
        quoted: ``{ $text }`` in quotation marks.
    """

    tag: str
    name: str
    direction: str
    quoted: str


@cache
def languages() -> dict[str, Language]:
    """The languages by their tags, English first.

    All other files are read when somebody speaks a language: that takes some tenths of a second for each.
    """
    found = {}
    for path in sorted(FOLDER.glob("*/language.ftl"), key=lambda path: (path.parent.name != ENGLISH, path)):
        told, tag = dict(_NAMED.findall(path.read_text(encoding="utf-8"))), path.parent.name
        found[tag] = Language(
            tag, told["name"], told.get("direction", "ltr"), told.get("quoted", "'{ $text }'")
        )
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


def quoted(text: str) -> str:
    """A name, or what was typed, in the quotation marks of the language that is spoken now."""
    if (tag := _locale(_now.get())) == ENGLISH:
        return repr(text)  # as the sentences of `sim` have it
    plain = text if text.isprintable() else repr(text)[1:-1]
    return languages()[tag].quoted.replace("{ $text }", plain)


def number(value: float, digits: int = 3) -> str:
    """A number with some significant digits at most, as the language that is spoken now writes it."""
    rounded = float(f"{value:.{digits}g}") + 0.0  # no -0
    return format_decimal(rounded, "#0.############", _locale(_now.get()))


def decimal(text: str) -> str:
    """A number that is written in English, as it is written in the language that is spoken now."""
    point = get_decimal_symbol(_locale(_now.get()))
    return text if point == "." else text.translate({ord(","): "\u202f", ord("."): point})


def upright(text: str) -> str:
    """A number with its unit, which keeps its direction in a text from right to left."""
    return f"\u2066{text}\u2069" if direction() == "rtl" else text


def has_decimal_comma() -> bool:
    """Whether the language that is spoken now writes a comma before decimals."""
    return get_decimal_symbol(_locale(_now.get())) == ","


def listed(items: Sequence[str]) -> str:
    """Some texts as a list, as in "a, b and c"."""
    tag = _now.get()
    text = format_list(list(items), locale="en_GB" if _locale(tag) == ENGLISH else tag)
    return text.replace(" and ", f" {pseudo('and')} ") if tag == PSEUDO else text


def _locale(tag: str) -> str:
    return ENGLISH if tag == PSEUDO else tag


def pseudo(text: str) -> str:
    """A text in pseudo-English, 40 percent longer."""
    return " ".join(word.translate(_ACCENTS) + "·" * round(0.4 * len(word)) for word in text.split(" "))
