"""A slider with its number, for one setting."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import viser

from sim.edit.values import Number
from sim.scene.types import Scene
from sim.settings import Setting

from ...wire.carrier import Mail
from ...words import joined, say
from ...words.settings import label_of, remark_of, term_of
from .. import readouts
from .handlers import on_change
from .look import describe_control

TOUCHED = 0.4
"""Seconds for which the server does not move a slider that its user has moved."""


class SliderBox:
    """A slider with a number box for one setting.

    The slider covers the useful range, the box all that is allowed. The page's script refuses other numbers
    with a sentence (`app/ui/gui/numbers.js`); from other clients they are ignored.

    Args:
        client: the page.
        mail: of the page.
        setting: the setting.
        value: its present value.
        post: called with a new value.
        order: its place in the tab; at the end if not given.
        own: the scene's own value; None without one.

    Attributes:
        slider: viser's handle of it.
        settled: it shows the value of the solver, not one that its user has just set.
        mixed: the parts that it sets have different values; its label says so, and its hint what it then
        does.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        mail: Mail,
        setting: Setting,
        value: float,
        post: Callable[[float], None],
        order: float | None = None,
        own: float | None = None,
    ) -> None:
        self.setting = setting
        self._post = post
        self.settled = True
        self.mixed = False
        self._scene: Scene | None = None
        self._touched = -math.inf
        self._known = value  # the last known value of the solver
        self._retired = False
        low, high = setting.slider
        step = 1.0 if setting.integer else 10.0 ** math.floor(math.log10((high - low) / 500.0))
        self.slider = client.gui.add_slider(
            label_of(setting),
            min=low,
            max=high,
            step=step,
            initial_value=low,
            marks=((low, readouts.short(low)), (high, readouts.short(high))),
            hint=joined((term_of(setting), range_of(setting)), "language-semicolon"),
            order=order,
        )
        self.slider.value = rounded(value)  # which may be beyond the slider
        describe_control(
            mail, self.slider, unit=setting.unit, low=setting.low, high=setting.high,
            logarithmic=setting.logarithmic, own=own,
        )  # fmt: skip

        def enter() -> None:
            if not self._send(float(self.slider.value)):
                self.slider.value = rounded(self._known)

        on_change(self.slider, enter)

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
        if not alike(value, self.slider.value):
            self.slider.value = rounded(value)

    def _show_hint(self, scene: Scene) -> None:
        setting = self.setting
        mixed = setting.differs(scene)
        parts = (
            term_of(setting),
            range_of(setting),
            mixed_words(setting) if mixed else "",
            remark_of(setting, scene),
        )
        hint = joined(parts, "language-semicolon")
        if mixed != self.mixed or hint != self.slider.hint:
            self.mixed, self.slider.hint = mixed, hint
            label = label_of(setting)
            self.slider.label = say("ui-mixed", setting=label) if mixed else label

    def _send(self, value: float) -> bool:
        """Post a value if it is allowed, and return True if it was posted."""
        self._touched, self.settled = time.monotonic(), False
        if self._retired or not allows(self.setting, value):
            return False
        self._known = value
        self._post(value)
        return True


def mixed_words(setting: Setting) -> str:
    """What a slider does whose parts have different values."""
    if setting.key == "rest_angle":
        return say("ui-mixed.angles")
    return say("ui-mixed.numbers")


def allows(of: Setting | Number, value: float) -> bool:
    """Return True if a number may have a value."""
    return of.low <= value <= of.high


def range_of(of: Setting | Number) -> str:
    """The allowed range of a number as text."""
    high = f"{readouts.grouped(of.high)} {of.unit}".rstrip()
    return say("ui-range", low=readouts.grouped(of.low), high=high)


def alike(a: float, b: float) -> bool:
    """Return True if a box shows two numbers alike."""
    return math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-9)


def rounded(value: float) -> float:
    """A number as a box shows it."""
    return float(f"{value:.7g}")
