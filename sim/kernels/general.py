"""Forces and symplectic Euler on any topology; the equations stand in `chain`.

Loops that gather through indices are kept apart from loops over the springs in order, so that the latter,
which hold the square root, the division and most of the arithmetic, are vectorised.
"""

from __future__ import annotations

import math

import numpy as np

from .controls import lead_and_press
from .guard import DONE, GOOD, STRIDE, WHAT, judge, keep
from .jit import kernel
from .tables import SHORTEST_SQUARED


@kernel(inline="always")
def internal_forces(body, live, work):
    """Forces of all springs on all masses, from the state in `live`, into `work.fx` and `work.fy`."""
    x, y, vx, vy = live.x, live.y, live.vx, live.vy
    lx, ly, dvx, dvy, inverse = work.lx, work.ly, work.dvx, work.dvy, work.inverse
    turn, couple, tx, ty, fx, fy = work.turn, work.couple, work.tx, work.ty, work.fx, work.fy
    stiffness, damping, pull = body.stiffness, body.damping, live.pull
    springs = stiffness.size  # padded
    # Unsigned indices: numba otherwise tests each one for being negative.
    for s in range(body.springs):
        a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
        lx[s] = x[b] - x[a]
        ly[s] = y[b] - y[a]
    if body.damped:
        for s in range(body.springs):
            a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
            dvx[s] = vx[b] - vx[a]
            dvy[s] = vy[b] - vy[a]
    for s in range(springs):
        inverse[s] = 1.0 / math.sqrt(max(lx[s] * lx[s] + ly[s] * ly[s], SHORTEST_SQUARED))
    if body.joints:
        for j in range(body.joints):
            a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            dot = lx[a] * lx[b] + ly[a] * ly[b]
            couple[j + 1] = live.couple_cos[j + 1] * cross - live.couple_sin[j + 1] * dot
        for s in range(body.springs):
            turn[s] = couple[np.uint64(body.joint_in[s])] - couple[np.uint64(body.joint_out[s])]
        for i in range(body.more_joint.size):
            turn[body.more_joint_spring[i]] += body.more_joint_sign[i] * couple[body.more_joint[i]]
    if body.joints and body.damped:
        for s in range(springs):
            inv = inverse[s]
            inv2 = inv * inv
            rate = lx[s] * dvx[s] + ly[s] * dvy[s]
            along = pull[s] * inv - stiffness[s] - damping[s] * rate * inv2
            across = turn[s] * inv2
            tx[s] = along * lx[s] + across * ly[s]
            ty[s] = along * ly[s] - across * lx[s]
    elif body.joints:
        for s in range(springs):
            inv = inverse[s]
            along = pull[s] * inv - stiffness[s]
            across = turn[s] * (inv * inv)
            tx[s] = along * lx[s] + across * ly[s]
            ty[s] = along * ly[s] - across * lx[s]
    elif body.damped:
        for s in range(springs):
            inv = inverse[s]
            rate = lx[s] * dvx[s] + ly[s] * dvy[s]
            along = pull[s] * inv - stiffness[s] - damping[s] * rate * (inv * inv)
            tx[s] = along * lx[s]
            ty[s] = along * ly[s]
    else:
        for s in range(springs):
            along = pull[s] * inverse[s] - stiffness[s]
            tx[s] = along * lx[s]
            ty[s] = along * ly[s]
    for i in range(1, body.masses + 1):
        a, b = np.uint64(body.spring_in[i]), np.uint64(body.spring_out[i])
        fx[i] = tx[a] - tx[b]
        fy[i] = ty[a] - ty[b]
    for i in range(body.more_spring.size):
        m, s, sign = body.more_spring_mass[i], body.more_spring[i], body.more_spring_sign[i]
        fx[m] += sign * tx[s]
        fy[m] += sign * ty[s]


@kernel()
def run_general(body, live, work, motion, kept, progress, dt, steps, has_air, farthest, fastest):
    """Do `steps` steps, or as many as go well; arguments as those of `run_chain`."""
    masses = (body.masses + 7) // 8 * 8  # padded
    while progress[DONE] < steps and progress[WHAT] == GOOD:
        done = progress[DONE]
        count = min(progress[STRIDE], steps - done)
        keep(live, kept)
        for step in range(done, done + count):
            if motion.active:
                lead_and_press(body, live, motion, step, steps)
            internal_forces(body, live, work)
            general_axis(live.x, live.vx, work.fx, live.dt_mass, live.dt_air, live.dt_gx, dt, masses, has_air)
            general_axis(live.y, live.vy, work.fy, live.dt_mass, live.dt_air, live.dt_gy, dt, masses, has_air)
        judge(body, live, kept, progress, count, farthest, fastest)


@kernel()
def run_held(body, live, motion, steps):
    """The steps of a body all of whose masses are held: no forces, only the pointer and the keys."""
    for step in range(steps):
        lead_and_press(body, live, motion, step, steps)


@kernel(inline="always")
def general_axis(position, velocity, force, dt_mass, dt_air, dt_gravity, dt, masses, has_air):
    """v += dt F/m, then x += dt v, along one axis."""
    if has_air:
        for i in range(1, masses + 1):
            v = velocity[i]
            v = v + (force[i] * dt_mass[i] - dt_air[i] * (v * abs(v)) + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
    else:
        for i in range(1, masses + 1):
            v = velocity[i] + (force[i] * dt_mass[i] + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
