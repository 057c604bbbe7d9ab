"""What springs and joints bear: beyond a limit, a spring yields or breaks, and a joint yields.

Limits are looked at by the force f of a spring and the torque of a joint, without damping.

- A spring of stiffness k yields where |f| > Y. Its rest length moves by d in the direction of the force, so
  the force decreases by k d, and Y grows by H d, with the hardening H, kg/s². Then the force is at the limit
  again: |f| - k d = Y + H d, hence d = (|f| - Y) / (k + H). This is the return mapping of plasticity with
  linear isotropic hardening (Simo & Hughes, "Computational Inelasticity", 1.4).
- A joint yields where its torque K |A||B| |f(V - r)| is beyond T, see `joints`. The rest angle r moves so far
  that the torque is T again. It does not harden.
- A spring breaks where |f| > B, after it has yielded. From then on it does nothing, nor do the joints that
  hold it, nor a filling whose loop it was a part of, and nothing touches it; see `without_broken`.

Yielding is a part of the force law. A step begins with what has yielded before (the history); at each
evaluation `yield_at` maps the force back to the limit from there, so that all stages of a step see forces
within the limits, and implicit methods the tangent of the mapped force, k H / (k + H) instead of k. After a
step, `commit_plasticity` makes what has yielded in it part of the history. Where a spring or joint has turned
round within the step, the largest way between is taken from the cubic through lengths and rates at both ends.

So the force is continuous, with a kink where yielding begins. Error control may miss that, and does not see
where something turns round, or breaks too late: `event_fraction` asks for a step that ends there instead, as
far as it matters to the tolerance.

The energy that is lost is entered into the energy balance, with that of what touches a spring that breaks.
Limits are no `Term`, since they exert no force of their own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.blocks import add_block, outer, plus
from ..engine.numerics.vectors import deflection, from_to, length_of
from ..engine.table import Floats, Indices
from ..engine.tables import Body, Limits, State
from ..scene.columns import column
from ..scene.types import Scene
from .all import accelerations
from .drive import wrap
from .events import LARGEST_PART, UNSEEN, crossing, kink_fraction, peak
from .fillings import FillingRow
from .joints import TUTORIAL, deflection_at, is_loose, is_sine, joint_energy, joint_vectors, terms
from .motors import stopped
from .resistance import of_whole_springs
from .touch.broad_phase import update_pairs
from .touch.contact import energy_along_spring, energy_on

# Unless noted, doubling or halving one of these numbers fails no test.
_ON = 1e-9
"""Force below the yield force, as a fraction of it, from which on a spring that is pulled further yields."""
_STEEPEST = 0.999
"""Largest sine of the deflection to which a yielding joint returns; beyond 90 degrees it would not hold. At
0.5, `test_the_matrix_and_its_part_by_velocities_are_those_of_the_forces` fails."""
_SHORTEST_REST = 0.01
"""Smallest rest length, as a fraction of that of the scene, to which a spring can be squeezed for good."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
NO_LIMITS = Limits.empty().read_only()
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
    return Limits(
        present=True,
        breaking=_or_infinite(column(springs, "strength"))[spring_order],
        yielding=_or_infinite(column(springs, "yield_force"))[spring_order],
        hardening=column(springs, "hardening")[spring_order],
        bending=bending,
    )


def _or_infinite(limits: Floats) -> Floats:
    return np.where(np.isnan(limits), math.inf, limits)


