"""Commands: what keys, buttons, menus, the palette and the help offer.

A row is all that a command needs: the page's copy of the table (`app/wire/commands.js`), the list of keys in
docs/page.md and the types of the script are made from it by ``uv run python -m tests.page.generate``. Rows of
a feature stand with the feature; `app.page.features` has the whole table.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import viser

from sim.edit.muscles import toggle_muscles

from ..drawing.looks import ICONS
from ..session import commands
from ..session.session import Session

Look = Literal["dark", "gizmos", "meter"]
"""Looks of the page that are switches, see `keeping.Looks`."""


class Page(Protocol):
    """What commands do beyond the session: `Tab` has it. All of it is called in the ticker's thread."""

    def plot_angle(self) -> None:
        """Plot the angle of the joint that is read out."""
        ...

    def make_lesson(self) -> None:
        """Open the form of the scene's lesson."""
        ...

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


def _follow(session: Session, _: Page) -> None:
    session.post(commands.Follow(not session.follow))


def _energy(session: Session, _: Page) -> None:
    session.post(commands.FollowEnergy(not session.follows_energy))


def _foretell(session: Session, _: Page) -> None:
    session.post(commands.Foretell(session.foresight is None))


def _anew(session: Session, _: Page) -> None:
    session.post(commands.Open(session.opened, session.lesson_begun))


def _plot(_: Session, page: Page) -> None:
    page.plot_angle()


def _lesson(_: Session, page: Page) -> None:
    page.make_lesson()


def _muscle(session: Session, _: Page) -> None:
    session.post(commands.Change(lambda moment, selected: toggle_muscles(moment.scene, selected)))


def _help(_: Session, page: Page) -> None:
    page.show_help()


def _toggle(look: Look) -> Callable[[Session, Page], None]:
    return lambda _, page: page.toggle(look)


_HAND = (
    "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-1V4.5a1.5 1.5 0 0 1 3 0V11m0-5a1.5 1.5 0 0 1 3 0v7c0 4-2 7-6 7-3 0-4-1"
    "-5.500-4l-2-3.500a1.500 1.500 0 0 1 2.500-1.500L8 14"
)

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
    "gallery": Row("Choose another scene", "page", ("O",), "choose another scene", needs="chooser"),
    "anew": Row("Open this scene anew", _anew, needs="chooser"),
    "share": Row(
        "Share this scene by a link", "page", needs="files", share=("Share by a link", viser.Icon.LINK)
    ),
    "lesson": Row(
        "Make a lesson", _lesson, hint="steps with a question, a goal, sliders and plots", needs="edit",
        share=("Make a lesson", viser.Icon.LIST_CHECK),
    ),
    "follow": Row(
        "Follow the pointer, or stop", _follow, ("F",),
        "the ringed mass follows the pointer, or stops following",
    ),
    "plot": Row("Plot the joint's angle", _plot, ("G",), "plot the angle of the joint", needs="measure"),
    "fit": Row("Show the whole scene", "page", ("0",), "show the whole scene"),
    "chase": Row(
        "Camera goes with the body", "page", hint="with both, in a race; pan and zoom as ever", needs="view"
    ),
    "larger": Row("Larger, for a projector", "page", ("P",), "larger, for a projector"),
    "stopwatch": Row(
        "Stopwatch", "own", ("T", "L"),
        "start or stop the stopwatch, a lap, once it is on the canvas",
    ),
    "dark": Row("Dark", _toggle("dark"), needs="view"),
    "meter": Row(
        "Stability bar", _toggle("meter"), hint="always, not only where the time step is near its limit",
        needs="view",
    ),
    "gizmos": Row(
        "Arrows at held masses", _toggle("gizmos"), hint="to drag them along one axis", needs="view"
    ),
    "video": Row("Measure in a video", "page", needs="files"),
    "picture": Row("Picture of the page (PNG)", "page", ("I",), "a picture of the page, as a file"),
    "energy": Row("Energy: follow it, or stop", _energy, needs="solver"),
    "foretell": Row("Predictability: measure it, or stop", _foretell, needs="solver"),
    # ------------------------------------------------------------------------- editing
    "edit": Row(
        "Edit", "page", ("E",), "the tools that build and change the body: Build, Joint, Select, Cut",
        hint="Build and change the body", needs="edit", word="Edit", icon="M4 20l1-4L16 5l3 3L8 19zM14 7l3 3",
    ),
    "undo": Row(
        "Undo the last change of the body", commands.Undo(), ("Ctrl Z",), "undo, redo", word="Undo",
        icon="M9 7L4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2",
    ),
    "redo": Row(
        "Do again what was undone", commands.Redo(), ("Ctrl Y",), "undo, redo", word="Redo",
        icon="M15 7l5 5-5 5M20 12H10a5 5 0 0 0 0 10h2",
    ),
    "hand": Row("Hand", "edit", ("H",), hint="Take hold of masses and drag them", icon=_HAND),
    "build": Row(
        "Build", "edit", ("B",), hint="Click for a mass, drag from mass to mass for a spring",
        icon="M6 18a2.500 2.500 0 1 0 0-.01zM18 8a2.500 2.500 0 1 0 0-.01zM8 16l8-7M18 15v6M15 18h6",
    ),
    "joint": Row(
        "Joint", "edit", ("K",), hint="Point at a mass and click a corner for an angular spring",
        icon="M5 19L19 6M5 19h15M11 13.500a8 8 0 0 1 2.500 5.500",
    ),
    "select": Row(
        "Select", "edit", ("S",), hint="Click parts, or drag a frame around them",
        icon="M5 4l14 7-6 2-2 6z",
    ),
    "cut": Row(
        "Cut", "edit", ("C",), hint="Draw a line through springs",
        icon="M6 8a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM6 20a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM7.700 7.200L19 18"
        "M7.700 16.800L19 6",
    ),
    "pin": Row("Pin", "edit", ("P",), hint="Hold the masses where they are, or let them go"),
    "remove": Row("Delete", "edit", ("Delete", "Backspace"), hint="Take away what is selected"),
    "duplicate": Row("Duplicate", "edit", ("Ctrl D",), hint="A copy beside it"),
    "copy": Row("Copy", "edit", ("Ctrl C",)),
    "all": Row("Select all", "edit", ("Ctrl A",)),
    "mirror": Row("Mirror", "edit", hint="Left becomes right"),
    "corners": Row("Corners", "edit", hint="Angular springs at every corner, at rest as they are"),
    "triangulate": Row("Triangulate", "edit", hint="Springs until all is triangles"),
    "rest": Row("Rest as is", "edit", hint="Springs and joints rest as they are now"),
    "keep": Row(
        "Keep this shape", "edit", hint="Springs and joints hold the body as it is now"
    ),
    "stiffen": Row("Keep it, stiffer", "edit", hint="With the least stiffness that holds it as it is now"),
    "muscle": Row(
        "Muscle", _muscle, ("U",), "selected springs and joints become muscles, or are none any more",
        hint="Springs and joints that move to a beat; again, and they are none any more", needs="edit",
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
    "ownBody": Row("The body's own values", commands.OwnValues("body")),
    "ownSolver": Row("The solver's own values", commands.OwnValues("solver")),
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
