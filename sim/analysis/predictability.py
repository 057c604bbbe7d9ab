"""Growth of small errors in a motion, and whether any tolerance can therefore predict where a body will be.

Two near-exact bodies start where the body is, one of them slightly perturbed. After some time they restart
from the body's current state, keeping the direction of their separation but rescaling it to its initial size.
The logarithm of the total growth of the separation, divided by time, estimates the largest Lyapunov exponent
(Benettin, Galgani & Strelcyn, *Kolmogorov entropy and numerical experiments*, Physical Review A 14, 1976).

The body's own method is unsuitable for the two bodies. With an adaptive method, the perturbation leads to
slightly different step lengths, whose errors soon outgrow it. The two bodies therefore have a much finer
tolerance, and the perturbation is large compared with it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..motion.divergence import Divergence
from ..motion.simulation import Simulation
from ..scene.types import Scene
from ..solve.registry import METHODS
from ..text import Text

# Unless noted, doubling or halving one of these numbers fails no test.
MANY = 100.0
"""Growth of errors per second from which a tolerance may not be met: for random bodies, `auto` meets all
tolerances where errors grow less; see the study in docs."""

STILL = 1.5
"""Growth of errors per second below which they are said not to grow."""

_PERTURBATION, _TOLERANCE = 1e-4, 5e-6
"""Size of the perturbation and tolerance of the two bodies, relative to a typical spring length."""
_LEAST, _MOST = 0.1, 30.0
"""Range of separations, relative to the perturbation, outside which the two bodies restart."""
_LONGEST = 0.25
"""Time, s, after which they restart in any case."""
_MIN_PER_CALL = 1e-3
"""Smallest factor by which a separation can change in a call; smaller ones may be rounding."""

_SWING = 0.5
"""Length of the window, s, whose largest separation counts, since a separation may pass through zero."""
_SAMPLE = 1.0 / 60.0
"""Time between two samples, s."""
_LONGEST_RUN = 1e4
"""Longest simulated duration that `predictability` accepts, s."""
_MASS_STEPS = 20_000_000
"""Default number of steps that `predictability` may try, times the number of masses."""


class TwinTrajectory:
    """Two near-exact bodies beside a body, and the growth of their separation.

    Args:
        body: the body; it is only read.
        wait: whether steps of the two bodies may wait until their kernels are compiled.

    Attributes:
        pair: the two bodies. Whatever drives masses of the body, or presses keys, must do the same for them.
        hair: (4, n) their current separation: x and y, px, and vx and vy, px/s.
        level: natural logarithm of the factor by which their separation has grown since the start.
    """

    def __init__(self, body: Simulation, wait: bool = True) -> None:
        self._of = body.scene
        self.pair = tuple(Simulation(_near_exact(body.scene), wait=wait) for _ in range(2))
        self.hair = np.zeros((4, 0))
        self.level = 0.0
        self.place(body)

    def place(self, body: Simulation, hair: NDArray[np.float64] | None = None) -> None:
        """Restart both from the body's current state.

        Args:
            body: as for the constructor; its settings, and even its masses, may have changed.
            hair: direction of the second body's perturbation; None for the present one.
        """
        if body.scene is not self._of:
            self._of = body.scene
            for one in self.pair:
                one.replace(_near_exact(self._of))
        hair = self.hair if hair is None else hair
        if hair.shape[1] != len(self._of.masses) or not hair[:2].any():
            hair = np.random.default_rng(1).normal(size=(4, len(self._of.masses)))
        for one, shift in zip(self.pair, (None, hair * (hair_of(self._of) / _farthest(hair))), strict=True):
            one.take_state(body, shift)
        self._measure()
        self._since = 0.0

    def step(self, steps: int, attempts: int | None = None) -> bool:
        """Advance both by some time steps and measure their separation.

        Args:
            steps: time steps of the body.
            attempts: steps that a method may try, for each of the two.

        Returns:
            Whether both have completed all steps. If not, they must be placed anew.
        """
        if any(one.step(steps, attempts) < steps for one in self.pair):
            return False
        before = self._far
        self._measure()
        self._since += steps * self.pair[0].dt
        if before > 0.0:
            self.level += math.log(max(self._far / before, _MIN_PER_CALL))
        return True

    @property
    def due(self) -> bool:
        """Whether they should restart from the body's current state."""
        return self._since >= _LONGEST or not _LEAST < self._far / hair_of(self._of) < _MOST

    @property
    def held(self) -> bool:
        """Whether no mass is free, so that nothing can separate."""
        return self._far == 0.0

    def _measure(self) -> None:
        near, far = self.pair
        self.hair = np.concatenate((far.positions - near.positions, far.velocities - near.velocities), 1).T
        self._far = float(np.hypot(*self.hair[:2]).max())


