"""A slider with a number box, for one setting."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import viser

from sim.edit.values import Number
from sim.scene.types import Scene
from sim.settings import Setting

from ...session.notices import Notice
from .. import readouts
from .handlers import on_change

TOUCHED = 0.4
"""Seconds for which the server does not move a slider that its user has moved."""

NOTICE_EVERY = 3.0
"""Seconds between two notices that numbers of a box are out of range."""

DECIMALS = 15
"""Decimals that a box shows; viser would round to those of its step."""


class SliderBox:
    """A slider and a number box for one setting; the slider of a logarithmic one is over powers of ten.

    The slider covers the useful range, the box all that is allowed. Numbers out of range are refused with a
    notice. The page's script sends complete numbers only, see `numbers.js`.

    Args:
        client: the page.
        setting: the setting.
        value: its present value.
        post: called with a new value.
        notify: shows a notice to the user.
        order: its place in the tab; at the end if not given.
        apart: distance of the number box in this order.

    Attributes:
        settled: it shows the value of the solver, not one that its user has just set.
        mixed: the parts that it sets have different values; its label says so, and its hint what it then
        does.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        setting: Setting,
        value: float,
        post: Callable[[float], None],
        notify: Callable[[Notice], None],
        order: float | None = None,
        apart: float = 0.5,
    ) -> None:
        self.setting = setting
        self._post = post
        self._limits = Limits(setting, notify)
        self.settled = True
        self.mixed = False
        self._scene: Scene | None = None
        self._touched = -math.inf
        self._known = value  # the last known value of the solver
        self._retired = False
        low, high = setting.slider
        self._low, self._high = self._to_slider(low), self._to_slider(high)
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
            hint=self._limits.range,
            order=order,
        )
        self.box = client.gui.add_number(
            "",
            initial_value=rounded(value),
            step=box_step,  # without limits: viser would drop the sign of a number, or replace it
            order=None if order is None else order + apart,
        )
        self.box.precision = DECIMALS

        def slide() -> None:
            value = self._from_slider(self.slider.value)
            if self._send(value):
                self.box.value = rounded(value)

        def enter() -> None:
            value = self.box.value
            if self._send(value):
                self.slider.value = self._place(value)
            else:
                self.box.value = rounded(self._known)

        on_change(self.slider, slide)
        on_change(self.box, enter)

    def retire(self) -> None:
        """Ignore what its user still sends; it is about to be removed."""
        self._retired = True

    def show(self, scene: Scene) -> None:
        """Show the value of a scene, unless the user is just setting another one."""
        value = self.setting.read(scene)
        if scene is not self._scene:
            self._scene = scene
            self._show_hint(scene)
        self.show_value(value)

    def show_value(self, value: float) -> None:
        """Show a value, unless the user is just setting another one."""
        if time.monotonic() - self._touched < TOUCHED:
            return
        self._known, self.settled = value, True
        if not alike(value, self.box.value):
            self.box.value = rounded(value)
        place = self._place(value)
        if abs(place - self.slider.value) >= 0.5 * self._slider_step:
            self.slider.value = place

    def _show_hint(self, scene: Scene) -> None:
        setting = self.setting
        mixed = setting.differs(scene)
        parts = (self._limits.range, mixed_words(setting) if mixed else "", setting.remark(scene))
        hint = "; ".join(part for part in parts if part)
        if mixed != self.mixed or hint != self.slider.hint:
            self.mixed, self.slider.hint = mixed, hint
            self.slider.label = f"{setting.label} (mixed)" if mixed else setting.label

    def _send(self, value: float) -> bool:
        """Post a value if it is allowed, and return True if it was posted."""
        self._touched, self.settled = time.monotonic(), False
        if self._retired or not self._limits.allow(value):
            return False
        self._known = value
        self._post(value)
        return True

    def _place(self, value: float) -> float:
        """The slider's position for a value, limited to its range."""
        return min(max(self._to_slider(value), self._low), self._high)

    def _to_slider(self, value: float) -> float:
        return math.log10(max(value, 1e-12)) if self.setting.logarithmic else float(value)

    def _from_slider(self, place: float) -> float:
        place = min(max(place, self._low), self._high)
        # No hand moves it more finely than three digits.
        return float(f"{10.0**place:.3g}") if self.setting.logarithmic else float(place)


def mixed_words(setting: Setting) -> str:
    """What a slider does whose parts have different values."""
    if setting.key == "rest_angle":
        return "the slider turns the first angle, and the others by as much"
    return "the slider sets the largest number, and the others keep their ratio to it"


class Limits:
    """The values that a box may have, with a notice for others.

    Args:
        of: the number, with its label, unit and limits.
        notify: shows a notice to the user.

    Attributes:
        range: the allowed range as text.
    """

    def __init__(self, of: Setting | Number, notify: Callable[[Notice], None]) -> None:
        self._of, self._notify = of, notify
        self._noticed = -math.inf
        self.range = f"{readouts.grouped(of.low)} to {readouts.grouped(of.high)} {of.unit}".rstrip()

    def allow(self, value: float) -> bool:
        """Return True if a number is allowed; if not, show a notice."""
        if self._of.low <= value <= self._of.high:
            return True
        now = time.monotonic()
        if now - self._noticed > NOTICE_EVERY:  # a button that counts down may be held
            self._noticed = now
            self._notify(Notice("warning", "Out of range", f"{self._of.label}: {self.range}"))
        return False


def alike(a: float, b: float) -> bool:
    """Return True if a box shows two numbers alike."""
    return math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-9)


def rounded(value: float) -> float:
    """A number as a box shows it."""
    return float(f"{value:.7g}")
