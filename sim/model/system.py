"""Builds the tables of the kernels from a scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeVar

import msgspec
import numpy as np

from ..engine.layout import aligned_arena
from ..engine.numerics.roots import MIN_SQUARE
from ..engine.table import Table
from ..engine.tables import (
    SHORTEST_SQUARED,
    Body,
    Floats,
    Indices,
    padded,
)
from ..forces.environment import EMPTY, is_surrounded, new_environment
from ..forces.joints import LAWS, NO_JOINTS
from ..forces.muscles import NO_MUSCLES, new_muscles
from ..forces.plasticity import NO_LIMITS, new_limits
from ..forces.runs import new_links, order_in_runs
from ..scene.columns import column, columns, ends, vectors
from ..scene.parts import constant_force
from ..scene.types import Damage, Integrator, Scene, is_damageable, is_loaded
from ..solve.registry import METHODS

_Made = TypeVar("_Made", bound=Table)

# Unless noted, doubling or halving one of these numbers fails no test.
_SOFT_IN_TOLERANCES = 0.02
"""Softening length of springs under an adaptive method, in tolerances; see `Body.softening`. Doubled,
`test_lengths_are_softened_far_below_the_tolerance_and_not_at_all_for_the_tutorial` fails."""
_SOFT_AT_MOST = 1e-4
"""The largest softening length, as a fraction of a typical spring's length."""

_ENDLESS = 1e30
"""Softening of padding springs, px²: makes them longer than any spring, but fits into single precision."""

_BEHIND_RUNS = 7
"""Number of springs and joints after the last one that loops over a run read."""


@dataclass(frozen=True)
class System:
    """The kernels' tables for one scene.

    Attributes:
        body: the tables; masses and springs are numbered as the kernels visit them.
        mass_order: (n,) scene index of the mass in slot 1, 2, ..., n.
        mass_index: (n,) the slot, counted from 1, of each mass of the scene.
        vector_index: (n, 2) the indices of x and y of each mass of the scene in a flat vector, see `State`.
        slots: number of slots of a state.
        spring_order: (S,) scene index of each spring of the tables.
        joint_order: (J,) index of the joint in the tables for each angular spring of the scene.
        inverse_mass: (n,) 1/kg, in slot order, also of held masses.
        held: (n,) whether a mass is held, in slot order.
        start: (4, n) x, y, vx, vy at the start, in slot order.
        loads: (2, n) x and y of the constant forces on the masses, kg px/s², in slot order; None if there are
            none.
    """

    body: Body
    mass_order: Indices
    mass_index: Indices
    vector_index: Indices
    slots: int
    spring_order: Indices
    joint_order: Indices
    inverse_mass: Floats
    held: np.ndarray
    start: Floats
    loads: Floats | None


