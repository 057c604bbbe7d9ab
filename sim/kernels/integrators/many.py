"""Many bodies of one shape, side by side: explicit methods with a fixed step.

The numbers of eight bodies lie beside each other, so that all loops are vectorised whatever connects the
masses. They run over as many springs as follow each other, with both ends counting up by one: in a chain all
of them, in a net a row. What a body does depends on none of those beside it, nor on their number.

The forces are those of `forces.springs` under the laws whose torque is a sine, still air and gravity. What
else a scene can have, this does not know; `motion.many` has the rule.
"""

from __future__ import annotations

import numpy as np

from ...forces.joints import CONSERVATIVE, NO_JOINTS
from ..core.roots import inverse_root
from ..engine.bits import from_bits, size_bits
from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time
from ..engine.table import Floats, Indices, Rows, Table

LANES = 8
"""Bodies beside each other."""


class Batch(Table):
    """Bodies of one shape: n masses, S springs, J joints; `groups` times eight of them.

    A number of each of k parts of all bodies is an array of (groups, k, 8), flat; scratch has one group.
    """

    groups: int
    masses: int
    springs: int
    joints: int
    law: int  # see `forces.joints`
    damped: bool  # any linear spring of any body has damping
    joint_damped: bool  # any angular spring has
    # Runs of springs that follow each other, and so do their masses: the first spring of each run, and that
    # behind the last run; the masses at the ends of these, counted from 0
    spring_run: Indices
    spring_a: Indices
    spring_b: Indices
    # Likewise for joints and the springs that they hold
    joint_run: Indices
    joint_a: Indices
    joint_b: Indices
    stiffness: Floats  # of springs, kg/s²
    damping: Floats  # of springs, kg/s
    rest_tension: Floats  # stiffness times rest length, kg px/s²
    torque_cos: Floats  # of joints, stiffness times the cosine of the rest angle, kg/s²
    torque_sin: Floats  # likewise with the sine
    torque_size: Floats  # stiffness of joints, kg/s²
    torque_damping: Floats  # of joints, kg/s
    inverse_mass: Floats  # 1/kg; this and the next three are zero for a mass that is held
    air: Floats  # air friction / mass, 1/px
    gx: Floats  # acceleration by gravity and constant forces, px/s²
    gy: Floats
    x: Floats  # positions, px: at first those of the start, then those of the end
    y: Floats
    vx: Floats  # velocities, px/s
    vy: Floats
    # The method, for q'' = f(q, q'): stage i is at q + c_i h v + h² sum abar_ij k_j and v + h sum a_ij k_j,
    # and the last one is the end of the step, as in `core.tables.Tableau`.
    stages: int
    c: Floats  # (stages + 1,)
    a: Rows  # (stages + 1, stages + 1)
    abar: Rows
    corrects: bool  # the velocity at the end is v + h/2 (k_0 + k_1) instead, as of velocity Verlet
    h: float  # s
    steps: int
    every: int  # steps from one sample to the next
    samples: Floats  # (groups, samples, 4, n, 8) x, y, vx and vy at the start and after each `every` steps
    far: Floats  # (groups, 8) largest coordinate of each body at any step, px; NaN counts as more than any
    fast: Floats  # (groups, 8) largest velocity component, px/s
    # Scratch
    qx: Floats  # positions and velocities at a stage
    qy: Floats
    ux: Floats
    uy: Floats
    kx: Floats  # accelerations of all stages, (stages + 1, n, 8)
    ky: Floats
    lx: Floats  # vectors of springs, px
    ly: Floats
    inverse: Floats  # 1 / length
    turning: Floats  # rates at which springs turn, 1/s
    tx: Floats  # forces on the b ends of springs, kg px/s²
    ty: Floats
    on_ax: Floats  # forces of joints on the b end of the first spring of each,
    on_ay: Floats
    on_bx: Floats  # and on that of the second
    on_by: Floats


