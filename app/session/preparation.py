"""The state of the compiler, as a page shows it."""

from __future__ import annotations

from sim.compiling.compiler import Compiler, cache_trouble
from sim.engine.tables import Body

from ..words import say
from ..words.settings import options_of
from .session import Refresh, Session


def compile_status(ready: int, of: int, busy_with: str, awaited: str) -> str:
    """The progress of the compiler in words; empty once everything is compiled.

    Args:
        ready: number of compiled parts.
        of: number of all parts.
        busy_with: what is being compiled.
        awaited: the method that the body waits for, stepped by NumPy meanwhile; empty if it does not wait.
    """
    if awaited:
        text = say("session-awaited", what=awaited, ready=ready, count=of)
    elif ready < of:
        text = say("session-preparing", what=busy_with, ready=ready, count=of)
    else:
        return ""
    trouble = cache_trouble()
    return f"{text}; {trouble}" if trouble else text


class Preparation:
    """Has the compiler prepare what a page needs, and shows its progress.

    Args:
        compiler: compiles kernels in the background.

    Attributes:
        is_done: everything that the page's body may need is compiled.
    """

    def __init__(self, compiler: Compiler) -> None:
        self._compiler = compiler
        self._wanted: tuple[str, Body | None] = "", None
        self.is_done = False

    def update(self, session: Session) -> None:
        """Ask for what a new method or body needs, and note the progress in the session."""
        method, waits = session.simulation.method, session.simulation.plain
        body = session.simulation.tables[0].body
        if (method, body) != self._wanted:
            self._wanted = method, body
            self._compiler.want_for(method, body)
            self.is_done = False
        if self.is_done and not waits:
            return
        ready, of = self._compiler.progress
        self.is_done = ready == of
        text = compile_status(
            ready, of, self._compiler.busy_with, options_of("method")[method] if waits else ""
        )
        if text != session.preparing:
            session.preparing = text
            session.refresh(Refresh.SETTINGS)
