"""Rails: lines along which masses move.

A mass on a rail of the unit direction u takes no part of any force across it: its acceleration is u (u . a),
where a would be that without the rail. In the matrix of an implicit step, rows of the derivatives are
projected in the same way, which leaves across the rail what they have on the diagonal, at least 1/s²: the
solution has no part there. A rail takes no energy.

A held mass on a rail is led along it only.
"""

from __future__ import annotations

import math

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.table import Indices, Rows, Table
from ..engine.tables import Body, State
from ..scene.columns import is_set_in_any
from ..scene.types import Scene
from .term import Places, Term, Vectors


class Rails(Table):
    """Read-only. R masses on rails."""

    slot: Indices  # (R,) slots of the masses
    way: Rows  # (R, 2) unit vectors
    number: Indices  # (slots,) the rail of each mass, -1 without one; empty where there are none


NO_RAILS = Rails.empty().replaced(way=np.zeros((0, 2))).read_only()


def has_rails(scene: Scene) -> bool:
    """Whether any mass of a valid scene is on a rail."""
    return is_set_in_any(scene.masses, "rail")


def new_rails(scene: Scene, places: Places) -> Rails:
    """The table of a valid scene."""
    if not has_rails(scene):
        return NO_RAILS
    on = [(int(places.mass_index[i]), mass.rail) for i, mass in enumerate(scene.masses) if mass.rail]
    number = np.full(places.slots, -1)
    number[[slot for slot, _ in on]] = np.arange(len(on))
    way = np.array([(x / math.hypot(x, y), y / math.hypot(x, y)) for _, (x, y) in on])
    return Rails(slot=np.array([slot for slot, _ in on]), way=way, number=number)


@kernel(forceinline=True, fastmath=FAST)
def keep_on_rails(body, flat):
    """Take what is across the rails out of a flat vector, x of every slot, then y."""
    rails, slots = body.environment.rails, flat.size // 2
    for k in range(rails.slot.size):
        m, x, y = rails.slot[k], rails.way[k, 0], rails.way[k, 1]
        along = x * flat[m] + y * flat[slots + m]
        flat[m], flat[slots + m] = x * along, y * along


@kernel(forceinline=True, fastmath=FAST)
def keep_row_on_rail(body, blocks, m, first, behind, diagonal, a, drag_x, drag_y):
    """Project the row of mass m in the matrix of an implicit step, if it is on a rail; return whether it is.

    Args:
        body, m: the mass.
        blocks: four numbers for each block, row by row.
        first, behind, diagonal: the first block of its row, one past the last, and that on the diagonal.
        a: what is on the diagonal of the matrix besides derivatives, 1/s².
        drag_x, drag_y: minus derivatives of the friction of still air under the tutorial's law, 1/s², which
            are added.
    """
    rails, d = body.environment.rails, 4 * diagonal
    if rails.slot.size == 0 or rails.number[m] < 0:
        return False
    x, y = rails.way[rails.number[m], 0], rails.way[rails.number[m], 1]
    blocks[d] += drag_x
    blocks[d + 3] += drag_y
    for p in range(first, behind):
        for column in range(2):
            e = 4 * p + column
            along = x * blocks[e] + y * blocks[e + 2]
            blocks[e], blocks[e + 2] = x * along, y * along
    across = max(1.0 - a, 0.0)
    blocks[d] += a + across * y * y
    blocks[d + 1] -= across * x * y
    blocks[d + 2] -= across * x * y
    blocks[d + 3] += a + across * x * x
    return True


def along_rails(body: Body, vectors: Vectors) -> Vectors:
    """`keep_on_rails` of vectors in NumPy."""
    rails = body.environment.rails
    if not rails.slot.size:
        return vectors
    kept, way = vectors.copy(), rails.way[:, 0] + 1j * rails.way[:, 1]
    kept[rails.slot] = way * (way.conjugate() * vectors[rails.slot]).real
    return kept


def ways_of(body: Body) -> dict[int, tuple[float, float]]:
    """The direction of each rail, by the slot of its mass."""
    rails = body.environment.rails
    return {slot: (x, y) for slot, (x, y) in zip(rails.slot.tolist(), rails.way.tolist(), strict=True)}


class RailsReference:
    """A rail in NumPy exerts what keeps a mass on it; see `along_rails`, and `Reference`."""

    def __init__(self, body: Body, state: State) -> None:
        pass

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`; those of rails are left out."""
        return np.zeros_like(x)

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return 0.0


RAILS = Term(
    "rails", has_rails, RailsReference, field="rails", table=Rails, new=new_rails, label="masses on rails"
)