@kernel(fastmath=FAST)
def run_batch(batch):
    """Move all bodies of a `Batch` by its steps."""
    wide, stages, h = LANES * batch.masses, batch.stages, batch.h
    x, y, vx, vy = batch.x, batch.y, batch.vx, batch.vy
    qx, qy, ux, uy, kx, ky = batch.qx, batch.qy, batch.ux, batch.uy, batch.kx, batch.ky
    samples, looks = batch.samples, batch.samples.size // batch.groups
    for group in range(batch.groups):
        here = group * wide
        take, taken = 0, group * looks
        _copy(wide, x, y, here, qx, qy, 0)
        _copy(wide, vx, vy, here, ux, uy, 0)
        for step in range(batch.steps + 1):
            # The accelerations of the start are a stage of their own; later they are those of the last end.
            for stage in range(min(step, 1), stages + 1 if step > 0 else 1):
                if stage > 0:
                    time = batch.c[stage] * h
                    _move(wide, time, x, y, vx, vy, here, qx, qy)
                    _copy(wide, vx, vy, here, ux, uy, 0)
                    for k in range(stage):
                        _add(wide, h * h * batch.abar[stage, k], kx, ky, k * wide, qx, qy)
                        _add(wide, h * batch.a[stage, k], kx, ky, k * wide, ux, uy)
                _forces(batch, group, stage * wide)
                _accelerate(
                    wide,
                    batch.inverse_mass,
                    batch.air,
                    batch.gx,
                    batch.gy,
                    here,
                    ux,
                    uy,
                    kx,
                    ky,
                    stage * wide,
                )
            if step > 0:
                if batch.corrects:
                    _copy(wide, vx, vy, here, ux, uy, 0)
                    _add(wide, 0.5 * h, kx, ky, 0, ux, uy)
                    _add(wide, 0.5 * h, kx, ky, stages * wide, ux, uy)
                _copy(wide, qx, qy, 0, x, y, here)
                _copy(wide, ux, uy, 0, vx, vy, here)
                _move_down(wide, kx, ky, stages * wide)
            if step == 0:
                batch.far[group * LANES : (group + 1) * LANES] = 0.0
                batch.fast[group * LANES : (group + 1) * LANES] = 0.0
            _note_largest(batch.masses, qx, qy, batch.far, group * LANES)
            _note_largest(batch.masses, ux, uy, batch.fast, group * LANES)
            if looks > 0 and step == take:
                _copy(wide, qx, qy, 0, samples[taken:], samples[taken + wide :], 0)
                _copy(wide, ux, uy, 0, samples[taken + 2 * wide :], samples[taken + 3 * wide :], 0)
                take, taken = take + batch.every, taken + 4 * wide


@kernel(forceinline=True)
def _span(runs, run):
    """Where the numbers of the parts of a run begin, and how many they are."""
    return LANES * runs[run], LANES * (runs[run + 1] - runs[run])


