"""Computing time against error on one scene."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import sim
from sim import Scene
from sim.methods.registry import METHODS

from . import others
from .contenders import FRAMES, Contender, Ours, Reference, Theirs, Trial, distance, reference
from .equations import Equations

TIGHT = (1e-9, 1e-10, 1e-11)
"""Tolerances of the reference, px; the tighter ones only where it takes them."""

SURE, UNSURE = 0.1, 0.3
"""Part of the smallest error that is asked for, to which the references are brought if they can be; and part
of an error above which their doubt makes it unknown who is within it."""

LONGEST, LONGEST_OURS = 2.0, 0.2
"""Seconds of a run beyond which finer settings of a method are not tried: of another solver's, and of
softrod's."""

GRADES = ((0.1, 1), (0.5, 2), (math.inf, 4))
"""Up to which seconds of a run tolerances are how many half decades apart."""

HOPELESS = 10.0
"""Errors larger than so many times the largest that is asked for are not timed again."""

FINEST_STEP = 1e-6
"""The shortest time step that a scene may have, s."""

BISECTIONS = 5
"""Times that the interval of steps is halved in which hindsight looks for the longest that is good enough."""

WARM = 0.002
"""Seconds of computing in a turn of the repeats: the first run of a turn finds the processor's caches full of
what others have left there, which takes a run of a tenth of a millisecond a quarter longer."""

FOLLOWED = "auto"
"""The method that is timed frame by frame, too."""


@dataclass
class Point:
    """One setting of one method on one scene.

    Attributes:
        scene: its name.
        integrator: a method of softrod, or another solver as `others` has it.
        value: time step, s, or tolerance, px.
        end_error: largest position error of a mass at the end, px; infinite where the run failed.
        path_error: the same at any frame; softrod goes frame by frame for it.
        seconds: of computing in one call, the least of the repeats.
        framed_seconds: in a call per frame, or NaN where that is not timed.
        framed_end_error: error at the end after a call per frame, or NaN.
        runs: how many turns of timing it had.
        failure: why it failed, or empty.
    """

    scene: str
    integrator: str
    value: float
    end_error: float
    path_error: float
    seconds: float
    framed_seconds: float = math.nan
    framed_end_error: float = math.nan
    runs: int = 1
    failure: str = ""


@dataclass
class SceneResults:
    """What is known of one scene.

    Attributes:
        scene: its name.
        doubt: how far the two methods of the reference are apart, px.
        points: one per setting.
        complete: whether all settings were tried, and timed as often as they should be.
    """

    scene: str
    doubt: float
    points: list[Point] = field(default_factory=list)
    complete: bool = False

    def doubtful(self, error: float) -> bool:
        """Whether the reference is too unsure to tell who is within an error, px."""
        return self.doubt > UNSURE * error

    def best(self, integrators: Sequence[str], error: float) -> Point | None:
        """The cheapest setting of some methods that ends within an error, px."""
        fitting = [p for p in self.points if p.integrator in integrators and p.end_error <= error]
        return min(fitting, key=lambda p: p.seconds, default=None)

    def at(self, integrator: str, value: float) -> Point | None:
        """The point of one setting."""
        points = [p for p in self.points if (p.integrator, p.value) == (integrator, value)]
        return points[0] if points else None


