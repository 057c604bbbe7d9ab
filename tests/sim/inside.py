"""The few looks that the tests take at the inside of a `Simulation`."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from sim import Scene, Simulation
from sim.body.system import System
from sim.forces.springs import spring_forces as kernel_forces
from sim.motion.solver import Solver

Points = NDArray[np.float64]


def system_of(simulation: Simulation) -> System:
    return simulation._system


def solver_of(simulation: Simulation) -> Solver:
    """What runs the simulation's method."""
    solver = simulation._stepper.solver
    assert isinstance(solver, Solver)
    return solver


def adams_degree(simulation: Simulation) -> int:
    """The degree that Adams' methods went on with in the last step."""
    return int(solver_of(simulation).integrator.adams.degree)


def is_chain(simulation: Simulation) -> bool:
    """Whether the simulation takes the fast path for chains."""
    return simulation._body.chain


def is_ring(simulation: Simulation) -> bool:
    """Whether the simulation takes the fast path for rings."""
    return simulation._body.ring


def general(simulation: Simulation) -> Simulation:
    """The same simulation, made to take the path for any topology."""
    body = simulation._body.replaced(chain=False, ring=False)
    simulation._body = body
    simulation._system = dataclasses.replace(simulation._system, body=body)
    simulation._stepper = simulation._new_stepper()
    return simulation


def put(simulation: Simulation, positions: Points, velocities: Points | None = None) -> None:
    """Set the state of all masses, the held ones too."""
    index, state = simulation._system.mass_index, simulation._state
    state.x[index], state.y[index] = positions.T
    if velocities is not None:
        state.vx[index], state.vy[index] = velocities.T
    simulation._stepper.begin_anew()


def take_over(simulation: Simulation, other: Simulation) -> None:
    """Give a simulation the whole state of another one of the same scene; the methods of both begin anew."""
    for name, array in other._state.arrays():
        getattr(simulation._state, name)[:] = array
    simulation._stepper.begin(other.time, other.step_count)
    other._stepper.begin_anew()


def spring_forces(simulation: Simulation) -> Points:
    """(n, 2) what all springs and joints do to each mass at the present state, without air and gravity."""
    scratch = simulation._scratch
    state = simulation._state
    kernel_forces(simulation._body, state, scratch, state.x, state.y, state.vx, state.vy)
    index = simulation._system.mass_index
    return np.column_stack((scratch.fx[index], scratch.fy[index]))


def forces_of(scene: Scene) -> Points:
    """(n, 2) what all springs and joints do to each mass at the start of a scene."""
    return spring_forces(Simulation(scene))


def same_state(one: Simulation, other: Simulation) -> bool:
    """Whether all masses of both have the same positions and velocities, bit for bit."""
    return np.array_equal(one.positions, other.positions) and np.array_equal(one.velocities, other.velocities)
