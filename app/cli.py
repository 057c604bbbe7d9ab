"""The command line: `softrod [SCENE]`, `softrod run`, `softrod scenes`, `softrod check` and others."""

from __future__ import annotations

import io
import math
import os
import sys
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.table import Table
from tyro.conf import Positional, UseAppendAction, arg

import sim
from sim.compiling.compiler import cache_trouble
from sim.errors import InputError, SceneError, SettingError
from sim.methods.registry import METHODS
from sim.motion.quantities import PARTS
from sim.scene.files import read_scene

from . import headless
from .command import CsvComma, Settings, fail, scene_of
from .export.command import Export
from .lessons import check_lesson
from .linking import Link
from .page.controls import of_scene
from .session.log import Log
from .sweep.measures import MEASURES, parse_measures

DEFAULT_SCENE = "rope"

_GROUPS = {"lessons": "scenes with steps beside the body", "study": "scenes of `softrod study`"}
"""What the groups of presets are."""


@dataclass
class Serve:
    """Serve a scene in the browser."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = DEFAULT_SCENE
    """A preset's name, a file's path or a link."""
    host: str = "127.0.0.1"
    """Address to listen on. Any other than this machine's own lets other machines in."""
    port: int = 8080
    """Port to listen on; 0 for any free one."""
    open: bool = True
    """Open the page in a browser."""
    embed: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="ORIGIN")] = ()
    """A site that may show the page in a frame, as in https://school.example; may be repeated."""
    allow_host: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="NAME")] = ()
    """A further name by which browsers may reach the page, with its port if that is another, as in
    laptop.local or laptop.local:9000; may be repeated."""
    public_url: Annotated[str | None, arg(metavar="URL")] = None
    """The address by which others reach the page through a proxy, as in https://school.example/lab/."""
    qr: bool = False
    """Print the QR code of the address by which others reach the page."""
    settings: Settings = ()

    def run(self) -> int:
        """Serve until told to stop."""
        # Here, not above: the other commands have no use for viser, which takes a second to import.
        from .gate.gate import GateError, PortBusy
        from .server.serve import serve

        try:
            scene = scene_of(self.scene, self.settings)
            serve(
                scene, self.host, self.port, self.open, self.embed, self.allow_host, self.public_url, self.qr
            )
        except (GateError, PortBusy) as error:
            return fail(error)
        return 0


@dataclass
class Run:
    """Simulate without a page, and write a table of positions; or replay a log that a page saved."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = ""
    """A preset's name or a file's path; a recorded log has its own."""
    out: Path | None = None
    """The table, FILE.csv or FILE.npz; a replay needs none."""
    steps: int | None = None
    """Steps to do."""
    duration: float | None = None
    """Seconds to simulate, instead of a number of steps."""
    inputs: Path | None = None
    """A log of moves and keys, one JSON object a line, ordered by step; or one that a page recorded."""
    every: int = 1
    """Write one row after each so many steps."""
    energy: bool = False
    """Add columns of the energies, and of what has changed them."""
    record: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(
            metavar="QUANTITY",
            help="write this instead of positions; may be repeated. It is the name of a part and what is "
            "measured of it, as in joint3.angle: "
            + "; ".join(f"{part}: {', '.join(names)}" for part, names in PARTS.items()),
        ),
    ] = ()
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Simulate and write."""
        scene = scene_of(self.scene, self.settings) if self.scene else None
        if self.out is not None:
            headless.check_output(self.out)
        entries = headless.read_log(self.inputs) if self.inputs is not None else []
        if self.every < 1:
            return fail("--every: it must be at least 1")
        if self.energy and self.record:
            return fail("--energy: with --record, energies are quantities, as energy.total")
        if isinstance(entries, Log):
            return self._replay(entries, scene)
        if scene is None:
            return fail("run: name a scene, or a recorded log with --inputs")
        if self.out is None:
            return fail("--out: name the table to write, FILE.csv or FILE.npz")
        steps = self._steps(scene.integrator.dt)
        if isinstance(steps, str):
            return fail(steps)
        recording, problem = headless.run(
            scene, steps, entries, self.every, Console(stderr=True), self.energy, self.record
        )
        recording.write(self.out, self.csv_comma)
        if problem is not None:
            return fail(f"{problem}; {self.out} has the {len(recording)} rows before it")
        return 0

    def _replay(self, record: Log, scene: sim.Scene | None) -> int:
        if scene is None and self.settings:
            return fail("--set: a recorded log is replayed as it was; name the SCENE to change one")
        if scene is not None and not headless.same_body(scene, record.scene):
            return fail(f"{self.inputs}: the log was recorded with another scene than {self.scene}")
        steps = None
        if self.steps is not None or self.duration is not None:
            steps = self._steps(record.scene.integrator.dt)
            if isinstance(steps, str):
                return fail(steps)
        recording, player = headless.replay(
            record, steps, self.every, Console(stderr=True), self.energy, self.record
        )
        if self.out is not None:
            recording.write(self.out, self.csv_comma)
        if not player.agrees:
            return fail(f"{self.inputs}: {player.verdict}")
        print(player.verdict)
        return 0

    def _steps(self, dt: float) -> int | str:
        if (self.steps is None) == (self.duration is None):
            return "either --steps or --duration says how long to simulate"
        steps = self.steps
        if self.duration is not None:
            if not 0.0 <= self.duration <= 1e9:
                return f"--duration: {self.duration:g} is not in the range 0..1e+09 s"
            steps = round(self.duration / dt)
        if steps is None or not 0 <= steps <= 10**12:
            return f"--steps: {steps} is not in the range 0..{10**12}"
        return steps


