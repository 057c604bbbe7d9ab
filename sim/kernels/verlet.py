"""Velocity Verlet: one evaluation of the forces a step."""

from __future__ import annotations

from .drive import drive_to
from .forces import accelerations
from .guard import GOOD, sound
from .jit import FAST, kernel
from .ledger import tally
from .steps import (
    HOPELESS,
    SHORTEST_SPAN,
    WORTH_SHORTENING,
    first_step,
    fitting_step,
    freshen,
    replace_state,
    step_after,
)
from .tables import (
    CLOCK_CAP,
    CLOCK_STEP,
    CLOCK_TIME,
    COUNT_FORCES,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
)


@kernel(fastmath=FAST)
def run_verlet(body, live, work, drive, flow, ledger, end, fixed, tolerance, attempts):
    """Go on to `end` by x += h v + h²/2 a, v += h/2 (a + a'); arguments as those of `run_explicit`.

    Forces that depend on velocities take v + h a for the new ones, which keeps the second order. The error of
    a step is taken to be h² |a' - a| / 12. Near the stability limit that says nothing for a while and
    then everything at once, so a step that failed is remembered as a limit, which is raised slowly.
    """
    freshen(body, live, work, drive, flow)
    clock, count = flow.clock, flow.counts
    q, v, a, rows = flow.q, flow.v, flow.a, flow.rows
    to_q, to_v, to_a = rows[0], rows[1], rows[2]
    t, h = clock[CLOCK_TIME], clock[CLOCK_STEP]
    if fixed > 0.0:
        h = fixed
    elif h <= 0.0:
        h = 0.5 * first_step(flow, drive, 0.01 * tolerance)
        clock[CLOCK_CAP] = 1e9
    failed = False
    for _ in range(attempts):
        if not (t < end and count[COUNT_WHAT] == GOOD):
            break
        step = fitting_step(t, end, h)
        half = 0.5 * step
        for j in range(q.size):
            to_q[j] = q[j] + step * (v[j] + half * a[j])
            to_v[j] = v[j] + step * a[j]
        if drive.moving:
            drive_to(body, live, drive, t + step, to_q, to_v)
        accelerations(body, live, work, to_q, to_v, to_a)
        count[COUNT_FORCES] += 1
        error = 0.0
        if fixed == 0.0:
            for j in range(q.size):
                change = abs(to_a[j] - a[j])
                error = change if not change <= error else error
            error *= step * step / (12.0 * max(step, SHORTEST_SPAN) * tolerance)
            if not error < HOPELESS:
                error = HOPELESS
        if error <= 1.0:
            for j in range(q.size):
                to_v[j] = v[j] + half * (a[j] + to_a[j])
            if drive.moving:
                drive_to(body, live, drive, t + step, to_q, to_v)
        good = error <= 1.0 and sound(body, flow, to_q, to_v, fixed > 0.0 or step < WORTH_SHORTENING)
        if good:
            if ledger.active:
                tally(body, live, work, ledger, drive, flow, t, to_q, to_v, to_a, step)
            t = end if step == end - t else t + step
            replace_state(flow, to_q, to_v, to_a)
            count[COUNT_STEPS] += 1
        else:
            error = max(error, 2.0)
            count[COUNT_REJECTED] += 1
        if fixed == 0.0:
            if good:
                clock[CLOCK_CAP] *= 1.004
            else:
                clock[CLOCK_CAP] = 0.93 * step
            h = min(step_after(flow, h, step, error, 2, good, failed), clock[CLOCK_CAP])
            failed = not good
    clock[CLOCK_TIME] = t
    clock[CLOCK_STEP] = h
