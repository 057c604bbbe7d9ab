"""The scenes that are saved, which any page may change at any time."""

from __future__ import annotations

import functools
import re
import time
from collections.abc import Iterable
from pathlib import Path

import msgspec

import sim
from sim.scene import files
from sim.scene.files import SceneInfo

_FRESH = 1.0
"""Seconds for which a folder's time may stay the same although another file is written: clocks are coarse."""

Stamp = tuple[Path, int, bool]
"""The user's folder, when it was last changed, ns, and whether that was just now."""


def stamp() -> Stamp:
    """Another value whenever a scene may have been saved or deleted, by whatever program."""
    folder = files.user_folder()
    try:
        changed = folder.stat().st_mtime_ns
    except OSError:
        changed = 0
    return folder, changed, time.time_ns() - changed < _FRESH * 1e9


def scenes() -> tuple[SceneInfo, ...]:
    """The scenes there are; read once for all pages, but for those that are being saved just now."""
    now = stamp()
    return _read_once(now) if not now[2] else tuple(sim.list_scenes())


@functools.lru_cache(maxsize=1)
def _read_once(_: Stamp) -> tuple[SceneInfo, ...]:
    return tuple(sim.list_scenes())


class Entry(msgspec.Struct, frozen=True):
    """A scene as the gallery shows it.

    Attributes:
        name: by which it is opened.
        title: what it is called: presets by their titles, saved scenes by the names they were saved under.
        line: in one sentence, what it shows.
        text: all of that, which is searched, too.
        group: the heading under which it stands.
        own: whether it is one of the user's own.
    """

    name: str
    title: str
    line: str
    text: str
    group: str
    own: bool


OWN, START = "Your own", "Start here"
GROUPS = (OWN, START, "Lessons", "Bodies", "Tutorial", "Studies")
"""Headings of the gallery, in order."""

FIRST = ("rope", "pile", "water-balloon", "jelly", "tree", "empty")
"""What a newcomer finds first, in order: what is fun, and the way to a body of one's own."""

_FOLDERS = {"study": "Studies", "lessons": "Lessons"}


def entries(scenes: Iterable[SceneInfo]) -> list[Entry]:
    """Scenes by their groups, and in these by their names; lessons by their titles, and what a newcomer finds
    first in the order of `FIRST`."""
    found = [
        Entry(
            name=info.name,
            title=(info.built_in and info.title) or info.name,
            line=re.split(r"(?<=[.!?])\s", info.description, maxsplit=1)[0],
            text=info.description,
            group=_group(info),
            own=not info.built_in,
        )
        for info in scenes
    ]
    return sorted(found, key=_order)


def _order(entry: Entry) -> tuple[int, str]:
    if entry.group == START:
        name = f"{FIRST.index(entry.name):02}"
    else:  # lessons have a number at the beginning of their titles
        name = entry.title if entry.group == "Lessons" else entry.name
    return GROUPS.index(entry.group), name.casefold()


def _group(info: SceneInfo) -> str:
    if not info.built_in:
        return OWN
    if info.group:
        return _FOLDERS.get(info.group, "Bodies")
    if info.name in FIRST:
        return START
    if info.name.startswith("tutorial"):
        return "Tutorial"
    return "Bodies"


def find(name: str) -> SceneInfo | None:
    """The scene of that name, if there is one."""
    return next((info for info in scenes() if info.name == name), None)