@dataclass
class Scenes:
    """List the scenes there are."""

    def run(self) -> int:
        """Print them."""
        table = Table("scene", "description", box=None, padding=(0, 2, 0, 0))
        group = ""
        for info in sim.list_scenes():
            if info.group and info.group != group:
                table.add_row()
                table.add_row(f"[bold]{info.group}[/]", _GROUPS.get(info.group, ""))
            group = info.group
            table.add_row(info.name if info.built_in else f"{info.name} (saved)", info.description)
        Console().print(table)
        return 0


@dataclass
class Check:
    """Say whether scene files are valid, and why not."""

    files: Annotated[Positional[tuple[Path, ...]], arg(metavar="FILE")] = field(default=())

    def run(self) -> int:
        """Check each; 1 if any is not valid."""
        if not self.files:
            return fail("check: name at least one file")
        failed = 0
        for path in self.files:
            try:
                scene = read_scene(path)
                of_scene(scene)
                check_lesson(scene)
            except (InputError, SettingError) as error:
                failed = fail(f"{path}: {error}")
            except ValueError as error:
                failed = fail(error)
            else:
                print(f"{path}: {scene.name}, {len(scene.masses)} masses, is valid")
                if note := _note_on_tolerance(scene):
                    print(f"{path}: note: {note}")
        return failed


_COARSE = 0.01
"""Part of a body's size from which on a tolerance is called coarse; that of the presets is a thousandth."""


def _note_on_tolerance(scene: sim.Scene) -> str:
    """What to know of a tolerance that is large for its body, as the usual one is in metres."""
    tolerance, unit = scene.integrator.tolerance, scene.view.unit
    places = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
    size = max(max(axis) - min(axis) for axis in zip(*places, strict=True))
    if not METHODS[scene.integrator.method].adaptive or not 0.0 < size < tolerance / _COARSE:
        return ""
    return (
        f"integrator.tolerance: {tolerance:g} {unit} is coarse for a body of {size:.3g} {unit}; "
        f"{1e-3 * size:.1g} {unit} is a thousandth of it"
    )


@dataclass
class Bench:
    """Measure softrod on this machine, beside other programs that do the same."""

    what: Annotated[
        Positional[
            Literal[
                "kernels", "growth", "heap", "frames", "matrices", "compile", "start", "page", "tabs", "edit"
            ]
        ],
        arg(metavar="{kernels,growth,heap,frames,matrices,compile,start,page,tabs,edit}"),
    ]
    """kernels: the step by several programs; growth: the step as the body grows; heap: rings that fall into a
    heap; frames: time and error of a rod led in a circle, and time of one torn to and fro; matrices: what
    implicit steps of any topology factorise; compile: processor time of compiling; start: until each preset
    moves; page: cost and latency; tabs: many pages at once; edit: of one part of a large body."""
    repeats: int = 5
    """Repeats, of which the fastest counts."""

    def run(self) -> int:
        """Measure and print."""
        from .bench.compiling import bench_compile
        from .bench.editing import bench_edit
        from .bench.frames import bench_frames
        from .bench.growth import bench_growth
        from .bench.heap import bench_heap
        from .bench.kernels import bench
        from .bench.matrices import bench_matrices
        from .bench.serving import bench_page, bench_start
        from .bench.tabs import bench_tabs

        if not 1 <= self.repeats <= 1000:
            return fail("--repeats: it must be from 1 to 1000")
        benches = {
            "kernels": bench,
            "growth": bench_growth,
            "heap": bench_heap,
            "frames": bench_frames,
            "matrices": bench_matrices,
            "compile": bench_compile,
            "start": bench_start,
            "page": bench_page,
            "tabs": bench_tabs,
            "edit": bench_edit,
        }
        benches[self.what](Console(), self.repeats)
        return 0


