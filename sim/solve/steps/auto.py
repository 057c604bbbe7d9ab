"""The choice of `auto` between explicit and implicit methods.

Which method is fastest cannot be derived from the body: it depends on the tolerance and on the present
motion. So at intervals a method that is not in use takes a few steps, and the method that advances furthest
for its computing time goes on. No step is wasted, since all methods keep to the same tolerance.
"""

from __future__ import annotations

import math

from ...engine.jit import FAST, kernel
from ...engine.numerics.vectors import from_to
from ...engine.tables import ADAMS, ALPHA, CHOICES, CONTROL_SCALE, ROSENBROCK, VERLET
from ...forces.joints import joint_vectors
from .guard import GOOD, STUCK

_SHARE = 0.05
"""Share of the computing time that is spent on trying another method. By experiment (40 bodies, 3
tolerances): halved or doubled, 1 % in work."""
_SHARE_OF_HOPELESS = 0.01
"""That share for a method that was far from the best, and for all while generalized-alpha is best."""
_CLOSE = 0.3
"""Fraction of the best pace above which a method counts as close to the best."""

_TAKING_OVER = 0.3
"""First step of generalized-alpha in a turn, relative to its last one: it is only of first order. By
experiment: with 1, a dragged rod of 200 masses takes 2.4 times the work."""

_RESTART = 8.0
"""Number of steps that a method with a history loses when another method has a turn. By experiment: with 0,
dragged rods of 400 and 1000 masses take 15 % more work; halved or doubled, 1 %."""

_FILTER_RATE = 0.3
"""Weight of a bad turn of generalized-alpha relative to the turns before it, so that one does not change the
method. By experiment: doubled or halved, 1 % in work."""

_LONG_STEP = 0.03
"""Length, s, that implicit steps of a moving body hardly exceed at a tolerance of 1 px; it is proportional to
the fifth root of the tolerance. Where the best method already gets as far in the computing time of such a
step, the other methods are tried later. By experiment: doubled, a tuft of hair takes 2.2 times the work at
1 px; halved, 1 % on average."""

_HOPE = 0.3
"""Length of the steps of generalized-alpha, relative to `_LONG_STEP`, that they hardly exceed."""
_DOUBT = 0.1
"""Length of a step, relative to `_LONG_STEP`, up to which an implicit method that would need such steps to
be the fastest is tried at once. By experiment: with 0, a rope of stiffness 1e6 takes 25 times the work."""
_PATIENCE = 3.0
"""Computing time that passes before a trial that needs steps of that full length, relative to that of the
trial. By experiment: doubled or halved, less than 1 % in work."""
_FIRST = 0.5
"""First step of a method, relative to the one with which it would be the fastest: it can grow from there, and
soon shows if it cannot. By experiment: with 0 or 1, an error of 3.8 or 3.6 tolerances."""

MATRICES = 2.0
"""Number of matrices in a typical step of generalized-alpha; only bodies of 200 masses or more use it.
Halved or doubled, less than 4 % in their work."""

_SAFETY = 0.1
"""Factor of all tolerances while small errors grow quickly: where a joint is bent by more than 90 degrees
from rest, beyond which its torque decreases, or where a spring is short. By experiment: doubled or halved, 3
% less or more work."""
_SHORT = 0.25
"""Fraction of its rest length below which a spring is short, so that it may turn round very quickly. By
experiment: doubled or halved, less than 1 % in work."""

_BEGINNING = 16
"""Number of Verlet's first steps, in which they grow to their full length; and, if stability limited any of
them, of the next ones, which show whether it limits most. By experiment: doubled or halved, 4 % more work."""
_BEGINNING_OF_LONG = 4
"""The same for long bodies, whose steps stability soon limits, so that other methods take over. By
experiment: 16 makes the first frame of a rod of 1000 masses slower (test_long_rods)."""

_TURN_STEPS = 64
"""Number of steps in a turn of an explicit method. By experiment: halved, 4 % more work;
doubled, 1 % less."""
_IMPLICIT_TURN_STEPS = 12
"""Number of steps in a turn of an implicit method. By experiment: halved, 3 % more work; doubled, 2 % less;
with 64, a dragged rod of 400 masses takes 2.8 times the work at 1e-3 px."""
_LONG_TURN_STEPS = 512
"""Number of steps in a turn of Verlet where stability limits them, so that they hardly change. By experiment:
halved or doubled, 2 % in work."""

_LONGEST = 2.2
"""Length of the longest stable steps of Verlet, relative to `near_damped_limit`, or more."""

