"""Adams methods: a polynomial through past accelerations, and two evaluations of the forces per step.

Positions and velocities are integrals of the polynomial. It is extrapolated to predict them, and corrected
with the accelerations found there (predict, evaluate, correct, evaluate: Shampine & Gordon, 1975). Past
accelerations are stored at equal distances in time, and interpolated when the step changes. High degrees are
best for smooth motion and worse than low ones for rough motion, for instance where joints fold. So after a
failed step, and at regular intervals, the current degree is compared with its neighbours. Kinks of air
friction are kept out of the past accelerations where they matter, see `kinks`.
"""

from __future__ import annotations

from ...engine.bits import from_bits, size_bits
from ...engine.calls import accelerate
from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import PAST, SPARE
from ...forces.drive import drive_to
from .common import HOPELESS, SHORTEST_STEP, first_step
from .guard import STUCK
from .kinks import ago, any_turns, kinks_matter, turn_past, with_kinks, without_kinks
from .loop import advance

_EQUAL_STEPS = 4.0
"""Number of steps before the end of a call that are made equally long. By experiment (20 bodies, `auto` and
Adams): doubled or halved, 1 to 3 % in work."""

_SPAN = 1e-3
"""After a failed step, a step may use the tolerance of this many seconds: a jump of the forces, which no
short step makes smooth, causes its error once and not once per second. By experiment: doubled, one body in 20
is off by 5 tolerances; halved, by 1.5."""

_SHORT = 8.0
"""That span as a multiple of the step, at most, which bounds velocity errors. By experiment: doubled, errors
of `auto` grow by 8 %; halved, one body in 20 is off by 6 tolerances."""

_LONGER = 1.25
"""Smallest growth of a step that is worth interpolating the past for. By experiment: 1.1 or 1.5, 1 % more
work."""
_MUCH_LONGER = 2.0
"""Largest growth of a step. By experiment: 1.5 takes 1 to 3 % more work, 4 up to 3 % less with larger
errors."""
_FIRST_LONGER = 4.0
"""Largest growth of a step while the degree is rising. By experiment: 2 takes 7 % more work in `auto`, 8 as
much."""

_PATIENCE = 4
"""Number of steps after a change of the step before it may grow again. By experiment: doubled, 3 % more work;
halved, errors grow by 30 %."""

_LITTLE = 0.06
"""Error, in tolerances, below which a step is too short. By experiment: doubled or halved, 2 % in work."""
_MUCH = 0.6
"""Error, in tolerances, above which the next step is computed, by a slow power; below, it would be left as
it is anyway, since it changes by less than 5 %. Halved, nothing changes."""

_MIN_DEGREE = 3
"""Lowest degree that the choice of degrees leads to. By experiment: 4 takes 9 % more work, 2 makes no
difference in `auto`."""
_WEIGHED = 16
"""Number of steps after which the current degree is compared with its neighbours. By experiment: doubled or
halved, 1 % in work."""

_UNSTEADY = 0.61
"""Step, as a fraction of `near_limit`, above which the degree is limited to `_STEADY`. By experiment:
doubled or halved, 1 % in work; errors are those of `_STEADY`."""
_STEADY = 6
"""Highest degree for such steps. With degree 7, undamped vibrations grow in steps of 0.25 to 0.47 of Verlet's
limit, by at most 5e-4 per step, and error control then holds the steps in that range. With degree 6 they
decay in steps of 0.34 to 0.62 of the limit."""


@kernel(fastmath=FAST)
def run_adams(problem, drive, end, tolerance, attempts):
    """Advance to `end` with error control; see `advance` for the arguments."""
    advance(problem, drive, end, tolerance, attempts, _begin, _step, _control, _EQUAL_STEPS, True)


@kernel(internal=True, fastmath=FAST)
def _begin(problem, drive, tolerance):
    """See `advance`."""
    integrator, method = problem.integrator, problem.adams
    run, adams = integrator.run, integrator.adams
    if adams.time != run.time or run.since == 0:
        _forget(integrator, method)
        first = first_step(integrator, drive, 0.01 * tolerance)
        run.step = min(run.step, first) if run.step > 0.0 else first
    _look_for_kinks(problem, run.step, tolerance)


