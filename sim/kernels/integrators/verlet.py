"""Velocity Verlet: one evaluation of the forces per step."""

from __future__ import annotations

from ..core.bits import from_bits, size_bits
from ..core.drive import act_at, drive_to
from ..core.jit import FAST, kernel
from ..core.lanes import eight_at_a_time
from ..core.shared import accelerate, accumulate, bears, keeps_apart, settle
from ..core.tables import (
    CONTROLLER_CAP,
    CONTROLLER_HELD,
    CONTROLLER_STEP,
    CONTROLLER_TIME,
    COUNT_FORCES,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
    SPARE,
)
from .guard import GOOD, sound
from .steps import (
    HOPELESS,
    SHORTEST_SPAN,
    WORTH_SHORTENING,
    ensure_acceleration,
    first_step,
    fitting_step,
    fixed_steps,
    fixed_time,
    replace_state,
    shortest_of,
    stays_gentle,
    step_after,
)

_ROOMY = 0.8
"""Error, in tolerances, at which the step keeps its length."""

_STRICTLY = 0.27
"""Fraction of the tolerance for steps that are not near the stability limit. Near it, errors reach the
tolerance only in the hardest moments; elsewhere all steps are as long as the tolerance allows, so that errors
add up."""

_PAST = 0.25
"""Weight of the previous acceleration in the prediction of velocities near the stability limit."""

_SINK = 0.93
"""The remembered limit after a failed step, relative to that step."""
_RAISE = 1.002
"""Factor by which that limit rises again in every step."""


