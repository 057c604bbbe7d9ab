"""The fallback step, for states in which no method finds a step, such as a spring of zero length.

It is one linearly implicit Euler step (Baraff & Witkin 1998) with a matrix that is positive definite in every
state. Springs of zero length get some length first, and no mass moves further than a spring is long. The step
never adds energy: it is shortened until the energy does not increase, or else the body is brought to rest.
"""

from __future__ import annotations

import math

from ...engine.calls import accelerate, add_damping, commit_plasticity, factorise, solve
from ...engine.jit import FAST, kernel
from ...engine.numerics.vectors import from_to
from ...forces.drive import apply_controls_at, drive_to
from ..balance.energies import energies
from .common import max_abs
from .guard import CHANGED, GOOD, state_ok


@kernel(fastmath=FAST)
def run_fallback(problem, drive, h, shortest, reach):
    """Take one step of h seconds from a state in which the integrators are stuck.

    Args:
        problem, drive: see `solve.steps.loop.advance`.
        h: length of the step, s.
        shortest: length to which shorter springs are set, px.
        reach: largest distance that a mass moves, px.
    """
    body, state, integrator, balance = problem.body, problem.state, problem.integrator, problem.balance
    slots = state.q.size // 2
    run, alpha, q, v, rows = integrator.run, integrator.alpha, state.q, state.v, integrator.rows
    to_q, to_v, a, move, parts = rows[0], rows[1], rows[2], rows[3], rows[4]
    kept_q, kept_v = rows[5], rows[6]
    for j in range(q.size):
        kept_q[j], kept_v[j], a[j] = q[j], v[j], 0.0
    t = run.time
    mass = body.environment.mass
    first = energies(body, state, mass, q, v, parts)
    if drive.moving:
        drive_to(body, state, drive, t + h, q, v)
    for s in range(body.springs):
        i, k = body.spring_a[s], body.spring_b[s]
        if state.inverse_mass[k] == 0.0:
            i, k = k, i
        if state.inverse_mass[k] > 0.0:
            x, y = from_to(q, i, k)
            if math.sqrt(x * x + y * y) < shortest:
                # A different direction for each spring, so that no two coincide.
                far = run.farthest
                q[k] = min(max(q[i] + shortest * math.cos(1.0 + s), -far), far)
                q[slots + k] = min(max(q[slots + i] + shortest * math.sin(1.0 + s), -far), far)
    before = energies(body, state, mass, q, v, parts)
    accelerate(problem, q, v, a)
    g = 1.0 / h
    factorise(problem, q, v, g * g, g, True)
    for j in range(q.size):
        move[j] = a[j] + g * v[j]
    for i in range(drive.mass.size):
        m = drive.mass[i]
        move[m], move[slots + m] = 0.0, 0.0
    add_damping(problem, q, v, v, -1.0, move)
    solve(problem, move)
    for m in range(1, body.masses + 1):
        size = math.sqrt(move[m] * move[m] + move[slots + m] * move[slots + m])
        if not size <= reach:
            factor = reach / size if size < 1e300 else 0.0
            move[m] = move[m] * factor if factor > 0.0 else 0.0
            move[slots + m] = move[slots + m] * factor if factor > 0.0 else 0.0
    part, after = 1.0, before
    for attempt in range(10):
        if attempt == 9:
            part = 0.0
        for j in range(q.size):
            to_q[j] = q[j] + part * move[j]
            to_v[j] = part * move[j] * g
        if drive.moving:
            drive_to(body, state, drive, t + h, to_q, to_v)
        after = energies(body, state, mass, to_q, to_v, parts)
        if after <= before and max_abs(to_q) <= run.farthest and max_abs(to_v) <= run.fastest:
            break
        part *= 0.5
    if not state_ok(body, integrator, to_q, to_v, True):
        for j in range(q.size):  # a driven mass is out of bounds
            q[j], v[j] = kept_q[j], kept_v[j]
        apply_controls_at(body, state, drive, t)
        return
    for j in range(q.size):
        q[j], v[j] = to_q[j], to_v[j]
    if balance.active:
        # Giving springs a length and moving anchors also changed the energy.
        balance.work.anchors += before - first
        balance.work.fallbacks += after - before
    run.time = t + h
    run.step = alpha.last = alpha.older = 0.0
    run.current = False
    run.status = GOOD
    if commit_plasticity(problem, integrator.old, integrator.old, -1.0):
        run.status = CHANGED
    run.fallbacks += 1
    run.matrices += 1
