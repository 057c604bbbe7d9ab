"""Editing the body: gestures on the canvas, the numbers of the selection, undo and redo."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ...session import commands
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from .edits import Edits
from .messages import Edit
from .selection_panel import SelectionPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel

_HAND = (
    "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-1V4.5a1.5 1.5 0 0 1 3 0V11m0-5a1.5 1.5 0 0 1 3 0v7c0 4-2 7-6 7-3 0-4-1"
    "-5.500-4l-2-3.500a1.500 1.500 0 0 1 2.500-1.500L8 14"
)


class EditFeature(Feature):
    """The editing of one page."""

    messages: ClassVar = {Edit: "edit"}
    texts: ClassVar = {"paste": "edit"}
    controls: ClassVar = {"edit": "the tools that build and change the body, undo and redo"}
    commands: ClassVar = {
        "edit": Row("page", ("E",), needs="edit", icon="M4 20l1-4L16 5l3 3L8 19zM14 7l3 3"),
        "cross": Row("page", ("X",), needs="edit"),
        "undo": Row(commands.Undo(), ("Ctrl Z",), icon="M9 7L4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2"),
        "redo": Row(commands.Redo(), ("Ctrl Y",), icon="M15 7l5 5-5 5M20 12H10a5 5 0 0 0 0 10h2"),
        "hand": Row("edit", ("Q",), icon=_HAND),
        "build": Row(
            "edit",
            ("B",),
            icon="M6 18a2.500 2.500 0 1 0 0-.01zM18 8a2.500 2.500 0 1 0 0-.01zM8 16l8-7M18 15v6M15 18h6",
        ),
        "joint": Row("edit", ("K",), icon="M5 19L19 6M5 19h15M11 13.500a8 8 0 0 1 2.500 5.500"),
        "select": Row("edit", ("S",), icon="M5 4l14 7-6 2-2 6z"),
        "cut": Row(
            "edit",
            ("C",),
            icon="M6 8a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM6 20a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM7.700 7.200L19 18"
            "M7.700 16.800L19 6",
        ),
        "pin": Row("edit", ("P",)),
        "remove": Row("edit", ("Delete", "Backspace")),
        "duplicate": Row("edit", ("Ctrl D",)),
        "copy": Row("edit", ("Ctrl C",)),
        "all": Row("edit", ("Ctrl A",)),
        "mirror": Row("edit"),
        "corners": Row("edit"),
        "triangulate": Row("edit"),
        "rest": Row("edit"),
        "keep": Row("edit"),
        "stiffen": Row("edit"),
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._edits = Edits(page.session, page.mail, page.notify)
        self._selection: SelectionPanel | None = None

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        if isinstance(said, Edit):
            self._edits.do(said)

    def read(self, kind: str, letters: str) -> None:
        """See `Feature`."""
        self._edits.paste(letters)

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._selection = SelectionPanel(self.page) if "edit" in self.page.controls else None

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        if self._selection is not None:
            self._selection.tick()
            self._edits.tell()