# ------------------------------------------------------------------------- what yields, and by how much
@kernel(forceinline=True, fastmath=FAST)
def _trial_force(body, state, q, s):
    """The force of a spring if it did not yield in this step, kg px/s²; 0 where one of one side is slack."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    force = body.stiffness[s] * length_of(x, y, body.softening) - state.trial_tension[s]
    sides = body.environment.one_sided.spring_side
    return 0.0 if sides.size > 0 and sides[s] * force < 0.0 else force


@kernel(fastmath=FAST)
def _plastic_increment(body, state, s, over, force):
    """How far the rest length of a spring moves for good, px; never to less than it may be.

    Args:
        body, state, s: the tables, and which spring.
        over: how far it yields, px, if positive.
        force: its sign is that of the force.
    """
    if not over > 0.0:
        return 0.0
    rest = state.trial_tension[s] / body.stiffness[s]
    return max(math.copysign(over, force), min(_SHORTEST_REST * body.rest_length[s] - rest, 0.0))


@kernel(forceinline=True, fastmath=FAST)
def _beyond(body, state, s, force):
    """How far a spring yields under a trial force, px; negative where it does not."""
    stiffness = body.stiffness[s]
    if not stiffness > 0.0:
        return -1.0
    over = abs(force) - (body.limits.yielding[s] + state.hardened[s])
    return over / (stiffness + body.limits.hardening[s])


@kernel(fastmath=FAST)
def _joint_trial_state(body, state, q, j):
    """How a joint is bent at positions q, if it did not yield in this step.

    Returns:
        off: the deflection, radians.
        limit: that at which it yields; infinite where it has no torque, or never as much, or is loose.
        kept: that to which it returns.
        lengths: |A||B|, px².
    """
    size, soft = body.angular_stiffness[j + 1], body.softening
    if size <= 0.0 or not body.limits.bending[j] < np.inf:
        return 0.0, np.inf, 0.0, 1.0
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    lengths = length_of(ax, ay, soft) * length_of(bx, by, soft)
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, state.trial_angle[j])
    if is_loose(body, j, off):
        return 0.0, np.inf, 0.0, lengths
    torque = body.limits.bending[j] / (size * lengths)
    if is_sine(body.law):
        if torque >= 1.0:  # it never has that torque
            return off, np.inf, 0.0, lengths
        # Bent beyond its largest torque, it has yielded on the way.
        return off, math.asin(torque), math.asin(min(torque, _STEEPEST)), lengths
    limit = deflection_at(body.law, torque, math.pi)
    return off, limit, limit, lengths


@kernel(forceinline=True, fastmath=FAST)
def _turn_rest(body, state, j, rest):
    """Set the rest angle of a joint, radians."""
    if abs(rest) > math.pi:  # a deflection is wrapped once only
        rest -= math.copysign(2.0 * math.pi, rest)
    size = body.angular_stiffness[j + 1]
    state.torque_rest[j + 1] = rest
    state.torque_cos[j + 1], state.torque_sin[j + 1] = size * math.cos(rest), size * math.sin(rest)


@kernel(fastmath=FAST)
def yield_at(body, state, q):
    """Set rest lengths and rest angles to what they are if the step leads to positions q."""
    limits, known = body.limits, state.yields[body.springs + body.joints] > 0.0
    for s in range(body.springs):
        if limits.yielding[s] < np.inf:
            force = _trial_force(body, state, q, s)
            over = _beyond(body, state, s, force)
            if known:
                moved = math.copysign(1.0, force) * over if state.yields[s] > 0.0 else 0.0
            else:
                moved = _plastic_increment(body, state, s, over, force)
            state.rest_tension[s] = state.trial_tension[s] + body.stiffness[s] * moved
    for j in range(body.joints):
        off, limit, kept, _ = _joint_trial_state(body, state, q, j)
        on = state.yields[body.springs + j] > 0.0 if known else abs(off) > limit
        moved = off - math.copysign(kept, off) if on else 0.0
        if moved != 0.0 or state.torque_rest[j + 1] != state.trial_angle[j]:
            _turn_rest(body, state, j, state.trial_angle[j] + moved)


@kernel(forceinline=True)
def freeze_active_set(body, state, held):
    """Let what yields be what the last `add_yielding_derivatives` found, whatever the forces are, or not.

    A difference quotient of the forces there would else be half of that of a spring that yields, and half of
    one that does not.
    """
    if body.limits.present:
        state.yields[body.springs + body.joints] = 1.0 if held else 0.0


@kernel(fastmath=FAST)
def yielding_accelerations(body, state, scratch, q, v, a):
    """`forces.all.accelerations` of a body in which something yields or breaks."""
    yield_at(body, state, q)
    accelerations(body, state, scratch, q, v, a)


# ------------------------------------------------------------------------- derivatives
@kernel(fastmath=FAST)
def add_yielding_derivatives(body, state, matrix, q, v):
    """Add what yielding changes of the derivatives of forces to `matrix.blocks`, after `yield_at`.

    What yields is noted in `State.yields`.

    A spring that yields has R' = k² / (k + H) by its length, so that its tension changes by
    k² / (k + H) u uᵀ, with the unit vector u.

    A joint that yields keeps its torque G, and its energy U, which is K |A||B| F, depends on |A||B| only:
    with f K |A||B| = T, dU/d(K |A||B|) = F - f² / f'. In the notation of `joints.joint_blocks`, that is
    without the stiffness S = K |A||B| f' by the angle.
    """
    limits = body.limits
    for s in range(body.springs):
        force, stiffness = _trial_force(body, state, q, s), body.stiffness[s]
        x, y = from_to(q, body.spring_a[s], body.spring_b[s])
        u, w = from_to(v, body.spring_a[s], body.spring_b[s])
        beyond = _beyond(body, state, s, force)
        on = beyond > -_ON * limits.yielding[s] / (stiffness + limits.hardening[s])
        state.yields[s] = -1.0
        if on and (beyond > 0.0 or (x * u + y * w) * force > 0.0):
            moved = _plastic_increment(body, state, s, max(beyond, 0.0), force)
            if abs(moved) < beyond * (1.0 - _ON):
                continue  # it cannot be squeezed any further
            state.yields[s] = 1.0
            softer = stiffness * stiffness / (stiffness + limits.hardening[s])
            block = outer(softer / (x * x + y * y + body.softening), (x, y), (x, y))
            for k, sign in enumerate((1.0, -1.0, -1.0, 1.0)):
                add_block(matrix.blocks, matrix.spring_target[4 * s + k], sign, block)
    for j in range(body.joints):
        off, limit, kept, lengths = _joint_trial_state(body, state, q, j)
        state.yields[body.springs + j] = -1.0
        if abs(off) < limit * (1.0 - _ON):
            continue
        if abs(off) <= limit and _opening(body, q, v, j)[0] * off <= 0.0:
            continue
        state.yields[body.springs + j] = 1.0
        _add_yielding_joint(
            body, matrix, q, j, math.copysign(kept, off), body.angular_stiffness[j + 1] * lengths
        )


@kernel(fastmath=FAST)
def _add_yielding_joint(body, matrix, q, j, off, size):
    """The same for joint j with the deflection `off` and the stiffness `size`, K |A||B|."""
    a, b = joint_vectors(body, q, j)
    len_a, len_b = length_of(a[0], a[1], body.softening), length_of(b[0], b[1], body.softening)
    torque, _, slope = terms(body.law, off)
    stiffness, excess = size * slope, size * torque * torque / slope
    torque *= size
    unit_a, unit_b = (a[0] / len_a, a[1] / len_a), (b[0] / len_b, b[1] / len_b)
    normal_a, normal_b = (unit_a[1] / len_a, -unit_a[0] / len_a), (unit_b[1] / len_b, -unit_b[0] / len_b)
    # The derivatives of the torque by A and B, if it did not yield.
    by_a = (torque / len_a * unit_a[0] + stiffness * normal_a[0],
            torque / len_a * unit_a[1] + stiffness * normal_a[1])  # fmt: skip
    by_b = (torque / len_b * unit_b[0] - stiffness * normal_b[0],
            torque / len_b * unit_b[1] - stiffness * normal_b[1])  # fmt: skip
    aa, ab = outer(1.0, normal_a, by_a), outer(1.0, normal_a, by_b)
    ba, bb = outer(-1.0, normal_b, by_a), outer(-1.0, normal_b, by_b)
    if body.law != TUTORIAL:
        aa = plus(aa, outer(torque / len_a, unit_a, normal_a))
        ab = plus(ab, outer(-torque / len_a, unit_a, normal_b))
        ba = plus(ba, outer(torque / len_b, unit_b, normal_a))
        bb = plus(bb, outer(-torque / len_b, unit_b, normal_b))
        aa = plus(aa, outer(excess / (len_a * len_a), unit_a, unit_a))
        ab = plus(ab, outer(excess / (len_a * len_b), unit_a, unit_b))
        ba = plus(ba, outer(excess / (len_a * len_b), unit_b, unit_a))
        bb = plus(bb, outer(excess / (len_b * len_b), unit_b, unit_b))
    i = 16 * j
    for block in (aa, ab, ba, bb):
        for k, sign in enumerate((1.0, -1.0, -1.0, 1.0)):
            add_block(matrix.blocks, matrix.joint_target[i + k], sign, block)
        i += 4


# ------------------------------------------------------------------------- within a step
@kernel(forceinline=True, fastmath=FAST)
def _lengthening(body, q, v, s):
    """The rate of a spring's length, px/s."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    return (x * u + y * w) / length_of(x, y, body.softening)


