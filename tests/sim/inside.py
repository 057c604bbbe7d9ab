"""The few looks that the tests take at the inside of the solver; no other file of these tests takes any."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numba
import numpy as np
import pytest
from numpy.typing import NDArray

from sim import Scene, Simulation
from sim.engine import kept
from sim.engine.tables import Adams, Floats, PrescribedMotion, Problem, Rosenbrock, Scratch
from sim.forces.one_sided import OneSidedReference, is_one_sided
from sim.forces.runs import add_spring_forces
from sim.model.system import System
from sim.motion.plain import PlainSolver
from sim.motion.solver import Solver
from sim.scene import columns
from sim.solve.steps import adams
from sim.solve.steps.rosenbrock import run_rosenbrock

Points = NDArray[np.float64]


def system_of(simulation: Simulation) -> System:
    return simulation.tables[0]


def solver_of(simulation: Simulation) -> Solver:
    """What runs the simulation's method."""
    solver = simulation._motion.solver
    assert isinstance(solver, Solver)
    return solver


def adams_degree(simulation: Simulation) -> int:
    """The degree that Adams' methods went on with in the last step."""
    return int(solver_of(simulation).integrator.adams.degree)


def is_chain(simulation: Simulation) -> bool:
    """Whether the simulation takes the fast path for chains."""
    return simulation._system.body.chain


def is_ring(simulation: Simulation) -> bool:
    """Whether the simulation takes the fast path for rings."""
    return simulation._system.body.ring


def problem_of(simulation: Simulation) -> Problem:
    """The table of all tables that the simulation's kernels work on; its method has begun."""
    problem = solver_of(simulation)._problem
    assert problem is not None
    return problem


def scratch_of(simulation: Simulation) -> Scratch:
    """The kernels' room for what is needed within a step."""
    return simulation._motion.scratch


def drive(simulation: Simulation, start: float, end: float) -> PrescribedMotion:
    """What drives the simulation's body from a time to another, without hands and keys."""
    return simulation._motion._driver.drive(start, end, {})


def run_in_steps(solver: Solver, table: Rosenbrock, drive: PrescribedMotion, end: float, step: float) -> None:
    """Run to a time in steps of one length with a method that otherwise chooses them itself."""
    problem = solver._bind(True).replaced(implicit=table, fixed=step)
    run_rosenbrock(problem, drive, end, 1.0, 10**6)


def general(simulation: Simulation) -> Simulation:
    """The same simulation, made to take the path for any topology."""
    motion = simulation._motion
    motion._whole = dataclasses.replace(
        motion._whole, body=motion._whole.body.replaced(chain=False, ring=False)
    )
    motion.solver = motion._new_solver()
    return simulation


def by_numpy(simulation: Simulation) -> Simulation:
    """The same simulation, made to move by NumPy and to go on doing so."""
    motion = simulation._motion
    motion.solver = PlainSolver(motion.scene, motion.system, motion.state)
    simulation.take_compiled = lambda: False  # type: ignore[method-assign]
    return simulation


def with_law(simulation: Simulation, code: int) -> Simulation:
    """The same simulation, whose joints have another law: one of that code, which need not exist."""
    solver = simulation._motion.solver
    solver.system = dataclasses.replace(solver.system, body=solver.system.body.replaced(law=code))
    return simulation


def begin_anew(simulation: Simulation) -> None:
    """Let the method begin anew with the next step."""
    simulation._motion.begin_anew()


def put(simulation: Simulation, positions: Points, velocities: Points | None = None) -> None:
    """Set the state of all masses, the held ones too."""
    index, state = simulation._system.mass_index, simulation._state
    state.x[index], state.y[index] = positions.T
    if velocities is not None:
        state.vx[index], state.vy[index] = velocities.T
    simulation._motion.begin_anew()


def spring_forces(simulation: Simulation) -> Points:
    """(n, 2) what all springs and joints do to each mass at the present state, without air and gravity."""
    scratch = simulation._motion.scratch
    state = simulation._state
    scratch.fx[:], scratch.fy[:] = 0.0, 0.0
    add_spring_forces(simulation._system.body, state, scratch, state.q, state.v)
    index = simulation._system.mass_index
    found = np.column_stack((scratch.fx[index], scratch.fy[index]))
    if is_one_sided(simulation.scene):
        x, v = (flat[: state.slots] + 1j * flat[state.slots :] for flat in (state.q, state.v))
        back = OneSidedReference(simulation._system.body, state).forces(x, v)[index]
        found += np.column_stack((back.real, back.imag))
    return found


def forces_of(scene: Scene) -> Points:
    """(n, 2) what all springs and joints do to each mass at the start of a scene."""
    return spring_forces(Simulation(scene))


def same_state(one: Simulation, other: Simulation) -> bool:
    """Whether all masses of both have the same positions and velocities, bit for bit."""
    return np.array_equal(one.positions, other.positions) and np.array_equal(one.velocities, other.velocities)


# ------------------------------------------------------------------------- modules
STEADY = adams._STEADY
"""The degree that Adams' methods leave to long steps."""

KRYLOV = "sim.model.sparsity._KRYLOV"
"""Where a test may set how many directions the solver of linear systems tries before it begins anew."""


@numba.njit
def spaced(past: Floats, head: int, method: Adams, degree: int, ratio: float, rows: Floats) -> None:
    """Interpolate the past of Adams' methods for a step that is `ratio` times as long."""
    adams._space(past, head, method, degree, ratio, rows)


def hash_from(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the kernels' hashes made of the sources in another folder."""
    monkeypatch.setattr(kept, "_SOURCES", sources)
    kept.source_hash.cache_clear()


@contextmanager
def nothing_kept() -> Iterator[None]:
    """While it lasts, no arrays are known of any parts."""
    before = dict(columns._kept)
    columns._kept.clear()
    try:
        yield
    finally:
        columns._kept.clear()
        columns._kept.update(before)