@kernel(internal=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """See `advance`."""
    state, integrator, method = problem.state, problem.integrator, problem.adams
    adams, trial, past = integrator.adams, integrator.trial, integrator.adams.past
    ahead = integrator.rows[0]
    adams.target_degree = min(adams.target_degree, _highest_degree(problem, h))
    degree = adams.degree = min(adams.degree, adams.target_degree)
    if degree > 0 and abs(h - adams.spacing) > 1e-9 * adams.spacing:
        _space(past, adams.head, method, degree, h / adams.spacing, integrator.rows)
        adams.known = degree + 1
        _look_for_kinks(problem, h, tolerance)
    adams.spacing = h
    _predict(old.q, old.v, past, adams.head, method, degree, h, new.q, new.v, ahead)
    if drive.moving:
        drive_to(problem.body, state, drive, t + h, new.q, new.v)
    accelerate(problem, new.q, new.v, new.a)
    integrator.run.forces += 1
    if adams.kinks and any_turns(old.v, new.v):
        without_kinks(state.air, old.v, new.v, new.a)
    by_q, by_v = h * h * method.to_position[degree], h * method.to_velocity[degree]
    change, far, fast, moved = _correct(old.q, by_q, by_v, new.a, ahead, new.q, new.v)
    adams.turns = adams.kinks and any_turns(old.v, new.v)
    if adams.turns:
        with_kinks(state.air, old.v, past[adams.head], new.a, h, new.q, new.v)
    else:  # what turned was moved again
        trial.max_position, trial.max_speed = from_bits(far), from_bits(fast)
    trial.max_move = from_bits(moved)
    error = _scale(trial, h, tolerance) * method.error[degree] * from_bits(change)
    return error if error < HOPELESS else HOPELESS


@kernel(internal=True, fastmath=FAST)
def _control(problem, drive, old, new, h, tolerance, error, good):
    """See `advance`."""
    state, integrator, method = problem.state, problem.integrator, problem.adams
    run, adams, past, planned = integrator.run, integrator.adams, integrator.adams.past, integrator.run.step
    degree, top, scale = adams.degree, _highest_degree(problem, h), _scale(integrator.trial, h, tolerance)
    if not good:
        adams.since = 0
        if degree == adams.target_degree and error > 1.0:
            degree, error = _best_degree(past, adams.head, 0, method, degree, top, scale, error, new.a)
            adams.target_degree = degree
        h *= min(0.5, max(0.2, 0.9 * max(error, 2.0) ** (-1.0 / (degree + 2.0))))
        if integrator.trial.failures > 1:
            degree, adams.known = 0, 1  # the past no longer predicts anything
        adams.degree = degree
        if h < SHORTEST_STEP:
            run.status = STUCK
        return h
    if degree == adams.target_degree and adams.since % _WEIGHED == _WEIGHED - 1:
        adams.target_degree, error = _best_degree(
            past, adams.head, adams.known, method, degree, top, scale, error, new.a
        )
    # Overwrites the oldest acceleration, which is no longer needed.
    adams.head = (adams.head - 1) & (PAST - 1)
    adams.known = min(adams.known + 1, PAST)
    latest = past[adams.head]
    accelerate(problem, new.q, new.v, latest)
    run.forces += 1
    if adams.turns:
        turn_past(state.air, old.v, new.v, past, adams.head, adams.known, method.back, h)
    for j in range(1, latest.size - SPARE):
        new.a[j] = latest[j]
    adams.time = integrator.trial.end
    adams.since += 1
    degree = min(degree, adams.target_degree)
    rising = degree < adams.target_degree
    factor = 1.0
    if rising or error > _MUCH or (error < _LITTLE and adams.since > _PATIENCE):  # powers are slow
        factor = min(
            0.9 * max(error, 1e-12) ** (-1.0 / (degree + 2.0)), _FIRST_LONGER if rising else _MUCH_LONGER
        )
    adams.degree = degree + rising
    if rising or factor < 0.95 or factor > _LONGER:
        adams.since = 0
        # A step that was cut short says little about longer ones.
        return max(planned, h * factor) if h < 0.999 * planned else h * factor
    return planned


@kernel(internal=True)
def _forget(integrator, method):
    """Begin with the present accelerations alone."""
    adams = integrator.adams
    adams.degree, adams.target_degree, adams.head, adams.known, adams.since = 0, method.degree, 0, 1, 0
    adams.spacing, adams.time = 0.0, integrator.run.time
    for j in range(1, integrator.a.size - SPARE):
        adams.past[0, j] = integrator.a[j]


@kernel(forceinline=True)
def _look_for_kinks(problem, h, tolerance):
    """Note whether kinks of air friction matter in steps of length h."""
    adams = problem.integrator.adams
    weight = problem.adams.error[adams.degree]
    adams.kinks = kinks_matter(problem.state.air, adams.past[adams.head], h, weight, tolerance)


@kernel(forceinline=True)
def _highest_degree(problem, h):
    """The highest degree for a step of length h."""
    return _STEADY if h > _UNSTEADY * problem.near_limit else problem.adams.degree


@kernel(forceinline=True, fastmath=FAST)
def _scale(trial, h, tolerance):
    """The factor that turns a difference of accelerations into an error in tolerances."""
    span = max(h, min(_SPAN, _SHORT * h)) if trial.failures > 0 else h
    return h * h / (span * tolerance)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _predict(q, v, past, head, method, degree, h, to_q, to_v, ahead):
    """Extrapolate positions, velocities and accelerations by a step of length h."""
    eight_at_a_time()
    hh = h * h
    # In one pass everything stays in registers. Leaving out one row saves a tenth of the arithmetic.
    x, u, w = method.position[degree], method.velocity[degree], method.ahead[degree]
    x0, x1, x2, x3 = hh * x[0], hh * x[1], hh * x[2], hh * x[3]
    x4, x5, x6, x7 = hh * x[4], hh * x[5], hh * x[6], hh * x[7]
    u0, u1, u2, u3 = h * u[0], h * u[1], h * u[2], h * u[3]
    u4, u5, u6, u7 = h * u[4], h * u[5], h * u[6], h * u[7]
    w0, w1, w2, w3, w4, w5, w6, w7 = w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7]
    a0, a1, a2, a3 = past[head], past[ago(head, 1)], past[ago(head, 2)], past[ago(head, 3)]
    a4, a5, a6, a7 = past[ago(head, 4)], past[ago(head, 5)], past[ago(head, 6)], past[ago(head, 7)]
    if degree == PAST - 1:
        for j in range(1, q.size - SPARE):
            r0, r1, r2, r3, r4, r5, r6, r7 = a0[j], a1[j], a2[j], a3[j], a4[j], a5[j], a6[j], a7[j]
            by_x = x0 * r0 + x1 * r1 + x2 * r2 + x3 * r3 + (x4 * r4 + x5 * r5 + x6 * r6 + x7 * r7)
            by_u = u0 * r0 + u1 * r1 + u2 * r2 + u3 * r3 + (u4 * r4 + u5 * r5 + u6 * r6 + u7 * r7)
            to_q[j], to_v[j] = q[j] + h * v[j] + by_x, v[j] + by_u
            ahead[j] = w0 * r0 + w1 * r1 + w2 * r2 + w3 * r3 + (w4 * r4 + w5 * r5 + w6 * r6 + w7 * r7)
    else:
        for j in range(1, q.size - SPARE):
            r0, r1, r2, r3, r4, r5, r6 = a0[j], a1[j], a2[j], a3[j], a4[j], a5[j], a6[j]
            by_x = x0 * r0 + x1 * r1 + x2 * r2 + x3 * r3 + (x4 * r4 + x5 * r5 + x6 * r6)
            by_u = u0 * r0 + u1 * r1 + u2 * r2 + u3 * r3 + (u4 * r4 + u5 * r5 + u6 * r6)
            to_q[j], to_v[j] = q[j] + h * v[j] + by_x, v[j] + by_u
            ahead[j] = w0 * r0 + w1 * r1 + w2 * r2 + w3 * r3 + (w4 * r4 + w5 * r5 + w6 * r6)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _correct(q, by_q, by_v, to_a, ahead, to_q, to_v):
    """Correct a prediction.

    Returns:
        As bits, the largest error of the predicted acceleration, coordinate, speed and change of position.
    """
    eight_at_a_time()
    change, far, fast, moved = 0, 0, 0, 0
    for j in range(1, q.size - SPARE):
        off = to_a[j] - ahead[j]
        position, speed = to_q[j] + by_q * off, to_v[j] + by_v * off
        to_q[j], to_v[j] = position, speed
        change = max(change, size_bits(off))
        far = max(far, size_bits(position))
        fast = max(fast, size_bits(speed))
        moved = max(moved, size_bits(position - q[j]))
    return change, far, fast, moved


