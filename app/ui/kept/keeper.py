"""Has the browser store what its page needs to come back to where it is, as often as that is worth it."""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable
from typing import NamedTuple

from ...session import commands
from ...session.notices import Notice
from ...session.plots import Wish
from ...wire.to_page import Keepsake, Resumed
from ..page import Page
from . import keeping, pasts

MIN_INTERVAL, MAX_INTERVAL = 1.0, 3.0
"""Seconds between two saved states."""

MAX_SHARE = 0.001
"""The share of processor time that saving may take, within these intervals."""


class KeptState(NamedTuple):
    """What the browser was given last: the session's revision, and how the page looked."""

    revision: int
    looks: keeping.Looks
    plots: tuple[Wish, ...]
    time: float


class Keeper:
    """Saves one page's state in its browser, and restores it; the ticker's.

    Args:
        page: whose state it is.
        store: takes the state of a session instead of the browser, and says whether it did.

    Attributes:
        kept: what was saved last; None if nothing was, or if the next frame is to be saved.
    """

    def __init__(self, page: Page, store: Callable[[bytes], bool]) -> None:
        self._page, self._store = page, store
        self._secret = secrets.token_hex(16)
        self._due = 0.0
        self._scene: tuple[int, str] = (-1, "")
        self.kept: KeptState | None = None

    def keep(self, plots: tuple[Wish, ...], at_rest: bool) -> None:
        """Save the state if it has changed and is due.

        Args:
            plots: those that are open.
            at_rest: whether only the clock has gone on: that is not worth a message.
        """
        page, session = self._page, self._page.session
        now = session.now()
        state = KeptState(session.revision, page.looks, plots, session.simulation.time)
        resting = at_rest and self.kept is not None and state[:-1] == self.kept[:-1]
        # A scene that was just opened, or saved under another name, is saved at once.
        scene = (session.openings, session.scene.name)
        due = now >= self._due or scene != self._scene
        if not due or state == self.kept or resting or session.replay is not None:
            return
        began = time.thread_time()  # other threads' work is no reason to save less often
        undo = self._secret if len(session.versions) else ""
        if undo:
            pasts.keep(undo, session.versions)
        made = session.keepsake()
        if not self._store(made):
            page.mail.send(Keepsake(kept=keeping.encode(made, page.looks, plots, undo).decode()))
        self.kept, self._scene = state, scene
        wait = (time.thread_time() - began) / MAX_SHARE
        self._due = now + min(max(MIN_INTERVAL, wait), MAX_INTERVAL)

    def resume(self, kept: keeping.Kept) -> None:
        """Go on from a saved state, in this very frame."""
        page = self._page
        versions = pasts.of(kept.undo) if kept.undo else None
        if kept.undo and versions is None:
            text = "What was changed before the connection was lost can no longer be undone."
            page.notify(Notice("info", "Undo starts afresh", text))
        page.session.post(commands.Resume(bytes(kept.session), versions))
        page.mail.send(Resumed())
        self.kept = None
        for look in kept.looks.__struct_fields__:
            page.set_look(look, getattr(kept.looks, look))
