"""Commands of keys, buttons, menus, the palette and the help.

A row is all that a command needs: the page's copy of the table (`app/wire/commands.js`), the list of keys in
docs/using.md and the types of the script are made from it by ``uv run python -m tests.page.generate``. Rows
are declared by the features that execute them; `app.pages.sandbox.features` has the whole table.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import viser

from ..session import commands
from ..session.session import Session

Does = commands.Command | Callable[[Session, Any], None] | Literal["page", "edit", "own"]
"""What a command does: a command of the session; a function of the session and of the command's feature,
called by the ticker; "page": a function of the page's script; "edit" or "own": something that the script does
where it listens to the keys, while the editing tools are open or elsewhere. The last two are not in the
palette."""


@dataclass(frozen=True)
class Row:
    """A command.

    Attributes:
        label: its name in the palette and in menus.
        does: see `Does`.
        keys: its keys, as they are shown.
        help: description of the keys in the help and the documents; rows with the same text share a line.
        hint: tooltip of its button.
        needs: the control without which it is left out, see `Feature.controls`.
        icon: data of an SVG path, 24 by 24.
        word: text beside the icon of its button, if there is room; the label contains it.
        palette: the palette may list it.
        held: its keys act as long as they are held.
        share: text and icon of its button in the Share tab; None without one.
    """

    label: str
    does: Does
    keys: tuple[str, ...] = ()
    help: str = ""
    hint: str = ""
    needs: str = ""
    icon: str = ""
    word: str = ""
    palette: bool = True
    held: bool = False
    share: tuple[str, viser.IconName] | None = None

    @property
    def listed(self) -> bool:
        """True if the palette lists it."""
        return self.palette and self.does not in ("edit", "own")

    @property
    def where(self) -> str:
        """Where its keys act: "edit" or "own" as in `Does`, "held" while they are held, "" everywhere."""
        if isinstance(self.does, str) and self.does != "page":
            return self.does
        return "held" if self.held else ""


def key_lines(table: Mapping[str, Row]) -> list[tuple[str, str]]:
    """Keys and their descriptions; keys with the same description share a line."""
    keys: dict[str, list[str]] = {}
    for row in table.values():
        if row.help:
            keys.setdefault(row.help, []).extend(row.keys)
    return [(" or ".join(names), help) for help, names in keys.items()]