@kernel(fastmath=FAST)
def _best_degree(past, head, known, method, degree, top, scale, error, to_a):
    """(degree, error): the current degree or one of its neighbours, whichever allows the longest steps.

    Args:
        known: number of rows of the past that a higher degree could use.
        top: the highest degree that may be chosen.
        scale: factor that turns a difference of accelerations into an error.
        error: error of this step with the current degree, in tolerances.
        to_a: the accelerations found at the predicted state.
    """
    best, least, stride = degree, error, _stride(error, degree)
    if degree > _MIN_DEGREE:
        lower = scale * method.error[degree - 1] * _off(past, head, method, degree - 1, to_a)
        if _stride(lower, degree - 1) > stride:
            best, least, stride = degree - 1, lower, _stride(lower, degree - 1)
    if degree < top and known > degree + 1:
        higher = scale * method.error[degree + 1] * _off(past, head, method, degree + 1, to_a)
        if _stride(higher, degree + 1) > stride:
            best, least = degree + 1, higher
    return best, least


@kernel(forceinline=True, fastmath=FAST)
def _stride(error, degree):
    """The factor by which a step could be longer until its error equals the tolerance."""
    return max(error, 1e-12) ** (-1.0 / (degree + 2.0))


@kernel(noalias=True, fastmath=FAST)
def _off(past, head, method, degree, to_a):
    """Largest error of the accelerations that the polynomial of a degree predicts, px/s²."""
    eight_at_a_time()
    w, largest = method.ahead[degree], 0
    w0, w1, w2, w3, w4, w5, w6, w7 = w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7]
    a0, a1, a2, a3 = past[head], past[ago(head, 1)], past[ago(head, 2)], past[ago(head, 3)]
    a4, a5, a6, a7 = past[ago(head, 4)], past[ago(head, 5)], past[ago(head, 6)], past[ago(head, 7)]
    for j in range(1, to_a.size - SPARE):
        low = w0 * a0[j] + w1 * a1[j] + w2 * a2[j] + w3 * a3[j]
        off = to_a[j] - low - (w4 * a4[j] + w5 * a5[j] + w6 * a6[j] + w7 * a7[j])
        largest = max(largest, size_bits(off))
    return from_bits(largest)