@dataclass(frozen=True, eq=False)
class Predictability:
    """The growth of small errors in a motion.

    Attributes:
        times: (k,) s from the start.
        growth: (k,) natural logarithm of the factor by which the separation of two bodies, initially a small
            perturbation, has grown by then.
        rate: 1/s, slope of the growth after the first quarter of the time: the finite-time largest Lyapunov
            exponent.
        verdict: the consequence for the scene's tolerance or time step, in words.
        divergence: why the body stopped, or None.
        complete: whether the run covers its duration or ended because the body stopped. If not, its attempts
            were used up, and the verdict says so.
    """

    times: NDArray[np.float64]
    growth: NDArray[np.float64]
    rate: float
    verdict: str
    divergence: Divergence | None = None
    complete: bool = True

    def stopped(self, attempts: int, duration: float) -> Predictability:
        """Return a copy for a run that used up its attempts before its duration, s."""
        until = float(self.times[-1])
        if until > 0.0:
            known = Text("until {until:.3g} s, {verdict}", until=until, verdict=self.verdict)
        else:
            known = Text("how fast errors grow is not known")
        said = Text(
            "{known}; the {attempts} steps that it may try were used up before {duration:g} s",
            known=known,
            attempts=attempts,
            duration=duration,
        )
        return replace(self, verdict=said, complete=False)

    @property
    def per_second(self) -> float:
        """The factor by which errors grow per second, exp(`rate`)."""
        return factor_of(self.rate)

    @property
    def e_folding(self) -> float:
        """The time in which errors grow e-fold, s; infinite where they do not grow."""
        return 1.0 / self.rate if self.rate > 0.0 else math.inf


