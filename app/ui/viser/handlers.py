"""Callbacks for changes by the user; viser also calls its handlers when the server changes a control.

They speak the language that was spoken when they were asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from contextvars import copy_context
from typing import Any

import viser


def on_change(handle: Any, act: Callable[[], None]) -> None:
    """Call back, on viser's event loop, when the user changes a control."""
    act = _as_here(act)

    @handle.on_update
    async def _(event: viser.GuiEvent[Any]) -> None:
        if event.client_id is not None:
            act()


def on_press(button: Any, press: Callable[[], None], blocks: bool = False) -> None:
    """Call back when a button is pressed.

    Args:
        button: the button.
        press: called on viser's event loop.
        blocks: it may take a while, so one of viser's threads calls it.
    """
    press = _as_here(press)
    if blocks:
        button.on_click(lambda _: press())
        return

    @button.on_click
    async def _(_: object) -> None:
        press()


def add_command(gui: viser.GuiApi, label: str, act: Callable[[], None], keys: str | None = None) -> None:
    """Add a command to the palette, which calls back on viser's event loop."""
    act = _as_here(act)

    @gui.add_command(label, description=keys).on_trigger
    async def _(_: object) -> None:
        act()


def _as_here(act: Callable[[], None]) -> Callable[[], None]:
    context = copy_context()
    # A context is entered by one thread at a time.
    return lambda: context.copy().run(act)
