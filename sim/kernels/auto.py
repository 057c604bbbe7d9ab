"""Choosing between an explicit and an implicit method while it runs.

Which one is faster cannot be read off the body: it depends on the tolerance, on what moves, and on how. So
now and then the one that is not in use is given a few steps, and whoever gets further for its computing
goes on. Every step counts, none is a trial: both hold the same tolerance.
"""

from __future__ import annotations

from .explicit import run_explicit
from .guard import GOOD, STUCK
from .jit import FAST, kernel
from .rosenbrock import run_rosenbrock
from .tables import (
    AUTO_EXPLICIT_PACE,
    AUTO_EXPLICIT_STEP,
    AUTO_IMPLICIT_PACE,
    AUTO_IMPLICIT_STEP,
    AUTO_TURNS,
    CLOCK_STEP,
    CLOCK_TIME,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
)
from .verlet import run_verlet

_LONG, _SHORT = 64, 12
"""Steps of a turn, explicit and implicit."""

_ASK_AGAIN = 12
"""Turns until the other method is asked again."""


@kernel(fastmath=FAST)
def run_auto(
    body, live, work, matrix, drive, flow, ledger, explicit, implicit, low, cost, end, tolerances, attempts
):  # fmt: skip
    """Go on to `end`.

    Args:
        explicit, implicit: tables of the methods.
        low: whether velocity Verlet stands in for the explicit method.
        cost: of an implicit step, in explicit ones.
        tolerances: of one step, explicit and implicit, px.
        attempts: steps to try at most.
    """
    clock, count, mind = flow.clock, flow.counts, flow.mind
    left = attempts
    while clock[CLOCK_TIME] < end and left > 0 and count[COUNT_WHAT] == GOOD:
        turn = int(mind[AUTO_TURNS])
        explicit_pace, implicit_pace = mind[AUTO_EXPLICIT_PACE], mind[AUTO_IMPLICIT_PACE]
        ask = turn % _ASK_AGAIN == _ASK_AGAIN - 1
        if explicit_pace < 0.0:
            use_explicit, limit = True, 16
        elif implicit_pace < 0.0:
            use_explicit, limit = False, 3
        else:
            use_explicit = (explicit_pace > implicit_pace) != ask
            limit = _LONG if use_explicit else _SHORT
            if ask:
                limit = 8 if use_explicit else 1
        limit = min(limit, left)
        began, tried = clock[CLOCK_TIME], count[COUNT_STEPS] + count[COUNT_REJECTED]
        if use_explicit:
            clock[CLOCK_STEP] = mind[AUTO_EXPLICIT_STEP]
            if low:
                run_verlet(body, live, work, drive, flow, ledger, end, 0.0, tolerances[0], limit)
            else:
                run_explicit(body, live, work, drive, flow, ledger, explicit, end, 0.0, tolerances[0], limit)
            mind[AUTO_EXPLICIT_STEP] = clock[CLOCK_STEP]
        else:
            clock[CLOCK_STEP] = mind[AUTO_IMPLICIT_STEP]
            if implicit_pace < 0.0 and clock[CLOCK_STEP] <= 0.0:
                clock[CLOCK_STEP] = min(4.0 * mind[AUTO_EXPLICIT_STEP], 0.5 * (end - began))
            run_rosenbrock(
                body, live, work, matrix, drive, flow, ledger, implicit, end, 0.0, tolerances[1], limit
            )
            mind[AUTO_IMPLICIT_STEP] = clock[CLOCK_STEP]
        tries = count[COUNT_STEPS] + count[COUNT_REJECTED] - tried
        left -= tries
        pace = (clock[CLOCK_TIME] - began) / (max(tries, 1) * (1.0 if use_explicit else cost))
        if count[COUNT_WHAT] == STUCK and use_explicit:
            count[COUNT_WHAT] = GOOD  # the implicit method may still go on
            mind[AUTO_EXPLICIT_STEP] = 0.0
            pace = 0.0
        # The last steps of a call are cut short, which says nothing about the method.
        if use_explicit and (clock[CLOCK_TIME] < end or explicit_pace < 0.0):
            mind[AUTO_EXPLICIT_PACE] = pace
        elif not use_explicit and (clock[CLOCK_TIME] < end or implicit_pace < 0.0):
            mind[AUTO_IMPLICIT_PACE] = max(pace, clock[CLOCK_STEP] / cost if implicit_pace < 0.0 else 0.0)
        mind[AUTO_TURNS] += 1.0
