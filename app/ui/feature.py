"""The interface of a feature: all that the rest of the page knows of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from ..session.session import Session
from ..wire.messages import FromPage
from .commands import Row

if TYPE_CHECKING:
    from .page import Page
    from .panel import Panel


@dataclass(frozen=True)
class Drawn:
    """The picture that was just drawn.

    Attributes:
        plan: number of the body's plan.
        now: wall time, s.
        exactly: the body stands, so that what belongs to the picture has to be exact.
    """

    plan: int
    now: float
    exactly: bool


class Feature:
    """A feature of one page.

    A subclass has a folder of its own, and an entry in `app.pages.sandbox.features`. It declares as data what
    others have to know. A script and a style sheet with the folder's name are part of the page; the script's
    default export has its commands and starts it, see `Feature` in `feature.d.ts`. All methods but `hear` and
    `read` are called by the ticker.

    Attributes:
        messages: kinds of messages that it handles, and the control that each needs; "" for none.
        texts: kinds of texts that it handles which are too long for one message, and the control that each
            needs; "" for none. The message `ui-unsent-KIND` says that one is too large.
        commands: see `Row`.
        controls: its controls by their names, and descriptions.
    """

    messages: ClassVar[Mapping[type[FromPage], str]] = {}
    texts: ClassVar[Mapping[str, str]] = {}
    commands: ClassVar[Mapping[str, Row]] = {}
    controls: ClassVar[Mapping[str, str]] = {}

    def __init__(self, page: Page) -> None:
        self.page = page

    @property
    def session(self) -> Session:
        """The page's simulation."""
        return self.page.session

    def hear(self, said: FromPage) -> None:
        """Handle one of `messages`: on viser's event loop, where nothing may block, or an `Ask` in a thread,
        after those before it."""

    def read(self, kind: str, letters: str) -> None:
        """Handle one of `texts`, in a thread that may take its time."""

    def attach(self, panel: Panel) -> None:
        """Add the feature's controls to a new panel."""

    def detach(self) -> None:
        """Remember the values of the controls; the panel is about to be removed."""

    def clear(self) -> None:
        """Put away what belongs to the scene before: another one was opened; `build` follows."""

    def build(self) -> None:
        """Adapt to another body."""

    def frame(self, drawn: Drawn) -> None:
        """Send what has changed; called after each picture."""

    def refresh(self) -> None:
        """Update the controls: ten times a second, and at once when a setting changes."""

    @property
    def unsettled(self) -> bool:
        """True if there will be more to show although nothing moves."""
        return False
