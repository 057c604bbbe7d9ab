"""What a page's script sends beside commands to the session: what it asks for, and what comes in parts."""

from __future__ import annotations

import logging
import re
import threading
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any

from ...session.notices import Notice
from ...ui.feature import Feature
from ...ui.kept import keeping
from ...ui.page import Page
from ...ui.waiting import TOO_MUCH, Waiting
from ...wire import from_page
from ...wire.to_page import Resumed

_log = logging.getLogger(__name__)

beside = ThreadPoolExecutor(8, thread_name_prefix="softrod-beside")
"""For what the event loop must not wait for: scenes that are read, packed and painted. Some of it waits for
the step of a heavy body, in which nobody else's is to be held up."""


MAX_UNFINISHED = 6_000_000
"""Letters of texts of which parts are missing that one page may have: the longest one, and some more."""


class Answers:
    """Answers one page's script, one request after the other: what was asked for last is answered last.

    Args:
        page: whose script asks.
        features: the page's, which may read long texts.
        resume: goes on with what the page had kept.
    """

    def __init__(
        self,
        page: Page,
        features: Iterable[Feature],
        resume: Callable[[keeping.Kept], object],
    ) -> None:
        self._page, self._resume = page, resume
        self._readers = {kind: feature for feature in features for kind in feature.texts}
        self._parts: defaultdict[str, keeping.Parts] = defaultdict(keeping.Parts)
        self._line = InOrder(page.notify)

    def ask(self, ask: from_page.Ask) -> None:
        """Have a question answered after those before it."""
        self._line.submit(self._answer, ask)

    def later(self, work: Callable[..., None], *arguments: Any) -> None:
        """Have something done in a thread, after what was asked for before it."""
        self._line.submit(work, *arguments)

    @property
    def unfinished(self) -> Collection[keeping.Parts]:
        """The texts of which parts are missing."""
        return self._parts.values()

    def take(self, part: from_page.Part) -> None:
        """Put together what comes in parts, of which this is the next, and do what is to be done with it."""
        if part.kind not in VERBS and part.kind not in self._readers:
            return
        letters = self._parts[part.kind].add(part.number, part.of, part.letters)
        if letters is None:
            if sum(text.size for text in self.unfinished) > MAX_UNFINISHED:
                self._parts.clear()
                self._page.notify(TOO_MUCH)
            return
        if (reader := self._readers.get(part.kind)) is not None:
            needs = reader.texts[part.kind].needs
            if not needs or needs in self._page.controls:
                self._line.submit(reader.read, part.kind, letters)
        elif part.kind == "resume":
            if kept := keeping.decode(letters):
                self._resume(kept)
            else:
                self._page.mail.send(Resumed())  # as far as it can be

    def _verb(self, kind: str) -> str:
        """What is done with long texts of a kind."""
        reader = self._readers.get(kind)
        return reader.texts[kind].verb if reader is not None else VERBS.get(kind, "sent")

    def _answer(self, ask: from_page.Ask) -> None:
        match ask:
            case from_page.Who():
                self._page.shelf.introduce(ask)
            case from_page.Unread(text):
                self._page.notify(unread(text))
            case from_page.Unsent(what):
                self._page.notify(Notice("error", f"That cannot be {self._verb(what)}", UNSENT))


UNSENT = "It is too large for a page to send: at most 4.7 MB, which is some 11,000 masses."
VERBS = {"resume": "resumed"}
"""What is done with long texts."""


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
    """Work of one page, done in order by the threads of all pages, so that none keeps them to itself.

    Args:
        refuse: tells the page's user that there is too much of it.
    """

    def __init__(self, refuse: Callable[[Notice], None]) -> None:
        self._waiting: Waiting[Callable[[], None]] = Waiting(refuse)
        self._lock = threading.Lock()
        self._busy = False

    def submit(self, work: Callable[..., None], *arguments: Any) -> None:
        """Have something done after all that waits, in another thread."""
        with self._lock:
            self._waiting.add(partial(work, *arguments))
            if self._busy:
                return
            self._busy = True
        beside.submit(self._next)

    def _next(self) -> None:
        with self._lock:
            work = self._waiting.take()
        try:
            work()
        except Exception:  # a defect, or a page that went away meanwhile
            _log.exception("a request of a page failed")
        with self._lock:
            self._busy = more = len(self._waiting) > 0
        if more:
            beside.submit(self._next)
