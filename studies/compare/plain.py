"""A scene of masses and springs as plain equations of motion, which share no code with softrod's kernels.

The state y holds x, y, vx, vy of one mass after the other, px and px/s; those of held masses do not change.
"""

from __future__ import annotations

import math

import numba
import numpy as np

from sim import Scene

from .runs import Floats


@numba.njit
def circle_at(t, radius, frequency, ramp):
    """Return displacement and velocity of an anchor on a circle: x, y, vx, vy."""
    gone = -math.expm1(-t / ramp)
    p, rate = 2.0 * math.pi * frequency * (t - ramp * gone), 2.0 * math.pi * frequency * gone
    sine, cosine = math.sin(p), math.cos(p)
    return radius * sine, radius * (1.0 - cosine), radius * rate * cosine, radius * rate * sine


@numba.njit
def _derivative(y, out, lead, springs, numbers, weights, gravity):
    """Write dy/dt into `out`; `lead` is x, y, vx, vy of mass 0 where it is led, else empty."""
    n = weights.size
    for i in range(n):
        out[4 * i], out[4 * i + 1] = y[4 * i + 2], y[4 * i + 3]
        out[4 * i + 2] = out[4 * i + 3] = 0.0
    for s in range(springs.shape[0]):
        a, b = 4 * springs[s, 0], 4 * springs[s, 1]
        ax, ay, avx, avy = y[a], y[a + 1], y[a + 2], y[a + 3]
        if a == 0 and lead.size:
            ax, ay, avx, avy = lead[0], lead[1], lead[2], lead[3]
        lx, ly = y[b] - ax, y[b + 1] - ay
        length = math.sqrt(lx * lx + ly * ly)
        ux, uy = lx / length, ly / length
        rate = ux * (y[b + 2] - avx) + uy * (y[b + 3] - avy)
        force = numbers[s, 0] * (length - numbers[s, 2]) + numbers[s, 1] * rate
        out[a + 2] += force * ux
        out[a + 3] += force * uy
        out[b + 2] -= force * ux
        out[b + 3] -= force * uy
    for i in range(n):
        if weights[i] == 0.0:  # held
            out[4 * i : 4 * i + 4] = 0.0
        else:
            out[4 * i + 2] = out[4 * i + 2] * weights[i] + gravity[0]
            out[4 * i + 3] = out[4 * i + 3] * weights[i] + gravity[1]


class PlainSystem:
    """The numbers of a scene, and its equations dy/dt = f(t, y).

    Args:
        scene: a valid scene of masses and linear springs alone, whose first mass may be led in a circle.

    Attributes:
        springs: (m, 2) masses of each spring.
        numbers: (m, 3) stiffness kg/s², damping kg/s, rest length px.
        masses: (n,) kg.
        held: (n,) whether a mass is held.
        gravity: (2,) px/s².
        circle: radius (px), frequency (Hz) and ramp (s) of mass 0, or None.
        start: (4 n,) the state at time 0.
    """

    def __init__(self, scene: Scene) -> None:
        self.springs = np.array([(s.a, s.b) for s in scene.linear_springs])
        self.numbers = np.array([(s.stiffness, s.damping, s.rest_length) for s in scene.linear_springs])
        self.masses = np.array([mass.mass for mass in scene.masses])
        self.held = np.zeros(self.masses.size, bool)
        self.held[[anchor.mass for anchor in scene.anchors]] = True
        self.gravity = np.array(scene.gravity)
        circles = [anchor.circle for anchor in scene.anchors if anchor.circle is not None]
        self.circle = (circles[0].radius, circles[0].frequency, circles[0].ramp) if circles else None
        self.start = np.array([(*mass.position, *mass.velocity) for mass in scene.masses]).ravel()
        self._weights = np.where(self.held, 0.0, 1.0 / self.masses)
        self._nowhere = np.empty(0)
        self.lead_at(0.0)  # loads machine code

    def lead_at(self, t: float) -> Floats:
        """Return x, y, vx, vy of the led mass at a time; empty where none is led."""
        if self.circle is None:
            return self._nowhere
        lead = np.array(circle_at(t, *self.circle))
        lead[:2] += self.start[:2]
        return lead

    def derivative(self, t: float, y: Floats) -> Floats:
        """Return dy/dt."""
        out = np.empty(y.size)
        self.derivative_into(t, y, out)
        return out

    def derivative_into(self, t: float, y: Floats, out: Floats) -> None:
        """Write dy/dt into `out`."""
        lead = self.lead_at(t)
        _derivative(y, out, lead, self.springs, self.numbers, self._weights, self.gravity)

    def positions(self, t: float, y: Floats) -> Floats:
        """Return the (n, 2) positions of all masses, px."""
        found = y.reshape(-1, 4)[:, :2].copy()
        if self.circle is not None:
            found[0] = self.lead_at(t)[:2]
        return found
