"""Callbacks for changes by the user; viser also calls its handlers when the server changes a control."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser


def on_change(handle: Any, act: Callable[[], None]) -> None:
    """Call back, on viser's event loop, when the user changes a control."""

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
    if blocks:
        button.on_click(lambda _: press())
        return

    @button.on_click
    async def _(_: object) -> None:
        press()


def add_command(gui: viser.GuiApi, label: str, act: Callable[[], None], keys: str | None = None) -> None:
    """Add a command to the palette, which calls back on viser's event loop."""

    @gui.add_command(label, description=keys).on_trigger
    async def _(_: object) -> None:
        act()
