"""Which controls a page has, for prepared lessons: all, or those that its address or its scene names.

It is a matter of tidiness, not of security: what is left out can still be done by keys, and by whoever opens
the page without the list.
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
"""Those that stand in the Play tab, as the sliders of single settings do."""


@dataclass(frozen=True)
class Controls:
    """The controls of a page.

    Attributes:
        names: which there are, in order; None for all.
    """

    names: tuple[str, ...] | None = None

    def __contains__(self, name: str) -> bool:
        return self.names is None or name in self.names

    @property
    def in_play_tab(self) -> bool:
        """Whether the Play tab has anything."""
        return self.names is None or any(n in IN_PLAY_TAB or _is_setting(n) for n in self.names)

    def foremost(self, applicable: list[Setting]) -> list[Setting] | None:
        """The settings that are named, of those that the scene has; None if none is to be named."""
        if self.names is None:
            return None
        known = {setting.key: setting for setting in applicable}
        return [known[name] for name in self.names if name in known]


ALL = Controls()


def _is_setting(name: str) -> bool:
    return re.sub(r"^bodies\[\d+\]\.", "", name) in setting_keys()


def checked(names: tuple[str, ...], source: str, parts: Collection[str]) -> Controls:
    """Controls of that list.

    Args:
        names: of controls, and keys of settings.
        source: where they are from.
        parts: the names of all controls.

    Raises:
        InputError: one of them is no control; one sentence that begins with the source and has all there are.
    """
    for name in names:
        if name not in parts and not _is_setting(name):
            raise InputError(
                f"{source}: there is no control called {name!r}; there are {', '.join(parts)}, and the "
                f"settings {', '.join(sorted(setting_keys()))}"
            )
    return Controls(tuple(dict.fromkeys(names)))


def of_scene(scene: Scene, parts: Collection[str]) -> Controls:
    """What a scene asks for, of controls with those names.

    Raises:
        InputError: as `checked`.
    """
    return ALL if scene.view.controls is None else checked(scene.view.controls, "view.controls", parts)


def of_query(query: str, parts: Collection[str]) -> Controls | None:
    """What the query of a page's address asks for, as in `controls=play,rest_angle`; None if it has none.

    Raises:
        InputError: as `checked`.
    """
    fields = page_query(query)
    if not fields or "controls" not in fields:
        return None
    text = urllib.parse.unquote(fields["controls"])
    names = tuple(name for part in text.split(",") if (name := part.strip()[:80]))
    return checked(names, "the address, controls", parts)
