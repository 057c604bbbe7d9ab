"""The scenes as the gallery shows them: under which headings, and in which order."""

from __future__ import annotations

import re
from collections.abc import Iterable

from sim.store.files import SceneInfo

from ...ui.shelf import SHARED
from .messages import Entry

OWN, OTHERS, START = "Your own", "Saved on this computer", "Start here"
GROUPS = (OWN, OTHERS, START, "Lessons", "Muscles", "Bodies", "Tutorial", "Studies")
"""Headings of the gallery, in order."""

FIRST = ("rope", "pile", "water-balloon", "jelly", "tree", "empty")
"""What a newcomer finds first, in order: what is fun, and the way to a body of one's own."""

_FOLDERS = {"study": "Studies", "lessons": "Lessons", "muscles": "Muscles"}


def entries(scenes: Iterable[SceneInfo]) -> list[Entry]:
    """Scenes by their groups, and in these by their names; lessons by their titles, and what a newcomer finds
    first in the order of `FIRST`."""
    found = [
        Entry(
            name=info.name,
            title=(info.built_in and info.title) or info.name.removeprefix(SHARED),
            line=re.split(r"(?<=[.!?])\s", info.description, maxsplit=1)[0],
            text=info.description,
            group=_group(info),
            own=not info.built_in and not info.name.startswith(SHARED),
            saved=not info.built_in,
        )
        for info in scenes
    ]
    return sorted(found, key=_order)


def _order(entry: Entry) -> tuple[int, tuple[str | int, ...]]:
    if entry.group == START:
        name = str(FIRST.index(entry.name))
    else:  # lessons have a number at the beginning of their titles
        name = entry.title if entry.group == "Lessons" else entry.name
    return GROUPS.index(entry.group), _natural(name)


def _natural(name: str) -> tuple[str | int, ...]:
    """The key by which "Lesson 10" comes after "Lesson 2": texts in turn with the numbers between them."""
    parts = re.split(r"(\d+)", name.casefold())
    return tuple(int(part) if i % 2 else part for i, part in enumerate(parts))


def _group(info: SceneInfo) -> str:
    if not info.built_in:
        return OTHERS if info.name.startswith(SHARED) else OWN
    if info.group:
        return _FOLDERS.get(info.group, "Bodies")
    if info.name in FIRST:
        return START
    if info.name.startswith("tutorial"):
        return "Tutorial"
    return "Bodies"