@kernel(noalias=True, fastmath=FAST)
def _space(past, head, method, degree, ratio, rows):
    """Interpolate the past accelerations for a new step, `ratio` times as long as the old one.

    This is Lagrange's formula. The product of all distances but one is computed as the product of those
    before it times the product of those behind it, which needs no division.
    """
    eight_at_a_time()
    parts, size = method.barycentric[degree], past.shape[1]
    a0, a1, a2, a3 = past[head], past[ago(head, 1)], past[ago(head, 2)], past[ago(head, 3)]
    a4, a5, a6, a7 = past[ago(head, 4)], past[ago(head, 5)], past[ago(head, 6)], past[ago(head, 7)]
    for m in range(1, degree + 1):
        at, out = ratio * m, rows[m]
        d1, d2 = at - 1.0, at - 2.0 if degree > 1 else 1.0
        d3, d4 = at - 3.0 if degree > 2 else 1.0, at - 4.0 if degree > 3 else 1.0
        d5, d6 = at - 5.0 if degree > 4 else 1.0, at - 6.0 if degree > 5 else 1.0
        d7 = at - 7.0 if degree > 6 else 1.0
        before2 = at * d1
        before3, behind4 = before2 * d2, d5 * d6 * d7
        before4, behind3 = before3 * d3, d4 * behind4
        before5, behind2 = before4 * d4, d3 * behind3
        before6, behind1 = before5 * d5, d2 * behind2
        w0, w1, w2, w3 = (
            parts[0] * d1 * behind1,
            parts[1] * at * behind1,
            parts[2] * before2 * behind2,
            parts[3] * before3 * behind3,
        )
        w4, w5, w6, w7 = (
            parts[4] * before4 * behind4,
            parts[5] * before5 * (d6 * d7),
            parts[6] * before6 * d7,
            parts[7] * before6 * d6,
        )
        for j in range(1, size - SPARE):
            low = w0 * a0[j] + w1 * a1[j] + w2 * a2[j] + w3 * a3[j]
            out[j] = low + (w4 * a4[j] + w5 * a5[j] + w6 * a6[j] + w7 * a7[j])
    for m in range(1, degree + 1):
        row, out = past[ago(head, m)], rows[m]
        for j in range(1, size - SPARE):
            row[j] = out[j]