@kernel(forceinline=True, fastmath=FAST)
def _opening(body, q, v, j):
    """The rate of a joint's angle, and that of the logarithm of |A||B|, 1/s."""
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    (ux, uy), (wx, wy) = joint_vectors(body, v, j)
    per_a, per_b = 1.0 / (ax * ax + ay * ay + body.softening), 1.0 / (bx * bx + by * by + body.softening)
    turned = (bx * wy - by * wx) * per_b - (ax * uy - ay * ux) * per_a
    return turned, (ax * ux + ay * uy) * per_a + (bx * wx + by * wy) * per_b


@kernel(forceinline=True, fastmath=FAST)
def _spring_way(body, state, q, v, s):
    """How far a spring yields without the history of this step, px, the rate of that, and its sign."""
    force = _trial_force(body, state, q, s)
    side = math.copysign(1.0, force)
    softness = body.stiffness[s] / (body.stiffness[s] + body.limits.hardening[s] + 1e-300)
    rate = side * softness * _lengthening(body, q, v, s) if force != 0.0 else 0.0
    return _beyond(body, state, s, force), rate, side


@kernel(forceinline=True, fastmath=FAST)
def _joint_way(body, state, q, v, j):
    """How far a joint is beyond its limit, radians, the rate of that, and its sign."""
    off, limit, kept, _ = _joint_trial_state(body, state, q, j)
    side = math.copysign(1.0, off)
    turned, longer = _opening(body, q, v, j)
    torque, _, slope = terms(body.law, kept)
    # The torque at which it yields is T / (K |A||B|).
    return abs(off) - limit, side * turned + torque / max(slope, 1e-3) * longer, side


