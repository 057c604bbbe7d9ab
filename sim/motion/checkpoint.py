"""All that decides every bit of how a motion goes on, also in the middle of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engine.tables import Floats, Indices, PrescribedMotion
from ..scene.types import Scene
from .hands import Hand

_PIECE = 32
"""Words of a piece: pieces of zeros are not stored. Rows that a method does not use are zero."""


class Words(NamedTuple):
    """The contents of some arrays, without most zeros.

    Attributes:
        size: number of words of all arrays together.
        pieces: indices of the pieces that are not zero.
        words: (pieces, `_PIECE`) these.
    """

    size: int
    pieces: NDArray[np.int32]
    words: NDArray[np.int64]

    @property
    def nbytes(self) -> int:
        """Bytes that they take."""
        return self.pieces.nbytes + self.words.nbytes

    @staticmethod
    def of(arrays: Iterable[Floats | Indices]) -> Words:
        """The present contents of arrays of eight bytes an item."""
        words = [array.reshape(-1).view(np.int64) for array in arrays]
        size = sum(each.size for each in words)
        whole = np.concatenate([*words, np.zeros(-size % _PIECE, np.int64)]).reshape(-1, _PIECE)
        pieces = np.flatnonzero(whole.any(1)).astype(np.int32)
        return Words(size, pieces, whole[pieces])

    def put_into(self, arrays: Iterable[Floats | Indices]) -> None:
        """Set the contents of arrays that have the same sizes."""
        whole = np.zeros((-(-self.size // _PIECE), _PIECE), np.int64)
        whole[self.pieces] = self.words
        flat, begin = whole.reshape(-1), 0
        for array in arrays:
            array.reshape(-1).view(np.int64)[:] = flat[begin : begin + array.size]
            begin += array.size
        assert begin == self.size, "the arrays are those of another body"


class SolverMemory(NamedTuple):
    """What a method remembers of its last steps; not its matrix, which no step takes from another.

    Attributes:
        arrays: contents of its arrays, and of its scratch; None if it is to begin anew.
        numbers: of its records.
        costs: of the steps of `auto`'s methods; None if unknown.
    """

    arrays: Words | None
    numbers: tuple[tuple[int, ...], ...]
    costs: Floats | None


class MotionMemory(NamedTuple):
    """What decides how a `Motion` goes on.

    Attributes:
        damageable: whether its tables have room for damage.
        state: contents of its state.
        solver: what its method remembers.
        origin, begins: when the method began anew, s and steps, and whether it is to with the next step.
        steps: time steps done.
        drive, key_rates: the drive that is kept from the last call, and the keys in it.
        led: positions, px, to which masses were led in the last call, by slot.
        grabbed, targets, limited: see `Hands`.
    """

    damageable: bool
    state: Words
    solver: SolverMemory
    origin: tuple[float, int]
    begins: bool
    steps: int
    drive: PrescribedMotion | None
    key_rates: tuple[float, float]
    led: Mapping[int, tuple[float, float]]
    grabbed: frozenset[int]
    targets: Mapping[int, tuple[float, float]]
    limited: Mapping[int, Hand]


@dataclass(frozen=True, eq=False, slots=True)
class Checkpoint:
    """All that decides every bit of how a simulation goes on; see `Simulation.checkpoint`.

    Unlike a `Moment`, it has what the method remembers of its last steps, and what is in somebody's hand.

    Attributes:
        scene: its body and settings, without what keys have changed; shared, not copied.
        keys: the arrow keys held.
        time: simulated time, s.
        memory: the rest.
    """

    scene: Scene
    keys: frozenset[str]
    time: float
    memory: MotionMemory

    @property
    def nbytes(self) -> int:
        """Bytes of its numbers."""
        arrays = self.memory.solver.arrays
        return self.memory.state.nbytes + (arrays.nbytes if arrays is not None else 0)


def writable(arrays: Iterable[tuple[str, Floats | Indices]]) -> list[Floats | Indices]:
    """Those of a table's arrays that may change."""
    return [array for _, array in arrays if array.flags.writeable]
