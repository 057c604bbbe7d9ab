"""The decay of vibrations that damping may couple with each other.

With shapes w_i of unit modal mass, the small motions of a damped body are q'' + C q' + Ω² q = 0, where C is
the modal damping matrix. Only where C is diagonal does a vibration keep its shape as it decays. The decay
rate is therefore defined by the energy: the body at rest is struck so that it moves in the shape w_i, and

    r = 1 / (2 ∫ E(t) / E(0) dt),

where E is the energy of all vibrations. For an uncoupled vibration this is c / 2, for any damping c,
including supercritical damping: it is the rate of exp(-r t). With y = (Ω q, q'), E is |y|² / 2, and the
integral is the trace of the solution X of the Lyapunov equation A X + X Aᵀ = -y(0) y(0)ᵀ.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from ..engine.tables import Floats
from .vibrations import Vibrations

TENTH = math.log(10.0)
"""Time for an amplitude to fall to a tenth, times its decay rate."""

COUPLED = 60
"""Number of vibrations, those nearest in frequency, that are assumed to be coupled with one. Halved,
`test_a_blow_fades_as_the_tuning_says_where_damping_couples` fails."""

# Unless noted, doubling or halving one of these numbers fails no test.
_COUPLES = 1e-6
"""Damping between two vibrations, relative to that of one of them, up to which they count as uncoupled."""

_SLOWLY = 1e-4
"""Decay rate added to everything in the integral, relative to that of the vibration by itself. It discards
energy that remains in other, undamped vibrations, as long as it is less than about this fraction."""


class Drag(Protocol):
    """Whatever damps small vibrations, such as `tuning.Dampers`."""

    def drag(self, shape: Floats, springs: Floats | None = None, joints: Floats | None = None) -> Floats:
        """Return the (n, 2) damping forces opposing the velocities `shape`, kg/s times these.

        Args:
            shape: (n, 2) velocities, of any scale.
            springs, joints: (S,) and (J,) damping of each, kg/s; None for none.
        """
        ...


class Decay:
    """The decay of a body's vibrations.

    Args:
        dampers: the dampers.
        found: vibrations about the same pose.
        masses: (n,) kg.

    Attributes:
        omega: (k,) their angular frequencies, rad/s.
        shapes: (k, n, 2) of unit modal mass.
    """

    def __init__(self, dampers: Drag, found: Vibrations, masses: Floats) -> None:
        self.omega = found.omega
        sizes = np.sqrt((masses[:, None] * found.shapes**2).sum((1, 2)))
        self.shapes = found.shapes / sizes[:, None, None]
        self._dampers = dampers

    def between(self, springs: Floats | None = None, joints: Floats | None = None) -> Floats:
        """Return the (k, k) damping between each two vibrations, 1/s; arguments as for `Drag.drag`."""
        drags = np.array([self._dampers.drag(shape, springs, joints) for shape in self.shapes])
        return np.einsum("iab,jab->ij", self.shapes, drags)

    def rate(self, damping: Floats, index: int) -> float:
        """Return the rate, 1/s, at which a vibration's amplitude decays; 0 where it is undamped.

        Args:
            damping: (k, k) as from `between`.
            index: index of the vibration.
        """
        from scipy.linalg import solve_continuous_lyapunov

        near = np.sort(np.argsort(np.abs(self.omega - self.omega[index]))[:COUPLED])
        omega, c = np.diag(self.omega[near]), damping[np.ix_(near, near)]
        own = int(np.searchsorted(near, index))
        alone = 0.5 * float(c[own, own])
        if alone <= 1e-12 * self.omega[index]:
            return max(alone, 0.0)
        others = np.delete(c[own], own)
        if np.abs(others).max(initial=0.0) <= _COUPLES * alone:
            return alone
        count = near.size
        slowly = _SLOWLY * alone
        a = np.block([[-slowly * np.eye(count), omega], [-omega, -c - slowly * np.eye(count)]])
        struck = np.zeros((2 * count, 1))
        struck[count + own] = 1.0
        lifetime = float(np.trace(solve_continuous_lyapunov(a, -struck @ struck.T)))
        return max(0.5 / lifetime - slowly, 0.0) if lifetime > 0.0 else alone

    def rates(self, springs: Floats, joints: Floats) -> Floats:
        """Return the (k,) decay rates of all vibrations, 1/s; arguments as for `Drag.drag`."""
        damping = self.between(springs, joints)
        return np.array([self.rate(damping, i) for i in range(self.omega.size)])
