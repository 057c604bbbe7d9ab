"""The other bodies of a race, on the terrain of the session's body and on the same clock."""

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
from ...session.pacing import Costs
from .messages import Out

_ROUNDING = 1e-6
"""Part of a time step by which a step may be incomplete and still counts as whole."""


LIMIT = 30.0
"""Simulated seconds after which a race ends; the page says so, too."""

FALL = 2.0
"""Heights of the view by which a body has fallen out of the race."""


class Runner(NamedTuple):
    """One of the bodies of a race, the session's or a rival.

    Attributes:
        start: x and y of its centre of mass at the start, px.
        arrived: simulated seconds from the start to the finish; None before that.
        out: what has kept it from the finish; empty while nothing has.
    """

    start: tuple[float, float]
    arrived: float | None = None
    out: Out = ""

    @property
    def is_done(self) -> bool:
        """Whether the race is over for it."""
        return self.arrived is not None or bool(self.out)


class Lane(NamedTuple):
    """What a rival still has to do.

    Attributes:
        owed: simulated seconds by which it is behind the session's body.
        stopped: whether it is stepped no more.
    """

    owed: float = 0.0
    stopped: bool = False


class RivalsMoment(NamedTuple):
    """Rivals at a past moment; see `Rivals`."""

    moments: tuple[sim.Moment, ...]
    lanes: tuple[Lane, ...]
    seconds: float
    runners: tuple[Runner, ...]
    fair: bool


class Rivals(Companion):
    """The other bodies of a race.

    They never fall behind: a session waits for rivals that are late. Hands do not reach them.

    Args:
        simulation: the session's body.
        scenes: those of the others, which get the terrain of the first.
        finish: way from the start to the finish along x, px.
        wait: whether their steps may wait for the compiler.

    Attributes:
        scenes, finish: as above.
        seconds: simulated, since the start.
        runners: the session's body, and the others.
        fair: whether nobody has moved or changed the session's body between start and end.

    Raises:
        SceneError: one does not fit the terrain.
    """

    name, by_hand, in_step, drawn = "rival", False, True, True

    def __init__(
        self, simulation: sim.Simulation, scenes: Sequence[sim.Scene], finish: float, wait: bool = True
    ) -> None:
        self.scenes, self.finish = tuple(scenes), finish
        self._wait = wait
        terrain = simulation.scene
        super().__init__(tuple(sim.Simulation(on_terrain(scene, terrain), wait=wait) for scene in scenes))
        self._each = tuple(Costs() for _ in self.bodies)
        self.costs = self._each[0]
        self._start(simulation)

    def _start(self, simulation: sim.Simulation) -> None:
        self.seconds, self.fair = 0.0, True
        self._lanes = [Lane() for _ in self.bodies]
        self.runners = tuple(Runner(_middle(body)) for body in (simulation, *self.bodies))
        self._note(simulation)

    def _note(self, simulation: sim.Simulation) -> None:
        """Note where all bodies are before their next steps."""
        self._before = [body.capture() for body in (simulation, *self.bodies)]

    def ways(self, simulation: sim.Simulation) -> tuple[float, ...]:
        """Return how far the session's body and the others have come along x since the start, px."""
        bodies = (simulation, *self.bodies)
        return tuple(
            _middle(body)[0] - runner.start[0] for body, runner in zip(bodies, self.runners, strict=True)
        )

    @property
    def lines(self) -> tuple[float, ...]:
        """x of the finish of the session's body and of the others, px."""
        return tuple(runner.start[0] + self.finish for runner in self.runners)

    @property
    def is_over(self) -> bool:
        """Whether nothing can change the result any more."""
        return all(runner.is_done for runner in self.runners)

    @property
    def is_late(self) -> bool:
        """See `Companion`."""
        return any(
            not lane.stopped and lane.owed >= (1.0 - _ROUNDING) * body.dt
            for lane, body in zip(self._lanes, self.bodies, strict=True)
        )

    def touch(self) -> None:
        """See `Companion`."""
        self.fair = self.fair and self.is_over

    def begin(self, simulation: sim.Simulation) -> None:
        """Start again if the session's body is at its start; otherwise that was changed on the way."""
        misfits = []
        for i, (body, scene) in enumerate(zip(self.bodies, self.scenes, strict=True)):
            try:
                body.replace(on_terrain(scene, simulation.scene))
            except SceneError:
                misfits.append(i)
        if simulation.time == 0.0:
            for body in self.bodies:
                body.reset()
            self._start(simulation)
        else:
            self.touch()
            self._note(simulation)
        for i in misfits:
            self._lanes[i] = Lane(stopped=True)
            self._drop(i + 1, "misfit")

    def adapt(self, simulation: sim.Simulation) -> None:
        """See `begin`: the terrain may have changed."""
        self.begin(simulation)

    def capture(self) -> RivalsMoment:
        """See `Companion`."""
        moments = tuple(body.capture() for body in self.bodies)
        return RivalsMoment(moments, tuple(self._lanes), self.seconds, self.runners, self.fair)

    def go_back(self, past: Sequence[tuple[float, RivalsMoment]], simulation: sim.Simulation) -> None:
        """See `Companion`."""
        if not past:
            self.begin(simulation)
            return
        moments, lanes, self.seconds, self.runners, self.fair = past[-1][1]
        self._lanes = list(lanes)
        for body, moment in zip(self.bodies, moments, strict=True):
            body.restore(moment)
        self._note(simulation)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Advance by as much time as the session's body just has, and by what is still owed."""
        self.seconds += steps * simulation.dt
        self._watch(0, simulation, steps, self.seconds)
        began = time.perf_counter()
        for i, (body, costs) in enumerate(zip(self.bodies, self._each, strict=True)):
            if not self._lanes[i].stopped:
                self._move(i, body, costs, steps * simulation.dt, budget / len(self.bodies))
        self._count(time.perf_counter() - began)
        # Those of the slowest are what the session plans by.
        self.costs = max(self._each, key=lambda costs: costs.unit)
        if all(self.seconds - lane.owed >= LIMIT for lane in self._lanes):
            for i in range(len(self.runners)):
                self._drop(i, "late")

    def _move(self, i: int, body: sim.Simulation, costs: Costs, seconds: float, budget: float) -> None:
        """Advance one rival.

        Args:
            i: which of the `bodies`.
            body: the body.
            costs: what its steps cost.
            seconds: simulated ones that the session's body has just done.
            budget: seconds of computing that this may take.
        """
        owed = self._lanes[i].owed + seconds
        done = costs.move(body, math.floor(owed / body.dt + _ROUNDING), budget)
        owed -= done * body.dt
        self._watch(i + 1, body, done, self.seconds - owed)
        stopped = body.divergence is not None
        self._lanes[i] = Lane(0.0 if stopped else owed, stopped)

    def _watch(self, i: int, body: sim.Simulation, steps: int, seconds: float) -> None:
        """See whether one of all bodies has arrived, or never will.

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
            self._drop(i, "away")
        elif fallen >= FALL * (view.frame[3] - view.frame[1]):
            self._drop(i, "fell")

    def _drop(self, i: int, why: Out) -> None:
        """Take one of the bodies out of the race, unless it is done."""
        if not self.runners[i].is_done:
            self._set(i, self.runners[i]._replace(out=why))

    def _set(self, i: int, runner: Runner) -> None:
        self.runners = (*self.runners[:i], runner, *self.runners[i + 1 :])


def _middle(body: sim.Simulation) -> tuple[float, float]:
    """x and y of a body's centre of mass, px."""
    return center(body.scene, body.positions), center(body.scene, body.positions[:, ::-1])
