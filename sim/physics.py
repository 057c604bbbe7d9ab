"""The physics of softrod in NumPy. Start reading here.

A body consists of point masses, linear springs between two masses, and angular springs ("joints"), each of
which holds two linear springs at an angle. This module computes their forces for any body and every force
law, in as few lines as possible, and adds what the terms of `sim.forces.all` do, each of which has such a
twin on its page. It needs no compiler: the page uses it until the compiled kernels are ready, and the tests
compare every kernel with it.

A vector (x, y) is the complex number x + iy. The length of a vector is `abs`, and rotating it by an angle r
multiplies it by exp(ir). For two vectors A and B, conj(A) B = A . B + i (A x B) = |A||B| exp(iV), where V is
the angle from A to B. For a joint with the rest angle r, everything follows from S = conj(A) B exp(-ir): its
argument is the deflection V - r, its modulus is |A||B|, and its imaginary part is |A||B| sin(V - r), which
needs no trigonometric function.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .forces.all import TERMS, WITH_ENERGY
from .forces.joints import ANGLE, CONSERVATIVE, NO_JOINTS, TUTORIAL
from .forces.term import Floats, Vectors
from .kernels.core.tables import Body, State

SHORTEST = 1e-150
"""Lower bound, px, of a spring's length where something is divided by it."""


def sine_law(s: Vectors) -> tuple[Floats, Floats]:
    """The torque |A||B| sin(V - r), and the energy |A||B| (1 - cos(V - r)) of which it is the gradient."""
    return s.imag, abs(s) - s.real


def angle_law(s: Vectors) -> tuple[Floats, Floats]:
    """The torque |A||B| (V - r), and the energy |A||B| (V - r)² / 2."""
    deflection = np.angle(s)
    return abs(s) * deflection, 0.5 * abs(s) * deflection**2


LAWS: dict[int, Callable[[Vectors], tuple[Floats, Floats]]] = {
    NO_JOINTS: sine_law,
    TUTORIAL: sine_law,
    CONSERVATIVE: sine_law,
    ANGLE: angle_law,
}
"""Torque and energy of a joint of stiffness one, by `Body.law`. The tutorial's law has the torque of the sine
law without the pull along the springs that would make it the gradient of an energy."""


