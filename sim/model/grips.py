"""What tangential springs remember, as scenes and moments carry it: see `sim.forces.touch.friction_history`.

A scene has the stretches only. Where along a wall or a spring a mass is follows from its position.
"""

from __future__ import annotations

import numpy as np

from ..engine.tables import State
from ..forces.touch.contact import places
from ..forces.touch.friction_history import sticks
from ..forces.touch.walls import NOWHERE
from ..near import nearest_points
from ..scene.types import Grips
from .system import System


def grips_of(state: State, system: System) -> Grips | None:
    """The stretches of all tangential springs in a state; None where there are none.

    Args:
        state: of the tables.
        system: the tables.
    """
    if not sticks(system.body):
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
    return Grips(walls=tuple(walls), springs=tuple(springs)) if walls or springs else None


def _rows(*columns: np.ndarray) -> list[tuple[int, int, float]]:
    return list(zip(*(column.tolist() for column in columns), strict=True))


def put_grips(state: State, system: System, grips: Grips | None) -> None:
    """Let tangential springs have stretches at the positions of a state; all others begin anew.

    Args:
        state: the positions.
        system: its tables.
        grips: the stretches; those on walls and in contact that the tables do not have are left out.
    """
    if not sticks(system.body):
        return
    state.wall_stretch[:], state.wall_place[:], state.contact_start[:] = 0.0, NOWHERE, 0
    if grips is not None:
        _put_on_walls(state, system, grips)
        _put_in_contact(state, system, grips)


def _put_on_walls(state: State, system: System, grips: Grips) -> None:
    rows, index = system.body.environment.walls.rows, system.mass_index
    for k, mass, stretch in grips.walls:
        if k < len(state.wall_place) and mass < index.size:
            slot = index[mass]
            _, _, nx, ny, *_ = rows[k]
            state.wall_stretch[k, slot] = stretch
            state.wall_place[k, slot] = state.y[slot] * nx - state.x[slot] * ny


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
