"""Any explicit Runge-Kutta(-Nyström) method, with a fixed step or with error control."""

from __future__ import annotations

import math
from typing import Any

from .drive import drive_to
from .forces import accelerations
from .guard import GOOD, sound
from .jit import FAST, kernel
from .lanes import eight_at_a_time
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
    step_after_good,
)
from .tables import CLOCK_STEP, CLOCK_TIME, COUNT_FORCES, COUNT_REJECTED, COUNT_STEPS, COUNT_WHAT, SPARE

_BY_ERROR, _BY_BEFORE, _SAFE = 0.4, 0.2, 0.979
"""Powers of an error and of the one before that the next step goes by; and the part of it that is taken, so
that errors settle at half the tolerance. With the one before, steps come to rest close to a stability limit,
instead of running beyond it again and again, each time leaving vibrations behind (a PI controller:
Gustafsson, 1991; Hairer & Wanner, Solving Ordinary Differential Equations II, IV.2)."""

_LEAST, _LEAST_BEFORE = 1e-8, 1e-4
"""The least errors, in tolerances, that these are taken to be."""

_LEFT = 0.8
"""What part of a step that was not kept is left, at most."""


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
    failed, before = False, 1.0
    for _ in range(attempts):
        if not (t < end and count[COUNT_WHAT] == GOOD):
            break
        step = fitting_step(t, end, h)
        for j in range(1, q.size - SPARE):
            rates[0, j] = flow.a[j]
        for i in range(1, stages + 1):
            _combine(q, v, step, tableau.c[i], tableau.a[i], tableau.abar[i], rates, i, to_q, to_v)
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
        if fixed == 0.0 and good:
            h = step_after_good(h, step, _factor(error, before, tableau.order - 1), failed)
            before, failed = max(error, _LEAST_BEFORE), False
        elif fixed == 0.0:
            h = step_after(flow, h, step, error, tableau.order - 1, False, failed, _LEFT)
            failed = True
    clock[CLOCK_TIME] = t
    clock[CLOCK_STEP] = h


@kernel(forceinline=True)
def _factor(error, before, order):
    """How many times as long as the last step the next one should be.

    Args:
        error, before: error estimates of that step and of the one that was kept before it, in tolerances.
        order: power of the step that they go with.
    """
    power = -_BY_ERROR * math.log(max(error, _LEAST)) + _BY_BEFORE * math.log(before)
    return min(_SAFE * math.exp(power / order), 5.0)


def _combine_of(count: int) -> Any:
    """`_combine` over so many rates, which are known when it is compiled: so its sums stay in registers."""

    @kernel(apart=True, forceinline=True, fastmath=FAST)
    def combine(q, v, h, c, a, abar, rates, to_q, to_v):
        eight_at_a_time()
        ch, hh = c * h, h * h
        for j in range(1, q.size - SPARE):
            by_q, by_v = 0.0, 0.0
            for i in range(count):
                by_q += abar[i] * rates[i, j]
                by_v += a[i] * rates[i, j]
            to_q[j] = q[j] + ch * v[j] + hh * by_q
            to_v[j] = v[j] + h * by_v

    return combine


_combine_4, _combine_8, _combine_12 = _combine_of(4), _combine_of(8), _combine_of(12)


@kernel(forceinline=True)
def _combine(q, v, h, c, a, abar, rates, count, to_q, to_v):
    """to_q = q + c h v + h² sum abar_l k_l and to_v = v + h sum a_l k_l, over at least `count` rates k, and
    12 at most; behind those, a and abar are zero."""
    if count <= 4:
        _combine_4(q, v, h, c, a, abar, rates, to_q, to_v)
    elif count <= 8:
        _combine_8(q, v, h, c, a, abar, rates, to_q, to_v)
    else:
        _combine_12(q, v, h, c, a, abar, rates, to_q, to_v)


@kernel(fastmath=FAST)
def _estimate(tableau, rates, probe, h):
    """The largest position error of a step, px; two estimates are weighted as in DOP853."""
    first = largest_sum(tableau.error, rates, tableau.stages + 1, probe) * h * h
    if not tableau.paired:
        return first
    second = largest_sum(tableau.second, rates, tableau.stages + 1, probe) * h * h
    whole = math.sqrt(first * first + 0.01 * second * second)
    return first * first / whole if not whole <= 0.0 else 0.0
