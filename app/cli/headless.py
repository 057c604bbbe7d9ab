"""`softrod run`: simulates a scene without a page and writes a table."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import msgspec
import numpy as np
from rich.console import Console
from rich.progress import Progress

import sim
from sim.errors import InputError
from sim.motion.energy import ENERGY_FIELDS
from sim.store.csv_text import csv_text
from sim.store.files import write_file

from ..session.log import Log, Step
from ..session.replay import Player

LONG_RUN = 200_000
"""Steps from which on a run shows its progress."""


class QuantityTable(sim.Recording):
    """A table of quantities, for `--record`; a row after each K-th step."""

    def write(self, path: Path, decimal_comma: bool = False) -> None:
        """Write as CSV, which may have decimal commas, or NPZ (`time`, and an array for each quantity).

        Raises:
            InputError: the file has another ending, or cannot be written.
        """
        if path.suffix == ".npz":
            write_file(path, _npz(time=self.time, **{name: self[name] for name in self.units}))
        else:
            self.to_csv(path, decimal_comma)


class PositionTable:
    """A table of the positions of all masses, and optionally of the energies."""

    def __init__(self, masses: int, energy: bool) -> None:
        self._masses, self._energies = masses, ENERGY_FIELDS if energy else ()
        self._rows: list[tuple[float, ...]] = []

    def __len__(self) -> int:
        return len(self._rows)

    def add(self, simulation: sim.Simulation) -> None:
        balance = simulation.energy() if self._energies else None
        energies = (getattr(balance, name) for name in self._energies)
        places = simulation.positions.ravel().tolist()
        self._rows.append((simulation.step_count, simulation.time, *energies, *places))

    def write(self, path: Path, decimal_comma: bool = False) -> None:
        """See `QuantityTable`; CSV has 17 significant digits, NPZ `step`, `time`, `positions` (rows, n, 2).

        With energies, there is also a column, or an array, for each field of `sim.Energies`.
        """
        names = ("step", "time", *self._energies)
        if path.suffix == ".npz":
            columns = {name: np.array([row[i] for row in self._rows]) for i, name in enumerate(names)}
            places = np.array([row[len(names) :] for row in self._rows])
            write_file(path, _npz(**columns, positions=places.reshape(len(self._rows), self._masses, 2)))
        else:
            axes = (f"{axis}{i}" for i in range(self._masses) for axis in "xy")
            table = [(*names, *axes), *self._rows]
            write_file(path, csv_text(table, decimal_comma, "{:.17g}".format).encode())


Table = QuantityTable | PositionTable


def new_table(scene: sim.Scene, energy: bool, names: Sequence[str]) -> Table:
    """A table of the named quantities of a scene, or without names of the positions of its masses.

    Raises:
        InputError: there is no such quantity, or the scene has no such part.
    """
    if names:
        return QuantityTable(scene, names)
    return PositionTable(len(scene.masses), energy)


def _npz(**arrays: np.ndarray) -> bytes:
    data = io.BytesIO()
    np.savez(data, allow_pickle=False, **arrays)
    return data.getvalue()


def check_output(path: Path) -> None:
    """Check that an output can be written, before time is spent on a run.

    Raises:
        InputError: the ending is neither .csv nor .npz, or the folder does not exist.
    """
    if path.suffix not in (".csv", ".npz"):
        raise InputError(f"--out {path}: the file must end in .csv or .npz")
    if not path.parent.is_dir():
        raise InputError(f"--out {path}: the folder {path.parent} does not exist")


def run(
    record: Log,
    steps: int | None,
    every: int,
    console: Console,
    energy: bool = False,
    names: Sequence[str] = (),
) -> tuple[Table, Player]:
    """Play a log, and continue from its end.

    Args:
        record: the log; without entries, its scene moves freely.
        steps: steps after which the run ends, within the log or beyond; None for all of the log.
        every: a row is added after each multiple of so many steps, or after the call of the log that passes
            it.
        console: for the progress bar of a long run.
        energy: whether rows have the energies.
        names: quantities that rows have instead of positions.

    Returns:
        The rows until the steps are done, or until the body runs away, unless checks of the log expect that;
        and the player, which has compared the run with the log.

    Raises:
        InputError: there would be no row, there is no such quantity, or the log cannot be played; names the
            line.
    """
    if steps is not None and every > steps:
        raise InputError(f"--every: {every} is more than the run's {steps} steps, so no row would be written")
    recording = new_table(record.scene, energy, names)
    followed = recording if isinstance(recording, sim.Recording) else None
    simulation = sim.Simulation(record.scene)
    player = Player(record, simulation, energy or (followed is not None and followed.wants_energy))
    in_log = sum(entry.n * entry.times for entry in record.entries if isinstance(entry, Step))
    total, due = in_log if steps is None else steps, every
    with Progress(console=console, transient=True, disable=total < LONG_RUN) as progress:
        task = progress.add_task("simulating", total=total)
        while steps is None or player.steps < steps:
            if not player.ended:
                player.do()
            elif steps is not None:
                between = followed.steps_between(simulation.dt, every) if followed else every
                player.steps += simulation.step(min(due, steps, player.steps + between) - player.steps)
                if followed:
                    followed.look(simulation)
            else:
                break
            if simulation.divergence is not None and (player.ended or not record.checks):
                break
            if player.steps >= due:
                recording.add(simulation)
                due = player.steps - player.steps % every + every
                progress.update(task, completed=player.steps)
    return recording, player


def same_body(one: sim.Scene, other: sim.Scene) -> bool:
    """Whether two scenes are equal except for names, titles, descriptions and views."""
    plain = {"name": "scene", "title": "", "description": "", "view": sim.View()}
    return msgspec.structs.replace(one, **plain) == msgspec.structs.replace(other, **plain)
