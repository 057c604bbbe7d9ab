"""Symplectic Euler, the tutorial's method: v += h a(x, v), then x += h v. Also runs the stable spring."""

from __future__ import annotations

from ..core.drive import lead_to, press, set_controls
from ..core.jit import FUSED, kernel
from ..core.lanes import eight_at_a_time
from ..core.shared import accelerate, accumulate, settle
from ..core.tables import (
    CONTROL_SCALE,
    CONTROL_SHIFT,
    CONTROLLER_TIME,
    COUNT_FORCES,
    COUNT_FRESH,
    COUNT_STEPS,
    COUNT_WHAT,
    SPARE,
)
from .guard import GOOD, sound
from .steps import fixed_steps, fixed_time

CHECK_EVERY = 64
"""Number of steps between two checks of the state. If a check fails, the steps since the last one are undone
and repeated one at a time, so that a body that runs away stops at its last good state."""


@kernel(fastmath=FUSED)
def run_euler(problem, drive, end, tolerance, attempts):
    """Advance to `end` by steps of `problem.fixed` seconds; arguments as of `run_verlet`.

    In each step, led masses and held keys are updated before the forces. So forces see them as they are at
    the end of the step, as in the tutorial.
    """
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    controller, count, h = integrator.controller, integrator.counts, problem.fixed
    q, v, a, kept_q, kept_v = state.q, state.v, integrator.a, integrator.rows[0], integrator.rows[1]
    first = fixed_steps(problem, controller[CONTROLLER_TIME])
    wanted = fixed_steps(problem, end) - first
    steps = min(wanted, attempts)
    count[COUNT_FRESH] = 0  # `a` is never that of the state
    free = _any_free(state.inverse_mass)
    done, stride = 0, CHECK_EVERY
    while done < steps and count[COUNT_WHAT] == GOOD:
        batch = 1 if balance.active or problem.settle != 0 else min(stride, steps - done)
        scale, shift = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT]
        _copy(q, v, kept_q, kept_v)
        if balance.active:
            _step_with_balance(problem, drive, first + done)
        else:
            for step in range(done + 1, done + batch + 1):
                at = fixed_time(problem, first + step)
                lead_to(drive, at, q, v)
                press(body, state, drive, h)
                if drive.timed:
                    state.clock[0] = at
                if free:
                    accelerate(problem, q, v, a)
                    _kick_and_drift(q, v, a, h)
                    lead_to(drive, at, q, v)  # the drift has moved them
        if sound(body, integrator, q, v, batch == 1):
            done += batch
            settle(problem, q)
        else:
            _copy(kept_q, kept_v, q, v)
            if drive.pressed:
                set_controls(body, state, scale, shift)
            if drive.timed:
                state.clock[0] = fixed_time(problem, first + done)
            stride = 1
    count[COUNT_STEPS] += done
    count[COUNT_FORCES] += done
    controller[CONTROLLER_TIME] = fixed_time(problem, first + done)


@kernel(fastmath=FUSED)
def _step_with_balance(problem, drive, number):
    """The step with that number, adding its work to the energy balance, which needs both ends' forces."""
    body, state, integrator, h = problem.body, problem.state, problem.integrator, problem.fixed
    q, v, t, end = state.q, state.v, fixed_time(problem, number), fixed_time(problem, number + 1)
    to_q, to_v, to_a = integrator.rows[2], integrator.rows[3], integrator.rows[4]
    lead_to(drive, t, q, v)
    accelerate(problem, q, v, integrator.a)
    _copy(q, v, to_q, to_v)
    press(body, state, drive, h)
    if drive.timed:
        state.clock[0] = end
    scale, shift = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT]
    lead_to(drive, end, to_q, to_v)
    accelerate(problem, to_q, to_v, to_a)
    _kick_and_drift(to_q, to_v, to_a, h)
    lead_to(drive, end, to_q, to_v)
    accelerate(problem, to_q, to_v, to_a)
    accumulate(problem, drive, t, to_q, to_v, to_a, h)
    _copy(to_q, to_v, q, v)
    if drive.pressed:
        set_controls(body, state, scale, shift)


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


@kernel(forceinline=True)
def _any_free(inverse_mass):
    count = 0
    for w in inverse_mass:
        count += w > 0.0
    return count > 0
