"""Choosing between explicit and implicit methods while they run.

Which one is the fastest cannot be read off the body: it depends on the tolerance, on what moves, and on how.
So now and then one that is not in use is given a few steps, and whoever gets furthest for its computing goes
on. Every step counts, none is a trial: all hold the same tolerance.
"""

from __future__ import annotations

from .alpha import run_alpha
from .explicit import run_explicit
from .guard import GOOD, STUCK
from .jit import FAST, kernel
from .rosenbrock import run_rosenbrock
from .tables import (
    ARM_ALPHA,
    ARM_EXPLICIT,
    ARM_ROSENBROCK,
    AUTO_LAST,
    AUTO_PACE,
    AUTO_STEP,
    AUTO_TURNS,
    CLOCK_LAST,
    CLOCK_LAST_BUT_ONE,
    CLOCK_STEP,
    CLOCK_TIME,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
)
from .verlet import run_verlet

_ASK_AGAIN = 12
"""Turns until another method is asked again."""


@kernel(fastmath=FAST)
def run_auto(
    body, live, work, matrix, drive, flow, ledger, explicit, implicit, low, rho, costs, tolerances, end,
    attempts,
):  # fmt: skip
    """Go on to `end`.

    Args:
        explicit, implicit: tables of the methods.
        low: whether velocity Verlet stands in for the explicit method.
        rho: of generalized-alpha.
        costs: (arms,) of a step of each method, in those of the first; as many methods are tried.
        tolerances: (arms,) of one step, px.
        attempts: steps to try at most.
    """
    clock, count, mind = flow.clock, flow.counts, flow.mind
    arms = costs.size
    left = attempts
    while clock[CLOCK_TIME] < end and left > 0 and count[COUNT_WHAT] == GOOD:
        arm, limit = _whose_turn(mind, arms)
        fresh = mind[AUTO_PACE + arm] < 0.0
        limit = min(limit, left)
        if arm != int(mind[AUTO_LAST]):
            clock[CLOCK_LAST] = clock[CLOCK_LAST_BUT_ONE] = 0.0
        began, tried = clock[CLOCK_TIME], count[COUNT_STEPS] + count[COUNT_REJECTED]
        step, tolerance = mind[AUTO_STEP + arm], tolerances[arm]
        if fresh and step <= 0.0 and arm != ARM_EXPLICIT:
            step = min(4.0 * mind[AUTO_STEP + ARM_EXPLICIT], 0.5 * (end - began))
        clock[CLOCK_STEP] = step
        if arm == ARM_ROSENBROCK:
            run_rosenbrock(
                body, live, work, matrix, drive, flow, ledger, implicit, end, 0.0, tolerance, limit
            )
        elif arm == ARM_ALPHA:
            run_alpha(body, live, work, matrix, drive, flow, ledger, rho, end, 0.0, tolerance, limit)
        elif low:
            run_verlet(body, live, work, drive, flow, ledger, end, 0.0, tolerance, limit)
        else:
            run_explicit(body, live, work, drive, flow, ledger, explicit, end, 0.0, tolerance, limit)
        mind[AUTO_STEP + arm] = clock[CLOCK_STEP]
        mind[AUTO_LAST] = arm
        tries = count[COUNT_STEPS] + count[COUNT_REJECTED] - tried
        left -= max(tries, 1)
        pace = (clock[CLOCK_TIME] - began) / (max(tries, 1) * costs[arm])
        if count[COUNT_WHAT] == STUCK and arm != ARM_ROSENBROCK:
            count[COUNT_WHAT] = GOOD  # another method may still go on
            mind[AUTO_STEP + arm] = 0.0
            mind[AUTO_PACE + arm] = 0.0
            if mind[AUTO_PACE + ARM_ROSENBROCK] == 0.0:
                mind[AUTO_PACE + ARM_ROSENBROCK] = -1.0
        elif arm == ARM_ALPHA or (fresh and arm != ARM_EXPLICIT):
            # It has hardly begun to lengthen its steps.
            mind[AUTO_PACE + arm] = max(pace, clock[CLOCK_STEP] / costs[arm])
        elif fresh or clock[CLOCK_TIME] < end:
            # The last steps of a call are cut short, which says nothing about the method.
            mind[AUTO_PACE + arm] = pace
        mind[AUTO_TURNS] += 1.0


@kernel(forceinline=True, fastmath=FAST)
def _whose_turn(mind, arms):
    """(the method, how many steps it may try)."""
    best = 0
    for arm in range(arms):
        if mind[AUTO_PACE + arm] < 0.0:
            return arm, 12 if arm == ARM_ALPHA else 4 if arm == ARM_ROSENBROCK else 16
        if mind[AUTO_PACE + arm] > mind[AUTO_PACE + best]:
            best = arm
    turn = int(mind[AUTO_TURNS])
    if turn % _ASK_AGAIN == _ASK_AGAIN - 1:
        asked = turn // _ASK_AGAIN
        other = (best + 1 + asked % (arms - 1)) % arms
        # Generalized-alpha needs some steps to show what it can do.
        hopeless = other == ARM_ALPHA and mind[AUTO_PACE + other] < 0.15 * mind[AUTO_PACE + best]
        if not hopeless or asked // (arms - 1) % 4 == 0:
            return other, 8 if other == ARM_EXPLICIT else 3 if other == ARM_ROSENBROCK else 12
    return best, 64 if best == ARM_EXPLICIT else 12
