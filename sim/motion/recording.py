"""Quantities of a simulation over time, and their table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..scene.types import Scene
from ..store.csv_text import csv_text
from ..store.files import write_file
from ..text import Text
from .dimensions import IN_ASCII
from .quantities import Moving, Quantity, quantity

Floats = NDArray[np.float64]

LOOKS_APART = 1.0 / 240.0
"""Seconds between two looks at a body whose angles are followed, at most, unless a step is longer. Doubled or
halved, no test fails."""


class Recording:
    """Quantities of a simulation at several times; `Simulation.record` makes one.

    Angles go on from where they were, so that a joint that turns once round is at 360°. For that a body has
    to be looked at more often than it turns by half, see `look`.

    `recording["joint3.angle"]` is the (k,) array of a quantity, `recording.time` that of the times.

    Args:
        scene: whose quantities they are.
        names: of the quantities, see `sim.quantity`; each once.

    Attributes:
        units: of each quantity, by its name.

    Raises:
        InputError: there is none, there is no such quantity, or the scene has no such part.
    """

    def __init__(self, scene: Scene, names: Iterable[str]) -> None:
        self._quantities = {q.name: q for q in (quantity(name, scene) for name in names)}
        if not self._quantities:
            raise InputError(
                Text("{where}: name at least one quantity, such as joint0.angle", where="record")
            )
        self._rows: list[tuple[float, ...]] = []
        self._last = [math.nan] * len(self._quantities)
        self.units = {name: q.unit for name, q in self._quantities.items()}

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, name: str) -> Floats:
        try:
            return self._columns[1 + list(self._quantities).index(name)]
        except ValueError:
            raise InputError(
                Text("{name!r} was not recorded, but {known}", name=name, known=", ".join(self._quantities))
            ) from None

    @property
    def time(self) -> Floats:
        """(k,) simulated time, s."""
        return self._columns[0]

    @property
    def wants_energy(self) -> bool:
        """Whether any quantity is read from the energy balance."""
        return any(q.is_of("energy") for q in self._quantities.values())

    def add(self, simulation: Moving) -> None:
        """Add a row for the present state."""
        each = zip(self._quantities.values(), self._last, strict=True)
        self._last = [q.read(simulation, before) for q, before in each]
        self._rows.append((simulation.time, *self._last))

    def look(self, simulation: Moving) -> None:
        """Follow the angles between two rows."""
        for i, q in enumerate(self._quantities.values()):
            if q.unwrapped:
                self._last[i] = q.read(simulation, self._last[i])

    def steps_between(self, dt: float, every: int) -> int:
        """The most steps of a body from one look to the next, where a row is taken every so many."""
        turns = any(q.unwrapped for q in self._quantities.values())
        return min(max(int(LOOKS_APART / dt), 1), every) if turns else every

    def to_csv(self, path: str | Path, decimal_comma: bool = False) -> None:
        """Write a table: a line of names with units, as in `time [s]` and `joint3.angle [deg]`, and a line
        for each time. Numbers have as many digits as it takes to read back exactly what they are.

        Args:
            path: the file.
            decimal_comma: whether numbers have a decimal comma; semicolons then stand between them.

        Raises:
            InputError: the file cannot be written.
        """
        text = table_text(self._quantities.values(), self._rows, decimal_comma)
        write_file(Path(path), text.encode())

    @property
    def _columns(self) -> Floats:
        return np.array(self._rows, float).reshape(len(self._rows), 1 + len(self._quantities)).T


def table_text(
    quantities: Iterable[Quantity],
    rows: Iterable[Sequence[float]],
    decimal_comma: bool = False,
    frames: Sequence[int] = (),
) -> str:
    """The table of some quantities as CSV, see `Recording.to_csv`.

    Args:
        quantities: what the columns are, beside the time.
        rows: of time and values; a NaN leaves its place empty.
        decimal_comma: see `Recording.to_csv`.
        frames: for how many frames each row stands, as a last column; empty for none.
    """
    units = ((q.name, q.unit.translate(IN_ASCII)) for q in quantities)
    head: list[object] = ["time [s]", *(f"{name} [{unit}]" if unit else name for name, unit in units)]
    lines: list[list[object]] = [head, *(list(map(float, row)) for row in rows)]
    for line, count in zip(lines, ("frames", *frames) if frames else (), strict=False):
        line.append(count)
    return csv_text(lines, decimal_comma, _digits)


def _digits(value: float) -> str:
    return repr(value) if value == value else ""
