"""Joints, which hold two springs at an angle: force laws, torque, energy, power, derivatives.

Let V be the angle from spring A to spring B, r the rest angle and V - r the deflection. A joint has the
torque K |A||B| f(V - r). If the law has an energy, that is K |A||B| F(V - r), where f is the derivative of F.
Since the energy grows with the lengths of the springs, there is then also a pull along them.

A law is a row in `LAWS` and a case in `terms`; all kernels read it from there. The two sine laws need no
trigonometric functions, since |A||B| sin(V - r) and |A||B| cos(V - r) are products of the vectors. Kernels
have this algebra for them as well, and the tests compare it with `terms`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.blocks import add_block, from_left, minus, outer, plus, scaled
from ..engine.numerics.vectors import deflection, from_to, inverse_of, length_of
from ..engine.table import Floats, Indices
from ..engine.tables import SHORTEST_SQUARED, Body, State
from .term import Vectors, summed

NO_JOINTS, TUTORIAL, CONSERVATIVE, ANGLE = 0, 1, 2, 3
"""Values of `Body.law`: a body without joints, and the three force laws."""


_HALVINGS = 50
"""Number of halvings in `deflection_at`: to rounding. Doubled or halved, no test fails."""


class Law(NamedTuple):
    """Properties of a law, apart from its terms."""

    code: int  # in `Body.law`
    label: str  # for people


LAWS = {
    "tutorial": Law(TUTORIAL, "Tutorial"),
    "conservative": Law(CONSERVATIVE, "Conservative"),
    "angle": Law(ANGLE, "Angle law"),
}
"""The laws, by their names in scenes."""


@kernel(forceinline=True, fastmath=FAST)
def terms(law, deflection):
    """f, F and f' at a deflection (radians): torque, energy and stiffness for K |A||B| = 1.

    The energy of the tutorial's law is that of the conservative one, though its torque is not the gradient
    of that. NaN for an unknown law.
    """
    if law == ANGLE:
        return deflection, 0.5 * deflection * deflection, 1.0
    if law in (TUTORIAL, CONSERVATIVE):
        half = math.sin(0.5 * deflection)
        return math.sin(deflection), 2.0 * half * half, math.cos(deflection)
    return np.nan, np.nan, np.nan


SINE_LAWS = (TUTORIAL, CONSERVATIVE, NO_JOINTS)
"""The laws whose torque is the sine of the deflection; and a body without joints."""


@kernel(forceinline=True)
def is_sine(law):
    """Whether a law's torque is the sine of the deflection, or there are no joints."""
    return law in SINE_LAWS


