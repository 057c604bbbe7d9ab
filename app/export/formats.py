"""What can be taken home from a scene: a row for each kind of file.

The Share tab of a page, `softrod export` and a test of the guide's table go by these rows.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import sim

from ..words.keys import Key
from .animation import animated_glb
from .body.body import Body
from .body.data import body_csv, body_json
from .body.program import c_program, python_program, unknown_forces
from .clip import Clip, ClipFrame
from .keyframes import FPS, motion_csv
from .live.live import live_html
from .live.program import javascript_program
from .model import PX_PER_METRE, glb
from .replay import replay_html
from .teacher_sheet import sheet_html

PICTURE = 1280
"""Pixels of a picture's longer side."""


@dataclass(frozen=True)
class Source:
    """What files are made of.

    Attributes:
        body: the body of live files, data and programs.
        frames: the motion; pictures and models show its last moment.
        seconds: how much of the motion a clip has, simulated seconds before its end.
    """

    body: sim.Moment
    frames: list[ClipFrame]
    seconds: float

    def clip(self) -> Clip:
        """The motion.

        Raises:
            InputError: see `Clip`.
        """
        return Clip(self.frames, self.seconds)


@dataclass(frozen=True)
class Options:
    """How files are made.

    Attributes:
        name: of the file, without its ending.
        size: width and height of pictures and films, pixels; by the scene's frame unless given.
        dark: whether pictures and films are on dark paper.
        scale: px in a metre of a model.
        rate: keyframes a second.
        decimal_comma: whether tables have decimal commas, see `sim.store.csv_text.csv_text`.
        report: is called from time to time with the fraction that is done, 0..1.
    """

    name: str
    size: tuple[int, int] | None = None
    dark: bool = False
    scale: float = PX_PER_METRE
    rate: int = FPS
    decimal_comma: bool = False
    report: Callable[[float], None] = lambda _: None


@dataclass(frozen=True)
class Made:
    """What was made.

    Attributes:
        files: the content of each file, by its ending.
        notes: what whoever uses them should know, sentences without a full stop.
    """

    files: dict[str, bytes]
    notes: list[str] = field(default_factory=list)

    def as_one(self, name: str) -> bytes:
        """One file: a ZIP archive, if there are several of that name."""
        if len(self.files) == 1:
            return next(iter(self.files.values()))
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
            for ending, data in self.files.items():
                file.writestr(f"{name}.{ending}", data)
        return archive.getvalue()


@dataclass(frozen=True)
class Button:
    """How a page offers a kind of file.

    Attributes:
        label: of its button.
        saved_as: how the name of the file ends.
        command: what the palette calls it.
        icon: as viser names it; empty for a body as data or a program, whose buttons have no icons.
    """

    label: Key
    saved_as: str
    command: Key
    icon: str = ""


@dataclass(frozen=True)
class Format:
    """A kind of file.

    Attributes:
        flag: its option of `softrod export`, without the hyphens.
        endings: those that the command takes for the name of its file.
        about: what it is, for the command's help.
        of: whether it is made of a body, of the last moment of a motion, or of all of it.
        make: makes it; raises `InputError` where that cannot be done.
        button: None for a picture, which a page makes itself.
        races: whether it can show two bodies.
        has_rate: whether it has frames at a rate of its own.
    """

    flag: str
    endings: tuple[str, ...]
    about: str
    of: Literal["body", "end", "motion"]
    make: Callable[[Source, Options], Made]
    button: Button | None = None
    races: bool = False
    has_rate: bool = False


def _picture(source: Source, options: Options) -> Made:
    from .film import size_of  # it loads what a server can begin without
    from .picture import png

    last = source.frames[-1]
    size = options.size or size_of(last.scene, longer=PICTURE)
    return Made({"png": png(last, size, options.dark)})


def _film(source: Source, options: Options) -> Made:
    from .film import gif

    return Made({"gif": gif(source.clip(), options.size, options.dark, options.report)})