def predictability(scene: Scene, duration: float, attempts: int | None = None) -> Predictability:
    """Run a scene and measure how fast small errors grow in its motion.

    This takes about ten times as long as the run itself, and longer for violent motion, since two bodies are
    computed nearly exactly. It ends early if the allowed number of steps is used up, and the verdict then
    says so. Held masses stay where the scene has them, or move on their circles.

    Args:
        scene: a valid scene.
        duration: simulated time, up to 1e4 s; at least a second is most informative.
        attempts: steps that the body and its two companions may try together, at least 1; None for twenty
            million divided by the number of masses, which takes about ten seconds.

    Raises:
        SceneError: the scene is not valid.
        InputError: the duration or the attempts are not in their range, or every mass of the scene is held.
    """
    if not 0.0 < duration <= _LONGEST_RUN:
        raise InputError(
            Text(
                "{where}: a duration of {duration:g} s is not in the range 0..{most:g} s",
                where="predictability",
                duration=duration,
                most=_LONGEST_RUN,
            )
        )
    if attempts is None:
        attempts = max(1, _MASS_STEPS // max(1, len(scene.masses)))
    if isinstance(attempts, bool) or not isinstance(attempts, int) or attempts < 1:
        raise InputError(
            Text(
                "{where}: attempts is {attempts}, but must be a whole number from 1",
                where="predictability",
                attempts=attempts,
            )
        )
    body = Simulation(scene)
    meter = GrowthMeter(body)
    if meter.held:
        raise InputError(Text("{where}: every mass of the scene is held", where="predictability"))
    steps, sample = max(1, round(duration / body.dt)), max(1, round(_SAMPLE / body.dt))
    left = attempts
    while body.step_count < steps and body.divergence is None and left > 0:
        body.step(min(sample, steps - body.step_count), left)
        left -= _tried(body)
        if left > 0:
            left -= meter.look(body, left)
    found = meter.result(body)
    seen = left > 0 or found.times[-1] == body.time
    if body.divergence is not None or (body.step_count >= steps and seen):
        return found
    return found.stopped(attempts, duration)


class GrowthMeter:
    """Measures how fast errors grow in a motion, one interval at a time.

    Args:
        body: the body at the start; it is only read.
    """

    def __init__(self, body: Simulation) -> None:
        self._shadow = TwinTrajectory(body)
        self._steps = body.step_count
        self._times, self._levels = [body.time], [0.0]

    @property
    def held(self) -> bool:
        """Whether no mass is free, so that there is nothing to measure."""
        return self._shadow.held

    def look(self, body: Simulation, attempts: int | None = None) -> int:
        """Advance by what the body has done since the last call, ignoring whatever guides or drives it.

        Args:
            body: the body.
            attempts: steps that each of the two may try; None for no limit.

        Returns:
            The number of steps that both have tried.
        """
        steps, self._steps = body.step_count - self._steps, body.step_count
        arrived = steps > 0 and self._shadow.step(steps, attempts)
        if arrived:
            self._times.append(body.time)
            self._levels.append(self._shadow.level)
        if not arrived or self._shadow.due:
            self._shadow.place(body)
        return sum(map(_tried, self._shadow.pair))

    def result(self, body: Simulation) -> Predictability:
        """Return the result so far."""
        times, levels = np.array(self._times), np.array(self._levels)
        rate = _slope(times, levels)
        return Predictability(times, levels, rate, verdict(body.scene, factor_of(rate)), body.divergence)


def _tried(simulation: Simulation) -> int:
    """Return the number of steps a simulation has tried since the last call, see `SolverStats.work`."""
    return simulation.stats().work


def growth_within(times: Sequence[float], levels: Sequence[float], span: float) -> float | None:
    """Return the growth of the logarithm of the separation in the last `span` seconds; None if unknown.

    Args:
        times: ascending, s.
        levels: see `TwinTrajectory`.
        span: s.
    """
    if not times or times[-1] - times[0] < span:
        return None
    now, then = times[-1], times[-1] - span
    last = max(level for time, level in zip(times, levels, strict=True) if time >= now - _SWING)
    first = [level for time, level in zip(times, levels, strict=True) if then - _SWING <= time <= then]
    return last - max(first, default=levels[0])


def factor_of(level: float) -> float:
    """Return exp(level), limited to avoid overflow."""
    return math.exp(min(level, 700.0))


def hair_of(scene: Scene) -> float:
    """Return the initial separation of the two bodies beside one of a scene, px."""
    return _PERTURBATION * _typical_length(scene)


def horizon(scene: Scene, per_second: float) -> float:
    """Return the time, s, in which the rounding of a coordinate grows to the tolerance; infinite if errors do
    not grow.

    Args:
        scene: the scene, with its tolerance.
        per_second: the factor by which errors grow per second.
    """
    if per_second <= 1.0:
        return math.inf
    rounding = math.ulp(max(abs(c) for mass in scene.masses for c in (*mass.position, 1e-3)))
    return max(0.0, math.log(scene.integrator.tolerance / rounding)) / math.log(per_second)


def verdict(scene: Scene, per_second: float) -> str:
    """Describe the consequence of a growth of errors for a scene's tolerance or time step.

    Args:
        scene: the scene, with its method, tolerance and unit.
        per_second: the factor by which errors grow per second.
    """
    integrator = scene.integrator
    adaptive = METHODS[integrator.method].adaptive
    if per_second < STILL:
        grow = Text("errors do not grow")
    else:
        grow = Text("errors grow × {factor:.2g} in a second", factor=per_second)
    if per_second >= MANY:
        seconds = horizon(scene, per_second)
        if adaptive:
            return Text(
                "{grow}: no tolerance can promise where it is in {seconds:.2g} s", grow=grow, seconds=seconds
            )
        return Text(
            "{grow}: no time step can promise where it is in {seconds:.2g} s", grow=grow, seconds=seconds
        )
    if adaptive:
        return Text(
            "{grow}: a tolerance of {tolerance:g} {unit} is kept",
            grow=grow,
            tolerance=integrator.tolerance,
            unit=scene.view.unit,
        )
    return Text("{grow}: a shorter time step makes them smaller", grow=grow)


def _typical_length(scene: Scene) -> float:
    """Return the median rest length of a scene's springs, px, or the scene's size if there is none."""
    lengths = [spring.rest_length for spring in scene.linear_springs if spring.rest_length > 0.0]
    if lengths:
        return float(np.median(lengths))
    return float(np.ptp([mass.position for mass in scene.masses], axis=0).max()) or 1.0


def _near_exact(scene: Scene) -> Scene:
    """Return the scene with the method and tolerance of the two bodies."""
    tolerance = max(1e-12, _TOLERANCE * _typical_length(scene))
    integrator = msgspec.structs.replace(scene.integrator, method="auto", tolerance=tolerance)
    return msgspec.structs.replace(scene, integrator=integrator)


def _farthest(hair: NDArray[np.float64]) -> float:
    """Return the largest distance of a mass in (4, n) differences, px; positive."""
    return max(float(np.hypot(*hair[:2]).max()), 1e-300)


def _slope(times: NDArray[np.float64], levels: NDArray[np.float64]) -> float:
    """Return the slope of the largest levels within each `_SWING`, after a quarter of the time, 1/s."""
    first = np.searchsorted(times, times - _SWING)
    largest = np.array([levels[i : k + 1].max() for k, i in enumerate(first)])
    late = times >= 0.25 * times[-1]
    t, level = times[late] - times[late].mean(), largest[late]
    spread = float((t * t).sum())
    return float((t * (level - level.mean())).sum()) / spread if spread > 0.0 else 0.0
