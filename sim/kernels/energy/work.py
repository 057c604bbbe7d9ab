"""The energy balance of a step: the work of everything that changes a body's energy."""

from __future__ import annotations

import math

from ..around.contact import power_of_contact, push_apart
from ..around.fillings import press_from_inside
from ..around.walls import gather_others, mark_quick, power_of_walls, work_of_quick
from ..around.wind import power_of_wind
from ..core.jit import FAST, kernel
from ..core.shared import accelerate
from ..core.vectors import deflection, length_of
from ..forces.drive import drive_to, hand_speed
from ..forces.forces import spring_forces
from ..forces.laws import TUTORIAL, is_sine, terms
from .dissipation import gather_dampers, taken_away

_ACCELERATION = 3
"""Row of accelerations in the scratch `EnergyBalance.rows`."""
QUICK_ROW = 4
"""From this row on, there is one for each wall, see `mark_quick`; none by methods of first order, which move
masses by other speeds than those that they have on average."""

_NODES = (0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15))
"""Gauss-Legendre nodes on (0, 1), of order six."""
_WEIGHTS = (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)
"""Their weights."""


@kernel(fastmath=FAST)
def between(h, u, q0, v0, a0, q1, v1, a1, q, v):
    """Interpolate positions and velocities at the fraction u of a step of length h, into q and v.

    The quintic Hermite polynomial through positions, velocities and accelerations at both ends; the error of
    positions is of the order h⁶.
    """
    for j in range(q.size):
        # Of the polynomial q0 + h v0 u + h² a0 u²/2 + u³ (c3 + c4 u + c5 u²).
        d = q1[j] - q0[j] - h * v0[j] - 0.5 * h * h * a0[j]
        e = h * (v1[j] - v0[j]) - h * h * a0[j]
        f = h * h * (a1[j] - a0[j])
        c3 = 10.0 * d - 4.0 * e + 0.5 * f
        c4 = -15.0 * d + 7.0 * e - f
        c5 = 6.0 * d - 3.0 * e + 0.5 * f
        q[j] = q0[j] + u * (h * v0[j] + u * (0.5 * h * h * a0[j] + u * (c3 + u * (c4 + u * c5))))
        v[j] = v0[j] + u * (h * a0[j] + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)) / h)


@kernel(fastmath=FAST)
def _is_smooth(h, q0, v0, a0, q1, v1, a1):
    """Whether the accelerations at both ends of a step are consistent with its positions and velocities.

    In an implicit step of a stiff body they are not: they are small differences of large forces, and the
    quintic would swing far beyond both ends.
    """
    off, way = 0.0, 0.0
    for j in range(q0.size):
        d = 6.0 * (q1[j] - q0[j])
        off = max(off, abs(h * h * a0[j] - d + h * (4.0 * v0[j] + 2.0 * v1[j])))
        off = max(off, abs(h * h * a1[j] + d - h * (2.0 * v0[j] + 4.0 * v1[j])))
        way = max(way, h * abs(v0[j]), h * abs(v1[j]))
    return off < 0.5 * way


@kernel(fastmath=FAST)
def _roughly_between(h, u, q0, v0, q1, v1, q, v):
    """Like `between`, by the cubic through positions and velocities at both ends."""
    for j in range(q0.size):
        d = q1[j] - q0[j] - h * v0[j]
        e = h * (v1[j] - v0[j])
        c2, c3 = 3.0 * d - e, e - 2.0 * d
        q[j] = q0[j] + u * (h * v0[j] + u * (c2 + u * c3))
        v[j] = v0[j] + u * (2.0 * c2 + u * 3.0 * c3) / h


@kernel(fastmath=FAST)
def accumulate_work(problem, drive, t, q1, v1, a1, h):
    """Add the work of a step of length h from the present state, at time t, to q1, v1, a1."""
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    q, v, still = balance.rows[0], balance.rows[1], balance.rows[2]
    smooth = _is_smooth(h, state.q, state.v, integrator.a, q1, v1, a1)
    balance.dampers[:] = 0.0
    quick, a = balance.rows[QUICK_ROW:], balance.rows[_ACCELERATION]
    any_quick = quick.shape[0] > 0 and mark_quick(body, state.inverse_mass, state.q, q1, h, quick)
    for i in range(3):
        u = _NODES[i]
        if smooth:
            between(h, u, state.q, state.v, integrator.a, q1, v1, a1, q, v)
        else:
            _roughly_between(h, u, state.q, state.v, q1, v1, q, v)
        if drive.moving:
            drive_to(body, state, drive, t + u * h, q, v)
        _add_powers(problem, drive, t + u * h, _WEIGHTS[i] * h, q, v, still, quick)
        if any_quick:
            accelerate(problem, q, v, a)
            gather_others(body, q, v, a, _WEIGHTS[i], quick)
        gather_dampers(body, q, v, _WEIGHTS[i], balance.dampers)
    if any_quick:
        balance.work.walls += work_of_quick(body, state.v, v1, h, quick)
    balance.work.damping -= taken_away(body, state.inverse_mass, state.q, state.v, h, balance.dampers)
    if drive.pressed or drive.gusty:
        drive_to(body, state, drive, t + h, q, v)