@kernel(fastmath=FAST)
def event_fraction(problem, q, v, to_q, to_v, to_a, h, tolerance):
    """The part of a step that should be tried instead of it; 1 if it may be kept.

    Args:
        problem: the tables.
        q, v: flat positions and velocities at its start.
        to_q, to_v, to_a: those at its end, and the accelerations there.
        h: its length, s.
        tolerance: px per second.
    """
    body, state = problem.body, problem.state
    limits, w, unseen = body.limits, state.inverse_mass, UNSEEN * tolerance
    part = 1.0
    for s in range(body.springs):
        stiffness = body.stiffness[s]
        if not stiffness > 0.0:
            continue
        if limits.yielding[s] < np.inf:
            y0, r0, side0 = _spring_way(body, state, q, v, s)
            y1, r1, side1 = _spring_way(body, state, to_q, to_v, s)
            if side0 == side1:
                rest = state.trial_tension[s] / stiffness
                room = np.inf if side1 > 0.0 else rest - _SHORTEST_REST * body.rest_length[s]
                quick = stiffness * (w[body.spring_a[s]] + w[body.spring_b[s]])
                part = min(part, kink_fraction(h, y0, r0, y1, r1, room, quick, unseen))
        if limits.breaking[s] < np.inf:
            part = min(part, _break_fraction(problem, s, q, v, to_q, to_v, to_a, h, unseen))
    for j in range(body.joints):
        if limits.bending[j] < np.inf and body.angular_stiffness[j + 1] > 0.0:
            y0, r0, side0 = _joint_way(body, state, q, v, j)
            y1, r1, side1 = _joint_way(body, state, to_q, to_v, j)
            if side0 == side1:
                quick = _joint_stiffness(body, w, to_q, j)
                part = min(part, kink_fraction(h, y0, r0, y1, r1, np.inf, quick, unseen))
    return min(part, LARGEST_PART) if part < 1.0 else 1.0