def build_system(scene: Scene, damaged: bool = False) -> System:
    """Build the tables of a valid scene.

    Args:
        scene: the scene.
        damaged: whether existing damage must be kept even though nothing can yield or break any more; damage
            in the scene's pose is kept anyway.

    A chain is a body whose springs run head to tail through all masses, and whose angular springs each
    connect a spring to the next one; its masses and springs may be listed in any order. A ring is a closed
    chain. A body with surroundings is neither, nor is one that yields or breaks.
    """
    springs, joints, n = scene.linear_springs, scene.angular_springs, len(scene.masses)
    loaded = is_loaded(scene)
    damageable = damaged or is_damageable(scene) or damage_of(scene) is not None
    of_springs, of_joints = ends(springs), ends(joints)
    numbers = columns(springs, "stiffness", "damping", "rest_length")
    of_joint = _joint_stiffness(scene), *columns(joints, "damping", "rest_angle")
    mass = column(scene.masses, "mass")
    places, velocities = vectors(scene.masses, "position"), vectors(scene.masses, "velocity")
    softening = _softening(scene, numbers[2], places, of_springs)
    along = not damageable and not is_surrounded(scene)
    wiring = wired(n, along, *(end.tobytes() for end in (*of_springs, *of_joints)))
    mass_order, mass_index, order = wiring.mass_order, wiring.mass_index, wiring.spring_order
    body = with_numbers(wiring, list(numbers), of_joint, LAWS[scene.force_law].code, softening)
    method = METHODS[scene.integrator.method]
    step = 0.0 if method.adaptive or method.implicit else scene.integrator.dt
    body = body.replaced(
        limits=new_limits(scene, order, wiring.joint_order) if damageable else NO_LIMITS,
        muscles=new_muscles(scene, order, wiring.joint_order),
        environment=new_environment(
            scene, mass_index, wiring.ends, wiring.slots, order, wiring.joint_order, step
        ),
    ).read_only()
    held = np.zeros(n, np.bool_)
    for anchor in scene.anchors:
        held[mass_index[anchor.mass] - 1] = True
    if scene.pose is not None:
        places, velocities = np.array(scene.pose.positions), np.array(scene.pose.velocities)
    start = np.empty((4, n))
    start[:2], start[2:] = places[mass_order].T, velocities[mass_order].T
    start[2:, held] = 0.0
    loads = np.array([constant_force(one) or (0.0, 0.0) for one in scene.masses], float).T if loaded else None
    return System(
        body=body,
        mass_order=mass_order,
        mass_index=mass_index,
        vector_index=wiring.vector_index,
        slots=wiring.slots,
        spring_order=order,
        joint_order=wiring.joint_order,
        inverse_mass=1.0 / mass[mass_order],
        held=held,
        start=start,
        loads=None if loads is None else loads[:, mass_order],
    )


def for_analysis(scene: Scene) -> Scene:
    """Return the scene for analyses: its muscles rest, and its method softens nothing.

    See `build_system` for what would be softened.
    """
    # A fixed-step method does not soften springs, and an implicit one does not soften walls.
    method = Integrator(method="generalized_alpha")
    return msgspec.structs.replace(scene, integrator=method, beat=msgspec.UNSET)


def damage_of(scene: Scene) -> Damage | None:
    """Return everything that has yielded or broken in the scene's pose; None if nothing has."""
    return scene.pose.damage if scene.pose is not None else None


def same_topology(old: Scene, new: Scene) -> bool:
    """Return whether springs and joints have the same connections in both, so that a state fits both."""
    return (
        len(old.masses) == len(new.masses)
        and [(s.a, s.b) for s in old.linear_springs] == [(s.a, s.b) for s in new.linear_springs]
        and [(j.a, j.b) for j in old.angular_springs] == [(j.a, j.b) for j in new.angular_springs]
    )


def joint_stiffness(scene: Scene) -> list[float]:
    """Return the stiffness of each angular spring, kg/s²; diagonal templates are sqrt(2) times as stiff."""
    return _joint_stiffness(scene).tolist()


def _joint_stiffness(scene: Scene) -> Floats:
    factor = math.sqrt(2.0) if scene.template is not None and scene.template % 90 else 1.0
    return column(scene.angular_springs, "stiffness") * factor


def slots_of(body: Body) -> int:
    """Return the number of slots of a body's states."""
    return _slots_for(body.masses, body.stiffness.size if body.chain or body.ring else 0)


def _slots_for(masses: int, chained: int) -> int:
    """Return the number of slots, given the number of springs of a chain or a ring."""
    # The chain's loops look one slot back and, from the last spring, three ahead; and loops over flat vectors
    # should leave no scalar remainder.
    return padded((chained or padded(masses)) + 3)  # aligns both halves of a flat vector alike


class Topology(NamedTuple):
    """The parts of the tables that depend only on the connections of the masses; S springs, J joints, n
    masses.

    Attributes:
        in_order: whether the body is a chain or a ring.
        ring: whether it is a ring.
        room: size of the arrays of springs.
        slots: number of slots of a state.
        mass_order, mass_index, vector_index, spring_order, joint_order: see `System`.
        ends: (S, 2) the slots of the masses at the ends of each spring, in the order of the tables.
        body: tables with these connections and meaningless numbers.
    """

    in_order: bool
    ring: bool
    room: int
    slots: int
    mass_order: Indices
    mass_index: Indices
    vector_index: Indices
    spring_order: Indices
    joint_order: Indices
    ends: Indices
    body: Body


