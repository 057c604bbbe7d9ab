"""Rosenbrock methods: implicit methods with one linear solve per stage, all with the same matrix.

Velocities are eliminated: with g = 1 / (gamma h), a stage (x, w) of (q, v) solves
(g² I - g Jv - Jx) x = r_v + g r_q - Jv r_q, and w = g x - r_q.
"""

from __future__ import annotations

from ...engine.calls import accelerate, add_damping, factorise, solve
from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import ALPHA, SPARE
from ...forces.drive import apply_controls_at, drive_to
from ...forces.plasticity import freeze_active_set
from .common import HOPELESS, first_step, largest_sum, step_after
from .loop import advance
from .turning import store_direction

_MAX_STAGES = 8
"""Largest number of stages of a method."""

_SPAN = 5e-3
"""Any step may use at least the tolerance of this many seconds. Stiff motions decay within such a time, and
an implicit method is meant to avoid following them. By experiment: doubled, RODAS takes 6 to 10 % less work
with 23 % larger errors; halved, 1 to 4 % more work."""
_SHORT = 4.0
"""That span as a multiple of the step, at most, where anything yields or breaks. Else the speed that a short
step may miss at a kink would be unbounded. With walls or contact there is none: collisions are too short."""


@kernel(fastmath=FAST)
def run_rosenbrock(problem, drive, end, tolerance, attempts):
    """Advance to `end` by the method `problem.implicit`; see `advance` for the arguments."""
    advance(problem, drive, end, tolerance, attempts, _begin, _step, _control, 2.0, True)


@kernel(internal=True, fastmath=FAST)
def _begin(problem, drive, tolerance):
    """See `advance`."""
    run = problem.integrator.run
    if run.step <= 0.0:
        run.step = first_step(problem.integrator, drive, 0.01 * tolerance)


@kernel(internal=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """See `advance`."""
    eight_at_a_time()
    body, state, integrator, method = problem.body, problem.state, problem.integrator, problem.implicit
    q, v, to_q, to_v, to_a, rows = old.q, old.v, new.q, new.v, new.a, integrator.rows
    xs, ws = rows[:_MAX_STAGES], rows[_MAX_STAGES : 2 * _MAX_STAGES]
    rest, right, by_time = rows[2 * _MAX_STAGES], rows[2 * _MAX_STAGES + 1], rows[2 * _MAX_STAGES + 2]
    stages = method.stages
    g = 1.0 / (method.gamma * h)
    regular = factorise(problem, q, v, g * g, g, False)
    if drive.moving:
        _by_time(problem, drive, old, t, h, to_q, to_v, to_a, by_time)
    for i in range(stages + 1):
        if i == 0:
            for j in range(1, q.size - SPARE):
                to_a[j], rest[j], right[j] = old.a[j], v[j], 0.0
        else:
            _combine(q, v, method.a[i], method.coupling[i], 1.0 / h, xs, ws, i, to_q, to_v, rest, right)
            if drive.moving:
                drive_to(body, state, drive, t + method.c[i] * h, to_q, to_v)
            accelerate(problem, to_q, to_v, to_a)
        if i == stages:
            break
        x, w = xs[i], ws[i]
        if drive.moving:
            by_t = method.time_weights[i] * h
            for j in range(1, q.size - SPARE):
                right[j] += by_t * by_time[j]
            for k in range(drive.mass.size):
                m = drive.mass[k]
                rest[m], rest[q.size // 2 + m] = 0.0, 0.0
        for j in range(1, q.size - SPARE):
            x[j] = to_a[j] + right[j] + g * rest[j]
        if drive.timed:  # the derivatives are those at the start of the step, like the matrix
            state.clock[0] = t
        add_damping(problem, q, v, rest, -1.0, x)
        solve(problem, x)
        for j in range(1, q.size - SPARE):
            w[j] = g * x[j] - rest[j]
    integrator.run.matrices += 1
    integrator.run.forces += stages
    span = _SPAN
    if problem.event_fraction != 0:
        collides = body.environment.touches
        span = h if collides else min(_SPAN, _SHORT * h)
    error = largest_sum(method.error, xs, stages, rest) / (max(h, span) * tolerance)
    if not error < HOPELESS:
        return HOPELESS
    return error if regular else max(error, 2.0)


@kernel(internal=True, fastmath=FAST)
def _control(problem, drive, old, new, h, tolerance, error, good):
    """See `advance`."""
    integrator, rows = problem.integrator, problem.integrator.rows
    if not good:
        error = max(error, 2.0)
        for i in range(2 * _MAX_STAGES):  # sums include stages with weight zero, which may be NaN
            for j in range(1, old.q.size - SPARE):
                rows[i, j] = 0.0
    elif integrator.alpha.rows.shape[0] > 0:  # in case generalized-alpha goes on from here
        store_direction(problem, old.q, h, 0.5 * integrator.auto.step[ALPHA])
    failed = integrator.trial.failures > 0
    return step_after(integrator, integrator.run.step, h, error, problem.implicit.order, good, failed)


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
def _by_time(problem, drive, old, t, h, q, v, a, out):
    """The derivative of the accelerations with respect to time, at fixed positions of the free masses.

    It is a difference quotient over a small part of the step: driven motion is smooth within a call.
    """
    body, state = problem.body, problem.state
    part = 1e-4 * h
    freeze_active_set(body, state, True)
    for j in range(1, q.size - SPARE):
        q[j], v[j] = old.q[j], old.v[j]
        out[j] = 0.0
    for sign in (1.0, -1.0):
        drive_to(body, state, drive, t + sign * part, q, v)
        accelerate(problem, q, v, a)
        for j in range(1, q.size - SPARE):
            out[j] += sign * a[j] / (2.0 * part)
    freeze_active_set(body, state, False)
    apply_controls_at(body, state, drive, t)
