"""Recommendation of an integration method for a scene: all are tried, from coarse to fine settings.

The error of a run is the largest distance of a mass's final position from a reference. Two methods of very
different kinds at a tight tolerance give references. The cost is the least computing time of several runs.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import msgspec
import numpy as np

from ..engine.tables import Floats
from ..errors import InputError
from ..motion.simulation import Simulation
from ..scene.types import Integrator, Scene
from ..scene.validate import validate
from ..solve.registry import METHODS
from ..text import Text

ERRORS = (1.0, 0.1)
"""Default errors for which a method is recommended, px."""

SECONDS = 1.0
"""Simulated duration of a run, s."""

FRAME = 1.0 / 60.0
"""Longest time step tried, s; the others are fractions of it."""

AS_FAST = 1.1
"""Ratio of computing times up to which two methods count as equally fast."""

_REFERENCES = "adams", "rodas5p"
_TIGHT = (1e-3, 1e-6)
"""Tolerances of the references, relative to the smallest error; the tighter one is used only if needed."""
_SURE = 0.3
"""Largest difference between the references, relative to an error. Doubled,
`test_where_nothing_can_be_told_it_is_said` fails."""
# Unless noted, doubling or halving one of these numbers fails no test.
_LONGEST = 0.2
"""Computing time of a run, s, beyond which no finer setting of its method is tried."""
_PATIENCE = 3.0
"""Computing time, s, after which a run is given up; a reference may take ten times as long."""
_AT_ONCE = 2000
"""Number of time steps, or attempted steps, between two checks of the clock."""
_ROUNDS = 5
"""Number of rounds in which the best candidates are timed again, alternating between them."""


class Tried(NamedTuple):
    """The result of one setting of one method.

    Attributes:
        method: its name.
        value: the time step, s, or the tolerance, px.
        error: largest position error of a mass at the end, px; infinite where the run failed.
        seconds: computing time.
    """

    method: str
    value: float
    error: float
    seconds: float


@dataclass(frozen=True)
class Advice:
    """The performance of the methods on one scene.

    Attributes:
        tried: the settings that were tried.
        doubt: largest final distance between the two references, px; smaller errors cannot be resolved.
        moved: largest displacement of a mass from start to end, px.
    """

    tried: tuple[Tried, ...]
    doubt: float
    moved: float

    def front(self, method: str) -> list[Tried]:
        """Return the settings of a method that are not dominated in both error and time, fastest first."""
        kept: list[Tried] = []
        for one in sorted(
            (one for one in self.tried if one.method == method), key=lambda t: (t.seconds, t.error)
        ):
            if 0.0 < one.error < math.inf and (not kept or one.error < kept[-1].error):
                kept.append(one)
        return kept

    def is_doubtful(self, error: float) -> bool:
        """Whether the references are too far apart for an error, px."""
        return self.doubt > _SURE * error

    def sentence(self, error: float) -> str:
        """Name the cheapest method for an error, px, and the cost of the next best."""
        if self.moved <= error:
            return f"To {error:g} px nothing can be told: the body ends less than that from its start."
        if self.is_doubtful(error):
            return (
                f"To {error:g} px nothing can be told: near-exact solutions end {self.doubt:.1g} px apart, "
                "since small errors grow in this motion."
            )
        return f"To {error:g} px, {recommended(self.tried, error)}."


def best_two(tried: Iterable[Tried], error: float) -> tuple[Tried | None, Tried | None]:
    """Return the cheapest setting tried for an error, px, and the cheapest of another method."""
    # If a tolerance exceeds the error, meeting the error is luck.
    lucky = (one for one in tried if METHODS[one.method].adaptive and one.value > error)
    good = sorted({one for one in tried if one.error <= error} - {*lucky}, key=lambda one: one.seconds)
    best = good[0] if good else None
    return best, next((one for one in good if best is not None and one.method != best.method), None)


def recommended(tried: Iterable[Tried], error: float) -> str:
    """Name the cheapest setting tried for an error, px, and the cost of the next best method."""
    best, other = best_two(tried, error)
    if best is None:
        return "none of the settings that were tried comes as near"
    said = f"take {_setting(best)}, which ends {best.error:.1g} px off"
    if other is None:
        return said
    ratio = other.seconds / best.seconds
    as_long = "is as fast" if ratio < AS_FAST else f"takes {ratio:.2g} times as long"
    return f"{said}; {_setting(other)} {as_long} and ends {other.error:.1g} px off"


def _setting(one: Tried) -> str:
    """Describe a method and its tolerance or time step."""
    method = METHODS[one.method]
    value = f"{one.value:g} px" if method.adaptive else f"{1e3 * one.value:.3g} ms"
    return f"{method.label} at {value}"


def compare_methods(scene: Scene, errors: tuple[float, ...] = ERRORS, wait: bool = True) -> Advice:
    """Try all methods on the first second of a scene.

    This takes several seconds, during which the processor should have little else to do.

    Args:
        scene: a valid scene.
        errors: the errors of interest, px.
        wait: whether to wait for methods to be compiled; otherwise those that are not are left out.

    Raises:
        InputError: an error is not positive, no method completes a second, or the reference methods are not
            compiled.
    """
    scene = validate(scene)
    if not errors or not all(0.0 < error < math.inf for error in errors):
        raise InputError(Text("{where}: errors are numbers above zero, px", where="compare_methods"))
    return _Comparison(scene, errors, wait).advice()


class _Comparison:
    def __init__(self, scene: Scene, errors: tuple[float, ...], wait: bool) -> None:
        self._scene, self._errors, self._wait = scene, errors, wait
        self._runs: dict[tuple[str, float], Simulation] = {}

    def advice(self) -> Advice:
        """Run the whole comparison."""
        right, doubt = self._reference()
        start = self._simulation("auto", 1.0).positions
        tried = [one for method in METHODS for one in self._explore(method, right)]
        for _ in range(_ROUNDS):
            tried = [self._again(one) if self._may_be_best(one, tried) else one for one in tried]
        return Advice(tuple(tried), doubt, _distance(start, right))

    def _reference(self) -> tuple[Floats, float]:
        """Return the final positions of the masses, (n, 2) px, and how far two methods differ there."""
        best: tuple[Floats, float] | None = None
        for part in _TIGHT:
            tolerance = max(part * min(self._errors), 1e-11)
            runs = [self._simulation(method, tolerance) for method in _REFERENCES]
            if any(run.plain for run in runs):
                raise InputError(Text("the solver is still being compiled; try again in a moment"))
            ends = [run.positions for run in runs if _run(run, 10.0 * _PATIENCE) < math.inf]
            apart = _distance(*ends) if len(ends) == 2 else math.inf
            if ends and (best is None or apart < best[1]):
                best = ends[0], apart
            if apart <= 0.1 * _SURE * min(self._errors):
                break
        if best is None:
            raise InputError(
                Text(
                    "{scene}: no method comes to the end of {seconds:g} s",
                    scene=self._scene.name,
                    seconds=SECONDS,
                )
            )
        return best

    def _explore(self, method: str, right: Floats) -> Iterator[Tried]:
        """Try a method's settings until it is accurate enough or takes too long."""
        for value in self._settings(method):
            simulation = self._simulation(method, value)
            if simulation.plain:
                return
            seconds = _run(simulation, _PATIENCE)
            if seconds < _LONGEST:
                seconds = _run(simulation, _PATIENCE)  # the first run starts with cold caches
            error = _distance(simulation.positions, right) if seconds < math.inf else math.inf
            self._runs[method, value] = simulation
            yield Tried(method, value, error, seconds)
            if error <= min(self._errors) or (seconds > _LONGEST and seconds < math.inf):
                return

    def _settings(self, method: str) -> Iterator[float]:
        """Yield tolerances from the largest error down, by half decades; or steps a factor sqrt(2) apart."""
        if METHODS[method].adaptive:
            for half_decades in range(13):
                yield float(f"{max(self._errors) * 10.0 ** (-half_decades / 2):.2g}")
        else:
            for number in (0, *range(2, 23)):
                yield FRAME / round(2.0 ** (number / 2))

    def _simulation(self, method: str, value: float) -> Simulation:
        info = METHODS[method]
        integrator = Integrator(
            method=info.name,
            dt=FRAME if info.adaptive else value,
            tolerance=min(max(value, 1e-12), 1e3) if info.adaptive else Integrator().tolerance,
        )
        return Simulation(msgspec.structs.replace(self._scene, integrator=integrator), wait=self._wait)

    def _may_be_best(self, one: Tried, tried: list[Tried]) -> bool:
        """Return whether it is the cheapest of its method for one of the errors."""
        return any(
            one
            == min(
                (other for other in tried if other.method == one.method and other.error <= error),
                key=lambda other: other.seconds,
                default=None,
            )
            for error in self._errors
        )

    def _again(self, one: Tried) -> Tried:
        seconds = _run(self._runs[one.method, one.value], _PATIENCE)
        return one._replace(seconds=min(one.seconds, seconds))


def _run(simulation: Simulation, patience: float) -> float:
    """Run a body from its start; return the computing time, s, or infinity if it did not reach the end."""
    simulation.reset()
    left, seconds = round(SECONDS / simulation.dt), 0.0
    while left > 0:
        began = time.perf_counter()
        left -= simulation.step(min(left, _AT_ONCE), _AT_ONCE)
        seconds += time.perf_counter() - began
        if simulation.divergence is not None or seconds > patience:
            return math.inf
    return seconds


def _distance(one: Floats, other: Floats) -> float:
    """Return the largest distance between two positions of a mass, px."""
    return float(np.sqrt(((one - other) ** 2).sum(-1)).max())
