"""Runs any method over a span of time: the tables of a body, and the kernels that work on them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from ..compiling.compiler import (
    ENTRY_POINTS,
    FOR_MATRICES,
    fetch,
    for_energy,
    for_events,
    for_fallback,
    is_ready,
    needed_by,
)
from ..engine.calls import INDIRECT_CALLS
from ..engine.layout import Layout, aligned_arena
from ..engine.table import Record
from ..engine.tables import (
    CHOICES,
    CONTROL_SCALE,
    PAST,
    ROSENBROCK,
    VERLET,
    Adams,
    AdamsState,
    AlphaState,
    AutoState,
    EnergyBalance,
    Floats,
    Indices,
    IntegratorState,
    Matrix,
    PhasePoint,
    PrescribedMotion,
    Problem,
    Progress,
    Rosenbrock,
    Scratch,
    State,
    StepAttempt,
    Tableau,
    VerletState,
    Work,
)
from ..forces.all import paths_of
from ..forces.fillings import FillingsReference
from ..forces.plasticity import restore_committed, without_broken
from ..model.sparsity import NO_MATRIX, clear_factors, new_matrix
from ..model.state import update_rest_state
from ..model.system import System
from ..scene.numbers import MAX_COORDINATE, MAX_SPEED, RUNAWAY_SPEED
from ..scene.types import Scene, is_damageable
from ..solve.balance.dissipation import DAMPER_ROWS
from ..solve.registry import AUTO_METHODS, METHODS
from ..solve.steps import guard
from ..solve.steps.fallback import run_fallback
from ..solve.tableaux import RK4
from .auto_costs import LONG, LOW_TOLERANCE, costs_of_steps, tolerance_factors
from .checkpoint import SolverMemory, Words, writable
from .stability import damped_limit, quick_limit

_ROWS, _ALPHA_ROWS = 20, 4
"""Numbers of rows of `IntegratorState.rows` and `AlphaState.rows`."""
_ROWS_OFFSET = 2560 // 8
"""Where they begin in a page of 512 numbers; see `engine.layout.aligned_arena`."""

_NO_BALANCE = EnergyBalance.empty().replaced(work=Work())
"""Of all solvers that keep none; nobody reads what is entered into it."""

_TIME, _STATUS, _STEPS, _REJECTED = map(Progress.place, ("time", "status", "steps", "rejected"))
"""Where a run's numbers are in its words."""

_NEXT_TURN = ENTRY_POINTS["next_turn"]
_OF_AUTO = [ENTRY_POINTS[method.kernel.py_func.__name__] for method in AUTO_METHODS]
"""The kernels of the methods that `auto` chooses from."""

# Unless noted, doubling or halving one of these numbers fails no test.
_NEAR_LIMIT = 0.6
"""Step, as a fraction of the stability limit without damping, from which it counts as near the limit. By
experiment (20 bodies): 0.3, 13 % larger errors; 0.9, 3 % more work. Doubled,
`test_vibrations_that_nothing_damps_do_not_hold_steps` fails; halved,
`test_far_from_its_limit_verlet_leaves_most_of_the_tolerance_to_what_may_come`."""
_NEAR_DAMPED_LIMIT = 0.9
"""The same as a fraction of velocity Verlet's limit, where damping makes that much lower. By experiment:
halved, 14 % larger errors; 1.3 makes no difference. Doubled,
`test_where_stability_limits_all_steps_hardly_more_is_done_than_by_the_longest_stable_ones` fails; halved,
`test_far_from_its_limit_verlet_leaves_most_of_the_tolerance_to_what_may_come`."""
_MIN_DAMPED_LIMIT = 1e-7
"""Where that limit is lower, s, the velocities of such steps could be anything within the tolerance. At 0,
`test_no_tolerance_lets_a_light_mass_on_a_strong_damper_run_away` fails."""

_WITH_LIMITS = 0.3
"""Tolerance of methods with error control where something yields or breaks, as a fraction of the scene's: the
kinks of forces cause larger errors than is estimated for smooth ones. Found on random worlds."""
_WITH_CONTACT = 0.1
"""The same once more if masses may also lie on springs. Errors are held to the tolerance by place, and those
of speeds mostly cancel where a body vibrates. In a collision, which takes a few short steps, they do not: it
leaves a wrong speed, and collisions and breaks turn small errors into larger ones."""

