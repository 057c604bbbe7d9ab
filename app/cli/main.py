"""The command line: `softrod [SCENE]`, `softrod run`, `softrod scenes`, `softrod check` and others."""

from __future__ import annotations

import io
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Protocol

import tyro
from rich.console import Console
from rich.table import Table
from tyro.conf import Positional, UseAppendAction, arg

import sim
from sim.compiling.compiler import cache_trouble
from sim.errors import InputError, SceneError, SettingError
from sim.model.stable_spring import softening_note
from sim.motion.quantities import PARTS
from sim.solve.registry import METHODS
from sim.store.files import read_scene
from sim.store.schema import schema_bytes

from ..command import CsvComma, Listening, Settings, fail, scene_of
from ..export.command import Export
from ..lessons import check_lesson
from ..linking import Link
from ..session.log import Log, read_log
from ..site.command import MakeGallery
from . import headless
from .teaching import TeachClass

DEFAULT_SCENE = "rope"

_GROUPS = {"lessons": "scenes with steps beside the body", "study": "scenes of `softrod study`"}
"""Descriptions of the groups of presets."""


@dataclass
class Serve(Listening):
    """Serve a scene in the browser."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = DEFAULT_SCENE
    """A preset's name, a file's path or a link."""
    embed: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="ORIGIN")] = ()
    """A site that may show the page in a frame, as in https://school.example; may be repeated."""
    qr: bool = False
    """Print the QR code of the address by which others reach the page."""
    settings: Settings = ()

    def run(self) -> int:
        """Serve until told to stop."""
        # Imported here: the other commands do not need viser, whose import takes a second.
        from ..gate.gate import GateError, PortBusy
        from ..server.serve import serve

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
    """Simulate without a page, and write a table of positions; do what a log says, if one is given."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = ""
    """A preset's name or a file's path; a recorded log has its own."""
    out: Path | None = None
    """The table, FILE.csv or FILE.npz; a log that a page recorded needs none."""
    steps: int | None = None
    """Steps to do; those of the log unless given."""
    duration: float | None = None
    """Seconds to simulate, instead of a number of steps."""
    inputs: Path | None = None
    """A log of what is done, one JSON object a line: one that a page recorded, or one written by hand."""
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
            + "; ".join(f"{part}: {', '.join(names)}" for part, names in PARTS.items())
            + "; or a formula of such, as in 'mass1.y - mass0.y'",
        ),
    ] = ()
    csv_comma: CsvComma = False
    settings: Settings = ()

    def run(self) -> int:
        """Simulate and write."""
        scene = scene_of(self.scene, self.settings) if self.scene else None
        if self.out is not None:
            headless.check_output(self.out)
        if self.every < 1:
            return fail("--every: it must be at least 1")
        if self.energy and self.record:
            return fail("--energy: with --record, energies are quantities, as energy.total")
        if scene is None and self.settings:
            return fail("--set: a recorded log is replayed as it was; name the SCENE to change one")
        if self.inputs is not None:
            log = read_log(self.inputs, scene)
        elif scene is not None:
            log = Log("", scene)
        else:
            return fail("run: name a scene, or a recorded log with --inputs")
        if scene is not None and not headless.same_body(scene, log.scene):
            return fail(f"{self.inputs}: the log was recorded with another scene than {self.scene}")
        if self.out is None and not log.checks:
            return fail("--out: name the table to write, FILE.csv or FILE.npz")
        steps = None
        if not log.entries or self.steps is not None or self.duration is not None:
            steps = self._steps(log.scene.integrator.dt)
            if isinstance(steps, str):
                return fail(steps)
        if note := softening_note(log.scene):
            print(f"note: {note}", file=sys.stderr)
        recording, player = headless.run(
            log, steps, self.every, Console(stderr=True), self.energy, self.record
        )
        if self.out is not None:
            recording.write(self.out, self.csv_comma)
        if not player.agrees:
            return fail(f"{self.inputs}: {player.verdict}")
        if log.checks:
            print(player.verdict)
        elif (problem := player.simulation.divergence) is not None:
            return fail(f"{problem}; {self.out} has the {len(recording)} rows before it")
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
        from ..pages.sandbox.features import CONTROLS
        from ..ui.controls import of_scene

        if not self.files:
            return fail("check: name at least one file")
        failed = 0
        for path in self.files:
            try:
                scene = read_scene(path)
                of_scene(scene, CONTROLS)
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


@dataclass
class Schema:
    """Print the JSON Schema of scene files, by which editors check and complete them."""

    def run(self) -> int:
        """Print it."""
        print(schema_bytes().decode(), end="")
        return 0


_COARSE = 0.01
"""Part of a body's size beyond which a tolerance is called coarse; presets have a thousandth."""


def _note_on_tolerance(scene: sim.Scene) -> str:
    """A note on a tolerance that is large for its body, as the default is in metres; else empty."""
    tolerance, unit = scene.integrator.tolerance, scene.view.unit
    places = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
    size = max(max(axis) - min(axis) for axis in zip(*places, strict=True))
    if not METHODS[scene.integrator.method].adaptive or not 0.0 < size < tolerance / _COARSE:
        return ""
    return (
        f"integrator.tolerance: {tolerance:g} {unit} is coarse for a body of {size:.3g} {unit}; "
        f"{1e-3 * size:.1g} {unit} is a thousandth of it"
    )


class Command(Protocol):
    """A parsed command line."""

    def run(self) -> int:
        """Run the command; the exit status."""
        ...


_COMMANDS: dict[str, type[Command]] = {
    "run": Run,
    "scenes": Scenes,
    "check": Check,
    "schema": Schema,
    "link": Link,
    "export": Export,
    "gallery": MakeGallery,
    "class": TeachClass,
}

STUDIES = ("bench", "validate", "stability", "study", "sweep", "improve", "fit")
"""Commands of the package `studies`, which is loaded only for them."""

_SOLVING = ("run", "export", *STUDIES)
"""Commands that compile the solver first, and report trouble with its cache; the page does so by itself."""


def _command(name: str) -> type[Command] | None:
    """The command of that name, if there is one."""
    if name in STUDIES:
        from studies.commands import COMMANDS

        return COMMANDS[name]
    return _COMMANDS.get(name)


def main(arguments: list[str] | None = None) -> None:
    """The entry point of the command `softrod`."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # Names may have letters that the terminal's encoding lacks; the error stream does this by itself.
        sys.stdout.reconfigure(errors="backslashreplace")
    words = sys.argv[1:] if arguments is None else arguments
    name = words[0] if words else ""
    command, program, description = _command(name), f"softrod {name}", None
    if command is not None:
        words = words[1:]
    else:
        command, program = Serve, "softrod"
        if {"-h", "--help"} & set(words):
            kinds = ((other, _command(other)) for other in (*_COMMANDS, *STUDIES))
            others = "\n".join(f"  softrod {other}: {kind.__doc__}" for other, kind in kinds)
            description = f"{Serve.__doc__}\n\nOther commands (each has --help):\n{others}"
    if name in _SOLVING and (trouble := cache_trouble()):
        print(f"softrod: the solver is {trouble}", file=sys.stderr)
    parsed = tyro.cli(command, prog=program, description=description, args=words)
    try:
        status = parsed.run()
    except (InputError, SceneError, SettingError) as error:
        status = fail(error)
    sys.exit(status)
