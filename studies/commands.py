"""The commands of studies: `softrod bench`, `validate`, `stability`, `study`, `sweep`, `improve` and `fit`.

Each imports what it needs when it runs.
"""

from __future__ import annotations

import importlib
import math
import os
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated

from rich.console import Console
from tyro.conf import Positional, UseAppendAction, arg
from tyro.extras import literal_type_from_choices

import sim
from app.command import CsvComma, Settings, fail, scene_of
from sim.design.residuals import OF_MEASUREMENT
from sim.errors import InputError

from .sweep.measures import MEASURES, parse_measures
from .sweep.workers import MakeWorkers

BENCHES = {
    "kernels": "kernels",
    "growth": "growth",
    "many": "many",
    "heap": "heap",
    "frames": "frames",
    "matrices": "matrices",
    "compile": "compiling",
    "start": "serving",
    "page": "serving",
    "tabs": "tabs",
    "class": "classroom",
    "edit": "editing",
}
"""The module of each benchmark, which has a function bench_NAME; `peers` has options of its own."""

_BENCH_NAMES = (*BENCHES, "peers")


@dataclass
class Bench:
    """Measure softrod on this machine, and other programs that do the same."""

    what: Annotated[
        Positional[str],
        arg(constructor=literal_type_from_choices(_BENCH_NAMES), metavar=f"{{{','.join(_BENCH_NAMES)}}}"),
    ]
    """kernels: the step by several programs; growth: the step as the body grows; many: a thousand small
    bodies, and a call for one; heap: rings that fall into a heap; frames: time and error of a rod led in
    a circle, and time of one torn to and fro; matrices: what implicit steps of any topology factorise;
    compile: processor time of compiling; start: until each preset moves, and until all is compiled; page:
    cost and latency; tabs: many pages at once; class: pupils who follow or have a body each, and what
    cuts, reloads and a restart do to their answers; edit: of one part of a large body; peers: other
    engines and solvers on the same scenes (uv sync --extra peers installs them)."""
    repeats: int = 5
    """Repeats; the fastest counts."""
    scenes: str = ""
    """For peers: names of its scenes, separated by commas; without any, all."""
    engines: str = ""
    """For peers: names of engines and solvers, separated by commas; without any, all."""
    quick: bool = False
    """For peers: a few scenes, fewer repeats."""
    out: Path | None = None
    """For peers: folder for the report: peers.md, peers.csv.gz and figures."""

    def run(self) -> int:
        """Measure and print."""
        if not 1 <= self.repeats <= 1000:
            return fail("--repeats: it must be from 1 to 1000")
        if self.what == "peers":
            from .compare.peers import bench_peers

            return bench_peers(self.scenes, self.engines, self.quick, self.repeats, self.out, Console())
        if self.scenes or self.engines or self.quick or self.out is not None:
            return fail("--scenes, --engines, --quick and --out belong to softrod bench peers")
        # Only the one that is asked for: some of the others load the page.
        module = importlib.import_module(f"studies.bench.{BENCHES[self.what]}")
        getattr(module, f"bench_{self.what}")(Console(), self.repeats)
        return 0


@dataclass
class Validate:
    """Compare the solver with exact results; the exit status is 1 if a target is missed."""

    out: Path | None = None
    """Folder for the report: validate.md, validate.csv.gz and figures."""
    fast: bool = False
    """Leave out what takes long."""

    def run(self) -> int:
        """Compute, print and write."""
        from .validate.validate import validate

        return validate(self.out, self.fast, Console())


