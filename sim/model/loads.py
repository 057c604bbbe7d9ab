"""Forces on each mass and torques in each joint at a given time, from `sim.forces.reference`."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engine.tables import State
from ..forces.joints import JointsReference
from ..forces.reference import Physics
from ..scene.types import Scene
from .system import System


class Loads(NamedTuple):
    """Forces and torques.

    Attributes:
        forces: (n, 2) the net force on each mass, kg px/s²: of springs, joints, gravity, air, its constant
            force and the surroundings. For a mass held by an anchor or a hand it is the load on the support,
            without the inertia of a held mass that is being moved.
        torques: (J,) the torque of each angular spring on its first spring, kg px²/s², positive from +x
            towards +y; the opposite torque acts on its second spring. It is positive where stiffness and
            damping reduce the angle, like the quantity `jointN.torque`.
    """

    forces: NDArray[np.float64]
    torques: NDArray[np.float64]


class LoadCalculator:
    """Computes loads from the tables of a body, which it only reads.

    Args:
        scene, system, state: of the simulation; the tables are those without broken parts.
    """

    def __init__(self, scene: Scene, system: System, state: State) -> None:
        self.system = system
        self._scene = scene
        # The clock of the state is at the last force evaluation of a step, so it is replaced.
        self._state = state.replaced(clock=np.zeros(1))
        self._physics = Physics(system.body, self._state)

    def loads(self, time: float) -> Loads:
        """Return the loads in the current state, at a time (s)."""
        state, physics = self._state, self._physics
        state.clock[0] = time
        x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
        # The state has no weight for held masses, so that of all masses is computed here.
        weight = self.system.body.environment.mass * complex(*self._scene.gravity)
        net = (physics.forces(x, v) + weight)[self.system.mass_index]
        if self.system.loads is not None:
            net += (self.system.loads[0] + 1j * self.system.loads[1])[self.system.mass_index - 1]
        torques = JointsReference(self.system.body, state).torques(x, v)[self.system.joint_order]
        return Loads(np.column_stack((net.real, net.imag)), torques)
