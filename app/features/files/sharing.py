"""Links that hold a scene: made of what a page shows, and opened."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Literal

import segno

from sim.errors import InputError, SceneError
from sim.scene.types import Scene
from sim.settings import settings_of
from sim.store import files
from sim.store.link import PATH, pack_scene

from ...linking import short_address
from ...session.notices import Notice
from ...ui.board import main_settings
from ...ui.page import Page
from ...words import say
from ...words.english import of
from .messages import Link, Share

MAX_IN_QR = 1200
"""Characters of the longest link that gets a QR code; the squares of a longer one are too small for a camera
across a room."""


class Sharing:
    """One page's links. What reads and makes scenes takes a while: call it in a thread.

    Args:
        page: whose scene is shared.
        show: opens a scene.
        for_others: the address by which others reach the page, from that by which it was reached itself.
    """

    def __init__(
        self, page: Page, show: Callable[[Scene], object], for_others: Callable[[str], str] = str
    ) -> None:
        self._session, self._mail, self._notify = page.session, page.mail, page.notify
        self._show, self._for_others = show, for_others

    def share(self, ask: Share) -> None:
        """Send the page a link to its scene."""
        try:
            scene = self._session.snapshot(self._session.scene.name, ask.pose)
            link = self._link(scene, ask)
        except (InputError, SceneError) as error:
            self._mail.send(Link(problem=of(str(error))))
            return
        self._mail.send(Link(link=link, qr=qr_code(link) if len(link) <= MAX_IN_QR else ""))

    def _link(self, scene: Scene, ask: Share) -> str:
        base, controls = self._for_others(ask.page), _controls(scene, ask.controls)
        if ask.short:
            return short_address(base, scene) + (f"&{controls}" if controls else "")
        return f"{base}{PATH[1:]}{controls and '?'}{controls}#{pack_scene(scene)}"

    def open(self, data: str) -> None:
        """Open the scene in a link; nothing in it is trusted, and if it is no scene, nothing changes."""
        try:
            scene = files.decode_link(data)
        except SceneError as error:
            self._notify(Notice("error", say("files-not-opened"), str(error)))
        else:
            self._show(scene)


def _controls(scene: Scene, which: Literal["all", "play", "sliders"]) -> str:
    """The field of an address that says which controls there are; empty for those that there are anyway."""
    if which == "all":
        return ""
    sliders = [setting.key for setting in main_settings(settings_of(scene))] if which == "sliders" else []
    return f"controls={','.join(['play', *sliders])}"


@lru_cache(maxsize=32)
def qr_code(text: str) -> str:
    """A picture of a QR code, as an address that an image can have."""
    return segno.make(text, error="l", micro=False).svg_data_uri(border=4, light="#fff")
