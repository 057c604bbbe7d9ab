"""The grid of a sweep: the product of the axes of `--vary`."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import sim
from sim.errors import InputError, SettingError
from sim.settings import SETTINGS, apply_assignments, settings_of

MAX_VALUES = 10_000
"""Values along an axis."""

MAX_RUNS = 100_000
"""Runs of a sweep."""

EXPECTED = "KEY=A..B:N, KEY=A..B:N:log or KEY=VALUE,VALUE,... is expected"


@dataclass(frozen=True)
class Axis:
    """A setting and the values that it takes.

    Attributes:
        key: of the setting, as in `--set`.
        values: texts of assignments; numbers have as many digits as it takes to read them back exactly.
        logarithmic: whether the values were asked for with equal ratios.
    """

    key: str
    values: tuple[str, ...]
    logarithmic: bool = False

    @property
    def numbers(self) -> list[float] | None:
        """The values as numbers; None if one is a name."""
        found = [number_in(value) for value in self.values]
        return None if None in found else [number for number in found if number is not None]


def parse_axis(text: str) -> Axis:
    """Return an axis from KEY=A..B:N, KEY=A..B:N:log or KEY=VALUE,VALUE,...

    Raises:
        InputError: it is none of these, a number is not finite, or the same value comes twice; the message
            begins with `--vary`.
    """
    key, equals, listed = (part.strip() for part in text.partition("="))
    if not (key and equals and listed):
        raise InputError(f"--vary {text}: {EXPECTED}")
    logarithmic = False
    if ".." in listed:
        ends, *rest = listed.split(":")
        logarithmic = rest[1:] == ["log"]
        if len(rest) != 1 + logarithmic:
            raise InputError(f"--vary {text}: {EXPECTED}")
        first, _, last = ends.partition("..")
        values = _spaced(text, first, last, rest[0], logarithmic)
    else:
        values = [word.strip() for word in listed.split(",")]
        if not all(values):
            raise InputError(f"--vary {text}: {EXPECTED}")
        if len(values) > MAX_VALUES:
            raise InputError(f"--vary {key}: {len(values)} values are more than {MAX_VALUES}")
    for value in values:
        number = number_in(value)
        if number is not None and not math.isfinite(number):
            raise InputError(f"--vary {text}: {value} is not a finite number")
    exact = [value if (number := number_in(value)) is None else text_of(number) for value in values]
    for i, value in enumerate(exact):
        if value in exact[:i]:
            raise InputError(f"--vary {text}: {value} comes twice")
    return Axis(key, tuple(exact), logarithmic)


def _spaced(text: str, first: str, last: str, count: str, logarithmic: bool) -> list[str]:
    """Return numbers from the first to the last, both exactly, with equal differences or equal ratios."""
    a, b = number_in(first), number_in(last)
    if a is None or b is None or not (math.isfinite(a) and math.isfinite(b)):
        raise InputError(f"--vary {text}: from {first.strip()} to {last.strip()} are not two finite numbers")
    if not count.strip().isdecimal() or not 2 <= int(count) <= MAX_VALUES:
        raise InputError(
            f"--vary {text}: {count.strip() or 'no number'} of values is not in the range 2..{MAX_VALUES}"
        )
    n = int(count)
    if logarithmic and not (a > 0.0 and b > 0.0):
        raise InputError(f"--vary {text}: equal ratios need two numbers above 0")
    if logarithmic:
        between = [a * (b / a) ** (i / (n - 1)) for i in range(1, n - 1)]
    else:
        between = [a + (b - a) * (i / (n - 1)) for i in range(1, n - 1)]
    return [text_of(value) for value in (a, *between, b)]


def number_in(text: str) -> float | None:
    """Return the number in a text; None if it is none."""
    try:
        return float(text)
    except ValueError:
        return None


def text_of(number: float) -> str:
    """Return a number in as many digits as it takes to read it back exactly."""
    return repr(number).removesuffix(".0")


def with_unit(name: str, unit: str) -> str:
    """Return a heading: a name with its unit in brackets, if it has one."""
    return f"{name} [{unit}]" if unit else name


@dataclass(frozen=True)
class Grid:
    """A scene and its axes; runs are numbered in the order of the rows, the last axis fastest.

    Attributes:
        scene: a valid scene.
        settings: assignments KEY=VALUE that hold in every run.
        axes: what is varied.
    """

    scene: sim.Scene
    settings: tuple[str, ...]
    axes: tuple[Axis, ...]

    @cached_property
    def points(self) -> list[tuple[str, ...]]:
        """Values of each run, one for each axis."""
        return list(itertools.product(*(axis.values for axis in self.axes)))

    def assignments(self, point: Sequence[str]) -> tuple[str, ...]:
        """Return the assignments of a run.

        Names come before numbers, since a method decides which numbers there are. A number that only some of
        the names use, such as the tolerance of some methods, is left out of the runs of the others.
        """
        varied = dict(zip((axis.key for axis in self.axes), point, strict=True))
        names = frozenset(key for key, value in varied.items() if number_in(value) is None)
        without = self._without_use(tuple((key, varied[key]) for key in sorted(names)))
        used = (f"{key}={value}" for key, value in varied.items() if key not in without)
        parts = [assignment.partition("=") for assignment in (*self.settings, *used)]
        parts.sort(key=lambda each: number_in(each[2]) is not None)
        return tuple("".join(each) for each in parts)

    def _without_use(self, names: tuple[tuple[str, str], ...]) -> frozenset[str]:
        """Return the varied numbers that have no effect with these names, but with others."""
        return self._useless.get(names, frozenset())

    @cached_property
    def _useless(self) -> dict[tuple[tuple[str, str], ...], frozenset[str]]:
        keys = [axis.key for axis in self.axes]
        of_names = [axis for axis in self.axes if any(number_in(value) is None for value in axis.values)]
        numbers = [key for key in keys if key in SETTINGS and key not in {axis.key for axis in of_names}]
        found: dict[tuple[tuple[str, str], ...], frozenset[str]] = {}
        for values in itertools.product(*(axis.values for axis in of_names)):
            names = tuple(sorted((axis.key, value) for axis, value in zip(of_names, values, strict=True)))
            set_names = [text for text in self.settings if number_in(text.partition("=")[2]) is None]
            try:
                scene = apply_assignments(self.scene, [*set_names, *(f"{k}={v}" for k, v in names)])
            except SettingError:
                continue  # `scene_at` reports it
            found[names] = frozenset(key for key in numbers if not SETTINGS[key].applies(scene))
        nowhere = frozenset.intersection(*found.values()) if found else frozenset()
        return {names: useless - nowhere for names, useless in found.items()}

    def scene_at(self, point: Sequence[str]) -> sim.Scene:
        """Return the scene of a run.

        Raises:
            InputError: the values do not fit the scene; the message names the option.
        """
        try:
            return apply_assignments(self.scene, self.assignments(point))
        except SettingError as error:
            reason = str(error).removeprefix("--set ")
            key = reason.partition("=")[0].partition(":")[0].strip()
            option = "--vary" if any(axis.key == key for axis in self.axes) else "--set"
            raise InputError(f"{option} {reason}") from None

    def unit(self, key: str) -> str:
        """Return the unit of a setting, or ""; "px" stands for the scene's own unit of length."""
        first = self.scene_at([axis.values[0] for axis in self.axes])
        units = {setting.key: setting.unit for setting in settings_of(first)}
        return units.get(key, "")


def make_grid(scene: sim.Scene, settings: Sequence[str], vary: Sequence[str]) -> Grid:
    """Return the grid of `--set` and `--vary`.

    Raises:
        InputError: there is nothing to vary, a key comes twice, or there are too many runs.
    """
    if not vary:
        raise InputError("--vary: name at least one setting, as in --vary gravity=0..2000:5")
    axes = tuple(parse_axis(text) for text in vary)
    check_keys(axes, settings)
    runs = math.prod(len(axis.values) for axis in axes)
    if runs > MAX_RUNS:
        raise InputError(f"--vary: {runs} runs are more than {MAX_RUNS}")
    return Grid(scene, tuple(settings), axes)


def check_keys(axes: Sequence[Axis], settings: Sequence[str]) -> None:
    """Refuse settings that are named more than once.

    Raises:
        InputError: a setting is varied twice, or set as well.
    """
    keys = [axis.key for axis in axes]
    for i, key in enumerate(keys):
        if key in keys[:i]:
            raise InputError(f"--vary {key}: it is varied twice")
        if key in (assignment.partition("=")[0].strip() for assignment in settings):
            raise InputError(f"--set {key}: it is varied as well")
