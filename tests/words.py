"""Checks the texts of a language against the English ones.

`uv run python -m tests.words de` says which texts German still lacks, and what is wrong with those that it
has; without a language it counts those of all. It fails where something is wrong, not where something is
missing. `uv run python -m tests.words de --write` writes the files of texts that are known by their English
anew: with every English text, and nothing where German has none yet. What German has for an English text
that is gone is printed, and left out.
"""

from __future__ import annotations

import ast as python
import json
import os
import re
import string
import sys
from collections.abc import Iterator
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from fluent.syntax import ast

import sim
from app.words import ENGLISH, languages, parsed, spoken
from app.words.english import SCENES, SIM, files, read
from sim.edit.texts import with_texts
from tests.page.generate import places

_TAG = re.compile(r"<[a-z/][^>]*>")
_PLACE = re.compile(r"\{[^{}]*\}")
SIM_SOURCES = Path(__file__).parents[1] / "sim"


def texts(tag: str) -> dict[str, ast.Pattern]:
    """The texts that a language has itself, by their keys."""
    return {key: pattern for _, entry in parsed(tag)[0].values() for key, pattern in texts_of(entry)}


def texts_of(entry: ast.Message) -> Iterator[tuple[str, ast.Pattern]]:
    """Yield the texts of a message, with their keys."""
    if entry.value is not None:
        yield entry.id.name, entry.value
    for attribute in entry.attributes:
        yield f"{entry.id.name}.{attribute.id.name}", attribute.value


def by_english(tag: str) -> tuple[dict[str, dict[str, str]], list[str]]:
    """What a language has of texts that are known by their English, by their files, and what is wrong with
    files that cannot be read."""
    found: dict[str, dict[str, str]] = {}
    faults: list[str] = []
    for path in files(tag):
        try:
            found[path.relative_to(spoken.FOLDER / tag).as_posix()] = read(path)
        except ValueError as error:
            faults.append(str(error))
    return found, faults


def told(tag: str) -> dict[str, str]:
    """What texts are in a language, by their English; those that the language lacks are left out."""
    return {english: own for each in by_english(tag)[0].values() for english, own in each.items() if own}


@cache
def of_scenes() -> dict[str, list[str]]:
    """The texts of presets in the order in which they are read, by their files in a language; each once."""
    seen: set[str] = {""}
    found: dict[str, list[str]] = {}
    for info in sim.list_scenes():
        own: list[str] = []
        if info.built_in:
            with_texts(sim.load_scene(info.name), lambda text, own=own: own.append(text) or text)
        if new := [text for text in dict.fromkeys(own) if text not in seen]:
            found[f"{SCENES}/{info.name}.json"] = new
            seen.update(new)
    return found


def written_in_english() -> dict[str, list[str]]:
    """The texts that are known by their English, by their files in a language."""
    return {SIM: list(sim_templates()), **of_scenes()}


def write(tag: str) -> list[str]:
    """Write the files of the texts that are known by their English, with what a language has.

    Returns:
        What it has for English texts that are gone, a sentence each; the files no longer have it.
    """
    if by_english(tag)[1]:
        return ["nothing is written before all files can be read"]
    has, new = told(tag), written_in_english()
    known = {text for each in new.values() for text in each}
    (spoken.FOLDER / tag / SCENES).mkdir(exist_ok=True)
    for old in files(tag):
        old.unlink()
    for name, english in new.items():
        text = json.dumps({text: has.get(text, "") for text in english}, ensure_ascii=False, indent=1)
        (spoken.FOLDER / tag / name).write_text(f"{text}\n", encoding="utf-8")
    return [
        f"left out, as there is no such English text: {text!r} → {own!r}; {reworded(text, has)}"
        for text, own in has.items()
        if text not in known
    ]


def reworded(english: str, has: dict[str, str]) -> str:
    """Say what may have become of an English text that is gone: one that the language does not have yet."""
    new = (text for texts in written_in_english().values() for text in texts if text not in has)
    alike = get_close_matches(english, new, 1)
    return "it may have been reworded" + (f": {alike[0]!r}" if alike else "")


def template_places(template: str) -> list[tuple[str, str, str]]:
    """The places of a template of `sim.text`, sorted, each with its format and its conversion."""
    found = string.Formatter().parse(template)
    return sorted((name, form or "", how or "") for _, name, form, how in found if name is not None)


def same_places(own: str, english: str) -> bool:
    """Whether a language's template has the places of the English one, and is a template."""
    try:
        return template_places(own) == template_places(english)
    except ValueError:
        return False