@kernel(internal=True, fastmath=FAST)
def _forces(batch, group, to):
    """Forces of springs and joints on the masses of a group, into `kx` and `ky` from index `to` on."""
    lx, ly, inverse, turning, tx, ty = batch.lx, batch.ly, batch.inverse, batch.turning, batch.tx, batch.ty
    of_springs, of_joints = group * LANES * batch.springs, group * LANES * batch.joints
    for run in range(batch.spring_a.size):
        first, size = _span(batch.spring_run, run)
        a, b = LANES * batch.spring_a[run], LANES * batch.spring_b[run]
        _pull(
            size, batch.qx, batch.qy, a, b, batch.stiffness, batch.rest_tension, of_springs + first,
            lx, ly, inverse, tx, ty, first,
        )  # fmt: skip
        if batch.damped or batch.joint_damped:
            _damp(
                size, batch.ux, batch.uy, a, b, batch.damping, of_springs + first, lx, ly, inverse, turning,
                tx, ty, first,
            )  # fmt: skip
    if batch.law != NO_JOINTS:
        for run in range(batch.joint_a.size):
            first, size = _span(batch.joint_run, run)
            a, b = LANES * batch.joint_a[run], LANES * batch.joint_b[run]
            _bend(
                batch.law, size, lx, ly, inverse, a, b, batch.torque_cos, batch.torque_sin, batch.torque_size,
                of_joints + first, batch.on_ax, batch.on_ay, batch.on_bx, batch.on_by,
            )  # fmt: skip
            if batch.joint_damped:
                _rub(
                    size, lx, ly, inverse, turning, a, b, batch.torque_damping, of_joints + first,
                    batch.on_ax, batch.on_ay, batch.on_bx, batch.on_by,
                )  # fmt: skip
            _join(size, batch.on_ax, batch.on_ay, 0, 1.0, tx, ty, a)
            _join(size, batch.on_bx, batch.on_by, 0, 1.0, tx, ty, b)
    batch.kx[to : to + LANES * batch.masses] = 0.0
    batch.ky[to : to + LANES * batch.masses] = 0.0
    for run in range(batch.spring_a.size):
        first, size = _span(batch.spring_run, run)
        _join(size, tx, ty, first, 1.0, batch.kx, batch.ky, to + LANES * batch.spring_b[run])
        _join(size, tx, ty, first, -1.0, batch.kx, batch.ky, to + LANES * batch.spring_a[run])


@kernel(noalias=True, forceinline=True)
def _copy(size, x, y, at, to_x, to_y, to):
    eight_at_a_time()
    at, to = np.uint64(at), np.uint64(to)
    for i in range(np.uint64(size)):
        to_x[to + i], to_y[to + i] = x[at + i], y[at + i]