class _Explorer:
    """Tries the settings of the methods on one scene."""

    def __init__(self, scene: Scene, name: str, errors: Sequence[float]) -> None:
        self._scene, self._errors = scene, errors
        self._reference: Reference = reference(scene, TIGHT, SURE * min(errors))
        self.results = SceneResults(name, self._reference.doubt)
        self._ready: list[tuple[Point, Contender]] = []

    def explore(self, integrator: str) -> Iterator[str]:
        """Try a method's settings, from coarse to fine, until it is as exact as it has to be or takes too
        long. Says what comes next."""
        make = self._maker(integrator)
        fixed = integrator in METHODS and not METHODS[integrator].adaptive
        if fixed:
            yield from self._steps(integrator, make)
            return
        make(100.0).frame_by_frame()  # machine code, and what is imported late
        half_decades = 4
        seen: list[float] = []
        while half_decades > -22:
            value = 10.0 ** (half_decades / 2)
            yield f"tolerance {value:.2g}"
            point = self._try(integrator, value, make)
            seen.append(value)
            if self._enough(point):
                break
            half_decades -= next(grade for seconds, grade in GRADES if point.seconds < seconds)
            half_decades += half_decades % 2 if point.seconds >= GRADES[0][0] else 0
        if integrator == FOLLOWED:
            # Without hindsight: the tolerance is the error that is asked for.
            for error in self._errors:
                if error not in seen:
                    yield f"tolerance {error:.2g}"
                    self._try(integrator, error, make)

    def _steps(self, integrator: str, make: Callable[[float], Contender]) -> Iterator[str]:
        """Try steps, a factor of sqrt(2) apart, and for each error look for the longest that will do."""
        make(1.0 / FRAMES).in_one_call()
        tried: dict[int, Point] = {}  # by steps in a frame
        exponent = 0
        while (steps := round(2.0 ** (exponent / 2))) <= 1.0 / FRAMES / FINEST_STEP:
            yield f"dt {1e3 / FRAMES / steps:.2g} ms"
            tried[steps] = self._try(integrator, 1.0 / FRAMES / steps, make)
            if self._enough(tried[steps]):
                break
            exponent += 2 if steps == 1 else 1
        for error in self._errors:
            good = [steps for steps, point in tried.items() if point.end_error <= error]
            if not good:
                continue
            fine = min(good)
            coarse = max((steps for steps in tried if steps < fine), default=fine)
            for _ in range(BISECTIONS):
                middle = round(math.sqrt(coarse * fine))
                if middle in (coarse, fine):
                    break
                yield f"dt {1e3 / FRAMES / middle:.2g} ms"
                point = tried[middle] = self._try(integrator, 1.0 / FRAMES / middle, make)
                coarse, fine = (coarse, middle) if point.end_error <= error else (middle, fine)

    def _maker(self, integrator: str) -> Callable[[float], Contender]:
        if integrator in METHODS:
            return lambda value: Ours(self._scene, integrator, value)
        equations = Equations(self._scene)
        return lambda value: Theirs(equations, integrator, value)

    def _try(self, integrator: str, value: float, make: Callable[[float], Contender]) -> Point:
        contender = make(value)
        looked = contender.frame_by_frame()
        whole = contender.in_one_call() if looked.path is not None else looked
        right = self._reference.path
        point = Point(
            self.results.scene,
            integrator,
            value,
            end_error=math.inf if whole.path is None else distance(whole.path[-1], right[-1]),
            path_error=math.inf if looked.path is None else distance(looked.path, right),
            seconds=whole.seconds,
            failure=looked.failure or whole.failure,
        )
        if integrator == FOLLOWED and looked.path is not None:
            point.framed_seconds, point.framed_end_error = (
                looked.seconds,
                distance(looked.path[-1], right[-1]),
            )
        self.results.points.append(point)
        if point.end_error <= HOPELESS * max(self._errors):
            self._ready.append((point, contender))
        return point

    def _enough(self, point: Point) -> bool:
        if point.failure and point.integrator in METHODS and not METHODS[point.integrator].adaptive:
            return False  # it exploded, however long that took
        longest = LONGEST_OURS if point.integrator in METHODS else LONGEST
        return point.seconds > longest or point.end_error <= SURE * min(self._errors)

    def repeat(self) -> Iterator[str]:
        """Time all that is worth it again and again, one after the other, and keep the least times."""
        rounds = {id(point): repeats(point.seconds) for point, _ in self._ready}
        for number in range(1, max(rounds.values(), default=0)):
            yield f"repeat {number} of {max(rounds.values()) - 1}"
            for point, contender in self._ready:
                if number < rounds[id(point)]:
                    point.seconds = min(point.seconds, _least(contender.in_one_call))
                    if point.integrator == FOLLOWED:
                        point.framed_seconds = min(point.framed_seconds, _least(contender.frame_by_frame))
                    point.runs += 1
        self.results.complete = True


def _least(run: Callable[[], Trial]) -> float:
    """The least seconds of computing of the runs of a turn."""
    least, spent = math.inf, 0.0
    while spent < WARM:
        seconds = run().seconds
        least, spent = min(least, seconds), spent + max(seconds, 1e-6)
    return least


def repeats(seconds: float) -> int:
    """How often a run of that length is timed: the shorter, the more often, since others disturb it more."""
    return 25 if seconds < 0.005 else 5 if seconds < 0.05 else 2 if seconds < 0.5 else 1


def explore(
    scene: Scene, name: str, integrators: Sequence[str], errors: Sequence[float]
) -> Iterator[tuple[SceneResults | None, str]]:
    """Measure a scene. Gives what is known so far, and says what comes next.

    The points of the results grow and their times shrink as it goes on.
    """
    yield None, "reference"
    explorer = _Explorer(scene, name, errors)
    for integrator in integrators:
        for what in explorer.explore(integrator):
            yield explorer.results, f"{label(integrator)}, {what}"
    for what in explorer.repeat():
        yield explorer.results, what


def label(integrator: str) -> str:
    """A method's name for people."""
    return METHODS[integrator].label if integrator in METHODS else others.label(integrator)


def known(integrators: Sequence[str]) -> tuple[str, ...]:
    """All methods that can be measured here, or those that are asked for.

    Raises:
        sim.InputError: there is no such method, or what it needs is not installed.
    """
    here = (*METHODS, *others.SCIPY, *(others.CVODE if others.has_cvode() else ()))
    for name in integrators:
        if name in others.CVODE and name not in here:
            raise sim.InputError(
                f"--integrators: {name} needs scikit-sundae; uv sync --extra compare installs it"
            )
        if name not in here:
            raise sim.InputError(f"--integrators: {name!r} is not one of {', '.join(here)}")
    return tuple(dict.fromkeys(integrators)) or here