@kernel(forceinline=True, fastmath=FAST)
def _joint_stiffness(body, w, q, j):
    """The largest acceleration that a joint gives a mass per deflection, px/s²."""
    s, r = body.joint_a[j], body.joint_b[j]
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    len_a, len_b = length_of(ax, ay, body.softening), length_of(bx, by, body.softening)
    light = max(w[body.spring_a[s]], w[body.spring_b[s]], w[body.spring_a[r]], w[body.spring_b[r]])
    return body.angular_stiffness[j + 1] * light * (len_a + len_b)


@kernel(fastmath=FAST)
def _break_fraction(problem, s, q, v, to_q, to_v, to_a, h, unseen):
    """The part of a step that leads just beyond the strength of a spring; 1 if the step may be kept.

    Too late a break adds the force that is gone, and the accelerations of what changes with it, for so long.
    """
    body, state = problem.body, problem.state
    y0, r0, side0 = _strain(body, state, q, v, s)
    y1, r1, side1 = _strain(body, state, to_q, to_v, s)
    if side0 != side1:
        y0, r0 = -y0 - 2.0 * body.limits.breaking[s], -r0
    top, _ = peak(h, y0, r0, y1, r1)
    if not max(top, y0) > 0.0:
        return 1.0
    part = crossing(h, y0, r0, y1, r1) if y0 < 0.0 else 0.0
    most, slots = 0.0, q.size // 2
    for i in range(1, body.masses + 1):
        most = max(most, abs(to_a[i]), abs(to_a[slots + i]))
    light = max(state.inverse_mass[body.spring_a[s]], state.inverse_mass[body.spring_b[s]])
    late = unseen / (body.limits.breaking[s] * light + most + 1e-300)
    if y1 > 0.0 and (1.0 - part) * h <= late:
        return 1.0
    return part + 0.5 * late / h


@kernel(forceinline=True, fastmath=FAST)
def _strain(body, state, q, v, s):
    """How far the force of a spring is beyond its strength, kg px/s², its rate, and its sign."""
    limits, stiffness = body.limits, body.stiffness[s]
    force = _trial_force(body, state, q, s)
    rate = stiffness * _lengthening(body, q, v, s) if force != 0.0 else 0.0
    moved = _plastic_increment(body, state, s, _beyond(body, state, s, force), force)
    side = math.copysign(1.0, force)
    if moved != 0.0:
        force -= stiffness * moved
        rate *= limits.hardening[s] / (stiffness + limits.hardening[s])
    return abs(force) - limits.breaking[s], side * rate, side


# ------------------------------------------------------------------------- after a step
@kernel(fastmath=FAST)
def commit_plasticity(problem, q, v, to_q, to_v, h):
    """Make what has yielded in a step part of the history, and let springs break.

    Args:
        problem: the tables.
        q, v: flat positions and velocities at its start.
        to_q, to_v: those at its end.
        h: its length, s; 0 if what was between is not to be looked at, as under a fixed step; negative if it
            took no time, so that all elastic energy that goes is lost.

    Returns:
        Whether anything broke.
    """
    body, state, balance = problem.body, problem.state, problem.balance
    limits, slots, broke = body.limits, q.size // 2, False
    for s in range(body.springs):
        stiffness = body.stiffness[s]
        if limits.yielding[s] < np.inf:
            way, r1, side = _spring_way(body, state, to_q, to_v, s)
            if h > 0.0:
                y0, r0, side0 = _spring_way(body, state, q, v, s)
                if side0 == side:
                    way, _ = peak(h, y0, r0, way, r1)
            moved = _plastic_increment(body, state, s, way, side)
            if moved != 0.0:
                before = limits.yielding[s] + state.hardened[s]
                state.set_length[s] += moved
                state.hardened[s] += limits.hardening[s] * abs(moved)
                state.trial_tension[s] += stiffness * moved
                mean = before + 0.5 * limits.hardening[s] * abs(moved)
                if h < 0.0:
                    mean += 0.5 * (stiffness + limits.hardening[s]) * abs(moved)
                balance.work.plastic -= mean * abs(moved)
            state.rest_tension[s] = state.trial_tension[s]
        force = _trial_force(body, state, to_q, s)
        if abs(force) > limits.breaking[s] and state.broken[s] == 0.0:
            state.broken[s] = 1.0
            balance.work.broken -= 0.5 * force * force / stiffness
            if body.environment.contact.present:
                update_pairs(body, to_q[:slots], to_q[slots:])
                balance.work.broken -= energy_on(body, to_q, s)
                balance.work.broken -= energy_along_spring(body, state, to_q, s)
            broke = True
    for j in range(body.joints):
        _settle_joint(problem, j, q, v, to_q, to_v, h)
    return broke


