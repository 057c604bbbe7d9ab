"""What commands share: loading a scene with `--set`, options, and how they fail."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from tyro.conf import UseAppendAction, arg

import sim
from sim.errors import InputError, SceneError
from sim.settings import CHOICES, SETTINGS, apply_assignments

from .words import choose, languages

Settings = Annotated[
    UseAppendAction[tuple[str, ...]],
    arg(
        name="set",
        metavar="KEY=VALUE",
        help=f"set a number of the scene; may be repeated. Keys: {', '.join(SETTINGS)} and masses; and "
        f"{', '.join(CHOICES)}, which are names",
    ),
]

CsvComma = Annotated[
    bool,
    arg(
        help="write CSV with decimal commas, and semicolons between the columns, as spreadsheets of many "
        "countries read it"
    ),
]


_LANGUAGES = " or ".join(f"{each.tag} ({each.name})" for each in languages().values())

Lang = Annotated[
    str,
    arg(
        metavar="TAG",
        help=f"language of what is written: {_LANGUAGES}",
    ),
]


def spoken(tag: str) -> str:
    """A language that was asked for by --lang.

    Raises:
        InputError: softrod does not speak it.
    """
    if choose(tag) != tag:
        raise InputError(f"--lang {tag}: softrod speaks {_LANGUAGES}")
    return tag


@dataclass
class Listening:
    """Where a command serves pages, and by which names."""

    host: str = "127.0.0.1"
    """Address to listen on. Any other than this machine's own lets other machines in."""
    port: int = 8080
    """Port to listen on; 0 for any free one."""
    open: bool = True
    """Open the page in a browser."""
    allow_host: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="NAME")] = ()
    """A further name by which browsers may reach the page, with its port if that is another, as in
    laptop.local or laptop.local:9000; may be repeated."""
    public_url: Annotated[str | None, arg(metavar="URL")] = None
    """The address by which others reach the page through a proxy, as in https://school.example/lab/."""


def scene_of(name: str, settings: tuple[str, ...]) -> sim.Scene:
    """Load a scene by name, path or link, and apply settings KEY=VALUE.

    Raises:
        SceneError: it does not exist, or is not valid.
        SettingError: a setting makes no sense.
    """
    try:
        scene = sim.load_scene(name)
    except SceneError:
        if _is_log(Path(name)):
            raise SceneError(
                f"{name}: this is a log and no scene; `softrod run` and `softrod export` take it by --inputs"
            ) from None
        raise
    return apply_assignments(scene, settings)


def _is_log(path: Path) -> bool:
    from .session.log import is_log

    try:
        return path.is_file() and is_log(path.read_bytes())
    except (OSError, ValueError):  # not a possible file name, or not readable
        return False


def fail(reason: object) -> int:
    """Print the reason on the error stream; the exit status, 1."""
    print(f"softrod: {reason}", file=sys.stderr)
    return 1
