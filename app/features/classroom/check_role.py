"""The connection of a device that checks whether it can take part in a class."""

from __future__ import annotations

from app.classroom.live import Class, DeviceCheck

from ...gate.address import page_query
from ...session.session import Session
from ...wire import from_page
from . import messages
from .role import Role


def is_check(query: str) -> bool:
    """Whether the query of a page's address says that it is such a check."""
    return (page_query(query) or {}).get("as") == "check"


class CheckRole(Role):
    """A page with a moving body that nobody sees: its pictures are counted.

    Args:
        classroom: the class whose teacher is told of it; None if there is none.
    """

    def __init__(self, classroom: Class | None) -> None:
        self._classroom = classroom

    def allows(self, said: from_page.FromPage) -> bool:
        return isinstance(said, messages.Checked)

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        if self._classroom is not None and isinstance(said, messages.Checked):
            self._classroom.checks.append(DeviceCheck(said.trip, said.rate, said.works, said.doubts))
