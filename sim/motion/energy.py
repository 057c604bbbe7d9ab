"""The energy of a body, and the books of what has changed it."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..body.system import System
from ..kernels.core.tables import (
    WORK_AIR,
    WORK_ANCHORS,
    WORK_DAMPING,
    WORK_FALLBACK,
    WORK_KEYS,
    WORK_LAW,
    State,
)
from ..kernels.energy.energies import energies
from ..scene.types import Scene
from .solver import Solver


@dataclass(frozen=True)
class EnergyBook:
    """Energies and what has changed their sum since the book was opened, in kg px²/s².

    Attributes:
        kinetic, linear, angular, gravity: of the free masses, the linear springs and the angular springs,
            and that of height, from height 0. Under the force law "tutorial" the angular energy is that of
            the conservative law.
        anchors: work done on the body by held masses that are moved. A hand that takes hold of a mass takes
            its kinetic energy and that of its height, and gives that of its height then in letting go.
        damping, air: what the springs' damping and the air have added, so negative.
        law: work done by a force law that is the gradient of no energy.
        keys: work done by keys that change rest lengths and angles.
        changes: what changes of settings have added at once.
        fallbacks: what fallback steps have added; negative or zero.
        residual: the sum of the energies, less what it was at first and all of the above. It is what the
            method gets wrong, and shrinks with the step at the method's order.
    """

    kinetic: float
    linear: float
    angular: float
    gravity: float
    anchors: float
    damping: float
    air: float
    law: float
    keys: float
    changes: float
    fallbacks: float
    residual: float

    @property
    def total(self) -> float:
        """The sum of the four energies."""
        return self.kinetic + self.linear + self.angular + self.gravity


ENERGY_FIELDS = tuple(field.name for field in fields(EnergyBook))


class Books:
    """Keeps the books of a simulation; made only where someone wants to read them.

    Args:
        scene, system, state, solver: of the simulation.
    """

    def __init__(self, scene: Scene, system: System, state: State, solver: Solver) -> None:
        self._scene, self._system, self._state = scene, system, state
        self._solver = solver
        self._solver.open_balance()
        self._changes = 0.0
        self._four = np.zeros(4)
        self._start = self.total()

    def read(self) -> EnergyBook:
        """The books as they are now."""
        total = self.total()
        kinetic, linear, angular, gravity = (float(e) for e in self._four)
        work = self._solver.balance.work
        return EnergyBook(
            kinetic,
            linear,
            angular,
            gravity,
            anchors=float(work[WORK_ANCHORS]),
            damping=float(work[WORK_DAMPING]),
            air=float(work[WORK_AIR]),
            law=float(work[WORK_LAW]),
            keys=float(work[WORK_KEYS]),
            changes=self._changes,
            fallbacks=float(work[WORK_FALLBACK]),
            residual=total - self._start - float(work.sum()) - self._changes,
        )

    def total(self) -> float:
        """The sum of the energies of the state in `state`."""
        state, gravity = self._state, self._scene.gravity
        mass = self._solver.balance.mass
        energies(self._system.body, state, mass, *gravity, state.q, state.v, self._four)
        return float(self._four.sum())

    def moved(self, before: float) -> None:
        """Held masses were put elsewhere at once, taken hold of or let go: the total was `before`."""
        self._solver.balance.work[WORK_ANCHORS] += self.total() - before

    def take_over(self, old: Books) -> None:
        """Go on from the books of a simulation with other settings."""
        self._solver.balance.work[:] = old._solver.balance.work
        book = old._last
        self._changes = book.changes + self.total() - book.total
        self._start = old._start

    def close(self) -> None:
        """Remember what is read now, for the books that take over."""
        self._last = self.read()
