"""Springs that only pull or only push, and joints that act on one side of their rest angle only.

The sum of all forces has them as if they acted both ways. This term takes back what they exert where they do
not act: a spring that only pulls (a rope) where it is shorter than its rest length, one that only pushes
where it is longer, a joint on the wrong side of its rest angle (a stop). Nor does damping turn their force
round: a rope that is taut but shortens so fast that its damper would push exerts nothing.

The energy of what does not act is left out in `springs` and `joints`. What a damper would have taken there is
given back to the balance, and where damping would turn a force round, the elastic energy is lost as fast as
it falls.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.blocks import add_block
from ..engine.numerics.vectors import from_to, inverse_of, length_of
from ..engine.table import Floats, Indices, Table
from ..engine.tables import Body, State
from ..scene.columns import is_set_in_any
from ..scene.types import Scene
from .events import crossing
from .joints import JointsReference, bend, deflection, joint_blocks, joint_vectors, rub, terms
from .springs import SpringsReference, spring_block, tension
from .term import Places, Term, Vectors

SIDES = {"pull": 1.0, "push": -1.0, "above": 1.0, "below": -1.0}
"""The sign of the deflection at which a spring or a joint acts, by `only`."""


class OneSided(Table):
    """Read-only. Sides are 1 for what acts beyond its rest length or angle, -1 for what acts below it."""

    springs: Indices  # numbers in the tables of the springs that act on one side
    joints: Indices  # and of such joints
    spring_side: Floats  # (S,) the side of each spring, 0 for both; empty where all act on both
    joint_side: Floats  # (J,) the same of each joint


NO_SIDES = OneSided.empty()


def is_one_sided(scene: Scene) -> bool:
    """Whether a valid scene has springs or joints that act on one side only."""
    return is_set_in_any(scene.linear_springs, "only") or is_set_in_any(scene.angular_springs, "only")


def new_one_sided(scene: Scene, places: Places) -> OneSided:
    """The table of a valid scene."""
    if not is_one_sided(scene):
        return NO_SIDES
    spring_side = _sides([part.only for part in scene.linear_springs], places.spring_order)
    joint_side = _sides([part.only for part in scene.angular_springs], places.joint_order)
    return OneSided(
        springs=np.flatnonzero(spring_side),
        joints=np.flatnonzero(joint_side),
        spring_side=spring_side,
        joint_side=joint_side,
    )


def _sides(only: Sequence[object], order: Indices) -> Floats:
    """The side of each part in the order of the tables, 0 for both; empty where all act on both."""
    sides = np.array([SIDES[str(part)] if part else 0.0 for part in only], float)
    return sides[order] if sides.any() else np.zeros(0)


# ------------------------------------------------------------------------- force
@kernel(forceinline=True, fastmath=FAST)
def _spring(body, state, q, v, k):
    """The k-th of these springs: its number, vector, 1 / length, rate of the vector, and pull (elastic, and
    with its damping, kg px/s²)."""
    s = body.environment.one_sided.springs[k]
    a, b = body.spring_a[s], body.spring_b[s]
    (x, y), (u, w) = from_to(q, a, b), from_to(v, a, b)
    inv = inverse_of(x, y, body.softening)
    elastic = body.stiffness[s] * length_of(x, y, body.softening) - state.rest_tension[s]
    return s, x, y, inv, u, w, elastic, elastic + body.damping[s] * (x * u + y * w) * inv


@kernel(forceinline=True, fastmath=FAST)
def _joint(body, state, q, v, k):
    """The k-th of these joints: its number, deflection, and torque (elastic, and with its damping), over the
    lengths of its springs."""
    j = body.environment.one_sided.joints[k]
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    (au, av), (bu, bv) = joint_vectors(body, v, j)
    per_a, per_b = inverse_of(ax, ay, body.softening) ** 2, inverse_of(bx, by, body.softening) ** 2
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, state.torque_rest[j + 1])
    elastic = body.angular_stiffness[j + 1] * terms(body.law, off)[0]
    rate = (bx * bv - by * bu) * per_b - (ax * av - ay * au) * per_a
    return j, off, elastic, elastic + body.torque_damping[j + 1] * rate


@kernel(forceinline=True)
def _acts(side, deflection, elastic, whole):
    """Whether a part acts: on its side, and not where damping would turn its force round."""
    return side * deflection > 0.0 and side * whole > 0.0


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    one = body.environment.one_sided
    for k in range(one.springs.size):
        s, x, y, inv, u, w, elastic, pull = _spring(body, state, q, v, k)
        if not _acts(one.spring_side[s], elastic, elastic, pull):
            a, b = body.spring_a[s], body.spring_b[s]
            t = tension(x, y, inv, u, w, state.rest_tension[s], body.stiffness[s], body.damping[s])
            scratch.fx[b] -= t * x
            scratch.fy[b] -= t * y
            scratch.fx[a] += t * x
            scratch.fy[a] += t * y
    for k in range(one.joints.size):
        j, off, elastic, torque = _joint(body, state, q, v, k)
        if not _acts(one.joint_side[j], off, elastic, torque):
            ax, ay, bx, by = _bend(body, state, q, j)
            cx, cy, dx, dy = _rub(body, q, v, j, body.torque_damping[j + 1])
            for spring, x, y in ((body.joint_a[j], ax + cx, ay + cy), (body.joint_b[j], bx + dx, by + dy)):
                a, b = body.spring_a[spring], body.spring_b[spring]
                scratch.fx[b] -= x
                scratch.fy[b] -= y
                scratch.fx[a] += x
                scratch.fy[a] += y


@kernel(forceinline=True, fastmath=FAST)
def _bend(body, state, q, j):
    """What a joint exerts without its damping; see `joints.bend`."""
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    spring_a, spring_b = (
        (ax, ay, inverse_of(ax, ay, body.softening)),
        (bx, by, inverse_of(bx, by, body.softening)),
    )
    cos, sin, rest = state.torque_cos[j + 1], state.torque_sin[j + 1], state.torque_rest[j + 1]
    return bend(body.law, spring_a, spring_b, cos, sin, body.angular_stiffness[j + 1], rest, body.softening)


@kernel(forceinline=True, fastmath=FAST)
def _rub(body, q, v, j, damping):
    """What a joint of some damping exerts by it; see `joints.rub`."""
    (ax, ay), (bx, by) = joint_vectors(body, q, j)
    (au, av), (bu, bv) = joint_vectors(body, v, j)
    inv_a, inv_b = inverse_of(ax, ay, body.softening), inverse_of(bx, by, body.softening)
    return rub((ax, ay, inv_a, au, av), (bx, by, inv_b, bu, bv), damping, body.softening)


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """See the module for what is given back, and what is lost."""
    one, power = body.environment.one_sided, 0.0
    for k in range(one.springs.size):
        s, x, y, inv, u, w, elastic, pull = _spring(body, state, q, v, k)
        if not _acts(one.spring_side[s], elastic, elastic, pull):
            rate = (x * u + y * w) * inv
            power += (pull - elastic) * rate
            if one.spring_side[s] * elastic > 0.0:
                power += elastic * rate
    for k in range(one.joints.size):
        j, off, elastic, torque = _joint(body, state, q, v, k)
        if not _acts(one.joint_side[j], off, elastic, torque):
            (ax, ay), (bx, by) = joint_vectors(body, q, j)
            weight = length_of(ax, ay, body.softening) * length_of(bx, by, body.softening)
            damping = body.torque_damping[j + 1]
            rate = (torque - elastic) / damping if damping > 0.0 else 0.0
            power += weight * (torque - elastic) * rate
            if one.joint_side[j] * off > 0.0:
                # The energy falls with the angle, and with the lengths of the springs.
                ax, ay, bx, by = _bend(body, state, q, j)
                for spring, x, y in ((body.joint_a[j], ax, ay), (body.joint_b[j], bx, by)):
                    u, w = from_to(v, body.spring_a[spring], body.spring_b[spring])
                    power -= x * u + y * w
    balance.work.damping += part * power


# ------------------------------------------------------------------------- derivatives
@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    one, soft = body.environment.one_sided, body.softening
    for k in range(one.springs.size):
        s, x, y, inv, u, w, elastic, pull = _spring(body, state, q, v, k)
        if not _acts(one.spring_side[s], elastic, elastic, pull):
            block = spring_block(
                body.stiffness[s], body.damping[s], state.rest_tension[s], inv, (x, y), (u, w), g, definite
            )
            for i, sign in enumerate((-1.0, 1.0, 1.0, -1.0)):
                add_block(matrix.blocks, matrix.spring_target[4 * s + i], sign, block)
    for k in range(one.joints.size):
        j, off, elastic, torque = _joint(body, state, q, v, k)
        if not _acts(one.joint_side[j], off, elastic, torque):
            (a, b), (rate_a, rate_b) = joint_vectors(body, q, j), joint_vectors(body, v, j)
            of_joint = joint_blocks(
                body.law, body.angular_stiffness[j + 1], state.torque_cos[j + 1], state.torque_sin[j + 1],
                state.torque_rest[j + 1], body.torque_damping[j + 1], a, b, inverse_of(a[0], a[1], soft),
                inverse_of(b[0], b[1], soft), soft, rate_a, rate_b, g, definite,
            )  # fmt: skip
            i = 16 * j
            for block in of_joint:
                for n, sign in enumerate((-1.0, 1.0, 1.0, -1.0)):
                    add_block(matrix.blocks, matrix.joint_target[i + n], sign, block)
                i += 4


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    one, inverse_mass, slots = body.environment.one_sided, state.inverse_mass, z.size // 2
    for k in range(one.springs.size):
        s, x, y, inv, _, _, elastic, pull = _spring(body, state, q, v, k)
        if not _acts(one.spring_side[s], elastic, elastic, pull):
            a, b = body.spring_a[s], body.spring_b[s]
            zx, zy = from_to(z, a, b)
            along = factor * body.damping[s] * (x * zx + y * zy) * (inv * inv)
            out[b] += inverse_mass[b] * along * x
            out[slots + b] += inverse_mass[b] * along * y
            out[a] -= inverse_mass[a] * along * x
            out[slots + a] -= inverse_mass[a] * along * y
    for k in range(one.joints.size):
        j, off, elastic, torque = _joint(body, state, q, v, k)
        if not _acts(one.joint_side[j], off, elastic, torque):
            ax, ay, bx, by = _rub(body, q, z, j, factor * body.torque_damping[j + 1])
            for spring, x, y in ((body.joint_a[j], ax, ay), (body.joint_b[j], bx, by)):
                a, b = body.spring_a[spring], body.spring_b[spring]
                out[b] -= inverse_mass[b] * x
                out[slots + b] -= inverse_mass[b] * y
                out[a] += inverse_mass[a] * x
                out[slots + a] += inverse_mass[a] * y


# ------------------------------------------------------------------------- where a step should end
@kernel(fastmath=FAST)
def _kink_fraction(body, state, q, v, to_q, to_v, h, unseen):
    """See `Term.kink_fraction`: a part begins or ends to act, with a kink of its force, and a jump by its
    damping."""
    one, w, part = body.environment.one_sided, state.inverse_mass, 1.0
    for k in range(one.springs.size):
        s, x0, y0, inv0, u0, w0, elastic0, _ = _spring(body, state, q, v, k)
        _, x1, y1, inv1, u1, w1, elastic1, _ = _spring(body, state, to_q, to_v, k)
        stiffness = body.stiffness[s]
        if stiffness > 0.0 and (elastic0 > 0.0) != (elastic1 > 0.0):
            rate0, rate1 = (x0 * u0 + y0 * w0) * inv0, (x1 * u1 + y1 * w1) * inv1
            mobility = w[body.spring_a[s]] + w[body.spring_b[s]]
            part = min(
                part,
                _part_beyond(
                    h, elastic0 / stiffness, rate0, elastic1 / stiffness, rate1, mobility * stiffness,
                    mobility * body.damping[s], unseen,
                ),
            )  # fmt: skip
    for k in range(one.joints.size):
        j, off0, _, _ = _joint(body, state, q, v, k)
        _, off1, _, _ = _joint(body, state, to_q, to_v, k)
        if (off0 > 0.0) != (off1 > 0.0) and abs(off1 - off0) < math.pi:
            (ax, ay), (bx, by) = joint_vectors(body, q, j)
            lengths = length_of(ax, ay, body.softening) + length_of(bx, by, body.softening)
            a, b = body.joint_a[j], body.joint_b[j]
            light = max(w[body.spring_a[a]], w[body.spring_b[a]], w[body.spring_a[b]], w[body.spring_b[b]])
            rate = (off1 - off0) / h
            part = min(
                part,
                _part_beyond(
                    h, off0, rate, off1, rate, light * lengths * body.angular_stiffness[j + 1],
                    light * lengths * body.torque_damping[j + 1], unseen,
                ),
            )  # fmt: skip
    return part


@kernel(fastmath=FAST)
def _part_beyond(h, y0, r0, y1, r1, stiff, damped, unseen):
    """The part of a step that leads just beyond a zero of a deflection; 1 if the step may be kept.

    Args:
        h: length of the step, s.
        y0, r0, y1, r1: deflection at both ends, and its rate.
        stiff, damped: acceleration of a mass, px/s², by a deflection and by a rate of 1.
        unseen: speed of a mass that does not matter, px/s.
    """
    side = 1.0 if y1 > 0.0 else -1.0
    zero = crossing(h, side * y0, side * r0, side * y1, side * r1)
    rate = abs(r0 + zero * (r1 - r0))
    shorter = h * min(zero, 1.0 - zero)
    if rate * shorter * (damped + 0.5 * stiff * shorter) <= unseen:
        return 1.0
    beyond = 0.5 * (1.0 - zero) * h
    if stiff > 0.0:
        beyond = min(beyond, math.sqrt(0.2 * unseen / (stiff * rate)))
    if damped > 0.0:
        beyond = min(beyond, 0.1 * unseen / (damped * rate))
    return zero + beyond / h


# ------------------------------------------------------------------------- in NumPy
class OneSidedReference:
    """One-sided springs and joints in NumPy; see `Reference`.

    Attributes:
        springs, joints: those of them, whose stiffness and damping may be replaced.
    """

    def __init__(self, body: Body, state: State) -> None:
        one = body.environment.one_sided
        self.springs, self.joints = (
            SpringsReference(body, state, one.springs),
            JointsReference(body, state, one.joints),
        )

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        slack, loose = ~self.springs.acting(x, v), ~self.joints.acting(x, v)
        return -self.springs.forces(x, v, slack) - self.joints.forces(x, v, loose)

    def brace(self, x: Vectors) -> None:
        """See `Bracing`; then there is nothing to take back."""
        self.springs.brace(x)
        self.joints.brace(x)

    def energy(self, x: Vectors) -> float:
        """See `Reference`; what does not act has none in those of springs and of joints."""
        return 0.0


ONE_SIDED = Term(
    "one-sided",
    is_one_sided,
    OneSidedReference,
    _add_forces,
    field="one_sided",
    table=OneSided,
    new=new_one_sided,
    label="springs and joints of one side",
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    kink_fraction=_kink_fraction,
)