@kernel(fastmath=FAST)
def deflection_at(law, torque, most):
    """The deflection between 0 and `most` (radians) at which a law reaches a torque, for K |A||B| = 1.

    By bisection, from the law's terms. The torque must be passed between 0 and `most`.
    """
    low, high = 0.0, most
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if abs(terms(law, middle)[0]) < torque:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@kernel(forceinline=True, fastmath=FAST)
def bend(law, spring_a, spring_b, cos, sin, size, rest, soft):
    """The forces of a joint on the b ends of its springs A and B: x and y of one, and of the other; kg px/s².

    Under the conservative law K R(-r) B - K |B| A / |A| and K R(r) A - K |A| B / |B|, the gradient without
    the difference of large numbers; under others those of the torque, and of the energy if there is one, as
    `springs` says.

    Args:
        law: as in `Body.law`.
        spring_a, spring_b: the vector of a spring, px, and 1 / its length.
        cos, sin, size: the stiffness, times the cosine and the sine of the rest angle; and itself, kg/s².
        rest: rest angle, radians.
        soft: see `Body.softening`, px².
    """
    (ax, ay, inv_a), (bx, by, inv_b) = spring_a, spring_b
    if law == CONSERVATIVE:
        both = size * (inv_a * inv_b)
        by_a, by_b = both * (bx * bx + by * by + soft), both * (ax * ax + ay * ay + soft)
        on_ax, on_ay = cos * bx + sin * by - by_a * ax, cos * by - sin * bx - by_a * ay
        return on_ax, on_ay, cos * ax - sin * ay - by_b * bx, cos * ay + sin * ax - by_b * by
    if law == TUTORIAL:
        torque = cos * (ax * by - ay * bx) - sin * (ax * bx + ay * by)
        by_a, by_b = torque * (inv_a * inv_a), torque * (inv_b * inv_b)
        return -by_a * ay, by_a * ax, by_b * by, -by_b * bx
    square_a, square_b = ax * ax + ay * ay, bx * bx + by * by
    torque, energy, _ = terms(law, deflection(ax * by - ay * bx, ax * bx + ay * by, rest))
    weight = size * (square_a * inv_a) * (square_b * inv_b)
    per_a, per_b = 1.0 / max(square_a, SHORTEST_SQUARED), 1.0 / max(square_b, SHORTEST_SQUARED)
    by_a, by_b = weight * torque * per_a, weight * torque * per_b
    # The energy is K w(A) w(B) F, and L w'(L) / w(L) = (L² + 2 softening) / (L² + softening).
    along_a = weight * energy * per_a * ((square_a + 2.0 * soft) * (inv_a * inv_a))
    along_b = weight * energy * per_b * ((square_b + 2.0 * soft) * (inv_b * inv_b))
    on_ax, on_ay = -by_a * ay - along_a * ax, by_a * ax - along_a * ay
    return on_ax, on_ay, by_b * by - along_b * bx, -by_b * bx - along_b * by


@kernel(forceinline=True, fastmath=FAST)
def rub(spring_a, spring_b, damping, soft):
    """The forces by a joint's damping, whose torque is C |A||B| times the rate of the angle.

    Args:
        spring_a, spring_b: the vector of a spring, px, 1 / its length, and the rate of the vector, px/s.
        damping: of the joint, kg/s.
        soft: see `Body.softening`, px².
    """
    (ax, ay, inv_a, au, av), (bx, by, inv_b, bu, bv) = spring_a, spring_b
    per_a, per_b = inv_a * inv_a, inv_b * inv_b
    lengths = (ax * ax + ay * ay + soft) * inv_a * ((bx * bx + by * by + soft) * inv_b)
    torque = damping * lengths * ((bx * bv - by * bu) * per_b - (ax * av - ay * au) * per_a)
    by_a, by_b = torque * per_a, torque * per_b
    return -by_a * ay, by_a * ax, by_b * by, -by_b * bx


@kernel(forceinline=True, fastmath=FAST)
def joint_energy(law, ax, ay, bx, by, rest, softening):
    """The energy of a joint of stiffness one; for the tutorial's law that of the conservative one."""
    square_a, square_b = ax * ax + ay * ay, bx * bx + by * by
    len_a, len_b = math.sqrt(square_a + softening), math.sqrt(square_b + softening)
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, rest)
    if not is_sine(law):
        return (square_a / len_a) * (square_b / len_b) * terms(law, off)[1]
    true = math.sqrt(square_a * square_b)
    sine = math.sin(0.5 * off)
    # |A||B| with softening minus |A||B| without it, avoiding the difference of two large numbers.
    more = softening * (square_a + square_b + softening) / (len_a * len_b + true)
    return 2.0 * true * sine * sine + more


@kernel(forceinline=True, fastmath=FAST)
def is_loose(body, j, off):
    """Whether a joint that acts on one side of its rest angle only is on the other, by its deflection."""
    sides = body.environment.one_sided.joint_side
    return sides.size > 0 and sides[j] * off < 0.0


@kernel(fastmath=FAST)
def joint_energies(body, state, q):
    """The energy of all joints, kg px²/s²."""
    energy = 0.0
    for j in range(body.joints):
        (ax, ay), (bx, by) = joint_vectors(body, q, j)
        rest = state.torque_rest[j + 1]
        if is_loose(body, j, deflection(ax * by - ay * bx, ax * bx + ay * by, rest)):
            continue
        energy += body.angular_stiffness[j + 1] * joint_energy(body.law, ax, ay, bx, by, rest, body.softening)
    return energy


