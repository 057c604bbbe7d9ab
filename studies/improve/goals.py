"""Goals: what is wanted of a run, as `--goal` has it, and how near a run comes to it."""

from __future__ import annotations

import difflib
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
from sim.errors import InputError, SettingError
from sim.motion.quantities import quantity
from sim.scene.lesson import Reading
from sim.settings import scene_of_step

Floats = NDArray[np.float64]

MAX_SECONDS = 600.0
"""Seconds for which a goal may ask a quantity to stay in a range, as in lessons."""

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

_EXACT = 1e-9
"""Seconds by which rounding may shorten a stay in a range."""


@dataclass(frozen=True)
class Goal:
    """What is wanted.

    Attributes:
        text: as `--goal` has it, with single spaces.
        want: the largest or smallest reading, one near a value, or that a quantity reaches a range soon.
        of: what of the quantity: its value at the end, its mean, largest or smallest value over time, or the
            period of its swings.
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
        """What the result is, for people, without its unit."""
        if self.want == "reach":
            period = "the period of " if self.of == "period" else ""
            return f"moment from which {period}{self.quantity} stays in its range"
        return _SHOWN[self.of].format(self.quantity)


def parse_goal(text: str, scene: sim.Scene) -> tuple[Goal, sim.Scene]:
    """A goal, and the scene that it is of.

    Args:
        text: as `EXPECTED` says.
        scene: that is to be improved; "step 2" takes it as the second step of its lesson leaves it.

    Raises:
        InputError: it is none of these, or the scene has no such quantity or step; the sentence begins with
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
    words = rest.split()
    if len(words) == 2 and words[0] not in _OF:
        raise InputError(f"--goal {text}: {_meant(words[0], _OF)}")
    of: Of = _OF[words.pop(0)] if len(words) == 2 and words[0] in _OF else "end"
    if len(words) != 1 or (want == "reach" and of not in ("end", "period")):
        raise InputError(f"--goal {text}: {EXPECTED}")
    name, unit = _quantity(text, words[0], scene)
    unit = "s" if want == "reach" or of == "period" else unit
    return Goal(text, want, of, name, unit, value, low, high, seconds), scene


def _meant(word: str, known: Collection[str]) -> str:
    """What to say of a word that is none of those that there are."""
    alike = difflib.get_close_matches(word, known, 1)
    return f"{word!r} is none of {', '.join(known)}; is {alike[0]!r} meant?" if alike else EXPECTED


def _of_step(text: str, number: str, scene: sim.Scene) -> tuple[Goal, sim.Scene]:
    """The goal of a step of the scene's lesson, and the scene with what the steps until then set."""
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
    """The name and the unit of a quantity."""
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
    """From and to; one of them may be left out."""
    first, dots, last = bounds.partition("..")
    if not dots or not (first or last):
        raise InputError(f"--goal {text}: LOW..HIGH, LOW.. or ..HIGH is expected after reach")
    low = _number(text, first) if first else -math.inf
    high = _number(text, last) if last else math.inf
    if low > high:
        raise InputError(f"--goal {text}: {low:g} is above {high:g}")
    return low, high


class GoalMeter:
    """Follows a run, and says how near it came to a goal.

    Args:
        goal: of the scene.
        simulation: at its start.
    """

    def __init__(self, goal: Goal, simulation: sim.Simulation) -> None:
        self._goal, self._simulation = goal, simulation
        self._quantity = quantity(goal.quantity, simulation.scene)
        simulation.track_energy(self._quantity.kind.of == "energy")
        self._times: list[float] = []
        self._values: list[float] = []
        # A lesson's goal asks at every moment for the period until then.
        reading = Reading(quantity=goal.quantity, of="period")
        wants_periods = goal.want == "reach" and goal.of == "period"
        self._periods = Meter(reading, simulation.scene) if wants_periods else None

    @property
    def goes_by_end(self) -> bool:
        """Whether the end of a run is all that it needs to see, so that `look` need not be called."""
        return self._goal.want != "reach" and self._goal.of == "end" and not self._quantity.kind.unwrapped

    def look(self) -> None:
        """Note the present state."""
        value = self._periods.take(self._simulation) if self._periods is not None else self._value()
        self._times.append(self._simulation.time)
        self._values.append(math.nan if value is None else value)

    def _value(self) -> float:
        """The present value; an angle goes on from the last look."""
        return self._quantity.read(self._simulation, self._values[-1] if self._values else math.nan)

    def result(self) -> tuple[float | None, float | None]:
        """At the end: the result, and a score, which is less the nearer the run came to the goal.

        The result is None where a range was not reached; both are None where there is no reading.
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
    """The moment from which values stay in the range for long enough, and the score.

    The moments at which they come and go are on a straight line between two samples. Where they do not stay,
    the score is the larger the shorter their longest stay is; where they never come, the farther they keep
    away.

    Args:
        times: (k,) s.
        values: (k,); NaN where there is none.
        goal: the range, and for how long.
    """
    inside = (values >= goal.low) & (values <= goal.high)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], inside, [False])).astype(int)))
    longest = 0.0
    for first, after in edges.reshape(-1, 2).tolist():
        begin = _passage(times, values, first - 1, first, goal) if first else float(times[0])
        last = after - 1
        end = _passage(times, values, after, last, goal) if after < len(times) else float(times[last])
        if end - begin >= goal.seconds - _EXACT:
            return begin, begin
        longest = max(longest, end - begin)
    known = values[np.isfinite(values)]
    if not known.size:
        return None, None
    away = 0.0 if inside.any() else float(np.maximum(goal.low - known, known - goal.high).min())
    return None, float(times[-1]) + goal.seconds - longest + away


def _passage(times: Floats, values: Floats, outside: int, inside: int, goal: Goal) -> float:
    """The moment between two samples at which values pass an end of the range."""
    out, within = float(values[outside]), float(values[inside])
    if math.isnan(out):
        return float(times[inside])
    edge = goal.low if out < goal.low else goal.high
    share = (edge - out) / (within - out)
    return float(times[outside]) + share * float(times[inside] - times[outside])
