"""Whether tables that are saved have decimal commas: one choice of a page, shown where tables are saved."""

from __future__ import annotations

from collections.abc import Callable

import viser

from .handlers import on_change


class CommaSwitch:
    """The choice.

    Args:
        act: passes on whether its user wants commas.

    Attributes:
        on: whether tables have decimal commas, and semicolons between their columns.
    """

    def __init__(self, act: Callable[[bool], None]) -> None:
        self.on = False
        self._act = act
        self._shown: list[viser.GuiCheckboxHandle] = []

    def clear(self) -> None:
        """Forget the switches of a panel that is gone."""
        self._shown.clear()

    def add(self, gui: viser.GuiApi, order: float | None = None) -> viser.GuiCheckboxHandle:
        """Show it, where the next control would stand."""
        switch = gui.add_checkbox(
            "Decimal commas",
            initial_value=self.on,
            hint="tables that are saved have 0,5 for 0.5, and semicolons between the columns",
            order=order,
        )
        self._shown.append(switch)

        on_change(switch, lambda: self._act(bool(switch.value)))
        return switch

    def show(self, on: bool) -> None:
        """Choose, and show it everywhere."""
        self.on = on
        for switch in self._shown:
            switch.value = on
