"""Velocity Verlet: one evaluation of the forces per step."""

from __future__ import annotations

from ..core.drive import drive_to
from ..core.shared import accelerate
from ..core.tables import SPARE
from ..engine.bits import from_bits, size_bits
from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time
from .loop import advance
from .steps import HOPELESS, SHORTEST_SPAN, first_step, step_after

_ERROR_AT_CAP = 0.8
"""Largest error, in tolerances, that a step of the length of the remembered limit may be expected to make."""

_SAFETY = 0.27
"""Fraction of the tolerance for steps that are not near the stability limit. Near it, errors reach the
tolerance only in the hardest moments; elsewhere all steps are as long as the tolerance allows, so that errors
add up."""

_PAST = 0.25
"""Weight of the previous acceleration in the prediction of velocities near the stability limit."""

_CAP_AFTER_FAILURE = 0.93
"""The remembered limit after a failed step, relative to that step."""
_CAP_GROWTH = 1.002
"""Factor by which that limit rises again in every step."""


@kernel(fastmath=FAST)
def run_verlet(problem, drive, end, tolerance, attempts):
    """Advance to `end` by x += h v + h²/2 a, v += h/2 (a + a'); arguments as of `advance`.

    Forces that depend on velocities use v + h a for those at the end of the step. This is of second order,
    but under damping its stability limit is lower than that of symplectic Euler, see `sim.motion.stability`.
    Under error control, steps of at least `near_limit` use v + h (3 a + b) / 4, where b is the acceleration
    before a. This is also of second order, with larger errors and Euler's limit. Shorter steps are held to a
    part of the tolerance.

    The error of a step is estimated as h² |a' - a| / 12. Near the stability limit this estimate stays small
    and then rises suddenly, so a failed step is remembered as a limit, which then rises slowly. If the next
    step fails as well, at half the length, that is due to the vibration that is left, and not to the limit.
    """
    advance(problem, drive, end, tolerance, attempts, _begin, _step, _control, 2.0, True)


@kernel(internal=True, fastmath=FAST)
def _begin(problem, drive, tolerance):
    """See `advance`."""
    integrator = problem.integrator
    run, verlet, slope = integrator.run, integrator.verlet, integrator.rows[0]
    if problem.fixed == 0.0 and run.step <= 0.0:
        run.step, verlet.cap = 0.5 * first_step(integrator, drive, 0.01 * tolerance), 1e9
    verlet.limited, verlet.row = 0, 0
    for j in range(slope.size):
        slope[j] = integrator.a[j]


@kernel(forceinline=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """See `advance`."""
    integrator = problem.integrator
    trial, row = integrator.trial, integrator.verlet.row
    slope, next_slope = integrator.rows[row], integrator.rows[1 - row]
    near = problem.fixed == 0.0 and integrator.run.step >= problem.near_limit
    _predict(old.q, old.v, old.a, slope, h, new.q, new.v)
    if drive.moving:
        drive_to(problem.body, problem.state, drive, t + h, new.q, new.v)
    accelerate(problem, new.q, new.v, new.a)
    integrator.run.forces += 1
    past = _PAST if near else 0.0
    change, far, fast, moved = _correct(old.q, old.v, old.a, new.a, 0.5 * h, past, new.q, new.v, next_slope)
    trial.far, trial.fast, trial.moved = from_bits(far), from_bits(fast), from_bits(moved)
    if problem.fixed > 0.0:
        return 0.0
    error = from_bits(change) * h * h / (12.0 * max(h, SHORTEST_SPAN) * tolerance)
    if not near:
        error *= 1.0 / _SAFETY
    return error if error < HOPELESS else HOPELESS


@kernel(forceinline=True, fastmath=FAST)
def _control(problem, drive, old, new, h, tolerance, error, good):
    """See `advance`."""
    integrator, planned = problem.integrator, problem.integrator.run.step
    verlet, failures, cap = integrator.verlet, integrator.trial.failures, integrator.verlet.cap
    if good:
        verlet.row = 1 - verlet.row
    if problem.fixed > 0.0:
        return planned
    if not good:
        if failures != 1:
            cap = _CAP_AFTER_FAILURE * h
        verlet.cap = cap
        return min(step_after(integrator, planned, h, max(error, 2.0), 2, False, failures > 0), cap)
    cap *= _CAP_GROWTH
    verlet.cap = cap
    if failures == 0 and error * cap * cap < _ERROR_AT_CAP * h * h and cap < 2.0 * h:
        # The limit determines the next step, which therefore need not wait for the error.
        verlet.limited += 1
        return cap
    after = step_after(integrator, planned, h, error, 2, True, failures > 0)
    if after > cap:
        verlet.limited += 1
    return min(after, cap)


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
