"""How somebody uses the page: language, keys, motion. All of it is the page's script's."""

from __future__ import annotations

from typing import ClassVar

from ...ui.commands import Row
from ...ui.feature import Feature


class AccessFeature(Feature):
    """The page Access of the View menu."""

    commands: ClassVar = {"access": Row("page", needs="view")}
