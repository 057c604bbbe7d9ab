"""The state of a body: its memory, and what scenes and moments store of it.

Grips of friction are stored as stretches only: the position of a mass along a wall or a spring follows from
its coordinates; see `sim.forces.touch.friction_history`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple, TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..engine.layout import Layout, aligned_arena
from ..engine.table import Table
from ..engine.tables import CONTROL_SCALE, CONTROL_SHIFT, Body, Floats, Indices, Scratch, State, padded
from ..forces.muscles import waves
from ..forces.plasticity import without_broken
from ..forces.rails import along_rails
from ..forces.touch.batch import room_for_batches
from ..forces.touch.contact import places
from ..forces.touch.friction_history import room_in_scratch, room_in_state
from ..forces.touch.walls import NOWHERE, place_along
from ..near import nearest_points
from ..scene.types import Damage, Grips, Scene
from .system import System

Bools = NDArray[np.bool_]
"""An array of flags."""
_Made = TypeVar("_Made", bound=Table)


# ------------------------------------------------------------------------- memory
def _vectors(table: type[Table]) -> list[str]:
    """Return the fields of a table that are vectors of floats."""
    return [name for name, field in table.fields.items() if field.dimensions == 1 and field.dtype == float]


_STATE_VECTORS, _SCRATCH_VECTORS = _vectors(State), _vectors(Scratch)


def new_state(system: System) -> State:
    """Allocate a state for the system's masses; `Simulation` fills it."""
    body = system.body
    springs, joints = (body.springs, body.joints) if body.limits.present else (0, 0)
    drag = system.slots if body.environment.air.brakes else 0
    layout = _layout_of_state(
        system.slots, body.stiffness.size, body.angular_stiffness.size, springs, joints, drag
    )
    state = layout.made()
    state.controls[0] = 1.0
    return state.replaced(**room_in_state(body, state.slots)) if body.environment.sticks else state


@lru_cache(maxsize=16)
def _layout_of_state(
    slots: int, room: int, torques: int, springs: int, joints: int, drag: int
) -> Layout[State]:
    """Return the layout for padded arrays of springs and joints, and of `State.drag`; `springs` and `joints`
    may yield."""
    sizes = {
        "q": (2 * slots, 1),
        "v": (2 * slots, 1),
        "controls": (2, 0),
        "rest_tension": (room, 1),
        "torque_cos": (torques, 1),
        "torque_sin": (torques, 1),
        "torque_rest": (torques, 0),
        "clock": (1, 0),
        "steer": (5, 0),
        "set_length": (springs, 0),
        "set_angle": (joints, 0),
        "hardened": (springs, 0),
        "trial_tension": (springs, 0),
        "trial_angle": (joints, 0),
        "broken": (springs, 0),
        "yields": (springs + joints + 1 if springs else 0, 0),
        "drag": (drag, 1),
    }
    return _layout(State, {field: sizes.get(field, (slots, 1)) for field in _STATE_VECTORS}, page_offset=0)


def _layout(
    kind: type[_Made],
    sizes: Mapping[str, tuple[int, int]],
    page_offset: int,
    rows: Mapping[str, int] | None = None,
) -> Layout[_Made]:
    """Return the layout of a table that has only arrays, some of them empty.

    Args:
        kind: the table's class.
        sizes, page_offset: by field, and as in `aligned_arena`.
        rows: by field, the number of rows of each two-dimensional array.
    """
    arrays = aligned_arena(list(sizes.values()), page_offset)
    fields = dict(zip(sizes, arrays, strict=True))
    fields |= {field: fields[field].reshape(count, -1) for field, count in (rows or {}).items()}
    return Layout(kind.empty().replaced(**fields), arrays, page_offset)


def rest_lengths(body: Body, state: State) -> Floats:
    """Return the (S,) current rest length of each spring of the tables, px.

    This includes the scale of rest lengths, muscles at `State.clock`, and yielding.
    """
    rest = body.rest_length[: body.springs] * state.controls[CONTROL_SCALE]
    if body.muscles.present:
        rest[body.muscles.spring] *= 1.0 + waves(body.muscles.stretch, state.steer, float(state.clock[0]))
    return rest + state.set_length if body.limits.present else rest