_WITH_GRIP, _WITH_GRIP_LOW = 0.7, 0.2
"""The same again where friction holds: the first for RODAS 5P above `LOW_TOLERANCE`; the second below it,
for every method.
Without it, one random world in seven is off by up to twice 1e-3 px; with it, 98 in 100 are within theirs."""

FALLBACK_STEP = 1e-3
"""Length of a fallback step, s."""
_FALLBACK_WORK = 2
"""Computing time of a fallback step, in steps of the implicit method."""

UNLIMITED = 2**62
"""A number of steps that is never reached."""


@dataclass
class SolverStats:
    """Counts of what a method did since they were last read.

    Attributes:
        steps, rejected: accepted and rejected steps.
        forces, matrices: evaluations of the accelerations, and factorised matrices.
        fallbacks: fallback steps.
        work: what was tried, in steps; those of `auto` in steps of its cheapest method, by their costs.
    """

    steps: int = 0
    rejected: int = 0
    forces: int = 0
    matrices: int = 0
    fallbacks: int = 0
    work: int = 0


@lru_cache(maxsize=16)
def _layout(wide: int, past: int, alpha: int) -> Layout[IntegratorState]:
    """The layout for flat vectors of some length, and so many rows of `AdamsState` and of `AlphaState`."""
    # Rows lie in another part of a page than `new`, which has three vectors and some room behind each.
    new = 3 * (wide + 16)
    gap = (_ROWS_OFFSET - new - 16) % 512 + 8
    count = 1 + _ROWS + past + alpha
    arrays = aligned_arena([(wide, 1)] * 3 + [(gap, 0), (count * wide, 1)], page_offset=0)
    rows = arrays[4].reshape(-1, wide)  # a whole number of cache lines each
    first = IntegratorState(
        a=rows[0],
        old=PhasePoint(q=np.zeros(0), v=np.zeros(0), a=rows[0]),  # of each state its own
        new=PhasePoint(q=arrays[0], v=arrays[1], a=arrays[2]),
        rows=rows[1 : 1 + _ROWS],
        run=Progress(),
        trial=StepAttempt(),
        verlet=VerletState(),
        alpha=AlphaState(rows=rows[1 + _ROWS + past :]),
        adams=AdamsState(past=rows[1 + _ROWS : 1 + _ROWS + past]),
        auto=AutoState(step=arrays[3][:CHOICES], pace=arrays[3][CHOICES : 2 * CHOICES]),
    )
    return Layout(first, arrays, page_offset=0)


