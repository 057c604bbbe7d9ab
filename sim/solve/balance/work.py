"""The energy balance of a step: the work of everything that changes the energy of a body."""

from __future__ import annotations

import math

from ...engine.calls import accelerate
from ...engine.jit import FAST, kernel
from ...engine.numerics.waves import KIND, PULSE, RATE, RISE, SHARPNESS, STEER
from ...forces.all import add_power, forces
from ...forces.drive import drive_to, hand_speed, lead_of
from ...forces.joints import TUTORIAL, joint_power_of_keys, power_of_law
from ...forces.muscles import power_of_muscles
from ...forces.plasticity import yield_at
from ...forces.resistance import gather_other_powers, mark_stiff_resistance, work_of_stiff_resistance
from ...forces.springs import spring_power_of_keys
from ...forces.touch.walls import gather_others, mark_stiff_friction, work_of_quick
from .dissipation import dissipated_energy, gather_dampers

_ACCELERATION = 3
"""Row of accelerations in the scratch `EnergyBalance.rows`."""

_NODES = (0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15))
"""Gauss-Legendre nodes on (0, 1), of order six."""
_WEIGHTS = (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)
"""Weights of the nodes."""
_MAX_PARTS = 1000.0
"""Maximum number of parts of a step, less one; there is one for each radian of the fastest muscle. Doubled or
halved, no test fails."""


@kernel(fastmath=FAST)
def between(h, u, q0, v0, a0, q1, v1, a1, q, v):
    """Interpolate positions and velocities at the fraction u of a step of length h, into q and v.

    The quintic Hermite polynomial through positions, velocities and accelerations at both ends is used; its
    position error is of the order h⁶.
    """
    for j in range(q.size):
        # The polynomial is q0 + h v0 u + h² a0 u²/2 + u³ (c3 + c4 u + c5 u²).
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
    """Return whether the accelerations at both ends of a step are consistent with its positions and
    velocities.

    In an implicit step of a stiff body they are not: they are small differences of large forces, and the
    quintic would overshoot far beyond both ends.
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
    """Interpolate like `between`, with the cubic through positions and velocities at both ends."""
    for j in range(q0.size):
        d = q1[j] - q0[j] - h * v0[j]
        e = h * (v1[j] - v0[j])
        c2, c3 = 3.0 * d - e, e - 2.0 * d
        q[j] = q0[j] + u * (h * v0[j] + u * (c2 + u * c3))
        v[j] = v0[j] + u * (2.0 * c2 + u * 3.0 * c3) / h


@kernel(fastmath=FAST)
def accumulate_work(problem, drive, t, q1, v1, a1, h):
    """Add the work of a step of length h from the current state, at time t, to q1, v1, a1."""
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    q, v, a = balance.rows[0], balance.rows[1], balance.rows[_ACCELERATION]
    smooth = _is_smooth(h, state.q, state.v, integrator.a, q1, v1, a1)
    balance.dampers[:] = 0.0
    quick = balance.quick
    any_quick = False
    if quick.shape[0] > 0:
        quick[:] = 0.0
        any_quick = mark_stiff_friction(body, state.inverse_mass, state.q, q1, h, quick)
        any_quick = mark_stiff_resistance(body, state.inverse_mass, q1, h, quick) or any_quick
    parts = _parts_for_muscles(body, h)
    for i in range(3 * parts):
        u, weight = (i // 3 + _NODES[i % 3]) / parts, _WEIGHTS[i % 3] / parts
        if smooth:
            between(h, u, state.q, state.v, integrator.a, q1, v1, a1, q, v)
        else:
            _roughly_between(h, u, state.q, state.v, q1, v1, q, v)
        if drive.moving:
            drive_to(body, state, drive, t + u * h, q, v)
        _add_powers(problem, drive, t + u * h, weight * h, q, v)
        if any_quick:
            accelerate(problem, q, v, a)
            gather_others(body, state, q, v, a, weight, quick)
            gather_other_powers(body, state, q, v, a, weight, quick)
        gather_dampers(body, q, v, weight, balance.dampers)
    if any_quick:
        balance.work.walls += work_of_quick(body, state.v, v1, h, quick)
        work_of_stiff_resistance(body, balance, state.v, v1, h)
    balance.work.damping -= dissipated_energy(body, state.inverse_mass, state.q, state.v, h, balance.dampers)
    if drive.pressed or drive.timed:
        drive_to(body, state, drive, t + h, q, v)


@kernel(internal=True, fastmath=FAST)
def _parts_for_muscles(body, h):
    """Return the number of parts of a step of h seconds, each with nodes of its own, so that none skips waves
    of muscles: a step may be longer than several of them."""
    quickest, muscles = 0.0, body.muscles
    for rows in (muscles.stretch, muscles.turn):
        for i in range(rows.shape[0]):
            sharper = 1.0 + SHARPNESS if rows[i, KIND] == PULSE else 1.0
            rise = 1.0 / RISE if rows[i, STEER] >= 0.0 else 0.0
            quickest = max(quickest, abs(rows[i, RATE]) * sharper + rise)
    return 1 + int(min(quickest * h, _MAX_PARTS))


@kernel(fastmath=FAST)
def _add_powers(problem, drive, t, h, q, v):
    """Add h times the powers in the state q, v at time t."""
    body, state, balance = problem.body, problem.state, problem.balance
    slots, work, still, true = q.size // 2, balance.work, balance.rows[2], balance.rows[_ACCELERATION]
    for j in range(v.size):
        true[j] = v[j]
    for i in range(drive.mass.size):  # in `v`, the velocity of a guided mass may be zero
        m, lead = drive.mass[i], lead_of(drive, i)
        ux, uy = hand_speed(lead, t - drive.start)
        true[m] += (1.0 - lead.hand) * ux
        true[slots + m] += (1.0 - lead.hand) * uy
    if body.limits.present:
        yield_at(body, state, q)
    if drive.mass.size > 0:
        # Guided masses do work at their true velocities against all forces except those of dampers, friction
        # and bouncing, and against these at the velocities used by the forces.
        _add_work_of_anchors(problem, drive, q, still, true, h)
        if body.damped or body.joint_damped or body.environment.contact.present:
            _add_work_of_anchors(problem, drive, q, still, v, -h)
            _add_work_of_anchors(problem, drive, q, v, v, h)
    add_power(body, state, balance, q, v, h)
    if body.law == TUTORIAL:
        work.law += h * power_of_law(body, state, q, true)
    if drive.pressed:
        keys = spring_power_of_keys(body, state, drive.growth, q)
        work.keys += h * (keys + joint_power_of_keys(body, state, drive.turn, q))
    if body.muscles.present:
        work.muscles += h * power_of_muscles(body, state, q, t)


@kernel(fastmath=FAST)
def _add_work_of_anchors(problem, drive, q, v, rate, h):
    """Add h times the power of guided masses, at velocities `rate`, against the forces at velocities v."""
    body, state, scratch, slots = problem.body, problem.state, problem.scratch, q.size // 2
    forces(body, state, scratch, q, v)
    for i in range(drive.mass.size):
        m = drive.mass[i]
        power = scratch.fx[m] * rate[m] + scratch.fy[m] * rate[slots + m]
        problem.balance.work.anchors -= h * power
