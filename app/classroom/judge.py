"""Whether a step's goal was reached: during the run, and again from the log that was handed in.

A log is a file, and a file can be forged. So a judge replays it, and checks everything that could be more
than a pupil can do: the scene it begins with, what it sets, and where it goes back to.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import msgspec
import numpy as np

import sim
from sim.analysis.swings import swings
from sim.errors import InputError, SettingError
from sim.motion.quantities import Quantity, quantity
from sim.scene.lesson import Goal, Reading, Step
from sim.settings import CHOICES, set_choice, set_value, setting_of

from ..session import log
from ..session.log import Log, digest_of
from ..session.replay import Player
from ..words.english import of, refusal
from .answers import Doubt

SPAN = 60.0
"""Longest simulated time from which a period is measured, s."""

MAX_SECONDS = 3600.0
"""Longest simulated time of a log that is judged, s."""

_SAMPLES_EVERY = 1.0 / 240.0
"""Least time between two samples from which a period is measured, s."""


class Meter:
    """Takes a reading from a moving body.

    Args:
        reading: what.
        scene: of the body.

    Raises:
        InputError: the scene has no such quantity.
    """

    def __init__(self, reading: Reading, scene: sim.Scene) -> None:
        self._quantity: Quantity = quantity(reading.quantity, scene)
        self._of = reading.of
        self._times: list[float] = []
        self._values: list[float] = []
        self._last, self._at = math.nan, math.inf

    def take(self, simulation: sim.Simulation) -> float | None:
        """Return the present reading; None if there is none, as the period of a body that does not swing.

        Time may have gone back: later samples are dropped.
        """
        now = simulation.time
        before = self._last if self._at <= now else math.nan
        self._last, self._at = self._quantity.read(simulation, before), now
        value = self._last
        if self._of == "value":
            return value if math.isfinite(value) else None
        while self._times and self._times[-1] >= now:
            self._times.pop()
            self._values.pop()
        if not self._times or now - self._times[-1] >= _SAMPLES_EVERY:
            self._times.append(now)
            self._values.append(value)
        first = next((i for i, time in enumerate(self._times) if time >= now - SPAN), 0)
        del self._times[:first], self._values[:first]
        values = np.array(self._values)
        found = swings(np.array(self._times), values) if np.isfinite(values).all() else None
        return None if found is None else found.period


class GoalWatch:
    """Follows a run until its goal is reached.

    Args:
        goal: of the step.
        scene: of the body.

    Attributes:
        reached: whether it has been; never reset.
        value: the reading now, or None.
        held: simulated seconds for which the reading has been in the range without interruption.

    Raises:
        InputError: the scene has no such quantity.
    """

    def __init__(self, goal: Goal, scene: sim.Scene) -> None:
        self._goal, self._meter = goal, Meter(goal, scene)
        self._since: float | None = None
        self.reached = False
        self.value: float | None = None
        self.held = 0.0

    def look(self, simulation: sim.Simulation) -> bool:
        """Check the body between two steps; return `reached`."""
        goal = self._goal
        self.value = value = self._meter.take(simulation)
        low, high = -math.inf if goal.low is None else goal.low, math.inf if goal.high is None else goal.high
        inside = value is not None and low <= value <= high and simulation.divergence is None
        if not inside:
            self._since, self.held = None, 0.0
        else:
            if self._since is None or simulation.time < self._since:
                self._since = simulation.time
            self.held = simulation.time - self._since
            self.reached = self.reached or self.held >= goal.seconds
        return self.reached


@dataclass(frozen=True)
class Verdict:
    """The result of judging a log.

    Attributes:
        refused: why the log cannot be what a pupil did, see `Work`; empty if it can.
        reached: whether the goal was; None without a goal.
        found: the last reading of what the step collects, or None.
        steps: time steps that were replayed.
    """

    refused: Doubt | str = ""
    reached: bool | None = None
    found: float | None = None
    steps: int = 0


class _Forged(Exception):
    """A log has something that a pupil cannot do.

    Args:
        doubt: what.
    """

    def __init__(self, doubt: Doubt | str) -> None:
        super().__init__(doubt)
        self.doubt = doubt


def judge(record: Log, scene: sim.Scene, step: Step, been: Collection[str] = ()) -> Verdict:
    """Replay a log, and check whether it reached the goal of a step.

    Args:
        record: as handed in; nothing in it is trusted.
        scene: as the step begins.
        step: of the lesson.
        been: digests of the moments at which the server itself let the body go on, as after a reload of its
            page or when its kernels were ready, see `Recorder`.
    """
    try:
        _check_scene(record.scene, scene, step.controls, begins=True)
        return _judge(record, scene, step, been)
    except _Forged as error:
        return Verdict(refused=error.doubt)
    except (InputError, SettingError) as error:
        return Verdict(refused=refusal(error))


def _judge(record: Log, scene: sim.Scene, step: Step, seen: Collection[str]) -> Verdict:
    simulation = sim.Simulation(record.scene)
    player = Player(record, simulation)
    watch = GoalWatch(step.goal, record.scene) if step.goal is not None else None
    meter = Meter(step.collect, record.scene) if step.collect is not None else None
    found = None
    # All states so far: a pupil can go back only to one of these.
    been = {digest_of(simulation), *seen}
    while not player.ended:
        entry = player.upcoming
        match entry:
            case log.Set(key=key) | log.Choose(key=key) if key not in step.controls:
                raise _Forged(Doubt("class-doubt-sets", key))
            case log.Restore(scene=other) if other is not None:
                _check_scene(record.moments[player.at].scene, scene, step.controls, begins=False)
        player.do()
        if isinstance(entry, log.Restore) and digest_of(simulation) not in been:
            raise _Forged(Doubt("class-doubt-never"))
        if isinstance(entry, log.Step):
            been.add(digest_of(simulation))
            if watch is not None:
                watch.look(simulation)
            if meter is not None:
                found = meter.take(simulation)
        if simulation.time > MAX_SECONDS:
            raise _Forged(Doubt("class-doubt-long", f"{MAX_SECONDS:g} s"))
    if not player.agrees:
        raise _Forged(f"{player.verdict.rstrip('.')}.")
    return Verdict("", None if watch is None else watch.reached, found, player.steps)


def _check_scene(has: sim.Scene, wanted: sim.Scene, controls: tuple[str, ...], begins: bool) -> None:
    """Refuse a scene that differs from the step's by more than its sliders can set.

    Args:
        has, wanted: the log's scene, and the step's.
        controls: of the step.
        begins: whether the log begins with it; else it goes on with it.

    Raises:
        _Forged: it does.
    """
    for key in sorted(controls, key=lambda key: key not in CHOICES):  # a choice may change a number
        try:
            if key in CHOICES:
                wanted = set_choice(wanted, key, CHOICES[key].read(has))
            else:
                wanted = set_value(wanted, key, setting_of(has, key).read(has))
        except SettingError as error:
            key = "class-doubt-begins" if begins else "class-doubt-goes-on"
            raise _Forged(Doubt(key, of(str(error)))) from None
    if _bare(has) != _bare(wanted):
        raise _Forged(Doubt("class-doubt-begins-other" if begins else "class-doubt-goes-on-other"))


def _bare(scene: sim.Scene) -> sim.Scene:
    """Return a scene without what does not affect its motion."""
    plain = sim.Scene(name="x", masses=scene.masses)
    return msgspec.structs.replace(
        scene,
        name="x",
        title="",
        description="",
        lesson=None,
        view=plain.view,
        format=plain.format,
    )