@kernel(fastmath=FAST)
def _settle_joint(problem, j, q, v, to_q, to_v, h):
    """Let a joint yield, or break with one of its springs."""
    body, state, balance = problem.body, problem.state, problem.balance
    size = body.angular_stiffness[j + 1]
    if size <= 0.0:
        return
    s, r = body.joint_a[j], body.joint_b[j]
    if body.limits.bending[j] < np.inf:
        way, r1, side = _joint_way(body, state, to_q, to_v, j)
        if h > 0.0:
            y0, r0, side0 = _joint_way(body, state, q, v, j)
            if side0 == side:
                way, _ = peak(h, y0, r0, way, r1)
        if way > 0.0:
            _, limit, kept, lengths = _joint_trial_state(body, state, to_q, j)
            moved = side * (way + (limit - kept))
            state.set_angle[j] = wrap(state.set_angle[j] + math.degrees(moved))
            _turn_rest(body, state, j, state.trial_angle[j] + moved)
            state.trial_angle[j] = state.torque_rest[j + 1]
            torque, energy, _ = terms(body.law, kept)
            lost = terms(body.law, limit)[1] - energy + torque * way
            if h < 0.0:
                lost = terms(body.law, limit + way)[1] - energy
            balance.work.plastic -= size * lengths * lost
        elif state.torque_rest[j + 1] != state.trial_angle[j]:
            _turn_rest(body, state, j, state.trial_angle[j])
    if state.broken[s] + state.broken[r] > 0.0:
        (ax, ay), (bx, by) = joint_vectors(body, to_q, j)
        rest = state.torque_rest[j + 1]
        if not is_loose(body, j, deflection(ax * by - ay * bx, ax * bx + ay * by, rest)):
            balance.work.broken -= size * joint_energy(body.law, ax, ay, bx, by, rest, body.softening)


def restore_committed(body: Body, state: State) -> None:
    """Set rest lengths and rest angles to the history again, after a step that was not kept."""
    joints = slice(1, body.joints + 1)
    state.rest_tension[: body.springs] = state.trial_tension
    state.torque_rest[joints] = state.trial_angle
    state.torque_cos[joints] = body.joint_stiffness * np.cos(state.trial_angle)
    state.torque_sin[joints] = body.joint_stiffness * np.sin(state.trial_angle)


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
    size, resistance = body.angular_stiffness.copy(), body.torque_damping.copy()
    size[1 : body.joints + 1][loose] = resistance[1 : body.joints + 1][loose] = 0.0
    environment, fillings = body.environment, body.environment.fillings
    if environment.contact.present:
        environment = environment.replaced(contact=environment.contact.replaced(broken=broken.copy()))
    if environment.motors.joint.size:
        environment = environment.replaced(motors=stopped(environment.motors, loose))
    if environment.resistance.rows.size:
        ends = np.stack((body.spring_a, body.spring_b), 1)
        whole = of_whole_springs(environment.resistance, ends, broken)
        environment = environment.replaced(resistance=whole)
    if leaks := leaking(fillings.loops(), np.stack((body.spring_a, body.spring_b), 1), gone):
        rows = fillings.rows.copy()
        for k in leaks:
            rows[k] = FillingRow(*rows[k])._replace(strength=0.0, outside=0.0)
        environment = environment.replaced(fillings=fillings.replaced(rows=rows))
    body = body.replaced(
        stiffness=stiffness, damping=damping, angular_stiffness=size, torque_damping=resistance
    )
    return body.replaced(environment=environment).read_only()
