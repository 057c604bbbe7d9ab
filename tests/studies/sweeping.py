"""Sweeps in this process, and what they leave in their folders."""

from __future__ import annotations

import concurrent.futures
import csv
import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import msgspec
from rich.console import Console

import sim
from studies.sweep.grid import make_grid
from studies.sweep.journal import Entry
from studies.sweep.measures import parse_measures
from studies.sweep.runs import run_several
from studies.sweep.sweep import sweep
from studies.sweep.workers import MAX_AHEAD, Workers

ROPE = sim.rope(
    5,
    100.0,
    direction=(1.0, 0.5),
    driven=None,
    damping=10.0,
    integrator=sim.Integrator(method="rk4", dt=1e-3),
)


def rows_of(out: Path) -> list[dict[str, str]]:
    """The rows of the table."""
    with (out / "table.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def numbers_of(out: Path) -> list[int]:
    """The numbers of the runs that are kept, in the order in which they were."""
    lines = (out / "sweep.jsonl").read_bytes().splitlines()[1:]
    return [msgspec.json.decode(line, type=Entry).run for line in lines]


class Here(concurrent.futures.Executor):
    """Computes in this process, and notes what it was asked for: "run" for each run of a sweep.

    Attributes:
        asked: names of what was asked for.
        calls: how often it was asked.
    """

    def __init__(self, interrupt_at: int | None = None, counted: str = "run", ahead: int = MAX_AHEAD) -> None:
        self.asked: list[str] = []
        self.calls = 0
        self._interrupt_at, self._counted, self._ahead = interrupt_at, counted, ahead

    def submit(self, call, /, *arguments, **named):
        asked = ["run"] * len(arguments[1]) if call is run_several else [call.__name__]
        if asked[0] == self._counted and self.asked.count(self._counted) == self._interrupt_at:
            raise KeyboardInterrupt
        self.asked += asked
        self.calls += 1
        future = concurrent.futures.Future()
        try:
            future.set_result(call(*arguments, **named))
        except Exception as error:
            future.set_exception(error)
        return future

    @contextmanager
    def __call__(self) -> Iterator[Workers]:
        yield Workers(self, self._ahead)


def swept(
    out: Path,
    scene: sim.Scene,
    vary: Sequence[str],
    measures: Sequence[str],
    duration: float = 0.2,
    **options,
) -> tuple[int, Here, str]:
    """The exit status of a sweep in this process, what was asked for, and what was printed."""
    here = Here(options.pop("interrupt_at", None), ahead=options.pop("ahead", MAX_AHEAD))
    text = io.StringIO()
    grid = make_grid(scene, options.pop("settings", ()), vary)
    status = sweep(grid, parse_measures(measures), duration, here, out, Console(file=text, width=200))
    return status, here, text.getvalue()
