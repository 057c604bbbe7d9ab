"""Work against error: tries the settings of each contender, then times the good ones in turns."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass

from .runs import (
    FAILURES,
    FRAME,
    SECONDS,
    WALL,
    Clock,
    Floats,
    Point,
    Runner,
    Trial,
    distance,
    method_label,
    reason,
    run,
)

Settings = Generator[float, Point, None]
"""Chooses one setting after another; each is answered by its point."""

MAX_SECONDS = 0.5
"""Seconds of computing per simulated second beyond which a ladder of settings ends."""

FINE = 3e-4
"""Error, px, below which a ladder of settings ends."""

SURE = 0.1
"""Part of the smallest error asked for at which a search among settings ends."""

TOLERANCE_SPACING = ((0.1, 1), (0.5, 2), (math.inf, 4))
"""Spacing of tolerances in half decades, by the seconds of a run: long runs are not worth many."""

FINEST_STEP = 1e-6
"""The shortest time step that a scene may have, s."""

BISECTIONS = 5
"""Bisections of the interval of steps in which the longest good one is sought: to within 2 %."""

MIN_TURN = 0.002
"""Seconds of computing in a turn of timing. The first run of a turn finds the caches full of another
contender's data, which makes a run of a tenth of a millisecond a quarter longer."""


@dataclass(frozen=True)
class Contender:
    """A method of an engine and its settings.

    Attributes:
        engine, method: names.
        settings: starts a choice of settings.
        text: a setting for people.
        make: prepares a run in one call; not timed.
        framed: prepares a run in a call per frame, which is compared with the whole reference; or None.
        times_frames: whether that is timed, too.
    """

    engine: str
    method: str
    settings: Callable[[], Settings]
    text: Callable[[float], str]
    make: Callable[[float], Runner]
    framed: Callable[[float], Runner] | None = None
    times_frames: bool = False


def ladder(values: Sequence[float], whole: bool = False) -> Callable[[], Settings]:
    """Settings from coarse to fine, until they take too long or are exact enough.

    Args:
        values: all settings.
        whole: whether to go on when they are exact enough.
    """

    def settings() -> Settings:
        for value in values:
            point = yield value
            if point.seconds > MAX_SECONDS or (point.error <= FINE and not whole):
                return

    return settings


def tolerances(errors: Sequence[float], longest: float, also: Sequence[float] = ()) -> Callable[[], Settings]:
    """Tolerances by half decades, until one is exact enough or takes too long.

    Args:
        errors: that are asked about, px.
        longest: seconds of a run that is too long.
        also: tolerances that are tried in any case.
    """

    def settings() -> Settings:
        half_decades = 4
        seen = []
        while half_decades > -22:
            value = 10.0 ** (half_decades / 2)
            point = yield value
            seen.append(value)
            if point.seconds > longest or point.error <= SURE * min(errors):
                break
            half_decades -= next(spacing for seconds, spacing in TOLERANCE_SPACING if point.seconds < seconds)
            half_decades += half_decades % 2 if point.seconds >= TOLERANCE_SPACING[0][0] else 0
        for value in also:
            if value not in seen:
                yield value

    return settings


def steps(errors: Sequence[float], longest: float) -> Callable[[], Settings]:
    """Time steps a factor of sqrt(2) apart; then, for each error, a search for the longest good one.

    Args:
        errors: that are asked about, px.
        longest: seconds of a run that is too long.
    """

    def settings() -> Settings:
        tried: dict[int, Point] = {}  # by steps per frame
        exponent = 0
        while (count := round(2.0 ** (exponent / 2))) <= FRAME / FINEST_STEP:
            point = tried[count] = yield FRAME / count
            # A run that exploded says nothing about shorter steps, however long it took.
            if not point.failure and (point.seconds > longest or point.error <= SURE * min(errors)):
                break
            exponent += 2 if count == 1 else 1
        for error in errors:
            good = [count for count, point in tried.items() if point.error <= error]
            if not good:
                continue
            fine = min(good)
            coarse = max((count for count in tried if count < fine), default=fine)
            for _ in range(BISECTIONS):
                middle = round(math.sqrt(coarse * fine))
                if middle in (coarse, fine):
                    break
                point = tried[middle] = yield FRAME / middle
                coarse, fine = (coarse, middle) if point.error <= error else (middle, fine)

    return settings


