"""The looks of the page, and the help."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Literal

from ...session.session import Session
from ...ui import readouts
from ...ui.commands import Row, key_lines
from ...ui.feature import Feature
from ...ui.viser.handlers import on_press
from ...words import say


def _toggle(look: Literal["dark", "gizmos", "meter"]) -> Callable[[Session, Feature], None]:
    return lambda _, feature: feature.page.set_look(look, not getattr(feature.page.looks, look))


def _show_help(_: Session, feature: Feature) -> None:
    gui = feature.page.client.gui
    with gui.add_modal(say("view-help")) as modal:
        gui.add_html(readouts.help_html(key_lines(feature.page.commands)))
        on_press(gui.add_button(say("ui-close")), modal.close)


class ViewFeature(Feature):
    """The View menu, the palette and the help of a page."""

    controls: ClassVar = {
        "help": "Help, in the View menu",
        "view": "the other entries of the View menu",
    }
    commands: ClassVar = {
        "fit": Row("page", ("0",)),
        "chase": Row("page", needs="view"),
        "larger": Row("page", ("Z",)),
        "dark": Row(_toggle("dark"), needs="view"),
        "meter": Row(_toggle("meter"), needs="view"),
        "gizmos": Row(_toggle("gizmos"), needs="view"),
        "palette": Row("page", ("Ctrl K",), palette=False),
        "help": Row(_show_help, needs="help"),
    }
