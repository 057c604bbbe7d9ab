"""A body in the kernels' own arrays, so that tests can ask each kernel by itself."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from sim import Scene, Simulation
from sim.compiling.compiler import ENTRY_POINTS, fetch
from sim.forces.all import ENERGIES, accelerations, add_damping_product
from sim.forces.plasticity import yielding_accelerations
from sim.forces.rails import keep_on_rails
from sim.forces.reference import Physics
from sim.model.sparsity import new_matrix
from sim.motion.solver import Solver
from sim.solve.balance.energies import energies
from sim.solve.linear.implicit import factorise_matrix, solve_matrix
from tests.sim.checks import jacobian
from tests.sim.inside import scratch_of

Floats = NDArray[np.float64]


def off(found: Floats, expected: Floats) -> float:
    """The largest difference, as a part of the largest number that is expected."""
    return float(np.abs(found - expected).max() / np.abs(expected).max())


class Arrays:
    """A body at the start of its scene.

    Args:
        scene: a valid scene.
        general: whether a chain is to take the path for any topology.

    Attributes:
        q, v: positions and velocities, flat, as the kernels have them.
        here: the indices in a flat array that belong to masses: all x, then all y.
        free: of `here`, those that belong to masses that are not held.
        weight: kg, of each of `here`.
    """

    def __init__(self, scene: Scene, *, general: bool = False) -> None:
        fetch(ENTRY_POINTS)  # kernels are called directly here
        self.scene = scene
        simulation = Simulation(scene)
        simulation.keys = {"right", "down"}  # held where they work anything, with no time for anything else
        self.system, self.state = simulation.tables
        if general:
            self.system = dataclasses.replace(
                self.system, body=self.system.body.replaced(chain=False, ring=False)
            )
        self.body, self.scratch = self.system.body, scratch_of(simulation)
        self.solver = Solver(scene, self.system, self.state, self.scratch)
        self.solver.load(0.0)
        self.q, self.v = self.state.q.copy(), self.state.v.copy()
        self.slots = self.q.size // 2
        n = self.body.masses
        self.here = np.r_[1 : n + 1, self.slots + 1 : self.slots + n + 1]
        self.free = self.here[np.tile(~self.system.held, 2)]
        self.weight = np.tile(1.0 / self.system.inverse_mass, 2)
        self.matrix = new_matrix(self.body, self.system.held)

    def flat(self, pairs: Floats) -> Floats:
        """(n, 2), in the scene's order, as a flat array."""
        flat = np.zeros_like(self.q)
        flat[self.here] = pairs[self.system.mass_order].T.ravel()
        return flat

    def pairs(self, flat: Floats) -> Floats:
        """A flat array as (n, 2), in the scene's order."""
        index = self.system.mass_index
        return np.column_stack((flat[index], flat[self.slots + index]))

    def pairs_of(self, values: Floats) -> Floats:
        """Numbers of all of `here` as (n, 2), in the scene's order."""
        flat = np.zeros_like(self.q)
        flat[self.here] = values
        return self.pairs(flat)

    def accelerations(self, q: Floats, v: Floats) -> Floats:
        """Of all of `here`."""
        a = np.zeros_like(q)
        forces = yielding_accelerations if self.body.limits.present else accelerations
        forces(self.body, self.state, self.scratch, q, v, a)
        return a[self.here]

    def by_numpy(self) -> Floats:
        """The accelerations of all of `here` in the body's state, by `sim.forces.reference`."""
        state = self.state
        found = Physics(self.body, state).accelerations(state.x + 1j * state.y, state.vx + 1j * state.vy)
        return np.concatenate((found.real, found.imag))[self.here]

    def potential(self, q: Floats) -> float:
        """The energy of all that has one, but motion."""
        mass = np.zeros(self.slots)
        mass[1 : self.body.masses + 1] = 1.0 / self.system.inverse_mass
        still, parts = np.zeros_like(q), np.zeros(ENERGIES)
        return float(energies(self.body, self.state, mass, q, still, parts))

    def gradient(self) -> Floats:
        """The derivative of the potential by all of `here`, by differences of order 4."""
        return jacobian(self.potential, self.q, 1e-3, self.here)

    def derivative(self, by_velocity: bool, step: float) -> Floats:
        """The derivative of the accelerations by positions or velocities, by differences of order 4."""
        if by_velocity:
            return jacobian(lambda v: self.accelerations(self.q, v), self.v, step, self.here)
        return jacobian(lambda q: self.accelerations(q, self.v), self.q, step, self.here)

    def by_differences(self, a: float, g: float, places: float = 1e-3, speeds: float = 0.01) -> Floats:
        """a I - g Jv - Jx, by differences of accelerations of these sizes, px and px/s."""
        by_place, by_speed = self.derivative(False, places), self.derivative(True, speeds)
        return np.array(a * np.eye(self.here.size) - g * by_speed - by_place, float)

    def factorise(self, a: float, g: float, definite: bool = False) -> bool:
        """Factorise a I - g Jv - Jx at the present state."""
        return bool(factorise_matrix(self.body, self.state, self.matrix, self.q, self.v, a, g, definite))

    def solve(self, right: Floats) -> Floats:
        """Solve with the last factors, for numbers of all of `here`."""
        flat = np.zeros_like(self.q)
        flat[self.here] = right
        solve_matrix(self.body, self.state, self.matrix, flat)
        assert not np.delete(flat, self.here).any()  # the padding stays as it is
        return flat[self.here]

    def inverse(self, a: float, g: float, definite: bool = False) -> Floats:
        """The inverse of a I - g Jv - Jx, one column after the other."""
        assert self.factorise(a, g, definite)
        return np.array([self.solve(row) for row in np.eye(self.here.size)]).T

    def matrix_of(self, a: float, g: float, definite: bool = False) -> Floats:
        """a I - g Jv - Jx, as it is solved with."""
        return np.array(np.linalg.inv(self.inverse(a, g, definite)), float)

    @property
    def along(self) -> Floats:
        """What takes everything across rails out of numbers of all of `here`."""
        every = []
        for unit in np.eye(self.here.size):
            flat = np.zeros(self.q.size)
            flat[self.here] = unit
            keep_on_rails.py_func(self.body, flat)
            every.append(flat[self.here])
        return np.array(every).T

    def resistance(self, z: Floats, factor: float, start: Floats) -> Floats:
        """start + factor Jv z, for numbers of all of `here`."""
        flat, out = np.zeros((2, self.q.size))
        flat[self.here], out[self.here] = z, start
        add_damping_product(self.body, self.state, self.q, self.v, flat, factor, out)
        return out[self.here]