@kernel(forceinline=True, fastmath=FAST)
def joint_vectors(body, q, j):
    """The vectors of the springs A and B that a joint holds, px; of velocities, their rates, px/s."""
    s, r = body.joint_a[j], body.joint_b[j]
    return from_to(q, body.spring_a[s], body.spring_b[s]), from_to(q, body.spring_a[r], body.spring_b[r])


@kernel(fastmath=FAST)
def joint_power_of_keys(body, state, turn, q):
    """The power of keys that turn all rest angles at `turn`, degrees/s; kg px²/s³."""
    power = 0.0
    for j in range(body.joints):
        power += joint_power(body, state, q, j, turn)
    return power


@kernel(fastmath=FAST)
def joint_power(body, state, q, j, turn):
    """The power of what turns the rest angle of a joint at `turn`, degrees/s; kg px²/s³."""
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, state.torque_rest[j + 1])
    if is_loose(body, j, off):
        return 0.0
    aa, bb = ax * ax + ay * ay, bx * bx + by * by
    weight = math.sqrt(aa * bb)
    if not is_sine(body.law):
        weight = aa * bb / (length_of(ax, ay, body.softening) * length_of(bx, by, body.softening))
    return -body.angular_stiffness[j + 1] * weight * terms(body.law, off)[0] * math.radians(turn)


@kernel(fastmath=FAST)
def power_of_law(body, state, q, v):
    """Power of the tutorial's law that no energy accounts for: U (|A|'/|A| + |B|'/|B|) of each joint."""
    power = 0.0
    for j in range(body.joints):
        (ax, ay), (bx, by) = joint_vectors(body, q, j)
        (ux, uy), (wx, wy) = joint_vectors(body, v, j)
        if is_loose(body, j, deflection(ax * by - ay * bx, ax * bx + ay * by, state.torque_rest[j + 1])):
            continue
        aa, bb = length_of(ax, ay, body.softening), length_of(bx, by, body.softening)
        size, cos, sin = body.angular_stiffness[j + 1], state.torque_cos[j + 1], state.torque_sin[j + 1]
        # The rate of the conservative law's energy, and the power of the tutorial's torque.
        torque = cos * (ax * by - ay * bx) - sin * (ax * bx + ay * by)
        power += size * bb / aa * (ax * ux + ay * uy) + size * aa / bb * (bx * wx + by * wy)
        power -= ux * (cos * bx + sin * by) + uy * (cos * by - sin * bx)
        power -= wx * (cos * ax - sin * ay) + wy * (cos * ay + sin * ax)
        power -= torque * ((ay * ux - ax * uy) / (aa * aa) - (by * wx - bx * wy) / (bb * bb))
    return power


