"""Symplectic Euler on a chain: every array is read and written in order, so every loop is vectorised.

With L_s the vector of spring s and perp(L) = (L.y, -L.x), the force on the b end of spring s is
T_s = (k rest/|L| - k - c L.dv/|L|²) L_s + (G_{s-1} - G_s)/|L|² perp(L_s), and joint j between springs j
and j + 1 has the couple G_j = K cos r (L_j x L_{j+1}) - K sin r (L_j . L_{j+1}): the tutorial's forces
without unit vectors and with one inverse of a square root a spring.

Each spring computes both of its couples anew from the positions, as the sum of its neighbours' vectors, each
turned by the rest angle in between and times K, across its own. That is less work than it looks: values that
one loop stores and the next one loads at a place beside, cost a short chain more than the arithmetic.
"""

from __future__ import annotations

from .controls import lead_and_press, place_led
from .guard import DONE, GOOD, STRIDE, WHAT, judge, keep
from .jit import FUSED, kernel
from .lanes import eight_at_a_time, whole_eights
from .roots import inverse_root


@kernel(fastmath=FUSED)
def run_chain(body, live, work, motion, kept, progress, dt, steps, has_air, farthest, fastest):
    """Do `steps` steps, or as many as go well; `progress` tells. `live` ends at the last good state."""
    eight_at_a_time()
    springs, masses = whole_eights(body.springs), whole_eights(body.masses)
    x, y, vx, vy = live.x, live.y, live.vx, live.vy
    tx, ty = work.tx, work.ty
    stiffness, damping, pull = body.stiffness, body.damping, live.pull
    cos, sin = live.couple_cos, live.couple_sin
    tx[1], ty[1] = 0.0, 0.0
    while progress[DONE] < steps and progress[WHAT] == GOOD:
        done = progress[DONE]
        count = min(progress[STRIDE], steps - done)
        keep(live, kept)
        for step in range(done, done + count):
            if motion.active:
                lead_and_press(body, live, motion, step, steps)
            # The force of spring s goes to the place of the mass at its b end, s + 2. Place 1 stays zero:
            # no spring ends at the first mass.
            if body.joints and body.damped:
                for s in range(springs):
                    bx, by = x[s + 2] - x[s + 1], y[s + 2] - y[s + 1]
                    inv = inverse_root(bx * bx + by * by)
                    inv2 = inv * inv
                    rate = bx * (vx[s + 2] - vx[s + 1]) + by * (vy[s + 2] - vy[s + 1])
                    along = pull[s] * inv - stiffness[s] - damping[s] * rate * inv2
                    ax, ay = x[s + 1] - x[s], y[s + 1] - y[s]
                    cx, cy = x[s + 3] - x[s + 2], y[s + 3] - y[s + 2]
                    wx = cos[s] * ax - sin[s] * ay + cos[s + 1] * cx + sin[s + 1] * cy
                    wy = sin[s] * ax + cos[s] * ay - sin[s + 1] * cx + cos[s + 1] * cy
                    across = (wx * by - wy * bx) * inv2
                    tx[s + 2] = along * bx + across * by
                    ty[s + 2] = along * by - across * bx
            elif body.joints:
                for s in range(springs):
                    bx, by = x[s + 2] - x[s + 1], y[s + 2] - y[s + 1]
                    inv = inverse_root(bx * bx + by * by)
                    along = pull[s] * inv - stiffness[s]
                    ax, ay = x[s + 1] - x[s], y[s + 1] - y[s]
                    cx, cy = x[s + 3] - x[s + 2], y[s + 3] - y[s + 2]
                    wx = cos[s] * ax - sin[s] * ay + cos[s + 1] * cx + sin[s + 1] * cy
                    wy = sin[s] * ax + cos[s] * ay - sin[s + 1] * cx + cos[s + 1] * cy
                    across = (wx * by - wy * bx) * (inv * inv)
                    tx[s + 2] = along * bx + across * by
                    ty[s + 2] = along * by - across * bx
            elif body.damped:
                for s in range(springs):
                    bx, by = x[s + 2] - x[s + 1], y[s + 2] - y[s + 1]
                    inv = inverse_root(bx * bx + by * by)
                    rate = bx * (vx[s + 2] - vx[s + 1]) + by * (vy[s + 2] - vy[s + 1])
                    along = pull[s] * inv - stiffness[s] - damping[s] * rate * (inv * inv)
                    tx[s + 2] = along * bx
                    ty[s + 2] = along * by
            else:
                for s in range(springs):
                    bx, by = x[s + 2] - x[s + 1], y[s + 2] - y[s + 1]
                    along = pull[s] * inverse_root(bx * bx + by * by) - stiffness[s]
                    tx[s + 2] = along * bx
                    ty[s + 2] = along * by
            _move(live, tx, ty, dt, masses, has_air)
            if motion.active:
                place_led(live, motion, step, steps)  # those that have a speed were moved on by it
        judge(body, live, kept, progress, count, farthest, fastest)


@kernel(apart=True, forceinline=True, fastmath=FUSED)
def _move(live, tx, ty, dt, masses, has_air):
    """v += dt F/m, then x += dt v; `masses` is their padded number."""
    eight_at_a_time()
    x, y, vx, vy = live.x, live.y, live.vx, live.vy
    w, air, gx, gy = live.dt_mass, live.dt_air, live.dt_gx, live.dt_gy
    if has_air:
        for i in range(1, masses + 1):
            u, v = vx[i], vy[i]
            u = u + ((tx[i] - tx[i + 1]) * w[i] - air[i] * (u * abs(u)) + gx[i])
            v = v + ((ty[i] - ty[i + 1]) * w[i] - air[i] * (v * abs(v)) + gy[i])
            vx[i], vy[i] = u, v
            x[i] += u * dt
            y[i] += v * dt
    else:
        for i in range(1, masses + 1):
            u = vx[i] + ((tx[i] - tx[i + 1]) * w[i] + gx[i])
            v = vy[i] + ((ty[i] - ty[i + 1]) * w[i] + gy[i])
            vx[i], vy[i] = u, v
            x[i] += u * dt
            y[i] += v * dt
