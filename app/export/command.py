"""`softrod export`: pictures, films, replays, models, data and programs of a scene, without a page."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass, make_dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from rich.console import Console
from rich.progress import Progress
from tyro.conf import Positional, UseAppendAction, arg

import sim
from sim.errors import InputError
from sim.store.files import write_file

from ..command import CsvComma, Lang, scene_of, spoken
from ..session.log import read_log
from ..words import ENGLISH, speaking
from .clip import LONGEST, SHORTEST, ClipFrame
from .formats import FORMATS, Format, Options, Source
from .keyframes import FASTEST, FPS, SLOWEST
from .model import PX_PER_METRE

_SIZE = re.compile(r"(\d{2,4})x(\d{2,4})")

if TYPE_CHECKING:

    class _Files:
        """The files to write, an option for each row of `FORMATS`."""

else:
    _Files = make_dataclass(
        "_Files", [(f.flag, Annotated[Path | None, arg(help=f.about)], None) for f in FORMATS]
    )


@dataclass
class Export(_Files):
    """Write a picture, a film, a replay, a model, data or a program of a scene, or of a log that a page
    recorded."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = ""
    """A preset's name or a file's path; a recorded log has its own."""
    seconds: float = 5.0
    """Simulated seconds, 0..60: of a log the last ones."""
    after: float = 0.0
    """Simulated seconds before these."""
    race: str = ""
    """Another scene, whose body moves along with this one on the same terrain, in --png, --gif and --html."""
    scale: float = PX_PER_METRE
    """Px in a metre, in --glb and --animation, 0.001..1e9."""
    fps: int = FPS
    """Frames a second of --motion and --animation, 1..240."""
    size: str = ""
    """Of the picture and the film, pixels, as in 640x360; by the scene's frame unless given."""
    dark: bool = False
    """On dark paper."""
    csv_comma: CsvComma = False
    lang: Lang = ENGLISH
    inputs: Path | None = None
    """A log that a page recorded."""
    settings: Annotated[
        UseAppendAction[tuple[str, ...]],
        arg(name="set", metavar="KEY=VALUE", help="as for `softrod run`; may be repeated"),
    ] = ()

    def run(self) -> int:
        """Simulate and write.

        Raises:
            InputError, SceneError, SettingError: it cannot be done; what is not written yet is not written.
        """
        with speaking(spoken(self.lang)):
            return self._write()

    def _write(self) -> int:
        paths: dict[Format, Path] = {f: path for f in FORMATS if (path := getattr(self, f.flag)) is not None}
        size = self._checked(paths)
        seconds = 0.0 if all(each.of == "body" for each in paths) else self.seconds
        moments = self._moments(seconds, self.fps if any(each.has_rate for each in paths) else None)
        # The body at the start of a film; of a log there is only its end.
        begin = moments[0 if self.inputs is None else -1]
        source = Source(begin, self._frames(moments), self.seconds)
        console = Console(stderr=True)
        for each, path in paths.items():
            with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
                task = progress.add_task("making", total=1.0)
                made = each.make(
                    source,
                    Options(
                        path.stem, size, self.dark, self.scale, self.fps, self.csv_comma,
                        lambda part, task=task, progress=progress: progress.update(task, completed=part),
                    ),
                )  # fmt: skip
            for note in made.notes:
                print(f"softrod: {path}: {note}", file=sys.stderr)
            for number, (ending, data) in enumerate(made.files.items()):
                file = path.with_suffix(f".{ending}") if number else path
                write_file(file, data)
                print(f"{file}: {len(data) / 1000:.0f} kB")
        return 0

    def _checked(self, paths: dict[Format, Path]) -> tuple[int, int] | None:
        """The size, before any time goes into simulating.

        Raises:
            InputError: an option is out of its range, or a file could not be written.
        """
        from .painter import LARGEST, SMALLEST

        if not paths:
            *first, last = (f"--{each.flag}" for each in FORMATS)
            raise InputError(f"export: name what to write, with {', '.join(first)} or {last}")
        for each, path in paths.items():
            endings = [f".{ending}" for ending in each.endings]
            if path.suffix.lower() not in endings:
                raise InputError(f"--{each.flag} {path}: the file must end in {' or '.join(endings)}")
            if not path.parent.is_dir():
                raise InputError(f"--{each.flag} {path}: the folder {path.parent} does not exist")
        if self.race and (self.inputs is not None or not all(each.races for each in paths)):
            raise InputError("--race: it is shown by --png, --gif and --html, of a scene and not of a log")
        least = SHORTEST if any(each.of == "motion" for each in paths) else 0.0
        if not least <= self.seconds <= LONGEST:
            raise InputError(f"--seconds: {self.seconds:g} is not in the range {least:g}..{LONGEST:g} s")
        if not 1e-3 <= self.scale <= 1e9:
            raise InputError(f"--scale: {self.scale:g} is not in the range 0.001..1e+09 px in a metre")
        if not SLOWEST <= self.fps <= FASTEST:
            raise InputError(f"--fps: {self.fps} is not in the range {SLOWEST}..{FASTEST}")
        if not 0.0 <= self.after <= 1e4:
            raise InputError(f"--after: {self.after:g} is not in the range 0..10000 s")
        if not self.size:
            return None
        match = _SIZE.fullmatch(self.size)
        size = (int(match[1]), int(match[2])) if match else (0, 0)
        if not all(SMALLEST <= side <= LARGEST for side in size):
            raise InputError(f"--size {self.size}: two numbers from {SMALLEST} to {LARGEST}, as in 640x360")
        return size

    def _moments(self, seconds: float, rate: int | None) -> list[sim.Moment]:
        from .making import replayed, simulated

        console = Console(stderr=True)
        if self.inputs is None:
            if not self.scene:
                raise InputError("export: name a scene, or a recorded log with --inputs")
            return simulated(scene_of(self.scene, self.settings), seconds, self.after, console, rate)
        record = read_log(self.inputs)
        if self.scene or self.settings or self.after:
            raise InputError("export: a recorded log is shown as it was, without SCENE, --set and --after")
        moments, differs = replayed(record, console)
        if differs is not None:
            console.print(f"softrod: {self.inputs}: {differs}", highlight=False)
        return moments

    def _frames(self, moments: list[sim.Moment]) -> list[ClipFrame]:
        """What pictures, films and replays show."""
        if not self.race:
            return list(map(ClipFrame.of, moments))
        from sim.edit.terrain import on_terrain

        from .making import simulated
        from .race import race, result, winner

        rival = on_terrain(sim.load_scene(self.race), moments[-1].scene)
        others = simulated(rival, self.seconds, self.after, Console(stderr=True))
        for each in (moments, others):
            print(result(each))
        if self.seconds:
            print(winner(moments, others))
        return race(moments, others)