@kernel(forceinline=True, fastmath=FAST)
def joint_blocks(
    law, size, cos, sin, rest, damping, a, b, inv_a, inv_b, softening, rate_a, rate_b, g, definite
):  # fmt: skip
    """The derivatives of the tensions that a joint adds to its springs a and b: aa, ab, ba, bb, kg/s².

    A spring with the vector L turns by -n . dL, where n = perp(L) / |L|² (`normal_a`, `normal_b`, 1/px). So
    the angle V has the derivatives n_a by A and -n_b by B, and a torque G adds the tensions -G n_a and
    +G n_b. Hence, with dn/dL in `turn_a` and `turn_b`,

        aa = -n_a (dG/dA)ᵀ - G dn_a/dA, ab = -n_a (dG/dB)ᵀ,
        ba = n_b (dG/dA)ᵀ, bb = n_b (dG/dB)ᵀ + G dn_b/dB.

    This holds for the tutorial's torque and for the damping C |A||B| V', whose derivative by rates is added
    times g. The conservative law has the second derivatives of -U = K A . R(-r) B - K |A||B| instead.

    Args:
        law: as in `Body.law`.
        size, cos, sin: the stiffness, and its products with the cosine and sine of the rest angle.
        rest: rest angle, radians.
        damping: of the joint.
        a, b: vectors of the springs.
        inv_a, inv_b: 1 / their lengths.
        softening: see `Body.softening`, px².
        rate_a, rate_b: the rates of the vectors.
        g: factor of the derivative by the rates.
        definite: whether the matrix -[[aa, ab], [ba, bb]] must be positive semidefinite. It is then
            that of the conservative law, which is the square of sqrt(|B|/|A|) A - sqrt(|A|/|B|) R(-r) B,
            with the square roots taken as constants (Gauss-Newton).
    """
    len_a = (a[0] * a[0] + a[1] * a[1] + softening) * inv_a
    len_b = (b[0] * b[0] + b[1] * b[1] + softening) * inv_b
    normal_a = (a[1] * inv_a * inv_a, -a[0] * inv_a * inv_a)
    normal_b = (b[1] * inv_b * inv_b, -b[0] * inv_b * inv_b)
    turn_a = _normal_by_vector(a, normal_a, inv_a)
    turn_b = _normal_by_vector(b, normal_b, inv_b)
    product = len_a * len_b
    if definite:
        pa, pb = -size * len_b * inv_a, -size * len_a * inv_b
        aa = (pa, 0.0, 0.0, pa)
        ab = (cos, sin, -sin, cos)
        ba = (cos, -sin, sin, cos)
        bb = (pb, 0.0, 0.0, pb)
    elif law == CONSERVATIVE:
        unit_a, unit_b = (a[0] * inv_a, a[1] * inv_a), (b[0] * inv_b, b[1] * inv_b)
        pa, pb = -size * len_b * inv_a, -size * len_a * inv_b
        aa = minus((pa, 0.0, 0.0, pa), outer(pa, unit_a, unit_a))
        bb = minus((pb, 0.0, 0.0, pb), outer(pb, unit_b, unit_b))
        ab = plus((cos, sin, -sin, cos), outer(-size, unit_a, unit_b))
        ba = (ab[0], ab[2], ab[1], ab[3])
    elif law == TUTORIAL:
        torque = cos * (a[0] * b[1] - a[1] * b[0]) - sin * (a[0] * b[0] + a[1] * b[1])
        by_a = (cos * b[1] - sin * b[0], -cos * b[0] - sin * b[1])
        by_b = (-cos * a[1] - sin * a[0], cos * a[0] - sin * a[1])
        aa = minus(outer(-1.0, normal_a, by_a), scaled(torque, turn_a))
        ab = outer(-1.0, normal_a, by_b)
        ba = outer(1.0, normal_b, by_a)
        bb = plus(outer(1.0, normal_b, by_b), scaled(torque, turn_b))
    else:
        aa, ab, ba, bb = blocks_of_law(law, size, rest, a, b, inv_a, inv_b, softening)
    if damping > 0.0:
        strength = damping * product
        # dV/dt is the turning rate of b minus that of a; the turning rate of a spring is -normal . rate.
        turning = normal_a[0] * rate_a[0] + normal_a[1] * rate_a[1]
        turning = turning - normal_b[0] * rate_b[0] - normal_b[1] * rate_b[1]
        torque = strength * turning
        by_a = (g * strength * normal_a[0], g * strength * normal_a[1])
        by_b = (-g * strength * normal_b[0], -g * strength * normal_b[1])
        if not definite:
            longer_a, longer_b = damping * len_b * inv_a * turning, damping * len_a * inv_b * turning
            turned_a, turned_b = from_left(rate_a, turn_a), from_left(rate_b, turn_b)
            by_a = (
                by_a[0] + longer_a * a[0] + strength * turned_a[0],
                by_a[1] + longer_a * a[1] + strength * turned_a[1],
            )
            by_b = (
                by_b[0] + longer_b * b[0] - strength * turned_b[0],
                by_b[1] + longer_b * b[1] - strength * turned_b[1],
            )
            aa = minus(aa, scaled(torque, turn_a))
            bb = plus(bb, scaled(torque, turn_b))
        aa = minus(aa, outer(1.0, normal_a, by_a))
        ab = minus(ab, outer(1.0, normal_a, by_b))
        ba = plus(ba, outer(1.0, normal_b, by_a))
        bb = plus(bb, outer(1.0, normal_b, by_b))
    return aa, ab, ba, bb


