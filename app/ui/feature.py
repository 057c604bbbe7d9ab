"""The door of a feature: all that the rest of the page knows of it."""

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
    """A picture that was just drawn.

    Attributes:
        plan: the number of the body's plan, which belongs to it.
        now: wall time, s.
        exactly: whether the body stands, so that what goes with the picture is to be exact.
    """

    plan: int
    now: float
    exactly: bool


@dataclass(frozen=True)
class LongText:
    """A text that a page may send which is too long for one message.

    Attributes:
        needs: the control without which it is ignored.
        verb: what is done with it, as in "That cannot be opened".
    """

    needs: str
    verb: str


class Feature:
    """What one page has of a feature.

    A subclass stands in a folder of its own, and in `app.pages.sandbox.features`. It says as data what others
    have to know. A script and a style sheet with the folder's name belong to the page; the script's default
    export has its commands and begins it, see `Feature` in `feature.d.ts`. All methods are the ticker's but
    for `hear` and `read`.

    Attributes:
        messages: kinds of those that it hears, and the control without which each is ignored; "" for none.
        texts: long texts that it reads, by their kinds.
        commands: see `Row`.
        controls: names of controls that a page may have, and what they stand for.
    """

    messages: ClassVar[Mapping[type[FromPage], str]] = {}
    texts: ClassVar[Mapping[str, LongText]] = {}
    commands: ClassVar[Mapping[str, Row]] = {}
    controls: ClassVar[Mapping[str, str]] = {}

    def __init__(self, page: Page) -> None:
        self.page = page

    @property
    def session(self) -> Session:
        """The page's simulation."""
        return self.page.session

    def hear(self, said: FromPage) -> None:
        """Do what the page says with one of `messages`: on viser's event loop, where nothing may block, or
        for an `Ask` in a thread, after those before it."""

    def read(self, kind: str, letters: str) -> None:
        """Do what is to be done with one of `texts`; in a thread that may take its time."""

    def attach(self, panel: Panel) -> None:
        """Put controls into a panel, which is a new one with the controls that the page has now."""

    def detach(self) -> None:
        """Remember what the controls have come to: the panel is about to be taken out of the page."""

    def build(self) -> None:
        """The body is another one."""

    def frame(self, drawn: Drawn) -> None:
        """Tell the page what it does not know yet; after each picture."""

    def refresh(self) -> None:
        """Show in the controls what has changed: ten times a second, and at once where that is a setting."""

    @property
    def unsettled(self) -> bool:
        """Whether there will be more to show although nothing moves."""
        return False
