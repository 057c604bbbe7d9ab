"""The product of Jv, the derivative of the accelerations with respect to velocities, with a vector."""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.lanes import eight_at_a_time, whole_eights
from ..core.shared import add_damping_around
from ..core.vectors import from_to, inverse_of


@kernel(forceinline=True, fastmath=FAST)
def remember_directions(body, matrix, q):
    """Store the directions of the springs at positions q, for `add_damping_product`."""
    slots = q.size // 2
    ux, uy, inverse = matrix.ux, matrix.uy, matrix.inverse
    if body.chain:
        springs = whole_eights(body.springs)
        _chain_directions(springs, body.softening, q[:slots], q[slots:], ux, uy, inverse)
    else:
        for s in range(body.springs):
            x, y = from_to(q, body.spring_a[s], body.spring_b[s])
            inv = inverse_of(x, y, body.softening)
            ux[s + 1], uy[s + 1], inverse[s + 1] = x * inv, y * inv, inv


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _chain_directions(springs, soft, x_of, y_of, ux, uy, inverse):
    eight_at_a_time()
    for s in range(springs):
        x, y = x_of[s + 2] - x_of[s + 1], y_of[s + 2] - y_of[s + 1]
        inv = 1.0 / math.sqrt(x * x + y * y + soft)
        ux[s + 1], uy[s + 1], inverse[s + 1] = x * inv, y * inv, inv


@kernel(forceinline=True)
def add_resistance(problem, q, v, z, factor, out):
    """out += factor Jv z, with Jv of the whole problem, at positions q and velocities v."""
    add_damping_product(problem.body, problem.state, problem.matrix, v, z, factor, out)
    if problem.resistance != 0:
        add_damping_around(problem, q, v, z, factor, out)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def add_damping_product(body, state, matrix, v, z, factor, out):
    """out += factor Jv z, with Jv at velocities v and the positions of the last `remember_directions`."""
    eight_at_a_time()
    slots = z.size // 2
    if not body.chain or body.joint_damped:
        _add_any_damping(body, state, matrix, v, z, factor, out)
        return
    zx, zy, vx, vy = z[:slots], z[slots:], v[:slots], v[slots:]
    ox, oy = out[:slots], out[slots:]
    w, air, ux, uy, damping = state.inverse_mass, state.air, matrix.ux, matrix.uy, matrix.damping
    # Both springs are recomputed at each mass: waiting for results that another loop stores takes longer.
    for i in range(1, whole_eights(body.masses) + 1):
        before = damping[i - 1] * (ux[i - 1] * (zx[i] - zx[i - 1]) + uy[i - 1] * (zy[i] - zy[i - 1]))
        behind = damping[i] * (ux[i] * (zx[i + 1] - zx[i]) + uy[i] * (zy[i + 1] - zy[i]))
        ox[i] += factor * (w[i] * (behind * ux[i] - before * ux[i - 1]) - 2.0 * air[i] * abs(vx[i]) * zx[i])
        oy[i] += factor * (w[i] * (behind * uy[i] - before * uy[i - 1]) - 2.0 * air[i] * abs(vy[i]) * zy[i])


@kernel(fastmath=FAST)
def _add_any_damping(body, state, matrix, v, z, factor, out):
    slots = z.size // 2
    zx, zy = z[:slots], z[slots:]
    ox, oy = out[:slots], out[slots:]
    w, air = state.inverse_mass, state.air
    ux, uy = matrix.ux, matrix.uy
    if body.damped:
        for s in range(body.springs):
            a, b = body.spring_a[s], body.spring_b[s]
            x, y = ux[s + 1], uy[s + 1]
            along = -factor * body.damping[s] * (x * (zx[b] - zx[a]) + y * (zy[b] - zy[a]))
            ox[b] += w[b] * along * x
            oy[b] += w[b] * along * y
            ox[a] -= w[a] * along * x
            oy[a] -= w[a] * along * y
    if body.joint_damped:
        _add_twist(body, w, matrix, zx, zy, factor, ox, oy)
    for i in range(1, body.masses + 1):
        ox[i] -= factor * 2.0 * air[i] * abs(v[i]) * zx[i]
        oy[i] -= factor * 2.0 * air[i] * abs(v[slots + i]) * zy[i]


@kernel(fastmath=FAST)
def _add_twist(body, w, matrix, zx, zy, factor, ox, oy):
    ux, uy, inverse = matrix.ux, matrix.uy, matrix.inverse
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        ax, ay, inv_a = ux[s + 1], uy[s + 1], inverse[s + 1]
        bx, by, inv_b = ux[r + 1], uy[r + 1], inverse[r + 1]
        rate_a = (ax * (zy[a1] - zy[a0]) - ay * (zx[a1] - zx[a0])) * inv_a
        rate_b = (bx * (zy[b1] - zy[b0]) - by * (zx[b1] - zx[b0])) * inv_b
        torque = factor * body.torque_damping[j + 1] * (rate_b - rate_a) / (inv_a * inv_b)
        fx, fy = -torque * inv_a * ay, torque * inv_a * ax
        ox[a1] += w[a1] * fx
        oy[a1] += w[a1] * fy
        ox[a0] -= w[a0] * fx
        oy[a0] -= w[a0] * fy
        fx, fy = torque * inv_b * by, -torque * inv_b * bx
        ox[b1] += w[b1] * fx
        oy[b1] += w[b1] * fy
        ox[b0] -= w[b0] * fx
        oy[b0] -= w[b0] * fy
