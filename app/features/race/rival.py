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
from ...session.finish import arrival

_ROUNDING = 1e-6
"""Part of a time step by which a step may be incomplete and still counts as whole."""


LIMIT = 30.0
"""Simulated seconds after which a race ends."""

FALL = 2.0
"""Heights of the view by which a body has fallen out of the race."""


class Runner(NamedTuple):
    """One of the bodies of a race, the session's or the rival's.

    Attributes:
        start: x and y of its centre of mass at the start, px.
        arrived: simulated seconds from the start to the finish; None before that.
        out: what has kept it from the finish, such as "exploded"; empty while nothing has.
    """

    start: tuple[float, float]
    arrived: float | None = None
    out: str = ""

    @property
    def is_done(self) -> bool:
        """Whether the race is over for it."""
        return self.arrived is not None or bool(self.out)


class RivalMoment(NamedTuple):
    """A rival at a past moment; see `Rival`."""

    moment: sim.Moment
    owed: float
    seconds: float
    runners: tuple[Runner, Runner]
    fair: bool
    stopped: bool


class Rival(Companion):
    """The other body of a race.

    It never falls behind: a session waits for a rival that `is_late`. Hands do not reach it.

    Args:
        simulation: the session's body.
        scene: the other one's, which gets the terrain of the first.
        finish: way from the start to the finish along x, px.
        wait: whether its steps may wait for the compiler.

    Attributes:
        scene, finish: as above.
        simulation: the other body.
        seconds: simulated, since the start.
        runners: the session's body, and the other one.
        fair: whether nobody has moved or changed the session's body between start and end.

    Raises:
        SceneError: it does not fit the terrain.
    """

    name, by_hand, in_step, drawn = "rival", False, True, True

    def __init__(
        self, simulation: sim.Simulation, scene: sim.Scene, finish: float, wait: bool = True
    ) -> None:
        self.scene, self.finish = scene, finish
        self.simulation = sim.Simulation(on_terrain(scene, simulation.scene), wait=wait)
        self._wait = wait
        super().__init__((self.simulation,))
        self._start(simulation)

    def _start(self, simulation: sim.Simulation) -> None:
        self._owed = self.seconds = 0.0
        self.fair, self._stopped = True, False
        one, other = (Runner(_middle(body)) for body in (simulation, self.simulation))
        self.runners = one, other
        self._note(simulation)

    def _note(self, simulation: sim.Simulation) -> None:
        """Note where both bodies are before their next steps."""
        self._before = [simulation.capture(), self.simulation.capture()]

    def ways(self, simulation: sim.Simulation) -> tuple[float, float]:
        """Return how far the session's body and the other one have come along x since the start, px."""
        one, other = (
            _middle(body)[0] - runner.start[0]
            for body, runner in zip((simulation, self.simulation), self.runners, strict=True)
        )
        return one, other

    @property
    def lines(self) -> tuple[float, float]:
        """x of the finish of the session's body and of the other one, px."""
        one, other = (runner.start[0] + self.finish for runner in self.runners)
        return one, other

    @property
    def is_over(self) -> bool:
        """Whether nothing can change the result any more."""
        return all(runner.is_done for runner in self.runners)

    @property
    def is_late(self) -> bool:
        """See `Companion`."""
        return not self._stopped and self._owed >= (1.0 - _ROUNDING) * self.simulation.dt

    def touch(self) -> None:
        """See `Companion`."""
        self.fair = self.fair and self.is_over

    def begin(self, simulation: sim.Simulation) -> None:
        """Start again if the session's body is at its start; otherwise that was changed on the way."""
        fits = True
        try:
            self.simulation.replace(on_terrain(self.scene, simulation.scene))
        except SceneError:
            fits = False
        if simulation.time == 0.0:
            self.simulation.reset()
            self._start(simulation)
        else:
            self.touch()
            self._note(simulation)
        if not fits:
            self._stopped = True
            self._drop(1, "does not fit this terrain")

    def adapt(self, simulation: sim.Simulation) -> None:
        """See `begin`: the terrain may have changed."""
        self.begin(simulation)

    def capture(self) -> RivalMoment:
        """See `Companion`."""
        moment = self.simulation.capture()
        return RivalMoment(moment, self._owed, self.seconds, self.runners, self.fair, self._stopped)

    def go_back(self, past: Sequence[tuple[float, RivalMoment]], simulation: sim.Simulation) -> None:
        """See `Companion`."""
        if not past:
            self.begin(simulation)
            return
        moment, self._owed, self.seconds, self.runners, self.fair, self._stopped = past[-1][1]
        self.simulation.restore(moment)
        self._note(simulation)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Advance by as much time as the session's body just has, and by what is still owed."""
        own = self.simulation
        self.seconds += steps * simulation.dt
        self._owed += steps * simulation.dt
        self._watch(0, simulation, steps, self.seconds)
        if self._stopped:
            self._owed = 0.0
        else:
            began = time.perf_counter()
            done = self.costs.move(own, math.floor(self._owed / own.dt + _ROUNDING), budget)
            self._count(time.perf_counter() - began)
            self._owed -= done * own.dt
            self._watch(1, own, done, self.seconds - self._owed)
            self._stopped = own.divergence is not None
        if self.seconds - self._owed >= LIMIT:
            for i in range(2):
                self._drop(i, f"needed more than {LIMIT:g} s")

    def _watch(self, i: int, body: sim.Simulation, steps: int, seconds: float) -> None:
        """See whether one of the bodies has arrived, or never will.

        Args:
            i: which of the `runners`.
            body: the body.
            steps: time steps that it has just done.
            seconds: simulated, since the start.
        """
        before, runner = self._before[i], self.runners[i]
        if runner.is_done:
            return
        if body.divergence is not None:
            self._drop(i, "exploded")
            return
        self._before[i] = body.capture()
        (x, y), (start, height), view = _middle(body), runner.start, body.scene.view
        way = (x - start) * math.copysign(1.0, self.finish)
        fallen = (y - height) * (1.0 if view.y_down else -1.0)
        if way >= abs(self.finish):
            after = arrival(before, steps, self.lines[i], self._wait)
            late = 0.0 if after is None else steps * body.dt - after
            self._set(i, runner._replace(arrived=seconds - late))
        elif way <= -abs(self.finish):
            self._drop(i, "went the other way")
        elif fallen >= FALL * (view.frame[3] - view.frame[1]):
            self._drop(i, "fell")

    def _drop(self, i: int, why: str) -> None:
        """Take one of the bodies out of the race, unless it is done."""
        if not self.runners[i].is_done:
            self._set(i, self.runners[i]._replace(out=why))

    def _set(self, i: int, runner: Runner) -> None:
        one, other = self.runners
        self.runners = (runner, other) if i == 0 else (one, runner)


def _middle(body: sim.Simulation) -> tuple[float, float]:
    """x and y of a body's centre of mass, px."""
    return center(body.scene, body.positions), center(body.scene, body.positions[:, ::-1])
