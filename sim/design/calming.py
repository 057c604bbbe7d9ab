"""The damping with which a body at rest calms down in a given time."""

from __future__ import annotations

import math

import numpy as np

from ..analysis.decay import COUPLED, TENTH, Decay
from ..analysis.vibrations import Vibrations
from ..scene.columns import column
from ..settings import SETTINGS
from .sensitivity import AtRest, Floats

# Doubling or halving one of these numbers fails no test.
_NEAR = 2e-4
"""Logarithm of the reached over the wanted time below which the body's own damping is left as it is."""
_WAYS = 12
"""Number of dampings sampled, from none to critical, before one is found exactly."""


class Calming:
    """Finds the damping that calms the elastic vibration of a body at rest.

    Args:
        rest: the body, which must have one.
    """

    def __init__(self, rest: AtRest) -> None:
        assert rest.elastic is not None
        dampers, frequencies = rest.dampers, rest.found.omega
        near = np.sort(np.argsort(np.abs(frequencies - frequencies[rest.elastic]))[:COUPLED])
        some = Vibrations(frequencies[near], rest.found.shapes[near])
        self._elastic = int(np.searchsorted(near, rest.elastic))
        self._decay = Decay(dampers, some, column(rest.scene.masses, "mass"))
        own = dampers.numbers
        self._own = [float(each.max(initial=0.0)) for each in (own.damping, own.joint_damping)]
        units = [
            each / most if most else np.ones_like(each)
            for each, most in zip((own.damping, own.joint_damping), self._own, strict=True)
        ]
        self._around = self._decay.between()
        self._kinds = [
            self._decay.between(springs=units[0]) - self._around,
            self._decay.between(joints=units[1]) - self._around,
        ]
        omega = float(some.omega[self._elastic])
        hold = dampers.hold(omega, some.shapes[self._elastic])
        self._carrier = int(hold.joints > hold.springs)

    def calmed(self, after: float) -> tuple[float, float, float]:
        """Return the damping of springs and of joints, kg/s, with which its amplitude falls to a tenth in a
        given time, or as nearly as possible; and the time that it then takes.

        Either all damping is lowered, or that of springs or joints is raised, whichever contribute more to
        the vibration's stiffness: as little as necessary, and at most to where the vibration by itself would
        be critically damped.
        """
        from scipy.optimize import minimize_scalar, root_scalar

        own, e = np.array(self._own), self._elastic
        each = np.array([kind[e, e] for kind in self._kinds])
        left = 2.0 * float(self._decay.omega[e]) - float(self._around[e, e]) - float(own @ each)
        most = own.copy()
        if left > 0.0 and each[self._carrier] > 0.0:
            most[self._carrier] += left / each[self._carrier]
            most = np.minimum(most, SETTINGS["linear_damping"].high)

        def damping(way: float) -> Floats:
            """Return the damping at -1: none; 0: its own; 1: the most."""
            return (1.0 + way) * own if way < 0.0 else own + way**3 * (most - own)

        def off(way: float) -> float:
            return math.log(min(self._time(damping(way)), 1e300) / after)

        here = off(0.0)
        if abs(here) <= _NEAR:
            return self._own[0], self._own[1], self._time(own)
        lower = np.linspace(0.0, -1.0, _WAYS) if own.any() else np.zeros(1)
        higher = np.linspace(0.0, 1.0, _WAYS) if (most > own).any() else np.zeros(1)
        found = 0.0
        # To calm the body sooner, more damping is tried first; a body that its damping holds together calms
        # sooner with less.
        for ways in (higher, lower) if here > 0.0 else (lower, higher):
            values = np.array([off(way) for way in ways.tolist()])
            crossed = np.flatnonzero(np.sign(values[1:]) != np.sign(values[0]))
            if crossed.size:
                bracket = ways[crossed[0]], ways[crossed[0] + 1]
                found = float(root_scalar(off, bracket=bracket, method="brentq", xtol=1e-12).root)
                break
            best = int(np.argmin(np.abs(values)))
            if 0 < best < ways.size - 1:
                ends = sorted((ways[best - 1], ways[best + 1]))
                near = minimize_scalar(lambda way: abs(off(way)), bounds=ends, method="bounded")
                best_way = float(near.x)  # pyright: ignore
            else:
                best_way = float(ways[best])
            if abs(off(best_way)) < abs(off(found)):
                found = best_way
        springs, joints = damping(found).tolist()
        return springs, joints, self._time(damping(found))

    def _time(self, damping: Floats) -> float:
        """Return the time to a tenth of the amplitude, s; infinite without damping."""
        c = self._around + damping[0] * self._kinds[0] + damping[1] * self._kinds[1]
        rate = self._decay.rate(c, self._elastic)
        return TENTH / rate if rate > 1e-300 else math.inf
