"""The loop that all methods share: move held masses, try a step, and accept it or try a shorter one.

A method is a step: a kernel that leads from one `PhasePoint` to another and estimates the error. Methods that
choose their steps or keep a history also have a kernel that begins a run and one that controls the next step.
Everything else is here: fixed and adaptive steps, acceptance, held keys, the energy balance, and springs that
yield and break. `solve.steps.runge_kutta` is the shortest example.
"""

from __future__ import annotations

import math

from ...engine.calls import (
    accelerate,
    accumulate,
    commit_plasticity,
    event_fraction,
    no_tunnelling,
    update_friction_history,
)
from ...engine.jit import kernel
from ...engine.tables import CONTROL_SCALE, CONTROL_SHIFT
from ...forces.drive import apply_controls, lead_to
from .common import (
    WORTH_SHORTENING,
    ensure_acceleration,
    fitting_step,
    fixed_steps,
    fixed_time,
    replace_state,
    rotation_ok,
    shortest_of,
)
from .guard import CHANGED, GOOD, state_ok

_MAX_AT_ONCE = 64
"""Number of steps between two checks of the state. If a check fails, fixed steps are repeated one at a time,
so that a body that diverges stops at its last good state. By experiment: doubled or halved, nothing."""


@kernel(inline="always")
def advance(problem, drive, end, tolerance, attempts, begin, step, control, equal_steps, knows_a):
    """Advance to `end` by a method.

    Args:
        problem: the tables. With a fixed step (`problem.fixed`) only whole steps are done.
        drive: how held masses move, and what held keys do.
        end: the time to advance to, s.
        tolerance: position error, px, that the steps of a second may add up to; unused with a fixed step.
        attempts: number of steps that may be tried.
        begin: kernel(problem, drive, tolerance), called first. Where `run.step` is 0, it sets that.
        step: kernel(problem, drive, old, new, t, h, tolerance) that leads from `old` at time t to `new` at
            t + h, evaluating forces with held masses and keys where they are then (`drive_to`). Returns the
            error in tolerances; a step above 1 is rejected. It may take a shorter step (`trial.h`,
            `trial.end`), and may report extrema of `new` (`trial.max_position`, `trial.max_speed`,
            `trial.max_move`), which saves time. It may also take up to `trial.max_steps` steps of h seconds
            at once, and report them (`trial.count`, `trial.end`). With an energy balance, `control` then
            accounts for all but the last (`trial.start`), if the step is accepted.
        control: kernel(problem, drive, old, new, h, tolerance, error, good), called after a step was judged
            and before it is kept. Returns the step to try next; see `common.step_after`.
        equal_steps: number of steps before the end that are made equally long; see `fitting_step`.
        knows_a: whether the method uses the accelerations at `old` and computes those at `new`. Then
            `run.since` counts the steps since something else changed the motion, and what a method keeps of
            earlier steps is of no use while that is 0.
    """
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    run, trial, fixed = integrator.run, integrator.trial, problem.fixed
    old, new = integrator.old, integrator.new
    number = last = 0
    # With an energy balance, methods with a fixed step do one at a time, which gives the same bits.
    accounts = balance.active and fixed > 0.0
    most = (
        1
        if accounts or problem.commit_plasticity != 0 or problem.update_friction_history != 0
        else _MAX_AT_ONCE
    )
    if knows_a:
        ensure_acceleration(problem, drive)
    else:
        run.current = False
    # A body may be beyond its limits where it is put.
    if run.time == run.origin and commit_plasticity(problem, old, old, -1.0):
        run.status, run.current = CHANGED, False
    if fixed > 0.0:
        number = fixed_steps(problem, run.time)
        last = fixed_steps(problem, end)
        end = fixed_time(problem, last)
    begin(problem, drive, tolerance)
    trial.failures = 0
    t, goal, is_whole = run.time, end, run.time == fixed_time(problem, number)
    tries, steps, swaps, shortest = 0, 0, 0, 0.0
    while tries < attempts and t < end and run.status == GOOD:
        trial.count, trial.start = 1, t
        if fixed > 0.0:
            goal = fixed_time(problem, number + 1)
            h = fixed if is_whole else goal - t
            trial.end, trial.number = goal, number
            trial.max_steps = min(most, last - number, attempts - tries) if is_whole else 1
        else:
            h = fitting_step(t, end, run.step, equal_steps)
            trial.end = goal if h == goal - t else t + h
            trial.max_steps, trial.remaining = min(most, attempts - tries), end - t
        trial.h, trial.max_position, trial.max_speed, trial.max_move = h, math.inf, math.inf, math.inf
        trial.event_fraction = 1.0
        scale, shift = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT]
        if balance.active and not knows_a:
            lead_to(drive, t, old.q, old.v)
            accelerate(problem, old.q, old.v, old.a)
        error = step(problem, drive, old, new, t, h, tolerance)
        h = trial.h
        if drive.timed and problem.update_friction_history != 0:  # belts go on to the end of the step
            state.clock[0] = trial.end
        if drive.mass.size > 0:
            lead_to(drive, trial.end, new.q, new.v)
            trial.max_position = math.inf
        good = error <= 1.0 and _is_acceptable(problem, old, new, h, tolerance, shortest)
        tries += trial.count if good or fixed == 0.0 else 1
        if not good and drive.moving:  # the step has set them to a later time
            apply_controls(body, state, drive, t, scale, shift)
        if not good and trial.count > 1 and fixed > 0.0:
            most, tries = 1, tries - 1  # one at a time, up to the last good state
            continue
        if trial.event_fraction < 1.0:
            run.step = trial.event_fraction * h
            continue
        run.step = control(problem, drive, old, new, h, tolerance, error, good)
        if not good:
            trial.failures += 1
            continue
        # Before all that evaluates forces elsewhere.
        shortest = shortest_of(body, problem.scratch) if trial.max_move < math.inf else 0.0
        scale, shift = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT]
        if balance.active:
            if not knows_a:
                accelerate(problem, new.q, new.v, new.a)
            accumulate(problem, drive, trial.start, new.q, new.v, new.a, h)
        # What yields now must not depend on whether the energy is followed, and a method may have ended
        # at a sum of times, which rounds differently.
        if drive.moving and (balance.active or body.limits.present):
            apply_controls(body, state, drive, trial.end, scale, shift)
        length = h if fixed == 0.0 else 0.0
        if update_friction_history(problem, old, new, length):
            accelerate(problem, new.q, new.v, new.a)
            run.since = -trial.count
        broke = commit_plasticity(problem, old, new, length)
        if balance.active:
            replace_state(old.q, old.v, old.a, new.q, new.v, new.a)
        else:
            # Swap the arrays instead of copying them.
            old, new = new, old
            swaps += 1
        if broke:
            run.status, run.current = CHANGED, False
        steps += trial.count
        run.since += trial.count
        t, is_whole = trial.end, fixed == 0.0 or trial.end == fixed_time(problem, number + trial.count)
        number += trial.count if is_whole else 0
        trial.failures = 0
    run.time = t
    if swaps % 2:
        replace_state(state.q, state.v, integrator.a, old.q, old.v, old.a)
    run.steps += steps
    run.rejected += tries - steps


@kernel(forceinline=True)
def _is_acceptable(problem, old, new, h, tolerance, shortest):
    """Return whether a step with a small error may be accepted; if not, a shorter one may be tried."""
    body, integrator = problem.body, problem.integrator
    run, trial, fixed = integrator.run, integrator.trial, problem.fixed
    too_short = h < WORTH_SHORTENING
    final = too_short or (fixed > 0.0 and trial.count == 1)
    known_ok = trial.max_position <= run.farthest and trial.max_speed <= run.fastest
    if not (known_ok or state_ok(body, integrator, new.q, new.v, final)):
        return False
    if fixed > 0.0:
        return True
    if not (
        rotation_ok(body, problem.state, old.q, new.q, h, trial.max_move, shortest)
        and no_tunnelling(problem, old.q, new.q)
    ):
        return False
    if not too_short:
        trial.event_fraction = event_fraction(problem, old, new, h, tolerance)
    return trial.event_fraction == 1.0


@kernel(internal=True)
def begin_at_once(problem, drive, tolerance):
    """Do nothing, for methods with a fixed step."""


@kernel(internal=True)
def finish_step(problem, drive, old, new, h, tolerance, error, good):
    """Keep the step, for methods with a fixed step."""
    return problem.integrator.run.step
