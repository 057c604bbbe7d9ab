"""Generalized-alpha, for long and stiff bodies: one implicit force per step, found by Newton's method.

The method is that of Chung & Hulbert (1993), formulated at the end of the step: the force there is the
unknown, and the force at the start is kept from the step before. A long rod turns a lot in one step while it
hardly stretches. Positions are strongly nonlinear in that motion, so the predictor and the Newton updates
turn and stretch each spring of a spanning forest, and positions follow from the springs.
"""

from __future__ import annotations

import math

from ...forces.all import impact_time
from ..core.drive import act_at, drive_to
from ..core.jit import FAST, kernel
from ..core.shared import accelerate, accumulate, bears, factorise, keeps_apart, settle, solve
from ..core.tables import (
    CONTROLLER_BEGUN,
    CONTROLLER_CONTRACTION,
    CONTROLLER_CUBE,
    CONTROLLER_LAST,
    CONTROLLER_LAST_BUT_ONE,
    CONTROLLER_SOLVABLE,
    CONTROLLER_STEP,
    CONTROLLER_TIME,
    COUNT_FORCES,
    COUNT_MATRICES,
    COUNT_REJECTED,
    COUNT_STEPS,
    COUNT_WHAT,
    SPARE,
)
from .guard import GOOD, sound
from .steps import (
    HOPELESS,
    SHORTEST_STEP,
    WORTH_SHORTENING,
    ensure_acceleration,
    first_step,
    fixed_steps,
    fixed_time,
    is_gentle,
    max_abs,
    max_abs_difference,
    step_after,
)
from .turning import predict, remember, turn_and_stretch

_RHO = 0.8
"""Factor by which each step multiplies the fastest motions (the spectral radius at infinity)."""

_AM, _AF = (2.0 * _RHO - 1.0) / (_RHO + 1.0), _RHO / (_RHO + 1.0)
_BETA = 0.25 * (1.0 - _AM + _AF) ** 2
_ALPHA = _AM, _AF, 0.5 - _AM + _AF, _BETA, 0.5 - _BETA
"""alpha_m, alpha_f, gamma, beta, and the weight in positions of the acceleration at the start of the step."""
_EULER = 0.0, 0.0, 1.0, 1.0, 0.0
"""The same parameters for the implicit Euler method, which does not use that acceleration."""

_CALMING = 2
"""Number of steps of the implicit Euler method with which the method begins."""

_ITERATIONS = 8
"""Largest number of Newton iterations in a step."""
_SLIGHT = 0.4
"""Size of a second Newton update, in tolerances times the step squared (s²), below which it is left out: an
error d of a position makes an error of about d / h² of the acceleration, which persists for many steps. With
exact derivatives Newton's method converges quadratically, so the size follows from that of the first update
and the ratio found in earlier steps (Hairer & Wanner, "Solving Ordinary Differential Equations II", IV.8)."""
_SURVEY = 8
"""One step in this many always takes the second update, to measure that ratio."""

_SPAN = 2.5e-3
"""The error of a step is held to the tolerance of this many seconds, whatever its length: with an error per
unit step, the steps of this method of second order would be too short to pay."""

_LEFT = 0.75
"""Largest length, relative to a step whose error was too large, of the step that follows; the error grows
smoothly, so that halving the step would be too much."""
_WORTH = 1.25
"""Growth of the step above which changing it pays."""

_SOLVED = 0.7
"""Length of the next step relative to one in which Newton's method failed."""
_RAISE = 1.06
"""Growth of the step limit, per step, after that: a failed Newton solve costs more than a converged one."""
_RAISE_FIXED = 1.3
"""The same for a fixed step."""

_IMPACT = 0.3
"""Largest fixed step in which something hits a wall or a body, relative to the time until it is deepest: in
longer ones it may leave faster than it came."""

_ERROR = 0.1
"""Error of a step as a fraction of the distance between prediction and solution, found by experiment."""


