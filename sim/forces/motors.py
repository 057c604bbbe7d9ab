"""Motors, which turn the second spring of a joint against the first.

With the rate V' of the joint's angle, the wanted rate w, the slip s and the largest torque T, the torque on
the second spring is t = T tanh((w - V') / s), and -t on the first: nearly T far below the wanted rate, and a
brake above it. A torque t on a spring with the vector L is a pair of forces, t n on its b end and -t n on its
a end, where n = (-L.y, L.x) / |L|². So with V' = n_B . B' - n_A . A' for the second spring B and the first A,
the power of a motor is t V', its derivatives are those of t n, and dt/dV' = -(T - t² / T) / s.

The wanted rate of a motor that is steered by keys has the sign of `State.steer`: it holds still where that is
0.
"""

from __future__ import annotations

import math

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.blocks import add_block
from ..engine.numerics.tanhs import tanh
from ..engine.numerics.vectors import from_to
from ..engine.table import Indices, Rows, Table
from ..engine.tables import SHORTEST_SQUARED, Body, State
from ..scene.columns import is_set_in_any
from ..scene.types import Scene
from .muscles import steer_of
from .term import Floats, Places, Term, Vectors, summed


class Motors(Table):
    """Read-only. M motors."""

    joint: Indices  # (M,) numbers in the tables
    rows: Rows  # (M, 3) wanted rate, radians/s, largest torque, kg px²/s², and slip, radians/s
    steer: Indices  # (M,) index in `State.steer`, -1 for a motor that always turns


NO_MOTORS = Motors.empty().replaced(rows=np.zeros((0, 3))).read_only()


def has_motors(scene: Scene) -> bool:
    """Whether a valid scene has motors."""
    return is_set_in_any(scene.angular_springs, "motor")


def new_motors(scene: Scene, places: Places) -> Motors:
    """The table of a valid scene."""
    if not has_motors(scene):
        return NO_MOTORS
    row = np.empty(places.joint_order.size, np.int64)
    row[places.joint_order] = np.arange(row.size)
    turning = [(int(row[j]), each.motor) for j, each in enumerate(scene.angular_springs) if each.motor]
    turning.sort(key=lambda each: each[0])
    rows = [(math.radians(m.speed), m.torque, math.radians(m.slip)) for _, m in turning]
    return Motors(
        joint=np.array([j for j, _ in turning]),
        rows=np.array(rows, float),
        steer=np.array([steer_of(m.keys) for _, m in turning]),
    )


def stopped(motors: Motors, loose: np.ndarray) -> Motors:
    """The table without the torques of some joints; `loose`: (J,) whether each is one of them."""
    rows = motors.rows.copy()
    rows[loose[motors.joint], 1] = 0.0
    return motors.replaced(rows=rows)


@kernel(forceinline=True, fastmath=FAST)
def _arm(body, q, s):
    """n of a spring, 1/px."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    inverse = 1.0 / (x * x + y * y + SHORTEST_SQUARED)
    return -y * inverse, x * inverse


@kernel(forceinline=True, fastmath=FAST)
def _turning(body, state, q, v, k):
    """The k-th motor: its springs A and B, n of both, the rate V', the torque t, and -dt/dV'."""
    motors = body.environment.motors
    j = motors.joint[k]
    a, b = body.joint_a[j], body.joint_b[j]
    ax, ay = _arm(body, q, a)
    bx, by = _arm(body, q, b)
    au, av = from_to(v, body.spring_a[a], body.spring_b[a])
    bu, bv = from_to(v, body.spring_a[b], body.spring_b[b])
    rate = bx * bu + by * bv - ax * au - ay * av
    way = 1.0 if motors.steer[k] < 0 else state.steer[motors.steer[k]]
    part = tanh((way * motors.rows[k, 0] - rate) / motors.rows[k, 2])
    most = motors.rows[k, 1]
    return a, b, (ax, ay), (bx, by), rate, most * part, most * (1.0 - part * part) / motors.rows[k, 2]


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    for k in range(body.environment.motors.joint.size):
        a, b, of_a, of_b, _, torque, _ = _turning(body, state, q, v, k)
        for spring, (x, y), t in ((a, of_a, -torque), (b, of_b, torque)):
            start, end = body.spring_a[spring], body.spring_b[spring]
            scratch.fx[end] += t * x
            scratch.fy[end] += t * y
            scratch.fx[start] -= t * x
            scratch.fy[start] -= t * y


@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    power = 0.0
    for k in range(body.environment.motors.joint.size):
        _, _, _, _, rate, torque, _ = _turning(body, state, q, v, k)
        power += torque * rate
    balance.work.motors += part * power


@kernel(forceinline=True, fastmath=FAST)
def _bend(body, q, v, s, n):
    """How n of a spring changes with its vector, (xx, xy, yx, yy), 1/px²; and the gradient of n . L' by the
    vector, 1/(px s)."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    inverse, (nx, ny) = 1.0 / (x * x + y * y + SHORTEST_SQUARED), n
    change = (
        -2.0 * nx * x * inverse,
        -inverse - 2.0 * nx * y * inverse,
        inverse - 2.0 * ny * x * inverse,
        -2.0 * ny * y * inverse,
    )
    return change, (change[0] * u + change[2] * w, change[1] * u + change[3] * w)


