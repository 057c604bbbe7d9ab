"""The setting of a page whether saved tables have decimal commas, with a switch wherever tables are saved."""

from __future__ import annotations

from collections.abc import Callable

import viser

from ...words import say
from .handlers import on_change


class DecimalCommas:
    """The setting and its switches.

    Args:
        act: called with the new value when the user changes it.

    Attributes:
        on: tables have decimal commas, and semicolons between their columns.
    """

    def __init__(self, act: Callable[[bool], None]) -> None:
        self.on = False
        self._act = act
        self._shown: list[viser.GuiCheckboxHandle] = []

    def clear(self) -> None:
        """Forget the switches of a panel that has been removed."""
        self._shown.clear()

    def add(self, gui: viser.GuiApi, order: float | None = None) -> viser.GuiCheckboxHandle:
        """Add a switch at the place of the next control."""
        switch = gui.add_checkbox(
            say("ui-commas"),
            initial_value=self.on,
            hint=say("ui-commas.hint"),
            order=order,
        )
        self._shown.append(switch)

        on_change(switch, lambda: self._act(bool(switch.value)))
        return switch

    def show(self, on: bool) -> None:
        """Set the value, and show it in all switches."""
        self.on = on
        for switch in self._shown:
            switch.value = on
