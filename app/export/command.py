"""`softrod export`: pictures, films, replays, models, data and programs of a scene, without a page."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from rich.console import Console
from rich.progress import Progress
from tyro.conf import Positional, UseAppendAction, arg

import sim
from sim.errors import InputError
from sim.settings import apply_assignments
from sim.store.files import write_file

from ..command import CsvComma
from ..session.log import read_log
from .clip import LONGEST, SHORTEST, Clip, Shot
from .keyframes import FASTEST, FPS, SLOWEST, motion_csv

PICTURE = 1280
"""Pixels of a picture's longer side."""

_SIZE = re.compile(r"(\d{2,4})x(\d{2,4})")

_ENDINGS = {
    "csv": ("zip",),
    "python": ("py",),
    "javascript": ("js", "mjs"),
    "live": ("html",),
    "motion": ("csv",),
    "animation": ("glb",),
}
"""Of files whose option has another name."""

_OF_BODY = frozenset(("live", "json", "csv", "python", "c", "javascript"))
"""What needs no motion."""

_RACES = frozenset(("png", "gif", "html"))
"""What can show two bodies."""

_KEYFRAMES = frozenset(("motion", "animation"))
"""What has frames at a rate of its own."""


@dataclass
class Export:
    """Write a picture, a film, a replay, a model, data or a program of a scene, or of a log that a page
    recorded."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")] = ""
    """A preset's name or a file's path; a recorded log has its own."""
    png: Path | None = None
    """A picture of the end, FILE.png."""
    gif: Path | None = None
    """A film, FILE.gif."""
    html: Path | None = None
    """A replay that any browser shows without a network, FILE.html."""
    live: Path | None = None
    """The body itself, which moves and is dragged in any browser without a network, FILE.html."""
    glb: Path | None = None
    """A model of the end in three dimensions, FILE.glb."""
    motion: Path | None = None
    """Where all masses are in each frame, as a table in CSV, FILE.csv."""
    animation: Path | None = None
    """A model in three dimensions that moves, with keyframes, FILE.glb."""
    json: Path | None = None
    """The body's numbers as plain arrays, FILE.json."""
    csv: Path | None = None
    """The body's numbers as tables in CSV, FILE.zip."""
    python: Path | None = None
    """A program in Python with NumPy that moves the body by the tutorial's step, FILE.py."""
    c: Path | None = None
    """The same in C99, for a game's loop: FILE.c and, beside it, FILE.h."""
    javascript: Path | None = None
    """A module in JavaScript for games, which moves, pushes and drags the body, FILE.js or FILE.mjs."""
    seconds: float = 5.0
    """Simulated seconds, 0..60: of a log the last ones."""
    after: float = 0.0
    """Simulated seconds before these."""
    race: str = ""
    """Another scene, whose body moves beside this one on the same terrain, in --png, --gif and --html."""
    scale: float = 1000.0
    """Px in a metre, in --glb and --animation, 0.001..1e9."""
    fps: int = FPS
    """Frames a second of --motion and --animation, 1..240."""
    size: str = ""
    """Of the picture and the film, pixels, as in 640x360; by the scene's frame unless given."""
    dark: bool = False
    """On dark paper."""
    csv_comma: CsvComma = False
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
        wanted = {"png": self.png, "gif": self.gif, "html": self.html, "glb": self.glb}
        wanted |= {"live": self.live, "json": self.json, "csv": self.csv, "python": self.python, "c": self.c}
        wanted |= {"javascript": self.javascript, "motion": self.motion, "animation": self.animation}
        outputs = {kind: path for kind, path in wanted.items() if path is not None}
        size = self._checked(outputs)
        rate = self.fps if _KEYFRAMES & set(outputs) else None
        moments = self._moments(0.0 if set(outputs) <= _OF_BODY else self.seconds, rate)
        makers = self._makers(moments, self._shots(moments), size)
        for kind, path in outputs.items():
            made = makers[kind]()
            files = made if isinstance(made, dict) else {path: made}
            for file, data in files.items():
                write_file(file, data)
                print(f"{file}: {len(data) / 1000:.0f} kB")
        return 0

    def _checked(self, outputs: dict[str, Path]) -> tuple[int, int] | None:
        """The size, before any time goes into simulating.

        Raises:
            InputError: an option is out of its range, or a file could not be written.
        """
        from .painter import LARGEST, SMALLEST

        if not outputs:
            raise InputError(
                "export: name what to write, with --png, --gif, --html, --live, --glb, --motion, "
                "--animation, --json, --csv, --python, --c or --javascript"
            )
        for kind, path in outputs.items():
            endings = [f".{ending}" for ending in _ENDINGS.get(kind, (kind,))]
            if path.suffix.lower() not in endings:
                raise InputError(f"--{kind} {path}: the file must end in {' or '.join(endings)}")
            if not path.parent.is_dir():
                raise InputError(f"--{kind} {path}: the folder {path.parent} does not exist")
        if self.race and (self.inputs is not None or not set(outputs) <= _RACES):
            raise InputError("--race: it is shown by --png, --gif and --html, of a scene and not of a log")
        least = SHORTEST if {"gif", "html", *_KEYFRAMES} & set(outputs) else 0.0
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
            scene = apply_assignments(sim.load_scene(self.scene), self.settings)
            return simulated(scene, seconds, self.after, console, rate)
        record = read_log(self.inputs)
        if self.scene or self.settings or self.after:
            raise InputError("export: a recorded log is shown as it was, without SCENE, --set and --after")
        moments, differs = replayed(record, console)
        if differs is not None:
            console.print(f"softrod: {self.inputs}: {differs}", highlight=False)
        return moments

    def _shots(self, moments: list[sim.Moment]) -> list[Shot]:
        """What pictures, films and replays show."""
        if not self.race:
            return list(map(Shot.of, moments))
        from sim.edit.terrain import on_terrain

        from .making import simulated
        from .race import race, result

        rival = on_terrain(sim.load_scene(self.race), moments[-1].scene)
        others = simulated(rival, self.seconds, self.after, Console(stderr=True))
        for each in (moments, others):
            print(result(each))
        return race(moments, others)

    def _makers(
        self, moments: list[sim.Moment], shots: list[Shot], size: tuple[int, int] | None
    ) -> dict[str, Callable[[], bytes | dict[Path, bytes]]]:
        from . import film, picture, replay
        from .body.body import Body
        from .body.data import body_csv, body_json
        from .body.program import c_program, python_program
        from .live.live import live_html
        from .live.program import javascript_program

        last = shots[-1]
        # The start of a film; of a log there is only its end.
        begin = moments[0 if self.inputs is None else -1]

        def clip() -> Clip:
            return Clip(shots, self.seconds)

        def noted(made: tuple[bytes, list[str]], path: Path | None) -> bytes:
            data, notes = made
            for note in notes:
                print(f"softrod: {path}: {note}", file=sys.stderr)
            return data

        def in_c() -> dict[Path, bytes]:
            assert self.c is not None
            source, header, notes = c_program(Body.of(begin), self.c.stem)
            return {self.c: noted((source, notes), self.c), self.c.with_suffix(".h"): header}

        def model() -> bytes:
            from .model import glb

            return glb(last.scene, last.picture, self.scale)

        def animated() -> bytes:
            from .animation import animated_glb

            return animated_glb(clip(), self.fps, self.scale)

        def moving() -> bytes:
            console = Console(stderr=True)
            with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
                task = progress.add_task("painting", total=1.0)
                return film.gif(clip(), size, self.dark, lambda part: progress.update(task, completed=part))

        return {
            "png": lambda: picture.png(last, size or film.size_of(last.scene, longer=PICTURE), self.dark),
            "gif": moving,
            "html": lambda: replay.replay_html(clip()),
            "glb": model,
            "motion": lambda: motion_csv(clip(), self.fps, self.csv_comma),
            "animation": animated,
            "json": lambda: body_json(Body.of(begin)),
            "csv": lambda: body_csv(Body.of(begin), self.csv_comma),
            "live": lambda: noted(live_html(begin), self.live),
            "python": lambda: noted(python_program(Body.of(begin)), self.python),
            "c": in_c,
            "javascript": lambda: noted(javascript_program(begin), self.javascript),
        }
