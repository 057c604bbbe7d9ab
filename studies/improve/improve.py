"""`softrod improve`: gives the runs of a search to workers, stores their rows, and writes the best scene."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import msgspec
from rich.console import Console

import sim
from app.linking import link_to
from sim.compiling.compiler import all_of, fetch
from sim.errors import InputError, SceneError
from sim.model.system import build_system
from sim.settings import apply_assignments, setting_of
from sim.store.files import decode_scene, encode_scene, write_file

from ..reporting.progress import ProgressBar
from ..reporting.report import Figure, csv_of
from ..sweep.grid import Grid, text_of, with_unit
from ..sweep.journal import Entry, Header, Journal, digest_of
from ..sweep.runs import Row, made_by
from ..sweep.workers import Call, MakeWorkers, Workers
from .goals import Goal
from .ranges import Range
from .search import WORST, Search
from .trials import INVALID, trial

_RESULTS = 3
"""Values of a row after the settings: the result, the score, and why the run counts as worst."""

_MAX_LINK = 4000
"""Characters up to which a link is printed."""


class SearchHeader(Header, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What is searched. The number of runs is not in it: more may follow.

    Attributes:
        vary: keys and ends of the ranges.
        goal: its text.
        seed, population: of the search.
    """

    COMMAND = "improve"
    NOUN = "search"
    OPTIONS = Header.OPTIONS | {
        "goal": "--goal",
        "duration": "--for",
        "seed": "--seed",
        "population": "--population",
    }

    vary: tuple[tuple[str, float, float], ...]
    goal: str
    seed: int
    population: int

    def has(self, entry: Entry) -> bool:
        """Whether an entry can belong to one of its runs."""
        return entry.run >= 0 and len(entry.row.values) == len(self.vary) + _RESULTS


@dataclass(frozen=True)
class OptimizationProblem:
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
    def header(self) -> SearchHeader:
        """The first line of its journal."""
        scene = self.grid.scene
        return SearchHeader(
            scene=scene.name,
            digest=digest_of(scene),
            settings=self.grid.settings,
            vary=tuple((each.key, each.low, each.high) for each in self.ranges),
            goal=self.goal.text,
            duration=self.duration,
            seed=self.seed,
            population=self.population,
        )

    def unit(self, key: str) -> str:
        """Return the unit of a setting, in the scene's own unit of length; empty where it has none."""
        return self.grid.unit(key).replace("px", self.grid.scene.view.unit)

    def heading(self, key: str) -> str:
        """Return the name of a setting with its unit."""
        return with_unit(key, self.unit(key))

    @property
    def initial_scene(self) -> sim.Scene:
        """The scene with what is set in every run."""
        return apply_assignments(self.grid.scene, self.grid.settings)


@dataclass(frozen=True)
class Trial:
    """A run that is done.

    Attributes:
        number: 0 for the scene as it is.
        point: values of the settings, as texts of assignments.
        result: in the unit of the goal; None if there is none.
        score: lower is nearer to the goal; None for what counts as worst.
        ended: why it counts as worst, or "".
    """

    number: int
    point: tuple[str, ...]
    result: float | None
    score: float | None
    ended: str

    @classmethod
    def of(cls, number: int, row: Row) -> Trial:
        """Return the run of a row."""
        *point, result, score, ended = row.values
        assert result is None or isinstance(result, float)
        assert score is None or isinstance(score, float)
        return cls(number, tuple(map(str, point)), result, score, str(ended))


@dataclass(frozen=True)
class SearchResult:
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
    problem: OptimizationProblem,
    workers: MakeWorkers,
    out: Path,
    console: Console,
    decimal_comma: bool = False,
) -> SearchResult:
    """Do all runs that are not done yet, and write the best scene, a table, and a figure of the progress.

    Ctrl-C ends it early; what is done by then is stored, and the same call resumes from there. The runs are
    the same whoever computes them, in whatever order.

    Args:
        problem: what is to be improved.
        workers: makes those who compute.
        out: folder; made if its parent exists.
        console: for the progress.
        decimal_comma: whether the table has decimal commas.

    Raises:
        InputError: the scene is too large, the folder cannot be written to or has another search, or no
            worker is left; what is done by then is stored.
    """
    # As workers will, which have no way to say that a scene is too large.
    decode_scene(encode_scene(problem.grid.scene), problem.grid.scene.name)
    journal: Journal | None = None
    with ProgressBar(console, problem.runs) as bar:
        journal = Journal(out, problem.header)
        try:
            _SearchLoop(problem, journal, bar).run(workers)
        finally:
            trials = _trials(problem, journal)
            _write_table(problem, trials, out, decimal_comma)
            _write_best(problem, trials, out)
    if journal is None:
        return SearchResult({}, None, None, bar.interrupted)
    trials = _trials(problem, journal)
    draw(problem, trials, out)
    best = _best(problem, trials)
    scene = None if best is None else _scene_of(problem, best)
    if journal.is_mixed:
        console.print("Runs were computed by different machines or versions; last digits may differ.")
    return SearchResult(trials, best, scene, bar.interrupted)