@kernel(fastmath=FAST)
def run_alpha(problem, drive, end, tolerance, attempts):
    """Advance to `end`; arguments as of `run_verlet`."""
    ensure_acceleration(problem, drive)
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    matrix, fixed = problem.matrix, problem.fixed
    controller, count = integrator.controller, integrator.counts
    q, v, rows = state.q, state.v, integrator.rows
    start, to_q, to_v, speed, move, guess, force, pull = (
        rows[0],
        rows[1],
        rows[2],
        rows[3],
        rows[4],
        rows[5],
        rows[6],
        rows[8],
    )
    late, missed = integrator.history[0], integrator.history[3]  # late: the method's own acceleration
    if controller[CONTROLLER_BEGUN] == 0.0:
        controller[CONTROLLER_CUBE] = 0.0
        for j in range(1, q.size - SPARE):
            late[j] = integrator.a[j]
    precision = 0.05 * _SPAN * tolerance if fixed == 0.0 else 1e-9
    t, h = controller[CONTROLLER_TIME], controller[CONTROLLER_STEP]
    goal = end
    if fixed > 0.0:
        h = min(h, fixed) if h > 0.0 else fixed
    elif h <= 0.0:
        h = 4.0 * first_step(integrator, drive, _SPAN * tolerance)
    failed = False
    for _ in range(attempts):
        if not (t < end and count[COUNT_WHAT] == GOOD):
            break
        # Equal steps up to the end: where steps change, what is kept from the last one is only of first
        # order. A fixed step is divided by itself, so that a run does not depend on how it is cut into calls.
        most = h
        if fixed > 0.0:
            goal = fixed_time(problem, fixed_steps(problem, t) + 1)
            if body.environment.present:
                most = min(h, _IMPACT * impact_time(body, state, q, v, integrator.a, h))
        parts = math.ceil((goal - t - 4e-16 * abs(t)) / most - 1e-6)  # times are rounded
        step = (goal - t) / max(parts, 1)
        # Motions that are too fast for the coming steps show up in the accelerations: discard those.
        calming = fixed == 0.0 and controller[CONTROLLER_BEGUN] < _CALMING
        am, af, gamma, beta, kept = _EULER if calming else _ALPHA
        weight = 1.0 / (1.0 - af)
        inverse = 1.0 / (beta * step * step)
        # At positions q the velocity is speed + g1 (q - start), and the force must be g2 (q - start) - pull.
        g2 = weight * (1.0 - am) * inverse
        g1 = gamma / (beta * step)
        # `late` belongs to a time that is off by a fraction of the step (Jay & Negrut, 2007): rescale it.
        ratio = min(step / controller[CONTROLLER_LAST], 2.0) if controller[CONTROLLER_LAST] > 0.0 else 1.0
        for j in range(1, q.size - SPARE):
            own = integrator.a[j] + ratio * (late[j] - integrator.a[j])
            start[j] = q[j] + step * v[j] + step * step * kept * own
            to_q[j] = q[j] + step * v[j] + 0.5 * step * step * own
            speed[j] = v[j] + step * (1.0 - gamma) * own
            pull[j] = weight * (af * integrator.a[j] - am * own)
        if drive.moving:
            drive_to(body, state, drive, t + step, to_q, to_v)
        predict(problem, step, to_q, rows[7])
        # The prediction is a polynomial of time, so its error is expected to resemble that of the last one.
        h1, h0 = controller[CONTROLLER_LAST], controller[CONTROLLER_LAST_BUT_ONE]
        cube = step * (step + h1) * (step + h1 + h0) if h0 > 0.0 else 0.0
        again = cube / controller[CONTROLLER_CUBE] if controller[CONTROLLER_CUBE] > 0.0 else 0.0
        if again > 8.0:
            again = 0.0
        for j in range(1, q.size - SPARE):
            guess[j] = to_q[j]
            to_q[j] += again * missed[j]
        converged = False
        surveyed = (
            fixed == 0.0
            and controller[CONTROLLER_CONTRACTION] > 0.0
            and int(controller[CONTROLLER_BEGUN]) % _SURVEY > 0
        )
        last = 1e300
        for iteration in range(_ITERATIONS):
            for j in range(1, q.size - SPARE):
                to_v[j] = speed[j] + g1 * (to_q[j] - start[j])
            if drive.moving:
                drive_to(body, state, drive, t + step, to_q, to_v)
            accelerate(problem, to_q, to_v, force)
            for j in range(1, q.size - SPARE):
                move[j] = force[j] - (g2 * (to_q[j] - start[j]) - pull[j])
            _rest(drive, move)
            # The second iteration is close enough to the first to use its matrix.
            if iteration != 1 or last > 10.0 * _SPAN * tolerance:
                factorise(problem, to_q, to_v, g2, g1, False)
                count[COUNT_MATRICES] += 1
            solve(problem, move)
            count[COUNT_FORCES] += 1
            size = max_abs(move)
            if not size < 1e8 or (iteration >= 3 and size > 0.5 * last):
                break
            turn_and_stretch(matrix, state.inverse_mass, to_q, move, rows[7])
            if size < precision or (iteration > 0 and size * (size / last) < 0.1 * precision):
                converged = True
            elif iteration == 0 and surveyed:
                converged = (
                    controller[CONTROLLER_CONTRACTION] * size * size < _SLIGHT * tolerance * step * step
                )
            if iteration == 1:
                controller[CONTROLLER_CONTRACTION] = max(
                    size / (last * last), 0.5 * controller[CONTROLLER_CONTRACTION]
                )
            if converged:
                break
            last = size
        error = HOPELESS
        if converged:
            for j in range(1, q.size - SPARE):
                to_v[j] = speed[j] + g1 * (to_q[j] - start[j])
            if drive.moving:
                drive_to(body, state, drive, t + step, to_q, to_v)
            error = 0.0
            if fixed == 0.0:
                part = _ERROR if controller[CONTROLLER_LAST_BUT_ONE] > 0.0 else 0.3 * _ERROR
                error = (1.0 if calming else part) * max_abs_difference(to_q, guess) / (_SPAN * tolerance)
        good = error <= 1.5 and sound(body, integrator, to_q, to_v, fixed > 0.0 or step < WORTH_SHORTENING)
        good = good and keeps_apart(problem, q, to_q)
        if good and fixed == 0.0:
            good = is_gentle(body, state, q, to_q, step)
            good = good and (step < WORTH_SHORTENING or bears(problem, to_q, tolerance))
        if good:
            if balance.active:
                for j in range(1, q.size - SPARE):
                    force[j] = g2 * (to_q[j] - start[j]) - pull[j]
                _rest(drive, force)
                accumulate(problem, drive, t, to_q, to_v, force, step)
            t = goal if step == goal - t else t + step
            remember(problem, step, 0.0)
            for j in range(1, q.size - SPARE):
                late[j] = (to_q[j] - start[j]) * inverse
                integrator.a[j] = g2 * (to_q[j] - start[j]) - pull[j]
                q[j], v[j], missed[j] = to_q[j], to_v[j], to_q[j] - guess[j]
            _rest(drive, late)
            _rest(drive, integrator.a)
            controller[CONTROLLER_CUBE] = 0.0 if calming else cube
            controller[CONTROLLER_BEGUN] += 1.0
            settle(problem, q)
            count[COUNT_STEPS] += 1
        else:
            error = max(error, 2.0)
            count[COUNT_REJECTED] += 1
            act_at(body, state, drive, t)
        after = step_after(integrator, h, step, error, 3, good, failed, _LEFT)
        if not good and error >= HOPELESS:
            controller[CONTROLLER_SOLVABLE] = after = _SOLVED * step
        elif controller[CONTROLLER_SOLVABLE] > 0.0:
            controller[CONTROLLER_SOLVABLE] *= _RAISE if fixed == 0.0 else _RAISE_FIXED
            after = min(after, controller[CONTROLLER_SOLVABLE])
        if not good or after > _WORTH * h or after < 0.8 * h:
            h = after
        failed = not good
        if fixed > 0.0:
            h = min(h, fixed)
        elif not good and h < 1e-6 and h > SHORTEST_STEP:
            # What was kept from earlier steps may be the cause: discard it.
            controller[CONTROLLER_LAST] = controller[CONTROLLER_LAST_BUT_ONE] = controller[
                CONTROLLER_BEGUN
            ] = controller[CONTROLLER_CUBE] = 0.0
            accelerate(problem, q, v, integrator.a)
            for j in range(1, q.size - SPARE):
                late[j] = integrator.a[j]
    controller[CONTROLLER_TIME] = t
    controller[CONTROLLER_STEP] = h


@kernel(forceinline=True)
def _rest(drive, a):
    """Clear the accelerations of driven masses."""
    for k in range(drive.mass.size):
        m = drive.mass[k]
        a[m], a[a.size // 2 + m] = 0.0, 0.0
