"""What a page's script sends beside commands to the session: what it asks for, and what comes in parts."""

from __future__ import annotations

import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from ..session.session import Notice, Session
from . import keeping, mail, script
from .controls import Controls
from .gallery import Gallery
from .sharing import Sharing

_log = logging.getLogger(__name__)

_threads = ThreadPoolExecutor(2, thread_name_prefix="softrod-beside")
"""For what the event loop must not wait for: scenes that are read, packed and painted."""


class Answers:
    """Answers one page's script.

    Args:
        session: the page's simulation.
        letters: to the page's script.
        notify: tells the user something.
        resume: goes on with what the page had kept.

    Attributes:
        sharing, gallery: what it asks about.
    """

    def __init__(
        self,
        session: Session,
        letters: mail.Mail,
        notify: Callable[[Notice], None],
        resume: Callable[[keeping.Kept], None],
    ) -> None:
        self.sharing = Sharing(session, letters, notify)
        self.gallery = Gallery(session, letters, notify)
        self._resume = resume
        self._parts = {"resume": keeping.Parts(), "link": keeping.Parts()}

    def take(self, message: object, controls: Controls) -> bool:
        """Whether a message of the script is one of these; if so, what it asks for is done.

        Args:
            message: the value of the hidden text element, which any client can set to anything.
            controls: those of the page.
        """
        if part := script.parse_part(message):
            self._take_part(part)
        elif ask := mail.parse_ask(message):
            if not isinstance(ask, mail.Offer):
                _in_thread(self._answer, ask)
            elif "chooser" in controls:
                self.gallery.offer()
        else:
            return False
        return True

    def _take_part(self, part: script.Part) -> None:
        letters = self._parts[part.kind].add(part.number, part.of, part.letters)
        if letters is None:
            return
        if part.kind == "link":
            _in_thread(self.sharing.open, letters)
        elif kept := keeping.decode(letters):
            self._resume(kept)

    def _answer(self, ask: mail.Ask) -> None:
        match ask:
            case mail.Share():
                self.sharing.share(ask)
            case mail.Scenes():
                self.gallery.list(ask)
            case mail.OpenScene():
                self.gallery.open(ask)
            case mail.Change():
                self.gallery.change(ask)


def _in_thread(work: Callable[..., None], *arguments: Any) -> None:
    """Have something done soon, in another thread."""

    def do() -> None:
        try:
            work(*arguments)
        except Exception:  # a defect, or a page that went away meanwhile
            _log.exception("a request of a page failed")

    _threads.submit(do)
