"""The scenes as the gallery shows them: under which headings, and in which order."""

from __future__ import annotations

import re
from collections.abc import Iterable

from sim.store.files import SceneInfo

from ...ui.shelf import SHARED
from ...words import say
from ...words.english import of
from ...words.keys import Key
from .messages import Entry

GROUPS: tuple[Key, ...] = (
    "gallery-own", "gallery-shared", "gallery-start", "gallery-lessons", "gallery-muscles", "gallery-bodies",
    "gallery-tutorial", "gallery-studies",
)  # fmt: skip
"""Headings of the gallery, in order."""

FIRST = ("rope", "pile", "water-balloon", "jelly", "tree", "empty")
"""What a newcomer finds first, in order: what is fun, and the way to a body of one's own."""

_FOLDERS: dict[str, Key] = {
    "study": "gallery-studies", "lessons": "gallery-lessons", "muscles": "gallery-muscles"
}  # fmt: skip


def entries(scenes: Iterable[SceneInfo]) -> list[Entry]:
    """Scenes by their groups, and in these by their names; lessons by their titles, and what a newcomer finds
    first in the order of `FIRST`."""
    return [
        Entry(
            name=info.name,
            title=of(_title(info)),
            line=re.split(r"(?<=[.!?])\s", of(info.description), maxsplit=1)[0],
            text=of(info.description),
            group=say(_group(info)),
            own=not info.built_in and not info.name.startswith(SHARED),
            saved=not info.built_in,
        )
        for info in sorted(scenes, key=_order)
    ]


def _title(info: SceneInfo) -> str:
    return (info.built_in and info.title) or info.name.removeprefix(SHARED)


def _order(info: SceneInfo) -> tuple[int, tuple[str | int, ...]]:
    group = _group(info)
    if group == "gallery-start":
        name = str(FIRST.index(info.name))
    else:  # lessons have a number at the beginning of their titles
        name = _title(info) if group == "gallery-lessons" else info.name
    return GROUPS.index(group), _natural(name)


def _natural(name: str) -> tuple[str | int, ...]:
    """The key by which "Lesson 10" comes after "Lesson 2": texts in turn with the numbers between them."""
    parts = re.split(r"(\d+)", name.casefold())
    return tuple(int(part) if i % 2 else part for i, part in enumerate(parts))


def _group(info: SceneInfo) -> Key:
    if not info.built_in:
        return "gallery-shared" if info.name.startswith(SHARED) else "gallery-own"
    if info.group:
        return _FOLDERS.get(info.group, "gallery-bodies")
    if info.name in FIRST:
        return "gallery-start"
    if info.name.startswith("tutorial"):
        return "gallery-tutorial"
    return "gallery-bodies"