_KEPT = 4
"""Number of wirings that are cached. That of a cloth of 10 000 masses takes 5 MB."""


@lru_cache(maxsize=_KEPT)
def wired(n: int, along: bool, *tables: bytes) -> Topology:
    """Return the wiring of a body with n masses.

    The most recent ones are cached, since scenes are often rebuilt with other parameters only.

    Args:
        n: number of masses.
        along: whether the body may be a chain or a ring.
        tables: the `a` and the `b` of the scene's springs and joints.
    """
    of_spring, of_joint = np.frombuffer(b"".join(tables[:2]), np.int64), tables[2:]
    spring_ends = of_spring.reshape(2, -1)
    joints = np.frombuffer(b"".join(of_joint), np.int64).reshape(2, -1)
    count = spring_ends.shape[1]
    order = _order_along(n, spring_ends, joints) if along else None
    mass_order, spring_order = order or (np.arange(n), _hinged_first(spring_ends, joints, n + 1))
    in_order, ring = order is not None, order is not None and count == n
    mass_index = np.empty(n, np.int64)
    mass_index[mass_order] = np.arange(1, n + 1)
    # At least as many springs as masses, since the chain's loops over masses read as many, and one more. For
    # others, the loops over a run read a few more.
    room = padded(max(count, n)) + 1 + (0 if in_order else _BEHIND_RUNS)
    spring_a, spring_b = (mass_index[end[spring_order]] for end in spring_ends)
    spring_index = np.empty(count, np.int64)
    spring_index[spring_order] = np.arange(count)
    joint_a, joint_b = (spring_index[end] for end in joints)
    held = np.zeros(count, np.bool_)
    held[joint_a] = held[joint_b] = True
    hinged = int(held.sum())
    if in_order and joint_a.size:
        joint_order = joint_a
        of_chain = n if ring else n - 2
        joint_a, joint_b = np.arange(of_chain), (np.arange(of_chain) + 1) % count
        hinged = count
    else:
        by_runs = order_in_runs(joint_a, joint_b, hinged)
        joint_order = np.empty(by_runs.size, np.int64)
        joint_order[by_runs] = np.arange(by_runs.size)
        joint_a, joint_b = joint_a[by_runs], joint_b[by_runs]
    nothing = np.zeros(0)
    body = Body(
        masses=n,
        springs=count,
        joints=joint_a.size,
        damped=False,
        joint_damped=False,
        chain=in_order and not ring,
        ring=ring,
        law=NO_JOINTS,
        softening=0.0,
        softenings=nothing,
        spring_a=spring_a,
        spring_b=spring_b,
        stiffness=nothing,
        damping=nothing,
        rest_length=nothing,
        joint_a=joint_a,
        joint_b=joint_b,
        joint_rest=nothing,
        angular_stiffness=nothing,
        torque_damping=nothing,
        hinged=hinged,
        held=new_links(spring_a[:hinged], spring_b[:hinged], n + 1, nothing=room),
        free=new_links(spring_a[hinged:], spring_b[hinged:], n + 1, nothing=room, begin=hinged),
        bends=new_links(joint_a, joint_b, hinged, nothing=joint_a.size),
        limits=NO_LIMITS,
        muscles=NO_MUSCLES,
        environment=EMPTY,
    )
    ends_of_springs = np.stack((spring_a, spring_b), 1)
    slots = _slots_for(n, room if in_order else 0)
    vector_index = np.stack((mass_index, mass_index + slots), 1)
    for array in (mass_order, mass_index, vector_index, spring_order, joint_order, ends_of_springs):
        array.setflags(write=False)
    return Topology(
        in_order, ring, room, slots, mass_order, mass_index, vector_index, spring_order, joint_order,
        ends_of_springs, body.read_only(),
    )  # fmt: skip


