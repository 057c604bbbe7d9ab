"""`softrod sweep`: gives runs to workers, and stores their rows as they come."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from rich.console import Console

import sim
from sim.compiling.compiler import all_of, fetch
from sim.model.system import build_system
from sim.solve.registry import METHODS
from sim.store.files import decode_scene, encode_scene

from ..reporting.progress import ProgressBar
from ..reporting.report import Figure
from .grid import Grid
from .journal import Entry, Header, Journal, digest_of
from .runs import REFERENCE, Points, Reference, Row, is_quick, reference_of, run_reference, run_several
from .table import write_sweep_table
from .workers import Call, MakeWorkers, Workers

MAX_TOGETHER = 64
"""Runs of one call, where a call does several."""


class SweepHeader(Header, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What is swept.

    Attributes:
        vary: keys and values of the axes.
        measures: names.
    """

    COMMAND = "sweep"
    NOUN = "sweep"
    OPTIONS = Header.OPTIONS | {"measures": "--measure", "duration": "--duration"}

    vary: tuple[tuple[str, tuple[str, ...]], ...]
    measures: tuple[str, ...]

    def has(self, entry: Entry) -> bool:
        """Whether an entry can belong to one of its runs."""
        runs = math.prod(len(values) for _, values in self.vary)
        return 0 <= entry.run < runs and len(entry.row.values) == len(self.measures)


@dataclass
class Sweep:
    """What is swept.

    Attributes:
        grid: the scene and what is varied.
        measures: names.
        duration: simulated time of each run, s.
        quick: after `check`, the numbers of the quick runs, see `is_quick`.
        methods: after `check`, the names of the methods of all others.
        tolerance: after `check`, the smallest tolerance of all methods, px; infinite where none has one.
    """

    grid: Grid
    measures: tuple[str, ...]
    duration: float
    quick: set[int] = field(default_factory=set)
    methods: set[str] = field(default_factory=set)
    tolerance: float = math.inf

    @property
    def header(self) -> SweepHeader:
        """The first line of its journal."""
        return SweepHeader(
            scene=self.grid.scene.name,
            digest=digest_of(self.grid.scene),
            settings=self.grid.settings,
            vary=tuple((axis.key, axis.values) for axis in self.grid.axes),
            measures=self.measures,
            duration=self.duration,
        )

    def check(self) -> None:
        """Check the scene of every run.

        Raises:
            InputError: one is not valid.
        """
        for number, point in enumerate(self.grid.points):
            scene = self.grid.scene_at(point)
            integrator = scene.integrator
            if is_quick(scene, self.duration, self.measures):
                self.quick.add(number)
            else:
                self.methods.add(integrator.method)
            if METHODS[integrator.method].adaptive:
                self.tolerance = min(self.tolerance, integrator.tolerance)

    def rows(self, missing: Iterable[int], workers: Workers) -> Iterator[tuple[int, Row]]:
        """Do the runs of these numbers, and yield each with its row, in the order in which they are done.

        A near-exact run that several have in common is done once, before them.

        Raises:
            InputError: no worker is left.
        """
        queue = _Queue(self, missing)
        with workers.losing("sweep"):
            for key, result in workers.compute(queue.next_call):
                if isinstance(key, Reference):
                    queue.take_reference(key, result)
                else:
                    yield from zip(key, result, strict=True)


