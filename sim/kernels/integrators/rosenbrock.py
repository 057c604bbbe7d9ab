"""Rosenbrock methods: implicit methods with one linear solve per stage, all with the same matrix.

Velocities are eliminated: with g = 1 / (gamma h), a stage (x, w) of (q, v) solves
(g² I - g Jv - Jx) x = r_v + g r_q - Jv r_q, and w = g x - r_q.
"""

from __future__ import annotations

from ..core.drive import act_at, drive_to
from ..core.jit import FAST, kernel
from ..core.lanes import eight_at_a_time
from ..core.shared import accelerate, accumulate, add_damping, bears, factorise, keeps_apart, settle, solve
from ..core.tables import (
    ARM_ALPHA,
    AUTO_STEP,
    CONTROLLER_STEP,
    CONTROLLER_TIME,
    COUNT_FORCES,
    COUNT_MATRICES,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
    SPARE,
)
from .guard import GOOD, sound
from .steps import (
    HOPELESS,
    WORTH_SHORTENING,
    ensure_acceleration,
    first_step,
    fitting_step,
    is_gentle,
    largest_sum,
    replace_state,
    step_after,
)
from .turning import remember

_MOST_STAGES = 8
"""Largest number of stages of a method."""

_SPAN = 5e-3
"""Any step may use at least the tolerance of this many seconds. Stiff motions decay within such a time, and
an implicit method is meant to avoid following them."""


