"""The zip that a teacher takes home from a class: its scenes, all answers, and the runs."""

from __future__ import annotations

import io
import math
import re
import zipfile
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from sim.errors import InputError, SettingError
from sim.settings import scene_of_step
from sim.store.csv_text import csv_text
from sim.store.files import encode_scene

from ..export.clip import ClipFrame
from ..export.picture import png
from ..stage.plan import Picture
from ..words import say
from ..words.keys import Key
from ..words.spoken import has_decimal_comma
from .answers import Answer, Prediction, Work, doubt_text
from .axes import axes_of
from .kept import LOGS, log_path
from .room import Room

PICTURES = "pictures"
"""Folder in the zip with pictures of the runs' last moments."""

PICTURE_SIZE = (640, 480)
"""Width and height of these, pixels."""

ANSWERS: tuple[Key, ...] = (
    "zip-step", "zip-title", "zip-asked", "zip-seat", "zip-name", "zip-pupil", "zip-kind", "zip-answer",
    "zip-right", "zip-late", "zip-starred",
)  # fmt: skip
"""The columns of `answers.csv`."""

FOUND: tuple[Key, ...] = (
    "zip-step", "zip-seat", "zip-name", "zip-pupil", "zip-over", "zip-over-unit", "zip-setting", "zip-what",
    "zip-unit", "zip-found", "zip-doubt",
)  # fmt: skip
"""The columns of `found.csv`."""

PREDICTIONS: tuple[Key, ...] = (
    "zip-step", "zip-asked", "zip-seat", "zip-name", "zip-pupil", "zip-mass", "zip-x", "zip-y", "zip-late",
)  # fmt: skip
"""The columns of `predictions.csv`."""


def pack(room: Room, logs: Mapping[str, bytes] | None = None) -> bytes:
    """Make the zip, in the language that is spoken now; its pictures take about 30 ms each.

    Args:
        room: of the class, which may be running.
        logs: of the runs that are not on the disk yet, by their names.
    """
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("README.txt", _readme(room))
        file.writestr("answers.csv", _table(_answers(room)))
        file.writestr("found.csv", _table(_found(room)))
        file.writestr("predictions.csv", _table(_predictions(room)))
        for i, scene in enumerate(room.scenes, start=1):
            file.writestr(f"scenes/{i:02}-{_slug(scene.name)}.json", encode_scene(scene))
        for answer in _in_order(room):
            if not isinstance(answer.content, Work):
                continue
            twin = "-2" if answer.twin else ""
            seat = f"{answer.seat:02}-{_slug(room.seats[answer.seat].name)}{twin}"
            name = f"step-{answer.stop + 1:02}-{seat}"
            if (log := _log_of(answer.content, room.code, logs or {})) is not None:
                file.writestr(f"{LOGS}/{name}.jsonl", log)
            if (picture := _picture(answer.content, room, answer.stop)) is not None:
                file.writestr(f"{PICTURES}/{name}.png", picture)
    return made.getvalue()


def _readme(room: Room) -> str:
    seats = [seat for seat in room.seats.values() if not seat.removed]
    typed = any(seat.name != seat.given for seat in seats)
    names = say("zip-typed-names") if typed else say("zip-given-names")
    return say("zip-readme", steps=len(room.stops), seats=len(seats), names=names) + "\n"


def _log_of(work: Work, code: str, unwritten: Mapping[str, bytes]) -> bytes | None:
    """Return the log of a run that was handed in; None if it is gone."""
    if work.log in unwritten:
        return unwritten[work.log]
    try:
        return log_path(code, work.log).read_bytes() if work.log else None
    except FileNotFoundError:  # another run has replaced it
        return None


def _picture(work: Work, room: Room, stop: int) -> bytes | None:
    """Draw a body as it was handed in, as a PNG; None if it cannot be drawn."""
    place = room.stops[stop]
    scene = room.scenes[place.scene]
    try:
        scene = scene if place.step is None else scene_of_step(scene, place.step)
        if len(work.points) != len(scene.masses):  # the teacher has given another body
            return None
        return png(ClipFrame(scene, Picture(np.array(work.points), damage=work.damage)), PICTURE_SIZE)
    except (InputError, SettingError):
        return None


def _in_order(room: Room) -> list[Answer]:
    return sorted(room.answers.values(), key=lambda a: (a.stop, a.round, a.seat, a.twin))


def _answers(room: Room) -> Iterable[Sequence[str | float]]:
    yield [say(key) for key in ANSWERS]
    for a in _in_order(room):
        if (cells := a.content.cells(room.step_at(a.stop))) is None:
            continue
        kind, text, right = cells
        right = "" if right is None else _yes(right)
        asked = a.stop + 1, room.title(a.stop), a.round + 1
        whose = a.seat, room.seats[a.seat].name, a.twin + 1
        yield *asked, *whose, kind, text, right, _yes(a.late), _yes(a.starred)


def _found(room: Room) -> Iterable[Sequence[str | float]]:
    """Yield the points of the class's plots, and their axes."""
    yield [say(key) for key in FOUND]
    for a in _in_order(room):
        if isinstance(work := a.content, Work) and work.found is not None:
            axes, setting = axes_of(room, a.stop), "" if work.setting is None else work.setting
            whose = a.stop + 1, a.seat, room.seats[a.seat].name, a.twin + 1
            over, what = (axes.over, axes.over_unit), (axes.what, axes.unit)
            yield *whose, *over, setting, *what, work.found, doubt_text(work.doubt)


def _predictions(room: Room) -> Iterable[Sequence[str | float]]:
    yield [say(key) for key in PREDICTIONS]
    for a in _in_order(room):
        if isinstance(a.content, Prediction):
            for mass, (x, y) in enumerate(a.content.points):
                whose = a.stop + 1, a.round + 1, a.seat, room.seats[a.seat].name, a.twin + 1
                yield *whose, mass, x, y, _yes(a.late)


def _slug(text: str) -> str:
    """Return a text that can be part of a file's name."""
    return re.sub(r"[^\w-]+", "-", text).strip("-")[:40] or "unnamed"


def _yes(on: bool) -> str:
    return say("zip-yes") if on else say("zip-no")


def _table(rows: Iterable[Sequence[str | float]]) -> str:
    """CSV as spreadsheets of the language read it, in UTF-8 with the mark by which they know that.

    A number that is not finite is left out.
    """
    return "\ufeff" + csv_text((map(_finite, row) for row in rows), has_decimal_comma(), "{:.6g}".format)


def _finite(cell: str | float) -> str | float | None:
    return None if isinstance(cell, float) and not math.isfinite(cell) else cell