@dataclass
class Validate:
    """Hold the solver against exact results; the exit status is 1 if a target is missed."""

    out: Path | None = None
    """Folder for the report: validate.md, validate.csv.gz and figures."""
    fast: bool = False
    """Leave out what takes long."""

    def run(self) -> int:
        """Compute, print and write."""
        from .studies.validate import validate

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
    """Likewise."""
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
        from .studies.hard_case_report import hard_case_report
        from .studies.stability import stability
        from .studies.stability_axes import AXES

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
    """Two numbers with a comma between them.

    Raises:
        InputError: they are not that.
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
    """Random bodies to hold auto's tolerance against."""

    def run(self) -> int:
        """Measure, print and write."""
        from .studies.study import parse_errors, parse_integrators, study, study_scenes

        if not 0 <= self.random <= 100_000:
            return fail(f"--random: {self.random} is not in the range 0..100000")
        scenes = [(name, sim.load_scene(name)) for name in self.scenes or study_scenes()]
        integrators, errors = parse_integrators(self.integrators), parse_errors(self.errors)
        return study(scenes, integrators, errors, self.random, self.out, Console())


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
    jobs: int | None = None
    """Processes that compute at the same time; one for each core unless given."""
    cluster: str | None = None
    """Address of a Dask scheduler whose workers compute instead, as in tcp://host:8786."""
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Compute and write."""
        from .sweep.grid import make_grid
        from .sweep.sweep import sweep
        from .sweep.workers import cluster, processes

        if not 1e-3 <= self.duration <= 1e4:
            return fail(f"--duration: {self.duration:g} is not in the range 0.001..10000 s")
        if self.jobs is not None and not 1 <= self.jobs <= 1000:
            return fail(f"--jobs: {self.jobs} is not in the range 1..1000")
        if self.jobs is not None and self.cluster is not None:
            return fail("--jobs: how many compute is up to the cluster")
        grid = make_grid(sim.load_scene(self.scene), self.settings, self.vary)
        measures, address = parse_measures(self.measure), self.cluster
        jobs = self.jobs or os.cpu_count() or 1
        workers = partial(processes, jobs) if address is None else partial(cluster, address)
        return sweep(grid, measures, self.duration, workers, self.out, Console(), self.csv_comma)


COMMANDS = {
    "run": Run,
    "scenes": Scenes,
    "check": Check,
    "link": Link,
    "bench": Bench,
    "validate": Validate,
    "stability": Stability,
    "study": Study,
    "sweep": Sweep,
    "export": Export,
}


_SOLVING = (Run, Bench, Validate, Stability, Study, Sweep, Export)
"""Commands that compile the solver before they do anything; the page says it while it compiles."""


def main(arguments: list[str] | None = None) -> None:
    """The entry point of the command `softrod`."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # Names may have letters that the terminal's encoding lacks. The error stream does this anyway.
        sys.stdout.reconfigure(errors="backslashreplace")
    words = sys.argv[1:] if arguments is None else arguments
    command = COMMANDS.get(words[0]) if words else None
    sys.exit(_main(command or Serve, words[1:] if command else words))


def _main(
    command: type[
        Serve | Run | Scenes | Check | Link | Bench | Validate | Stability | Study | Sweep | Export
    ],
    words: list[str],
) -> int:
    program = "softrod" if command is Serve else f"softrod {command.__name__.lower()}"
    description = None
    if command is Serve:
        others = "\n".join(f"  softrod {name}: {kind.__doc__}" for name, kind in COMMANDS.items())
        description = f"Serve a scene in the browser.\n\nOther commands (each has --help):\n{others}"
    if command in _SOLVING and (trouble := cache_trouble()):
        print(f"softrod: the solver is {trouble}", file=sys.stderr)
    parsed = tyro.cli(command, prog=program, description=description, args=words)
    try:
        return parsed.run()
    except (InputError, SceneError, SettingError) as error:
        return fail(error)