class _Queue:
    """The runs of a sweep that are still to be done.

    Args:
        sweep: what is swept.
        missing: the numbers of the runs.
    """

    def __init__(self, sweep: Sweep, missing: Iterable[int]) -> None:
        self._sweep, self._data = sweep, encode_scene(sweep.grid.scene)
        # Runs that can start, each with the end of its near-exact run.
        self._several: deque[tuple[int, Points | None]] = deque()
        self._single: deque[tuple[int, Points | None]] = deque()
        # Runs whose near-exact run has not been looked up.
        self._waiting = deque(missing)
        self._exact: dict[Reference, Points | None] = {}
        self._asked: dict[Reference, list[int]] = {}
        if "error" not in sweep.measures:
            self._make_ready(self._waiting, None)
            self._waiting.clear()

    def next_call(self) -> Call | None:
        """Return the next call; None where all others wait for near-exact runs."""
        while True:
            if self._several or self._single:
                return self._runs()
            if not self._waiting:
                return None
            number = self._waiting.popleft()
            sweep = self._sweep
            scene = sweep.grid.scene_at(sweep.grid.points[number])
            reference = reference_of(scene, sweep.duration, sweep.tolerance)
            if reference in self._exact:
                self._make_ready([number], self._exact[reference])
            elif reference in self._asked:
                self._asked[reference].append(number)
            else:
                self._asked[reference] = [number]
                return Call(reference, run_reference, reference)

    def take_reference(self, reference: Reference, end: Points | None) -> None:
        """Let the runs start that waited for a near-exact run."""
        self._exact[reference] = end
        self._make_ready(self._asked.pop(reference), end)

    def _make_ready(self, numbers: Iterable[int], end: Points | None) -> None:
        for number in numbers:
            (self._several if number in self._sweep.quick else self._single).append((number, end))

    def _runs(self) -> Call:
        count = min(MAX_TOGETHER, len(self._several))
        some = [self._several.popleft() for _ in range(count)] or [self._single.popleft()]
        numbers, ends = [number for number, _ in some], [end for _, end in some]
        grid, measures = self._sweep.grid, self._sweep.measures
        changes = [grid.assignments(grid.points[number]) for number in numbers]
        return Call(numbers, run_several, (self._data, changes, self._sweep.duration, measures, ends))


def sweep(
    grid: Grid,
    measures: tuple[str, ...],
    duration: float,
    workers: MakeWorkers,
    out: Path,
    console: Console,
    decimal_comma: bool = False,
) -> int:
    """Do all runs that are not done yet, and write the table and its plot.

    Ctrl-C ends it early; what is done by then is stored, and the same call resumes from there.

    Args:
        grid: the scene and what is varied.
        measures: names.
        duration: simulated time of each run, s.
        workers: makes those who compute.
        out: folder; made if its parent exists.
        console: for the progress.
        decimal_comma: whether the table has decimal commas.

    Returns:
        The exit status: 0, or 130 if it was interrupted.

    Raises:
        InputError: a scene of the grid is not valid, the folder cannot be written to or has another sweep,
            or no worker is left; what is done by then is stored.
    """
    what = Sweep(grid, measures, duration)
    # As workers will, which have no way to say that a scene is too large.
    decode_scene(encode_scene(grid.scene), grid.scene.name)
    total = len(grid.points)
    journal: Journal | None = None
    with ProgressBar(console, total) as bar:
        bar.say("checking")
        what.check()
        journal = Journal(out, what.header)
        try:
            _compute(what, journal, workers, bar)
        finally:
            journal.read()  # an interruption may have come between the disk and the memory
            write_sweep_table(out, grid, measures, journal.rows, decimal_comma)
    if journal is not None and journal.rows:
        _draw(what, journal, out)
        if journal.is_mixed:
            console.print("Rows were computed by different machines or versions; last digits may differ.")
    done = f"{len(journal.rows) if journal else 0} of {total} runs are done"
    if bar.interrupted:
        console.print(f"Interrupted: {done}; the same command goes on.")
        return 130
    console.print(f"{done} and written to {out}")
    return 0


def _compute(what: Sweep, journal: Journal, make_workers: MakeWorkers, bar: ProgressBar) -> None:
    total = len(what.grid.points)
    missing = [number for number in range(total) if number not in journal.rows]
    if not missing:
        return
    bar.say("compiling", len(journal.rows))
    # Once, here, and not by each of several processes that start at the same time.
    body = build_system(what.grid.scene).body
    for method in sorted(what.methods | ({REFERENCE} if "error" in what.measures else set())):
        fetch(all_of(method, body))
    if what.quick:
        sim.run_many([what.grid.scene_at(what.grid.points[min(what.quick)])], 0.0)
    bar.say("starting", len(journal.rows))
    with make_workers() as workers:
        for number, row in what.rows(missing, workers):
            journal.add(number, row)
            bar.say(f"{len(journal.rows)} of {total} runs", len(journal.rows))


def _draw(what: Sweep, journal: Journal, out: Path) -> None:
    # Here, not above: workers have no use for Matplotlib.
    from .plot import plot

    Figure("plot", "", lambda: plot(what.grid, what.measures, journal.rows)).write(out)
