"""What springs and joints bear: beyond a limit, a spring yields or breaks, and a joint yields.

Limits are looked at after each step, by the force f of a spring and the torque of a joint, without damping.

- A spring of stiffness k yields where |f| > Y. Its rest length moves by d in the direction of the force, so
  the force decreases by k d, and Y grows by H d, with the hardening H, kg/s². Then the force is at the limit
  again: |f| - k d = Y + H d, hence d = (|f| - Y) / (k + H). This is the return mapping of plasticity with
  linear isotropic hardening (Simo & Hughes, "Computational Inelasticity", 1.4).
- A joint yields where its torque K |A||B| |f(V - r)| is beyond T, see `joints`. The rest angle r moves so far
  that the torque is T again. It does not harden.
- A spring breaks where |f| > B, after it has yielded. From then on it does nothing, nor do the joints that
  hold it, nor a filling whose loop it was a part of, and nothing touches it; see `without_broken`.

The energy that is lost in this way is entered into the energy balance, with that of what touches a spring
that breaks. A step is asked not to go far beyond a limit, so that a method with error control finds the
moment at which a spring breaks, see `overstrained`. Limits are no `Term`, since they exert no force: the loop
of the integrators calls `overstrained` before it keeps a step, and `settle` after it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..kernels.core.drive import wrap
from ..kernels.core.tables import Body
from ..kernels.core.vectors import deflection, length_of
from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.table import Floats, Indices, Table
from ..scene.columns import column
from ..scene.types import Scene
from .broad_phase import update_pairs
from .contact import energy_on_spring
from .fillings import FillingRow
from .joints import deflection_at, is_sine, joint_energy, joint_vectors, terms
from .resistance import of_whole_springs
from .springs import spring_force
from .term import read_only

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


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Limits(Table):
    """Read-only. All arrays are empty where nothing yields or breaks."""

    present: bool  # anything yields or breaks
    breaking: Floats  # (S,) B, kg px/s²; infinite for a spring that never breaks
    yielding: Floats  # (S,) Y before any hardening, kg px/s²; or infinite
    hardening: Floats  # (S,) H, kg/s²
    bending: Floats  # (J,) T, kg px²/s²; or infinite


NO_LIMITS = read_only(Limits.empty())
"""Those of a body in which nothing yields or breaks."""


def new_limits(scene: Scene, spring_order: Indices, joint_order: Indices) -> Limits:
    """The table of a valid scene in which something yields or breaks.

    Args:
        scene: the scene.
        spring_order: (S,) scene index of each spring of the tables.
        joint_order: (J,) index in the tables of each angular spring of the scene.
    """
    springs = scene.linear_springs
    bending = np.empty(len(joint_order))
    bending[joint_order] = _or_infinite(column(scene.angular_springs, "yield_torque"))
    return read_only(
        Limits(
            present=True,
            breaking=_or_infinite(column(springs, "strength"))[spring_order],
            yielding=_or_infinite(column(springs, "yield_force"))[spring_order],
            hardening=column(springs, "hardening")[spring_order],
            bending=bending,
        )
    )


def _or_infinite(limits: Floats) -> Floats:
    return np.where(np.isnan(limits), math.inf, limits)


# ------------------------------------------------------------------------- what yields, and by how much
@kernel(fastmath=FAST)
def _set_by(body, state, s, force):
    """How far the rest length of a spring with a force moves for good, px; never to less than it may be."""
    limits, stiffness = body.limits, body.stiffness[s]
    over = abs(force) - (limits.yielding[s] + state.hardened[s])
    if not (over > 0.0 and stiffness > 0.0):
        return 0.0
    rest = state.rest_tension[s] / stiffness
    moved = math.copysign(over / (stiffness + limits.hardening[s]), force)
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
    span, limit = one + other, body.limits.bending[j] / (size * one * other)
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


# ------------------------------------------------------------------------- what it asks of a step
@kernel(fastmath=FAST)
def overstrained(problem, q, tolerance):
    """Whether a step that leads to positions q goes so far beyond a limit that a shorter one should be tried.

    So a method with error control finds the moment at which a spring breaks.
    """
    body, state = problem.body, problem.state
    limits = body.limits
    for s in range(body.springs):
        force, stiffness = spring_force(body, state, q, s), body.stiffness[s]
        over = min(_OVER_STRENGTH * limits.breaking[s], _OVER_STRETCH * stiffness * tolerance)
        if state.broken[s] == 0.0 and abs(force) > limits.breaking[s] + over:
            return True
        # Not the force, since a spring that cannot yield any further may be squeezed by any.
        over = abs(_set_by(body, state, s, force)) * (stiffness + limits.hardening[s])
        yielding = limits.yielding[s] + state.hardened[s]
        if over > _OVER_YIELD * yielding + stiffness * tolerance:
            return True
    for j in range(body.joints):
        moved, limit, over, span = _bent_by(body, state, q, j)
        if moved != 0.0 and over > _OVER_YIELD * limit + tolerance / span:
            return True
    return False


# ------------------------------------------------------------------------- after a step
@kernel(fastmath=FAST)
def settle(problem, q):
    """Let springs and joints yield and break at positions q; returns whether any did."""
    body, state, balance = problem.body, problem.state, problem.balance
    limits, slots, changed = body.limits, q.size // 2, False
    for s in range(body.springs):
        force, stiffness = spring_force(body, state, q, s), body.stiffness[s]
        moved = _set_by(body, state, s, force)
        if moved != 0.0:
            after = force - stiffness * moved
            state.set_length[s] += moved
            state.hardened[s] += limits.hardening[s] * abs(moved)
            state.rest_tension[s] += stiffness * moved
            balance.work.plastic -= 0.5 * (force * force - after * after) / stiffness
            force, changed = after, True
        if abs(force) > limits.breaking[s] and state.broken[s] == 0.0:
            state.broken[s] = 1.0
            balance.work.broken -= 0.5 * force * force / stiffness
            if body.environment.contact.present:
                update_pairs(body, q[:slots], q[slots:])
                balance.work.broken -= energy_on_spring(body, q, s)
            changed = True
    for j in range(body.joints):
        changed |= _settle_joint(problem, q, j)
    return changed


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
    if abs(rest) > math.pi:  # a deflection is wrapped once only
        rest -= math.copysign(2.0 * math.pi, rest)
    state.torque_rest[j + 1] = rest
    state.torque_cos[j + 1], state.torque_sin[j + 1] = size * math.cos(rest), size * math.sin(rest)
    after = size * joint_energy(body.law, ax, ay, bx, by, rest, soft)
    balance.work.plastic -= before - after
    return True


# ------------------------------------------------------------------------- what breaking does to a body
def leaking(loops: Sequence[Indices], ends: Indices, broken: Indices) -> list[int]:
    """The loops that a gas or liquid has left: somewhere, the spring from a mass to the next is broken.

    Neighbours that no spring has ever joined are tight, as the scene says.

    Args:
        loops: the masses around each of them.
        ends: (S, 2) the masses at the ends of each spring.
        broken: indices of the springs that are broken.
    """
    if not len(broken) or not loops:
        return []
    gone = set(map(frozenset, ends[broken].tolist()))
    around = [zip(loop.tolist(), np.roll(loop, -1).tolist(), strict=True) for loop in loops]
    return [k for k, loop in enumerate(around) if not gone.isdisjoint(map(frozenset, loop))]


def without_broken(body: Body, broken: Floats) -> Body:
    """The table of a body whose broken springs, and the joints that hold them, do nothing any more.

    Nor does a filling whose loop is `leaking`: its pressure is gone.

    Args:
        body: the table.
        broken: (S,) 1 for each broken spring, as in `State.broken`.
    """
    gone = np.flatnonzero(broken)
    stiffness, damping = body.stiffness.copy(), body.damping.copy()
    stiffness[gone] = damping[gone] = 0.0
    loose = np.isin(body.joint_a, gone) | np.isin(body.joint_b, gone)
    size, resistance = body.torque_size.copy(), body.torque_damping.copy()
    size[1 : body.joints + 1][loose] = resistance[1 : body.joints + 1][loose] = 0.0
    environment, fillings = body.environment, body.environment.fillings
    if environment.contact.present:
        environment = environment.replaced(contact=environment.contact.replaced(broken=broken.copy()))
    if environment.resistance.rows.size:
        ends = np.stack((body.spring_a, body.spring_b), 1)
        whole = of_whole_springs(environment.resistance, ends, broken)
        environment = environment.replaced(resistance=whole)
    if leaks := leaking(fillings.loops(), np.stack((body.spring_a, body.spring_b), 1), gone):
        rows = fillings.rows.copy()
        for k in leaks:
            rows[k] = FillingRow(*rows[k])._replace(strength=0.0, outside=0.0)
        environment = environment.replaced(fillings=read_only(fillings.replaced(rows=rows)))
    body = body.replaced(stiffness=stiffness, damping=damping, torque_size=size, torque_damping=resistance)
    return read_only(body.replaced(environment=environment))
