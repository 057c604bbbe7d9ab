"""A second body beside the first: the same inputs, another method, time step or force law."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import NamedTuple

import msgspec
import numpy as np

import sim
from sim.methods.registry import METHODS
from sim.settings import CHOICES, SETTINGS, set_choice

from .companion import Companion

REFERENCE = "reference"
"""Instead of a method: `auto` at a tolerance at which it stands for the exact motion."""

REFERENCE_TOLERANCE = 1e-4
"""Of the reference, px."""

FINER: tuple[int, ...] = (1, 2, 4, 10)
"""How many times smaller a ghost's time step or tolerance may be: so both bodies have the same frames."""


class GhostMoment(NamedTuple):
    """A ghost at a moment that is past.

    Attributes:
        moment: where it was.
        owed: simulated seconds that it was late by then.
        worst: see `Ghost`.
    """

    moment: sim.Moment
    owed: float
    worst: float


class Ghost(Companion):
    """The second body of a session.

    It has the time that the first body leaves of a frame. Where that does not suffice it is late, and catches
    up later.

    Args:
        simulation: the first body, whose state it starts from.
        method: a name of `sim.methods.METHODS`, or REFERENCE.
        law: a force law, or "" for the scene's own.
        finer: how many times smaller than the first body's its time step is, or its tolerance where it has
            one; of no meaning to the reference.
        wait: whether its steps may wait for the compiler.

    Attributes:
        simulation: the body.
        distance: largest distance between a mass and its counterpart, px, when it was last not late.
        worst: the largest that it has been.
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
        """The first body's scene with this one's method and law, as far as it has a use for them."""
        if not CHOICES["method"].applies(scene):
            return scene  # every mass is held: there is nothing that a method could do differently
        if self.method == REFERENCE:
            scene = set_choice(scene, "method", "auto")
            tight = msgspec.structs.replace(scene.integrator, tolerance=REFERENCE_TOLERANCE)
            scene = msgspec.structs.replace(scene, integrator=tight)
        else:
            scene = set_choice(scene, "method", self.method)
            key = "tolerance" if METHODS[scene.integrator.method].adaptive else "dt"
            whole = getattr(scene.integrator, key)
            # A whole part of it, and not less than a scene may have.
            part = whole / max(min(self.finer, int(whole / SETTINGS[key].low)), 1)
            integrator = msgspec.structs.replace(scene.integrator, **{key: part})
            scene = msgspec.structs.replace(scene, integrator=integrator)
        if self.law and CHOICES["force_law"].applies(scene):
            scene = set_choice(scene, "force_law", self.law)
        return scene

    def adapt(self, simulation: sim.Simulation) -> None:
        """See `Companion`."""
        self.simulation.replace(self.variant(simulation.scene))  # with what keys have changed

    def begin(self, simulation: sim.Simulation) -> None:
        """Take the first body's settings, place, speed and time."""
        self.adapt(simulation)
        self._start(simulation)

    def _start(self, simulation: sim.Simulation) -> None:
        self.simulation.take_state(simulation)
        self._owed = self.distance = self.worst = 0.0

    def capture(self) -> GhostMoment | None:
        """Where it is now, to come back to; None while it `is_compiling`."""
        return None if self.is_compiling else GhostMoment(self.simulation.capture(), self._owed, self.worst)

    def go_back(self, past: Sequence[tuple[float, GhostMoment]], simulation: sim.Simulation) -> None:
        """Be where it was at the moment that the first body has gone to; if none is kept, begin with that."""
        if not past:
            self.begin(simulation)
            return
        then = past[-1][1]
        self.simulation.restore(then.moment)
        self._owed, self.worst = then.owed, then.worst
        self._compare(simulation)

    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Go on by as much time as the first body has just done, and measure how far apart they are."""
        own = self.simulation
        self._owed += steps * simulation.dt
        began = time.perf_counter()
        done = self.costs.move(own, int(self._owed / own.dt + 1e-6), budget)
        self._count(time.perf_counter() - began)
        self._owed -= done * own.dt
        if abs(self._owed) < 0.5 * own.dt:
            self._owed = 0.0  # but for rounding
        self._compare(simulation)

    def _compare(self, simulation: sim.Simulation) -> None:
        if self._owed:
            return  # where it was some time ago says nothing
        apart = np.hypot(*(simulation.positions - self.simulation.positions).T)
        self.distance = float(apart.max(initial=0.0))
        self.worst = max(self.worst, self.distance)

    @property
    def label(self) -> str:
        """What it is, for people."""
        if self.method == REFERENCE:
            parts = ["Reference"]
        else:
            parts = [CHOICES["method"].options[self.method]]
            if self.finer > 1:
                parts.append(f"{'tolerance' if METHODS[self.method].adaptive else 'step'} / {self.finer}")
        if self.law:
            parts.append(f"{CHOICES['force_law'].options[self.law].lower().removesuffix(' law')} law")
        return ", ".join(parts)
