"""`softrod run`: simulates a scene without a page and writes a table."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

import msgspec
import numpy as np
from rich.console import Console
from rich.progress import Progress

import sim
from sim.csv_text import csv_text
from sim.errors import InputError
from sim.motion.energy import ENERGY_FIELDS, EnergyBook
from sim.store.files import write_atomically
from sim.store.places import as_utf8, repeated_key

from .session.log import Log, Step, decode_log, is_recorded
from .session.replay import Player

LONG_RUN = 200_000
"""Steps from which on a run shows its progress."""


class Move(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A held mass is put somewhere."""

    mass: int
    to: tuple[float, float]


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One line of an input log: what happens at the start of a step, before the forces.

    Attributes:
        step: steps done before it, from 0.
        move: the mass and where it is put, or None.
        keys: the set of keys held from this step on, or None for no change.
    """

    step: int
    move: Move | None = None
    keys: tuple[str, ...] | None = None


def read_log(path: Path) -> list[Entry] | Log:
    """The entries of an input log, one JSON object a line, in order of their steps; or a recorded log.

    Raises:
        InputError: the file cannot be read, or a line is not an entry; the sentence names the line.
    """
    try:
        data = as_utf8(path.read_bytes())
    except OSError as error:
        raise InputError(f"{path}: the file cannot be read ({error.strerror or error})") from None
    except UnicodeError as error:
        raise InputError(f"{path}: {error}") from None
    if is_recorded(data):
        return decode_log(data, str(path))
    lines = data.splitlines()
    entries: list[Entry] = []
    decoder = msgspec.json.Decoder(Entry)
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        try:
            entry = decoder.decode(line)
        except msgspec.DecodeError as error:
            raise InputError(f"{path}: line {number}: {error}") from None
        if again := repeated_key(line):
            raise InputError(f"{path}: line {number}: the key {again[0][:60]!r} stands twice in one object")
        if entry.step < (entries[-1].step if entries else 0):
            raise InputError(f"{path}: line {number}: step {entry.step} comes after a later step")
        entries.append(entry)
    return entries


class Table(Protocol):
    """Rows of a run, one after each K-th step."""

    def __len__(self) -> int: ...

    def add(self, simulation: sim.Simulation) -> None:
        """Note the present state."""
        ...

    def write(self, path: Path, decimal_comma: bool = False) -> None:
        """Write as CSV, which may have decimal commas, or NPZ.

        Raises:
            InputError: the ending is neither, or the file cannot be written.
        """
        ...


class QuantityTable(sim.Recording):
    """A table of quantities, for `--record`."""

    def write(self, path: Path, decimal_comma: bool = False) -> None:
        """As `Table` says; in NPZ, there is an array `time`, and one for each quantity by its name."""
        if path.suffix == ".npz":
            _write(path, _npz(time=self.time, **{name: self[name] for name in self.units}))
        else:
            self.to_csv(path, decimal_comma)


@dataclass
class PositionTable:
    """A table of the places of all masses, and of the energies if they are asked for."""

    masses: int
    steps: list[int] = field(default_factory=list)
    times: list[float] = field(default_factory=list)
    positions: list[np.ndarray] = field(default_factory=list)
    energies: list[EnergyBook] | None = None

    def __len__(self) -> int:
        return len(self.steps)

    def add(self, simulation: sim.Simulation) -> None:
        """As `Table` says."""
        if self.energies is not None:
            self.energies.append(simulation.energy())
        self.steps.append(simulation.step_count)
        self.times.append(simulation.time)
        self.positions.append(simulation.positions)

    def write(self, path: Path, decimal_comma: bool = False) -> None:
        """Write as CSV (17 significant digits) or NPZ (`step`, `time`, `positions` of shape (rows, n, 2)).

        With energies, there is a column, or an array, for each field of `sim.EnergyBook`.

        Raises:
            InputError: the ending is neither, or the file cannot be written.
        """
        positions = np.array(self.positions).reshape(len(self.steps), self.masses, 2)
        if path.suffix == ".npz":
            books = self.energies or ()
            energies = {
                name: np.array([getattr(book, name) for book in books])
                for name in (ENERGY_FIELDS if self.energies is not None else ())
            }
            steps, times = np.array(self.steps), np.array(self.times)
            _write(path, _npz(step=steps, time=times, positions=positions, **energies))
        else:
            _write(path, self._csv(positions, decimal_comma).encode())

    def _csv(self, positions: np.ndarray, decimal_comma: bool) -> str:
        names = ENERGY_FIELDS if self.energies is not None else ()
        axes = [f"{axis}{i}" for i in range(self.masses) for axis in "xy"]
        table: list[list[object]] = [["step", "time", *names, *axes]]
        flat = positions.reshape(len(self.steps), 2 * self.masses)
        for i, (step, time, row) in enumerate(zip(self.steps, self.times, flat, strict=True)):
            energies = [getattr(self.energies[i], name) for name in names] if self.energies else []
            table.append([step, time, *energies, *row])
        return csv_text(table, decimal_comma, "{:.17g}".format)


def new_table(scene: sim.Scene, energy: bool, names: Sequence[str]) -> Table:
    """A table of the named quantities of a scene; without any, of the places of its masses.

    Raises:
        InputError: there is no such quantity, or the scene has no such part.
    """
    if names:
        return QuantityTable(scene, names)
    return PositionTable(len(scene.masses), energies=[] if energy else None)


def _are_energies(names: Sequence[str]) -> bool:
    """Whether any of the quantities is an entry of the energy balance, which is then kept from the start."""
    return any(name.startswith("energy.") for name in names)


def _npz(**arrays: np.ndarray) -> bytes:
    data = io.BytesIO()
    np.savez(data, allow_pickle=False, **arrays)
    return data.getvalue()


def _write(path: Path, content: bytes) -> None:
    try:
        write_atomically(path, content)
    except OSError as error:
        raise InputError(f"{path}: the file cannot be written ({error.strerror or error})") from None


def check_output(path: Path) -> None:
    """Refuse an output that could not be written, before any time goes into a run.

    Raises:
        InputError: the ending is neither .csv nor .npz, or the folder does not exist.
    """
    if path.suffix not in (".csv", ".npz"):
        raise InputError(f"--out {path}: the file must end in .csv or .npz")
    if not path.parent.is_dir():
        raise InputError(f"--out {path}: the folder {path.parent} does not exist")


def run(
    scene: sim.Scene,
    steps: int,
    entries: list[Entry],
    every: int,
    console: Console,
    energy: bool = False,
    names: Sequence[str] = (),
) -> tuple[Table, str | None]:
    """Simulate, and return the rows and why it stopped early (None if it did not).

    Args:
        scene: a valid scene.
        steps: steps to do.
        entries: inputs, in order of their steps.
        every: rows are taken after each step that is a multiple of this.
        console: for the progress bar of a long run.
        energy: whether the rows have the energies.
        names: quantities that the rows have instead of places.

    Raises:
        InputError: there would be no row, or there is no such quantity, or an input asks for what cannot be
            done; the sentence names its step.
    """
    if every > steps:
        raise InputError(f"--every: {every} is more than the run's {steps} steps, so no row would be written")
    recording = new_table(scene, energy, names)
    simulation = sim.Simulation(scene)
    simulation.keep_books(energy or _are_energies(names))
    with Progress(console=console, transient=True, disable=steps < LONG_RUN) as progress:
        task = progress.add_task("simulating", total=steps)
        for target in _stops(steps, entries, every):
            while entries and entries[0].step == simulation.step_count:
                _apply(entries[0], simulation)
                entries = entries[1:]
            simulation.step(target - simulation.step_count)
            if simulation.divergence is not None:
                return recording, str(simulation.divergence)
            if target % every == 0:
                recording.add(simulation)
            progress.update(task, completed=target)
    return recording, None


def replay(
    record: Log,
    steps: int | None,
    every: int,
    console: Console,
    energy: bool = False,
    names: Sequence[str] = (),
) -> tuple[Table, Player]:
    """Do again what a recorded log says, and return the rows, and how it compares.

    Args:
        record: the log.
        steps: steps after which it ends; None for all of the log.
        every: a row is taken after each recorded frame in which a multiple of this many steps was passed.
        console, energy, names: as for `run`.

    Raises:
        InputError: the log asks for what cannot be done; the sentence names its line.
    """
    recording = new_table(record.scene, energy, names)
    simulation = sim.Simulation(record.scene)
    player = Player(record, simulation, energy or _are_energies(names))
    total = sum(entry.n * entry.times for entry in record.entries if isinstance(entry, Step))
    due = every
    with Progress(console=console, transient=True, disable=total < LONG_RUN) as progress:
        task = progress.add_task("replaying", total=total)
        while not player.ended and (steps is None or player.steps < steps):
            player.do()
            if player.steps >= due:
                recording.add(simulation)
                due = player.steps - player.steps % every + every
                progress.update(task, completed=player.steps)
    return recording, player


def same_body(one: sim.Scene, other: sim.Scene) -> bool:
    """Whether two scenes differ in no more than their names, titles, descriptions and views."""
    plain = {"name": "scene", "title": "", "description": "", "view": sim.View()}
    return msgspec.structs.replace(one, **plain) == msgspec.structs.replace(other, **plain)


def _stops(steps: int, entries: list[Entry], every: int) -> Iterator[int]:
    """The steps, ascending, up to which the simulation can go in one call."""
    inputs = sorted({entry.step for entry in entries if 0 < entry.step < steps})
    rows = iter(range(every, steps + 1, every))
    row = next(rows, None)
    for stop in [*inputs, steps]:
        while row is not None and row <= stop:
            yield row
            row = next(rows, None)
        if stop % every:
            yield stop


def _apply(entry: Entry, simulation: sim.Simulation) -> None:
    try:
        if entry.move is not None:
            simulation.move(entry.move.mass, entry.move.to)
        if entry.keys is not None:
            simulation.keys = entry.keys
    except InputError as error:
        raise InputError(f"inputs, step {entry.step}: {error}") from None
