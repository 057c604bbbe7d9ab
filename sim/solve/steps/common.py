"""Step size control, and other functions that the integrators share."""

from __future__ import annotations

import math

import numpy as np

from ...engine.bits import from_bits, size_bits
from ...engine.calls import accelerate
from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time, whole_eights
from ...engine.numerics.vectors import from_to
from ...engine.tables import SPARE
from ...forces.chain import is_chain_like
from ...forces.drive import drive_to, lead_of
from .guard import STUCK

SHORTEST_STEP = 1e-12
"""Length of a step, s, below which a method gives up as STUCK; some 1e4 times the rounding of a time of 1
s."""

WORTH_SHORTENING = 1e-9
"""Length of a step, s, below which a bad state is blamed on the body and not on the step; it only has to lie
between `SHORTEST_STEP` and useful steps."""

SHORTEST_SPAN = 1e-7
"""Each step may use at least the tolerance of this many seconds. Where a spring shrinks to a point and turns
round very quickly, an error per unit step would demand impractically short steps. It only has to be far below
useful steps."""

_SHORTEST_TURN = 1e-7
"""Length of a step, s, below which springs may turn by any angle. By experiment: doubled or halved,
nothing."""

SURE = 0.6
"""Movement of both ends of a spring together, as a fraction of its length, below which it cannot have turned
by 60 degrees: sin 60° = 0.87, less a margin. Double would be wrong; half only costs full checks."""
BOTH_ENDS = 2.83
"""Largest movement of both ends together if no coordinate changes by more than 1: 2 sqrt(2), rounded up."""

HOPELESS = 1e30
"""Error estimate, in tolerances, that replaces infinities and NaN; above any that a step can have."""


@kernel(fastmath=FAST)
def ensure_acceleration(problem, drive):
    """Move held masses to where they should be and update the accelerations, unless both are up to date."""
    body, state, integrator = problem.body, problem.state, problem.integrator
    if not integrator.run.current:
        if drive.moving:
            drive_to(body, state, drive, integrator.run.time, state.q, state.v)
        accelerate(problem, state.q, state.v, integrator.a)
        integrator.run.forces += 1
        integrator.run.current = True
        integrator.run.since = 0


@kernel(forceinline=True, fastmath=FAST)
def all_rotations_ok(body, state, q, to_q, step):
    """Whether no spring has turned by more than 60 degrees in a step.

    If one has, for instance because its ends passed each other, the forces in between were never evaluated.
    Positions may still be within the tolerance, but the wrong impulse of each such step adds energy.
    """
    if step < _SHORTEST_TURN:
        return True
    inverse_mass = state.inverse_mass
    for s in range(body.springs):
        a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
        x, y = from_to(q, a, b)
        to_x, to_y = from_to(to_q, a, b)
        free = inverse_mass[a] + inverse_mass[b] > 0.0
        # Not vectorised: gathering the ends of eight springs at a time is slower than one by one.
        if free and _has_turned(x, y, to_x, to_y, body.softening):
            return False
    return True


@kernel(forceinline=True, fastmath=FAST)
def _has_turned(x, y, to_x, to_y, softening):
    """Whether a spring's vector has turned by more than 60 degrees, if it has a direction."""
    size = (x * x + y * y) * (to_x * to_x + to_y * to_y)
    along = x * to_x + y * to_y
    return size > softening * softening and along * abs(along) < 0.25 * size


@kernel(forceinline=True, fastmath=FAST)
def rotation_ok(body, state, q, to_q, step, moved, shortest):
    """Like `all_rotations_ok`, but skip the check where no mass has moved far.

    Args:
        body, state, q, to_q, step: see `all_rotations_ok`.
        moved: largest change of a coordinate in the step, px.
        shortest: length of the shortest spring at the start, px, or less.
    """
    return BOTH_ENDS * moved < SURE * shortest or all_rotations_ok(body, state, q, to_q, step)


@kernel(forceinline=True, fastmath=FAST)
def shortest_of(body, scratch):
    """Return the length of the shortest spring, px, at the positions of the last evaluation of forces."""
    eight_at_a_time()
    if is_chain_like(body):
        return 1.0 / max(scratch.inverse[0], 1e-300)
    short = 0
    for s in range(whole_eights(body.springs)):
        short = max(short, size_bits(scratch.inverse[s]) if s < body.springs else 0)
    return 1.0 / max(from_bits(short), 1e-300)


