"""Velocity Verlet: one evaluation of the forces per step."""

from __future__ import annotations

from ...engine.bits import from_bits, size_bits
from ...engine.calls import accelerate, accumulate
from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import CONTROL_SCALE, CONTROL_SHIFT, SPARE
from ...forces.drive import apply_controls, drive_to, lead_to
from .common import (
    BOTH_ENDS,
    HOPELESS,
    SHORTEST_SPAN,
    SURE,
    first_step,
    replace_state,
    shortest_of,
    step_after,
)
from .loop import advance

_ERROR_AT_CAP = 0.8
"""Largest expected error, in tolerances, of a step as long as `VerletState.cap`. By experiment (20 bodies, 3
tolerances): halved, 2 % more work; 1 makes 5 % more, and an octagon 2.6 times as much."""

_SAFETY = 0.27
"""Fraction of the tolerance for steps that are not near the stability limit. Near it, errors reach the
tolerance only in the hardest moments; elsewhere all steps are as long as the tolerance allows, so that
errors add up. By experiment: doubled, errors grow by 16 % and one body in twenty exceeds its tolerance;
halved, 7 % more work."""

_PAST = 0.25
"""Weight of the previous acceleration in the prediction of velocities near the stability limit: 1/4 gives it
the limit of symplectic Euler. Doubled or halved, the worst error of 20 bodies is 13 or 7 tolerances instead
of 0.9."""

_CAP_AFTER_FAILURE = 0.93
"""`VerletState.cap` after a failed step, relative to that step. By experiment: 0.86 or 0.97, 2 % more
work."""
_CAP_CONFIRMED = 0.97
"""The same where that confirms the limit."""
_CAP_AFTER_OTHERS = 0.9
"""Smallest cap after a later failure, relative to the confirmed cap before it. By experiment: without this
rule the walker exceeds 6 of 16 tolerances instead of 3, and a pendulum and a rod take 30 % more work at 1
px."""
_SHORT_OF_CAP = 0.8
"""A failed step that is shorter than this fraction of a confirmed cap is blamed on the vibration that an
earlier failure has left, and not on the cap. By experiment: 0.4 takes 2 % more work, 1 takes 1 % more."""
_CAP_GROWTH = 1.002
"""Growth of the cap per step where it is not confirmed or no longer held. By experiment: the square or the
root, 1 % in work."""
_HOLDS = 512
"""Number of steps for which a confirmed cap is held. By experiment: doubled or halved, 1 % in work."""
_ALIKE = 0.1
"""Largest relative difference of the two failed steps that confirm a cap. By experiment: doubled or halved,
1 to 2 % more work; without it, a dragged rod of 400 masses takes 3 times the work at 1e-3 px."""

_AT_ONCE = 64
"""Largest number of steps done at once while the cap is held. By experiment: doubled or halved, no
difference."""
_MARGIN = 0.7
"""Largest move of a mass in these steps, predicted from its speed, relative to the move by which a spring
cannot have turned too far. By experiment: halved or doubled, 1 % more work."""


@kernel(fastmath=FAST)
def run_verlet(problem, drive, end, tolerance, attempts):
    """Advance to `end` by x += h v + h²/2 a, v += h/2 (a + a'); see `advance` for the arguments.

    Forces at the end of a step use the velocity v + h a. This is of second order, but under damping its
    stability limit is lower than that of symplectic Euler, see `sim.motion.stability`. Under error control,
    steps of at least `near_damped_limit` use v + h (3 a + b) / 4, where b is the acceleration before a: also
    of second order, with larger errors and Euler's limit. With contact, all steps use it, since contact may
    damp much more than `near_damped_limit` accounts for.

    The error of a step is estimated as h² |a' - a| / 12. Near the stability limit this estimate stays small
    and then rises suddenly, so the length of a failed step is stored as `VerletState.cap`, which then rises
    slowly. If the next step, of half the length, fails as well, the cause is the remaining vibration and not
    the cap. Two successive failures at about the same length confirm the cap; it is then held for a while,
    and many steps are done at once.
    """
    advance(problem, drive, end, tolerance, attempts, _begin, _step, _control, 2.0, True)


@kernel(internal=True, fastmath=FAST)
def _begin(problem, drive, tolerance):
    """See `advance`."""
    integrator = problem.integrator
    run, verlet, slope = integrator.run, integrator.verlet, integrator.rows[0]
    if problem.fixed == 0.0 and run.step <= 0.0:
        run.step, verlet.cap = 0.5 * first_step(integrator, drive, 0.01 * tolerance), 1e9
    verlet.limited, verlet.row, verlet.reach = 0, 0, 0.0
    for j in range(slope.size):
        slope[j] = integrator.a[j]