def _model(source: Source, options: Options) -> Made:
    last = source.frames[-1]
    return Made({"glb": glb(last.scene, last.picture, options.scale)})


def _animation(source: Source, options: Options) -> Made:
    return Made({"glb": animated_glb(source.clip(), options.rate, options.scale)})


def _motion(source: Source, options: Options) -> Made:
    return Made({"csv": motion_csv(source.clip(), options.rate, options.decimal_comma)})


def _c(source: Source, options: Options) -> Made:
    code, header, notes = c_program(Body.of(source.body), options.name)
    return Made({"c": code, "h": header}, notes)


def _left_out(source: Source) -> list[str]:
    return [f"{name} are not in it" for name in unknown_forces(source.body.scene)]


def _noted(ending: str, made: tuple[bytes, list[str]]) -> Made:
    data, notes = made
    return Made({ending: data}, notes)


FORMATS = (
    Format("png", ("png",), "A picture of the end, FILE.png.", "end", _picture, races=True),
    Format(
        "gif", ("gif",), "A film, FILE.gif.", "motion", _film,
        Button("files-gif", "gif", "files-gif.command", "gif"), races=True,
    ),
    Format(
        "html", ("html",), "A replay that any browser shows without a network, FILE.html.", "motion",
        lambda source, _: Made({"html": replay_html(source.clip())}),
        Button("files-replay", "html", "files-replay.command", "movie"), races=True,
    ),
    Format(
        "live", ("html",),
        "The body itself, which moves and is dragged in any browser without a network, FILE.html.", "body",
        lambda source, _: _noted("html", live_html(source.body)),
        Button("files-live", "live.html", "files-live.command", "world"),
    ),
    Format(
        "sheet", ("html",), "A lesson on one side of paper, for its teacher, FILE.html.", "body",
        lambda source, _: Made({"html": sheet_html(source.body.scene)}),
    ),
    Format(
        "glb", ("glb",), "A model of the end in three dimensions, FILE.glb.", "end", _model,
        Button("files-model", "glb", "files-model.command", "cube"),
    ),
    Format(
        "animation", ("glb",), "A model in three dimensions that moves, with keyframes, FILE.glb.", "motion",
        _animation,
        Button("files-animation", "motion.glb", "files-animation.command", "cube-send"),
        has_rate=True,
    ),
    Format(
        "motion", ("csv",), "Where all masses are in each frame, as a table in CSV, FILE.csv.", "motion",
        _motion, Button("files-motion", "motion.csv", "files-motion.command", "table"),
        has_rate=True,
    ),
    Format(
        "json", ("json",), "The body's numbers as plain arrays, FILE.json.", "body",
        lambda source, _: Made({"json": body_json(Body.of(source.body))}, _left_out(source)),
        Button("files-json", "json", "files-json.command"),
    ),
    Format(
        "csv", ("zip",), "The body's numbers as tables in CSV, FILE.zip.", "body",
        lambda source, options: Made(
            {"zip": body_csv(Body.of(source.body), options.decimal_comma)}, _left_out(source)
        ),
        Button("files-csv", "zip", "files-csv.command"),
    ),
    Format(
        "python", ("py",),
        "A program in Python with NumPy that moves the body by the tutorial's step, FILE.py.", "body",
        lambda source, _: _noted("py", python_program(Body.of(source.body))),
        Button("files-python", "py", "files-python.command"),
    ),
    Format(
        "c", ("c",), "The same in C99, for a game's loop: FILE.c and, in the same folder, FILE.h.", "body",
        _c, Button("files-c", "c.zip", "files-c.command"),
    ),
    Format(
        "javascript", ("js", "mjs"),
        "A module in JavaScript for games, which moves, pushes and drags the body, FILE.js or FILE.mjs.",
        "body", lambda source, _: _noted("js", javascript_program(source.body)),
        Button("files-javascript", "js", "files-javascript.command"),
    ),
)  # fmt: skip
"""All kinds, in the order of the Share tab."""
