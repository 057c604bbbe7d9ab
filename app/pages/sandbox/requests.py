"""What a page's script sends besides commands: requests that take a while, and long texts in parts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable
from typing import Any

from ...session.notices import Notice
from ...ui.feature import Feature
from ...ui.kept import keeping
from ...ui.page import Page
from ...ui.queues import SerialQueue, too_much
from ...wire import from_page
from ...wire.to_page import Resumed
from ...words import find, say

MAX_UNFINISHED = 6_000_000
"""Characters of unfinished texts that one page may have sent: slightly more than the longest text."""

OWN_TEXTS = ("resume",)
"""Kinds of long texts of no feature."""


class RequestHandler:
    """Handles the requests of one page's script, one after the other.

    Args:
        page: the page.
        features: its features, which may read long texts.
        resume: restores a saved state of the page.
    """

    def __init__(
        self, page: Page, features: Iterable[Feature], resume: Callable[[keeping.SavedPage], object]
    ) -> None:
        self._page, self._resume = page, resume
        self._readers = {kind: feature for feature in features for kind in feature.texts}
        self._chunks: defaultdict[str, keeping.ChunkAssembler] = defaultdict(keeping.ChunkAssembler)
        self._queue = SerialQueue(page.notify)

    def ask(self, ask: from_page.Ask) -> None:
        """Answer a question after those before it."""
        self._queue.submit(self._answer, ask)

    def later(self, work: Callable[..., None], *arguments: Any) -> None:
        """Call a function in a thread, after the requests before it."""
        self._queue.submit(work, *arguments)

    @property
    def unfinished(self) -> Collection[keeping.ChunkAssembler]:
        """The texts whose last part is missing."""
        return self._chunks.values()

    def take(self, part: from_page.Part) -> None:
        """Add a part to its text, and handle the text once it is complete."""
        if part.kind not in OWN_TEXTS and part.kind not in self._readers:
            return
        letters = self._chunks[part.kind].add(part.number, part.of, part.letters)
        if letters is None:
            if sum(text.size for text in self.unfinished) > MAX_UNFINISHED:
                self._chunks.clear()
                self._page.notify(too_much())
            return
        if (reader := self._readers.get(part.kind)) is not None:
            needs = reader.texts[part.kind]
            if not needs or needs in self._page.controls:
                self._queue.submit(reader.read, part.kind, letters)
        elif part.kind == "resume":
            if saved := keeping.decode(letters):
                self._resume(saved)
            else:
                # Nothing can be restored, but the page need not send it again.
                self._page.mail.send(Resumed())

    def _answer(self, ask: from_page.Ask) -> None:
        match ask:
            case from_page.Who():
                self._page.shelf.introduce(ask)
            case from_page.Unsent(what):
                title = find(f"ui-unsent-{what}", say("ui-unsent"))
                self._page.notify(Notice("error", title, say("ui-unsent.text")))
