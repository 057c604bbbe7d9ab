"""The numbers of the arrows of forces, velocities and torques, sent only while arrows are shown."""

from __future__ import annotations

import math
from collections.abc import Set
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sim import Scene, Simulation

from ...session.session import Session
from ...stage.sketch import Floats
from ...wire.carrier import Mail
from . import messages as to_page

KINDS = ("forces", "velocities", "torques")

MAX_ARROWS = 240
"""Arrows of a kind, about: of more masses or joints, every second or third one has an arrow."""

MAX_HELD = 60
"""Held masses that have an arrow in any case."""

EVERY = 1.0 / 30.0
"""Seconds between two sets of numbers while the body moves; the page interpolates between them."""

MIN_CHANGE = 0.005
"""Change, as a fraction of the longest arrow, below which nothing is sent while the body moves."""


class Arrows:
    """The arrows of one page.

    Args:
        mail: to the page's script.
    """

    def __init__(self, mail: Mail) -> None:
        self._mail = mail
        self._sent: tuple[tuple[Any, ...], list[Floats]] | None = None
        self._due = 0.0
        self._least = -1, (0.0, 0.0, 0.0)  # of the plan with that number

    def draw(self, session: Session, kinds: Set[str], plan: int, now: float, exactly: bool) -> None:
        """Send the numbers of the present moment if they changed.

        Args:
            session: the simulation.
            kinds: which of KINDS are shown.
            plan: number of the plan of the body that the page has.
            now: wall time, s.
            exactly: whether to send even the negligible change, for a still picture.
        """
        if not kinds:
            self.clear()
            return
        if not exactly and now < self._due:
            return
        simulation = session.simulation
        held = {anchor.mass for anchor in simulation.anchors} | set(session.hands.masses)
        about = plan, frozenset(kinds), frozenset(held)
        numbers = _numbers(simulation, kinds)
        if self._least[0] != plan:
            self._least = plan, negligible(simulation.scene)
        least = self._least[1]
        if self._sent is not None and self._sent[0] == about:
            size = (0.0, 0.0, 0.0) if exactly else least
            if all(map(_is_similar, self._sent[1], numbers, size)):
                return
        self._sent = about, numbers
        self._due = now + EVERY - 1e-3
        encoded = encode(plan, simulation.time, least, sorted(held), numbers)
        self._mail.send(to_page.Arrows(numbers=encoded))

    def clear(self) -> None:
        """Remove the arrows from the page."""
        if self._sent is not None:
            self._sent = None
            self._mail.send(to_page.Arrows(numbers=np.zeros(0, np.float32)))


def _numbers(simulation: Simulation, kinds: Set[str]) -> list[Floats]:
    """(n, 2) forces and velocities, and (J,) torques; each is empty unless its kind is shown."""
    loads = simulation.loads if kinds & {"forces", "torques"} else None
    nothing = np.zeros(0)
    return [
        loads.forces if loads is not None and "forces" in kinds else nothing,
        simulation.velocities if "velocities" in kinds else nothing,
        loads.torques if loads is not None and "torques" in kinds else nothing,
    ]


def _is_similar(before: Floats, now: Floats, least: float) -> bool:
    """Whether the change is invisible; with `least` 0, whether there is none."""
    size = max(MIN_CHANGE * float(np.abs(before).max(initial=0.0)), 0.02 * least) if least else 0.0
    return before.shape == now.shape and bool(np.abs(now - before).max(initial=0.0) <= size)


def encode(
    plan: int, time: float, least: tuple[float, float, float], held: list[int], numbers: list[Floats]
) -> NDArray[np.float32]:
    """The array that arrows.js reads.

    Args:
        plan: number of the plan of the body.
        time: simulated time, s.
        least: force, speed and torque below which arrows stay shorter than the longest one may be.
        held: masses that an anchor or the hand holds.
        numbers: forces (n, 2), velocities (n, 2) and torques (J,); each may be empty.
    """
    masses = max(len(numbers[0]), len(numbers[1]))
    step, joint_step = _step(masses), _step(len(numbers[2]))
    held = held[:MAX_HELD]
    chosen = [*range(0, masses, step), *(mass for mass in held if mass % step)]
    forces, velocities = (part[chosen] if len(part) else part for part in numbers[:2])
    return to_page.Arrows.pack(
        head=(plan, time, step, joint_step),
        least=least,
        held=held,
        forces=forces,
        velocities=velocities,
        torques=numbers[2][::joint_step],
    )


def _step(count: int) -> int:
    """Return n such that every n-th of so many items is at most MAX_ARROWS items."""
    return -(-count // MAX_ARROWS) or 1


def negligible(scene: Scene) -> tuple[float, float, float]:
    """A negligible force, speed and torque in a scene: kg px/s², px/s, kg px²/s².

    Without them the noise of a body at rest would be drawn as large as the forces of one in motion.
    """
    frame = scene.view.frame
    pixel = max(frame[2] - frame[0], frame[3] - frame[1]) / 600.0
    weight = max(mass.mass for mass in scene.masses) * float(np.hypot(*scene.gravity))
    weight = max([weight, *(math.hypot(*mass.force) for mass in scene.masses if mass.force)])
    stiffest = max((spring.stiffness for spring in scene.linear_springs), default=0.0)
    force = max(0.02 * weight, 1e-4 * pixel * stiffest)
    torque = 0.0
    for joint in scene.angular_springs:
        sides = scene.linear_springs[joint.a].rest_length * scene.linear_springs[joint.b].rest_length
        torque = max(torque, 1e-3 * joint.stiffness * sides)
    return max(force, 1e-9), max(20.0 * pixel, 1e-9), max(torque, 1e-9)
