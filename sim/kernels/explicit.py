"""Any explicit Runge-Kutta(-Nyström) method, with a fixed step or with error control."""

from __future__ import annotations

import math

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
    is_gentle,
    largest_sum,
    replace_state,
    step_after,
)
from .tables import CLOCK_STEP, CLOCK_TIME, COUNT_FORCES, COUNT_REJECTED, COUNT_STEPS, COUNT_WHAT, SPARE


@kernel(fastmath=FAST)
def run_explicit(body, live, work, drive, flow, ledger, tableau, end, fixed, tolerance, attempts):
    """Go on to time `end`, or for a number of attempts, or to the last good state.

    Args:
        fixed: the step, s, or 0 for error control.
        tolerance: of the largest position error of a step, per second of it, px/s.
        attempts: steps to try at most.
    """
    freshen(body, live, work, drive, flow)
    clock, count = flow.clock, flow.counts
    q, v, rates = flow.q, flow.v, flow.rows
    last = rates.shape[0] - 1
    to_q, to_v, probe = rates[last], rates[last - 1], rates[last - 2]
    stages = tableau.stages
    t, h = clock[CLOCK_TIME], clock[CLOCK_STEP]
    if fixed > 0.0:
        h = fixed
    elif h <= 0.0:
        h = first_step(flow, drive, 0.01 * tolerance)
    failed = False
    for _ in range(attempts):
        if not (t < end and count[COUNT_WHAT] == GOOD):
            break
        step = fitting_step(t, end, h)
        for j in range(1, q.size - SPARE):
            rates[0, j] = flow.a[j]
        for i in range(1, stages + 1):
            combine(q, v, step, tableau.c[i], tableau.a[i], tableau.abar[i], rates, i, to_q, to_v)
            if drive.moving:
                drive_to(body, live, drive, t + tableau.c[i] * step, to_q, to_v)
            accelerations(body, live, work, to_q, to_v, rates[i])
        count[COUNT_FORCES] += stages
        error = 0.0
        if fixed == 0.0:
            error = _estimate(tableau, rates, probe, step) / (max(step, SHORTEST_SPAN) * tolerance)
            if not error < HOPELESS:
                error = HOPELESS
        good = error <= 1.0 and sound(body, flow, to_q, to_v, fixed > 0.0 or step < WORTH_SHORTENING)
        if good and fixed == 0.0:
            good = is_gentle(body, live, q, to_q, step)
        if good:
            if ledger.active:
                tally(body, live, work, ledger, drive, flow, t, to_q, to_v, rates[stages], step)
            t = end if step == end - t else t + step
            replace_state(flow, to_q, to_v, rates[stages])
            count[COUNT_STEPS] += 1
        else:
            error = max(error, 2.0)
            count[COUNT_REJECTED] += 1
            for i in range(stages + 1):  # sums run over stages with weight zero, too
                for j in range(1, q.size - SPARE):
                    rates[i, j] = 0.0
        if fixed == 0.0:
            h = step_after(flow, h, step, error, tableau.order - 1, good, failed)
            failed = not good
    clock[CLOCK_TIME] = t
    clock[CLOCK_STEP] = h


@kernel(apart=True, forceinline=True, fastmath=FAST)
def combine(q, v, h, c, a, abar, rates, count, to_q, to_v):
    """to_q = q + c h v + h² sum abar_l k_l and to_v = v + h sum a_l k_l, over the first `count` rates k."""
    ch, hh = c * h, h * h
    for j in range(1, q.size - SPARE):
        to_q[j] = q[j] + ch * v[j]
        to_v[j] = v[j]
    for i in range(0, count, 4):
        a0, a1, a2, a3 = h * a[i], h * a[i + 1], h * a[i + 2], h * a[i + 3]
        b0, b1, b2, b3 = hh * abar[i], hh * abar[i + 1], hh * abar[i + 2], hh * abar[i + 3]
        k0, k1, k2, k3 = rates[i], rates[i + 1], rates[i + 2], rates[i + 3]
        for j in range(1, q.size - SPARE):
            r0, r1, r2, r3 = k0[j], k1[j], k2[j], k3[j]
            to_q[j] += b0 * r0 + b1 * r1 + b2 * r2 + b3 * r3
            to_v[j] += a0 * r0 + a1 * r1 + a2 * r2 + a3 * r3


@kernel(fastmath=FAST)
def _estimate(tableau, rates, probe, h):
    """The largest position error of a step, px; two estimates are weighted as in DOP853."""
    first = largest_sum(tableau.error, rates, tableau.stages + 1, probe) * h * h
    if not tableau.paired:
        return first
    second = largest_sum(tableau.second, rates, tableau.stages + 1, probe) * h * h
    whole = math.sqrt(first * first + 0.01 * second * second)
    return first * first / whole if not whole <= 0.0 else 0.0
