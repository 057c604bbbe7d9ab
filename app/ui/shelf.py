"""The scenes of a page: presets, scenes that it has saved, and scenes of the owner.

The scenes in the user's folder belong to the owner of this computer. Visitors can open and copy them; their
own scenes are saved in a folder of each visitor, named by a secret of their browser."""

from __future__ import annotations

import functools
import hashlib
import time
from dataclasses import replace
from pathlib import Path

import sim
from sim.errors import SceneError
from sim.store import files, own_scenes
from sim.store.files import SceneInfo

from ..wire.from_page import Who
from ..words import say
from . import owner

_FRESH = 1.0
"""Seconds within which a folder's time may not change although a file is written: clocks are coarse."""

Stamp = tuple[Path, int, bool]
"""A folder, the time of its last change, ns, and whether that was just now."""

MAX_SCENES = 50
"""Scenes that a visitor may save."""

MAX_BYTES = 200_000_000
"""Size of the scenes of all visitors, including deleted ones."""

SHARED = "shared/"
"""Prefix of the names of the owner's scenes for visitors; no real name can have it."""


def stamp(folder: Path | None = None) -> Stamp:
    """A value that changes whenever a scene may have been saved or deleted, by whatever program.

    Args:
        folder: a folder with scenes; the user's own if not given.
    """
    folder = folder or files.user_folder()
    try:
        changed = folder.stat().st_mtime_ns
    except OSError:
        changed = 0
    return folder, changed, time.time_ns() - changed < _FRESH * 1e9


def scenes() -> tuple[SceneInfo, ...]:
    """All scenes of this computer, cached for all pages unless one was saved just now."""
    now = stamp()
    return _read_once(now) if not now[2] else tuple(sim.list_scenes())


@functools.lru_cache(maxsize=1)
def _read_once(_: Stamp) -> tuple[SceneInfo, ...]:
    return tuple(sim.list_scenes())


def visitors_folder() -> Path:
    """The folder with the scenes of visitors, which may not exist yet."""
    return files.user_folder().parent / "visitors"


class Shelf:
    """The scenes of one page.

    Args:
        owned: the page is known to be the owner's.

    Attributes:
        owned: as above, or the page has shown the owner's key.
    """

    def __init__(self, owned: bool) -> None:
        self.owned = owned
        self._visitor: Path | None = None

    def introduce(self, who: Who) -> None:
        """Identify the page's user."""
        self.owned = self.owned or owner.is_key(who.owner)
        self._visitor = visitors_folder() / hashlib.sha256(who.visitor.encode()).hexdigest()[:32]

    @property
    def folder(self) -> Path:
        """The folder with the page's own scenes.

        Raises:
            SceneError: the page has not identified its user.
        """
        if self.owned:
            return files.user_folder()
        if self._visitor is None:
            raise SceneError(say("ui-no-user"))
        return self._visitor

    def stamp(self) -> tuple[Stamp, Stamp | None]:
        """A value that changes whenever the page may have other scenes."""
        visited = None if self.owned or self._visitor is None else stamp(self._visitor)
        return stamp(), visited

    def scenes(self) -> list[SceneInfo]:
        """All scenes of the page."""
        found = list(scenes())
        if self.owned:
            return found
        found = [info if info.built_in else replace(info, name=SHARED + info.name) for info in found]
        return found + (files.list_saved(self._visitor) if self._visitor is not None else [])

    def find(self, name: str) -> SceneInfo | None:
        """The scene of a name; None if there is none."""
        return next((info for info in self.scenes() if info.name == name), None)

    def save(self, scene: sim.Scene, name: str) -> str:
        """Save a scene as one of the page's own, and return the name used.

        Raises:
            SceneError: see `sim.store.files.save_user_scene`; or there is no room.
        """
        self._check_room(exists=files.user_path(name, self.folder).exists())
        return files.save_user_scene(scene, name, self.folder)

    def duplicate(self, name: str) -> str:
        """Copy a saved scene, whoever's it is, to the page's own, and return the name of the copy.

        Raises:
            SceneError: there is none of that name, it cannot be written, or there is no room.
        """
        self._check_room()
        shared = name.startswith(SHARED) and not self.owned
        source = files.user_folder() if shared else self.folder
        return own_scenes.duplicate_user_scene(name.removeprefix(SHARED), self.folder, source)

    def _check_room(self, exists: bool = False) -> None:
        """Refuse one more scene of a visitor if there are too many; `exists`: it replaces one."""
        if self.owned:
            return
        if not exists and len(list(self.folder.glob("*.json"))) >= MAX_SCENES:
            raise SceneError(say("ui-no-room", count=MAX_SCENES))
        taken = sum(path.stat().st_size for path in visitors_folder().rglob("*.json"))
        if taken + files.MAX_FILE_BYTES > MAX_BYTES:
            raise SceneError(say("ui-no-room.computer"))
