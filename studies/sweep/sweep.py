"""`softrod sweep`: the loop that gives runs to workers and keeps what comes back."""

from __future__ import annotations

import concurrent.futures
import math
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from rich.console import Console

import sim
from sim.compiling.compiler import all_of, fetch
from sim.methods.registry import METHODS
from sim.store.files import decode_scene, encode_scene

from ..reporting.output import Watch, write_figures
from .folder import Folder, make_plan
from .grid import Grid
from .runs import REFERENCE, Points, Reference, Row, is_quick, reference_of, run_reference, run_several
from .workers import Making, Workers

TOGETHER = 64
"""Runs of one call, where one does several."""


@dataclass
class Sweep:
    """What is swept.

    Attributes:
        grid: the scene and what is varied.
        measures: names.
        duration: simulated time of each run, s.
        quick: once `check` has looked, the numbers of the runs that are quick, see `is_quick`.
        methods: then the names of the methods of all others.
        tolerance: then the smallest one of a method that has one, px; infinite where none has.
    """

    grid: Grid
    measures: tuple[str, ...]
    duration: float
    quick: set[int] = field(default_factory=set)
    methods: set[str] = field(default_factory=set)
    tolerance: float = math.inf

    def check(self) -> None:
        """Look at the scene of every run.

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
        """Do the runs of these numbers, and give each with its row, in the order in which they are done.

        The near-exact run that several have in common is done once, before them.

        Raises:
            InputError: no worker is left.
        """
        data = encode_scene(self.grid.scene)
        waiting, ready = deque(missing), _Ready(self.quick)
        if "error" not in self.measures:
            ready.add(waiting, None)
            waiting.clear()
        exact: dict[Reference, Points | None] = {}
        asked: dict[Reference, list[int]] = {}
        running: dict[concurrent.futures.Future, list[int] | Reference] = {}
        submit = workers.executor.submit
        with workers.losing("sweep"):
            while waiting or ready or running:
                while (waiting or ready) and len(running) < workers.ahead:
                    if ready:
                        numbers, ends = ready.take()
                        changes = [self.grid.assignments(self.grid.points[number]) for number in numbers]
                        call = submit(run_several, data, changes, self.duration, self.measures, ends)
                        running[call] = numbers
                    else:
                        number = waiting.popleft()
                        scene = self.grid.scene_at(self.grid.points[number])
                        reference = reference_of(scene, self.duration, self.tolerance)
                        if reference in exact:
                            ready.add([number], exact[reference])
                        elif reference in asked:
                            asked[reference].append(number)
                        else:
                            asked[reference] = [number]
                            running[submit(run_reference, *reference)] = reference
                done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
                for call in done:
                    what = running.pop(call)
                    if isinstance(what, list):
                        yield from zip(what, call.result(), strict=True)
                    else:
                        exact[what] = call.result()
                        ready.add(asked.pop(what), exact[what])


class _Ready:
    """The runs that wait for nothing but somebody to do them, each with the end of its near-exact run.

    Args:
        quick: the numbers of those of which a call does several.
    """

    def __init__(self, quick: set[int]) -> None:
        self._quick = quick
        self._several: deque[tuple[int, Points | None]] = deque()
        self._single: deque[tuple[int, Points | None]] = deque()

    def __len__(self) -> int:
        return len(self._several) + len(self._single)

    def add(self, numbers: Iterable[int], end: Points | None) -> None:
        """Put in some runs."""
        for number in numbers:
            (self._several if number in self._quick else self._single).append((number, end))

    def take(self) -> tuple[list[int], list[Points | None]]:
        """Take out the runs of a call: their numbers, and their ends."""
        if self._several:
            some = [self._several.popleft() for _ in range(min(TOGETHER, len(self._several)))]
        else:
            some = [self._single.popleft()]
        return [number for number, _ in some], [end for _, end in some]


def sweep(
    grid: Grid,
    measures: tuple[str, ...],
    duration: float,
    workers: Making,
    out: Path,
    console: Console,
    decimal_comma: bool = False,
) -> int:
    """Do all runs that are not done yet, and write the table and its plot.

    Ctrl-C ends it early; what is done by then is kept, and the same call goes on from there.

    Args:
        grid: the scene and what is varied.
        measures: names.
        duration: simulated time of each run, s.
        workers: makes those who compute.
        out: folder; made if its parent exists.
        console: where the progress goes.
        decimal_comma: whether the table has decimal commas.

    Returns:
        The exit status: 0, or 130 if it was interrupted.

    Raises:
        InputError: a scene of the grid is not valid, the folder cannot be written to or has another sweep,
            or no worker is left; what is done by then is kept.
    """
    what = Sweep(grid, measures, duration)
    # As workers will, which have no way to say that a scene is too large.
    decode_scene(encode_scene(grid.scene), grid.scene.name)
    total = len(grid.points)
    folder: Folder | None = None
    with Watch(console, total) as watch:
        watch.say("checking")
        what.check()
        folder = Folder(out, make_plan(grid, measures, duration))
        try:
            _compute(what, folder, workers, watch)
        finally:
            folder.write_table(grid, measures, decimal_comma)
    if folder is not None and folder.rows:
        _draw(what, folder, out)
        if len({row.by for row in folder.rows.values()}) > 1:
            console.print("Rows were computed by different machines or versions; last digits may differ.")
    done = f"{len(folder.rows) if folder else 0} of {total} runs are done"
    if watch.interrupted:
        console.print(f"Interrupted: {done}; the same command goes on.")
        return 130
    console.print(f"{done} and written to {out}")
    return 0


def _compute(what: Sweep, folder: Folder, making: Making, watch: Watch) -> None:
    total = len(what.grid.points)
    missing = [number for number in range(total) if number not in folder.rows]
    if not missing:
        return
    watch.say("compiling", len(folder.rows))
    # Once, here, and not by each of several processes that start at the same time.
    for method in sorted(what.methods | ({REFERENCE} if "error" in what.measures else set())):
        fetch(all_of(method))
    if what.quick:
        sim.run_many([what.grid.scene_at(what.grid.points[min(what.quick)])], 0.0)
    watch.say("starting", len(folder.rows))
    with making() as workers:
        for number, row in what.rows(missing, workers):
            folder.add(number, row)
            watch.say(f"{len(folder.rows)} of {total} runs", len(folder.rows))


def _draw(what: Sweep, folder: Folder, out: Path) -> None:
    # Here, not above: workers have no use for Matplotlib.
    from .plot import plot

    write_figures(out, {"plot": ("", lambda: plot(what.grid, what.measures, folder.rows))})
