"""What a page's script sends beside commands to the session: what it asks for, and what comes in parts."""

from __future__ import annotations

import logging
import re
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any

from sim.scene.types import Scene

from ..session.session import Notice, Session
from . import asks, keeping, mail, script
from .controls import Controls
from .edits import Edits
from .gallery import Gallery
from .sharing import Sharing
from .shelf import Shelf

_log = logging.getLogger(__name__)

_threads = ThreadPoolExecutor(2, thread_name_prefix="softrod-beside")
"""For what the event loop must not wait for: scenes that are read, packed and painted."""


MOST_WAITING = 50
"""Requests of a page that wait at most; beyond that the page is not a person, and the oldest are dropped."""


class Answers:
    """Answers one page's script, one request after the other: what was asked for last is answered last.

    Args:
        session: the page's simulation.
        letters: to the page's script.
        notify: tells the user something.
        resume: goes on with what the page had kept.
        show: opens the scene of a link, after what the page had kept.
        for_others: the address by which others reach the page, from that by which it was reached itself.
        scenes: those of the page.

    Attributes:
        sharing, gallery, edits: what it asks about.
    """

    def __init__(
        self,
        session: Session,
        letters: mail.Mail,
        notify: Callable[[Notice], None],
        resume: Callable[[keeping.Kept], None],
        show: Callable[[Scene], None],
        for_others: Callable[[str], str],
        scenes: Shelf,
    ) -> None:
        self._letters, self._shelf = letters, scenes
        self.sharing = Sharing(session, letters, notify, show, for_others)
        self.gallery = Gallery(session, letters, notify, scenes)
        self.edits = Edits(session, letters, notify)
        self._notify, self._resume = notify, resume
        self._parts = {"resume": keeping.Parts(), "link": keeping.Parts(), "paste": keeping.Parts()}
        self._line = InOrder()

    def take(self, message: object, controls: Controls) -> bool:
        """Whether a message of the script is one of these; if so, what it asks for is done.

        Args:
            message: the value of the hidden text element, which any client can set to anything.
            controls: those of the page.
        """
        if part := script.parse_part(message):
            self._take_part(part, controls)
        elif ask := asks.parse_ask(message):
            if isinstance(ask, asks.Gesture):
                if "edit" in controls:
                    self.edits.do(ask)
            elif isinstance(ask, asks.Texts):
                if "edit" in controls:
                    self.edits.set_texts(ask)
            elif not isinstance(ask, asks.Offer):
                self._line.submit(self._answer, ask)
            elif "chooser" in controls:
                self.gallery.offer()
        else:
            return False
        return True

    def _take_part(self, part: script.Part, controls: Controls) -> None:
        letters = self._parts[part.kind].add(part.number, part.of, part.letters)
        if letters is None:
            return
        if part.kind == "link":
            self._line.submit(self.sharing.open, letters)
        elif part.kind == "paste":
            if "edit" in controls:
                self._line.submit(self.edits.paste, letters)
        elif kept := keeping.decode(letters):
            self._resume(kept)
        else:
            self._letters.send("resumed")  # as far as it can be

    def _answer(self, ask: asks.Ask) -> None:
        match ask:
            case asks.Share():
                self.sharing.share(ask)
            case asks.Who():
                self._shelf.introduce(ask)
            case asks.Unread(text):
                self._notify(unread(text))
            case asks.Unsent(what):
                self._notify(Notice("error", f"That cannot be {_DONE[what]}", UNSENT))
            case asks.Scenes():
                self.gallery.list(ask)
            case asks.OpenScene():
                self.gallery.open(ask)
            case asks.Change():
                self.gallery.change(ask)


UNSENT = "It is too large for a page to send: at most 4.7 MB, which is some 11,000 masses."
_DONE = {"resume": "resumed", "link": "opened", "paste": "pasted"}


def unread(text: str) -> Notice:
    """Says of a text that was typed into a number box that it is no number, and how one is written."""
    if _EITHER.fullmatch(text):
        told = f"{text} could be {text.replace(',', '.')} or {text.replace(',', '')}. Write one of these."
    else:
        told = f"“{text}” is not a number. Write one as 20000, 2e4 or 0.05."
    return Notice("warning", "That cannot be read", told)


_EITHER = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}", re.ASCII)
"""A comma that could be a decimal one, or part thousands; the page's script reads neither."""


class InOrder:
    """Work of one page, done in order by the threads of all pages, so that none keeps them to itself."""

    def __init__(self) -> None:
        self._waiting: deque[Callable[[], None]] = deque(maxlen=MOST_WAITING)
        self._lock = threading.Lock()
        self._busy = False

    def submit(self, work: Callable[..., None], *arguments: Any) -> None:
        """Have something done after all that waits, in another thread."""
        with self._lock:
            self._waiting.append(partial(work, *arguments))
            if self._busy:
                return
            self._busy = True
        _threads.submit(self._next)

    def _next(self) -> None:
        with self._lock:
            work = self._waiting.popleft()
        try:
            work()
        except Exception:  # a defect, or a page that went away meanwhile
            _log.exception("a request of a page failed")
        with self._lock:
            self._busy = more = bool(self._waiting)
        if more:
            _threads.submit(self._next)
