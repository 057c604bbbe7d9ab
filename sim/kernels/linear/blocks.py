"""2×2 blocks: derivatives of the forces of springs and joints.

A block is a tuple (xx, xy, yx, yy). It is the derivative of the force on the b end of a spring, its tension,
with respect to a spring's vector. The derivative with respect to the rate of that vector, times the factor g
of an implicit step, is added to it, since velocities are eliminated from the linear systems.
"""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.tables import SHORTEST_SQUARED
from ..core.vectors import deflection
from ..forces.laws import CONSERVATIVE, TUTORIAL, terms


@kernel(forceinline=True, fastmath=FAST)
def times(a, b):
    """The product of two blocks."""
    return (
        a[0] * b[0] + a[1] * b[2],
        a[0] * b[1] + a[1] * b[3],
        a[2] * b[0] + a[3] * b[2],
        a[2] * b[1] + a[3] * b[3],
    )


@kernel(forceinline=True, fastmath=FAST)
def minus(a, b):
    """The difference of two blocks."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]


@kernel(forceinline=True, fastmath=FAST)
def plus(a, b):
    """The sum of two blocks."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]


@kernel(forceinline=True, fastmath=FAST)
def inverted(a):
    """The inverse of a block; infinities where it has none."""
    factor = 1.0 / (a[0] * a[3] - a[1] * a[2])
    return a[3] * factor, -a[1] * factor, -a[2] * factor, a[0] * factor


@kernel(forceinline=True, fastmath=FAST)
def outer(factor, a, b):
    """factor a bᵀ, of two vectors."""
    x, y = factor * a[0], factor * a[1]
    return x * b[0], x * b[1], y * b[0], y * b[1]


@kernel(forceinline=True, fastmath=FAST)
def scaled(factor, block):
    """A block times a number."""
    return factor * block[0], factor * block[1], factor * block[2], factor * block[3]


@kernel(forceinline=True, fastmath=FAST)
def spring_block(stiffness, damping, pull, inv, vector, rate, g, definite):
    """The derivative of a linear spring's tension by its own vector; `inv` is 1 / its length.

    `definite` leaves out what could make the matrix of an implicit step indefinite: the sideways push of a
    compressed spring, and the turning of the damping force.
    """
    x, y = vector
    inv2 = inv * inv
    if definite:
        taut = max(stiffness - pull * inv, 0.0)
        along = (stiffness - taut + g * damping) * inv2
        return -taut - along * x * x, -along * x * y, -along * x * y, -taut - along * y * y
    speed = x * rate[0] + y * rate[1]
    e = pull * inv - stiffness - damping * speed * inv2
    radial = -pull * inv * inv2 + 2.0 * damping * speed * inv2 * inv2 - g * damping * inv2
    ex = radial * x - damping * inv2 * rate[0]
    ey = radial * y - damping * inv2 * rate[1]
    return e + x * ex, x * ey, y * ex, e + y * ey


@kernel(forceinline=True, fastmath=FAST)
def joint_blocks(
    law, size, cos, sin, rest, damping, a, b, inv_a, inv_b, softening, rate_a, rate_b, g, definite
):  # fmt: skip
    """The derivatives of the tensions that a joint adds to its springs a and b: aa, ab, ba, bb.

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
        turning = (
            normal_a[0] * rate_a[0]
            + normal_a[1] * rate_a[1]
            - normal_b[0] * rate_b[0]
            - normal_b[1] * rate_b[1]
        )
        torque = strength * turning
        by_a = (g * strength * normal_a[0], g * strength * normal_a[1])
        by_b = (-g * strength * normal_b[0], -g * strength * normal_b[1])
        if not definite:
            by_a = (
                by_a[0]
                + damping * len_b * inv_a * turning * a[0]
                + strength * (turn_a[0] * rate_a[0] + turn_a[2] * rate_a[1]),
                by_a[1]
                + damping * len_b * inv_a * turning * a[1]
                + strength * (turn_a[1] * rate_a[0] + turn_a[3] * rate_a[1]),
            )
            by_b = (
                by_b[0]
                + damping * len_a * inv_b * turning * b[0]
                - strength * (turn_b[0] * rate_b[0] + turn_b[2] * rate_b[1]),
                by_b[1]
                + damping * len_a * inv_b * turning * b[1]
                - strength * (turn_b[1] * rate_b[0] + turn_b[3] * rate_b[1]),
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