@kernel(fastmath=FAST)
def blocks_of_law(law, size, rest, a, b, inv_a, inv_b, softening):
    """Like `joint_blocks`, for any law with an energy, from its terms.

    The energy is K w(A) w(B) F(V - r) with the weight w(L) = L² / sqrt(L² + softening), since V is undefined
    where a spring has no length.
    """
    off = deflection(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1], rest)
    torque, energy, stiffness = terms(law, off)
    weight_a, slope_a, bend_a, normal_a, turn_a = _weight(a, inv_a, softening)
    weight_b, slope_b, bend_b, normal_b, turn_b = _weight(b, inv_b, softening)
    aa = plus(outer(torque, slope_a, normal_a), outer(torque, normal_a, slope_a))
    aa = plus(aa, plus(scaled(energy, bend_a), outer(stiffness * weight_a, normal_a, normal_a)))
    aa = scaled(-size * weight_b, plus(aa, scaled(weight_a * torque, turn_a)))
    bb = plus(outer(-torque, slope_b, normal_b), outer(-torque, normal_b, slope_b))
    bb = plus(bb, plus(scaled(energy, bend_b), outer(stiffness * weight_b, normal_b, normal_b)))
    bb = scaled(-size * weight_a, minus(bb, scaled(weight_b * torque, turn_b)))
    ab = minus(outer(torque * weight_b, slope_a, normal_b), outer(torque * weight_a, normal_a, slope_b))
    both = outer(stiffness * weight_a * weight_b, normal_a, normal_b)
    ab = plus(minus(ab, outer(energy, slope_a, slope_b)), both)
    ab = scaled(size, ab)
    return aa, ab, (ab[0], ab[2], ab[1], ab[3]), bb


@kernel(forceinline=True, fastmath=FAST)
def _weight(vector, inv, softening):
    """The weight of a spring, its gradient and its second derivatives; perp(L) / |L|², which is minus the
    gradient of the spring's angle, and the derivatives of that."""
    square = vector[0] * vector[0] + vector[1] * vector[1]
    true = 1.0 / max(square, SHORTEST_SQUARED)
    slope = (square + 2.0 * softening) * inv * inv * inv
    bend = (3.0 * square * inv * inv - 4.0) * inv * inv * inv
    normal = (vector[1] * true, -vector[0] * true)
    second = plus((slope, 0.0, 0.0, slope), outer(bend, vector, vector))
    turn = _normal_by_vector(vector, normal, math.sqrt(true))
    return square * inv, (slope * vector[0], slope * vector[1]), second, normal, turn


@kernel(forceinline=True, fastmath=FAST)
def _normal_by_vector(vector, normal, inv):
    """The derivative of perp(L) / |L|² by L."""
    x, y = 2.0 * inv * inv * vector[0], 2.0 * inv * inv * vector[1]
    return (
        -normal[0] * x,
        inv * inv - normal[0] * y,
        -inv * inv - normal[1] * x,
        -normal[1] * y,
    )


@kernel(fastmath=FAST)
def add_joint_derivatives(body, state, matrix, q, v, g, definite):
    """Add the derivatives of all joints' forces to `matrix.blocks`; see `term.Term.add_derivatives`.

    A joint adds a tension to each of its springs, which depends on the vectors of both. Each of the blocks
    aa, ab, ba, bb of `joint_blocks` belongs at the rows of the ends of the one spring and the columns of
    those of the other, with the signs of `add_spring_derivatives`.
    """
    for j in range(body.joints):
        (a, b), (rate_a, rate_b) = joint_vectors(body, q, j), joint_vectors(body, v, j)
        of_joint = joint_blocks(
            body.law, body.angular_stiffness[j + 1], state.torque_cos[j + 1], state.torque_sin[j + 1],
            state.torque_rest[j + 1], body.torque_damping[j + 1], a, b,
            inverse_of(a[0], a[1], body.softening), inverse_of(b[0], b[1], body.softening),
            body.softening, rate_a, rate_b, g, definite,
        )  # fmt: skip
        i = 16 * j
        for block in of_joint:
            for k, sign in enumerate((1.0, -1.0, -1.0, 1.0)):
                add_block(matrix.blocks, matrix.joint_target[i + k], sign, block)
            i += 4


