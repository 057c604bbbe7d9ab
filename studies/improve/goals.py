"""Goals: what `--goal` asks of a run, and how near a run comes to it."""

from __future__ import annotations

import math
import re
from collections.abc import Collection
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import sim
from app.classroom.judge import Meter
from sim.analysis.swings import swings
from sim.errors import InputError, SettingError, did_you_mean
from sim.motion.quantities import quantity
from sim.scene.lesson import Reading
from sim.settings import scene_of_step

Floats = NDArray[np.float64]

MAX_SECONDS = 600.0
"""Longest time, s, for which a goal may ask a quantity to stay in a range, as in lessons."""

EXPECTED = (
    '"max QUANTITY", "min QUANTITY", "near VALUE QUANTITY", "reach LOW..HIGH QUANTITY for SECONDS" or "step '
    'NUMBER" is expected, where QUANTITY may have mean, largest, smallest or period before it, as in "min '
    'largest spring0.force"'
)

Of = Literal["end", "mean", "largest", "smallest", "period"]

_OF: dict[str, Of] = {"mean": "mean", "largest": "largest", "smallest": "smallest", "period": "period"}

_WANTS = ("max", "min", "near", "reach", "step")

_SHOWN: dict[Of, str] = {
    "end": "{} at the end",
    "mean": "mean of {}",
    "largest": "largest {}",
    "smallest": "smallest {}",
    "period": "period of {}",
}

_ROUNDING = 1e-9
"""Seconds by which rounding may shorten a stay in a range."""


@dataclass(frozen=True)
class Goal:
    """What is wanted.

    Attributes:
        text: of `--goal`, with single spaces.
        want: the largest or smallest reading, one near a value, or that a quantity reaches a range soon.
        of: what is read of the quantity: its value at the end, its mean, largest or smallest value over time,
            or the period of its swings.
        quantity: its name.
        unit: of the result, which for "reach" is a time; empty for a pure number.
        value: for "near", in that unit.
        low, high: for "reach", in the unit of the quantity; infinite for no bound.
        seconds: for "reach", the time for which it stays there.
    """

    text: str
    want: Literal["max", "min", "near", "reach"]
    of: Of
    quantity: str
    unit: str
    value: float = 0.0
    low: float = -math.inf
    high: float = math.inf
    seconds: float = 0.0

    @property
    def result(self) -> str:
        """Name of the result for people, without its unit."""
        if self.want == "reach":
            period = "the period of " if self.of == "period" else ""
            return f"moment from which {period}{self.quantity} stays in its range"
        return _SHOWN[self.of].format(self.quantity)


def parse_goal(text: str, scene: sim.Scene) -> tuple[Goal, sim.Scene]:
    """Return a goal, and the scene it applies to.

    Args:
        text: in the form that `EXPECTED` describes.
        scene: to be improved; "step 2" takes it with the settings of the second step of its lesson.

    Raises:
        InputError: it is none of these, or the scene has no such quantity or step; the message begins with
            `--goal`.
    """
    text = " ".join(text.split())
    want, _, rest = text.partition(" ")
    if want == "step":
        return _of_step(text, rest, scene)
    value, low, high, seconds = 0.0, -math.inf, math.inf, 0.0
    if want == "near":
        number, _, rest = rest.partition(" ")
        value = _number(text, number)
    elif want == "reach":
        bounds, _, rest = rest.partition(" ")
        low, high = _range(text, bounds)
        if stay := re.fullmatch(r"(.+) for (\S+)", rest):
            rest, seconds = stay[1], _number(text, stay[2])
            if not 0.0 <= seconds <= MAX_SECONDS:
                raise InputError(f"--goal {text}: {seconds:g} is not in the range 0..{MAX_SECONDS:g} s")
    elif want not in ("max", "min"):
        raise InputError(f"--goal {text}: {_meant(want, _WANTS)}")
    of: Of = "end"
    word, space, after = rest.partition(" ")
    if space and word in _OF:
        of, rest = _OF[word], after
    elif space and word.isalpha() and not after.startswith("("):  # nor a function of a formula
        raise InputError(f"--goal {text}: {_meant(word, _OF)}")
    if not rest or (want == "reach" and of not in ("end", "period")):
        raise InputError(f"--goal {text}: {EXPECTED}")
    name, unit = _quantity(text, rest, scene)
    unit = "s" if want == "reach" or of == "period" else unit
    return Goal(text, want, of, name, unit, value, low, high, seconds), scene


def _meant(word: str, known: Collection[str]) -> str:
    """Return a message about an unknown word, with the most similar known one."""
    meant = did_you_mean(word, known)
    return f"{word!r} is none of {', '.join(known)}{meant}" if meant else EXPECTED


def _of_step(text: str, number: str, scene: sim.Scene) -> tuple[Goal, sim.Scene]:
    """Return the goal of a step of the lesson, and the scene with the settings of all steps up to it."""
    steps = scene.lesson.steps if scene.lesson else ()
    if not number.isdecimal() or not 1 <= int(number) <= len(steps):
        there = f"there are 1..{len(steps)}" if steps else f"the scene {scene.name!r} has no lesson"
        raise InputError(f"--goal {text}: there is no such step; {there}")
    goal = steps[int(number) - 1].goal
    if goal is None:
        raise InputError(f"--goal {text}: this step of the lesson has no goal")
    try:
        for i in range(int(number)):
            scene = scene_of_step(scene, i)
    except SettingError as error:
        raise InputError(f"--goal {text}: {error}") from None
    name, _ = _quantity(text, goal.quantity, scene)
    low, high = -math.inf if goal.low is None else goal.low, math.inf if goal.high is None else goal.high
    of: Of = "period" if goal.of == "period" else "end"
    return Goal(text, "reach", of, name, "s", 0.0, low, high, goal.seconds), scene


