"""A race in the page: a rival is found by what was pasted or chosen, and the page is told how far each is."""

from __future__ import annotations

import re
import urllib.parse

import sim
from sim.errors import InputError, SceneError
from sim.scene.types import shown_name
from sim.store import files
from sim.store.files import read_scene

from ...session import commands
from ...session.rival import on_terrain
from ...session.session import Session
from ...wire import to_page
from ...wire.carrier import Mail
from ..opening import asked_scene
from ..page import Page

EVERY = 0.1
"""Seconds between two readings while the bodies move; faster would only flicker."""

_ADDRESS = re.compile(r"\S+\?(\S+)")


class Races:
    """Finds one page's rivals. It takes a while: call it in a thread.

    Args:
        page: whose body races.
    """

    def __init__(self, page: Page) -> None:
        self._page = page

    def against(self, letters: str) -> None:
        """Begin a race against the body of a scene, or say why not.

        Args:
            letters: a link to it, its short address or its name, as in an address.
        """
        session = self._page.session
        try:
            rival = self._find(urllib.parse.unquote(letters).strip())
            on_terrain(rival, session.snapshot(session.scene.name, with_pose=False))
        except (SceneError, InputError) as error:
            text = str(error)
            self._page.mail.tell(to_page.RaceAnswer(problem=f"{text[:1].upper()}{text[1:]}."))
            return
        session.post(commands.Race(rival))
        self._page.mail.tell(to_page.RaceAnswer(problem=""))

    def _find(self, text: str) -> sim.Scene:
        """The scene that is meant.

        Raises:
            SceneError: there is none; one sentence.
        """
        if "#" in text:
            return files.decode_link(text.partition("#")[2])
        address = _ADDRESS.fullmatch(text)
        if address is not None and (scene := asked_scene(address[1])) is not None:
            return scene
        # Only what is listed: a name could be the path of any file.
        info = self._page.shelf.find(text)
        if info is None:
            raise SceneError(f"{text[:80]!r} is neither a link to a scene nor the name of one")
        return read_scene(info.path)


class RaceView:
    """What one page is told of its race.

    Args:
        mail: to its script.
    """

    def __init__(self, mail: Mail) -> None:
        self._mail = mail
        self._on = False
        self._due = 0.0

    def tell(self, session: Session) -> None:
        """Send what the page does not know yet."""
        rival = session.rival
        if rival is None:
            if self._on:
                self._on = False
                self._mail.tell(to_page.Race())
            return
        now = session.now()
        if now < self._due:
            return
        self._on, self._due = True, now + EVERY
        one, other = rival.ways(session.simulation)
        self._mail.tell(
            to_page.Race(
                on=True,
                names=(shown_name(session.scene), shown_name(rival.scene)),
                ways=(round(one, 1), round(other, 1)),
                seconds=round(rival.seconds, 1),
                fair=rival.fair,
                out=rival.out,
            )
        )
