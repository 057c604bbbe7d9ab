"""Builds the tables of the kernels from a scene."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import msgspec
import numpy as np

from ..forces.environment import new_environment
from ..forces.joints import LAWS, NO_JOINTS
from ..forces.limits import Limits, new_limits, without_broken
from ..forces.muscles import new_muscles, waves
from ..forces.nets import NO_NET, new_net, order_in_runs
from ..forces.term import read_only
from ..kernels.core.roots import LEAST
from ..kernels.core.tables import (
    CONTROL_SCALE,
    CONTROL_SHIFT,
    SHORTEST_SQUARED,
    Body,
    Floats,
    Indices,
    Scratch,
    State,
    padded,
)
from ..methods.registry import METHODS
from ..scene.columns import column, ends
from ..scene.types import Damage, Integrator, Scene, is_damageable, is_loaded, is_surrounded

_SOFT_IN_TOLERANCES = 0.02
"""Softening length of springs under an adaptive method, in tolerances; see `Body.softening`."""
_SOFT_AT_MOST = 1e-4
"""The largest softening length, as a fraction of a typical spring's length."""

_ENDLESS = 1e30
"""Softening of padding springs, px²: makes them longer than any spring, and fits into single precision."""

_VECTORS = [name for name, field in Scratch.fields.items() if field.dimensions == 1]
"""The fields of `Scratch` that are vectors."""


@dataclass(frozen=True)
class System:
    """The kernels' tables for one scene.

    Attributes:
        body: the tables; masses and springs are numbered as the kernels visit them.
        mass_order: (n,) scene index of the mass in slot 1, 2, ..., n.
        mass_index: (n,) the slot, counted from 1, of each mass of the scene.
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
        damaged: whether something has yielded or broken that is to be kept though nothing can any more; what
            the scene's pose says is kept anyway.

    A chain is a body whose springs run head to tail through all masses, and whose angular springs each
    hold a spring and the next one; its masses and springs may be listed in any order. A ring is a closed
    chain. A body in surroundings is neither, nor is one that yields or breaks.
    """
    n = len(scene.masses)
    damageable = damaged or is_damageable(scene) or damage_of(scene) is not None
    order = None if damageable or is_surrounded(scene) else _order_along(scene)
    mass_order, spring_order = order or (np.arange(n), _hinged_first(scene))
    mass_index = np.empty(n, np.int64)
    mass_index[mass_order] = np.arange(1, n + 1)
    body, joint_order = _body(scene, mass_index, spring_order, order is not None, damageable)
    held = np.zeros(n, np.bool_)
    held[mass_index[[anchor.mass for anchor in scene.anchors]] - 1] = True
    if scene.pose is not None:
        positions, velocities = scene.pose.positions, scene.pose.velocities
    else:
        positions = tuple(m.position for m in scene.masses)
        velocities = tuple(m.velocity for m in scene.masses)
    start = np.array([*np.array(positions, float).T, *np.array(velocities, float).T])[:, mass_order]
    start[2:, held] = 0.0
    return System(
        body=body,
        mass_order=mass_order,
        mass_index=mass_index,
        spring_order=spring_order,
        joint_order=joint_order,
        inverse_mass=1.0 / column(scene.masses, "mass")[mass_order],
        held=held,
        start=np.ascontiguousarray(start),
        loads=_loads(scene, mass_order),
    )


def for_analysis(scene: Scene) -> Scene:
    """The scene as analyses take it: its muscles rest, and nothing softens by its method.

    See `build_system` for what would.
    """
    # One with a fixed step, for which springs do not, and an implicit one, for which walls do not.
    method = Integrator(method="generalized_alpha")
    return msgspec.structs.replace(scene, integrator=method, beat=msgspec.UNSET)


def damage_of(scene: Scene) -> Damage | None:
    """What has yielded and broken in the scene's pose; None where nothing has."""
    return scene.pose.damage if scene.pose is not None else None


