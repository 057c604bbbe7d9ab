"""How somebody uses the page: language, keys, motion. The page's script keeps it."""

from __future__ import annotations

from typing import ClassVar

from ...ui.commands import Row
from ...ui.feature import Feature
from ...wire.messages import FromPage
from .messages import Still


class AccessFeature(Feature):
    """The page Access of the View menu."""

    messages: ClassVar = {Still: ""}
    commands: ClassVar = {"access": Row("page", needs="view")}

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        assert isinstance(said, Still)
        self.session.stands = said.on
