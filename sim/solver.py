"""Runs any method but the tutorial's over a stretch of time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from .driving import new_drive
from .hand import NO_GLIDES, Glides
from .kernels import guard
from .kernels.auto import (
    KIND_ADAMS,
    KIND_ALPHA,
    KIND_AUTO,
    KIND_EXPLICIT,
    KIND_ROSENBROCK,
    KIND_VERLET,
    run,
)
from .kernels.bound import BOUND, DRIVE, Bound, bind, new_buffer
from .kernels.dissipation import DAMPER_ROWS
from .kernels.rescue import run_rescue
from .kernels.tables import (
    ARM_ADAMS,
    ARM_ALPHA,
    ARM_ROSENBROCK,
    ARM_VERLET,
    ARMS,
    AUTO_NEW,
    CLOCK_BEGUN,
    CLOCK_CONTRACTION,
    CLOCK_LAST,
    CLOCK_LAST_BUT_ONE,
    CLOCK_TIME,
    CLOCKS,
    CONTROL_SCALE,
    COUNT_FORCES,
    COUNT_FRESH,
    COUNT_MASS,
    COUNT_MATRICES,
    COUNT_REJECTED,
    COUNT_RESCUES,
    COUNT_STEPS,
    COUNT_WHAT,
    COUNTS,
    PAST,
    WORKS,
    Adams,
    Drive,
    Floats,
    Flow,
    Ledger,
    Live,
    Matrix,
    Rosenbrock,
    Tableau,
    Work,
)
from .methods import METHODS, MethodInfo
from .pattern import NO_MATRIX, new_matrix
from .scene import MAX_COORDINATE, MAX_SPEED, RUNAWAY_SPEED, Scene
from .stability import quick_limit
from .system import System, slab
from .tableaux import RK4

_ROWS, _HISTORY = 24, 4
_NEW = np.array(AUTO_NEW)

LOW_TOLERANCE = 3e-3
"""Tolerance, px, below which `auto` chooses from methods of high order, too."""

LONG = 200
"""Masses from which on `auto` tries generalized-alpha, too: what it is good at is long rods."""

_NEAR_LIMIT = 0.6
"""The part of the stability limit from which on a step counts as near it."""

_COARSEST, _FINER = 1e-3, 0.03
"""The part of a body's size up to which `auto` takes Rosenbrock methods by their word, since they see too
little of the error of a stiff body's long steps; and the least part of the tolerance that it asks of them."""

_LARGEST, _SENSIBLE = 0.01, 0.1
"""The part of a body's size that `auto` takes for the tolerance, at most, and px that it takes all the same:
within more than that, velocities of the lightest masses could be anything."""

_ADAMS_LOW, _ADAMS_HIGH = 0.5, 1.6
"""What it multiplies the tolerance of Adams' methods by, down to `LOW_TOLERANCE` and below. Found by trying:
so, about the same share of random bodies ends within large tolerances and within small ones."""

RESCUE_STEP = 1e-3
"""Length of a step of last resort, s."""

UNLIMITED = 2**62

_KINDS = {
    "explicit": KIND_EXPLICIT,
    "verlet": KIND_VERLET,
    "rosenbrock": KIND_ROSENBROCK,
    "alpha": KIND_ALPHA,
    "adams": KIND_ADAMS,
    "auto": KIND_AUTO,
}


@dataclass
class Effort:
    """What a method did since its counters were last taken.

    Attributes:
        steps, rejected: steps kept and steps tried in vain.
        forces, matrices: evaluations of the accelerations, and matrices factorised.
        rescues: steps of last resort.
    """

    steps: int = 0
    rejected: int = 0
    forces: int = 0
    matrices: int = 0
    rescues: int = 0