@kernel(fastmath=FAST)
def add_joint_damping(body, state, q, v, z, factor, out):
    """A joint's damper has the torque -C |A||B| V', where V' is the rate of the angle from A to B.

    A spring with the vector L and the rate L' turns at (L x L') / |L|². A torque T turns it by the force
    T (-L.y, L.x) / |L|² on its b end.
    """
    w, slots = state.inverse_mass, z.size // 2
    for j in range(body.joints if body.joint_damped else 0):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        (ax, ay), (bx, by) = from_to(q, a0, a1), from_to(q, b0, b1)
        (zax, zay), (zbx, zby) = from_to(z, a0, a1), from_to(z, b0, b1)
        inv_a, inv_b = inverse_of(ax, ay, body.softening), inverse_of(bx, by, body.softening)
        per_a, per_b = inv_a * inv_a, inv_b * inv_b
        rate = (bx * zby - by * zbx) * per_b - (ax * zay - ay * zax) * per_a
        torque = factor * body.torque_damping[j + 1] * rate / (inv_a * inv_b)
        for one, other, x, y in (
            (a0, a1, torque * per_a * ax, torque * per_a * ay),
            (b0, b1, -torque * per_b * bx, -torque * per_b * by),
        ):
            out[other] -= w[other] * y
            out[slots + other] += w[other] * x
            out[one] += w[one] * y
            out[slots + one] -= w[one] * x


# ------------------------------------------------------------------------- in NumPy
def sine_law(s: Vectors) -> tuple[Floats, Floats]:
    """The torque |A||B| sin(V - r), and its energy |A||B| (1 - cos(V - r))."""
    return s.imag, abs(s) - s.real


def angle_law(s: Vectors) -> tuple[Floats, Floats]:
    """The torque |A||B| (V - r), and the energy |A||B| (V - r)² / 2."""
    deflection = np.angle(s)
    return abs(s) * deflection, 0.5 * abs(s) * deflection**2


IN_NUMPY: dict[int, Callable[[Vectors], tuple[Floats, Floats]]] = {
    NO_JOINTS: sine_law,
    TUTORIAL: sine_law,
    CONSERVATIVE: sine_law,
    ANGLE: angle_law,
}
"""Torque and energy of a joint of stiffness one, by `Body.law`, from S = conj(A) B exp(-ir), see
`sim.forces.reference`. The tutorial's law has the torque of the sine law without the pull along the springs
that would make it the gradient of an energy."""


