"""The notices of one page; some are removed when their subject is over."""

from __future__ import annotations

from collections import deque
from typing import Literal

import viser

from ..session.notices import About, Notice
from ..session.session import Session
from ..words.english import of

_COLORS: dict[str, Literal["red", "orange", "green"]] = {"error": "red", "warning": "orange", "info": "green"}

MAX_WAITING = 100

SECONDS = 8.0
"""Seconds for which a notice is shown, without those for its length."""

SECONDS_A_CHARACTER = 0.06
"""Seconds more for each of its characters, to read it."""


def seconds_for(notice: Notice) -> float | None:
    """How long a notice is shown, s; None for one that stays until its subject is over."""
    if notice.about is not None:
        return None
    return SECONDS + SECONDS_A_CHARACTER * (len(notice.title) + len(notice.text))


class NoticeBoard:
    """The notices of a page.

    Args:
        client: viser's handle of the page.
    """

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._waiting: deque[Notice] = deque(maxlen=MAX_WAITING)
        self._transient: dict[About, viser.NotificationHandle] = {}

    def add(self, notice: Notice) -> None:
        """Show a notice with the next frame; any thread may call."""
        self._waiting.append(notice)

    @property
    def has_new(self) -> bool:
        """True if a notice is not shown yet."""
        return bool(self._waiting)

    @property
    def has_transient(self) -> bool:
        """True while a notice is shown that will be removed when its subject is over."""
        return bool(self._transient)

    def show(self, session: Session) -> None:
        """Show new notices, and remove those whose subject is over; called by the ticker."""
        self._waiting.extend(session.notices)
        session.notices.clear()
        for about in tuple(self._transient):
            if not session.notice_still_applies(about):
                self._transient.pop(about).remove()
        while self._waiting:
            notice = self._waiting.popleft()
            handle = self._client.add_notification(
                of(notice.title),
                of(notice.text),
                color=_COLORS[notice.kind],
                auto_close_seconds=seconds_for(notice),
            )
            if notice.about is not None:
                if notice.about in self._transient:
                    self._transient[notice.about].remove()
                self._transient[notice.about] = handle
