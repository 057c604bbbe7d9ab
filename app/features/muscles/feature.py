"""A command that makes selected springs and joints muscles; the edits have all changes of muscles."""

from __future__ import annotations

from typing import ClassVar

from sim.edit.muscles import toggle_muscles

from ...session import commands
from ...ui.commands import Row
from ...ui.feature import Feature


class MusclesFeature(Feature):
    """The muscles of a page's body."""

    commands: ClassVar = {
        "muscle": Row(
            commands.Change(lambda moment, selected: toggle_muscles(moment.scene, selected)),
            ("U",),
            needs="edit",
        ),
    }
