"""Commands of keys, buttons, menus, the palette and the help.

A row is what a command does, and by which keys; its texts are the message with its name in
`app/words/en/commands.ftl`. The page's copy of the table (`app/wire/commands.js`), the list of keys in
docs/using.md and the types of the script are made from both by ``uv run python -m tests.page.generate``. Rows
are declared by the features that execute them; `app.pages.sandbox.features` has the whole table.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any, Literal

import viser

from ..session import commands
from ..session.session import Session
from ..words import find, say

Does = commands.Command | Callable[[Session, Any], None] | Literal["page", "edit", "own"]
"""What a command does: a command of the session; a function of the session and of the command's feature,
called by the ticker; "page": a function of the page's script; "edit" or "own": something that the script does
where it listens to the keys, while the editing tools are open or elsewhere. The last two are not in the
palette."""


@dataclass(frozen=True)
class Row:
    """A command.

    Attributes:
        does: see `Does`.
        keys: its keys, as they are shown.
        needs: the control without which it is left out, see `Feature.controls`.
        icon: data of an SVG path, 24 by 24.
        palette: the palette may list it.
        held: its keys act as long as they are held.
        share: icon of its button in the Share tab; None without one.
    """

    does: Does
    keys: tuple[str, ...] = ()
    needs: str = ""
    icon: str = ""
    palette: bool = True
    held: bool = False
    share: viser.IconName | None = None

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


def key_of(name: str, part: str = "") -> str:
    """The key of a text of a command; of its name, or of an attribute of its message: `hint`, as in
    ``command-own-body.hint``."""
    message = "command-" + re.sub("[A-Z]", lambda letter: f"-{letter[0].lower()}", name)
    return f"{message}.{part}" if part else message


def text_of(name: str, part: str = "") -> str:
    """A text of a command, see `key_of`; "" if it has none."""
    return find(key_of(name, part))


def key_lines(table: Mapping[str, Row]) -> list[tuple[str, str]]:
    """Keys and their descriptions; keys with the same description share a line."""
    keys: dict[str, list[str]] = {}
    for name, row in table.items():
        if about := text_of(name, "help"):
            keys.setdefault(about, []).extend(row.keys)
    return [(keys_text(names), about) for about, names in keys.items()]


def keys_text(keys: Sequence[str]) -> str:
    """Keys that do the same, as the language that is spoken calls them."""
    names = (" ".join(find(f"key-{part.lower()}", part) for part in key.split(" ")) for key in keys)
    return reduce(lambda one, other: say("key-or", one=one, other=other), names)