class Physics:
    """The forces on a body's masses.

    The masses are at indices 1 to n of the arrays; the other slots are padding, see
    `sim.kernels.core.tables`.

    Args:
        body: the springs and joints, and which masses they connect.
        state: the present rest lengths and rest angles, and what acts on each mass besides its springs.
    """

    def __init__(self, body: Body, state: State) -> None:
        self._law, self._has_energy = LAWS[body.law], body.law != TUTORIAL
        springs, joints = slice(body.springs), slice(1, body.joints + 1)
        self.a, self.b = body.spring_a, body.spring_b  # (S,) masses at the ends of each spring
        self.stiffness = body.stiffness[springs]  # (S,) kg/s²
        self.damping = body.damping[springs]  # (S,) kg/s
        self.rest_tension = state.rest_tension[springs]  # (S,) stiffness * rest length, kg px/s²
        self.first, self.second = body.joint_a, body.joint_b  # (J,) springs of each joint
        self.joint_stiffness = body.torque_size[joints]  # (J,) kg/s²
        self.joint_damping = body.torque_damping[joints]  # (J,) kg/s
        self.rest_angle = state.torque_rest[joints]  # (J,) radians
        self.state = state
        # By their names; each adds its forces.
        self.terms = {term.name: term.twin(body, state) for term in TERMS}
        self._ends = np.concatenate((self.b, self.a))

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) all forces but gravity at positions x (px) and velocities v (px/s), kg px/s²."""
        return sum((term.forces(x, v) for term in self.terms.values()), self.spring_forces(x, v))

    def spring_forces(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) those of springs and joints alone."""
        spring, rate = x[self.b] - x[self.a], v[self.b] - v[self.a]
        square = np.maximum(abs(spring), SHORTEST) ** 2
        # Of a spring with the vector L: -stiffness (|L| - rest) L/|L| - damping (L . dL/dt) L/|L|².
        along = (rate * spring.conj()).real / square
        tension = (self.rest_tension / np.sqrt(square) - self.stiffness - self.damping * along) * spring
        if self.first.size:
            torque, energy = self._bending(spring, rate, square)
            # The torque turns both springs towards the rest angle. The energy grows with both lengths, so its
            # gradient also pulls along them.
            turned = spring / square
            np.add.at(tension, self.first, (1j * torque - energy) * turned[self.first])
            np.add.at(tension, self.second, (-1j * torque - energy) * turned[self.second])
        return self._sum(np.concatenate((tension, -tension)), x.size)

    def torques(self, x: Vectors, v: Vectors) -> Floats:
        """(J,) the torque of each joint, kg px²/s²: on its first spring; minus it acts on the second one."""
        spring, rate = x[self.b] - x[self.a], v[self.b] - v[self.a]
        return self._bending(spring, rate, np.maximum(abs(spring), SHORTEST) ** 2)[0]

    def accelerations(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) px/s²; zero where a mass is held."""
        state = self.state
        return self.forces(x, v) * state.inverse_mass + (state.gx + 1j * state.gy)

    def energies(self, x: Vectors) -> dict[str, float]:
        """Energies of linear and of angular springs and of all terms, kg px²/s², by their names.

        The tutorial's law uses the sine law's.
        """
        spring = x[self.b] - x[self.a]
        pulls = self.stiffness > 0.0
        rest = self.rest_tension[pulls] / self.stiffness[pulls]
        linear = 0.5 * float((self.stiffness[pulls] * (abs(spring[pulls]) - rest) ** 2).sum())
        s = spring[self.first].conj() * spring[self.second] * np.exp(-1j * self.rest_angle)
        angular = float((self.joint_stiffness * self._law(s)[1]).sum())
        others = {term.name: self.terms[term.name].energy(x) for term in WITH_ENERGY}
        return {"linear": linear, "angular": angular, **others}

    def _bending(self, spring: Vectors, rate: Vectors, square: Floats) -> tuple[Floats, Floats]:
        """(J,) torques and energies of the joints; the energy of a law without one is zero."""
        one, other = spring[self.first], spring[self.second]
        torque, energy = self._law(one.conj() * other * np.exp(-1j * self.rest_angle))
        torque, energy = self.joint_stiffness * torque, self.joint_stiffness * energy
        turning = (rate * spring.conj()).imag / square  # rate at which each spring turns, 1/s
        bending = turning[self.second] - turning[self.first]  # dV/dt
        torque = torque + self.joint_damping * abs(one) * abs(other) * bending
        return torque, energy if self._has_energy else 0.0 * energy

    def _sum(self, at_ends: Vectors, slots: int) -> Vectors:
        """Sum the forces on both ends of the springs by mass."""
        x, y = (np.bincount(self._ends, part, slots) for part in (at_ends.real, at_ends.imag))
        return x + 1j * y


def euler_step(physics: Physics, x: Vectors, v: Vectors, h: float) -> tuple[Vectors, Vectors]:
    """A step of h seconds of symplectic Euler, the tutorial's method: first velocities, then positions."""
    v = v + h * physics.accelerations(x, v)
    return x + h * v, v


def verlet_step(
    physics: Physics, x: Vectors, v: Vectors, a: Vectors, h: float, lead: Callable[[Vectors, Vectors], None]
) -> tuple[Vectors, Vectors, Vectors]:
    """A step of h seconds of velocity Verlet.

    Args:
        a: accelerations at the start of the step. Forces at its end use v + h a as the velocity.
        lead: moves the led masses, in positions and velocities, to where they are at the end of the step.
    """
    x, expected = x + h * v + 0.5 * h * h * a, v + h * a
    lead(x, expected)
    after = physics.accelerations(x, expected)
    return x, v + 0.5 * h * (a + after), after
