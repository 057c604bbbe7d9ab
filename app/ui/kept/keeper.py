"""Saves the state of a page in its browser, as often as the cost allows."""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable
from typing import NamedTuple

from ...session import commands
from ...session.notices import Notice
from ...session.plots import PlotSpec
from ...wire.to_page import Keepsake, Resumed
from ...words import say
from ..page import Page
from . import keeping, undo_store

MIN_INTERVAL = 1.0
"""Seconds between two saved states of a page whose state is cheap to save."""

MAX_INTERVAL = 3.0
"""Seconds after which a state is saved whatever it costs."""

MAX_SHARE = 0.001
"""Share of processor time that saving may take between these intervals."""


class KeptState(NamedTuple):
    """The state that was saved last."""

    revision: int
    looks: keeping.Looks
    plots: tuple[PlotSpec, ...]
    time: float


class Keeper:
    """Saves one page's state in its browser, and restores it; the ticker's.

    Args:
        page: the page.
        store: stores the state of a session elsewhere than in the browser; returns True if it did.

    Attributes:
        kept: the state that was saved last; None before that, or to have the next frame saved.
    """

    def __init__(self, page: Page, store: Callable[[bytes], bool]) -> None:
        self._page, self._store = page, store
        self._secret = secrets.token_hex(16)
        self._due = 0.0
        self._scene: tuple[int, str] = (-1, "")
        self.kept: KeptState | None = None

    def keep(self, plots: tuple[PlotSpec, ...], at_rest: bool) -> None:
        """Save the state if it has changed and is due.

        Args:
            plots: the open plots.
            at_rest: only the clock has advanced, which is not worth a message.
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
            undo_store.store(undo, session.versions)
        made = session.keepsake()
        if not self._store(made):
            page.mail.send(Keepsake(kept=keeping.encode(made, page.looks, plots, undo).decode()))
        self.kept, self._scene = state, scene
        wait = (time.thread_time() - began) / MAX_SHARE
        self._due = now + min(max(MIN_INTERVAL, wait), MAX_INTERVAL)

    def resume(self, saved: keeping.SavedPage) -> None:
        """Restore a saved state in this frame."""
        page = self._page
        versions = undo_store.copy_of(saved.undo) if saved.undo else None
        if saved.undo and versions is None:
            page.notify(Notice("info", say("ui-undo-afresh"), say("ui-undo-afresh.text")))
        page.session.post(commands.Resume(bytes(saved.session), versions))
        page.mail.send(Resumed())
        self.kept = None
        for look in saved.looks.__struct_fields__:
            page.set_look(look, getattr(saved.looks, look))