def put_damage(state: State, system: System, damage: Damage | None) -> None:
    """Enter what has yielded and broken into a state; None for nothing.

    Args:
        state: of the tables, which are those of a body that yields, breaks or has done so.
        system: the tables.
        damage: of the scene.
    """
    order, joints = system.spring_order, system.joint_order
    for array in (state.set_length, state.hardened, state.set_angle, state.broken):
        array[:] = 0.0
    if damage is None:
        return
    state.broken[:] = np.isin(order, damage.broken)
    if damage.set_lengths:
        state.set_length[:] = np.array(damage.set_lengths)[order]
    if damage.hardened:
        state.hardened[:] = np.array(damage.hardened)[order]
    if damage.set_angles:
        state.set_angle[joints] = damage.set_angles


def start_of(scene: Scene, system: System) -> tuple[System, State]:
    """The tables without what is broken at a scene's start, and the state there.

    Args:
        scene: a valid scene.
        system: its tables.
    """
    state = new_state(system)
    if (damage := damage_of(scene)) is not None:
        put_damage(state, system, damage)
        system = replace(system, body=without_broken(system.body, state.broken))
    state.controls[0] = scene.rest_length_scale
    refresh(system.body, state)
    here = slice(1, system.body.masses + 1)
    for field, row in zip((state.x, state.y, state.vx, state.vy), system.start, strict=True):
        field[here] = row
    state.inverse_mass[here] = np.where(system.held, 0.0, system.inverse_mass)
    return system, state


def _loads(scene: Scene, mass_order: Indices) -> Floats | None:
    if not is_loaded(scene):
        return None
    return np.array([mass.force or (0.0, 0.0) for mass in scene.masses], float).T[:, mass_order]


def same_topology(old: Scene, new: Scene) -> bool:
    """Whether springs and angular springs connect the same masses in both, so that a state carries over."""
    return (
        len(old.masses) == len(new.masses)
        and [(s.a, s.b) for s in old.linear_springs] == [(s.a, s.b) for s in new.linear_springs]
        and [(j.a, j.b) for j in old.angular_springs] == [(j.a, j.b) for j in new.angular_springs]
    )


def joint_stiffness(scene: Scene) -> list[float]:
    """The stiffness of each angular spring, kg/s²; diagonal templates are sqrt(2) times as stiff."""
    return _joint_stiffness(scene).tolist()


def _joint_stiffness(scene: Scene) -> Floats:
    factor = math.sqrt(2.0) if scene.template is not None and scene.template % 90 else 1.0
    return column(scene.angular_springs, "stiffness") * factor


