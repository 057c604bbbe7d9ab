"""The energy of a body, and the balance of what has changed it."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..engine.tables import State
from ..forces.all import ENERGIES, OTHERS, WITH_ENERGY
from ..solve.balance.energies import energies
from .solver import Solver


@dataclass(frozen=True)
class Energies:
    """The energies, and what has changed their sum since the balance was opened, in kg px²/s².

    Attributes:
        kinetic: energy of the free masses' motion.
        gravity: that of their height above 0, with the energy -F · x of the constant forces on them.
        others: energies of `sim.forces.all.WITH_ENERGY`, in order: of linear and angular springs, of the
            depth in walls, of gases and liquids, and of contact. Each is an attribute, too, under its name
            there, such as `linear`. Under the law "tutorial" the angular energy is that of the conservative
            law.
        anchors: work done on the body by moved anchors. Grabbing a mass removes its kinetic energy and that
            of its height; releasing it adds that of its height at that moment.
        damping, air, friction: work of the damping of springs, of air friction and a medium, and of walls,
            contact and the ground by friction and in bouncing, which is negative; but wind can do work on a
            body.
        plastic, broken: energy lost in yielding, and with springs and joints that broke, which is negative.
        law: work of a force law that is not the gradient of an energy.
        keys: work of keys that change rest lengths and rest angles, and of forces that keys work.
        muscles: work of muscles, which do so, too.
        motors: work of motors.
        changes: energy added by changes of settings.
        fallbacks: energy added by fallback steps, which is negative or zero.
        residual: the sum of the energies minus its initial value and all of the above. This is the error of
            the integration method, which decreases with the step at the method's order.
    """

    kinetic: float
    gravity: float
    others: tuple[float, ...]
    anchors: float
    damping: float
    air: float
    friction: float
    plastic: float
    broken: float
    law: float
    keys: float
    muscles: float
    motors: float
    changes: float
    fallbacks: float
    residual: float

    def __getattr__(self, name: str) -> float:
        if name not in _OTHERS:
            raise AttributeError(name)
        return self.others[_OTHERS.index(name)]

    @property
    def total(self) -> float:
        """The sum of the energies."""
        return self.kinetic + self.gravity + sum(self.others)


_OTHERS = tuple(term.name for term in WITH_ENERGY)

ENERGY_FIELDS = tuple(
    name for field in fields(Energies) for name in (_OTHERS if field.name == "others" else (field.name,))
)
"""Names of the entries of the balance."""


class EnergyTracker:
    """Keeps the energy balance of a simulation; made only when it is asked for.

    Args:
        state, solver: of the simulation.
    """

    def __init__(self, state: State, solver: Solver) -> None:
        self._state, self._solver = state, solver
        self._solver.open_balance()
        self._changes = 0.0
        self._energies = np.zeros(ENERGIES)
        self._start = self.total()

    def read(self) -> Energies:
        """The present balance."""
        total = self.total()
        work = self._solver.balance.work
        energies = self._energies.tolist()
        return Energies(
            *energies[:OTHERS],
            others=tuple(energies[OTHERS:]),
            anchors=work.anchors,
            damping=work.damping,
            air=work.air,
            friction=work.walls,
            plastic=work.plastic,
            broken=work.broken,
            law=work.law,
            keys=work.keys,
            muscles=work.muscles,
            motors=work.motors,
            changes=self._changes,
            fallbacks=work.fallbacks,
            residual=total - self._start - work.total - self._changes,
        )

    def total(self) -> float:
        """The sum of the energies of the present state, kg px²/s²."""
        state, solver = self._state, self._solver
        body = solver.system.body
        return float(energies(body, state, body.environment.mass, state.q, state.v, self._energies))

    def moved(self, before: float) -> None:
        """Enter that held masses were moved at once, grabbed or released; the total was `before`."""
        self._solver.balance.work.anchors += self.total() - before

    def take_over(self, old: EnergyTracker) -> None:
        """Continue the balance of a simulation with other settings."""
        self._solver.balance.work.take_over(old._solver.balance.work)
        balance = old._last
        self._changes = balance.changes + self.total() - balance.total
        self._start = old._start

    def close(self) -> None:
        """Remember the present balance, for the one that continues it."""
        self._last = self.read()