@dataclass
class Stability:
    """Map where each integrator breaks, over two numbers of a scene, or run them all on hard cases."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = "tutorial-3.1"
    """A preset's name, a file's path or a link."""
    out: Path = Path("stability")
    """Folder for the report: stability.md, stability.csv.gz and maps, or hard-cases.md, hard-cases.csv.gz."""
    x: str | None = None
    """What varies from left to right: dt, stiffness, damping, angular_stiffness, angular_damping,
    air_friction, mass_ratio (of one mass to the next) or masses. Five maps unless --x and --y are given."""
    y: str | None = None
    """What varies from bottom to top."""
    x_range: str | None = None
    """From and to, as in 1e-4,0.05; scales are logarithmic."""
    y_range: str | None = None
    """The same for --y."""
    size: int = 64
    """Cells along each side, 2 to 512."""
    integrators: str | None = None
    """Names, separated by commas; all that have a fixed step unless given."""
    duration: float = 1.0
    """Simulated seconds of each cell."""
    hard_cases: bool = False
    """Run every integrator on the hard cases instead."""
    settings: Settings = ()

    def run(self) -> int:
        """Compute, print and write."""
        from .stability.axes import AXES
        from .stability.hard_case_report import hard_case_report
        from .stability.stability import stability

        if self.hard_cases:
            return hard_case_report(self.out, Console())
        if (self.x is None) != (self.y is None):
            return fail("stability: --x and --y belong together")
        for name, key in (("--x", self.x), ("--y", self.y)):
            if key is not None and key not in AXES:
                return fail(f"{name}: {key!r} is not one of {', '.join(AXES)}")
        if self.x is None and (self.x_range is not None or self.y_range is not None):
            return fail("stability: --x-range and --y-range need --x and --y")
        if not 2 <= self.size <= 512:
            return fail(f"--size: {self.size} is not in the range 2..512")
        if not 0.01 <= self.duration <= 100.0:
            return fail(f"--duration: {self.duration:g} is not in the range 0.01..100 s")
        ranges = _range("--x-range", self.x_range), _range("--y-range", self.y_range)
        axes = (self.x, self.y) if self.x is not None and self.y is not None else None
        methods = [name.strip() for name in self.integrators.split(",")] if self.integrators else []
        scene = scene_of(self.scene, self.settings)
        return stability(scene, axes, ranges, self.size, methods, self.duration, self.out, Console())


def _range(name: str, text: str | None) -> tuple[float, float] | None:
    """Return two numbers from a text with a comma between them.

    Raises:
        InputError: it is something else.
    """
    if text is None:
        return None
    try:
        low, high = (float(part) for part in text.split(","))
    except ValueError:
        low = high = math.nan
    if not (math.isfinite(low) and math.isfinite(high)):
        raise InputError(f"{name} {text}: two finite numbers with a comma between them are expected")
    return low, high


@dataclass
class Study:
    """Measure computing time against error, of softrod's methods and of SciPy's and CVODE."""

    out: Path
    """Folder for the report: study.md, study.csv.gz, bodies.csv.gz and figures."""
    scenes: Annotated[Positional[tuple[str, ...]], arg(metavar="SCENE")] = ()
    """Presets' names or files' paths; without any, the presets of the group study."""
    integrators: str = ""
    """Methods, separated by commas; without any, all there are, the other solvers among them."""
    errors: str = "1,0.1,1e-3,1e-6"
    """Errors to ask about, px, separated by commas."""
    random: int = 0
    """Number of random bodies on which the errors of auto are compared with its tolerance."""

    def run(self) -> int:
        """Measure, print and write."""
        from .compare.study import parse_errors, parse_integrators, study, study_scenes

        if not 0 <= self.random <= 100_000:
            return fail(f"--random: {self.random} is not in the range 0..100000")
        scenes = [(scene.name, scene) for scene in map(sim.load_scene, self.scenes or study_scenes())]
        integrators, errors = parse_integrators(self.integrators), parse_errors(self.errors)
        return study(scenes, integrators, errors, self.random, self.out, Console())


Jobs = Annotated[
    int | None, arg(help="processes that compute at the same time; one for each core unless given")
]
Cluster = Annotated[
    str | None,
    arg(help="address of a Dask scheduler whose workers compute instead, as in tcp://host:8786"),
]


def workers_for(jobs: int | None, address: str | None) -> MakeWorkers:
    """Return what makes the workers that `--jobs` and `--cluster` ask for.

    Raises:
        InputError: the number of processes makes no sense.
    """
    from .sweep.workers import cluster, processes, this_process

    if jobs is not None and not 1 <= jobs <= 1000:
        raise InputError(f"--jobs: {jobs} is not in the range 1..1000")
    if jobs is not None and address is not None:
        raise InputError("--jobs: how many compute is up to the cluster")
    if address is not None:
        return partial(cluster, address)
    count = jobs or os.cpu_count() or 1
    return partial(processes, count) if count > 1 else this_process


@dataclass
class Sweep:
    """Run a scene many times over a grid of its settings; write a table and a plot of what is measured."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")]
    """A preset's name, a file's path or a link."""
    out: Path
    """Folder for table.csv, plot.png and sweep.jsonl; the same command goes on with what is missing there."""
    vary: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="KEY=VALUES",
            help="a setting, as for --set, and its values: KEY=A..B:N for N numbers from A to B, "
            "KEY=A..B:N:log for equal ratios, KEY=VALUE,VALUE,... for a list; may be repeated, and all are "
            "combined with each other",
        ),
    ] = ()
    measure: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="NAME",
            help="what is measured; may be repeated. "
            + "; ".join(f"{measure.name}: {measure.summary}" for measure in MEASURES.values()),
        ),
    ] = ()
    duration: float = 10.0
    """Simulated seconds of each run."""
    jobs: Jobs = None
    cluster: Cluster = None
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Compute and write."""
        from .sweep.grid import make_grid
        from .sweep.sweep import sweep

        if not 1e-3 <= self.duration <= 1e4:
            return fail(f"--duration: {self.duration:g} is not in the range 0.001..10000 s")
        workers = workers_for(self.jobs, self.cluster)
        grid = make_grid(sim.load_scene(self.scene), self.settings, self.vary)
        measures = parse_measures(self.measure)
        return sweep(grid, measures, self.duration, workers, self.out, Console(), self.csv_comma)


@dataclass
class Improve:
    """Search for the settings with which a scene comes nearest to a goal; write the best as file and link."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")]
    """A preset's name, a file's path or a link."""
    goal: Annotated[
        str,
        arg(
            metavar="GOAL",
            help='what is wanted of a run: "max QUANTITY", "min QUANTITY" or "near VALUE QUANTITY" at its '
            'end, or with mean, largest, smallest or period before the quantity, as in "min largest '
            'spring0.force"; "reach LOW..HIGH QUANTITY for SECONDS", as soon as possible; or "step N", the '
            "goal of a step of the scene's lesson. Quantities are those of softrod run --record",
        ),
    ]
    out: Path = Path("improved")
    """Folder for best.json, link.txt, table.csv, progress.png and improve.jsonl; the same command goes on
    with what is missing there, also with more --runs."""
    duration: Annotated[float, arg(name="for")] = 10.0
    """Simulated seconds of each run."""
    vary: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="KEY=A..B",
            help="a setting, as for --set, and its range; may be repeated. Where both ends are above 0, "
            "it is searched by ratios",
        ),
    ] = ()
    runs: int = 300
    """Runs at most, 10 to 100000, with that of the scene as it is."""
    population: int | None = None
    """Runs of a generation, 4 to 1000, which are computed at the same time; 4 + 3 ln(number of settings)
    unless given. With more, a search is more thorough and slower, and uses more cores."""
    seed: int = 1
    """Of the search's random numbers, from 0; the same seed finds the same."""
    jobs: Jobs = None
    cluster: Cluster = None
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Compute, print and write."""
        from .improve.goals import parse_goal
        from .improve.improve import OptimizationProblem, improve, print_result
        from .improve.ranges import make_ranges
        from .improve.search import default_population

        if not 1e-3 <= self.duration <= 1e4:
            return fail(f"--for: {self.duration:g} is not in the range 0.001..10000 s")
        if not 10 <= self.runs <= 100_000:
            return fail(f"--runs: {self.runs} is not in the range 10..100000")
        if self.population is not None and not 4 <= self.population <= 1000:
            return fail(f"--population: {self.population} is not in the range 4..1000")
        if not 0 <= self.seed < 2**32:
            return fail(f"--seed: {self.seed} is not in the range 0..{2**32 - 1}")
        workers = workers_for(self.jobs, self.cluster)
        goal, scene = parse_goal(self.goal, sim.load_scene(self.scene))
        if goal.seconds > self.duration:
            return fail(f"--goal {goal.text}: a run has only {self.duration:g} s; --for says how many")
        grid, ranges = make_ranges(scene, self.settings, self.vary)
        population = self.population or default_population(len(ranges))
        problem = OptimizationProblem(grid, ranges, goal, self.duration, self.runs, population, self.seed)
        console = Console()
        found = improve(problem, workers, self.out, console, self.csv_comma)
        return print_result(problem, found, self.out, console)


@dataclass
class FitScene:
    """Fit numbers of a scene to what was measured: tables of phyphox, Tracker, spreadsheets or softrod."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")]
    """A preset's name, a file's path or a link."""
    data: Annotated[Positional[tuple[Path, ...]], arg(metavar="DATA")]
    """One or more tables: times, and places, angles, lengths, forces or accelerations at them."""
    vary: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="NAMES",
            help="what is sought, one to six names with commas between them; may be repeated: settings as "
            "for --set; numbers of parts, as spring0.stiffness and mass1.mass; what a mass starts with, as "
            "mass1.vx; " + "; ".join(f"{name}: {summary}" for name, summary in OF_MEASUREMENT.items()),
        ),
    ] = ()
    match: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="COLUMN=QUANTITY",
            help="which quantity a column is, as in y=-mass1.y or angle=90-spring0.direction; may be "
            "repeated. Unless given, the names of the columns say it",
        ),
    ] = ()
    scale: float | None = None
    """How many of the scene's lengths are one metre, or one pixel of what was measured."""
    out: Path | None = None
    """Folder for scene.json, the fitted scene, values.csv and fit.png."""
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Fit, print and write."""
        from .fitting.fitting import fit_and_report

        if not self.data:
            return fail("fit: name at least one table of what was measured")
        names = [name.strip() for names in self.vary for name in names.split(",") if name.strip()]
        if not names:
            return fail("--vary: name what is sought, as in --vary linear_stiffness,linear_damping")
        match = dict(_assignment(text) for text in self.match)
        scene = scene_of(self.scene, self.settings)
        return fit_and_report(
            scene, self.data, names, match or None, self.scale, self.out, Console(), self.csv_comma
        )


def _assignment(text: str) -> tuple[str, str]:
    """Return column and quantity of `COLUMN=QUANTITY`.

    Raises:
        InputError: it is something else.
    """
    column, equals, quantity = text.rpartition("=")
    if not equals or not column.strip():
        raise InputError(f"--match {text}: COLUMN=QUANTITY is expected, as in y=-mass1.y")
    return column.strip(), quantity.strip()


COMMANDS = {
    "bench": Bench,
    "validate": Validate,
    "stability": Stability,
    "study": Study,
    "sweep": Sweep,
    "improve": Improve,
    "fit": FitScene,
}
