"""Generalized-alpha, for long and stiff bodies: one implicit force per step, found by Newton's method.

The method is that of Chung & Hulbert (1993), formulated at the end of the step: the force there is the
unknown, and the force at the start is kept from the step before. A long rod turns a lot in one step while it
hardly stretches. Positions are strongly nonlinear in that motion, so the predictor and the Newton updates
turn and stretch each spring of a spanning forest, and positions follow from the springs.
"""

from __future__ import annotations

import math

from ...engine.calls import accelerate, factorise, no_tunnelling, solve
from ...engine.jit import FAST, kernel
from ...engine.tables import SPARE
from ...forces.all import impact_time
from ...forces.drive import drive_to
from .common import HOPELESS, SHORTEST_STEP, first_step, max_abs, max_abs_difference, step_after
from .loop import advance
from .turning import predict, store_direction, turn_and_stretch

_RHO = 0.8
"""Factor by which each step multiplies the fastest motions, the spectral radius at infinity (Chung & Hulbert
1993): 1 would keep all vibrations that the step cannot resolve, 0 damps those that it can."""

_AM, _AF = (2.0 * _RHO - 1.0) / (_RHO + 1.0), _RHO / (_RHO + 1.0)
"""alpha_m and alpha_f that lead to that radius."""
_BETA = 0.25 * (1.0 - _AM + _AF) ** 2
"""beta with which, at that radius, motions that the step resolves are damped the least."""
_ALPHA = _AM, _AF, 0.5 - _AM + _AF, _BETA, 0.5 - _BETA
"""alpha_m, alpha_f, gamma, beta, and the weight in positions of the acceleration at the start of the step."""
_EULER = 0.0, 0.0, 1.0, 1.0, 0.0
"""The same parameters for the implicit Euler method, which does not use that acceleration."""

_STARTUP_STEPS = 2
"""Number of steps of the implicit Euler method with which the method begins. By experiment: doubled or
halved, nothing but 4 % of the work of long rods."""

_ITERATIONS = 8
"""Largest number of Newton iterations in a step. By experiment: 4 takes 11 % more work with a fixed step, a
ring 4.5 times as much; 16 changes nothing."""
_SECANT_ITERATIONS = 30
"""The same with friction, where iterations that do not contract go on with its secants. By experiment (girder
on ground, friction 100, slip speed 1e-3, 1/960 s): with 8, 15, 30, 60, a step takes 780, 25, 3.5, 2 parts and
8100, 420, 90, 80 matrices."""
_SLIGHT = 0.4
"""Size of a second Newton update, in tolerances times the step squared (s²), below which it is left out: an
error d of a position makes an error of about d / h² of the acceleration, which persists for many steps. With
exact derivatives Newton's method converges quadratically, so the size follows from that of the first update
and the ratio found in earlier steps (Hairer & Wanner, "Solving Ordinary Differential Equations II", IV.8)."""
_SURVEY = 8
"""One step in this many always takes the second update, to measure that ratio. By experiment: doubled or
halved, 2 % in the work of long rods."""

_SPAN = 2.5e-3
"""The error of a step is held to the tolerance of this many seconds, whatever its length: with an error per
unit step, the steps of this method of second order would be too short to pay. By experiment: halved, a
dragged rod of 400 masses takes 31 % more work at 0.1 px; doubled, 24 % less, with errors above the
tolerance."""

_AFTER_FAILURE = 0.75
"""Largest length, relative to a step whose error was too large, of the step that follows; the error grows
smoothly, so that halving the step would be too much. By experiment: 0.5 takes 5 % more work for a rod of
400."""
_WORTH = 1.25
"""Growth of the step above which changing it pays. By experiment: 1.1 or 1.5, 1 % in the work of long
rods."""

_SOLVED = 0.7
"""Length of the next step relative to one in which Newton's method failed. By experiment: 0.5 or 0.85, less
than 2 % in work."""
_RAISE = 1.06
"""Growth of the step limit, per step, after that: a failed Newton solve costs more than a converged one."""
_RAISE_FIXED = 1.3
"""The same for a fixed step. By experiment: 1.15 or 1.6, 4 % in work."""

_IMPACT = 0.3
"""Largest fixed step in which something hits a wall or a body, relative to the time until it is deepest: in
longer ones it may leave faster than it came. By experiment: doubled or halved, 1 % in work; halved, the worst
error of 20 bodies is a third."""

_ACCEPTED = 1.5
"""Largest error of a step, in tolerances; steps are chosen for an error below 1. By experiment: with 1, a
dragged rod of 400 masses takes 16 % more work at 0.1 px; with 2.25, 13 % less."""

