"""Checks the texts of a language against the English ones.

`uv run python -m tests.words de` says which texts German still lacks, and what is wrong with those that it
has; without a language it counts those of all. It fails where something is wrong, not where something is
missing.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator

from fluent.syntax import ast

from app.words import ENGLISH, entries, languages
from tests.page.generate import places

_TAG = re.compile(r"<[a-z/][^>]*>")


def texts(tag: str) -> dict[str, ast.Pattern]:
    """The texts that a language has itself, by their keys."""
    found: dict[str, ast.Pattern] = {}
    for name, entry in entries(tag).items():
        if entry.value is not None:
            found[name] = entry.value
        for attribute in entry.attributes:
            found[f"{name}.{attribute.id.name}"] = attribute.value
    return found


def plain(pattern: ast.Pattern) -> str:
    """What a text says besides what stands in its places."""
    return "".join(part.value for part in pattern.elements if isinstance(part, ast.TextElement))


def missing(tag: str) -> list[str]:
    """The keys of the texts that a language lacks."""
    return sorted(texts(ENGLISH).keys() - texts(tag).keys())


def wrong(tag: str) -> Iterator[str]:
    """Say what is wrong with a language, a sentence each."""
    english, own = texts(ENGLISH), texts(tag)
    for key, pattern in own.items():
        if key not in english:
            yield f"{key} is no English text"
            continue
        here, there = set(places(pattern)), set(places(english[key]))
        if here != there:
            yield f"{key} has the places {sorted(here)}, but in English {sorted(there)}"
        if sorted(_TAG.findall(plain(pattern))) != sorted(_TAG.findall(plain(english[key]))):
            yield f"{key} has other marks than in English"
    if languages()[tag].direction not in ("ltr", "rtl"):
        yield "language-direction is neither ltr nor rtl"


def main(tags: list[str]) -> int:
    """Print what is missing and what is wrong; 1 if anything is wrong."""
    status = 0
    for tag in tags or [tag for tag in languages() if tag != ENGLISH]:
        if tag not in languages():
            print(f"{tag}: there is no app/words/{tag}/language.ftl", file=sys.stderr)
            return 2
        lacking, faults = missing(tag), list(wrong(tag))
        name, count = languages()[tag].name, len(texts(tag))
        print(f"{name} ({tag}): {count} texts, {len(lacking)} missing, {len(faults)} wrong")
        for sentence in faults:
            print(f"  {sentence}")
        for key in lacking if tags else ():
            print(f"  missing: {key} = {plain(texts(ENGLISH)[key])[:80]}")
        status = status or bool(faults)
    return int(status)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
