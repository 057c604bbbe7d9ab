"""What a page about a force gives to the list in `all`, and how kernels are joined from it.

All kernels get the tables `body` and `state`, and flat positions q (px) and velocities v (px/s): x of every
slot, then y of every slot. A term that a scene does not have has no rows, so its loops end at once.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..kernels.core.tables import Body, State
from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.table import Indices, Table

Vectors = NDArray[np.complex128]
"""An array of vectors, each a complex number: (x, y) is x + iy."""
Floats = NDArray[np.float64]
"""An array of real numbers."""
_T = TypeVar("_T", bound=Table)
Kernel = Any
"""numba's dispatcher of a compiled function."""


class Twin(Protocol):
    """The same force in NumPy, for one body; the tests compare the kernels with it."""

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """(slots,) kg px/s², on the masses at positions x (px) with velocities v (px/s)."""
        ...

    def energy(self, x: Vectors) -> float:
        """kg px²/s², of all masses at positions x (px); zero where the force has none."""
        ...


@kernel(internal=True)
def nothing(*_arguments):
    """Stands for a kernel that a term does not need."""


@kernel(internal=True)
def never(*_arguments):
    """Stands for `Term.impact_time` of a term that can be entered at any speed."""
    return np.inf


@dataclass(frozen=True)
class Term:
    """A force on masses besides those of springs and joints, with all that the solver asks of it.

    Attributes:
        name: of its energy, and as a cause of instability.
        twin: makes its twin in NumPy from a body's tables.
        add_forces: kernel (body, state, scratch, q, v); adds forces, kg px/s², to `scratch.fx` and
            `scratch.fy`. `tx` and `ty` of the scratch are free for it.
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
        depends_on_time: whether the force changes with time by itself, in a body.
    """

    name: str
    twin: Callable[[Body, State], Twin]
    add_forces: Kernel
    energy: Kernel | None = None
    label: str = ""
    add_power: Kernel = nothing
    add_derivatives: Kernel = nothing
    add_damping: Kernel = nothing
    impact_time: Kernel = never
    depends_on_time: Callable[[Body], bool] = lambda _body: False


def summed(at: Indices, forces: Vectors, slots: int) -> Vectors:
    """(slots,) the sum of the forces at each slot; `at`: (k,) where each acts."""
    x, y = (np.bincount(at, part, slots) for part in (forces.real, forces.imag))
    return x + 1j * y


def read_only(table: _T) -> _T:
    """The table, whose arrays nothing can write to any more."""
    for _, array in table.arrays():
        array.setflags(write=False)
    return table


def in_turn(kernels: Iterable[Kernel]) -> Kernel:
    """A kernel that calls all of some kernels with the same arguments."""

    def join(one: Kernel, other: Kernel) -> Kernel:
        @kernel(internal=True, kept=False, fastmath=FAST)
        def both(*arguments):
            one(*arguments)
            other(*arguments)

        return both

    return functools.reduce(join, kernels)


def least_of(kernels: Iterable[Kernel]) -> Kernel:
    """A kernel that returns the least of what some kernels return."""

    def join(one: Kernel, other: Kernel) -> Kernel:
        @kernel(internal=True, kept=False, fastmath=FAST)
        def both(*arguments):
            return min(one(*arguments), other(*arguments))

        return both

    return functools.reduce(join, kernels)


def written(energies: Iterable[Kernel], first: int) -> Kernel:
    """A kernel (body, state, q, out) that writes each of some energies into `out`, from index `first` on."""

    def at(index: int, energy: Kernel) -> Kernel:
        @kernel(internal=True, kept=False, fastmath=FAST)
        def write(body, state, q, out):
            out[index] = energy(body, state, q)

        return write

    return in_turn([at(first + k, energy) for k, energy in enumerate(energies)])
