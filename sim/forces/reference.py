"""The physics of softrod in NumPy. Start reading here.

A body consists of point masses, linear springs between two masses, and angular springs ("joints"), each of
which holds two linear springs at an angle. Air, walls, gases and liquids, and contact act on it, too: the
terms of `sim.forces.all`. Each of them has a page in `sim.forces`, whose last part computes its force and its
energy in NumPy, for any body, in as few lines as possible. This module adds them up. It needs no compiler:
the page uses it until the compiled kernels are ready, and the tests compare every kernel with it.

A vector (x, y) is the complex number x + iy. The length of a vector is `abs`, and rotating it by an angle r
multiplies it by exp(ir). For two vectors A and B, conj(A) B = A . B + i (A x B) = |A||B| exp(iV), where V is
the angle from A to B. For a joint with the rest angle r, everything follows from S = conj(A) B exp(-ir): its
argument is the deflection V - r, its modulus is |A||B|, and its imaginary part is |A||B| sin(V - r), which
needs no trigonometric function.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..engine.tables import Body, State
from .all import TERMS, WITH_ENERGY
from .rails import along_rails
from .term import Bracing, Sticking, Vectors


class Physics:
    """The forces on a body's masses.

    The masses are at indices 1 to n of the arrays; the other slots are padding, see
    `sim.engine.tables`.

    Args:
        body: the springs and joints, and which masses they connect.
        state: the present rest lengths and rest angles, and what acts on each mass besides its springs.

    Attributes:
        terms: the reference of each force, by name.
    """

    def __init__(self, body: Body, state: State) -> None:
        self._body, self._state = body, state
        self.terms = {term.name: term.reference(body, state) for term in TERMS}
        self._sticking = [term for term in self.terms.values() if isinstance(term, Sticking)]
        acting = [self.terms[TERMS[index].name] for index in body.environment.acting]
        self._bracing = [term for term in acting if isinstance(term, Bracing)]

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) all forces but gravity at positions x (px) and velocities v (px/s), kg px/s²."""
        return sum((term.forces(x, v) for term in self.terms.values()), np.zeros_like(x))

    def accelerations(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) px/s²; zero where a mass is held."""
        state = self._state
        free = self.forces(x, v) * state.inverse_mass + (state.gx + 1j * state.gy)
        return along_rails(self._body, free)

    def energies(self, x: Vectors) -> dict[str, float]:
        """Energies of all forces that have one, kg px²/s², by their names."""
        return {term.name: self.terms[term.name].energy(x) for term in WITH_ENERGY}

    def brace(self, x: Vectors) -> None:
        """Let springs and joints of one side act on both, and motors as at their speeds, since they may soon.

        Those that do not act at positions x (px) do so as if at rest there.
        """
        for term in self._bracing:
            term.brace(x)

    def update_friction_history(self, x: Vectors, v: Vectors) -> None:
        """Update the tangential springs after a step to positions x with velocities v."""
        for term in self._sticking:
            term.update_friction_history(x, v)


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