def plain(pattern: ast.Pattern) -> str:
    """What a text says besides what stands in its places."""
    return "".join(part.value for part in pattern.elements if isinstance(part, ast.TextElement))


def missing(tag: str) -> Iterator[tuple[str, list[str], bool]]:
    """Yield the files in which a language lacks texts, with the keys of these, and whether it has any there.

    Those of scenes and of `sim` are the English texts. Files that it has begun come first.
    """
    keys: dict[str, list[str]] = {}
    for name, entry in parsed(ENGLISH)[0].values():
        keys.setdefault(name, []).extend(key for key, _ in texts_of(entry))
    has, found = texts(tag).keys() | told(tag).keys(), []
    for name, each in (keys | written_in_english()).items():
        if lacking := [key for key in each if key not in has]:
            found.append((name, lacking, len(lacking) < len(each)))
    yield from sorted(found, key=lambda file: not file[2])


def wrong(tag: str) -> Iterator[str]:
    """Say what is wrong with a language, a sentence each."""
    yield from parsed(tag)[1]
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
    known = {text for each in written_in_english().values() for text in each}
    found, faults = by_english(tag)
    has = told(tag)
    yield from faults
    for name, each in found.items():
        for text, said in each.items():
            if text not in known:
                yield f"{name}: there is no English text {text!r}; {reworded(text, has)}"
            elif name == SIM and said and not same_places(said, text):
                yield f"{name}: {said!r} has other places than {text!r}"
    if languages()[tag].direction not in ("ltr", "rtl"):
        yield "language-direction is neither ltr nor rtl"


def sim_texts() -> Iterator[tuple[str, python.Call]]:
    """Yield the file and the call of every text that `sim` makes, in the order of its sources."""
    for path in sorted(SIM_SOURCES.rglob("*.py")):
        calls = [
            node
            for node in python.walk(python.parse(path.read_text(encoding="utf-8")))
            if isinstance(node, python.Call) and isinstance(node.func, python.Name) and node.func.id == "Text"
        ]
        for call in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
            yield path.relative_to(SIM_SOURCES.parent).as_posix(), call


@cache
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


def wrong_in_sim() -> Iterator[str]:
    """Say which texts of `sim` no language can say, a sentence each."""
    for path, call in sim_texts():
        where = f"{path}:{call.lineno}"
        match call.args:
            case [python.Constant(str(template))]:
                given = {each.arg for each in call.keywords}
                wanted = {name for name, _, _ in template_places(template)}
                if None not in given and given != wanted:
                    yield f"{where}: {template!r} is given {sorted(map(str, given))} for its places"
            case _ if path != "sim/text.py":
                # `number` of `sim.text` makes a template of a form, and parts are replaced in one.
                yield (
                    f"{where}: {python.unparse(call)} has no literal as its template, and is said in "
                    'English only; write its places, as in Text("mass {mass} is held", mass=mass)'
                )
            case _:
                pass


def main(arguments: list[str]) -> int:
    """Print what is missing and what is wrong; 1 if anything is wrong."""
    tags, status = [each for each in arguments if each != "--write"], 0
    if faults := [*parsed(ENGLISH)[1], *wrong_in_sim()]:
        status = 1
        print(f"English ({ENGLISH}): {len(faults)} wrong", *faults, sep="\n  ")
    for tag in tags or [tag for tag in languages() if tag != ENGLISH]:
        if tag not in languages():
            print(f"{tag}: there is no app/words/{tag}/language.ftl", file=sys.stderr)
            return 2
        gone = write(tag) if "--write" in arguments else []
        lacking, faults = list(missing(tag)), list(wrong(tag))
        name, count = languages()[tag].name, len(texts(tag)) + len(told(tag))
        lacks = sum(len(keys) for _, keys, _ in lacking)
        print(f"{name} ({tag}): {count} texts, {lacks} missing, {len(faults)} wrong")
        for sentence in (*gone, *faults):
            print(f"  {sentence}")
        for file, keys, begun in lacking if tags else ():
            for key in keys if begun else ():
                print(f"  missing in {file}: {' '.join(key.split())}"[:120])
            if not begun:
                print(f"  missing: all {len(keys)} texts of {file}")
        status = status or bool(faults)
    return int(status)


def run(arguments: list[str]) -> int:
    """Run `main`; return 1 where the reader of its output stops, as `head` does."""
    try:
        status = main(arguments)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # Python flushes it at its end
        return 1
    return status


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:]))
