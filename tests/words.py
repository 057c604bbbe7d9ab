"""Checks the texts of a language against the English ones.

`uv run python -m tests.words de` says which texts German still lacks, and what is wrong with those that it
has; without a language it counts those of all. It fails where something is wrong, not where something is
missing. `uv run python -m tests.words de --write` writes the files of texts that are known by their English
anew: with every English text, and nothing where German has none yet.
"""

from __future__ import annotations

import ast as python
import json
import re
import string
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from fluent.syntax import ast

import sim
from app.words import ENGLISH, entries, languages
from app.words.english import SCENES, SIM, catalogue, files, read
from app.words.spoken import FOLDER
from sim.edit.texts import with_texts
from tests.page.generate import places

_TAG = re.compile(r"<[a-z/][^>]*>")
_PLACE = re.compile(r"\{[^{}]*\}")
_SIM = Path(__file__).parents[1] / "sim"


def texts(tag: str) -> dict[str, ast.Pattern]:
    """The texts that a language has itself, by their keys."""
    found: dict[str, ast.Pattern] = {}
    for name, entry in entries(tag).items():
        if entry.value is not None:
            found[name] = entry.value
        for attribute in entry.attributes:
            found[f"{name}.{attribute.id.name}"] = attribute.value
    return found


@cache
def of_scenes() -> dict[str, list[str]]:
    """The texts of presets in the order in which they are read, by their files; each once."""
    seen: set[str] = {""}
    found: dict[str, list[str]] = {}
    for info in sim.list_scenes():
        own: list[str] = []
        if info.built_in:
            with_texts(sim.load_scene(info.name), lambda text, own=own: own.append(text) or text)
        if new := [text for text in dict.fromkeys(own) if text not in seen]:
            found[f"{info.name}.json"] = new
            seen.update(new)
    return found


def write(tag: str) -> None:
    """Write the files of a language's scenes, with what it has."""
    has = catalogue(tag)
    (folder := FOLDER / tag / SCENES).mkdir(exist_ok=True)
    for old in files(tag):
        old.unlink()
    for name, english in of_scenes().items():
        told = json.dumps({text: has.get(text, "") for text in english}, ensure_ascii=False, indent=1)
        (folder / name).write_text(f"{told}\n", encoding="utf-8")
    told = json.dumps({text: has.get(text, "") for text in sim_templates()}, ensure_ascii=False, indent=1)
    (FOLDER / tag / SIM).write_text(f"{told}\n", encoding="utf-8")


def wrong_templates(own: dict[str, str]) -> Iterator[str]:
    """Say what is wrong with a language's sentences of `sim`, a sentence each."""
    known = set(sim_templates())
    for english, text in own.items():
        if english not in known:
            yield f"{SIM}: {english!r} is no English template"
        elif text and template_places(text) != template_places(english):
            yield f"{SIM}: {text!r} has other places than {english!r}"


def template_places(template: str) -> list[tuple[str, str, str]]:
    """The places of a template of `sim.text`, sorted, each with its format and its conversion."""
    found = string.Formatter().parse(template)
    return sorted((name, form or "", how or "") for _, name, form, how in found if name is not None)


def plain(pattern: ast.Pattern) -> str:
    """What a text says besides what stands in its places."""
    return "".join(part.value for part in pattern.elements if isinstance(part, ast.TextElement))


def missing(tag: str) -> list[str]:
    """The keys of the texts that a language lacks; of scenes, the English texts."""
    lacking = sorted(texts(ENGLISH).keys() - texts(tag).keys())
    lacking += [text for text in sim_templates() if text not in catalogue(tag)]
    return lacking + [text for each in of_scenes().values() for text in each if text not in catalogue(tag)]


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
    known = {text for each in of_scenes().values() for text in each}
    for path in files(tag):
        if path.name == SIM:
            yield from wrong_templates(read(path))
            continue
        for text in read(path).keys() - known:
            yield f"{SCENES}/{path.name}: no scene has the English text {text!r}"
    if languages()[tag].direction not in ("ltr", "rtl"):
        yield "language-direction is neither ltr nor rtl"


def sim_texts() -> Iterator[tuple[str, python.Call]]:
    """Yield the file and the call of every text that `sim` makes, in the order of its sources."""
    for path in sorted(_SIM.rglob("*.py")):
        calls = [
            node
            for node in python.walk(python.parse(path.read_text(encoding="utf-8")))
            if isinstance(node, python.Call) and isinstance(node.func, python.Name) and node.func.id == "Text"
        ]
        for call in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
            yield path.relative_to(_SIM.parent).as_posix(), call


def sim_templates() -> dict[str, str]:
    """The templates of `sim`'s texts, with the first file that has them; only those with any words."""
    found: dict[str, str] = {}
    for path, call in sim_texts():
        match call.args:
            case [python.Constant(str(template))] if re.search(r"[^\W\d_]", _PLACE.sub("", template)):
                found.setdefault(template, path)
            case _:
                pass
    return found


@cache
def _file_of(key: str) -> str:
    """The file of an English text."""
    name = key.partition(".")[0]
    for path in sorted((FOLDER / ENGLISH).glob("*.ftl")):
        if re.search(rf"^{re.escape(name)} =", path.read_text(encoding="utf-8"), re.MULTILINE):
            return path.name
    return next((f"{SCENES}/{file}" for file, each in of_scenes().items() if key in each), SIM)


def main(arguments: list[str]) -> int:
    """Print what is missing and what is wrong; 1 if anything is wrong."""
    tags, status = [each for each in arguments if each != "--write"], 0
    for tag in tags or [tag for tag in languages() if tag != ENGLISH]:
        if tag not in languages():
            print(f"{tag}: there is no app/words/{tag}/language.ftl", file=sys.stderr)
            return 2
        if "--write" in arguments:
            write(tag)
        try:
            lacking, faults = missing(tag), list(wrong(tag))
        except ValueError as error:
            print(error, file=sys.stderr)
            return 2
        name, count = languages()[tag].name, len(texts(tag)) + len(catalogue(tag))
        print(f"{name} ({tag}): {count} texts, {len(lacking)} missing, {len(faults)} wrong")
        for sentence in faults:
            print(f"  {sentence}")
        for key in lacking if tags else ():
            print(f"  missing in {_file_of(key)}: {' '.join(key.split())}"[:120])
        status = status or bool(faults)
    return int(status)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