_ERROR = 0.1
"""Error of a step as a fraction of the distance between prediction and solution, found by experiment."""


@kernel(fastmath=FAST)
def run_alpha(problem, drive, end, tolerance, attempts):
    """Advance to `end`; see `advance` for the arguments."""
    advance(problem, drive, end, tolerance, attempts, _begin, _step, _control, math.inf, True)


@kernel(internal=True, fastmath=FAST)
def _begin(problem, drive, tolerance):
    """See `advance`."""
    integrator, fixed = problem.integrator, problem.fixed
    run, alpha, a_prev = integrator.run, integrator.alpha, integrator.alpha.rows[0]
    if alpha.steps == 0:
        alpha.cube = 0.0
        for j in range(1, a_prev.size - SPARE):
            a_prev[j] = integrator.a[j]
    if fixed > 0.0:
        run.step = min(run.step, fixed) if run.step > 0.0 else fixed
    elif run.step <= 0.0:
        run.step = 4.0 * first_step(integrator, drive, _SPAN * tolerance)


@kernel(internal=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """See `advance`. A fixed step may be divided by itself."""
    body, state, integrator, fixed = problem.body, problem.state, problem.integrator, problem.fixed
    alpha, trial, rows = integrator.alpha, integrator.trial, integrator.rows
    q, v, to_q, to_v = old.q, old.v, new.q, new.v
    start, speed, move, q_pred = rows[0], rows[1], rows[2], rows[3]
    force, pull, vector = rows[4], rows[5], rows[6]
    a_prev, predictor_error = alpha.rows[0], alpha.rows[3]
    precision = 0.05 * _SPAN * tolerance if fixed == 0.0 else 1e-9
    if fixed > 0.0:
        # The parts are equal, so that a run does not depend on how it is cut into calls.
        parts = math.ceil((h - 4e-16 * abs(t)) / _longest(problem, old) - 1e-6)  # times are rounded
        if parts > 1:
            h /= parts
            trial.h, trial.end = h, t + h
    am, af, gamma, beta, kept = _parameters(problem)
    weight, inverse = 1.0 / (1.0 - af), 1.0 / (beta * h * h)
    # At positions q the velocity is speed + g1 (q - start), and the force must be g2 (q - start) - pull.
    g2 = weight * (1.0 - am) * inverse
    g1 = gamma / (beta * h)
    # `a_prev` belongs to a time that is off by a fraction of the step (Jay & Negrut, 2007): rescale it.
    ratio = min(h / alpha.last, 2.0) if alpha.last > 0.0 else 1.0
    for j in range(1, q.size - SPARE):
        own = old.a[j] + ratio * (a_prev[j] - old.a[j])
        start[j] = q[j] + h * v[j] + h * h * kept * own
        to_q[j] = q[j] + h * v[j] + 0.5 * h * h * own
        speed[j] = v[j] + h * (1.0 - gamma) * own
        pull[j] = weight * (af * old.a[j] - am * own)
    if drive.moving:
        drive_to(body, state, drive, t + h, to_q, to_v)
    predict(problem, q, h, to_q, vector)
    # The prediction is a polynomial of time, so its error is expected to resemble that of the last one.
    h1, h0 = alpha.last, alpha.older
    alpha.next_cube = h * (h + h1) * (h + h1 + h0) if h0 > 0.0 else 0.0
    again = alpha.next_cube / alpha.cube if alpha.cube > 0.0 else 0.0
    if again > 8.0:
        again = 0.0
    for j in range(1, q.size - SPARE):
        q_pred[j] = to_q[j]
        to_q[j] += again * predictor_error[j]
    converged, secants, last = False, False, 1e300
    around = body.environment
    rubs = around.resistance.grounded or around.walls.rows.shape[0] > 0
    surveyed = fixed == 0.0 and alpha.contraction > 0.0 and alpha.steps % _SURVEY > 0
    for iteration in range(_SECANT_ITERATIONS if rubs else _ITERATIONS):
        for j in range(1, q.size - SPARE):
            to_v[j] = speed[j] + g1 * (to_q[j] - start[j])
        if drive.moving:
            drive_to(body, state, drive, t + h, to_q, to_v)
        accelerate(problem, to_q, to_v, force)
        for j in range(1, q.size - SPARE):
            move[j] = force[j] - (g2 * (to_q[j] - start[j]) - pull[j])
        _zero_prescribed(drive, move)
        # The second iteration is close enough to the first to use its matrix.
        if iteration != 1 or last > 10.0 * _SPAN * tolerance:
            factorise(problem, to_q, to_v, g2, g1, secants)
            integrator.run.matrices += 1
        solve(problem, move)
        integrator.run.forces += 1
        size = max_abs(move)
        # Where a mass begins to stick, Newton's method overshoots from the flat part of the law of friction.
        secants = secants or (rubs and iteration > 0 and size > (1.0 if iteration < 3 else 0.5) * last)
        if not size < 1e8 or (iteration >= 3 and size > (2.0 if secants else 0.5) * last):
            break
        turn_and_stretch(problem.matrix, state.inverse_mass, to_q, move, vector)
        if size < precision or (iteration > 0 and size * (size / last) < 0.1 * precision):
            converged = True
        elif iteration == 0 and surveyed:
            converged = alpha.contraction * size * size < _SLIGHT * tolerance * h * h
        if iteration == 1:
            alpha.contraction = max(size / (last * last), 0.5 * alpha.contraction)
        if converged:
            break
        last = size
    if not converged:
        return HOPELESS
    for j in range(1, q.size - SPARE):
        to_v[j] = speed[j] + g1 * (to_q[j] - start[j])
        new.a[j] = g2 * (to_q[j] - start[j]) - pull[j]
    if drive.moving:
        drive_to(body, state, drive, t + h, to_q, to_v)
        _zero_prescribed(drive, new.a)
    if fixed > 0.0:
        return 0.0 if no_tunnelling(problem, q, to_q) else 2.0
    part = _ERROR if alpha.older > 0.0 else 0.3 * _ERROR
    error = (1.0 if _is_calming(problem) else part) * max_abs_difference(to_q, q_pred) / (_SPAN * tolerance)
    return error / _ACCEPTED


@kernel(internal=True, fastmath=FAST)
def _control(problem, drive, old, new, h, tolerance, error, good):
    """See `advance`."""
    integrator, fixed, planned = problem.integrator, problem.fixed, problem.integrator.run.step
    alpha, failures = integrator.alpha, integrator.trial.failures
    start, q_pred = integrator.rows[0], integrator.rows[3]
    a_prev, predictor_error = alpha.rows[0], alpha.rows[3]
    hopeless, error = error >= HOPELESS, _ACCEPTED * error
    if good:
        store_direction(problem, old.q, h, 0.0)
        _, _, _, beta, _ = _parameters(problem)
        inverse = 1.0 / (beta * h * h)
        for j in range(1, old.q.size - SPARE):
            a_prev[j] = (new.q[j] - start[j]) * inverse
            predictor_error[j] = new.q[j] - q_pred[j]
        _zero_prescribed(drive, a_prev)
        alpha.cube = 0.0 if _is_calming(problem) else alpha.next_cube
        alpha.steps += 1
    else:
        error = max(error, 2.0)
    after = step_after(integrator, planned, h, error, 3, good, failures > 0, _AFTER_FAILURE)
    if not good and hopeless:
        alpha.solvable = after = _SOLVED * h
    elif alpha.solvable > 0.0:
        alpha.solvable *= _RAISE if fixed == 0.0 else _RAISE_FIXED
        after = min(after, alpha.solvable)
    if good and 0.8 * planned <= after <= _WORTH * planned:
        after = planned
    if fixed > 0.0:
        return min(after, fixed)
    if not good and SHORTEST_STEP < after < 1e-6:
        # What was kept from earlier steps may be the cause: discard it.
        alpha.last = alpha.older = alpha.cube = 0.0
        alpha.steps = 0
        accelerate(problem, old.q, old.v, old.a)
        for j in range(1, old.q.size - SPARE):
            a_prev[j] = old.a[j]
    return after


@kernel(forceinline=True)
def _is_calming(problem):
    """Whether this is one of the first steps.

    Motions that are too fast for the coming steps show up in accelerations: the first steps discard those.
    """
    return problem.fixed == 0.0 and problem.integrator.alpha.steps < _STARTUP_STEPS


@kernel(forceinline=True)
def _parameters(problem):
    """The parameters of a step, see `_ALPHA`."""
    return _EULER if _is_calming(problem) else _ALPHA


@kernel(forceinline=True)
def _longest(problem, old):
    """The longest part of a fixed step that may be tried from here, s."""
    body, longest = problem.body, problem.integrator.run.step
    if not body.environment.present:
        return longest
    return min(longest, _IMPACT * impact_time(body, problem.state, old.q, old.v, old.a, longest))


@kernel(forceinline=True)
def _zero_prescribed(drive, a):
    """Set the accelerations of masses with prescribed motion to zero."""
    for k in range(drive.mass.size):
        m = drive.mass[k]
        a[m], a[a.size // 2 + m] = 0.0, 0.0
