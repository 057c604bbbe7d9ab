"""The other body of a race, on the terrain of the session's body and on the same clock."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from typing import NamedTuple

import sim
from sim.edit.terrain import center, on_terrain
from sim.errors import SceneError

from ...session.companions import Companion

_ROUNDING = 1e-6
"""Part of a time step by which a step may be incomplete and still counts as whole."""


class RivalMoment(NamedTuple):
    """A rival at a past moment; see `Rival`."""

    moment: sim.Moment
    owed: float
    seconds: float
    starts: tuple[float, float]
    fair: bool
    out: str


class Rival(Companion):
    """The other body of a race.

    It never falls behind: a session waits for a rival that `is_late`. Hands do not reach it.

    Args:
        simulation: the session's body.
        scene: the other one's, which gets the terrain of the first.
        wait: whether its steps may wait for the compiler.

    Attributes:
        scene: as above.
        simulation: the other body.
        seconds: simulated, since the start.
        fair: whether nobody has moved or changed the session's body since then.
        out: why the other body is out of the race; empty while it is not.

    Raises:
        SceneError: it does not fit the terrain.
    """

    name, by_hand, in_step, drawn = "rival", False, True, True

    def __init__(self, simulation: sim.Simulation, scene: sim.Scene, wait: bool = True) -> None:
        self.scene = scene
        self.simulation = sim.Simulation(on_terrain(scene, simulation.scene), wait=wait)
        super().__init__((self.simulation,))
        self._start(simulation)

    def _start(self, simulation: sim.Simulation) -> None:
        self._owed = self.seconds = 0.0
        self.fair, self.out = True, ""
        self._starts = self._centers(simulation)

    def _centers(self, simulation: sim.Simulation) -> tuple[float, float]:
        one, other = (center(body.scene, body.positions) for body in (simulation, self.simulation))
        return one, other

    def ways(self, simulation: sim.Simulation) -> tuple[float, float]:
        """Return how far the session's body and the other one have come along x since the start, px."""
        (one, other), (a, b) = self._centers(simulation), self._starts
        return one - a, other - b

    @property
    def is_late(self) -> bool:
        """See `Companion`."""
        return not self.out and self._owed >= (1.0 - _ROUNDING) * self.simulation.dt

    def touch(self) -> None:
        """See `Companion`."""
        self.fair = False

    def begin(self, simulation: sim.Simulation) -> None:
        """Start again if the session's body is at its start; otherwise that was changed on the way."""
        trouble = ""
        try:
            self.simulation.replace(on_terrain(self.scene, simulation.scene))
        except SceneError as error:
            trouble = str(error)
        if simulation.time == 0.0:
            self.simulation.reset()
            self._start(simulation)
        else:
            self.fair = False
        self.out = trouble or self.out

    def adapt(self, simulation: sim.Simulation) -> None:
        """See `begin`: the terrain may have changed."""
        self.begin(simulation)

    def capture(self) -> RivalMoment:
        """See `Companion`."""
        moment = self.simulation.capture()
        return RivalMoment(moment, self._owed, self.seconds, self._starts, self.fair, self.out)

    def go_back(self, past: Sequence[tuple[float, RivalMoment]], simulation: sim.Simulation) -> None:
        """See `Companion`."""
        if not past:
            self.begin(simulation)
            return
        moment, self._owed, self.seconds, self._starts, self.fair, self.out = past[-1][1]
        self.simulation.restore(moment)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Advance by as much time as the session's body just has, and by what is still owed."""
        own = self.simulation
        self.seconds += steps * simulation.dt
        self._owed += steps * simulation.dt
        if self.out:
            self._owed = 0.0
            return
        began = time.perf_counter()
        done = self.costs.move(own, math.floor(self._owed / own.dt + _ROUNDING), budget)
        self._count(time.perf_counter() - began)
        self._owed -= done * own.dt
        if own.divergence is not None:
            self.out = "it exploded"
