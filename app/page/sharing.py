"""Links that hold a scene: made of what a page shows, and opened."""

from __future__ import annotations

from collections.abc import Callable

import segno

from sim.errors import InputError, SceneError
from sim.scene import files
from sim.scene.link import PATH, pack_scene

from ..session import commands
from ..session.session import Notice, Session
from .asks import Share
from .mail import Mail

MOST_IN_QR = 1200
"""Characters of the longest link that gets a QR code; the squares of a longer one are too small for a camera
across a room."""


class Sharing:
    """One page's links. What reads and makes scenes takes a while: call it in a thread.

    Args:
        session: the page's simulation.
        mail: to the page's script.
        notify: tells the user something.
    """

    def __init__(self, session: Session, mail: Mail, notify: Callable[[Notice], None]) -> None:
        self._session = session
        self._mail = mail
        self._notify = notify

    def offer(self) -> None:
        """Have the page show its dialog."""
        self._mail.send("share")

    def share(self, ask: Share) -> None:
        """Send the page a link to its scene."""
        try:
            data = pack_scene(self._session.snapshot(self._session.scene.name, ask.pose))
        except (InputError, SceneError) as error:
            self._mail.send("link", problem=str(error))
            return
        link = f"{ask.origin}{PATH}#{data}"
        self._mail.send("link", link=link, qr=qr_code(link) if len(link) <= MOST_IN_QR else "")

    def open(self, data: str) -> None:
        """Open the scene in a link; nothing in it is trusted, and if it is no scene, nothing changes."""
        try:
            scene = files.decode_link(data)
        except SceneError as error:
            self._notify(Notice("error", "That link cannot be opened", str(error)))
        else:
            self._session.post(commands.Open(scene))


def qr_code(text: str) -> str:
    """A picture of a QR code, as an address that an image can have."""
    return segno.make(text, error="l", micro=False).svg_data_uri(border=4, light="#fff")