Judge = Callable[[Point, Floats], None]
"""Writes into a point what a (frames, n, 2) path shows.

Raises:
    ArithmeticError: the path is that of a body that ran away.
"""


def against(reference: Floats) -> Judge:
    """Compare paths with a reference, (frames, n, 2) px."""

    def judge(point: Point, path: Floats) -> None:
        if len(path) == 1:
            point.error = distance(path[-1], reference[-1])
        else:
            point.framed_error = distance(path[-1], reference[-1])
            point.path_error = distance(path, reference)

    return judge


@dataclass(frozen=True)
class Timing:
    """How runs are timed.

    Attributes:
        turns: turns of timing that a point deserves.
        clocks: see `run`.
        duration: simulated time of a run, s.
        patience: seconds of computing per simulated second after which a run is given up.
    """

    turns: Callable[[Point], int]
    clocks: Sequence[Clock] = WALL
    duration: float = SECONDS
    patience: float = math.inf

    def run(self, runner: Runner) -> Trial:
        """Run once, in seconds of computing per simulated second."""
        trial = run(runner, self.clocks, self.patience * self.duration)
        return Trial(trial.path, trial.seconds / self.duration, trial.failure)

    def shortest(self, runner: Runner) -> float:
        """Return the shortest time of the runs of a turn."""
        shortest = math.inf
        spent = 0.0
        while spent < MIN_TURN:
            seconds = self.run(runner).seconds
            shortest = min(shortest, seconds)
            spent += max(seconds * self.duration, 1e-6)
        return shortest


@dataclass(frozen=True)
class _Ready:
    """A point that is timed again, with its runs."""

    point: Point
    runner: Runner
    framed: Runner | None

    def time(self, timing: Timing) -> None:
        self.point.seconds = min(self.point.seconds, timing.shortest(self.runner))
        if self.framed is not None:
            self.point.framed_seconds = min(self.point.framed_seconds, timing.shortest(self.framed))
        self.point.runs += 1


def measure(
    scene: str, contenders: Iterable[Contender], judge: Judge, timing: Timing
) -> Iterator[tuple[list[Point], str]]:
    """Try the settings of all contenders on a scene, then time the good ones in turns.

    Args:
        scene: its name.
        contenders: who takes part.
        judge: what is seen of a path.
        timing: how it is timed.

    Yields:
        The points so far, which grow and become faster, and what comes next.
    """
    points: list[Point] = []
    ready: list[_Ready] = []
    for contender in contenders:
        settings = contender.settings()
        value = next(settings, None)
        label = method_label(contender.engine, contender.method)
        while value is not None:
            setting = contender.text(value)
            yield points, f"{contender.engine}, {label}, {setting}"
            point = Point(scene, contender.engine, contender.method, setting, value)
            points.append(point)
            found = _try(contender, point, judge, timing)
            if found is not None and timing.turns(point) > 1:
                ready.append(found)
            try:
                value = settings.send(point)
            except StopIteration:
                value = None
    turns = [timing.turns(each.point) for each in ready]
    for number in range(1, max(turns, default=0)):
        yield points, f"repeat {number} of {max(turns) - 1}"
        for each, count in zip(ready, turns, strict=True):
            if number < count:
                each.time(timing)
    yield points, "done"


def _try(contender: Contender, point: Point, judge: Judge, timing: Timing) -> _Ready | None:
    """Run a setting for the first time; None where it fails."""
    try:
        framed = contender.framed(point.value) if contender.framed else None
        looked = timing.run(framed) if framed is not None else None
        if looked is not None and looked.path is None:
            _fail(point, looked.failure, looked.seconds)
            return None
        runner = contender.make(point.value)
        whole = timing.run(runner)
        if whole.path is None:
            _fail(point, whole.failure, whole.seconds)
            return None
        point.seconds, point.runs = whole.seconds, 1
        judge(point, whole.path)
        if looked is not None and looked.path is not None:
            judge(point, looked.path)
            if contender.times_frames:
                point.framed_seconds = looked.seconds
    except FAILURES as error:
        _fail(point, reason(error), point.seconds)
        return None
    return _Ready(point, runner, framed if contender.times_frames else None)


def _fail(point: Point, failure: str, seconds: float) -> None:
    point.failure, point.seconds, point.error = failure, seconds, math.inf
