"""`softrod improve`: the loop that gives a search's runs to workers, keeps what comes back, and the best."""

from __future__ import annotations

import concurrent.futures
from collections import Counter, deque
from collections.abc import Iterable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import msgspec
from rich.console import Console

import sim
from app.linking import link_to
from sim.compiling.compiler import all_of, fetch
from sim.errors import InputError, SceneError
from sim.settings import apply_assignments, setting_of
from sim.store.files import decode_scene, encode_scene, write_file

from ..reporting.output import Watch, comma_separated, write_figures
from ..sweep.grid import Grid, text_of
from ..sweep.kept import KeptRows, Line, digest_of
from ..sweep.runs import Row, made_by
from ..sweep.workers import Making, Workers
from .goals import Goal
from .ranges import Range
from .search import WORST, Search
from .trials import INVALID, trial

_ENDINGS = 3
"""Values of a row after the settings: the result, the score, and how the run ended."""

_MAX_LINK = 4000
"""Characters up to which a link is printed."""


class Plan(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is searched; see `studies.sweep.kept.Plan`. The number of runs is not in it: more may follow.

    Attributes:
        scene, digest: name of the scene, and BLAKE2b of it.
        settings: assignments that hold in every run.
        vary: keys and ends of the ranges.
        goal: its text.
        duration: of a run, s.
        seed, population: of the search.
        version: of the file's format.
    """

    COMMAND: ClassVar[str] = "improve"
    WORD: ClassVar[str] = "search"
    OPTIONS: ClassVar[Mapping[str, str]] = {
        "scene": "SCENE",
        "digest": "SCENE",
        "settings": "--set",
        "vary": "--vary",
        "goal": "--goal",
        "duration": "--for",
        "seed": "--seed",
        "population": "--population",
        "version": "softrod",
    }

    scene: str
    digest: str
    settings: tuple[str, ...]
    vary: tuple[tuple[str, float, float], ...]
    goal: str
    duration: float
    seed: int
    population: int
    version: int = 1

    def fits(self, line: Line) -> bool:
        """Whether a line can be of one of its runs."""
        return line.run >= 0 and len(line.row.values) == len(self.vary) + _ENDINGS


@dataclass(frozen=True)
class Wanted:
    """What is to be improved.

    Attributes:
        grid: the scene, what is set in every run, and the ends of the ranges.
        ranges: what is varied.
        goal: of the scene.
        duration: simulated time of each run, s.
        runs: how many, with that of the scene as it is.
        population: runs of the first generations, which are computed at the same time.
        seed: of the search's random numbers.
    """

    grid: Grid
    ranges: tuple[Range, ...]
    goal: Goal
    duration: float
    runs: int
    population: int
    seed: int

    @property
    def plan(self) -> Plan:
        """What goes on."""
        scene = self.grid.scene
        vary = tuple((each.key, each.low, each.high) for each in self.ranges)
        return Plan(
            scene.name, digest_of(scene), self.grid.settings, vary, self.goal.text, self.duration, self.seed,
            self.population,
        )  # fmt: skip

    def unit(self, key: str) -> str:
        """The unit of a setting, in the scene's own unit of length; empty where it has none."""
        return self.grid.unit(key).replace("px", self.grid.scene.view.unit)

    @property
    def as_it_is(self) -> sim.Scene:
        """The scene with what is set in every run."""
        return apply_assignments(self.grid.scene, self.grid.settings)


@dataclass(frozen=True)
class Trial:
    """A run that is done.

    Attributes:
        number: 0 for the scene as it is.
        point: values of the settings, as assignments have them.
        result: in the unit of the goal; None where there is none.
        score: the less, the nearer to the goal; None for what counts as worst.
        ended: why it counts as worst, or "".
    """

    number: int
    point: tuple[str, ...]
    result: float | None
    score: float | None
    ended: str

    @classmethod
    def of(cls, number: int, row: Row) -> Trial:
        """The run of a row."""
        *point, result, score, ended = row.values
        assert result is None or isinstance(result, float)
        assert score is None or isinstance(score, float)
        return cls(number, tuple(map(str, point)), result, score, str(ended))


@dataclass(frozen=True)
class Improved:
    """What a search has found.

    Attributes:
        trials: all runs that are done, by number.
        best: the one that came nearest to the goal; None where all count as worst.
        scene: the scene of that run; None without one.
        interrupted: whether Ctrl-C ended it early.
    """

    trials: dict[int, Trial]
    best: Trial | None
    scene: sim.Scene | None
    interrupted: bool


def improve(
    wanted: Wanted, workers: Making, out: Path, console: Console, decimal_comma: bool = False
) -> Improved:
    """Do all runs that are not done yet, and write the best scene, a table, and a figure of the progress.

    Ctrl-C ends it early; what is done by then is kept, and the same call goes on from there. The runs are the
    same whoever computes them, in whatever order.

    Args:
        wanted: what is to be improved.
        workers: makes those who compute.
        out: folder; made if its parent exists.
        console: where the progress goes.
        decimal_comma: whether the table has decimal commas.

    Raises:
        InputError: the scene is too large, the folder cannot be written to or has another search, or no
            worker is left; what is done by then is kept.
    """
    # As workers will, which have no way to say that a scene is too large.
    decode_scene(encode_scene(wanted.grid.scene), wanted.grid.scene.name)
    folder: KeptRows | None = None
    with Watch(console, wanted.runs) as watch:
        folder = KeptRows(out, wanted.plan)
        try:
            _Hunt(wanted, folder, watch).run(workers)
        finally:
            trials = _trials(wanted, folder)
            _write_table(wanted, trials, out, decimal_comma)
            _write_best(wanted, trials, out)
    if folder is None:
        return Improved({}, None, None, watch.interrupted)
    trials = _trials(wanted, folder)
    draw(wanted, trials, out)
    best = _best(wanted, trials)
    scene = None if best is None else _scene_of(wanted, best)
    if len({row.by for row in folder.rows.values()}) > 1:
        console.print("Runs were computed by different machines or versions; last digits may differ.")
    return Improved(trials, best, scene, watch.interrupted)


class _Hunt:
    """The loop of a search."""

    def __init__(self, wanted: Wanted, folder: KeptRows, watch: Watch) -> None:
        self._wanted, self._folder, self._watch = wanted, folder, watch
        self._data = encode_scene(wanted.grid.scene)
        scene = wanted.as_it_is
        values = [float(setting_of(scene, each.key).read(scene)) for each in wanted.ranges]
        places = [each.place(value) for each, value in zip(wanted.ranges, values, strict=True)]
        self._own = tuple(map(text_of, values))
        self._start = [0.5 if place is None else place for place in places]

    def run(self, making: Making) -> None:
        """Do the runs that are missing."""
        wanted, rows = self._wanted, self._folder.rows
        search = Search(self._start, wanted.population, wanted.seed)
        points, number = {0: self._own}, 1
        with ExitStack() as stack:
            workers: Workers | None = None
            while True:
                asked = search.ask()
                numbers = range(number, number + len(asked))
                for n, places in zip(numbers, asked, strict=True):
                    points[n] = tuple(e.at(place) for e, place in zip(wanted.ranges, places, strict=True))
                missing = self._missing({n: point for n, point in points.items() if n < wanted.runs})
                if missing and workers is None:
                    workers = self._workers(stack, making)
                if missing and workers is not None:
                    self._do(missing, workers)
                number = numbers.stop
                if number >= wanted.runs:
                    return
                scores = (Trial.of(n, rows[n]).score for n in numbers)
                search.tell([WORST if score is None else score for score in scores])
                points = {}

    def _workers(self, stack: ExitStack, making: Making) -> Workers:
        self._say("compiling")
        # Once, here, and not by each of several processes that start at the same time.
        fetch(all_of(self._wanted.as_it_is.integrator.method))
        self._say("starting")
        return stack.enter_context(making())

    def _missing(self, points: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """Those of some runs that have to be computed.

        Raises:
            InputError: a run that is done is of another place than the search asks for.
        """
        rows, missing = self._folder.rows, {}
        # Whole numbers come again and again.
        known = {tuple(row.values[:-_ENDINGS]): row for n, row in rows.items() if n}
        for number, point in points.items():
            if number in rows:
                if rows[number].values[:-_ENDINGS] != point:
                    raise InputError(
                        f"--out {self._folder.out}: run {number} has other settings than this search asks "
                        f"for, since it was computed by {rows[number].by}; begin anew in another folder"
                    )
            elif number and point in known:
                self._folder.add(number, known[point])
            else:
                missing[number] = point
        return missing

    def _do(self, points: dict[int, tuple[str, ...]], workers: Workers) -> None:
        """Do some runs, and keep each as soon as it is done."""
        wanted, waiting = self._wanted, deque(points)
        running: dict[concurrent.futures.Future[Row], int] = {}
        with workers.losing("improve"):
            while waiting or running:
                while waiting and len(running) < workers.ahead:
                    number = waiting.popleft()
                    point = points[number]
                    try:
                        if number:
                            wanted.grid.scene_at(point)
                    except InputError:
                        self._keep(number, point, Row((None, None, INVALID), made_by()))
                        continue
                    # The scene as it is may have settings that differ from part to part.
                    assignments = wanted.grid.assignments(point) if number else wanted.grid.settings
                    call = workers.executor.submit(
                        trial, self._data, assignments, wanted.duration, wanted.goal
                    )
                    running[call] = number
                done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
                for call in done:
                    number = running.pop(call)
                    self._keep(number, points[number], call.result())

    def _keep(self, number: int, point: tuple[str, ...], row: Row) -> None:
        self._folder.add(number, Row((*point, *row.values), row.by))
        self._say("searching")

    def _say(self, what: str) -> None:
        """Say how far it is, with the best until now."""
        done, wanted = len(self._folder.rows), self._wanted
        best = _best(wanted, _trials(wanted, self._folder))
        found = "" if best is None else f", best {shown(best.result, wanted.goal.unit)}"
        self._watch.say(f"{what}: {done} of {wanted.runs} runs{found}", done)


# ------------------------------------------------------------------------- what was found
def _trials(wanted: Wanted, folder: KeptRows) -> dict[int, Trial]:
    """The runs that are done, in the order of their numbers; without those of a longer search."""
    return {n: Trial.of(n, folder.rows[n]) for n in sorted(folder.rows) if n < wanted.runs}


def _best(wanted: Wanted, trials: Mapping[int, Trial]) -> Trial | None:
    """The run with the least score, the first of several; the scene as it is only if it is in all ranges."""
    within = (trial for trial in trials.values() if trial.number or _is_within(wanted.ranges, trial.point))
    fine = [(trial.score, trial.number) for trial in within if trial.score is not None]
    return trials[min(fine)[1]] if fine else None


def _is_within(ranges: Iterable[Range], point: Iterable[str]) -> bool:
    return all(each.low <= float(text) <= each.high for each, text in zip(ranges, point, strict=True))


def _scene_of(wanted: Wanted, best: Trial) -> sim.Scene:
    """The scene of a run. It has no lesson, whose first step would set the settings back."""
    scene = wanted.grid.scene_at(best.point) if best.number else wanted.as_it_is
    name = f"{scene.name[:50]}-improved"
    title = f"{(scene.title or scene.name)[:50]}, improved"
    found = f"Improved for the goal {wanted.goal.text!r}, in runs of {wanted.duration:g} s."
    text = f"{scene.description} {found}".strip()
    description = text if len(text) <= 2000 else scene.description
    return msgspec.structs.replace(scene, name=name, title=title, description=description, lesson=None)


def shown(result: float | None, unit: str) -> str:
    """A result for people."""
    return "not reached" if result is None else f"{result:.6g} {unit}".rstrip()


def _heading(wanted: Wanted, key: str) -> str:
    """The name of a setting with its unit."""
    unit = wanted.unit(key)
    return f"{key} [{unit}]" if unit else key


def _result_heading(goal: Goal) -> str:
    return f"{goal.result} [{goal.unit}]" if goal.unit else goal.result


def _write_table(wanted: Wanted, trials: Mapping[int, Trial], out: Path, decimal_comma: bool) -> None:
    """Write `table.csv`: a row for each run that is done."""
    keys = (_heading(wanted, each.key) for each in wanted.ranges)
    headings = ["run", *keys, _result_heading(wanted.goal), "counts as worst"]
    rows = ([trial.number, *map(float, trial.point), trial.result, trial.ended] for trial in trials.values())
    write_file(out / "table.csv", comma_separated(headings, rows, decimal_comma).encode())


def _write_best(wanted: Wanted, trials: Mapping[int, Trial], out: Path) -> None:
    """Write `best.json` and `link.txt`, if any run does not count as worst."""
    best = _best(wanted, trials)
    if best is None:
        return
    scene = _scene_of(wanted, best)
    sim.save_scene(scene, out / "best.json")
    try:
        link = link_to(scene)
    except SceneError:
        return  # it is too large for a link, and the file is there
    write_file(out / "link.txt", f"{link}\n".encode())


def draw(wanted: Wanted, trials: Mapping[int, Trial], out: Path) -> None:
    """Write the figure of all runs."""
    # Here, not above: workers have no use for Matplotlib.
    from .plot import plot

    best = _best(wanted, trials)
    done = list(trials.values())
    at = next((i for i, trial in enumerate(done) if trial is best), None)
    settings = [
        (_heading(wanted, each.key), each, [float(trial.point[i]) for trial in done])
        for i, each in enumerate(wanted.ranges)
    ]
    results, scores = [trial.result for trial in done], [trial.score for trial in done]
    if done:
        drawing = lambda: plot(_result_heading(wanted.goal), results, scores, settings, at)  # noqa: E731
        write_figures(out, {"progress": ("", drawing)})


def tell(wanted: Wanted, improved: Improved, out: Path, console: Console) -> int:
    """Print what a search has found.

    Returns:
        The exit status: 0, 130 if it was interrupted, or 1 if all runs count as worst.
    """
    trials, best, goal = improved.trials, improved.best, wanted.goal
    worst = Counter(trial.ended for trial in trials.values() if trial.ended)
    if worst:
        listed = ", ".join(f"{count} {ended}" for ended, count in worst.items())
        console.print(f"Of {len(trials)} runs these count as worst: {listed}.", highlight=False)
    if best is None:
        what = "Interrupted: no" if improved.interrupted else "No"
        console.print(f"{what} run came to a result; {out / 'table.csv'} has them all.", highlight=False)
        return 130 if improved.interrupted else 1
    start, found = trials.get(0), shown(best.result, goal.unit)
    if not best.number:
        found += "; nothing better than the scene as it is was found"
    elif best.result is None:
        found += " in any run, and this is the nearest"
    elif start and not start.ended:
        found += f"; {shown(start.result, goal.unit)} with the scene as it is"
    console.print(f"{goal.result}: {found}", soft_wrap=True, highlight=False, markup=False)
    for each, text in zip(wanted.ranges, best.point, strict=True):
        unit = wanted.unit(each.key)
        end = each.end(float(text))
        note = f", the {end} end of its range" if end else ""
        console.print(f"  {each.key} = {shown(float(text), unit)}{note}", highlight=False, markup=False)
    console.print(f"Run {best.number} of {len(trials)} is the best, in {out / 'best.json'}", highlight=False)
    link = out / "link.txt"
    text = link.read_text().strip() if link.exists() else ""
    if text and len(text) <= _MAX_LINK:
        console.print(text, soft_wrap=True, highlight=False, markup=False)
    elif text:
        console.print(f"Its link has {len(text)} characters and is in {link}", highlight=False)
    if improved.interrupted:
        console.print(f"Interrupted: {len(trials)} of {wanted.runs} runs are done; the same command goes on.")
        return 130
    return 0