def slab(sizes: list[tuple[int, int]], page_offset: int) -> list[Floats]:
    """Zeroed arrays, one after another in one block of memory.

    Each is given as (count, first): its length, and the index of the element to align to 64 bytes because
    loops start there.

    The speed of a short chain depends on how its arrays are aligned: a vector that crosses a cache line is
    slower to load, and a load waits for a store whose address differs by a multiple of 4096 bytes. Left to
    chance, run times differ by a fifth. The block starts `page_offset` bytes after such a multiple.
    """
    strides = [-(-(first % 8 + count + 8) // 8) * 8 for count, first in sizes]
    block = np.zeros(sum(strides) + 512)
    start = (page_offset - block.ctypes.data) % 4096 // 8
    arrays = []
    for (count, first), stride in zip(sizes, strides, strict=True):
        begin = start + (-first) % 8
        arrays.append(block[begin : begin + count])
        start += stride
    return arrays


def slots_of(body: Body) -> int:
    """The number of slots of a body's states."""
    return _slots_for(body.masses, body.stiffness.size if body.chain or body.ring else 0)


def _slots_for(masses: int, chained: int) -> int:
    """The number of slots, with room for so many springs of a chain or a ring."""
    # The chain's loops look one slot back and, from the last spring, three ahead; and loops over flat
    # vectors should leave no scalar remainder.
    return padded((chained or padded(masses)) + 3)  # aligns both halves of a flat vector alike


def new_state(system: System) -> State:
    """A state with room for the system's masses; `Simulation` fills it."""
    body = system.body
    slots = slots_of(body)
    joints = body.torque_size.size
    damageable = body.limits.present
    sizes = {
        "q": (2 * slots, 1),
        "v": (2 * slots, 1),
        "controls": (2, 0),
        "rest_tension": (body.stiffness.size, 1),
        "torque_cos": (joints, 1),
        "torque_sin": (joints, 1),
        "torque_rest": (joints, 0),
        "clock": (1, 0),
        "set_length": (body.springs if damageable else 0, 0),
        "set_angle": (body.joints if damageable else 0, 0),
        "hardened": (body.springs if damageable else 0, 0),
        "broken": (body.springs if damageable else 0, 0),
    }
    arrays = slab([sizes.get(field, (slots, 1)) for field in State.fields], page_offset=0)
    state = State(**dict(zip(State.fields, arrays, strict=True)))
    state.controls[0] = 1.0
    return state


def rest_lengths(body: Body, state: State) -> Floats:
    """(S,) the present rest length of each spring of the tables, px.

    In it are the scale of rest lengths, what muscles do at `State.clock`, and what has yielded.
    """
    rest = body.rest_length[: body.springs] * state.controls[CONTROL_SCALE]
    if body.muscles.present:
        rest[body.muscles.spring] *= 1.0 + waves(body.muscles.stretch, float(state.clock[0]))
    return rest + state.set_length if body.limits.present else rest


def rest_angles(body: Body, state: State) -> Floats:
    """(J,) the present rest angle of each joint of the tables, degrees in (-180, 180], likewise."""
    angle = body.joint_rest + state.controls[CONTROL_SHIFT]
    if body.limits.present:
        angle = angle + state.set_angle
    if body.muscles.present:
        angle[body.muscles.joint] += waves(body.muscles.turn, float(state.clock[0]))
    return 180.0 - (180.0 - angle) % 360.0


def refresh(body: Body, state: State) -> None:
    """Recompute what depends on the scale of rest lengths, the shift of rest angles, and the clock."""
    springs, joints = slice(body.springs), slice(1, body.joints + 1)
    state.rest_tension[springs] = body.stiffness[springs] * rest_lengths(body, state)
    rest = np.radians(rest_angles(body, state))
    state.torque_rest[joints] = rest
    state.torque_cos[joints] = body.joint_stiffness * np.cos(rest)
    state.torque_sin[joints] = body.joint_stiffness * np.sin(rest)
    if body.ring and body.joints:
        state.torque_cos[0] = state.torque_cos[body.joints]
        state.torque_sin[0] = state.torque_sin[body.joints]


def new_scratch(system: System) -> Scratch:
    """Scratch arrays for the system."""
    room = max(system.body.stiffness.size, system.body.joints) + 3
    first = {"tx": 2, "ty": 2, "fx": 1, "fy": 1}  # where loops over springs and masses start
    # An offset behind that of the arrays of a short chain's `State`.
    arrays = slab([(room, first.get(field, 0)) for field in _VECTORS], page_offset=2560)
    net = system.body.net
    return Scratch(
        **dict(zip(_VECTORS, arrays, strict=True)),
        spring_rows=np.zeros((2, net.springs.room)),
        joint_rows=np.zeros((3, net.joints.room)),
        vectors=np.zeros((3, 2 * net.gap + room if net.present else 0)),
    )


def _order_along(scene: Scene) -> tuple[Indices, Indices] | None:
    """(masses, springs) in order along a chain or a ring, or None for any other body."""
    n, springs = len(scene.masses), scene.linear_springs
    closed = len(springs) == n
    if n < (3 if closed else 2) or not (closed or len(springs) == n - 1):
        return None
    leaving = {spring.a: s for s, spring in enumerate(springs)}
    entered = {spring.b for spring in springs}
    if len(leaving) != len(springs) or len(entered) != len(springs):
        return None
    mass = 0 if closed else (set(range(n)) - entered).pop()
    mass_order, spring_order = [mass], []
    while mass in leaving and len(mass_order) < n:
        s = leaving[mass]
        mass = springs[s].b
        spring_order.append(s)
        mass_order.append(mass)
    if len(set(mass_order)) != n:
        return None  # a ring beside something else
    if closed:
        spring_order.append(leaving[mass])
    index = {s: i for i, s in enumerate(spring_order)}
    if any(index[joint.b] != (index[joint.a] + 1) % n for joint in scene.angular_springs):
        return None
    return np.array(mass_order, np.int64), np.array(spring_order, np.int64)


def _hinged_first(scene: Scene) -> Indices:
    """Indices of the springs in runs, those that angular springs hold first."""
    alone = np.ones(len(scene.linear_springs), np.bool_)
    for end in ends(scene.angular_springs):
        alone[end] = False
    return order_in_runs(*ends(scene.linear_springs), alone)


def _body(
    scene: Scene, mass_index: Indices, spring_order: Indices, in_order: bool, damageable: bool
) -> tuple[Body, Indices]:
    n, springs, joints = len(scene.masses), scene.linear_springs, scene.angular_springs
    count, method = len(springs), METHODS[scene.integrator.method]
    ring = in_order and count == n
    # At least as many springs as masses, since the chain's loops over masses read as many, and one more.
    # For others, the loops over a run read a few more.
    more = 0 if in_order else 7
    room = padded(max(count, n)) + 1 + more
    torques = max(room, len(joints) + more) + 1
    stiffness, damping, rest, torque_size, softenings = slab(
        [(room, 1)] * 3 + [(torques, 1), (room, 1)], page_offset=1536
    )
    stiffness[:count] = column(springs, "stiffness")[spring_order]
    damping[:count] = column(springs, "damping")[spring_order]
    rest[:count] = column(springs, "rest_length")[spring_order]
    softening = _softening(scene)
    # The loop around a ring visits its first spring twice.
    softenings[:], softenings[: count + ring] = _ENDLESS, max(softening, LEAST)
    spring_a, spring_b = (mass_index[end[spring_order]] for end in ends(springs))
    spring_index = np.empty(count, np.int64)
    spring_index[spring_order] = np.arange(count)
    joint_a, joint_b = (spring_index[end] for end in ends(joints))
    strength = _joint_stiffness(scene)
    rest_angle, resistance = column(joints, "rest_angle"), column(joints, "damping")
    held = np.zeros(count, np.bool_)
    held[joint_a] = held[joint_b] = True
    hinged = int(held.sum())
    if in_order and joint_a.size:
        joint_order = joint_a
        of_chain = n if ring else n - 2
        by_index = np.zeros((3, of_chain))
        by_index[:, joint_a] = strength, rest_angle, resistance
        strength, rest_angle, resistance = by_index.copy()
        joint_a, joint_b = np.arange(of_chain), (np.arange(of_chain) + 1) % count
        hinged = count
    else:
        by_runs = order_in_runs(joint_a, joint_b)
        joint_order = np.argsort(by_runs)
        joint_a, joint_b = joint_a[by_runs], joint_b[by_runs]
        strength, rest_angle, resistance = strength[by_runs], rest_angle[by_runs], resistance[by_runs]
    joint_in, joint_out, more_joint, more_joint_spring, more_joint_sign = _slots(
        joint_b, joint_a, count, first=1, nothing=0
    )
    layers = _layers(spring_b, spring_a, n + 1)
    spring_in, spring_out, more_spring, more_spring_mass, more_spring_sign = _slots(
        spring_b, spring_a, n + 1, first=0, nothing=room, layers=layers
    )
    torque_damping = np.zeros(max(joint_a.size, room) + 1)
    torque_size[1 : joint_a.size + 1], torque_damping[1 : joint_a.size + 1] = strength, resistance
    if ring and joint_a.size:
        torque_size[0] = strength[-1]
    net = NO_NET
    if not in_order:
        net = new_net((spring_a - 1, spring_b - 1), n, (joint_a, joint_b), hinged)
    body = Body(
        masses=n,
        springs=count,
        joints=joint_a.size,
        damped=bool(damping.any()),
        joint_damped=bool(resistance.any()),
        chain=in_order and not ring,
        ring=ring,
        law=LAWS[scene.force_law].code if joint_a.size else NO_JOINTS,
        softening=softening,
        softenings=softenings,
        spring_a=spring_a,
        spring_b=spring_b,
        stiffness=stiffness,
        damping=damping,
        rest_length=rest,
        joint_a=joint_a,
        joint_b=joint_b,
        joint_rest=np.ascontiguousarray(rest_angle),
        torque_size=torque_size,
        torque_damping=torque_damping,
        hinged=hinged,
        joint_in=joint_in,
        joint_out=joint_out,
        more_joint=more_joint,
        more_joint_spring=more_joint_spring,
        more_joint_sign=more_joint_sign,
        layers=layers,
        spring_in=spring_in,
        spring_out=spring_out,
        more_spring=more_spring,
        more_spring_mass=more_spring_mass,
        more_spring_sign=more_spring_sign,
        net=net,
        limits=new_limits(scene, spring_order, joint_order) if damageable else Limits.empty(),
        muscles=new_muscles(scene, spring_order, joint_order),
        environment=new_environment(
            scene,
            mass_index,
            np.stack((spring_a, spring_b), 1),
            _slots_for(n, room if in_order else 0),
            step=0.0 if method.adaptive or method.implicit else scene.integrator.dt,
        ),
    )
    return read_only(body), joint_order


def _softening(scene: Scene) -> float:
    """`Body.softening`, px²: practically none for methods with a fixed step."""
    if not METHODS[scene.integrator.method].adaptive:
        return SHORTEST_SQUARED
    lengths = column(scene.linear_springs, "rest_length")
    if not lengths.any():
        at = np.array([mass.position for mass in scene.masses])
        a, b = ends(scene.linear_springs)
        lengths = np.hypot(*(at[b] - at[a]).T)
    lengths = lengths[lengths > 0.0]
    typical = float(np.median(lengths)) if lengths.size else 1.0
    soft = min(_SOFT_IN_TOLERANCES * scene.integrator.tolerance, _SOFT_AT_MOST * typical)
    return max(soft * soft, SHORTEST_SQUARED)


def _slots(
    plus: Indices, minus: Indices, owners: int, first: int, nothing: int, layers: int = 1
) -> tuple[Indices, Indices, Indices, Indices, Floats]:
    """Tables for summing, at each owner, the things that act on it, with sign plus or minus.

    Each layer has one slot of each sign for every owner; things that find no slot go into lists.

    Args:
        plus, minus: the owners that each thing acts on with that sign.
        owners: number of owners.
        first: number of the first thing.
        nothing: value of an empty slot.
        layers: number of layers.

    Returns:
        (layers owners,) the things in the slots of either sign, one layer after another; and for the things
        in the lists: number, owner and sign.
    """
    slots = np.full((2, layers, owners), nothing, np.int64)
    left: list[tuple[Indices, Indices, Floats]] = []
    for slot, owner_of, sign in ((slots[0], plus, 1.0), (slots[1], minus, -1.0)):
        layer = _places(owner_of, owners)
        found = layer < layers
        slot[layer[found], owner_of[found]] = first + np.flatnonzero(found)
        rest = np.flatnonzero(~found)
        left.append((first + rest, owner_of[rest], np.full(rest.size, sign)))
    thing, owner, signs = (np.concatenate(columns) for columns in zip(*left, strict=True))
    return slots[0].ravel(), slots[1].ravel(), thing, owner, signs


def _places(owner_of: Indices, owners: int) -> Indices:
    """How many things of the same owner come before each thing."""
    order = np.argsort(owner_of, kind="stable")
    starts = np.cumsum(np.bincount(owner_of, minlength=owners)) - np.bincount(owner_of, minlength=owners)
    places = np.empty(owner_of.size, np.int64)
    places[order] = np.arange(owner_of.size) - starts[owner_of[order]]
    return places


def _layers(plus: Indices, minus: Indices, owners: int) -> int:
    """The number of layers for `_slots`: all but the first have things for at least half of the owners.

    A layer is gathered in vectors, empty slots included; the lists are processed one by one.
    """
    counts = np.stack((np.bincount(plus, minlength=owners), np.bincount(minus, minlength=owners)))
    layers = 1
    while 2 * int((counts > layers).sum()) >= owners:
        layers += 1
    return layers