class Solver:
    """The tables of a body, and the methods that move it.

    Args:
        scene: a valid scene.
        system: its tables.
        state: positions, velocities and parameters that change.
        scratch: scratch arrays.
        wait: whether it may wait until kernels are compiled.

    Attributes:
        work: what was tried since the counts were last read, see `SolverStats`.
    """

    def __init__(
        self, scene: Scene, system: System, state: State, scratch: Scratch, wait: bool = True
    ) -> None:
        self.work = 0
        self._wait = wait
        self.scene, self._system, self.state, self.scratch = scene, system, state, scratch
        self.slots = state.q.size // 2
        wide = state.q.size
        self._info = info = METHODS[scene.integrator.method]
        tolerance = scene.integrator.tolerance * info.tolerance_factor
        if system.body.limits.present and is_damageable(scene):
            tolerance *= _WITH_LIMITS * (_WITH_CONTACT if system.body.environment.contact.present else 1.0)
        if system.body.environment.sticks:
            tolerance *= _WITH_GRIP if scene.integrator.tolerance >= LOW_TOLERANCE else _WITH_GRIP_LOW
        self._tolerance = max(tolerance, 1e-13)
        auto = self._info.name == "auto"
        remembers = self._info.name == "generalized_alpha" or (auto and system.body.masses >= LONG)
        layout = _layout(wide, PAST if auto or info.name == "adams" else 0, _ALPHA_ROWS if remembers else 0)
        self.integrator = layout.made()
        self.integrator.old.fill_in(q=state.q, v=state.v)
        memory, run = self.integrator.memory, self.integrator.run
        run.farthest, run.fastest = MAX_COORDINATE, MAX_SPEED if info.adaptive else RUNAWAY_SPEED
        self._memory, self._words, self._first_words = memory.room, memory.words, memory.words.copy()
        self._wholes, self._floats = run.wholes, run.floats
        self._own = None if info.kernel is None else ENTRY_POINTS[info.kernel.py_func.__name__]
        self.balance = _NO_BALANCE
        self._matrix: Matrix | None = None
        self._problem: Problem | None = None
        self._costs: Floats | None = None  # of a step of each method, see `Problem`
        self._fetched: set[int] = set()  # indices of methods that `auto` has used
        self._missing: set[int] = set()  # indices of methods that `auto` cannot choose yet

    @property
    def system(self) -> System:
        """The tables; they change when springs break."""
        return self._system

    @system.setter
    def system(self, system: System) -> None:
        self._system, self._problem = system, None

    @property
    def matrix(self) -> Matrix:
        """The matrix of implicit steps; made when it is first used."""
        if self._matrix is None:
            self._matrix = new_matrix(self.system.body, self.system.held)
        return self._matrix

    @property
    def complete(self) -> bool:
        """Whether it waits for no kernel that is still being compiled."""
        if self._wait:
            return True
        chosen = AUTO_METHODS if self._info.kernel is None else ()
        body = self.system.body
        own = [name for method in chosen for name in needed_by(method.name, body)]
        return is_ready((*own, *(for_fallback(body) if self._info.implicit else ())))

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self.integrator.run.time

    def load(self, time: float) -> None:
        """Start from the state in `state`, at a time (s), and forget what was kept from earlier steps.

        Nothing of them is left, not even in scratch, which loops over padding read.
        """
        run = self.integrator.run
        fastest = run.fastest
        self._memory.fill(0.0)
        self.scratch.memory.room.fill(0.0)
        self._words[:] = self._first_words
        if self._matrix is not None:
            clear_factors(self._matrix)
        run.time, run.origin, run.fastest = time, time, fastest
        if self._own is None:
            self._forget_turns()

    def remembered(self, begins: bool) -> SolverMemory:
        """Return all that it knows of earlier steps, to the last bit, and what is in its scratch.

        Args:
            begins: whether `load` comes next, so that it knows nothing.
        """
        costs = None if self._costs is None else self._costs.copy()
        if begins:
            return SolverMemory(None, (), costs)
        numbers = tuple(record.contents() for record in self._records)
        return SolverMemory(Words.of(self._arrays), numbers, costs)

    def remember(self, memory: SolverMemory) -> None:
        """Go on as a solver of the same tables did that had remembered this; not the state."""
        self._costs, self._problem, self._missing = memory.costs, None, set()
        if memory.arrays is None:
            return
        memory.arrays.put_into(self._arrays)
        self._words[:] = self._first_words
        for record, numbers in zip(self._records, memory.numbers, strict=True):
            record.put(numbers)
        if self._matrix is not None:
            clear_factors(self._matrix)  # each step makes its own

    @property
    def _arrays(self) -> list[Floats | Indices]:
        return [self._memory, *writable(self.scratch.arrays())]

    @property
    def _records(self) -> list[Record]:
        every = (getattr(self.integrator, name) for name in sorted(self.integrator.tables))
        return [each for each in every if isinstance(each, Record)]

    def _forget_turns(self) -> None:
        """Forget what `auto` has learnt of its methods."""
        auto = self.integrator.auto
        auto.clear()
        auto.turn, auto.step[:], auto.pace[:] = -1, 0.0, -1.0

    def run(self, until: float, drive: PrescribedMotion, attempts: int = UNLIMITED) -> int:
        """Advance to a time (s) by the scene's method.

        Args:
            until: s.
            drive: how held masses move.
            attempts: what it may try, counted as `work` is.

        Returns:
            guard.GOOD, or what is wrong with the state after the next step.
        """
        run, last = self.integrator.run, self.work + attempts
        if run.status != guard.CHANGED:  # as `go_on` leaves it, if springs have broken
            self._run(until, drive, attempts)
        can_fall_back = self._info.implicit and (self._wait or is_ready(for_fallback(self.system.body)))
        while (status := run.status) != guard.GOOD:
            if status == guard.CHANGED:
                self._take_damage()
            elif status == guard.STUCK and can_fall_back and self.work < last and self.time < until:
                self.fall_back(until, drive)
            else:
                break
            if self.work < last and self.time < until:
                self._run(until, drive, last - self.work)
        if self.time < until and self.system.body.limits.present:
            restore_committed(self.system.body, self.state)
        if status == guard.STUCK and self._info.implicit:
            status = guard.GOOD  # it is only late: the next call begins with a fallback step
        return status

    def _take_damage(self) -> None:
        """Go on with the springs that are left, after some have broken."""
        alpha = self.integrator.alpha
        self.integrator.run.status = guard.GOOD
        # What implicit methods remember of the last steps does not belong to these forces.
        alpha.last = alpha.older = 0.0
        alpha.steps = 0
        system = replace(self.system, body=without_broken(self.system.body, self.state.broken))
        if self.balance.active and system.body.environment.fillings.rows.size:
            # A filling that gets out takes its energy with it.
            x = self.state.x + 1j * self.state.y
            before, after = (FillingsReference(s.body, self.state).energy(x) for s in (self.system, system))
            self.balance.work.broken += after - before
        self.system = system
        update_rest_state(system.body, self.state)

    def go_on(self, until: float, drive: PrescribedMotion, attempts: int) -> int:
        """As `run`, where nothing comes in between.

        Returns:
            -1 if it got there. If not, what is left of the attempts, with which `run` has to be called.
        """
        before = self.work
        self._run(until, drive, attempts)
        if self._wholes[_STATUS] == guard.GOOD and self._floats[_TIME] == until:
            return -1
        return max(0, before + attempts - self.work)

    def _run(self, until: float, drive: PrescribedMotion, attempts: int) -> None:
        """Like `run`, without fallback steps."""
        if self._own is not None:
            numbers, problem = self._wholes, self._problem or self._bind(self._info.implicit)
            before = numbers[_STEPS] + numbers[_REJECTED]
            self._own.call(problem, drive, until, self._tolerance, attempts)
            self.work += numbers[_STEPS] + numbers[_REJECTED] - before
            return
        if self._missing:
            self._enable_ready_methods()
        problem, left = self._problem or self._bind(False), attempts
        while True:
            index, limit, of_turn, spent = _NEXT_TURN.call(problem, until, self._tolerance, left)
            left -= spent
            self.work += spent
            if index < 0:
                return
            method = AUTO_METHODS[index]
            if method.implicit and not problem.factorise_matrix:
                problem = self._bind(True)
            if index not in self._fetched:
                self._fetched.add(index)
                self._fetch(needed_by(method.name, self.system.body))
            _OF_AUTO[index].call(problem, drive, until, of_turn, limit)

    def _bind(self, implicit: bool) -> Problem:
        """Make the table of all tables; `implicit`: with what linear systems need."""
        info, integrator = self._info, self.scene.integrator
        auto = info.kernel is None
        low = auto and integrator.tolerance >= LOW_TOLERANCE
        rodas = METHODS["rodas4" if low else "rodas5p"]
        methods = [rodas if index == ROSENBROCK else one for index, one in enumerate(AUTO_METHODS)]
        own, adams = info.table, METHODS["adams"].table
        rosenbrock = own if isinstance(own, Rosenbrock) else rodas.table
        assert isinstance(rosenbrock, Rosenbrock)
        assert isinstance(adams, Adams)
        if auto and self._costs is None:
            self._costs = costs_of_steps(self.system.body, self.matrix, low)
            self._missing = set(np.flatnonzero(self._costs).tolist())
            self._enable_ready_methods()
        costs = np.zeros(CHOICES) if self._costs is None else self._costs.copy()
        costs[list(self._missing)] = 0.0
        body = self.system.body
        called = (
            *(("accumulate_work",) if self.balance.active else ()),
            *(FOR_MATRICES if implicit else ()),
            *for_events(body),
        )
        forces = "yielding_accelerations" if body.limits.present else paths_of(body)[0].name
        needed = (*needed_by(info.name, body), *(for_fallback(body) if implicit else ()), *called)
        self._fetch((*needed, *(for_energy(body) if self.balance.active else ())))
        addresses = {name: ENTRY_POINTS[name].address if name in called else 0 for name in INDIRECT_CALLS}
        addresses["accelerations"] = ENTRY_POINTS[forces].address
        near = damped = 0.0
        if auto or info.name == "adams":
            near = _NEAR_LIMIT * quick_limit(self.system)
            damped = _NEAR_DAMPED_LIMIT * damped_limit(self.system, surroundings=False)
        self._problem = Problem(
            body=body,
            state=self.state,
            scratch=self.scratch,
            matrix=self.matrix if implicit else NO_MATRIX,
            integrator=self.integrator,
            balance=self.balance,
            **addresses,
            fixed=0.0 if info.adaptive else integrator.dt,
            near_limit=near,
            near_damped_limit=min(near, max(damped, _MIN_DAMPED_LIMIT)),
            explicit=own if isinstance(own, Tableau) else RK4,
            implicit=rosenbrock,
            adams=adams,
            costs=costs,
            tolerance_factor=tolerance_factors(self.scene, methods, low) if auto else np.ones(CHOICES),
        )
        return self._problem

    def _enable_ready_methods(self) -> None:
        """Let `auto` also choose from methods that have become ready, or from all if it may wait."""
        ready = {
            index
            for index in self._missing
            if self._wait
            or index == VERLET
            or is_ready(needed_by(AUTO_METHODS[index].name, self.system.body))
        }
        if ready:
            self._missing -= ready
            self._problem = None

    def fall_back(self, until: float, drive: PrescribedMotion) -> None:
        """Take a fallback step; see `run` for the arguments."""
        body, alpha = self.system.body, self.integrator.alpha
        lengths = body.rest_length[: body.springs] * self.state.controls[CONTROL_SCALE]
        typical = max(float(np.median(lengths)) if body.springs else 1.0, 1e-3)
        h = min(FALLBACK_STEP, until - self.time)
        problem = self._problem
        if problem is None or not problem.factorise_matrix:
            problem = self._bind(True)
        run_fallback(problem, drive, h, 1e-6 * typical, typical)
        implicit = 1.0 if self._costs is None else max(float(self._costs[ROSENBROCK]), 1.0)
        self.work += math.ceil(_FALLBACK_WORK * implicit)
        self._forget_turns()
        alpha.last = alpha.older = alpha.contraction = 0.0
        alpha.steps = 0

    def _fetch(self, names: tuple[str, ...]) -> None:
        """Load entry points, if it may wait for them; otherwise they are loaded by now."""
        if self._wait:
            fetch(names)

    def open_balance(self) -> None:
        """Start the energy balance."""
        body = self.system.body
        self._fetch(for_energy(body))
        around = body.environment
        laws = len(around.walls.rows) + len(around.resistance.rows) // max(body.springs, 1)
        # Methods of first order move masses by other speeds than those that they have on average.
        laws = laws if self._info.order != 1 else 0
        rows, quick = np.zeros((4, 2 * self.slots)), np.zeros((laws, 2 * self.slots))
        dampers = np.zeros((DAMPER_ROWS, body.springs + body.joints))
        self.balance = EnergyBalance(active=True, work=Work(), rows=rows, dampers=dampers, quick=quick)
        self._problem = None

    def close_balance(self) -> None:
        """Stop the energy balance."""
        self.balance = _NO_BALANCE
        self._problem = None

    @property
    def fastest(self) -> float:
        """Largest velocity component of a good state, px/s."""
        return self.integrator.run.fastest

    @fastest.setter
    def fastest(self, speed: float) -> None:
        self.integrator.run.fastest = speed

    @property
    def tracks_energy(self) -> bool:
        """Whether it keeps an energy balance."""
        return bool(self.balance.active)

    def invalidate(self) -> None:
        """Note that the state, or what acts on it, was changed from outside."""
        self.integrator.run.current = False

    @property
    def index(self) -> int:
        """Slot of the mass at which something is wrong."""
        return self.integrator.run.mass

    def stats(self) -> SolverStats:
        """Counts of what was done since the last call."""
        run = self.integrator.run
        stats = SolverStats(run.steps, run.rejected, run.forces, run.matrices, run.fallbacks, self.work)
        self.work = 0
        run.steps = run.rejected = run.forces = run.matrices = run.fallbacks = 0
        return stats
