"""A second body beside the first: the same inputs, another method, time step or force law."""

from __future__ import annotations

import time

import msgspec
import numpy as np

import sim
from sim.methods.registry import METHODS
from sim.settings import CHOICES, SETTINGS, set_choice

REFERENCE = "reference"
"""Instead of a method: `auto` at a tolerance at which it stands for the exact motion."""

REFERENCE_TOLERANCE = 1e-4
"""Of the reference, px."""

FINER: tuple[int, ...] = (1, 2, 4, 10)
"""How many times smaller a ghost's time step or tolerance may be: so both bodies have the same frames."""

ATTEMPTS = 2000
"""Steps that a ghost may try in a frame; it is not the one that the clock waits for."""


class Ghost:
    """The second body of a session.

    Args:
        scene: the first body's scene, as it is now.
        simulation: the first body, whose state it starts from.
        method: a name of `sim.methods.METHODS`, or REFERENCE.
        law: a force law, or "" for the scene's own.
        finer: how many times smaller than the first body's its time step is, or its tolerance where it has
            one; of no meaning to the reference.
        wait: whether its steps may wait for the compiler.

    Attributes:
        simulation: the body.
        cost: seconds of computing in the last frames, on average.
        distance: largest distance between a mass and its counterpart, px.
        worst: the largest that it has been.
    """

    def __init__(
        self, simulation: sim.Simulation, method: str, law: str, finer: int = 1, wait: bool = True
    ) -> None:
        self.method, self.law, self.finer = method, law, finer
        self.simulation = sim.Simulation(self.variant(simulation.scene), wait=wait)
        self.cost = 0.0
        self.distance = self.worst = 0.0
        self.start_from(simulation)

    def variant(self, scene: sim.Scene) -> sim.Scene:
        """The first body's scene with this one's method and law."""
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

    @property
    def waits(self) -> bool:
        """Whether its method is still being compiled; by NumPy, it would say nothing of that method."""
        return self.simulation.plain

    def is_ready(self, simulation: sim.Simulation) -> bool:
        """Whether it may go on; when its method has just become ready, it starts from the first body."""
        if not self.waits:
            return True
        if self.simulation.take_compiled():
            self.start_from(simulation)
        return False

    def start_from(self, simulation: sim.Simulation) -> None:
        """Take the first body's place, speed and time."""
        self.simulation.take_state(simulation)
        self.distance = self.worst = 0.0

    def step(self, steps: int, dt: float) -> None:
        """Go on by some time steps of the first body, each of dt, s."""
        began = time.perf_counter()
        self.simulation.step(steps * round(dt / self.simulation.dt), attempts=ATTEMPTS)
        self.cost += 0.1 * (time.perf_counter() - began - self.cost)

    def compare(self, simulation: sim.Simulation) -> None:
        """Measure the distance to the first body."""
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
