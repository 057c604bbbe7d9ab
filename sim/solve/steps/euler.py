"""Symplectic Euler, the tutorial's method: v += h a(x, v), then x += h v. Also runs the stable spring."""

from __future__ import annotations

from ...engine.calls import accelerate
from ...engine.jit import FUSED, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import SPARE
from ...forces.drive import integrate_keys, lead, lead_to
from .common import fixed_time
from .loop import advance, begin_at_once, finish_step


@kernel(fastmath=FUSED)
def run_euler(problem, drive, end, tolerance, attempts):
    """Advance to `end` by steps of `problem.fixed` seconds; see `advance` for the arguments."""
    advance(problem, drive, end, tolerance, attempts, begin_at_once, _step, finish_step, 1.0, False)


@kernel(internal=True, fastmath=FUSED)
def _step(problem, drive, old, new, t, h, tolerance):
    """Take as many steps as `advance` allows at once.

    Hands and held keys move before the forces are evaluated, so forces see them at the end of the step, as in
    the tutorial. Circles are part of the equations of motion: forces see them at the start of the step.
    """
    trial, q, v = problem.integrator.trial, new.q, new.v
    _copy(old.q, old.v, q, v)
    trial.count = trial.max_steps
    for i in range(1, trial.max_steps + 1):
        start = t if i == 1 else trial.end
        trial.end = fixed_time(problem, trial.number + i)
        lead(drive, trial.end, start, q, v)
        if drive.moving:
            integrate_keys(problem.body, problem.state, drive, trial.end, h)
        accelerate(problem, q, v, new.a)
        _kick_and_drift(q, v, new.a, h)
        lead_to(drive, trial.end, q, v)  # the drift has moved them
    problem.integrator.run.forces += trial.max_steps
    return 0.0


@kernel(noalias=True, forceinline=True, fastmath=FUSED)
def _kick_and_drift(q, v, a, h):
    eight_at_a_time()
    for j in range(1, q.size - SPARE):
        u = v[j] + h * a[j]
        v[j] = u
        q[j] += h * u


@kernel(noalias=True, forceinline=True)
def _copy(q, v, to_q, to_v):
    eight_at_a_time()
    for j in range(1, q.size - SPARE):
        to_q[j], to_v[j] = q[j], v[j]