class JointsReference:
    """Joints in NumPy; see `Reference`.

    Args:
        body, state: the tables.
        rows: indices of joints in the tables; without it, all of them.

    Attributes:
        stiffness, damping: (k,) kg/s², kg/s; may be replaced.
        rest_angle: (k,) radians.
    """

    def __init__(self, body: Body, state: State, rows: Indices | slice = slice(None)) -> None:
        self._law, self._is_sine, self._softening = IN_NUMPY[body.law], body.law in SINE_LAWS, body.softening
        self._has_energy = body.law != TUTORIAL
        sides = body.environment.one_sided.joint_side
        self._sides = sides[rows] if sides.size else np.zeros(body.joints)[rows]
        first, second = body.joint_a[rows], body.joint_b[rows]
        self._start, self._end = (
            np.stack((ends[first], ends[second])) for ends in (body.spring_a, body.spring_b)
        )  # (2, k) of both springs of each joint
        self._ends = np.concatenate((self._end.ravel(), self._start.ravel()))
        self.stiffness, self.damping, self.rest_angle = (
            numbers[1 : body.joints + 1][rows]
            for numbers in (body.angular_stiffness, body.torque_damping, state.torque_rest)
        )

    def forces(self, x: Vectors, v: Vectors, only: np.ndarray | None = None) -> Vectors:
        """See `Reference`; as if all acted on both sides. `only`: (k,) those that are wanted, or all."""
        springs, square, torque, energy = self._joint_trial_state(x, v)
        if only is not None:
            torque, energy = torque * only, energy * only
        # The torque turns both springs towards the rest angle. The energy grows with both lengths, so its
        # gradient also pulls along them.
        pull = energy if self._has_energy else 0.0
        tension = springs / square
        tension[0] *= 1j * torque - pull
        tension[1] *= -1j * torque - pull
        return summed(self._ends, np.concatenate((tension.ravel(), -tension.ravel())), x.size)

    def torques(self, x: Vectors, v: Vectors) -> Floats:
        """(k,) the torque of each joint, kg px²/s²: on its first spring; minus it acts on the second one."""
        return np.where(self.acting(x, v), self._joint_trial_state(x, v)[2], 0.0)

    def acting(self, x: Vectors, v: Vectors) -> np.ndarray:
        """(k,) whether each joint acts; those that act on one side do not turn their torque round."""
        torque, off = self._joint_trial_state(x, v)[2], self.deflections(x)
        return (self._sides == 0.0) | ((self._sides * off > 0.0) & (self._sides * torque > 0.0))

    def brace(self, x: Vectors) -> None:
        """See `Bracing`."""
        off = self.deflections(x)
        self.rest_angle = np.where(self._sides * off < 0.0, self.rest_angle + off, self.rest_angle)
        self._sides = np.zeros_like(self._sides)

    def deflections(self, x: Vectors) -> Floats:
        """(k,) by how much the angle of each joint is larger than its rest angle, radians in (-pi, pi]."""
        springs = self._springs(x)
        return np.angle(springs[0].conj() * springs[1] * np.exp(-1j * self.rest_angle))

    def rates(self, x: Vectors, v: Vectors) -> Floats:
        """(k,) the rate at which the angle of each joint grows, 1/s."""
        springs = self._springs(x)
        return self._rates(springs, self._square(springs), v)

    def energy(self, x: Vectors) -> float:
        """See `Reference`; for the tutorial's law that of the conservative one."""
        tight = ~(self._sides * self.deflections(x) < 0.0)
        return float(self._joint_trial_state(x, np.zeros_like(x))[3][tight].sum())

    def _springs(self, flat: Vectors) -> Vectors:
        """(2, k) the vectors of both springs of each joint: of positions, px, or of velocities, px/s."""
        return flat[self._end] - flat[self._start]

    def _square(self, springs: Vectors) -> Floats:
        """(2, k) the squares of their lengths, px²."""
        return springs.real**2 + springs.imag**2 + self._softening

    def _rates(self, springs: Vectors, square: Floats, v: Vectors) -> Floats:
        """As `rates`, from the vectors of the springs and the squares of their lengths."""
        turning = (self._springs(v) * springs.conj()).imag / square
        return turning[1] - turning[0]

    def _joint_trial_state(self, x: Vectors, v: Vectors) -> tuple[Vectors, Floats, Floats, Floats]:
        """(2, k) vectors of both springs of each joint, px, and the squares of their lengths, px²; a joint's
        torque, and its energy, kg px²/s²."""
        springs = self._springs(x)
        square = self._square(springs)
        s = springs[0].conj() * springs[1] * np.exp(-1j * self.rest_angle)
        torque, energy = self._law(s)
        lengths = np.sqrt(square[0] * square[1])  # |A||B|
        weight = self.stiffness if self._is_sine else self.stiffness * abs(s) / lengths  # as `blocks_of_law`
        damped = self.damping * lengths * self._rates(springs, square, v)
        return springs, square, weight * torque + damped, weight * energy
