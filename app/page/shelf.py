"""The scenes that are saved, which any page may change at any time."""

from __future__ import annotations

import functools
import time
from pathlib import Path

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


def labels(present: str) -> dict[str, str]:
    """The chooser's scenes, the present one among them: names by labels.

    Presets go by their titles, saved scenes by the names that they were saved under.
    """
    offered = [info for info in scenes() if info.group != "study"]
    names = {info.name for info in offered} | {present}
    found: dict[str, str] = {}
    for info in offered:
        by_title = info.built_in and info.title and info.title not in names
        found[info.title if by_title else info.name] = info.name
    if present not in found.values():
        found[present] = present
    return found
