"""The connection of a device that tries whether it can take part."""

from __future__ import annotations

from app.classroom.live import Class, Tried

from ...gate.address import page_query
from ...session.session import Session
from ...wire import from_page
from .role import Role


def is_check(query: str) -> bool:
    """Whether the query of a page's address says that it only tries."""
    return (page_query(query) or {}).get("as") == "check"


class CheckRole(Role):
    """A page with a body in motion, which nobody sees: its pictures are counted.

    Args:
        klass: the class whose teacher is told; None if there is none.
    """

    def __init__(self, klass: Class | None) -> None:
        self._klass = klass

    def allows(self, said: from_page.FromPage) -> bool:
        return isinstance(said, from_page.Checked)

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        if self._klass is not None and isinstance(said, from_page.Checked):
            self._klass.tried.append(Tried(said.trip, said.rate, said.works, said.doubts))
