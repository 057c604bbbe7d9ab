"""Symplectic Euler on a chain: every array is read and written in order, so every loop is vectorised.

With L_s the vector of spring s and perp(L) = (L.y, -L.x), the force on the b end of spring s is
T_s = (k rest/|L| - k - c L.dv/|L|²) L_s + (G_{s-1} - G_s)/|L|² perp(L_s), and joint j between springs j
and j + 1 has the couple G_j = K cos r (L_j x L_{j+1}) - K sin r (L_j . L_{j+1}): the tutorial's forces
without unit vectors, one square root and one division a spring.
"""

from __future__ import annotations

import math

from .controls import lead_and_press
from .guard import DONE, GOOD, STRIDE, WHAT, judge, keep
from .jit import kernel


@kernel()
def run_chain(body, live, work, motion, kept, progress, dt, steps, has_air, farthest, fastest):
    """Do `steps` steps, or as many as go well; `progress` tells. `live` ends at the last good state."""
    masses = live.x.size - 1  # padded; the loops below look one place ahead
    x, y, vx, vy = live.x, live.y, live.vx, live.vy
    lx, ly, inverse, couple, tx, ty = work.lx, work.ly, work.inverse, work.couple, work.tx, work.ty
    stiffness, damping, pull = body.stiffness, body.damping, live.pull
    cos, sin = live.couple_cos, live.couple_sin
    has_joints = body.joints > 0
    while progress[DONE] < steps and progress[WHAT] == GOOD:
        done = progress[DONE]
        count = min(progress[STRIDE], steps - done)
        keep(live, kept)
        for step in range(done, done + count):
            if motion.active:
                lead_and_press(body, live, motion, step, steps)
            # Few arrays a loop: before each, the compiled code checks at run time that its arrays do not
            # overlap, and for a short chain that costs more than another loop does.
            for s in range(masses):
                lx[s] = x[s + 1] - x[s]
            for s in range(masses):
                ly[s] = y[s + 1] - y[s]
            for s in range(masses):
                inverse[s] = 1.0 / math.sqrt(lx[s] * lx[s] + ly[s] * ly[s])
            if has_joints:
                for s in range(masses):
                    cross = lx[s] * ly[s + 1] - ly[s] * lx[s + 1]
                    dot = lx[s] * lx[s + 1] + ly[s] * ly[s + 1]
                    couple[s + 1] = cos[s] * cross - sin[s] * dot
            # tx[s + 1] belongs to spring s, and tx[0] stays zero: no spring ends at the first mass.
            if has_joints and body.damped:
                for s in range(masses):
                    inv = inverse[s]
                    inv2 = inv * inv
                    rate = lx[s] * (vx[s + 1] - vx[s]) + ly[s] * (vy[s + 1] - vy[s])
                    along = pull[s] * inv - stiffness[s] - damping[s] * rate * inv2
                    across = (couple[s] - couple[s + 1]) * inv2
                    tx[s + 1] = along * lx[s] + across * ly[s]
                    ty[s + 1] = along * ly[s] - across * lx[s]
            elif has_joints:
                for s in range(masses):
                    inv = inverse[s]
                    along = pull[s] * inv - stiffness[s]
                    across = (couple[s] - couple[s + 1]) * (inv * inv)
                    tx[s + 1] = along * lx[s] + across * ly[s]
                    ty[s + 1] = along * ly[s] - across * lx[s]
            elif body.damped:
                for s in range(masses):
                    inv = inverse[s]
                    rate = lx[s] * (vx[s + 1] - vx[s]) + ly[s] * (vy[s + 1] - vy[s])
                    along = pull[s] * inv - stiffness[s] - damping[s] * rate * (inv * inv)
                    tx[s + 1] = along * lx[s]
                    ty[s + 1] = along * ly[s]
            else:
                for s in range(masses):
                    along = pull[s] * inverse[s] - stiffness[s]
                    tx[s + 1] = along * lx[s]
                    ty[s + 1] = along * ly[s]
            chain_axis(x, vx, tx, live.dt_mass, live.dt_air, live.dt_gx, dt, has_air)
            chain_axis(y, vy, ty, live.dt_mass, live.dt_air, live.dt_gy, dt, has_air)
        judge(body, live, kept, progress, count, farthest, fastest)


@kernel(inline="always")
def chain_axis(position, velocity, tension, dt_mass, dt_air, dt_gravity, dt, has_air):
    """v += dt F/m, then x += dt v, along one axis."""
    masses = position.size - 1
    if has_air:
        for i in range(masses):
            v = velocity[i]
            force = (tension[i] - tension[i + 1]) * dt_mass[i]
            v = v + (force - dt_air[i] * (v * abs(v)) + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
    else:
        for i in range(masses):
            force = (tension[i] - tension[i + 1]) * dt_mass[i]
            v = velocity[i] + (force + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
