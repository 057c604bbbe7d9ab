"""The tables of what springs bear, and of a body some of whose springs are broken."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..forces.fillings import FILLING_OUTSIDE, FILLING_PRESSURE
from ..forces.term import read_only
from ..kernels.core.strength import Strength
from ..kernels.core.tables import Body, Floats, Indices
from ..scene.types import Scene

_NOTHING = np.zeros(0)
NO_STRENGTH = Strength(
    present=False, breaking=_NOTHING, yielding=_NOTHING, hardening=_NOTHING, bending=_NOTHING
)
"""The table of a scene in which nothing yields or breaks."""


def new_strength(scene: Scene, spring_order: Indices, joint_order: Indices) -> Strength:
    """The table of a valid scene in which something yields or breaks.

    Args:
        scene: the scene.
        spring_order: (S,) scene index of each spring of the tables.
        joint_order: (J,) index in the tables of each angular spring of the scene.
    """
    springs = [scene.linear_springs[s] for s in spring_order]
    bending = np.full(len(scene.angular_springs), math.inf)
    bending[joint_order] = [_limit(joint.yield_torque) for joint in scene.angular_springs]
    strength = Strength(
        present=True,
        breaking=np.array([_limit(spring.strength) for spring in springs]),
        yielding=np.array([_limit(spring.yield_force) for spring in springs]),
        hardening=np.array([spring.hardening for spring in springs]),
        bending=bending,
    )
    for _, array in strength.arrays():
        array.setflags(write=False)
    return strength


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
    joint_stiffness, size, resistance = (
        body.joint_stiffness.copy(),
        body.torque_size.copy(),
        body.torque_damping.copy(),
    )
    joint_stiffness[loose] = 0.0
    size[1 : body.joints + 1][loose] = resistance[1 : body.joints + 1][loose] = 0.0
    tables = {
        "stiffness": stiffness,
        "damping": damping,
        "joint_stiffness": joint_stiffness,
        "torque_size": size,
        "torque_damping": resistance,
    }
    for table in tables.values():
        table.setflags(write=False)
    environment, fillings = body.environment, body.environment.fillings
    if environment.contact.present:
        environment = environment.replaced(contact=environment.contact.replaced(broken=broken.copy()))
    if leaks := leaking(fillings.loops(), np.stack((body.spring_a, body.spring_b), 1), gone):
        rows = fillings.rows.copy()
        rows[np.ix_(leaks, (FILLING_PRESSURE, FILLING_OUTSIDE))] = 0.0
        environment = environment.replaced(fillings=read_only(fillings.replaced(rows=rows)))
    return body.replaced(**tables, environment=environment)


def _limit(value: float | None) -> float:
    return math.inf if value is None else value
