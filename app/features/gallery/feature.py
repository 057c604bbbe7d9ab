"""The gallery: all scenes on cards, to open one, to use one in a class, and to manage one's own."""

from __future__ import annotations

from typing import ClassVar

from ...session import commands
from ...session.session import Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from .gallery import Gallery
from .messages import ChangeScene, ListScenes, OpenScene, UseInClass

LOOK_EVERY = 0.3
"""Seconds between two looks whether scenes were saved or deleted, in whatever page."""


def _anew(session: Session, _: Feature) -> None:
    session.post(commands.Open(session.opened, session.lesson_begun))


class GalleryFeature(Feature):
    """The gallery of a page."""

    messages: ClassVar = {ListScenes: "", OpenScene: "", UseInClass: "", ChangeScene: ""}
    commands: ClassVar = {
        "gallery": Row("page", ("O",), needs="chooser"),
        "anew": Row(_anew, needs="chooser"),
    }
    controls: ClassVar = {
        "chooser": "the button with the scene's title, which opens the gallery, and Open anew"
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._gallery = Gallery(page)
        self._stamp, self._due = page.shelf.stamp(), 0.0

    def offer(self, why: str = "") -> None:
        """Have the page show it, with a sentence that says why, if there is one."""
        self._gallery.offer(why)

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case ListScenes():
                self._gallery.list(said)
            case OpenScene():
                self._gallery.open(said)
            case UseInClass():
                self._gallery.use_in_class(said)
            case ChangeScene():
                self._gallery.change(said)

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        if drawn.now < self._due:
            return
        self._due = drawn.now + LOOK_EVERY
        stamp = self.page.shelf.stamp()
        if stamp != self._stamp:
            self._stamp = stamp
            self._gallery.changed()
