"""The scenes that a page has: the presets, those that it has saved, and those that others look at.

The scenes in the user's folder belong to the owner of this computer. Pages of others can open and copy them;
what they save is in a folder of their own, which goes by a secret of their browser.
"""

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
from . import owner

_FRESH = 1.0
"""Seconds for which a folder's time may stay the same although another file is written: clocks are coarse."""

Stamp = tuple[Path, int, bool]
"""A folder, when it was last changed, ns, and whether that was just now."""

MAX_SCENES = 50
"""Scenes that a visitor may have."""

MAX_BYTES = 200_000_000
"""What the scenes of all visitors may take, those that they have deleted included."""

SHARED = "shared/"
"""Beginning of the names by which visitors open the owner's scenes; no scene's own name can have it."""


def stamp(folder: Path | None = None) -> Stamp:
    """Another value whenever a scene may have been saved or deleted, by whatever program.

    Args:
        folder: where scenes are; the user's own if not given.
    """
    folder = folder or files.user_folder()
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


def visitors_folder() -> Path:
    """The folder with those of the visitors; it need not exist yet."""
    return files.user_folder().parent / "visitors"


class Shelf:
    """The scenes of one page.

    Args:
        owned: whether the page is known to be the owner's.

    Attributes:
        owned: as above, or since it has shown the owner's key.
    """

    def __init__(self, owned: bool) -> None:
        self.owned = owned
        self._visitor: Path | None = None

    def introduce(self, who: Who) -> None:
        """The page says whose it is."""
        self.owned = self.owned or owner.is_key(who.owner)
        self._visitor = visitors_folder() / hashlib.sha256(who.visitor.encode()).hexdigest()[:32]

    @property
    def folder(self) -> Path:
        """Where the page's own scenes are.

        Raises:
            SceneError: the page has not said whose it is.
        """
        if self.owned:
            return files.user_folder()
        if self._visitor is None:
            raise SceneError("the page has not said whose scenes it has; reload it and try again")
        return self._visitor

    def stamp(self) -> tuple[Stamp, Stamp | None]:
        """Another value whenever the page may have other scenes."""
        visited = None if self.owned or self._visitor is None else stamp(self._visitor)
        return stamp(), visited

    def scenes(self) -> list[SceneInfo]:
        """The scenes there are."""
        found = list(scenes())
        if self.owned:
            return found
        found = [info if info.built_in else replace(info, name=SHARED + info.name) for info in found]
        return found + (files.list_saved(self._visitor) if self._visitor is not None else [])

    def find(self, name: str) -> SceneInfo | None:
        """The scene of that name, if there is one."""
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
        """Refuse one more scene of a visitor where there are too many; `exists`: one is to be replaced."""
        if self.owned:
            return
        if not exists and len(list(self.folder.glob("*.json"))) >= MAX_SCENES:
            raise SceneError(f"you have {MAX_SCENES} scenes here, which is the most; delete some first")
        taken = sum(path.stat().st_size for path in visitors_folder().rglob("*.json"))
        if taken + files.MAX_FILE_BYTES > MAX_BYTES:
            raise SceneError("this computer has no room for more scenes of visitors; download it as a file")
