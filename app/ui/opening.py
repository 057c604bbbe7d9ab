"""The scene that a page's address asks for: ``?scene=`` the name of a preset, or ``?s=`` the code of a shared
scene."""

from __future__ import annotations

import urllib.parse

import sim
from sim.errors import SceneError
from sim.store.files import built_in_files, read_scene
from sim.store.shared import shared_scene

from ..gate.address import page_query
from ..words import quoted, say


def asked_scene(query: str) -> sim.Scene | None:
    """The scene that the query of a page's address asks for; None if it asks for none.

    Raises:
        SceneError: there is no such scene; one sentence.
    """
    fields = page_query(query) or {}
    if "s" in fields:
        return shared_scene(fields["s"])
    if "scene" not in fields:
        return None
    # Only presets: a name could be the path of any file, and saved scenes are private.
    name = urllib.parse.unquote(fields["scene"])
    path = next((path for path in built_in_files() if path.stem.casefold() == name.casefold()), None)
    if path is None:
        raise SceneError(say("ui-no-preset", name=quoted(name[:80])))
    return read_scene(path)
