"""Explicit Runge-Kutta methods with a fixed step."""

from __future__ import annotations

from ..core.drive import act_at, drive_to
from ..core.jit import FAST, kernel
from ..core.lanes import eight_at_a_time
from ..core.shared import accelerate, accumulate, settle
from ..core.tables import CONTROLLER_TIME, COUNT_FORCES, COUNT_STEPS, COUNT_WHAT, SPARE
from .guard import GOOD, sound
from .steps import ensure_acceleration, fixed_steps, fixed_time, replace_state


@kernel(fastmath=FAST)
def run_runge_kutta(problem, drive, end, tolerance, attempts):
    """Advance to `end` with the method `problem.explicit` and steps of `problem.fixed` seconds.

    Arguments as of `run_verlet`.
    """
    ensure_acceleration(problem, drive)
    body, state, integrator = problem.body, problem.state, problem.integrator
    tableau, controller, count = problem.explicit, integrator.controller, integrator.counts
    q, v, rates = state.q, state.v, integrator.rows
    to_q, to_v = rates[rates.shape[0] - 1], rates[rates.shape[0] - 2]
    stages, step = tableau.stages, problem.fixed
    t, done = controller[CONTROLLER_TIME], 0
    first = fixed_steps(problem, t)
    wanted = min(fixed_steps(problem, end) - first, attempts)
    while done < wanted and count[COUNT_WHAT] == GOOD:
        for j in range(1, q.size - SPARE):
            rates[0, j] = integrator.a[j]
        # The last one is the end of the step, whose accelerations are those of the next step's start.
        for i in range(1, stages + 1):
            _stage(q, v, step, tableau.c[i], tableau.a[i], tableau.abar[i], rates, i, to_q, to_v)
            if drive.moving:
                drive_to(body, state, drive, t + tableau.c[i] * step, to_q, to_v)
            accelerate(problem, to_q, to_v, rates[i])
        count[COUNT_FORCES] += stages
        if not sound(body, integrator, to_q, to_v, True):
            act_at(body, state, drive, t)
            break
        if problem.balance.active:
            accumulate(problem, drive, t, to_q, to_v, rates[stages], step)
        done += 1
        t = fixed_time(problem, first + done)
        replace_state(q, v, integrator.a, to_q, to_v, rates[stages])
        settle(problem, q)
    count[COUNT_STEPS] += done
    controller[CONTROLLER_TIME] = t


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _stage(q, v, h, c, a, abar, rates, count, to_q, to_v):
    """to_q = q + c h v + h² sum abar_l k_l and to_v = v + h sum a_l k_l, over `count` rates k."""
    eight_at_a_time()
    for j in range(1, q.size - SPARE):
        to_q[j], to_v[j] = q[j] + c * h * v[j], v[j]
    for i in range(count):
        by_q, by_v = h * h * abar[i], h * a[i]
        for j in range(1, q.size - SPARE):
            to_q[j] += by_q * rates[i, j]
            to_v[j] += by_v * rates[i, j]
