"""The scenes that are saved, which any page may change at any time."""

from __future__ import annotations

import functools
from pathlib import Path

import sim
from sim.scene import files
from sim.scene.files import SceneInfo

Stamp = tuple[Path, int]
"""The user's folder, and when it was last changed."""


def stamp() -> Stamp:
    """Another value whenever a scene may have been saved or deleted, by whatever program."""
    folder = files.user_folder()
    try:
        return folder, folder.stat().st_mtime_ns
    except OSError:
        return folder, 0


def scenes() -> tuple[SceneInfo, ...]:
    """The scenes there are; read once for all pages."""
    return _read(stamp())


@functools.lru_cache(maxsize=1)
def _read(_: Stamp) -> tuple[SceneInfo, ...]:
    return tuple(sim.list_scenes())
