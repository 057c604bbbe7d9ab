"""What a gallery shows: scenes with the words that the page's gallery has, and the names of their files."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import sim
from sim.errors import InputError
from sim.store.files import SceneInfo, list_scenes, load_scene
from sim.store.link import link_data

from ..export.body.program import unknown_forces
from ..features.gallery.entries import entries as in_groups
from ..words import say
from ..words.english import name_of

EMPTY = "empty"
"""The preset to build on, which a page without tools cannot; it is left out where it is not named."""

MAX_LETTERS = 60
"""Of a file's name."""

# Windows opens devices by these names, whatever follows after a dot.
_DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?")


@dataclass(frozen=True)
class Shown:
    """A scene of a gallery.

    Attributes:
        name: by which a link to the gallery names it.
        file: name of its files, without an ending.
        title, line, text, group: as in `app.wire.to_page.Entry`.
        built_in: whether it is a preset as it ships.
        scene: what is shown.
    """

    name: str
    file: str
    title: str
    line: str
    text: str
    group: str
    built_in: bool
    scene: sim.Scene


def shown(names: Sequence[str], own: bool) -> list[Shown]:
    """The scenes of a gallery, in the groups and the order of the page's.

    Args:
        names: of presets and saved scenes, paths of files, and links; if there are none, all presets but
            `EMPTY` and those with forces that live files do not know.
        own: whether all scenes that the user has saved are in it, too.

    Raises:
        SceneError: a scene cannot be read; the sentence says why.
        InputError: two have the same name.
    """
    listed = list_scenes()
    known = {info.name: info for info in listed}
    found = [_named(name, known) for name in names] or [
        (info, scene)
        for info in listed
        if info.built_in and info.name != EMPTY and not unknown_forces(scene := load_scene(info.path))
    ]
    if own:
        there = {info.path for info, _ in found}
        saved = (info for info in listed if not info.built_in and info.path not in there)
        found += [(info, load_scene(info.path)) for info in saved]
    counts = Counter(info.name for info, _ in found)
    if again := next((name for name, count in counts.items() if count > 1), None):
        raise InputError(
            f"gallery: two scenes are called {again!r}; name it once, or rename one of the files"
        )
    scenes = {info.name: scene for info, scene in found}
    titles = Counter(name_of(scene) for scene in scenes.values())
    files: set[str] = set()
    result = []
    for entry in in_groups(info for info, _ in found):
        scene = scenes[entry.name]
        title = name_of(scene)
        files.add(file := _file(entry.name, files))
        result.append(
            Shown(
                name=entry.name,
                file=file,
                title=title if titles[title] == 1 else f"{title} ({entry.name})",
                line=entry.line,
                text=entry.text,
                group=say("site-own") if entry.saved else entry.group,
                built_in=not entry.saved,
                scene=scene,
            )
        )
    return result


def _named(name: str, known: dict[str, SceneInfo]) -> tuple[SceneInfo, sim.Scene]:
    """A scene that the user has named."""
    scene = load_scene(name)
    if name in known:
        return known[name], scene
    path = Path(name)
    of_file = path.stem if link_data(name) is None else scene.name
    return SceneInfo(of_file, scene.description, path, built_in=False, title=scene.title), scene


def _file(name: str, taken: set[str]) -> str:
    """A name for files of every system and for addresses: small letters, digits, dots and hyphens."""
    letters = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    text = re.sub(r"[^a-z0-9.]+|\.{2,}", "-", letters)[:MAX_LETTERS].strip("-.")
    if not text or text == "index" or _DEVICE.fullmatch(text):
        text = f"scene-{text}".rstrip("-")
    number, file = 1, text
    while file in taken:
        number += 1
        file = f"{text}-{number}"
    return file
