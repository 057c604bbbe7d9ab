"""The energy of a body, and the books of what has changed it."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from .kernels.controls import refresh
from .kernels.energy import energies
from .kernels.forces import accelerations
from .kernels.guard import GOOD
from .kernels.ledger import tally
from .kernels.steps import freshen
from .kernels.tables import (
    WORK_AIR,
    WORK_ANCHORS,
    WORK_DAMPING,
    WORK_KEYS,
    WORK_LAW,
    WORK_RESCUE,
    Live,
    Work,
)
from .scene import Scene
from .solver import Solver
from .stepping import EulerStepper, FlowStepper, Outcome, Presses, Stepper, Targets
from .system import System


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
        rescues: what steps of last resort have added; negative or zero.
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
    rescues: float
    residual: float

    @property
    def total(self) -> float:
        """The sum of the four energies."""
        return self.kinetic + self.linear + self.angular + self.gravity


ENERGY_FIELDS = tuple(field.name for field in fields(EnergyBook))


class Books:
    """Keeps the books of a simulation; made only where someone wants to read them.

    Args:
        scene, system, live, work, stepper: of the simulation.
    """

    def __init__(self, scene: Scene, system: System, live: Live, work: Work, stepper: Stepper) -> None:
        self._scene, self._system, self._live, self._work = scene, system, live, work
        # The tutorial's kernels keep no books; a solver that never steps does it for them.
        self._solver = (
            stepper.solver if isinstance(stepper, FlowStepper) else Solver(scene, system, live, work)
        )
        self._solver.open_ledger()
        self._changes = 0.0
        self._four = np.zeros(4)
        self._start = self.total()

    def read(self) -> EnergyBook:
        """The books as they are now."""
        total = self.total()
        kinetic, linear, angular, gravity = (float(e) for e in self._four)
        work = self._solver.ledger.work
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
            rescues=float(work[WORK_RESCUE]),
            residual=total - self._start - float(work.sum()) - self._changes,
        )

    def total(self) -> float:
        """The sum of the energies of the state in `live`."""
        live, gravity = self._live, self._scene.gravity
        q, v = np.concatenate((live.x, live.y)), np.concatenate((live.vx, live.vy))
        energies(self._system.body, live, self._solver.ledger.mass, *gravity, q, v, self._four)
        return float(self._four.sum())

    def moved(self, before: float) -> None:
        """Held masses were put elsewhere at once, taken hold of or let go: the total was `before`."""
        self._solver.ledger.work[WORK_ANCHORS] += self.total() - before

    def take_over(self, old: Books) -> None:
        """Go on from the books of a simulation with other settings."""
        self._solver.ledger.work[:] = old._solver.ledger.work
        book = old._last
        self._changes = book.changes + self.total() - book.total
        self._start = old._start

    def close(self) -> None:
        """Remember what is read now, for the books that take over."""
        self._last = self.read()

    def euler_steps(
        self, stepper: EulerStepper, steps: int, targets: Targets, presses: Presses, all_held: bool
    ) -> Outcome:
        """Steps of the tutorial's kernels, one by one, with their work entered."""
        done, live = 0, self._live
        start = {m: (float(live.x[m]), float(live.y[m])) for m in targets}
        for i in range(steps):
            part = (i + 1) / steps
            ends = {
                m: (start[m][0] + (x - start[m][0]) * part, start[m][1] + (y - start[m][1]) * part)
                for m, (x, y) in targets.items()
            }
            outcome = self._euler_step(stepper, ends, presses, all_held)
            done += outcome.steps
            if outcome.what != GOOD:
                return Outcome(done, outcome.what, outcome.place)
        return Outcome(done)

    def _euler_step(
        self, stepper: EulerStepper, targets: Targets, presses: Presses, all_held: bool
    ) -> Outcome:
        solver, live, body, dt = self._solver, self._live, self._system.body, self._scene.integrator.dt
        time = stepper.time
        growth, turn = np.log(presses.factor) / dt, presses.angle / dt
        solver.load(time)
        drive = solver.drive(time + dt, targets, growth, turn)
        freshen(body, live, self._work, drive, solver.flow)
        outcome = stepper.step(1, targets, presses, all_held)
        q, v = np.concatenate((live.x, live.y)), np.concatenate((live.vx, live.vy))
        a = np.zeros_like(q)
        controls = live.controls.copy()
        accelerations(body, live, self._work, q, v, a)
        if outcome.steps:
            tally(body, live, self._work, solver.ledger, drive, solver.flow, time, q, v, a, dt)
        live.controls[:] = controls
        refresh(body, live)
        return outcome
