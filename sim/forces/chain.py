"""The accelerations of a chain or a ring in one loop over its masses.

The tension of a spring, its force on the mass at its b end, depends on the vectors of both neighbouring
springs. So the loop runs two slots ahead of the mass whose acceleration it computes, and carries intermediate
results from one iteration to the next. It stores only accelerations: if one loop stored intermediate results
and the next one loaded them one slot further on, a short chain would wait for that longer than its arithmetic
takes. LLVM still vectorises the loop, eight iterations at a time, by shuffling what is carried. No iteration
tests whether its spring is padding: a padding spring has no stiffness, and is longer than any other.

The forces are those of `springs`, under the tutorial's law, under the conservative law, or without
joints.
"""

from __future__ import annotations

import math

from ..engine.bits import bits, from_bits
from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time, whole_eights
from ..engine.numerics.roots import inverse_root_from_min
from .joints import CONSERVATIVE, NO_JOINTS, SINE_LAWS, TUTORIAL


@kernel(forceinline=True)
def is_chain_like(body):
    """Whether `chain_accelerations` handles a body."""
    return (body.chain or body.ring) and body.law in SINE_LAWS and not body.joint_damped


@kernel(inline="always")
def _nothing():
    """What is carried on from a mass at which no spring ends."""
    return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


@kernel(inline="always")
def _along(law, alone, carried, bx, by, bu, bv, cos, sin, size, rest_tension, stiffness, damping, soft):
    """Advance along a spring to the mass at its b end.

    Args:
        law: TUTORIAL, CONSERVATIVE or NO_JOINTS.
        alone: whether the call is outside the vectorised loop.
        carried: the intermediate results from the mass at its a end.
        bx, by, bu, bv: the spring's vector, px, and its rate of change, px/s.
        cos, sin, size: stiffness of the joint with the spring before, kg/s², times the cosine and the sine of
            its rest angle; and itself.
        rest_tension, stiffness, damping: of the spring, as in `State` and `Body`.
        soft: of the spring, px², see `Body.softenings`.

    Returns:
        1 / length, the tension of the spring before, and the intermediate results to carry on.
    """
    ax, ay, along, part, known, in_x, in_y = carried
    square = bx * bx + by * by + soft
    inv = 1.0 / math.sqrt(square) if alone else inverse_root_from_min(square)
    inv2 = inv * inv
    rate = bx * bu + by * bv
    to_along = rest_tension * inv - stiffness - damping * rate * inv2
    to_part, to_known, to_x, to_y = 0.0, 0.0, 0.0, 0.0
    if law == CONSERVATIVE:
        # K (R(r) A + R(-r) C) - K (|A| + |C|) u on a spring between A and C: the gradient of both energies,
        # without their difference.
        length = square * inv
        along -= size * length * part
        tx = along * ax + in_x + (cos * bx + sin * by)
        ty = along * ay + in_y + (cos * by - sin * bx)
        to_x, to_y = cos * ax - sin * ay, sin * ax + cos * ay
        to_along -= size * known * inv
        to_part, to_known = inv, length
    elif law == TUTORIAL:
        torque = cos * (ax * by - ay * bx) - sin * (ax * bx + ay * by)
        across = (known - torque) * part
        tx, ty = along * ax + across * ay, along * ay - across * ax
        to_part, to_known = inv2, torque
    else:
        tx, ty = along * ax, along * ay
    return inv, tx, ty, (bx, by, to_along, to_part, to_known, to_x, to_y)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def chain_accelerations(body, state, scratch, q, v, a):
    """Accelerations of the masses of a chain or a ring, zero where one is held.

    Meanwhile, slot 0 of a ring has a copy of the last mass, and the two slots after the last mass have copies
    of the first two. `scratch.inverse[0]` becomes 1 / length of the shortest spring.
    """
    if body.ring:
        _close_ring(body.masses, q)
        _close_ring(body.masses, v)
    slots = q.size // 2
    _accelerate_by_law(body, state, scratch, q[:slots], q[slots:], v[:slots], v[slots:], a[:slots], a[slots:])
    if body.ring:
        _open_ring(body.masses, q)
        _open_ring(body.masses, v)


@kernel(forceinline=True)
def _close_ring(masses, flat):
    """Copy the last mass of a ring to the slot before the first, and the first two to after the last."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x], flat[behind], flat[behind + 1] = flat[behind - 1], flat[x + 1], flat[x + 2]


@kernel(forceinline=True)
def _open_ring(masses, flat):
    """Clear these copies again: error estimates and linear solvers look at all slots alike."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x] = flat[behind] = flat[behind + 1] = 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _accelerate_by_law(body, state, scratch, x, y, vx, vy, ax, ay):
    eight_at_a_time()
    if body.law == CONSERVATIVE:
        _accelerate(CONSERVATIVE, body, state, scratch, x, y, vx, vy, ax, ay)
    elif body.law == TUTORIAL:
        _accelerate(TUTORIAL, body, state, scratch, x, y, vx, vy, ax, ay)
    else:
        _accelerate(NO_JOINTS, body, state, scratch, x, y, vx, vy, ax, ay)


@kernel(inline="always")
def _accelerate(law, body, state, scratch, x, y, vx, vy, ax, ay):
    n, soft = body.masses, body.softenings
    cos, sin, size = state.torque_cos, state.torque_sin, body.angular_stiffness
    rest_tension, stiffness, damping = state.rest_tension, body.stiffness, body.damping
    w, air, gx, gy = state.inverse_mass, state.air, state.gx, state.gy
    carried = _nothing()
    if body.ring:
        for s in (n - 2, n - 1):
            a, b = (n - 1, 0) if s < n - 1 else (0, 1)
            _, _, _, carried = _along(
                law, True, carried, x[b] - x[a], y[b] - y[a], vx[b] - vx[a], vy[b] - vy[a],
                cos[s], sin[s], size[s], rest_tension[s], stiffness[s], damping[s], soft[s],
            )  # fmt: skip
    inv, before_x, before_y, carried = _along(
        law, True, carried, x[2] - x[1], y[2] - y[1], vx[2] - vx[1], vy[2] - vy[1],
        cos[0], sin[0], size[0], rest_tension[0], stiffness[0], damping[0], soft[0],
    )  # fmt: skip
    short = bits(inv)
    for m in range(1, whole_eights(n) + 1):
        a, b = m + 1, m + 2
        inv, tx, ty, carried = _along(
            law, False, carried, x[b] - x[a], y[b] - y[a], vx[b] - vx[a], vy[b] - vy[a],
            cos[m], sin[m], size[m], rest_tension[m], stiffness[m], damping[m], soft[m],
        )  # fmt: skip
        short = max(short, bits(inv))
        u, v = vx[m], vy[m]
        ax[m] = (before_x - tx) * w[m] - air[m] * (u * abs(u)) + gx[m]
        ay[m] = (before_y - ty) * w[m] - air[m] * (v * abs(v)) + gy[m]
        before_x, before_y = tx, ty
    scratch.inverse[0] = from_bits(short)