_SAVED_AT_LIMIT = 0.25
"""Part of the computing time of Verlet's steps that is saved where they are limited by stability and done at
once. By experiment: doubled or halved, 4 % in work; with 0, RODAS is
chosen more often, and the walker exceeds 5 of 16 tolerances instead of 4."""

_HELD = 0.2
"""Share of Verlet's steps that are limited by stability above which stability counts as the limit. By
experiment: doubled or halved, 1 % in work."""
_MEASURED = 48.0
"""Computing time, in Verlet steps, after which that share is known."""


@kernel(fastmath=FAST)
def next_turn(problem, end, whole_tolerance, left):
    """Evaluate the last turn, and choose the method of the next one.

    Args:
        problem: the tables, with the costs of the methods that may be chosen.
        end: the time to advance to, s.
        whole_tolerance: the scene's tolerance, px.
        left: remaining budget, in steps of Verlet by the costs.

    Returns:
        The method, or -1 if the end or the budget is reached; its maximum number of steps; its tolerance; and
        the cost of the last turn, in steps of Verlet.
    """
    integrator, costs = problem.integrator, problem.costs
    run, alpha, auto = integrator.run, integrator.alpha, integrator.auto
    spent = 0
    if auto.turn >= 0:
        tries = run.steps + run.rejected - auto.tried
        price = max(tries, 1) * costs[auto.turn]
        if auto.turn == ALPHA:  # its steps differ a lot
            price = (run.matrices - auto.made) / MATRICES * costs[ALPHA]
        spent = math.ceil(price)
        if auto.turn == VERLET:
            price -= _SAVED_AT_LIMIT * integrator.verlet.limited
        _enter_turn(integrator, costs, auto.turn, tries, price, end)
        auto.turn = -1
        left -= spent
    if not (run.time < end and left > 0 and run.status == GOOD):
        return -1, 0, 0.0, spent
    method, limit = _select_method(
        auto, costs, _LONG_STEP * whole_tolerance**0.2, auto.limited, _LONGEST * problem.near_damped_limit
    )
    began, step = run.time, auto.step[method]
    tolerance = problem.tolerance_factor[method] * whole_tolerance
    if _near_singular(problem.body, problem.state, problem.state.q):
        tolerance *= _SAFETY
    auto.turn, auto.began = method, began
    auto.tried, auto.made = run.steps + run.rejected, run.matrices
    if auto.pace[method] < 0.0 and step <= 0.0 and method != VERLET:
        equal = auto.pace[VERLET] * costs[method] if method != ADAMS else 0.0
        step = min(max(4.0 * auto.step[VERLET], _FIRST * equal), 0.5 * (end - began))
    if method == ALPHA and method != auto.last:
        alpha.steps = 0
        step *= _TAKING_OVER
    run.step = step
    affordable = max(int(left / costs[method]), 1)
    return method, min(limit, affordable), max(tolerance, 1e-13), spent


@kernel(fastmath=FAST)
def _enter_turn(integrator, costs, method, tries, price, end):
    """Update the statistics of a method after a turn of `tries` steps, at a cost of `price` Verlet steps."""
    run, alpha, auto = integrator.run, integrator.alpha, integrator.auto
    went = run.time - auto.began
    fresh = auto.pace[method] < 0.0
    begins = method == ADAMS and method != auto.last
    if method in (VERLET, ADAMS):  # they do not update the history
        if alpha.last > 0.0 and went < 0.5 * auto.step[ALPHA]:
            alpha.last += went
        else:
            alpha.last = alpha.older = 0.0
    auto.step[method] = run.step
    auto.last = method
    if method == VERLET:
        auto.limited = integrator.verlet.limited / max(tries, 1)
    pace = went / max(price, 1.0)
    if run.status == STUCK and method != ROSENBROCK and costs[ROSENBROCK] > 0.0:
        run.status = GOOD  # another method may still find a step
        auto.step[method] = 0.0
        auto.pace[method] = 0.0
        if auto.pace[ROSENBROCK] == 0.0:
            auto.pace[ROSENBROCK] = -1.0
    elif method == ALPHA or fresh or begins:
        # Its steps have only begun to grow; and one bad turn is no reason to change the method.
        pace = max(pace, run.step * max(tries, 1) / max(price, 1.0))
        before = auto.pace[method]
        auto.pace[method] = max(pace, (1.0 - _FILTER_RATE) * before + _FILTER_RATE * pace)
        if method == ALPHA and auto.pace[method] < before:
            # What slows it down also slows down the other implicit method.
            auto.pace[ROSENBROCK] *= auto.pace[method] / before
    elif run.time < end:
        auto.pace[method] = pace
    else:
        # The last step of a call is cut short; at best, it would have cost nothing.
        most = pace * tries / (tries - 1) if tries > 1 else math.inf
        auto.pace[method] = max(pace, min(auto.pace[method], most))
    auto.work += price


