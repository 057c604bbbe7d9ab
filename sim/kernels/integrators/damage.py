"""Springs that yield and break, and joints that yield.

Both are looked at after each step. A spring whose force |f| is beyond its yield force Y has its rest length
moved by (|f| - Y) / (k + H), and Y grows by H times that: the return mapping of plasticity with linear
isotropic hardening (Simo & Hughes, "Computational Inelasticity", 1.4). The rest angle of a joint is moved so
far that its torque is at the yield torque again. A spring whose force is beyond its strength breaks, and the
joints that hold it with it. The energy that is lost in this way is entered into the energy balance, with that
of what touches a spring that breaks.

The force is that of the spring itself, without its damping.
"""

from __future__ import annotations

import math

from ...forces.broad_phase import update_pairs
from ...forces.contact import energy_on_spring
from ...forces.joints import deflection_at, is_sine, joint_energy, joint_vectors, terms
from ...forces.springs import spring_force
from ..core.drive import wrap
from ..core.vectors import deflection, length_of
from ..engine.jit import FAST, kernel
from .guard import CHANGED

_OVER_STRENGTH = 1e-3
"""Force beyond the strength of a spring, as a fraction of it, at the end of a step in which it breaks."""
_OVER_STRETCH = 0.1
"""The same as a length, as a fraction of the tolerance; the smaller of both counts."""
_OVER_YIELD = 1e-3
"""The same for the yield force, and for the angle at which a joint yields, beside the tolerance for the way
that the rest length moves, or that an angle of both springs of the joint together takes."""
_STEEPEST = 0.999
"""Largest sine of the deflection to which a yielding joint returns; beyond 90 degrees it would not hold."""
_SHORTEST_REST = 0.01
"""Smallest rest length, as a fraction of that of the scene, to which a spring can be squeezed for good."""


@kernel(fastmath=FAST)
def overstrained(problem, q, tolerance):
    """Whether a step that leads to positions q goes so far beyond a limit that a shorter one should be tried.

    So a method with error control finds the moment at which a spring breaks.
    """
    body, state = problem.body, problem.state
    strength = body.strength
    for s in range(body.springs):
        force, stiffness = spring_force(body, state, q, s), body.stiffness[s]
        over = min(_OVER_STRENGTH * strength.breaking[s], _OVER_STRETCH * stiffness * tolerance)
        if state.broken[s] == 0.0 and abs(force) > strength.breaking[s] + over:
            return True
        # Not the force, since a spring that cannot yield any further may be squeezed by any.
        over = abs(_set_by(body, state, s, force)) * (stiffness + strength.hardening[s])
        yielding = strength.yielding[s] + state.hardened[s]
        if over > _OVER_YIELD * yielding + stiffness * tolerance:
            return True
    for j in range(body.joints):
        moved, limit, over, span = _bent_by(body, state, q, j)
        if moved != 0.0 and over > _OVER_YIELD * limit + tolerance / span:
            return True
    return False


@kernel(fastmath=FAST)
def settle(problem, q):
    """Let springs and joints yield and break at positions q; anything that did ends the run with CHANGED."""
    body, state, balance = problem.body, problem.state, problem.balance
    strength, slots, changed = body.strength, q.size // 2, False
    for s in range(body.springs):
        force, stiffness = spring_force(body, state, q, s), body.stiffness[s]
        moved = _set_by(body, state, s, force)
        if moved != 0.0:
            after = force - stiffness * moved
            state.set_length[s] += moved
            state.hardened[s] += strength.hardening[s] * abs(moved)
            state.rest_tension[s] += stiffness * moved
            balance.work.plastic -= 0.5 * (force * force - after * after) / stiffness
            force, changed = after, True
        if abs(force) > strength.breaking[s] and state.broken[s] == 0.0:
            state.broken[s] = 1.0
            balance.work.broken -= 0.5 * force * force / stiffness
            if body.environment.contact.present:
                update_pairs(body, q[:slots], q[slots:])
                balance.work.broken -= energy_on_spring(body, q, s)
            changed = True
    for j in range(body.joints):
        changed |= _settle_joint(problem, q, j)
    if changed:
        problem.integrator.run.what = CHANGED
        problem.integrator.run.current = False


@kernel(fastmath=FAST)
def _settle_joint(problem, q, j):
    """Let a joint yield or break with one of its springs; whether it did."""
    body, state, balance = problem.body, problem.state, problem.balance
    size, soft = body.torque_size[j + 1], body.softening
    if size <= 0.0:
        return False
    s, r = body.joint_a[j], body.joint_b[j]
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    before = size * joint_energy(body.law, ax, ay, bx, by, state.torque_rest[j + 1], soft)
    if state.broken[s] + state.broken[r] > 0.0:
        balance.work.broken -= before
        return True
    moved, _, _, _ = _bent_by(body, state, q, j)
    if moved == 0.0:
        return False
    state.set_angle[j] = wrap(state.set_angle[j] + math.degrees(moved))
    rest = state.torque_rest[j + 1] + moved
    state.torque_rest[j + 1] = rest
    state.torque_cos[j + 1], state.torque_sin[j + 1] = size * math.cos(rest), size * math.sin(rest)
    after = size * joint_energy(body.law, ax, ay, bx, by, rest, soft)
    balance.work.plastic -= before - after
    return True


@kernel(fastmath=FAST)
def _set_by(body, state, s, force):
    """How far the rest length of a spring with a force moves for good, px; never to less than it may be."""
    strength, stiffness = body.strength, body.stiffness[s]
    over = abs(force) - (strength.yielding[s] + state.hardened[s])
    if not (over > 0.0 and stiffness > 0.0):
        return 0.0
    rest = state.rest_tension[s] / stiffness
    moved = math.copysign(over / (stiffness + strength.hardening[s]), force)
    return max(moved, min(_SHORTEST_REST * body.rest_length[s] - rest, 0.0))


@kernel(fastmath=FAST)
def _bent_by(body, state, q, j):
    """How far the rest angle of a joint moves for good at positions q, in radians.

    Returns:
        That; the deflection at which it yields, and what is beyond it; the length of both springs, px.
    """
    size, soft = body.torque_size[j + 1], body.softening
    if size <= 0.0:
        return 0.0, 0.0, 0.0, 1.0
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    one, other = length_of(ax, ay, soft), length_of(bx, by, soft)
    span, limit = one + other, body.strength.bending[j] / (size * one * other)
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, state.torque_rest[j + 1])
    torque = abs(terms(body.law, off)[0])
    if is_sine(body.law) and abs(off) > 0.5 * math.pi:
        torque = 1.0  # bent beyond its largest torque, it has yielded on the way
    if is_sine(body.law):
        yielding, kept = math.asin(min(limit, 1.0)), math.asin(min(limit, _STEEPEST))
    else:
        yielding = kept = deflection_at(body.law, limit, abs(off))
    moved = off - math.copysign(kept, off)
    if not torque > limit or abs(moved) < 1e-12:
        moved = 0.0
    return moved, yielding, abs(off) - yielding, span