@kernel(forceinline=True, fastmath=FAST)
def fitting_step(t, end, h, equal_steps):
    """Return the step to try, s: at most h, not beyond the end, and without leaving a tiny remainder.

    The last `equal_steps` steps before the end are made equally long: a change of the step makes the history
    of a multistep method less useful.
    """
    rest = end - t
    if rest >= (equal_steps + 1e-6) * h:
        return h
    return rest / max(math.ceil(rest / h - 1e-6), 1)


@kernel(forceinline=True)
def fixed_steps(problem, t):
    """Return the number of whole steps of fixed length from the start of the run to time t."""
    passed = t - problem.integrator.run.origin
    # Times are rounded, the more the later it is.
    return int((passed + 4e-16 * abs(t)) / problem.fixed + 1e-6)


@kernel(forceinline=True)
def fixed_time(problem, number):
    """Return the time of a fixed step, s; the same bits however the run is divided into calls."""
    return problem.integrator.run.origin + number * problem.fixed


@kernel(fastmath=FAST)
def first_step(integrator, drive, tolerance):
    """Return a first step, s: the time in which the accelerations move a mass by about the tolerance."""
    h = math.sqrt(tolerance / max(max_abs(integrator.a), 1e-9))
    for i in range(drive.mass.size):
        lead = lead_of(drive, i)
        if lead.radius > 0.0:
            h = min(h, 0.25 * lead.ramp)
    return h


@kernel(forceinline=True, fastmath=FAST)
def step_after(integrator, h, step, error, order, good, after_failure, left=0.5):
    """Return the step to try next, s; set the run's status to STUCK if it is too short.

    Args:
        integrator: the tables of the run.
        h: the step that error control had planned.
        step: the step that was tried, which may have been cut short by the end of a call.
        error: its error estimate, in tolerances.
        order: power of the step to which the estimate is proportional.
        good: whether the step was accepted.
        after_failure: whether the step before it was rejected.
        left: length of the next step relative to a rejected one, at most.
    """
    factor = 5.0
    if error > 1e-12:
        factor = min(5.0, max(0.2, 0.9 / _root(error, order)))
    if not good:
        h = step * min(factor, left)
        if h < SHORTEST_STEP:
            integrator.run.status = STUCK
        return h
    return step_after_good(h, step, factor, after_failure)


@kernel(forceinline=True, fastmath=FAST)
def step_after_good(h, step, factor, after_failure):
    """Return the step to try after an accepted one, s; `factor` is the growth that the error allows."""
    if after_failure:
        factor = min(factor, 1.0)
    # A step that was cut short says little about longer ones.
    return max(h, step * factor) if step < 0.999 * h else step * factor


@kernel(forceinline=True, fastmath=FAST)
def _root(number, order):
    """Return a root of a number; square and fourth roots take a tenth of the time of a power."""
    if order == 2:
        return math.sqrt(number)
    if order == 4:
        return math.sqrt(math.sqrt(number))
    return number ** (1.0 / order)


@kernel(noalias=True, forceinline=True)
def replace_state(q, v, a, to_q, to_v, to_a):
    """Copy the state at the end of a step into the present state."""
    eight_at_a_time()
    for j in range(1, q.size - SPARE):
        q[j], v[j], a[j] = to_q[j], to_v[j], to_a[j]


@kernel(fastmath=FAST)
def max_abs(values):
    """Return the largest absolute value of a flat vector; NaN if any value is."""
    eight_at_a_time()
    most = 0
    for j in range(1, values.size - SPARE):
        most = max(most, size_bits(values[j]))
    return from_bits(most)


@kernel(fastmath=FAST)
def max_abs_difference(one, other):
    """Return the largest absolute difference of two flat vectors; NaN if any is."""
    eight_at_a_time()
    most = 0
    for j in range(1, one.size - SPARE):
        most = max(most, size_bits(one[j] - other[j]))
    return from_bits(most)


@kernel(noalias=True, fastmath=FAST)
def largest_sum(weights, rows, count, scratch):
    """Return the largest absolute value of a weighted sum of the first `count` rows; NaN if any is."""
    eight_at_a_time()
    for j in range(1, scratch.size - SPARE):
        scratch[j] = 0.0
    for i in range(0, count, 4):
        w0, w1, w2, w3 = weights[i], weights[i + 1], weights[i + 2], weights[i + 3]
        k0, k1, k2, k3 = rows[i], rows[i + 1], rows[i + 2], rows[i + 3]
        for j in range(1, scratch.size - SPARE):
            scratch[j] += w0 * k0[j] + w1 * k1[j] + w2 * k2[j] + w3 * k3[j]
    return max_abs(scratch)