def rest_angles(body: Body, state: State) -> Floats:
    """Return the (J,) current rest angle of each joint, degrees in (-180, 180], in the same way."""
    angle = body.joint_rest + state.controls[CONTROL_SHIFT]
    if body.limits.present:
        angle = angle + state.set_angle
    if body.muscles.present:
        angle[body.muscles.joint] += waves(body.muscles.turn, state.steer, float(state.clock[0]))
    return 180.0 - (180.0 - angle) % 360.0


def update_rest_state(body: Body, state: State) -> None:
    """Update what depends on the scale of rest lengths, the shift of rest angles, and the clock."""
    springs, joints = slice(body.springs), slice(1, body.joints + 1)
    state.rest_tension[springs] = body.stiffness[springs] * rest_lengths(body, state)
    if not body.joints:
        if body.limits.present:
            state.trial_tension[:] = state.rest_tension[springs]
        return
    rest = np.radians(rest_angles(body, state))
    state.torque_rest[joints] = rest
    state.torque_cos[joints] = body.joint_stiffness * np.cos(rest)
    state.torque_sin[joints] = body.joint_stiffness * np.sin(rest)
    if body.limits.present:
        state.trial_tension[:], state.trial_angle[:] = state.rest_tension[springs], rest
    if body.ring:
        state.torque_cos[0] = state.torque_cos[body.joints]
        state.torque_sin[0] = state.torque_sin[body.joints]


def new_scratch(system: System) -> Scratch:
    """Allocate scratch arrays for the system."""
    body = system.body
    # After the masses, including slot 0, and after springs in runs there may be some more.
    room = max(padded(body.masses + 1), body.stiffness.size) + 8
    links = body.held, body.free, body.bends
    scratch = _layout_of_scratch(room, body.joints + 1, *(each.room for each in links)).made()
    if body.environment.contact.present:
        scratch = scratch.replaced(**room_for_batches(body), **room_in_scratch(body))
    return scratch


@lru_cache(maxsize=16)
def _layout_of_scratch(room: int, joints: int, held: int, free: int, bends: int) -> Layout[Scratch]:
    """Return the layout for padded vectors, for joints in no run, and for rows."""
    first = {"tx": 2, "ty": 2, "fx": 1, "fy": 1}  # where loops over springs and masses start
    sizes = {field: (room, first.get(field, 0)) for field in _SCRATCH_VECTORS}
    rows = {"held_rows": 2, "free_rows": 2, "joint_rows": 4, "joint_alone": 4}
    for (field, count), wide in zip(rows.items(), (held, free, bends, joints), strict=True):
        sizes[field] = count * wide, 0
    # An offset after that of the arrays of a short chain's `State`.
    return _layout(Scratch, sizes, page_offset=2560, rows=rows)


# ------------------------------------------------------------------------- from and to poses
def start_of(scene: Scene, system: System) -> tuple[System, State]:
    """Return the tables without the parts that are broken at a scene's start, and the initial state.

    Args:
        scene: a valid scene.
        system: its tables.
    """
    state = new_state(system)
    pose, masses = scene.pose, slice(1, system.body.masses + 1)
    carried = Carried(system.start, pose and pose.damage, pose and pose.grips)
    controls = scene.rest_length_scale, 0.0
    return fill_in(state, system, scene, carried, masses, controls, 0.0, system.held), state


def whole_without_broken(system: System, state: State) -> System:
    """Return the tables without the springs that are broken in a state."""
    if not state.broken.any():
        return system
    return replace(system, body=without_broken(system.body, state.broken))


def rows_of(state: State, system: System) -> Floats:
    """Return (4, n) x, y (px), vx and vy (px/s) of the scene's masses; a copy."""
    rows = np.empty((4, system.mass_index.size))
    # The mode has no effect for valid indices; with it, numpy writes directly.
    for row, field in zip(rows, (state.x, state.y, state.vx, state.vy), strict=True):
        field.take(system.mass_index, out=row, mode="clip")
    return rows