class _SearchLoop:
    """Asks the search for generations, and has them computed."""

    def __init__(self, problem: OptimizationProblem, journal: Journal, bar: ProgressBar) -> None:
        self._problem, self._journal, self._bar = problem, journal, bar
        self._data = encode_scene(problem.grid.scene)
        scene = problem.initial_scene
        values = [float(setting_of(scene, each.key).read(scene)) for each in problem.ranges]
        places = [each.place(value) for each, value in zip(problem.ranges, values, strict=True)]
        self._initial = tuple(map(text_of, values))
        self._start = [0.5 if place is None else place for place in places]

    def run(self, make_workers: MakeWorkers) -> None:
        """Do the runs that are missing."""
        problem, rows = self._problem, self._journal.rows
        search = Search(self._start, problem.population, problem.seed)
        points, number = {0: self._initial}, 1
        with ExitStack() as stack:
            workers: Workers | None = None
            while True:
                asked = search.ask()
                numbers = range(number, number + len(asked))
                for n, places in zip(numbers, asked, strict=True):
                    points[n] = tuple(e.at(place) for e, place in zip(problem.ranges, places, strict=True))
                missing = self._missing({n: point for n, point in points.items() if n < problem.runs})
                if missing and workers is None:
                    workers = self._workers(stack, make_workers)
                if missing and workers is not None:
                    self._do(missing, workers)
                number = numbers.stop
                if number >= problem.runs:
                    return
                scores = (Trial.of(n, rows[n]).score for n in numbers)
                search.tell([WORST if score is None else score for score in scores])
                points = {}

    def _workers(self, stack: ExitStack, make_workers: MakeWorkers) -> Workers:
        self._say("compiling")
        # Once, here, and not by each of several processes that start at the same time.
        scene = self._problem.initial_scene
        fetch(all_of(scene.integrator.method, build_system(scene).body))
        self._say("starting")
        return stack.enter_context(make_workers())

    def _missing(self, points: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """Return those of some runs that have to be computed.

        Raises:
            InputError: a run that is done has other settings than the search asks for.
        """
        rows, missing = self._journal.rows, {}
        # Whole numbers come again and again.
        known = {tuple(row.values[:-_RESULTS]): row for n, row in rows.items() if n}
        for number, point in points.items():
            if number in rows:
                if rows[number].values[:-_RESULTS] != point:
                    raise InputError(
                        f"--out {self._journal.out}: run {number} has other settings than this search asks "
                        f"for, since it was computed by {rows[number].by}; use another folder"
                    )
            elif number and point in known:
                self._journal.add(number, known[point])
            else:
                missing[number] = point
        return missing

    def _do(self, points: dict[int, tuple[str, ...]], workers: Workers) -> None:
        """Do some runs, and store each as soon as it is done."""
        waiting = deque(points)

        def next_call() -> Call | None:
            while waiting:
                number = waiting.popleft()
                if (call := self._call(number, points[number])) is not None:
                    return call
                self._store(number, points[number], Row((None, None, INVALID), made_by()))
            return None

        with workers.losing("improve"):
            for number, row in workers.compute(next_call):
                self._store(number, points[number], row)

    def _call(self, number: int, point: tuple[str, ...]) -> Call | None:
        """Return the call of a run; None if its scene is not valid."""
        problem = self._problem
        assignments = problem.grid.settings
        if number:  # the scene as it is may have settings that differ from part to part
            try:
                problem.grid.scene_at(point)
            except InputError:
                return None
            assignments = problem.grid.assignments(point)
        return Call(number, trial, (self._data, assignments, problem.duration, problem.goal))

    def _store(self, number: int, point: tuple[str, ...], row: Row) -> None:
        self._journal.add(number, Row((*point, *row.values), row.by))
        self._say("searching")

    def _say(self, what: str) -> None:
        """Show how many runs are done, with the best result so far."""
        done, problem = len(self._journal.rows), self._problem
        best = _best(problem, _trials(problem, self._journal))
        found = "" if best is None else f", best {shown(best.result, problem.goal.unit)}"
        self._bar.say(f"{what}: {done} of {problem.runs} runs{found}", done)


# ------------------------------------------------------------------------- what was found
def _trials(problem: OptimizationProblem, journal: Journal) -> dict[int, Trial]:
    """Return the runs that are done, by number, without those of a longer search."""
    return {n: Trial.of(n, journal.rows[n]) for n in sorted(journal.rows) if n < problem.runs}


def _best(problem: OptimizationProblem, trials: Mapping[int, Trial]) -> Trial | None:
    """Return the first run with the lowest score; the scene as it is counts only if it is in all ranges."""
    within = (trial for trial in trials.values() if trial.number or _is_within(problem.ranges, trial.point))
    scored = [(trial.score, trial.number) for trial in within if trial.score is not None]
    return trials[min(scored)[1]] if scored else None


def _is_within(ranges: Iterable[Range], point: Iterable[str]) -> bool:
    return all(each.low <= float(text) <= each.high for each, text in zip(ranges, point, strict=True))


def _scene_of(problem: OptimizationProblem, best: Trial) -> sim.Scene:
    """Return the scene of a run, without its lesson, whose first step would reset the settings."""
    scene = problem.grid.scene_at(best.point) if best.number else problem.initial_scene
    name = f"{scene.name[:50]}-improved"
    title = f"{(scene.title or scene.name)[:50]}, improved"
    found = f"Improved for the goal {problem.goal.text!r}, in runs of {problem.duration:g} s."
    text = f"{scene.description} {found}".strip()
    description = text if len(text) <= 2000 else scene.description
    return msgspec.structs.replace(scene, name=name, title=title, description=description, lesson=None)


def shown(result: float | None, unit: str) -> str:
    """Return a result for people."""
    return "not reached" if result is None else f"{result:.6g} {unit}".rstrip()


def _result_heading(goal: Goal) -> str:
    return with_unit(goal.result, goal.unit)


def _write_table(
    problem: OptimizationProblem, trials: Mapping[int, Trial], out: Path, decimal_comma: bool
) -> None:
    """Write `table.csv`: a row for each run that is done."""
    keys = (problem.heading(each.key) for each in problem.ranges)
    headings = ["run", *keys, _result_heading(problem.goal), "counts as worst"]
    rows = ([trial.number, *map(float, trial.point), trial.result, trial.ended] for trial in trials.values())
    write_file(out / "table.csv", csv_of(headings, rows, decimal_comma).encode())


def _write_best(problem: OptimizationProblem, trials: Mapping[int, Trial], out: Path) -> None:
    """Write `best.json` and `link.txt`, if any run does not count as worst."""
    best = _best(problem, trials)
    if best is None:
        return
    scene = _scene_of(problem, best)
    sim.save_scene(scene, out / "best.json")
    try:
        link = link_to(scene)
    except SceneError:
        return  # it is too large for a link, and the file is there
    write_file(out / "link.txt", f"{link}\n".encode())


def draw(problem: OptimizationProblem, trials: Mapping[int, Trial], out: Path) -> None:
    """Write the figure of all runs."""
    # Here, not above: workers have no use for Matplotlib.
    from .plot import plot

    best = _best(problem, trials)
    done = list(trials.values())
    at = next((i for i, trial in enumerate(done) if trial is best), None)
    settings = [
        (problem.heading(each.key), each, [float(trial.point[i]) for trial in done])
        for i, each in enumerate(problem.ranges)
    ]
    results, scores = [trial.result for trial in done], [trial.score for trial in done]
    if done:
        heading = _result_heading(problem.goal)
        Figure("progress", "", lambda: plot(heading, results, scores, settings, at)).write(out)


def print_result(problem: OptimizationProblem, result: SearchResult, out: Path, console: Console) -> int:
    """Print what a search has found.

    Returns:
        The exit status: 0, 130 if it was interrupted, or 1 if all runs count as worst.
    """
    trials, best, goal = result.trials, result.best, problem.goal
    worst = Counter(trial.ended for trial in trials.values() if trial.ended)
    if worst:
        listed = ", ".join(f"{count} {ended}" for ended, count in worst.items())
        console.print(f"Of {len(trials)} runs these count as worst: {listed}.", highlight=False)
    if best is None:
        what = "Interrupted: no" if result.interrupted else "No"
        console.print(f"{what} run came to a result; {out / 'table.csv'} has them all.", highlight=False)
        return 130 if result.interrupted else 1
    start, found = trials.get(0), shown(best.result, goal.unit)
    if not best.number:
        found += "; nothing better than the scene as it is was found"
    elif best.result is None:
        found += " in any run, and this is the nearest"
    elif start and not start.ended:
        found += f"; {shown(start.result, goal.unit)} with the scene as it is"
    console.print(f"{goal.result}: {found}", soft_wrap=True, highlight=False, markup=False)
    for each, text in zip(problem.ranges, best.point, strict=True):
        unit = problem.unit(each.key)
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
    if result.interrupted:
        console.print(
            f"Interrupted: {len(trials)} of {problem.runs} runs are done; the same command goes on."
        )
        return 130
    return 0
