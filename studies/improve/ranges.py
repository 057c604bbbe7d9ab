"""The ranges of a search: settings between two values, and places in them from 0 to 1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import sim
from sim.errors import InputError
from sim.settings import CHOICES, setting_of

from ..sweep.grid import Axis, Grid, check_keys, number_in, text_of

EXPECTED = "KEY=A..B is expected, as in linear_stiffness=1e3..1e5"

MAX_SETTINGS = 50
"""Settings that are varied at a time; a search in more takes runs by the ten thousand."""

_END_PART = 1e-3
"""Part of a range that counts as its end."""


@dataclass(frozen=True)
class Range:
    """A setting between two values, logarithmic where both are above 0.

    Attributes:
        key: of the setting.
        low, high: the ends.
        integer: whether it takes only whole numbers.
    """

    key: str
    low: float
    high: float
    integer: bool = False

    @property
    def logarithmic(self) -> bool:
        """Whether equal distances are equal ratios."""
        return self.low > 0.0

    def at(self, place: float) -> str:
        """Return the value at a place from 0 to 1, as the text of an assignment."""
        if self.logarithmic:
            value = self.low * (self.high / self.low) ** place
        else:
            value = self.low + (self.high - self.low) * place
        # Rounding may lead beyond the ends.
        value = min(max(value, self.low), self.high)
        return text_of(float(round(value)) if self.integer else value)

    def end(self, value: float) -> str:
        """Return which end of the range a value is at, "lower" or "upper"; "" for none."""
        place = self.place(value)
        if place is None or _END_PART < place < 1.0 - _END_PART:
            return ""
        return "lower" if place <= _END_PART else "upper"

    def place(self, value: float) -> float | None:
        """Return the place of a value; None if it is out of the range."""
        if not self.low <= value <= self.high:
            return None
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


def make_ranges(
    scene: sim.Scene, settings: Sequence[str], vary: Sequence[str]
) -> tuple[Grid, tuple[Range, ...]]:
    """Return the ranges of `--vary`, and a grid of their ends, which makes scenes of values in them.

    Raises:
        InputError: there is nothing to vary, a text is no range, a key comes twice, or a setting does not
            take the ends of its range; the message names the option.
    """
    if not vary:
        raise InputError("--vary: name at least one setting, as in --vary linear_stiffness=1e3..1e5")
    if len(vary) > MAX_SETTINGS:
        raise InputError(f"--vary: {len(vary)} settings are more than {MAX_SETTINGS}")
    found = [_range(text) for text in vary]
    axes = tuple(Axis(key, (text_of(low), text_of(high))) for key, low, high in found)
    check_keys(axes, settings)
    grid = Grid(scene, tuple(settings), axes)
    lowest, _ = [grid.scene_at(ends) for ends in zip(*(axis.values for axis in axes), strict=True)]
    ranges = (Range(key, low, high, setting_of(lowest, key).integer) for key, low, high in found)
    return grid, tuple(ranges)


def _range(text: str) -> tuple[str, float, float]:
    """Return key and ends.

    Raises:
        InputError: the text is no range.
    """
    key, _, ends = (part.strip() for part in text.partition("="))
    first, dots, last = (part.strip() for part in ends.partition(".."))
    if key in CHOICES:
        raise InputError(f"--vary {text}: {key} is a name and has no range; softrod sweep compares names")
    if not (key and dots):
        raise InputError(f"--vary {text}: {EXPECTED}")
    low, high = number_in(first), number_in(last)
    if low is None or high is None or not (math.isfinite(low) and math.isfinite(high)):
        raise InputError(f"--vary {text}: from {first} to {last} are not two finite numbers")
    if not low < high:
        raise InputError(f"--vary {text}: {low:g} is not below {high:g}")
    return key, low, high
