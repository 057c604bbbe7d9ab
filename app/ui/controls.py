"""The controls of a page, for prepared lessons: all, or those that its address or its scene names.

This tidies the page but secures nothing: what is left out can still be done by keys, or on a page that is
opened without the list.
"""

from __future__ import annotations

import re
import urllib.parse
from collections.abc import Collection
from dataclasses import dataclass

from sim.errors import InputError
from sim.scene.types import Scene
from sim.settings import Setting, setting_keys

from ..gate.address import page_query

IN_PLAY_TAB = ("chooser", "about", "follow", "angle", "keys", "body")
"""Controls of the Play tab; the sliders of single settings are there, too."""


@dataclass(frozen=True)
class Controls:
    """The controls of a page.

    Attributes:
        names: their names, in order; None for all.
    """

    names: tuple[str, ...] | None = None

    def __contains__(self, name: str) -> bool:
        return self.names is None or name in self.names

    @property
    def in_play_tab(self) -> bool:
        """True if the Play tab has any of them."""
        return self.names is None or any(n in IN_PLAY_TAB or _is_setting(n) for n in self.names)

    def named_settings(self, applicable: list[Setting]) -> list[Setting] | None:
        """The named settings among those of a scene; None if all controls are there."""
        if self.names is None:
            return None
        known = {setting.key: setting for setting in applicable}
        return [known[name] for name in self.names if name in known]


ALL = Controls()


def _is_setting(name: str) -> bool:
    return re.sub(r"^bodies\[\d+\]\.", "", name) in setting_keys()


def checked(names: tuple[str, ...], source: str, parts: Collection[str]) -> Controls:
    """Make controls of a list of names.

    Args:
        names: of controls, and keys of settings.
        source: where the names are from, for errors.
        parts: the names of all controls.

    Raises:
        InputError: a name is unknown; one sentence that begins with the source and lists all names.
    """
    for name in names:
        if name not in parts and not _is_setting(name):
            raise InputError(
                f"{source}: there is no control called {name!r}; there are {', '.join(parts)}, and the "
                f"settings {', '.join(sorted(setting_keys()))}"
            )
    return Controls(tuple(dict.fromkeys(names)))


def of_scene(scene: Scene, parts: Collection[str]) -> Controls:
    """The controls that a scene asks for.

    Raises:
        InputError: as `checked`.
    """
    return ALL if scene.view.controls is None else checked(scene.view.controls, "view.controls", parts)


def of_query(query: str, parts: Collection[str]) -> Controls | None:
    """The controls that a query asks for, as in `controls=play,rest_angle`; None if it names none.

    Raises:
        InputError: as `checked`.
    """
    fields = page_query(query)
    if not fields or "controls" not in fields:
        return None
    text = urllib.parse.unquote(fields["controls"])
    names = tuple(name for part in text.split(",") if (name := part.strip()[:80]))
    return checked(names, "the address, controls", parts)