@kernel(forceinline=True, fastmath=FAST)
def _select_method(auto, costs, long_step, held, longest):
    """(method, number of steps that it may try).

    Args:
        auto, costs: what is known of the methods.
        long_step: length of long implicit steps, s, see `_LONG_STEP`.
        held: share of Verlet's steps limited by stability.
        longest: length that Verlet's steps hardly exceed, s, before they are known to be limited.
    """
    if auto.pace[VERLET] < 0.0:
        return VERLET, _BEGINNING if costs[ALPHA] == 0.0 else _BEGINNING_OF_LONG
    best = VERLET
    for method in range(1, CHOICES):
        if auto.pace[method] > auto.pace[best]:
            best = method
    pace = auto.pace[best]
    likely = min(pace, longest) if best == VERLET else pace
    # Where stability limits Verlet's steps, or a long body calls for an implicit method, it limits those of
    # Adams methods even more.
    worth = best != ALPHA and held <= _HELD
    unknown = costs[ADAMS] > 0.0 and auto.pace[ADAMS] < 0.0
    adams_unknown = unknown and pace * costs[ADAMS] < long_step
    if worth and adams_unknown and costs[ALPHA] == 0.0:
        # Where Adams methods are good, implicit methods hardly ever are, so Adams is tried first.
        if held > 0.0 and auto.work < 2.0 * _BEGINNING:
            return best, _BEGINNING
        auto.work = 0.0
        return ADAMS, _trial_steps(ADAMS)
    waits = False
    for method in range(1, CHOICES):
        if costs[method] == 0.0 or auto.pace[method] >= 0.0:
            continue
        hope = likely * costs[method] / long_step
        may = hope < 1.0
        if method == ADAMS:
            may = may and worth and auto.work >= _MEASURED
        elif best == VERLET:
            if method == ALPHA:
                hope /= _HOPE
            price = _trial_steps(method) * costs[method]
            may = hope < 1.0 and auto.work >= _PATIENCE * (hope - _DOUBT) * price
            waits = waits or (hope < 1.0 and not may)
        if may:
            auto.work = 0.0
            return method, _trial_steps(method)
    other = (best + 1 + auto.asked % (CHOICES - 1)) % CHOICES
    if costs[other] > 0.0 and (worth or other != ADAMS):
        tries = _trial_steps(other)
        price = tries * costs[other] + (_RESTART * costs[best] if best in (ALPHA, ADAMS) else 0.0)
        close = best != ALPHA and auto.pace[other] > _CLOSE * pace
        share = _SHARE if close else _SHARE_OF_HOPELESS
        if auto.work * share > price:
            auto.work = 0.0
            auto.asked += 1
            return other, tries
    else:
        auto.asked += 1
    if best != ALPHA and auto.last == ALPHA:
        return best, _trial_steps(best)  # what is known of it is out of date
    if best == VERLET and held > _HELD and not waits:
        return best, _LONG_TURN_STEPS
    return best, _TURN_STEPS if best in (VERLET, ADAMS) else _IMPLICIT_TURN_STEPS


@kernel(fastmath=FAST)
def _near_singular(body, state, q):
    """Return whether a spring is short, or a joint bent by over 90 degrees from rest: A . R(-r) B < 0."""
    short = _SHORT * state.controls[CONTROL_SCALE]
    for s in range(body.springs):
        x, y = from_to(q, body.spring_a[s], body.spring_b[s])
        least = short * body.rest_length[s]
        if x * x + y * y < least * least:
            return True
    for j in range(body.joints):
        (ax, ay), (bx, by) = joint_vectors(body, q, j)
        cosine, sine = state.torque_cos[j + 1], state.torque_sin[j + 1]
        if cosine * (ax * bx + ay * by) + sine * (ax * by - ay * bx) < 0.0:
            return True
    return False


@kernel(forceinline=True)
def _trial_steps(method):
    """Return the number of steps of a trial; methods with a history begin with short steps and need more."""
    return 8 if method == VERLET else 12 if method == ALPHA else 24 if method == ADAMS else 3