class Carried(NamedTuple):
    """A motion to be transferred from one state to another.

    Attributes:
        rows: (4, n) x, y (px), vx and vy (px/s) of the masses.
        damage: everything that has yielded or broken, or None.
        grips: the tangential springs of sticking friction, or None.
        steer: of the state; empty where no key was held.
    """

    rows: Floats
    damage: Damage | None
    grips: Grips | None
    steer: tuple[float, ...] = ()


def carried_by(state: State, system: System) -> Carried:
    """Return the motion in a state; its rows are copies, in the scene's order."""
    return Carried(rows_of(state, system), damage_in(state, system), grips_of(state, system), steer_in(state))


def steer_in(state: State) -> tuple[float, ...]:
    """Return `State.steer`: what keys do to motors, muscles and forces; empty where none was held."""
    return tuple(state.steer.tolist()) if state.steer.any() else ()


def fill_in(
    state: State,
    system: System,
    scene: Scene,
    carried: Carried,
    slots: slice | Indices,
    controls: tuple[float, float],
    time: float,
    held: Bools,
) -> System:
    """Set an entire state.

    Args:
        state: of the tables.
        system: the tables, including broken parts.
        scene: the scene.
        carried: the motion.
        slots: of the masses in its rows.
        controls: rest length scale, and degrees added to all rest angles.
        time: s.
        held: (n,) whether each mass is held, in slot order.

    Returns:
        The tables without broken parts.
    """
    put_rows(state, carried.rows, slots)
    put_masses(state, system, scene, held)
    state.controls[:] = controls
    state.clock[0] = time
    state.steer[:] = carried.steer or 0.0
    if system.body.limits.present:
        put_damage(state, system, carried.damage)
        system = whole_without_broken(system, state)
    update_rest_state(system.body, state)
    put_grips(state, system, carried.grips)
    return system


def put_rows(state: State, rows: Floats, slots: slice | Indices) -> None:
    """Set the motion of the masses in `slots` from rows like those of `rows_of`, and clear the padding."""
    for vector, of_masses in ((state.q, rows[:2]), (state.v, rows[2:])):
        vector.fill(0.0)
        vector.reshape(2, -1)[:, slots] = of_masses


def put_masses(state: State, system: System, scene: Scene, held: Bools) -> None:
    """Set inverse masses, air friction, gravity and constant forces in a state: zero for held masses.

    Args:
        state: of the tables.
        system: the tables.
        scene: the scene.
        held: (n,) whether each mass is held, in slot order.
    """
    masses, free = slice(1, system.body.masses + 1), np.where(held, 0.0, 1.0)
    inverse_mass = free * system.inverse_mass
    state.v.reshape(2, -1)[:, masses] *= free
    state.inverse_mass[masses] = inverse_mass
    if system.body.environment.rails.slot.size:
        moving = along_rails(system.body, state.vx + 1j * state.vy)
        state.vx[:], state.vy[:] = moving.real, moving.imag
    # The state is used for this scene only, so zeros in it have been zero from the start.
    if scene.air_friction and not scene.wind:  # the friction of wind is in the surroundings
        drag_of(state)[masses] = inverse_mass * scene.air_friction
    for k, (array, gravity) in enumerate(((state.gx, scene.gravity[0]), (state.gy, scene.gravity[1]))):
        if system.loads is not None:
            array[masses] = free * gravity + inverse_mass * system.loads[k]
        elif gravity:
            array[masses] = free * gravity


def drag_of(state: State) -> Floats:
    """Return the friction of still air in a state / mass, under the law that it has."""
    return state.drag if state.drag.size else state.air


