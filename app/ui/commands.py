"""Commands: what keys, buttons, menus, the palette and the help offer.

A row is all that a command needs: the page's copy of the table (`app/wire/commands.js`), the list of keys in
docs/using.md and the types of the script are made from it by ``uv run python -m tests.page.generate``. Rows
stand with the features that do them; `app.pages.sandbox.features` has the whole table.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import viser

from ..session import commands
from ..session.session import Session

Does = commands.Command | Callable[[Session, Any], None] | Literal["page", "edit", "own"]
"""What a command does: a command of the session; a function for the ticker, of the session and of the feature
that the command belongs to; something that the page's script does; or what the script
does where it listens to the keys: while the tools of editing are out, or in a place of its own. The last two
are not in the palette."""


@dataclass(frozen=True)
class Row:
    """A command.

    Attributes:
        label: what it is called, in the palette and in menus.
        does: see `Does`.
        keys: that do it, as they are shown.
        help: what the help and the documents say of the keys; rows with the same words are one line there.
        hint: a sentence on it, for the tooltip of its button.
        needs: the control without which it is left out, see `controls.PARTS`.
        icon: outline of 24 by 24, the data of an SVG path.
        word: beside the icon of its button, where there is room; the label contains it.
        palette: whether the palette may have it.
        held: whether its keys act as long as they are held.
        share: what its button in the Share tab says, and that button's icon; None without one.
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
        """Whether the palette has it."""
        return self.palette and self.does not in ("edit", "own")

    @property
    def where(self) -> str:
        """Where its keys act: "edit" or "own" as in `Does`, "held" while they are held, "" everywhere."""
        if isinstance(self.does, str) and self.does != "page":
            return self.does
        return "held" if self.held else ""


def key_lines(table: Mapping[str, Row]) -> list[tuple[str, str]]:
    """The keys and what the help says of them; keys that have the same words share a line."""
    keys: dict[str, list[str]] = {}
    for row in table.values():
        if row.help:
            keys.setdefault(row.help, []).extend(row.keys)
    return [(" or ".join(names), help) for help, names in keys.items()]
