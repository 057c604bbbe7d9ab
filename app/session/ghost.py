"""The ghost: a second body with the same inputs, and another method, time step or force law."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import NamedTuple

import msgspec
import numpy as np

import sim
from sim.settings import CHOICES, SETTINGS, set_choice
from sim.solve.registry import METHODS

from .companions import Companion

REFERENCE = "reference"
"""In place of a method: `auto` at a tolerance so tight that it stands for the exact motion."""

REFERENCE_TOLERANCE = 1e-4
"""Of the reference, px."""

FINER: tuple[int, ...] = (1, 2, 4, 10)
"""Factors by which its time step or tolerance may be smaller: integers, so that frames coincide."""


class GhostMoment(NamedTuple):
    """A ghost at a past moment.

    Attributes:
        moment: its state.
        owed: simulated seconds that it was behind.
        worst: see `Ghost`.
    """

    moment: sim.Moment
    owed: float
    worst: float


class Ghost(Companion):
    """A session's second body, for comparison.

    It is stepped in what time the first body leaves of a frame. If there is not enough it lags, and catches
    up later.

    Args:
        simulation: the first body, whose state it starts from.
        method: a name of `sim.solve.registry.METHODS`, or REFERENCE.
        law: a force law, or "" for the scene's own.
        finer: factor by which its time step, or its tolerance if it has one, is smaller than the first
            body's; ignored by the reference.
        wait: whether its steps may wait for the compiler.

    Attributes:
        simulation: the body.
        distance: largest distance between a mass and its counterpart, px, when it last did not lag.
        worst: largest `distance` so far.
    """

    name = "ghost"

    def __init__(
        self, simulation: sim.Simulation, method: str, law: str, finer: int = 1, wait: bool = True
    ) -> None:
        self.method, self.law, self.finer = method, law, finer
        self.simulation = sim.Simulation(self.variant(simulation.scene), wait=wait)
        super().__init__((self.simulation,))
        self._start(simulation)

    def variant(self, scene: sim.Scene) -> sim.Scene:
        """The first body's scene with this one's method and law, as far as they apply to it."""
        if not CHOICES["method"].applies(scene):
            return scene  # every mass is held, so methods cannot differ
        if self.method == REFERENCE:
            scene = set_choice(scene, "method", "auto")
            tight = msgspec.structs.replace(scene.integrator, tolerance=REFERENCE_TOLERANCE)
            scene = msgspec.structs.replace(scene, integrator=tight)
        else:
            scene = set_choice(scene, "method", self.method)
            key = "tolerance" if METHODS[scene.integrator.method].adaptive else "dt"
            whole = getattr(scene.integrator, key)
            # An integer fraction, within the range of the setting.
            part = whole / max(min(self.finer, int(whole / SETTINGS[key].low)), 1)
            integrator = msgspec.structs.replace(scene.integrator, **{key: part})
            scene = msgspec.structs.replace(scene, integrator=integrator)
        if self.law and CHOICES["force_law"].applies(scene):
            scene = set_choice(scene, "force_law", self.law)
        return scene

    def adapt(self, simulation: sim.Simulation) -> None:
        self.simulation.replace(self.variant(simulation.scene))  # including the effect of the arrow keys

    def begin(self, simulation: sim.Simulation) -> None:
        self.adapt(simulation)
        self._start(simulation)

    def _start(self, simulation: sim.Simulation) -> None:
        self.simulation.take_state(simulation)
        self._owed = self.distance = self.worst = 0.0

    def capture(self) -> GhostMoment | None:
        return None if self.is_compiling else GhostMoment(self.simulation.capture(), self._owed, self.worst)

    def go_back(self, past: Sequence[tuple[float, GhostMoment]], simulation: sim.Simulation) -> None:
        if not past:
            self.begin(simulation)
            return
        then = past[-1][1]
        self.simulation.restore(then.moment)
        self._owed, self.worst = then.owed, then.worst
        self._compare(simulation)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Catch up with the first body, and measure how far apart they are."""
        own = self.simulation
        self._owed += steps * simulation.dt
        began = time.perf_counter()
        done = self.costs.move(own, int(self._owed / own.dt + 1e-6), budget)
        self._count(time.perf_counter() - began)
        self._owed -= done * own.dt
        if abs(self._owed) < 0.5 * own.dt:
            self._owed = 0.0  # what is left is rounding
        self._compare(simulation)

    def _compare(self, simulation: sim.Simulation) -> None:
        if self._owed:
            return  # the two are at different times
        apart = np.hypot(*(simulation.positions - self.simulation.positions).T)
        self.distance = float(apart.max(initial=0.0))
        self.worst = max(self.worst, self.distance)