@kernel(fastmath=FAST)
def _add_powers(problem, drive, t, h, q, v, still, quick):
    """Add h times the powers in the state q, v at time t. `still` is all zeros; `quick`: see `mark_quick`."""
    body, state, scratch, balance = problem.body, problem.state, problem.scratch, problem.balance
    slots = q.size // 2
    x, y, vx, vy = q[:slots], q[slots:], v[:slots], v[slots:]
    work, mass = balance.work, balance.mass
    fx, fy, free = scratch.fx, scratch.fy, state.inverse_mass
    # The force of springs, joints, fillings and contact, and then that of the dampers, friction and bouncing.
    _internal_forces(body, state, scratch, x, y, still[:slots], still[slots:])
    for i in range(drive.mass.size):
        m = drive.mass[i]
        # Its true velocity; in `v` it may be zero.
        ux, uy = hand_speed(drive, i, t)
        tx, ty = vx[m] + (1.0 - drive.hand[i]) * ux, vy[m] + (1.0 - drive.hand[i]) * uy
        work.anchors -= h * (fx[m] * tx + fy[m] * ty)
    for i in range(1, body.masses + 1):
        if free[i] > 0.0:
            drag = state.air[i] * mass[i]
            work.air -= h * drag * (vx[i] * vx[i] * abs(vx[i]) + vy[i] * vy[i] * abs(vy[i]))
    if body.surroundings.present:
        work.walls += h * power_of_walls(body, free, x, y, vx, vy, quick)
        work.air += h * power_of_wind(body, state, x, y, vx, vy)
        if body.surroundings.contact.present:
            work.walls += h * power_of_contact(body, free, x, y, vx, vy)
    damped = body.damped or body.joint_damped or body.surroundings.contact.present
    if damped and drive.mass.size > 0:
        for i in range(drive.mass.size):
            m = drive.mass[i]
            work.anchors += h * (fx[m] * vx[m] + fy[m] * vy[m])
        _internal_forces(body, state, scratch, x, y, vx, vy)
        for i in range(drive.mass.size):
            m = drive.mass[i]
            work.anchors -= h * (fx[m] * vx[m] + fy[m] * vy[m])
    if body.law == TUTORIAL:
        work.law += h * _power_of_law(body, state, x, y, vx, vy, drive, t)
    if drive.pressed:
        work.keys += h * _power_of_keys(body, state, drive, x, y)


@kernel(fastmath=FAST)
def _internal_forces(body, state, scratch, x, y, vx, vy):
    """The forces of springs, joints, fillings and contact on all masses, into `fx` and `fy` of `scratch`."""
    spring_forces(body, state, scratch, x, y, vx, vy)
    if body.surroundings.present:
        press_from_inside(body.surroundings, x, y, scratch.fx, scratch.fy)
        if body.surroundings.contact.present:
            push_apart(body, state.inverse_mass, x, y, vx, vy, scratch.fx, scratch.fy)


@kernel(fastmath=FAST)
def _power_of_law(body, state, x, y, vx, vy, drive, t):
    """Power of the tutorial's law that no energy accounts for: U (|A|'/|A| + |B|'/|B|) of each joint."""
    power = 0.0
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        ax, ay, bx, by = x[a1] - x[a0], y[a1] - y[a0], x[b1] - x[b0], y[b1] - y[b0]
        aa, bb = length_of(ax, ay, body.softening), length_of(bx, by, body.softening)
        size, cos, sin = body.torque_size[j + 1], state.torque_cos[j + 1], state.torque_sin[j + 1]
        # The rate of the conservative law's energy, and the power of the tutorial's torque.
        ux, uy = _true(drive, t, a0, a1, vx, vy)
        wx, wy = _true(drive, t, b0, b1, vx, vy)
        torque = cos * (ax * by - ay * bx) - sin * (ax * bx + ay * by)
        power += size * bb / aa * (ax * ux + ay * uy) + size * aa / bb * (bx * wx + by * wy)
        power -= ux * (cos * bx + sin * by) + uy * (cos * by - sin * bx)
        power -= wx * (cos * ax - sin * ay) + wy * (cos * ay + sin * ax)
        power -= torque * ((ay * ux - ax * uy) / (aa * aa) - (by * wx - bx * wy) / (bb * bb))
    return power


@kernel(fastmath=FAST)
def _true(drive, t, a, b, vx, vy):
    """The rate of a spring's vector from mass a to b at time t, with the true velocities of hands."""
    ux, uy = vx[b] - vx[a], vy[b] - vy[a]
    for i in range(drive.mass.size):
        sign = (1.0 - drive.hand[i]) * ((drive.mass[i] == b) - (drive.mass[i] == a))
        if sign != 0.0:
            hx, hy = hand_speed(drive, i, t)
            ux, uy = ux + sign * hx, uy + sign * hy
    return ux, uy


@kernel(fastmath=FAST)
def _power_of_keys(body, state, drive, x, y):
    """The power of changing rest lengths and rest angles."""
    power = 0.0
    for s in range(body.springs):
        if body.stiffness[s] > 0.0:
            a, b = body.spring_a[s], body.spring_b[s]
            length = length_of(x[b] - x[a], y[b] - y[a], body.softening)
            stretch = body.stiffness[s] * length - state.pull[s]
            power -= stretch * drive.growth * state.pull[s] / body.stiffness[s]
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        ax, ay, bx, by = x[a1] - x[a0], y[a1] - y[a0], x[b1] - x[b0], y[b1] - y[b0]
        off = deflection(ax * by - ay * bx, ax * bx + ay * by, state.torque_rest[j + 1])
        aa, bb = ax * ax + ay * ay, bx * bx + by * by
        weight = math.sqrt(aa * bb)
        if not is_sine(body.law):
            weight = aa * bb / (length_of(ax, ay, body.softening) * length_of(bx, by, body.softening))
        torque = body.torque_size[j + 1] * weight * terms(body.law, off)[0]
        power -= torque * math.radians(drive.turn)
    return power
