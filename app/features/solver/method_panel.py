"""Which method suits a scene: a button in the Solver tab, a sentence and a figure.

All methods are tried in a thread of its own, one page's scene after the other. Kernels leave the interpreter
to the pages meanwhile.
"""

from __future__ import annotations

import html
import threading

import msgspec
import viser

import sim
from sim.analysis.advice import ERRORS, Advice, compare_methods
from sim.errors import InputError, SceneError

from ...server.background import BackgroundWorker
from ...session.notices import Notice
from ...ui.page import Page
from ...ui.viser.handlers import add_command

MAX_MASSES = 200
"""Masses of a body for which a page does that; `softrod study` does it for more."""

_worker = BackgroundWorker()


class MethodPanel:
    """The button, and what it finds.

    Args:
        page: whose scene it is about.
        order: of the first control; the others come within 1 of it.
    """

    def __init__(self, page: Page, order: float) -> None:
        self._page = page
        self._button = page.button(
            "Which method?",
            viser.Icon.SCALE,
            self._ask,
            hint="tries them all on the first second of the scene: which is near enough, and fast",
            order=order,
        )
        self._said = page.client.gui.add_html("", order=order + 0.1)
        self._busy = threading.Lock()
        self._working = False  # and what came of it is not shown yet
        self._found: tuple[sim.Scene, str] | None = None
        add_command(page.client.gui, "Which method suits the scene?", self._ask)

    @property
    def waits(self) -> bool:
        """Whether there will be more to show, though nothing moves."""
        return self._working

    def build(self, moving: bool) -> None:
        """Show it if the body can move."""
        self._button.visible = moving

    def refresh(self) -> None:
        """Show what is known of the scene as it is now, whatever method it has."""
        self._working = busy = self._busy.locked()
        # After the lock: what is found is there before that is released.
        scene, found = self._page.session.scene, self._found
        if found is not None and not _is_alike(found[0], scene):
            self._found = found = None
        self._button.disabled = busy
        self._said.content = _text("All methods are tried ...") if busy else found[1] if found else ""

    # --------------------------------------------------------------------- what handlers do
    def _ask(self) -> None:
        if self._busy.acquire(blocking=False):
            self._working = True
            _worker.submit(self._try_all)

    def _try_all(self) -> None:
        page = self._page
        try:
            scene = page.session.snapshot("methods", False)
            if len(scene.masses) > MAX_MASSES:
                raise InputError(
                    f"a page does that for at most {MAX_MASSES} masses; softrod study does it for more"
                )
            self._found = scene, _said(compare_methods(scene, wait=False))
        except (InputError, SceneError) as error:
            text = str(error)
            page.notify(Notice("error", "Methods cannot be compared", f"{text[:1].upper()}{text[1:]}."))
        except Exception:
            page.notify(Notice("error", "Methods cannot be compared", "There was an error on the server."))
            raise
        finally:
            self._busy.release()


def _text(text: str) -> str:
    return f'<div class="softrod-text">{html.escape(text)}</div>'


def _said(advice: Advice) -> str:
    """What is told of methods, as HTML."""
    from ...export.method_picture import methods_svg  # matplotlib does not delay the start

    return "".join(_text(advice.sentence(error)) for error in ERRORS) + (
        methods_svg(advice) if advice.tried else ""
    )


def _is_alike(one: sim.Scene, other: sim.Scene) -> bool:
    """Whether two scenes move alike, but for their methods."""
    named = msgspec.structs.replace(one, name=other.name, integrator=other.integrator)
    return named == other
