"""A slider with a number box, for one setting."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any

import viser

from sim.settings import Setting

from ..session.notices import Notice
from . import readouts

TOUCHED = 0.4
"""Seconds for which a slider that its user moved is left alone by the server."""

TYPED = 3.0
"""Seconds after which a box that was left with a number that cannot be set shows what is set."""


DECIMALS = 9
"""Decimals that can be typed."""


class SliderBox:
    """A slider and a number box for one setting; the slider of a logarithmic one is over powers of ten.

    The slider covers the useful range, the box all that is allowed. While its user types, the box is left
    alone: half a number ("0." of "0.001") may be out of range, and is then not taken. What is still out of
    range when they are done is not taken either, and they are told so.

    Args:
        client: the page.
        setting: the setting.
        value: what is set.
        post: hands a value on.
        tell: says something to the user.
        order: where it stands in its tab; at the end if not given.

    Attributes:
        refused: whether what was typed last was out of range, and still stands there.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        setting: Setting,
        value: float,
        post: Callable[[float], None],
        tell: Callable[[Notice], None],
        order: float | None = None,
    ) -> None:
        self.setting = setting
        self._post, self._tell = post, tell
        self.refused = False
        self._touched = -math.inf
        self._known = value  # what the solver has, as far as this page knows
        self._retired = False
        low, high = setting.slider
        self._low, self._high = self._to_slider(low), self._to_slider(high)
        # On its way to 25, a number of masses passes 2, which would be a rope without any joint.
        self._least = low if setting.integer else setting.low
        if setting.integer:
            slider_step = box_step = 1.0
        elif setting.logarithmic:
            slider_step, box_step = 0.01, low / 100.0
        else:
            slider_step = box_step = 10.0 ** math.floor(math.log10((high - low) / 500.0))
        self._slider_step = slider_step
        self.slider = client.gui.add_slider(
            setting.label,
            min=self._low,
            max=self._high,
            step=slider_step,
            initial_value=self._place(value),
            marks=((self._low, readouts.short(low)), (self._high, readouts.short(high))),
            hint=self._range,
            order=order,
        )
        self.box = client.gui.add_number(
            "",
            initial_value=rounded(value),
            step=box_step,  # and no limits: viser would take the sign out of a number, or put in another one
            order=None if order is None else order + 0.5,
        )
        if not setting.integer:
            # viser allows as many decimals as the step has, and takes the point out of any other number.
            self.box.precision = DECIMALS

        @self.slider.on_update
        async def _(event: viser.GuiEvent[Any]) -> None:
            if event.client_id is not None:
                value = self._from_slider(self.slider.value)
                if self._send(value):
                    self.box.value = rounded(value)

        @self.box.on_update
        async def _(event: viser.GuiEvent[Any]) -> None:
            if event.client_id is not None:
                value = self.box.value
                self.refused = not self._send(value)
                if not self.refused:
                    self.slider.value = self._place(value)

    def retire(self) -> None:
        """It is about to be taken out of the page: what its user still sends is ignored."""
        self._retired = True

    def show(self, value: float) -> None:
        """Show what the solver has, if that is not what this page's user is just setting."""
        idle = time.monotonic() - self._touched
        if idle < TOUCHED or (alike(value, self._known) and idle < TYPED):
            return
        self._known = value
        if self.refused:
            self.refused = False
            self._say_range()
        if not alike(value, self.box.value):
            self.box.value = rounded(value)
        place = self._place(value)
        if abs(place - self.slider.value) >= 0.5 * self._slider_step:
            self.slider.value = place

    @property
    def _range(self) -> str:
        """What can be set, in words."""
        low, high = map(readouts.grouped, (self._least, self.setting.high))
        return f"{low} to {high} {self.setting.unit}".rstrip()

    def _say_range(self) -> None:
        self._tell(Notice("warning", "Out of range", f"{self.setting.label}: {self._range}"))

    def _send(self, value: float) -> bool:
        """Hand a value on, if it is one that can be set."""
        self._touched = time.monotonic()
        if self._retired or not self._least <= value <= self.setting.high:
            return False
        self._known = value
        self._post(value)
        return True

    def _place(self, value: float) -> float:
        """Where the slider stands for a value, at the end of its range for one beyond it."""
        return min(max(self._to_slider(value), self._low), self._high)

    def _to_slider(self, value: float) -> float:
        return math.log10(max(value, 1e-12)) if self.setting.logarithmic else float(value)

    def _from_slider(self, place: float) -> float:
        place = min(max(place, self._low), self._high)
        # Three digits are as fine as a hand can move it.
        return float(f"{10.0**place:.3g}") if self.setting.logarithmic else float(place)


def alike(a: float, b: float) -> bool:
    """Whether two numbers are the same in a box."""
    return math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-9)


def rounded(value: float) -> float:
    """A number as a box shows it."""
    return float(f"{value:.7g}")