@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    for k in range(body.environment.motors.joint.size):
        a, b, of_a, of_b, _, torque, resists = _turning(body, state, q, v, k)
        i = 16 * body.environment.motors.joint[k]
        for row, n, sign in ((a, of_a, -1.0), (b, of_b, 1.0)):
            for column, m, other in ((a, of_a, -1.0), (b, of_b, 1.0)):
                change, by_vector = _bend(body, q, v, column, m)
                x, y = g * m[0], g * m[1]
                if not definite:
                    x, y = x + by_vector[0], y + by_vector[1]
                factor = -resists * sign * other
                xx, xy, yx, yy = factor * n[0] * x, factor * n[0] * y, factor * n[1] * x, factor * n[1] * y
                if row == column and not definite:
                    t = sign * torque
                    xx, xy, yx, yy = (
                        xx + t * change[0], xy + t * change[1], yx + t * change[2], yy + t * change[3],
                    )  # fmt: skip
                for e, way in enumerate((1.0, -1.0, -1.0, 1.0)):
                    add_block(matrix.blocks, matrix.joint_target[i + e], way, (xx, xy, yx, yy))
                i += 4


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    w, slots = state.inverse_mass, z.size // 2
    for k in range(body.environment.motors.joint.size):
        a, b, of_a, of_b, _, _, resists = _turning(body, state, q, v, k)
        au, av = from_to(z, body.spring_a[a], body.spring_b[a])
        bu, bv = from_to(z, body.spring_a[b], body.spring_b[b])
        change = -factor * resists * (of_b[0] * bu + of_b[1] * bv - of_a[0] * au - of_a[1] * av)
        for spring, (x, y), t in ((a, of_a, -change), (b, of_b, change)):
            start, end = body.spring_a[spring], body.spring_b[spring]
            out[end] += w[end] * t * x
            out[slots + end] += w[end] * t * y
            out[start] -= w[start] * t * x
            out[slots + start] -= w[start] * t * y


def _bounds(body: Body) -> tuple[Floats, Floats]:
    """See `Term.bounds`, at rest lengths."""
    motors, damped = body.environment.motors, np.zeros(body.masses + 1)
    for j, (_, torque, slip) in zip(motors.joint, motors.rows, strict=True):
        springs = np.array((body.joint_a[j], body.joint_b[j]))
        per_length = 1.0 / np.maximum(body.rest_length[springs], 1e-3)
        for spring, each in zip(springs, per_length, strict=True):
            ends = [body.spring_a[spring], body.spring_b[spring]]
            damped[ends] += 2.0 * torque / slip * each * float(per_length.sum())
    return np.zeros(body.masses), damped[1:]


# ------------------------------------------------------------------------- in NumPy
class MotorsReference:
    """Motors in NumPy; see `Reference`."""

    def __init__(self, body: Body, state: State) -> None:
        self._motors, self._state, joint = body.environment.motors, state, body.environment.motors.joint
        springs = np.stack((body.joint_a[joint], body.joint_b[joint]))
        self._start, self._end = body.spring_a[springs], body.spring_b[springs]  # (2, M)
        self._at_speed = False

    def torques(self, x: Vectors, v: Vectors) -> Floats:
        """(M,) kg px²/s², on the second springs."""
        speed, torque, slip = self._motors.rows.T
        arm, rate = self._arms(x), v[self._end] - v[self._start]
        of_each = (arm.conj() * rate).real
        way = np.where(self._motors.steer < 0, 1.0, self._state.steer[np.maximum(self._motors.steer, 0)])
        turning = of_each[1] - of_each[0]
        if self._at_speed:
            return -torque * turning / slip
        return torque * np.tanh((way * speed - turning) / slip)

    def brace(self, x: Vectors) -> None:
        """See `Bracing`: a motor far below its speed pulls evenly, and holds fast once it is there."""
        self._at_speed = True

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        pairs = self.torques(x, v) * self._arms(x)
        pairs[0] *= -1.0
        ends = np.concatenate((self._end.ravel(), self._start.ravel()))
        return summed(ends, np.concatenate((pairs.ravel(), -pairs.ravel())), x.size)

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return 0.0

    def _arms(self, x: Vectors) -> Vectors:
        vector = x[self._end] - x[self._start]
        return 1j * vector / (np.abs(vector) ** 2 + SHORTEST_SQUARED)


MOTORS = Term(
    "motors",
    has_motors,
    MotorsReference,
    _add_forces,
    field="motors",
    table=Motors,
    new=new_motors,
    label="motors",
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    bounds=_bounds,
)