@kernel(fastmath=FAST)
def run_verlet(problem, drive, end, tolerance, attempts):
    """Advance to `end` by x += h v + h²/2 a, v += h/2 (a + a').

    Forces that depend on velocities use v + h a for those at the end of the step. This is of second order,
    but under damping its stability limit is lower than that of symplectic Euler, see `sim.motion.stability`.
    Under error control, steps of at least `near_limit` use v + h (3 a + b) / 4, where b is the acceleration
    before a. This is also of second order, with larger errors and Euler's limit. Shorter steps are held to a
    part of the tolerance.

    The error of a step is estimated as h² |a' - a| / 12. Near the stability limit this estimate stays small
    and then rises suddenly, so a failed step is remembered as a limit, which then rises slowly. If the next
    step fails as well, at half the length, that is due to the vibration that is left, and not to the limit.

    Args:
        problem: the tables.
        drive: how held masses move, and what held keys do.
        end: the time to advance to, s.
        tolerance: position error, px, that the steps of a second may add up to; unused with a fixed step.
        attempts: number of steps that may be tried.
    """
    ensure_acceleration(problem, drive)
    body, state, scratch, integrator, balance = (
        problem.body,
        problem.state,
        problem.scratch,
        problem.integrator,
        problem.balance,
    )
    fixed, near_limit = problem.fixed, problem.near_limit
    controller, count = integrator.controller, integrator.counts
    q, v, a, rows = state.q, state.v, integrator.a, integrator.rows
    to_q, to_v, to_a, driven, slope, to_slope = rows[0], rows[1], rows[2], rows[3], rows[4], rows[5]
    slots = q.size // 2
    farthest, fastest = integrator.limits[0], integrator.limits[1]
    t, h = controller[CONTROLLER_TIME], controller[CONTROLLER_STEP]
    first = 0
    if fixed > 0.0:
        h, first = fixed, fixed_steps(problem, t)
        end = fixed_time(problem, fixed_steps(problem, end))
    elif h <= 0.0:
        h = 0.5 * first_step(integrator, drive, 0.01 * tolerance)
        controller[CONTROLLER_CAP] = 1e9
    cap = controller[CONTROLLER_CAP]
    for j in range(a.size):
        slope[j] = a[j]
    failures = 0  # consecutive ones
    steps, tries, held, swaps, shortest = 0, 0, 0, 0, 0.0
    while tries < attempts and t < end and count[COUNT_WHAT] == GOOD:
        tries += 1
        step = fixed if fixed > 0.0 else fitting_step(t, end, h)
        half = 0.5 * step
        near = fixed == 0.0 and h >= near_limit
        _predict(q, v, a, slope, step, to_q, to_v)
        if drive.moving:
            drive_to(body, state, drive, t + step, to_q, to_v)
            for k in range(drive.mass.size):
                m = drive.mass[k]
                driven[m], driven[slots + m] = to_v[m], to_v[slots + m]
        accelerate(problem, to_q, to_v, to_a)
        past = _PAST if near else 0.0
        change, far, fast, moved = _correct(q, v, a, to_a, half, past, to_q, to_v, to_slope)
        for k in range(drive.mass.size):
            m = drive.mass[k]
            for j in (m, slots + m):
                to_v[j] = driven[j]
                fast = max(fast, size_bits(driven[j]))
        error = 0.0
        if fixed == 0.0:
            error = from_bits(change) * step * step / (12.0 * max(step, SHORTEST_SPAN) * tolerance)
            if not near:
                error *= 1.0 / _STRICTLY
            if not error < HOPELESS:
                error = HOPELESS
        good = error <= 1.0
        if good and fixed == 0.0:
            good = stays_gentle(body, state, q, to_q, step, from_bits(moved), shortest)
            good = good and keeps_apart(problem, q, to_q)
            good = good and (step < WORTH_SHORTENING or bears(problem, to_q, tolerance))
        if not (from_bits(far) <= farthest and from_bits(fast) <= fastest):
            good = good and sound(body, integrator, to_q, to_v, fixed > 0.0 or step < WORTH_SHORTENING)
        if not good:
            act_at(body, state, drive, t)
            if fixed == 0.0:
                if failures != 1:
                    cap = _SINK * step
                h = min(step_after(integrator, h, step, max(error, 2.0), 2, False, failures > 0), cap)
                failures += 1
            continue
        shortest = shortest_of(body, scratch)  # before the energy balance, which evaluates forces elsewhere
        if balance.active:
            accumulate(problem, drive, t, to_q, to_v, to_a, step)
            replace_state(state.q, state.v, integrator.a, to_q, to_v, to_a)
        else:
            # Swap the arrays instead of copying them.
            q, to_q, v, to_v, a, to_a = to_q, q, to_v, v, to_a, a
            swaps += 1
        slope, to_slope = to_slope, slope
        settle(problem, q)
        steps += 1
        if fixed > 0.0:
            t = fixed_time(problem, first + steps)
        else:
            t = end if step == end - t else t + step
            cap *= _RAISE
            if failures == 0 and error * cap * cap < _ROOMY * step * step and cap < 2.0 * step:
                # The limit determines the next step, which therefore need not wait for the error.
                h = cap
                held += 1
            else:
                h = step_after(integrator, h, step, error, 2, True, failures > 0)
                if h > cap:
                    h = cap
                    held += 1
            failures = 0
    if swaps % 2:
        replace_state(state.q, state.v, integrator.a, q, v, a)
    count[COUNT_FORCES] += tries
    count[COUNT_STEPS] += steps
    count[COUNT_REJECTED] += tries - steps
    controller[CONTROLLER_TIME], controller[CONTROLLER_STEP], controller[CONTROLLER_CAP] = t, h, cap
    controller[CONTROLLER_HELD] = held / max(tries, 1)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _predict(q, v, a, slope, step, to_q, to_v):
    """Positions at the end of a step, and velocities for the forces there."""
    eight_at_a_time()
    half = 0.5 * step
    for j in range(1, q.size - SPARE):
        to_q[j] = q[j] + step * (v[j] + half * a[j])
        to_v[j] = v[j] + step * slope[j]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _correct(q, v, a, to_a, half, past, to_q, to_v, to_slope):
    """Correct velocities, and compute the slope that predicts the next ones, with the weight `past` of `a`.

    Returns:
        As bits, the largest change of an acceleration, coordinate, speed and change of position.
    """
    eight_at_a_time()
    change, far, fast, moved = 0, 0, 0, 0
    for j in range(1, v.size - SPARE):
        new = v[j] + half * (a[j] + to_a[j])
        to_v[j] = new
        to_slope[j] = to_a[j] + past * (a[j] - to_a[j])
        change = max(change, size_bits(to_a[j] - a[j]))
        far = max(far, size_bits(to_q[j]))
        fast = max(fast, size_bits(new))
        moved = max(moved, size_bits(to_q[j] - q[j]))
    return change, far, fast, moved
