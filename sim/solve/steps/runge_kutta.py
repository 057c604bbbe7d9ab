"""Explicit Runge-Kutta methods with a fixed step."""

from __future__ import annotations

from ...engine.calls import accelerate
from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import SPARE
from ...forces.drive import drive_to
from .loop import advance, begin_at_once, finish_step


@kernel(fastmath=FAST)
def run_runge_kutta(problem, drive, end, tolerance, attempts):
    """Advance to `end` by the method `problem.explicit`; see `advance` for the arguments."""
    advance(problem, drive, end, tolerance, attempts, begin_at_once, _step, finish_step, 1.0, True)


@kernel(internal=True, fastmath=FAST)
def _step(problem, drive, old, new, t, h, tolerance):
    """Take one step; see `advance`."""
    tableau, rates = problem.explicit, problem.integrator.rows
    stages = tableau.stages
    for j in range(1, old.q.size - SPARE):
        rates[0, j] = old.a[j]
    # The last one is the end of the step, whose accelerations are those of the next step's start.
    for i in range(1, stages + 1):
        _stage(old.q, old.v, h, tableau.c[i], tableau.a[i], tableau.abar[i], rates, i, new.q, new.v)
        if drive.moving:
            drive_to(problem.body, problem.state, drive, t + tableau.c[i] * h, new.q, new.v)
        accelerate(problem, new.q, new.v, rates[i] if i < stages else new.a)
    problem.integrator.run.forces += stages
    return 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _stage(q, v, h, c, a, abar, rates, count, to_q, to_v):
    """Compute to_q = q + c h v + h² sum abar_l k_l and to_v = v + h sum a_l k_l, over `count` rates k."""
    eight_at_a_time()
    for j in range(1, q.size - SPARE):
        to_q[j], to_v[j] = q[j] + c * h * v[j], v[j]
    for i in range(count):
        by_q, by_v = h * h * abar[i], h * a[i]
        for j in range(1, q.size - SPARE):
            to_q[j] += by_q * rates[i, j]
            to_v[j] += by_v * rates[i, j]
