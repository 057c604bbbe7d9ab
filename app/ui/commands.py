"""Commands: what keys, buttons, menus, the palette and the help offer.

A row is all that a command needs: the page's copy of the table (`app/wire/commands.js`), the list of keys in
docs/using.md and the types of the script are made from it by ``uv run python -m tests.page.generate``. Rows
of a feature stand with the feature; `app.pages.sandbox.features` has the whole table.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import viser

from ..session import commands
from ..session.session import Session
from ..stage.looks import ICONS

Look = Literal["dark", "gizmos", "meter"]
"""Looks of the page that are switches, see `keeping.Looks`."""


class Page(Protocol):
    """What commands do beyond the session: `Tab` has it. All of it is called in the ticker's thread."""

    def show_help(self) -> None:
        """Open the help."""
        ...

    def toggle(self, look: Look) -> None:
        """Turn a look of the page on or off."""
        ...


Does = commands.Command | Callable[[Session, Any], None] | Literal["page", "edit", "own"]
"""What a command does: a command of the session; a function for the ticker, of the session and of the feature
that the command belongs to, or else of the page; something that the page's script does; or what the script
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


def _help(_: Session, page: Page) -> None:
    page.show_help()


def _toggle(look: Look) -> Callable[[Session, Page], None]:
    return lambda _, page: page.toggle(look)


CORE: dict[str, Row] = {
    # ------------------------------------------------------------------------- time
    "play": Row("Play or pause", commands.Play(), ("Space",), "play or pause", icon=ICONS["play"]),
    "step": Row(
        "1 step", commands.DoSteps(1), ("N",), "one step; with Shift ten", word="Step",
        icon="M6 5v14l9-7zM16 5h2v14h-2z",
    ),
    "steps": Row("10 steps", commands.DoSteps(10), ("Shift N",)),
    "back": Row(
        "Back 1 frame", commands.GoBack(), (",",), "one frame back, one frame forward", word="Frame",
        icon="M18 5v14l-9-7zM6 5h2v14H6z",
    ),
    "forward": Row(
        "Forward 1 frame", commands.GoForward(), (".",), "one frame back, one frame forward", word="Frame",
        icon="M6 5v14l9-7zM16 5h2v14h-2z",
    ),
    "second": Row(
        "Back 1 second", commands.GoBack(1.0), ("J",), "one second back", word="1 s",
        icon="M20 5v14l-8-7zM11 5v14l-8-7z",
    ),
    "before": Row(
        "Go back to just before it exploded", commands.BackBeforeDivergence(),
        word="Go back to just before it",
    ),
    "reset": Row("Reset", commands.Reset(), ("R",), "reset", word="Reset", icon=ICONS["reset"]),
    "pause": Row(
        "Pause", commands.Play(False), ("Esc",), "pause; close this help, or a question", word="Pause",
        icon=ICONS["pause"],
    ),
    "run": Row("Play", commands.Play(True), palette=False),
    "forget": Row("Take the line away", commands.ForgetFuture(), palette=False),
    # ------------------------------------------------------------------------- what is shown
    "fit": Row("Show the whole scene", "page", ("0",), "show the whole scene"),
    "chase": Row(
        "Camera goes with the body", "page", hint="with both, in a race; pan and zoom as ever", needs="view"
    ),
    "larger": Row("Larger, for a projector", "page", ("P",), "larger, for a projector"),
    "dark": Row("Dark", _toggle("dark"), needs="view"),
    "meter": Row(
        "Stability bar", _toggle("meter"), hint="always, not only where the time step is near its limit",
        needs="view",
    ),
    "gizmos": Row(
        "Arrows at held masses", _toggle("gizmos"), hint="to drag them along one axis", needs="view"
    ),
    # ------------------------------------------------------------------------- the body by keys, and the help
    "body": Row(
        "The body by keys", "own", ("Tab",),
        "to the body, and on: arrows choose a mass, Space takes it, arrows move it",
    ),
    "lengths": Row(
        "Every spring longer, shorter", _help, ("↑ ↓",), "held: every spring longer, shorter", held=True
    ),
    "angles": Row("Every rest angle up, down", _help, ("→ ←",), "held: every rest angle up, down", held=True),
    "palette": Row("All commands", "own", ("Ctrl K",), "all commands"),
    "help": Row("Help", _help, needs="help"),
}  # fmt: skip
"""Commands of no feature by their names, in the order of the palette and of the help."""


def key_lines(table: Mapping[str, Row]) -> list[tuple[str, str]]:
    """The keys and what the help says of them; keys that have the same words share a line."""
    keys: dict[str, list[str]] = {}
    for row in table.values():
        if row.help:
            keys.setdefault(row.help, []).extend(row.keys)
    return [(" or ".join(names), help) for help, names in keys.items()]