def damage_in(state: State, system: System) -> Damage | None:
    """Return everything that has yielded or broken in a state; None if nothing has."""
    if not (state.set_length.any() or state.set_angle.any() or state.broken.any()):
        return None
    index = np.argsort(system.spring_order)  # of each spring of the scene, in the tables
    return Damage(
        broken=tuple(np.flatnonzero(state.broken[index]).tolist()),
        set_lengths=tuple(state.set_length[index].tolist()),
        hardened=tuple(state.hardened[index].tolist()),
        set_angles=tuple(state.set_angle[system.joint_order].tolist()),
    )


def put_damage(state: State, system: System, damage: Damage | None) -> None:
    """Set the damage in a state; None for none.

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


def grips_of(state: State, system: System) -> Grips | None:
    """Return the stretches of all tangential springs in a state; None if there are none.

    Args:
        state: of the tables.
        system: the tables.
    """
    if not system.body.environment.sticks:
        return None
    walls: list[tuple[int, int, float]] = []
    springs: list[tuple[int, int, float]] = []
    wall, slot = np.nonzero(state.wall_place < NOWHERE)
    if wall.size:
        masses = system.mass_order[slot - 1]
        walls = _rows(wall, masses, state.wall_stretch[wall, slot])
    if state.contact_start.size and (count := int(state.contact_start[-1])):
        s = np.repeat(np.arange(system.body.springs), np.diff(state.contact_start))
        masses = system.mass_order[state.contact_mass[:count] - 1]
        springs = _rows(system.spring_order[s], masses, state.contact_stretch[:count, 0])
    if not (walls or springs):
        return None
    wall, slot = np.nonzero(state.wall_slides)
    sliding = list(zip(wall.tolist(), system.mass_order[slot - 1].tolist(), strict=True))
    return Grips(walls=tuple(walls), springs=tuple(springs), sliding=tuple(sliding) or msgspec.UNSET)


def _rows(*columns: np.ndarray) -> list[tuple[int, int, float]]:
    return list(zip(*(column.tolist() for column in columns), strict=True))


def put_grips(state: State, system: System, grips: Grips | None) -> None:
    """Set the stretches of tangential springs at the positions of a state; all others start anew.

    Args:
        state: the positions.
        system: its tables.
        grips: the stretches; those on walls and contacts that the tables lack are ignored.
    """
    if not system.body.environment.sticks:
        return
    state.wall_stretch[:], state.wall_place[:], state.contact_start[:] = 0.0, NOWHERE, 0
    state.wall_slides[:] = 0.0
    state.wall_time[:] = state.clock
    if grips is not None:
        _put_on_walls(state, system, grips)
        _put_in_contact(state, system, grips)


def _put_on_walls(state: State, system: System, grips: Grips) -> None:
    rows, index = system.body.environment.walls.rows, system.mass_index
    for k, mass, stretch in grips.walls:
        if k < len(state.wall_place) and mass < index.size:
            slot = index[mass]
            state.wall_stretch[k, slot] = stretch
            state.wall_place[k, slot] = place_along(rows[k], state.x[slot], state.y[slot])
    for k, mass in grips.sliding or ():
        if k < len(state.wall_slides) and mass < index.size:
            state.wall_slides[k, index[mass]] = 1.0


def _put_in_contact(state: State, system: System, grips: Grips) -> None:
    body, index = system.body, np.argsort(system.spring_order)
    rows = [row for row in grips.springs if row[0] < index.size and row[1] < system.mass_index.size]
    rows = rows[: state.contact_mass.size]
    if not rows:
        return
    spring, mass, stretch = (np.array(column) for column in zip(*rows, strict=True))
    s, m = index[spring], system.mass_index[mass]
    order = np.lexsort((m, s))
    s, m, stretch = s[order], m[order], stretch[order]
    x, a, b = state.x + 1j * state.y, body.spring_a[s], body.spring_b[s]
    t = nearest_points(x[m], x[a], x[b])
    state.contact_start[:] = np.searchsorted(s, np.arange(body.springs + 1))
    state.contact_mass[: s.size] = m
    state.contact_stretch[: s.size] = np.column_stack((stretch, *places(x, m, a, b, t)))
