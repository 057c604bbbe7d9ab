"""Forces that keys work: each acts on a mass while a key is held, and the opposite one while the other is.

The force is F times `State.steer` of its keys, and its power is that times the velocity. It depends on
neither position nor velocity, so it has no derivatives.
"""

from __future__ import annotations

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.table import Indices, Rows, Table
from ..engine.tables import Body, State
from ..scene.types import Scene, is_pushed
from .muscles import steer_of
from .term import Places, Term, Vectors, summed


class Pushes(Table):
    """Read-only. P forces."""

    mass: Indices  # (P,) slots
    rows: Rows  # (P, 2) x and y, kg px/s²
    steer: Indices  # (P,) index in `State.steer`


NO_PUSHES = Pushes.empty().replaced(rows=np.zeros((0, 2))).read_only()


def new_pushes(scene: Scene, places: Places) -> Pushes:
    """The table of a valid scene."""
    if not is_pushed(scene):
        return NO_PUSHES
    pushed = [(i, mass) for i, mass in enumerate(scene.masses) if mass.keys]
    return Pushes(
        mass=places.mass_index[[i for i, _ in pushed]],
        rows=np.array([mass.force for _, mass in pushed], float),
        steer=np.array([steer_of(mass.keys) for _, mass in pushed]),
    )


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    pushes = body.environment.pushes
    for k in range(pushes.mass.size):
        m, way = pushes.mass[k], state.steer[pushes.steer[k]]
        scratch.fx[m] += way * pushes.rows[k, 0]
        scratch.fy[m] += way * pushes.rows[k, 1]


@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    pushes, slots = body.environment.pushes, q.size // 2
    for k in range(pushes.mass.size):
        m, way = pushes.mass[k], state.steer[pushes.steer[k]]
        power = pushes.rows[k, 0] * v[m] + pushes.rows[k, 1] * v[slots + m]
        balance.work.keys += part * way * power


class PushesReference:
    """Forces that keys work in NumPy; see `Reference`."""

    def __init__(self, body: Body, state: State) -> None:
        self._pushes, self._state = body.environment.pushes, state

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        pushes = self._pushes
        force = pushes.rows[:, 0] + 1j * pushes.rows[:, 1]
        return summed(pushes.mass, self._state.steer[pushes.steer] * force, x.size)

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return 0.0


PUSHES = Term(
    "pushes",
    is_pushed,
    PushesReference,
    _add_forces,
    field="pushes",
    table=Pushes,
    new=new_pushes,
    label="forces that keys work",
    add_power=_add_power,
)