@kernel(noalias=True, forceinline=True)
def _move_down(size, kx, ky, at):
    """Copy the accelerations of the end, which are those of the next step's start."""
    eight_at_a_time()
    at = np.uint64(at)
    for i in range(np.uint64(size)):
        kx[i], ky[i] = kx[at + i], ky[at + i]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _move(size, time, x, y, vx, vy, at, qx, qy):
    eight_at_a_time()
    at = np.uint64(at)
    for i in range(np.uint64(size)):
        qx[i], qy[i] = x[at + i] + time * vx[at + i], y[at + i] + time * vy[at + i]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _add(size, factor, kx, ky, at, qx, qy):
    eight_at_a_time()
    at = np.uint64(at)
    for i in range(np.uint64(size)):
        qx[i] += factor * kx[at + i]
        qy[i] += factor * ky[at + i]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _join(size, x, y, at, sign, to_x, to_y, to):
    """Add forces, with a sign, to those at other places."""
    eight_at_a_time()
    at, to = np.uint64(at), np.uint64(to)
    for i in range(np.uint64(size)):
        to_x[to + i] += sign * x[at + i]
        to_y[to + i] += sign * y[at + i]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _pull(size, qx, qy, a, b, stiffness, rest_tension, of, lx, ly, inverse, tx, ty, to):
    """Vectors of springs, px, 1 / length, and the forces on their b ends."""
    eight_at_a_time()
    a, b, of, to = np.uint64(a), np.uint64(b), np.uint64(of), np.uint64(to)
    for i in range(np.uint64(size)):
        dx, dy = qx[b + i] - qx[a + i], qy[b + i] - qy[a + i]
        inv = inverse_root(dx * dx + dy * dy)
        along = rest_tension[of + i] * inv - stiffness[of + i]
        lx[to + i], ly[to + i], inverse[to + i] = dx, dy, inv
        tx[to + i], ty[to + i] = along * dx, along * dy


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _damp(size, ux, uy, a, b, damping, of, lx, ly, inverse, turning, tx, ty, to):
    """Add the forces of the springs' damping; and the rates at which springs turn."""
    eight_at_a_time()
    a, b, of, to = np.uint64(a), np.uint64(b), np.uint64(of), np.uint64(to)
    for i in range(np.uint64(size)):
        du, dv = ux[b + i] - ux[a + i], uy[b + i] - uy[a + i]
        dx, dy = lx[to + i], ly[to + i]
        inv2 = inverse[to + i] * inverse[to + i]
        along = damping[of + i] * (dx * du + dy * dv) * inv2
        turning[to + i] = (dx * dv - dy * du) * inv2
        tx[to + i] -= along * dx
        ty[to + i] -= along * dy


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _bend(law, size, lx, ly, inverse, a, b, cos, sin, strength, of, on_ax, on_ay, on_bx, on_by):
    """The forces of joints on the b ends of their springs A and B.

    Under the conservative law K R(-r) B - K |B| A / |A| and K R(r) A - K |A| B / |B|; under the tutorial's
    those of the torque K |A||B| sin(V - r).
    """
    eight_at_a_time()
    a, b, of = np.uint64(a), np.uint64(b), np.uint64(of)
    if law == CONSERVATIVE:
        for i in range(np.uint64(size)):
            ax, ay, bx, by = lx[a + i], ly[a + i], lx[b + i], ly[b + i]
            both = strength[of + i] * inverse[a + i] * inverse[b + i]
            by_a, by_b = both * (bx * bx + by * by), both * (ax * ax + ay * ay)
            c, s = cos[of + i], sin[of + i]
            on_ax[i], on_ay[i] = c * bx + s * by - by_a * ax, c * by - s * bx - by_a * ay
            on_bx[i], on_by[i] = c * ax - s * ay - by_b * bx, c * ay + s * ax - by_b * by
    else:
        for i in range(np.uint64(size)):
            ax, ay, bx, by = lx[a + i], ly[a + i], lx[b + i], ly[b + i]
            torque = cos[of + i] * (ax * by - ay * bx) - sin[of + i] * (ax * bx + ay * by)
            by_a, by_b = torque * inverse[a + i] * inverse[a + i], torque * inverse[b + i] * inverse[b + i]
            on_ax[i], on_ay[i] = -by_a * ay, by_a * ax
            on_bx[i], on_by[i] = by_b * by, -by_b * bx


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _rub(size, lx, ly, inverse, turning, a, b, damping, of, on_ax, on_ay, on_bx, on_by):
    """Add those of the joints' damping, whose torque is C |A||B| times the rate of the angle."""
    eight_at_a_time()
    a, b, of = np.uint64(a), np.uint64(b), np.uint64(of)
    for i in range(np.uint64(size)):
        inv_a, inv_b = inverse[a + i], inverse[b + i]
        torque = damping[of + i] / (inv_a * inv_b) * (turning[b + i] - turning[a + i])
        by_a, by_b = torque * inv_a * inv_a, torque * inv_b * inv_b
        on_ax[i] -= by_a * ly[a + i]
        on_ay[i] += by_a * lx[a + i]
        on_bx[i] += by_b * ly[b + i]
        on_by[i] -= by_b * lx[b + i]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _accelerate(size, w, air, gx, gy, of, ux, uy, ax, ay, to):
    """Make accelerations of forces, in place."""
    eight_at_a_time()
    of, to = np.uint64(of), np.uint64(to)
    for i in range(np.uint64(size)):
        ax[to + i] = ax[to + i] * w[of + i] - air[of + i] * (ux[i] * abs(ux[i])) + gx[of + i]
        ay[to + i] = ay[to + i] * w[of + i] - air[of + i] * (uy[i] * abs(uy[i])) + gy[of + i]


@kernel(noalias=True, forceinline=True)
def _note_largest(masses, x, y, largest, at):
    """Enter the largest sizes of each body's numbers; as bits, among which those of NaN are the largest."""
    eight_at_a_time()
    for i in range(LANES):
        most = size_bits(largest[at + i])
        for m in range(masses):
            most = max(most, size_bits(x[LANES * m + i]), size_bits(y[LANES * m + i]))
        largest[at + i] = from_bits(most)
