"""What a page about a force gives to the list in `all`: springs and joints like all others.

All kernels get the tables `body` and `state`, and flat positions q (px) and velocities v (px/s): x of every
slot, then y of every slot. They are called through their addresses, for bodies that have the term: each is
compiled by itself, when a body first needs it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np
from numba import types
from numpy.typing import NDArray

from ..engine.calls import FLOATS
from ..engine.table import Indices, Table
from ..engine.tables import Body, EnergyBalance, Matrix, Scratch, State
from ..scene.types import Scene

Vectors = NDArray[np.complex128]
"""An array of vectors, each a complex number: (x, y) is x + iy."""
Floats = NDArray[np.float64]
"""An array of real numbers."""


class Places(NamedTuple):
    """Where the parts of a scene are in a body's tables.

    Attributes:
        mass_index: (n,) the slot of each mass of the scene.
        ends: (S, 2) the slots of the masses at the ends of each spring, in the order of the tables.
        slots: number of slots of a state.
        mass: (slots,) kg.
        spring_order, joint_order: the spring, and the joint, of the scene in each row of the tables.
    """

    mass_index: Indices
    ends: Indices
    slots: int
    mass: Floats
    spring_order: Indices
    joint_order: Indices


Kernel = Any
"""numba's dispatcher of a compiled function."""

_ON = Body.numba_type, State.numba_type
_FLOAT = types.float64
SIGNATURES = {
    "add_forces": types.void(*_ON, Scratch.numba_type, FLOATS, FLOATS),
    "energy": _FLOAT(*_ON, FLOATS),
    "add_power": types.void(*_ON, EnergyBalance.numba_type, FLOATS, FLOATS, _FLOAT),
    "add_derivatives": types.void(*_ON, Matrix.numba_type, FLOATS, FLOATS, _FLOAT, types.boolean),
    "add_damping": types.void(*_ON, FLOATS, FLOATS, FLOATS, _FLOAT, FLOATS),
    "impact_time": _FLOAT(*_ON, FLOATS, FLOATS, FLOATS, _FLOAT),
    "kink_fraction": _FLOAT(*_ON, FLOATS, FLOATS, FLOATS, FLOATS, _FLOAT, _FLOAT),
}
"""Signatures of the kernels that a `Term` may have, by their fields."""


class Reference(Protocol):
    """The same force in NumPy, for one body; the tests compare the kernels with it."""

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) kg px/s², on the masses at positions x (px) with velocities v (px/s)."""
        ...

    def energy(self, x: Vectors) -> float:
        """kg px²/s², of all masses at positions x (px); zero where the force has none."""
        ...


@runtime_checkable
class Sticking(Protocol):
    """A `Reference` that remembers what it sticks to."""

    def update_friction_history(self, x: Vectors, v: Vectors) -> None:
        """Update the tangential springs after a step to positions x with velocities v."""
        ...


@runtime_checkable
class Bracing(Protocol):
    """A `Reference` of parts that may soon be stiffer than they are; the stability limit is that of all."""

    def brace(self, x: Vectors) -> None:
        """Let all act as stiffly as they can; those that do not act at positions x (px) as if at rest."""
        ...


@dataclass(frozen=True)
class Term:
    """A force on masses, with all that the solver asks of it.

    Attributes:
        name: of its energy, and as a cause of instability.
        acts: whether the term acts on a valid scene's masses.
        reference: makes the same in NumPy from a body's tables.
        add_forces: kernel (body, state, scratch, q, v); adds forces, kg px/s², to `scratch.fx` and
            `scratch.fy`. `tx` and `ty` of the scratch are free for it. None where another term adds them.
        field: of its table in `Body.environment`; empty for springs and joints, which are the body itself.
        table: the class of that table.
        new: makes it from a valid scene.
        causes: what its stiffness and its damping are called as a cause of instability; `name` without.
        energy: kernel (body, state, q); returns kg px²/s². None for a force without an energy.
        label: what the energy is of, in a few words.
        add_power: kernel (body, state, balance, q, v, part); adds `part` (s) times the power, kg px²/s³, of
            what is not the gradient of the energy to a field of `balance.work`.
        add_derivatives: kernel (body, state, matrix, q, v, g, definite); adds the derivatives of forces by
            positions, kg/s², plus g (1/s) times those by velocities, kg/s, to `matrix.blocks`. With
            `definite`, it leaves out what could make the matrix of a step indefinite.
        add_damping: kernel (body, state, q, v, z, factor, out); adds `factor` times the derivative of the
            accelerations by velocities, 1/s, times the flat vector z, to `out`.
        impact_time: kernel (body, state, q, v, a, h); returns the shortest time, s, in which a mass gets as
            deep into something as its speed leads. It counts what masses with accelerations a (px/s²) are
            in, or enter within h (s); infinite where there is nothing.
        kink_fraction: kernel (body, state, q, v, to_q, to_v, h, unseen); returns the part of a step from q, v
            to to_q, to_v (h, s) that leads just beyond a kink of the force, where the step would miss more
            than the speed `unseen` (px/s) of a mass; 1 if the step may be kept.
        bounds: given a body's tables, (masses,) upper bounds of the row sums of minus the derivatives of its
            forces by positions, kg/s², and by velocities, kg/s, for NumPy's stand-in of the solver.
        touches: whether it acts only on masses that are in something, such as a wall.
        holds: whether it can keep a body in place that hangs on nothing, so that this has an equilibrium.
        sticks: whether tangential springs may hold what touches something in the term's table.
        depends_on_time: whether the force changes with time by itself, in a body.
    """

    name: str
    acts: Callable[[Scene], bool]
    reference: Callable[[Body, State], Reference]
    add_forces: Kernel | None = None
    field: str = ""
    table: type[Table] = Table
    new: Callable[[Scene, Places], Table] | None = None
    causes: tuple[str, str] | None = None
    energy: Kernel | None = None
    label: str = ""
    add_power: Kernel | None = None
    add_derivatives: Kernel | None = None
    add_damping: Kernel | None = None
    impact_time: Kernel | None = None
    kink_fraction: Kernel | None = None
    bounds: Callable[[Body], tuple[Floats, Floats]] | None = None
    touches: bool = False
    holds: bool = False
    sticks: Callable[[Any], bool] = lambda _table: False
    depends_on_time: Callable[[Body], bool] = lambda _body: False


def summed(at: Indices, forces: Vectors, slots: int) -> Vectors:
    """(slots,) the sum of the forces at each slot; `at`: (k,) where each acts."""
    x, y = (np.bincount(at, part, slots) for part in (forces.real, forces.imag))
    return x + 1j * y
