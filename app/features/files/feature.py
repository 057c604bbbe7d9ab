"""Files and links: what goes out of the page, and comes in."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

import viser

from ...session import commands
from ...ui.commands import Row
from ...ui.feature import Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from .export_panel import ExportPanel
from .messages import Share
from .panel import FilesPanel, open_file
from .sharing import Sharing

if TYPE_CHECKING:
    from ...ui.panel import Panel


class FilesFeature(Feature):
    """The Share tab of a page, if it has one, and the links that are opened in it."""

    messages: ClassVar = {Share: ""}
    texts: ClassVar = {
        "link": "",
        "file": "files",
    }
    commands: ClassVar = {
        "share": Row("page", needs="files", share=viser.Icon.LINK),
        "video": Row("page", needs="files"),
        "picture": Row("page", ("I",)),
    }
    controls: ClassVar = {"files": "the Share tab"}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        # In the queue of what the browser had stored of its page: a link comes after that.
        self._sharing = Sharing(
            page, lambda scene: page.soon(lambda: page.session.post(commands.Open(scene))), page.for_others
        )
        self._panel: FilesPanel | None = None

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        if isinstance(said, Share):
            self._sharing.share(said)

    def read(self, kind: str, letters: str) -> None:
        """See `Feature`."""
        if kind == "link":
            self._sharing.open(letters)
        else:
            open_file(self.page, letters)

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._panel = None
        if "files" in self.page.controls:
            with panel.tab("Share"):
                self._panel = FilesPanel(self.page)
                ExportPanel(self.page)

    def build(self) -> None:
        """See `Feature`."""
        if self._panel is not None:
            self._panel.build()