@kernel(fastmath=FAST)
def run_rosenbrock(problem, drive, end, tolerance, attempts):
    """Advance to `end` with the method `problem.implicit`; arguments as of `run_verlet`."""
    eight_at_a_time()
    ensure_acceleration(problem, drive)
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    method, fixed = problem.implicit, problem.fixed
    controller, count = integrator.controller, integrator.counts
    q, v, rows = state.q, state.v, integrator.rows
    xs, ws = rows[:_MOST_STAGES], rows[_MOST_STAGES : 2 * _MOST_STAGES]
    to_q, to_v, to_a = rows[2 * _MOST_STAGES], rows[2 * _MOST_STAGES + 1], rows[2 * _MOST_STAGES + 2]
    rest, right, by_time = rows[2 * _MOST_STAGES + 3], rows[2 * _MOST_STAGES + 4], rows[2 * _MOST_STAGES + 5]
    stages = method.stages
    t, h = controller[CONTROLLER_TIME], controller[CONTROLLER_STEP]
    if fixed > 0.0:
        h = fixed
    elif h <= 0.0:
        h = first_step(integrator, drive, 0.01 * tolerance)
    failed = False
    for _ in range(attempts):
        if not (t < end and count[COUNT_WHAT] == GOOD):
            break
        step = fitting_step(t, end, h)
        g = 1.0 / (method.gamma * step)
        regular = factorise(problem, q, v, g * g, g, False)
        if drive.moving:
            _by_time(problem, drive, t, step, to_q, to_v, to_a, by_time)
        count[COUNT_MATRICES] += 1
        for i in range(stages + 1):
            if i == 0:
                for j in range(1, q.size - SPARE):
                    to_a[j], rest[j], right[j] = integrator.a[j], v[j], 0.0
            else:
                _combine(
                    q, v, method.a[i], method.coupling[i], 1.0 / step, xs, ws, i, to_q, to_v, rest, right
                )
                if drive.moving:
                    drive_to(body, state, drive, t + method.c[i] * step, to_q, to_v)
                accelerate(problem, to_q, to_v, to_a)
            if i == stages:
                break
            x, w = xs[i], ws[i]
            if drive.moving:
                slope = method.slope[i] * step
                for j in range(1, q.size - SPARE):
                    right[j] += slope * by_time[j]
                for k in range(drive.mass.size):
                    m = drive.mass[k]
                    rest[m], rest[q.size // 2 + m] = 0.0, 0.0
            for j in range(1, q.size - SPARE):
                x[j] = to_a[j] + right[j] + g * rest[j]
            if drive.timed:  # the derivatives are those at the start of the step, like the matrix
                state.clock[0] = t
            add_damping(problem, v, rest, -1.0, x)
            solve(problem, x)
            for j in range(1, q.size - SPARE):
                w[j] = g * x[j] - rest[j]
        count[COUNT_FORCES] += stages
        error = 0.0
        if fixed == 0.0:
            error = largest_sum(method.error, xs, stages, rest) / (max(step, _SPAN) * tolerance)
            if not error < HOPELESS:
                error = HOPELESS
        good = (
            regular
            and error <= 1.0
            and sound(body, integrator, to_q, to_v, fixed > 0.0 or step < WORTH_SHORTENING)
        )
        if good and fixed == 0.0:
            good = is_gentle(body, state, q, to_q, step) and keeps_apart(problem, q, to_q)
            good = good and (step < WORTH_SHORTENING or bears(problem, to_q, tolerance))
        if good:
            if balance.active:
                accumulate(problem, drive, t, to_q, to_v, to_a, step)
            t = end if step == end - t else t + step
            if integrator.history.shape[0] > 0:  # in case generalized-alpha goes on from here
                remember(problem, step, 0.5 * integrator.selector[AUTO_STEP + ARM_ALPHA])
            replace_state(q, v, integrator.a, to_q, to_v, to_a)
            settle(problem, q)
            count[COUNT_STEPS] += 1
        else:
            error = max(error, 2.0)
            count[COUNT_REJECTED] += 1
            for i in range(2 * _MOST_STAGES):  # sums include stages with weight zero, which may be NaN
                for j in range(1, q.size - SPARE):
                    rows[i, j] = 0.0
            act_at(body, state, drive, t)
        if fixed == 0.0:
            h = step_after(integrator, h, step, error, method.order, good, failed)
            failed = not good
    controller[CONTROLLER_TIME] = t
    controller[CONTROLLER_STEP] = h


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _combine(q, v, a, c, per_step, xs, ws, count, to_q, to_v, rest, right):
    """Positions and velocities of a stage, and what earlier stages add to its right-hand side.

    to_q = q + sum a x, to_v = v + sum a w, rest = to_v + sum c x / h, right = sum c w / h.
    """
    eight_at_a_time()
    for i in range(0, count, 4):
        a0, a1, a2, a3 = a[i], a[i + 1], a[i + 2], a[i + 3]
        c0, c1, c2, c3 = per_step * c[i], per_step * c[i + 1], per_step * c[i + 2], per_step * c[i + 3]
        x0, x1, x2, x3 = xs[i], xs[i + 1], xs[i + 2], xs[i + 3]
        w0, w1, w2, w3 = ws[i], ws[i + 1], ws[i + 2], ws[i + 3]
        if i == 0:
            for j in range(1, q.size - SPARE):
                to_v[j] = v[j] + (a0 * w0[j] + a1 * w1[j] + a2 * w2[j] + a3 * w3[j])
                to_q[j] = q[j] + (a0 * x0[j] + a1 * x1[j] + a2 * x2[j] + a3 * x3[j])
                rest[j] = to_v[j] + (c0 * x0[j] + c1 * x1[j] + c2 * x2[j] + c3 * x3[j])
                right[j] = c0 * w0[j] + c1 * w1[j] + c2 * w2[j] + c3 * w3[j]
        else:
            for j in range(1, q.size - SPARE):
                more = a0 * w0[j] + a1 * w1[j] + a2 * w2[j] + a3 * w3[j]
                to_v[j] += more
                to_q[j] += a0 * x0[j] + a1 * x1[j] + a2 * x2[j] + a3 * x3[j]
                rest[j] += more + (c0 * x0[j] + c1 * x1[j] + c2 * x2[j] + c3 * x3[j])
                right[j] += c0 * w0[j] + c1 * w1[j] + c2 * w2[j] + c3 * w3[j]


@kernel(fastmath=FAST)
def _by_time(problem, drive, t, h, q, v, a, out):
    """The derivative of the accelerations with respect to time, at fixed positions of the free masses.

    It is a difference quotient over a small part of the step: driven motion is smooth within a call.
    """
    body, state = problem.body, problem.state
    part = 1e-4 * h
    for j in range(1, q.size - SPARE):
        q[j], v[j] = state.q[j], state.v[j]
        out[j] = 0.0
    for sign in (1.0, -1.0):
        drive_to(body, state, drive, t + sign * part, q, v)
        accelerate(problem, q, v, a)
        for j in range(1, q.size - SPARE):
            out[j] += sign * a[j] / (2.0 * part)
    if drive.pressed or drive.timed:
        drive_to(body, state, drive, t, q, v)
