"""A scene of masses and springs as plain equations of motion, which know nothing of softrod's kernels.

The state y has x, y, vx, vy of one mass after the other, px and px/s; those of held masses stand still in it,
and are put where they are at a time by `place_held`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numba
import numpy as np
from numpy.typing import NDArray

from sim import Scene

Floats = NDArray[np.float64]


@numba.njit
def circle_at(t, radius, frequency, ramp):
    """Displacement and velocity of an anchor on a circle: x, y, vx, vy."""
    gone = -math.expm1(-t / ramp)
    p, rate = 2.0 * math.pi * frequency * (t - ramp * gone), 2.0 * math.pi * frequency * gone
    sine, cosine = math.sin(p), math.cos(p)
    return radius * sine, radius * (1.0 - cosine), radius * rate * cosine, radius * rate * sine


@numba.njit
def _derivative(y, out, lead, springs, numbers, weights, gravity):
    """dy/dt into `out`; `lead` is x, y, vx, vy of mass 0 where it is led, else empty."""
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


@numba.njit
def _jacobian(y, out, lead, springs, numbers, weights):
    """Derivatives of both ends' accelerations: (springs, 4, 2, 4) by end and other end, component, unknown.

    The pairs are (a by a), (a by b), (b by a), (b by b).
    """
    for s in range(springs.shape[0]):
        a, b = springs[s, 0], springs[s, 1]
        at = y[4 * a : 4 * a + 4]
        if a == 0 and lead.size:
            at = lead
        to = y[4 * b : 4 * b + 4]
        lx, ly, du, dw = to[0] - at[0], to[1] - at[1], to[2] - at[2], to[3] - at[3]
        length = math.sqrt(lx * lx + ly * ly)
        u = (lx / length, ly / length)
        rate = u[0] * du + u[1] * dw
        k, c = numbers[s, 0], numbers[s, 1]
        turn = (du - rate * u[0], dw - rate * u[1])  # relative velocity across the spring
        across = (k * (length - numbers[s, 2]) + c * rate) / length
        for i in range(2):
            for j in range(2):
                along = u[i] * u[j]
                other = (1.0 if i == j else 0.0) - along
                by_place = k * along + across * other + c * u[i] * turn[j] / length
                by_speed = c * along
                for pair in range(4):
                    w = weights[a] if pair < 2 else weights[b]
                    sign = -1.0 if pair in (0, 3) else 1.0
                    out[s, pair, i, j] = sign * w * by_place
                    out[s, pair, i, 2 + j] = sign * w * by_speed


class Equations:
    """dy/dt = f(t, y) of a scene.

    Args:
        scene: a valid scene of masses and linear springs alone, whose first spring mass may be led.

    Attributes:
        springs: (m, 2) the masses of each.
        numbers: (m, 3) stiffness kg/s², damping kg/s, rest length px.
        masses: (n,) kg.
        held: (n,) whether it is held.
        gravity: (2,) px/s².
        circle: radius px, frequency Hz and ramp s of mass 0, or None.
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
        self.lead_at(0.0)  # machine code

    def lead_at(self, t: float) -> Floats:
        """x, y, vx, vy of the led mass at a time; empty where none is led."""
        if self.circle is None:
            return self._nowhere
        lead = np.array(circle_at(t, *self.circle))
        lead[:2] += self.start[:2]
        return lead

    def derivative(self, t: float, y: Floats) -> Floats:
        """dy/dt."""
        out = np.empty(y.size)
        self.derivative_into(t, y, out)
        return out

    def derivative_into(self, t: float, y: Floats, out: Floats) -> None:
        """dy/dt into `out`."""
        lead = self.lead_at(t)
        _derivative(y, out, lead, self.springs, self.numbers, self._weights, self.gravity)

    def jacobian(self) -> Callable[[float, Floats], object]:
        """A function (t, y) that returns the Jacobian of `derivative` as a sparse matrix in columns."""
        from scipy.sparse import csc_matrix

        m, size = len(self.springs), self.start.size
        a, b = self.springs.T
        ends = np.stack(
            (np.stack((a, a), 1), np.stack((a, b), 1), np.stack((b, a), 1), np.stack((b, b), 1)), 1
        )
        row = (4 * ends[:, :, 0])[:, :, None, None] + np.array([2, 3])[:, None] + np.zeros(4, int)
        column = (4 * ends[:, :, 1])[:, :, None, None] + np.zeros((2, 1), int) + np.arange(4)
        free = np.flatnonzero(~self.held)
        moves = (4 * free[:, None] + np.array([0, 1])).ravel()
        ones = np.ones(moves.size)
        rows, columns = np.concatenate((row.ravel(), moves)), np.concatenate((column.ravel(), moves + 2))
        # Of held masses, nothing depends on their unknowns, which stand still.
        fixed = np.repeat(self.held, 4)[columns]
        keys, place = np.unique(columns * size + rows, return_inverse=True)
        pattern = keys % size, np.searchsorted(keys // size, np.arange(size + 1))
        blocks = np.empty((m, 4, 2, 4))

        def function(t: float, y: Floats) -> object:
            _jacobian(y, blocks, self.lead_at(t), self.springs, self.numbers, self._weights)
            values = np.concatenate((blocks.ravel(), ones))
            values[fixed] = 0.0
            return csc_matrix((np.bincount(place, values), *pattern), (size, size))

        return function

    def positions(self, t: float, y: Floats) -> Floats:
        """(n, 2) where the masses are at a time, px."""
        found = y.reshape(-1, 4)[:, :2].copy()
        if self.circle is not None:
            found[0] = self.lead_at(t)[:2]
        return found
