"""The product of Jv, the derivative of the accelerations by the velocities, with a vector."""

from __future__ import annotations

import math

from .blocks import length_of
from .jit import FAST, kernel


@kernel(forceinline=True, fastmath=FAST)
def remember_directions(body, matrix, q):
    """Keep the springs' directions at positions q, for `add_resistance`."""
    places = q.size // 2
    ux, uy, inverse = matrix.ux, matrix.uy, matrix.inverse
    if body.chain:
        for s in range(body.stiffness.size):
            x, y = q[s + 2] - q[s + 1], q[places + s + 2] - q[places + s + 1]
            inv = 1.0 / math.sqrt(x * x + y * y + body.softening)
            ux[s], uy[s], inverse[s] = x * inv, y * inv, inv
    else:
        for s in range(body.springs):
            a, b = body.spring_a[s], body.spring_b[s]
            x, y = q[b] - q[a], q[places + b] - q[places + a]
            inv = 1.0 / length_of(x, y, body.softening)
            ux[s], uy[s], inverse[s] = x * inv, y * inv, inv


@kernel(forceinline=True, fastmath=FAST)
def add_resistance(body, live, work, matrix, v, z, factor, out):
    """out += factor Jv z, with Jv at velocities v and the positions last given to `remember_directions`."""
    places = z.size // 2
    if not body.chain or body.twisted:
        _add_any_resistance(body, live, matrix, v, z, factor, out)
        return
    zx, zy, vx, vy = z[:places], z[places:], v[:places], v[places:]
    ox, oy = out[:places], out[places:]
    w, air = live.inverse_mass, live.air
    springs = body.stiffness.size
    ux, uy, tx, ty, damping = matrix.ux, matrix.uy, work.tx, work.ty, body.damping
    tx[1], ty[1] = 0.0, 0.0
    for s in range(springs):
        along = -damping[s] * (ux[s] * (zx[s + 2] - zx[s + 1]) + uy[s] * (zy[s + 2] - zy[s + 1]))
        tx[s + 2] = along * ux[s]
        ty[s + 2] = along * uy[s]
    for i in range(1, springs + 1):
        ox[i] += factor * (w[i] * (tx[i] - tx[i + 1]) - 2.0 * air[i] * abs(vx[i]) * zx[i])
    for i in range(1, springs + 1):
        oy[i] += factor * (w[i] * (ty[i] - ty[i + 1]) - 2.0 * air[i] * abs(vy[i]) * zy[i])


@kernel(fastmath=FAST)
def _add_any_resistance(body, live, matrix, v, z, factor, out):
    places = z.size // 2
    zx, zy = z[:places], z[places:]
    ox, oy = out[:places], out[places:]
    w, air = live.inverse_mass, live.air
    ux, uy = matrix.ux, matrix.uy
    if body.damped:
        for s in range(body.springs):
            a, b = body.spring_a[s], body.spring_b[s]
            along = -factor * body.damping[s] * (ux[s] * (zx[b] - zx[a]) + uy[s] * (zy[b] - zy[a]))
            ox[b] += w[b] * along * ux[s]
            oy[b] += w[b] * along * uy[s]
            ox[a] -= w[a] * along * ux[s]
            oy[a] -= w[a] * along * uy[s]
    if body.twisted:
        _add_twist(body, w, matrix, zx, zy, factor, ox, oy)
    for i in range(1, body.masses + 1):
        ox[i] -= factor * 2.0 * air[i] * abs(v[i]) * zx[i]
        oy[i] -= factor * 2.0 * air[i] * abs(v[places + i]) * zy[i]


@kernel(fastmath=FAST)
def _add_twist(body, w, matrix, zx, zy, factor, ox, oy):
    ux, uy, inverse = matrix.ux, matrix.uy, matrix.inverse
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        rate_a = (ux[s] * (zy[a1] - zy[a0]) - uy[s] * (zx[a1] - zx[a0])) * inverse[s]
        rate_b = (ux[r] * (zy[b1] - zy[b0]) - uy[r] * (zx[b1] - zx[b0])) * inverse[r]
        couple = factor * body.couple_damping[j + 1] * (rate_b - rate_a) / (inverse[s] * inverse[r])
        fx, fy = -couple * inverse[s] * uy[s], couple * inverse[s] * ux[s]
        ox[a1] += w[a1] * fx
        oy[a1] += w[a1] * fy
        ox[a0] -= w[a0] * fx
        oy[a0] -= w[a0] * fy
        fx, fy = couple * inverse[r] * uy[r], -couple * inverse[r] * ux[r]
        ox[b1] += w[b1] * fx
        oy[b1] += w[b1] * fy
        ox[b0] -= w[b0] * fx
        oy[b0] -= w[b0] * fy