def _quantity(text: str, name: str, scene: sim.Scene) -> tuple[str, str]:
    """Return name and unit of a quantity."""
    try:
        found = quantity(name, scene)
    except InputError as error:
        raise InputError(f"--goal {text}: {error}") from None
    return found.name, found.unit


def _number(text: str, number: str) -> float:
    try:
        found = float(number)
    except ValueError:
        found = math.nan
    if not math.isfinite(found):
        raise InputError(f"--goal {text}: {number or 'nothing'!r} is not a finite number")
    return found


def _range(text: str, bounds: str) -> tuple[float, float]:
    """Return both bounds; one of them may be left out."""
    first, dots, last = bounds.partition("..")
    if not dots or not (first or last):
        raise InputError(f"--goal {text}: LOW..HIGH, LOW.. or ..HIGH is expected after reach")
    low = _number(text, first) if first else -math.inf
    high = _number(text, last) if last else math.inf
    if low > high:
        raise InputError(f"--goal {text}: {low:g} is above {high:g}")
    return low, high


class GoalMeter:
    """Follows a run, and measures how near it comes to a goal.

    Args:
        goal: of the scene.
        simulation: at its start.
    """

    def __init__(self, goal: Goal, simulation: sim.Simulation) -> None:
        self._goal, self._simulation = goal, simulation
        self._quantity = quantity(goal.quantity, simulation.scene)
        simulation.track_energy(self._quantity.is_of("energy"))
        self._times: list[float] = []
        self._values: list[float] = []
        # A lesson's goal asks at every moment for the period so far.
        reading = Reading(quantity=goal.quantity, of="period")
        wants_periods = goal.want == "reach" and goal.of == "period"
        self._periods = Meter(reading, simulation.scene) if wants_periods else None

    @property
    def needs_end_only(self) -> bool:
        """Whether the end of a run suffices, so that `look` need not be called."""
        return self._goal.want != "reach" and self._goal.of == "end" and not self._quantity.unwrapped

    def look(self) -> None:
        """Sample the present state."""
        value = self._periods.take(self._simulation) if self._periods is not None else self._value()
        self._times.append(self._simulation.time)
        self._values.append(math.nan if value is None else value)

    def _value(self) -> float:
        """Return the present value; an angle is unwrapped from the last look."""
        return self._quantity.read(self._simulation, self._values[-1] if self._values else math.nan)

    def result(self) -> tuple[float | None, float | None]:
        """Return the result at the end, and a score, which is lower the nearer the run came to the goal.

        The result is None if a range was not reached; both are None if there is no reading.
        """
        goal = self._goal
        if goal.want == "reach":
            return _reached(np.array(self._times), np.array(self._values), goal)
        value = self._reading()
        if value is None or not math.isfinite(value):
            return None, None
        return value, {"max": -value, "min": value}.get(goal.want, abs(value - goal.value))

    def _reading(self) -> float | None:
        if self._goal.of == "end":
            return self._value()
        times, values = np.array(self._times), np.array(self._values)
        if not np.isfinite(values).all():
            return None
        match self._goal.of:
            case "mean":
                parts = 0.5 * (values[1:] + values[:-1]) * np.diff(times)
                return float(parts.sum()) / float(times[-1] - times[0])
            case "largest":
                return float(values.max())
            case "smallest":
                return float(values.min())
        found = swings(times, values)
        return None if found is None else found.period


def _reached(times: Floats, values: Floats, goal: Goal) -> tuple[float | None, float | None]:
    """Return the moment from which values stay in the range long enough, and the score.

    Entries and exits are interpolated linearly between two samples. If the values do not stay long enough,
    the score grows with the missing time; if they never enter, with their distance from the range.

    Args:
        times: (k,) s.
        values: (k,); NaN where there is none.
        goal: the range, and for how long.
    """
    inside = (values >= goal.low) & (values <= goal.high)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], inside, [False])).astype(int)))
    longest = 0.0
    for first, after in edges.reshape(-1, 2).tolist():
        begin = _crossing(times, values, first - 1, first, goal) if first else float(times[0])
        last = after - 1
        end = _crossing(times, values, after, last, goal) if after < len(times) else float(times[last])
        if end - begin >= goal.seconds - _ROUNDING:
            return begin, begin
        longest = max(longest, end - begin)
    known = values[np.isfinite(values)]
    if not known.size:
        return None, None
    away = 0.0 if inside.any() else float(np.maximum(goal.low - known, known - goal.high).min())
    return None, float(times[-1]) + goal.seconds - longest + away


def _crossing(times: Floats, values: Floats, outside: int, inside: int, goal: Goal) -> float:
    """Return the moment between two samples at which values cross a bound of the range."""
    out, within = float(values[outside]), float(values[inside])
    if math.isnan(out):
        return float(times[inside])
    edge = goal.low if out < goal.low else goal.high
    share = (edge - out) / (within - out)
    return float(times[outside]) + share * float(times[inside] - times[outside])