def _order_along(n: int, spring_ends: Indices, joints: Indices) -> tuple[Indices, Indices] | None:
    """Return (masses, springs) in order along a chain or a ring, or None for any other body."""
    starts, stops = spring_ends.tolist()
    count = len(starts)
    closed = count == n
    if n < (3 if closed else 2) or not (closed or count == n - 1):
        return None
    leaving = {a: s for s, a in enumerate(starts)}
    entered = set(stops)
    if len(leaving) != count or len(entered) != count:
        return None
    mass = 0 if closed else (set(range(n)) - entered).pop()
    mass_order, spring_order = [mass], []
    while mass in leaving and len(mass_order) < n:
        s = leaving[mass]
        mass = stops[s]
        spring_order.append(s)
        mass_order.append(mass)
    if len(set(mass_order)) != n:
        return None  # a ring and something else
    if closed:
        spring_order.append(leaving[mass])
    index = np.empty(count, np.int64)
    index[spring_order] = np.arange(count)
    if (index[joints[1]] != (index[joints[0]] + 1) % n).any():
        return None
    return np.array(mass_order, np.int64), np.array(spring_order, np.int64)


def _hinged_first(spring_ends: Indices, joints: Indices, slots: int) -> Indices:
    """Return the indices of the springs in runs, those attached to angular springs first."""
    alone = np.ones(spring_ends.shape[1], np.bool_)
    alone[joints] = False
    return order_in_runs(spring_ends[0], spring_ends[1], slots, alone)


def with_numbers(
    wiring: Topology, of_springs: Sequence[Floats], of_joints: Sequence[Floats], law: int, softening: float
) -> Body:
    """Return the table of a body on which only its springs and joints act.

    Args:
        wiring: the connections of the masses.
        of_springs: (3, S) stiffness, damping and rest length, in the scene's order, as in `Body`.
        of_joints: (3, J) stiffness, damping and rest angle, in the same order.
        law, softening: as in `Body`.
    """
    order, ring, room = wiring.spring_order, wiring.ring, wiring.room
    count = order.size
    held = wiring.body.joints  # more than the scene's in a chain where some adjacent springs have no joint
    torques = max(room, held + (0 if wiring.in_order else _BEHIND_RUNS)) + 1
    stiffness, damping, rest, angular_stiffness, softenings = aligned_arena(
        [(room, 1)] * 3 + [(torques, 1), (room, 1)], page_offset=1536
    )
    for field, values in zip((stiffness, damping, rest), of_springs, strict=True):
        field[:count] = values[order]
    # The loop around a ring visits its first spring twice.
    softenings[:], softenings[: count + ring] = _ENDLESS, max(softening, MIN_SQUARE)
    torque_damping, rest_angle = np.zeros(torques), np.zeros(held)
    if held:
        at = wiring.joint_order + 1
        angular_stiffness[at], torque_damping[at], rest_angle[wiring.joint_order] = of_joints
        if ring:
            angular_stiffness[0] = angular_stiffness[held]
    return wiring.body.replaced(
        damped=np.count_nonzero(damping) > 0,  # a tenth of the time of `any`
        joint_damped=np.count_nonzero(torque_damping) > 0,
        law=law if held else NO_JOINTS,
        softening=softening,
        softenings=softenings,
        stiffness=stiffness,
        damping=damping,
        rest_length=rest,
        joint_rest=rest_angle,
        angular_stiffness=angular_stiffness,
        torque_damping=torque_damping,
    )


def _softening(scene: Scene, lengths: Floats, at: Floats, joined: tuple[Indices, Indices]) -> float:
    """Return `Body.softening`, px²: practically none for fixed-step methods.

    Args:
        scene: the scene.
        lengths: rest lengths of its springs, px.
        at: (n, 2) positions of its masses, px.
        joined: the masses at the ends of each spring.
    """
    if not METHODS[scene.integrator.method].adaptive:
        return SHORTEST_SQUARED
    if not lengths.any():
        lengths = np.hypot(*(at[joined[1]] - at[joined[0]]).T)
    lengths = lengths[lengths > 0.0]
    typical = float(np.median(lengths)) if lengths.size else 1.0
    soft = min(_SOFT_IN_TOLERANCES * scene.integrator.tolerance, _SOFT_AT_MOST * typical)
    return max(soft * soft, SHORTEST_SQUARED)