@kernel(internal=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """Take one step, or many at once while the cap is held; see `advance`."""
    integrator = problem.integrator
    trial, verlet = integrator.trial, integrator.verlet
    near = problem.fixed == 0.0 and integrator.run.step >= problem.near_damped_limit
    most = min(_AT_ONCE, trial.max_steps, verlet.since // 2)
    if near and most > 1 and verlet.held and verlet.reach > 0.0 and problem.no_tunnelling == 0:
        # The last steps before `end` are made equally long.
        far = _MARGIN * verlet.reach / max(h * verlet.speed, 1e-300)
        most = int(min(most, trial.remaining / h - 2.0, far))
        if most > 1:
            return _steps_at_limit(problem, drive, old, new, t, h, tolerance, most)
    slope, next_slope = integrator.rows[verlet.row], integrator.rows[1 - verlet.row]
    if integrator.run.since == 0:  # accelerations may have jumped after the last step
        for j in range(slope.size):
            slope[j] = old.a[j]
    _predict(old.q, old.v, old.a, slope, h, new.q, new.v)
    if drive.moving:
        drive_to(problem.body, problem.state, drive, t + h, new.q, new.v)
    accelerate(problem, new.q, new.v, new.a)
    integrator.run.forces += 1
    lags = near or (problem.fixed == 0.0 and problem.no_tunnelling != 0)
    past = _PAST if lags else 0.0
    change, far, fast, moved = _correct(old.q, old.v, old.a, new.a, 0.5 * h, past, new.q, new.v, next_slope)
    trial.max_position, trial.max_speed, trial.max_move = from_bits(far), from_bits(fast), from_bits(moved)
    if problem.fixed > 0.0:
        return 0.0
    error = from_bits(change) * h * h / (12.0 * max(h, SHORTEST_SPAN) * tolerance)
    if not near:
        error *= 1.0 / _SAFETY
    return error if error < HOPELESS else HOPELESS


@kernel(forceinline=True, fastmath=FAST)
def _steps_at_limit(problem, drive, old, new, t, h, tolerance, count):
    """Take `count` steps, or fewer if the error of one is too large, and return the largest error.

    Between them, velocities w are those in the middle of a step: x += h w, w += h a (leapfrog), which is the
    same and takes half the loads and stores.
    """
    integrator = problem.integrator
    trial, verlet, rows = integrator.trial, integrator.verlet, integrator.rows
    middle, spare, q, v = rows[2], rows[3], new.q, new.v
    per_change = h * h / (12.0 * max(h, SHORTEST_SPAN) * tolerance)
    fastest = _begin_leaps(old.q, old.v, old.a, rows[verlet.row], h, q, v, middle)
    a, most, done = old.a, 0, 0
    while True:
        done += 1
        before = a
        # The last accelerations are those of the new state.
        a = new.a if (count - done) % 2 == 0 else spare
        if drive.moving:
            drive_to(problem.body, problem.state, drive, t + done * h, q, v)
        accelerate(problem, q, v, a)
        if done == count:
            break
        change, fast = _leap(before, a, h, q, v, middle)
        most, fastest = max(most, change), max(fastest, fast)
        if not from_bits(change) * per_change <= 1.0:
            break
    integrator.run.forces += done
    trial.count, trial.end = done, t + done * h
    if done == count:
        change, far, fast = _end_leaps(before, a, h, q, v, middle, rows[1 - verlet.row])
        most, fastest = max(most, change), max(fastest, fast)
        # A mass may have moved to and fro.
        trial.max_position, trial.max_speed, trial.max_move = (
            from_bits(far),
            from_bits(fast),
            done * h * from_bits(fastest),
        )
        if not trial.max_move < verlet.reach:
            return 2.0
    error = from_bits(most) * per_change
    return error if error < HOPELESS else HOPELESS


@kernel(fastmath=FAST)
def _account_for_steps(problem, drive, old, new, h):
    """Repeat the steps of `_steps_at_limit` except the last, and add their work to the energy balance.

    `old` becomes the start of the last step.
    """
    body, state, integrator = problem.body, problem.state, problem.integrator
    trial, rows = integrator.trial, integrator.rows
    middle, q, v, before, a, end_v = rows[4], rows[5], rows[6], rows[7], rows[8], rows[9]
    scale, shift, t = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT], trial.start
    _begin_leaps(old.q, old.v, old.a, rows[integrator.verlet.row], h, q, v, middle)
    for j in range(1, q.size - SPARE):
        before[j] = old.a[j]
    for done in range(1, trial.count):
        trial.start = t + done * h
        if drive.moving:
            drive_to(body, state, drive, trial.start, q, v)
        accelerate(problem, q, v, a)
        for j in range(1, q.size - SPARE):
            end_v[j] = middle[j] + 0.5 * h * a[j]
        lead_to(drive, trial.start, q, end_v)
        accumulate(problem, drive, t + (done - 1) * h, q, end_v, a, h)
        replace_state(old.q, old.v, old.a, q, end_v, a)
        _leap(before, a, h, q, v, middle)
        before, a = a, before
    accelerate(problem, new.q, new.v, a)  # restores the scratch of the forces at the end
    if drive.moving:
        apply_controls(body, state, drive, trial.end, scale, shift)


@kernel(forceinline=True, fastmath=FAST)
def _control(problem, drive, old, new, h, tolerance, error, good):
    """See `advance`."""
    integrator, planned = problem.integrator, problem.integrator.run.step
    trial, verlet = integrator.trial, integrator.verlet
    failures, cap = trial.failures, verlet.cap
    if good and trial.count > 1 and problem.balance.active:
        _account_for_steps(problem, drive, old, new, h)
    if good:
        verlet.row = 1 - verlet.row
    if problem.fixed > 0.0:
        return planned
    verlet.held, verlet.reach = False, 0.0
    if not good:
        if verlet.sure and (failures > 1 or (failures == 0 and h < _SHORT_OF_CAP * cap)):
            cap = max(_CAP_AFTER_FAILURE * h, _CAP_AFTER_OTHERS * cap)
            verlet.since = _HOLDS
        elif failures != 1:
            alike = failures == 0 and abs(h - verlet.failed) < _ALIKE * h
            verlet.sure = alike and h >= problem.near_damped_limit  # shorter ones fail for other reasons
            cap = (_CAP_CONFIRMED if verlet.sure else _CAP_AFTER_FAILURE) * h
            verlet.since, verlet.failed = 0 if verlet.sure else _HOLDS, h
        verlet.cap = cap
        return min(step_after(integrator, planned, h, max(error, 2.0), 2, False, failures > 0), cap)
    verlet.since += trial.count
    if verlet.since > _HOLDS:
        cap *= _CAP_GROWTH
    verlet.cap = cap
    if failures == 0 and error * cap * cap < _ERROR_AT_CAP * h * h and cap < 2.0 * h:
        # The cap determines the next step, whatever the error.
        verlet.limited += trial.count
        verlet.held = verlet.since <= _HOLDS and cap >= problem.near_damped_limit
        if verlet.held:
            verlet.reach = SURE / BOTH_ENDS * shortest_of(problem.body, problem.scratch)
            verlet.speed = trial.max_speed
        return cap
    after = step_after(integrator, planned, h, error, 2, True, failures > 0)
    if after > cap:
        verlet.limited += 1
    return min(after, cap)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _predict(q, v, a, slope, step, to_q, to_v):
    """Compute positions at the end of a step, and velocities for the forces there."""
    eight_at_a_time()
    half = 0.5 * step
    for j in range(1, q.size - SPARE):
        to_q[j] = q[j] + step * (v[j] + half * a[j])
        to_v[j] = v[j] + step * slope[j]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _correct(q, v, a, to_a, half, past, to_q, to_v, to_slope):
    """Correct velocities, and compute the slope that predicts the next ones; `past` is the weight of `a`.

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


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _begin_leaps(q, v, a, slope, step, to_q, to_v, middle):
    """Move to the first evaluation of the forces, and return the largest speed, as bits."""
    eight_at_a_time()
    fast, half = 0, 0.5 * step
    for j in range(1, q.size - SPARE):
        w = v[j] + half * a[j]
        middle[j] = w
        to_q[j] = q[j] + step * w
        to_v[j] = v[j] + step * slope[j]
        fast = max(fast, size_bits(w))
    return fast


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _leap(before, a, step, q, v, middle):
    """Move from one evaluation of the forces to the next.

    Returns:
        As bits, the largest change of an acceleration, and the largest speed.
    """
    eight_at_a_time()
    change, fast, part = 0, 0, _PAST * step
    for j in range(1, q.size - SPARE):
        w = middle[j] + step * a[j]
        middle[j] = w
        q[j] += step * w
        # w + h (a + b) / 4 = v + h (3 a + b) / 4, where v = w - h a / 2 is the velocity at the positions of a
        v[j] = w + part * (a[j] + before[j])
        change = max(change, size_bits(a[j] - before[j]))
        fast = max(fast, size_bits(w))
    return change, fast


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _end_leaps(before, a, step, q, v, middle, to_slope):
    """Compute velocities at the last positions, and the slope that predicts the next ones.

    Returns:
        As bits, the largest change of an acceleration, coordinate and speed.
    """
    eight_at_a_time()
    change, far, fast, half = 0, 0, 0, 0.5 * step
    for j in range(1, q.size - SPARE):
        new = middle[j] + half * a[j]
        v[j] = new
        to_slope[j] = a[j] + _PAST * (before[j] - a[j])
        change = max(change, size_bits(a[j] - before[j]))
        far = max(far, size_bits(q[j]))
        fast = max(fast, size_bits(new))
    return change, far, fast