class Solver:
    """The state of one body in flat arrays, and the methods that move it on.

    Args:
        scene: a valid scene.
        system: its tables.
        live: parameters that change.
        work: scratch.
    """

    def __init__(self, scene: Scene, system: System, live: Live, work: Work) -> None:
        self.scene, self.system, self.live, self.work = scene, system, live, work
        self.places = live.x.size
        wide = 2 * self.places
        self._info = METHODS[scene.integrator.method]
        kind = self._info.kind
        remembers = kind == "alpha" or (kind == "auto" and system.body.masses >= LONG)
        history, past = 3 + _ROWS, 3 + _ROWS + (_HISTORY if remembers else 0)
        count = past + (PAST if kind in ("adams", "auto") else 0)
        (room,) = slab([(count * wide, 1)], page_offset=2560)
        rows = room.reshape(-1, wide)  # a whole number of cache lines each
        self.flow = Flow(
            q=rows[0],
            v=rows[1],
            a=rows[2],
            clock=np.zeros(CLOCKS),
            limits=np.array([MAX_COORDINATE, MAX_SPEED]),
            counts=np.zeros(COUNTS, np.int64),
            rows=rows[3 : 3 + _ROWS],
            mind=_NEW.copy(),
            history=rows[history:past],
            past=rows[past:],
        )
        if not self._info.adaptive:
            self.flow.limits[1] = RUNAWAY_SPEED
        no_rows = np.zeros((1, 0))
        self.ledger = Ledger(False, np.zeros(WORKS), np.zeros(self.places), no_rows, no_rows)
        self.ledger.mass[1 : system.body.masses + 1] = 1.0 / system.inverse_mass
        self._matrix: Matrix | None = None
        self._buffer, self._driven = new_buffer(BOUND), new_buffer(DRIVE)
        self._bound: Bound | None = None
        self._driven_by: Drive | None = None
        circles = {a.mass: a.circle for a in scene.anchors if a.circle is not None}
        self._circle = {int(system.mass_place[m]): circle for m, circle in circles.items()}
        self._hand = 0.0 if scene.force_law == "tutorial" else 1.0

    @property
    def matrix(self) -> Matrix:
        """What implicit steps need; made when it is first asked for."""
        if self._matrix is None:
            self._matrix = new_matrix(self.system.body, self.system.held)
        return self._matrix

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return float(self.flow.clock[CLOCK_TIME])

    def load(self, time: float) -> None:
        """Take over the state in `live`, at a time; what was carried from step to step is forgotten."""
        flow, live, p = self.flow, self.live, self.places
        flow.q[:p], flow.q[p:], flow.v[:p], flow.v[p:] = live.x, live.y, live.vx, live.vy
        flow.clock[:] = 0.0
        flow.mind[:] = _NEW
        flow.clock[CLOCK_TIME] = time
        flow.counts[:] = 0

    def drive(
        self,
        until: float,
        targets: dict[int, tuple[float, float]],
        growth: float,
        turn: float,
        glides: Glides = NO_GLIDES,
    ) -> Drive:
        """How masses move and keys act until a time.

        Args:
            until: the time, s.
            targets: where masses that are led straight are to be then, px, by place.
            growth, turn: what keys do to rest lengths and angles per second, see `Drive`.
            glides: how hands move, by place.
        """
        return new_drive(
            self.flow.q, self.live, self._circle, self._hand, self.time, until, targets, growth, turn, glides
        )

    def run(self, until: float, drive: Drive, attempts: int = UNLIMITED) -> int:
        """Go on to a time by the scene's method, as far as the attempts lead.

        Positions and velocities are in `live`, too, afterwards.

        Returns:
            guard.GOOD, or what is wrong with the state that the next step would lead to.
        """
        if self._bound is None:
            self._bind()
        if drive is not self._driven_by:
            bind(self._driven, drive)
            self._driven_by = drive
        counts = self.flow.counts
        left = attempts - run(self._buffer, self._driven, until, attempts)
        what = int(counts[COUNT_WHAT])
        while what == guard.STUCK and self._info.implicit and left > 0 and self.time < until:
            self.rescue(until, drive)
            left -= run(self._buffer, self._driven, until, left)
            what = int(counts[COUNT_WHAT])
        if what == guard.STUCK and self._info.implicit:
            what = guard.GOOD  # no more than late: the next call begins with a step of last resort
        return what

    def _bind(self) -> None:
        """Hand all tables over to the compiled code."""
        info, integrator = self._info, self.scene.integrator
        low = info.kind == "auto" and integrator.tolerance >= LOW_TOLERANCE
        rodas = METHODS["rodas4" if low else "rodas5p"]
        names = ("velocity_verlet", rodas.name, "generalized_alpha", "adams")
        arms = [METHODS[name] for name in names]
        explicit, implicit = (
            info.table if isinstance(info.table, kind) else other
            for kind, other in ((Tableau, RK4), (Rosenbrock, rodas.table))
        )
        assert isinstance(explicit, Tableau)
        assert isinstance(implicit, Rosenbrock)
        adams = arms[ARM_ADAMS].table
        assert isinstance(adams, Adams)
        self._bound = Bound(
            kind=_KINDS[info.kind],
            fixed=0.0 if info.adaptive else integrator.dt,
            tolerance=max(integrator.tolerance * info.strictness, 1e-13) if info.adaptive else 1.0,
            body=self.system.body,
            live=self.live,
            work=self.work,
            matrix=self.matrix if info.implicit else NO_MATRIX,
            flow=self.flow,
            ledger=self.ledger,
            explicit=explicit,
            implicit=implicit,
            adams=adams,
            costs=self._costs(low) if info.kind == "auto" else np.zeros(ARMS),
            strictness=self._strictness(arms, low) if info.kind == "auto" else np.ones(ARMS),
            near_limit=_NEAR_LIMIT * quick_limit(self.system) if info.kind in ("auto", "adams") else 0.0,
        )
        bind(self._buffer, self._bound)

    def _strictness(self, arms: list[MethodInfo], low: bool) -> Floats:
        """See `Bound.strictness`."""
        strictness = np.array([arm.strictness for arm in arms])
        strictness[ARM_ADAMS] *= _ADAMS_LOW if low else _ADAMS_HIGH
        size = max(
            *np.ptp([mass.position for mass in self.scene.masses], axis=0),
            *(spring.rest_length for spring in self.scene.linear_springs),
        )
        tolerance = self.scene.integrator.tolerance
        strictness[ARM_ROSENBROCK] *= min(max(_COARSEST * size / tolerance, _FINER), 1.0)
        return strictness * min(max(_LARGEST * size, _SENSIBLE) / tolerance, 1.0)

    def _costs(self, low: bool) -> Floats:
        """See `Bound.costs`; measured in ns on chains, elsewhere in proportion to operations."""
        body, matrix = self.system.body, self.matrix
        n = body.masses
        force, factors = 3.3 * n, 400.0 + 16.0 * n
        blocks = 1.8 * n
        if not (body.chain or body.ring):
            force = 5.0 * body.springs + 4.0 * body.joints + 2.0 * n
        if not body.chain:
            later = matrix.row_start[1:] - matrix.diagonal - 1
            products = float((later * (later + 1)).sum())
            factors = 1500.0 + 20.0 * body.springs + 60.0 * body.joints + 4.0 * products
            blocks = float(matrix.column.size)
        stages = 6 if low else 8
        costs = np.zeros(ARMS)
        costs[ARM_VERLET] = 60.0 + force
        costs[ARM_ADAMS] = 80.0 + 2.0 * force + 4.0 * n
        costs[ARM_ROSENBROCK] = factors + stages * (force + 2.0 * blocks + 4.0 * n)
        if low and n >= LONG:
            costs[ARM_ALPHA] = 1.2 * (factors + force + 2.0 * blocks) + 16.0 * n
        return costs / costs[ARM_VERLET]

    def rescue(self, until: float, drive: Drive) -> None:
        """Leave a state that no method can leave, by a step of last resort; as `run`."""
        body = self.system.body
        lengths = body.rest_length[: body.springs] * self.live.controls[CONTROL_SCALE]
        typical = max(float(np.median(lengths)) if body.springs else 1.0, 1e-3)
        h = min(RESCUE_STEP, until - self.time)
        run_rescue(
            body, self.live, self.work, self.matrix, drive, self.flow, self.ledger, *self.scene.gravity,
            h, 1e-6 * typical, typical,
        )  # fmt: skip
        flow, live, p = self.flow, self.live, self.places
        live.x[:], live.y[:], live.vx[:], live.vy[:] = flow.q[:p], flow.q[p:], flow.v[:p], flow.v[p:]
        flow.mind[:] = _NEW
        flow.clock[[CLOCK_LAST, CLOCK_LAST_BUT_ONE, CLOCK_BEGUN, CLOCK_CONTRACTION]] = 0.0

    def open_ledger(self) -> None:
        """Keep books from now on of what changes the energy."""
        body = self.system.body
        rows, dampers = np.zeros((3, 2 * self.places)), np.zeros((DAMPER_ROWS, body.springs + body.joints))
        self.ledger = self.ledger._replace(active=True, rows=rows, dampers=dampers)
        self.ledger.work[:] = 0.0
        self._bound = None

    def close_ledger(self) -> None:
        """Keep books no more."""
        self.ledger = self.ledger._replace(active=False)
        self._bound = None

    def touch(self) -> None:
        """Say that the state or what acts on it has changed from outside."""
        self.flow.counts[COUNT_FRESH] = 0

    def stop(self, places: Iterable[int]) -> None:
        """Some held masses are led no more."""
        for place in places:
            self.flow.v[place] = self.flow.v[self.places + place] = 0.0

    @property
    def tries(self) -> int:
        """Steps tried since the counters were last taken."""
        return int(self.flow.counts[COUNT_STEPS] + self.flow.counts[COUNT_REJECTED])

    @property
    def place(self) -> int:
        """The place of the mass that shows what is wrong."""
        return int(self.flow.counts[COUNT_MASS])

    def effort(self) -> Effort:
        """What was done since the last call of this."""
        counts = self.flow.counts
        places = (COUNT_STEPS, COUNT_REJECTED, COUNT_FORCES, COUNT_MATRICES, COUNT_RESCUES)
        effort = Effort(*(int(counts[i]) for i in places))
        counts[list(places)] = 0
        return effort
