"""Work on a page's scene that takes too long for a frame: in a thread, one piece at a time for each page.

Kernels leave the interpreter to the pages meanwhile; the rest shares it with them, so that large bodies are
left to scripts.
"""

from __future__ import annotations

import html
import threading
from collections.abc import Callable

import sim
from sim.errors import InputError, SceneError

from ...background import BackgroundWorker
from ...session.notices import Notice
from ...ui.page import Page
from ...words import say
from ...words.english import of, sentence, without_field

MAX_MASSES = 200
"""Masses of a body that a page works on; pages would notice the work on larger ones."""

_FUNCTIONS = ("make_stable", "damp_vibration", "set_wishes")
"""Functions of `sim` whose errors begin with their names."""

worker = BackgroundWorker()
"""The thread that does it for all pages."""


def problem(error: Exception | str) -> str:
    """Return an error as a sentence of its own, without the name of the function that raised it."""
    text = str(error)
    name = text.partition(": ")[0]
    return sentence(without_field(text, name) if name in _FUNCTIONS else of(text))


def paragraph(text: str, kind: str = "") -> str:
    """Return a text as HTML for a panel; nothing for an empty one."""
    return f'<div class="softrod-text{kind}">{html.escape(text)}</div>' if text else ""


class Job:
    """Work on one page's scene.

    Args:
        page: whose scene it is.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._lock = threading.Lock()

    @property
    def busy(self) -> bool:
        """Whether anything is being done."""
        return self._lock.locked()

    def run(self, work: Callable[[], None], then: Callable[[], None] = lambda: None) -> bool:
        """Do something in the thread, unless it is busy for this page; return whether it was begun.

        Args:
            work: what to do.
            then: called once the next piece can be begun.
        """
        if not self._lock.acquire(blocking=False):
            return False

        def run() -> None:
            try:
                work()
            finally:
                self._lock.release()
                then()

        worker.submit(run)
        return True

    def run_on_scene(
        self,
        trouble: str,
        work: Callable[[sim.Scene], None],
        with_pose: bool = False,
        instead: str = "",
        then: Callable[[], None] = lambda: None,
    ) -> bool:
        """Do something with the page's scene, as `run`; say what went wrong.

        Args:
            trouble: title of what is said then.
            work: gets the scene; may raise `InputError` and `SceneError`.
            with_pose: whether the scene has the body's present pose.
            instead: what to use for larger bodies, if there is anything.
            then: see `run`.
        """

        def run() -> None:
            try:
                scene = self._page.session.snapshot("a copy", with_pose)
                if len(scene.masses) > MAX_MASSES:
                    raise InputError(
                        say("solver-many.instead", count=MAX_MASSES, instead=instead)
                        if instead
                        else say("solver-many", count=MAX_MASSES)
                    )
                work(scene)
            except (InputError, SceneError) as error:
                self._page.notify(Notice("error", trouble, problem(error)))
            except Exception:
                self._page.notify(Notice("error", trouble, say("solver-error")))
                raise

        return self.run(run, then)
