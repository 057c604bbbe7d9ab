"""What a browser stores of a page's session, to continue after a reload or a restart of the server."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

import sim
from sim.errors import SceneError
from sim.scene.numbers import MAX_SPRINGS
from sim.settings import CHOICES
from sim.solve.registry import METHODS
from sim.store.files import MAX_FILE_BYTES, decode_scene
from sim.store.places import sentence_of_json

from ..stage.looks import SPEEDS
from . import log
from .ghost import FINER, REFERENCE

FORMAT, VERSION = "softrod-keepsake", 1

MAX_BYTES = 1_000_000
"""A larger one leaves out the scene as it was opened, and then also the motion: the scene starts again."""


class Second(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The settings of the second body; see `Ghost`."""

    method: Annotated[str, Meta(max_length=60)]
    law: Annotated[str, Meta(max_length=60)] = ""
    finer: int = 1


class Choices(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What the user had chosen apart from the scene; browsers store its fields by these names.

    Attributes:
        playing: whether the clock ran.
        speed: simulated seconds per second.
        follow: whether the driven mass followed the pointer.
        joint: the angular spring that was read out.
        ghost: the second body, if there was one.
        foretell: whether the growth of errors was measured.
        touched: whether anything had been done to the body by hand.
    """

    playing: bool = True
    speed: Annotated[float, Meta(ge=SPEEDS[0], le=SPEEDS[-1])] = 1.0
    follow: bool = False
    joint: Annotated[int, Meta(ge=0, lt=MAX_SPRINGS)] = 0
    ghost: Second | None = None
    foretell: bool = False
    touched: bool = False


_NOTHING = msgspec.Raw()


class _File(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, omit_defaults=True):
    format: Literal["softrod-keepsake"]
    version: Annotated[int, Meta(ge=1)]
    scene: msgspec.Raw
    moment: log.Restore | None
    wishes: Choices
    opened: msgspec.Raw = _NOTHING
    lesson_base: msgspec.Raw = _NOTHING


@dataclass(frozen=True)
class Keepsake:
    """The contents of a keepsake.

    Attributes:
        moment: state of the body.
        choices: of its user.
        opened: the scene as it was opened; if that was left out, as it was last.
        lesson_base: what the steps of its lesson begin from; likewise.
    """

    moment: sim.Moment
    choices: Choices
    opened: sim.Scene
    lesson_base: sim.Scene


def encode(moment: sim.Moment, choices: Choices, opened: sim.Scene, lesson_base: sim.Scene) -> bytes:
    """Write a keepsake; see `Keepsake`."""
    scene = log.raw_scene(moment.scene)
    there = log.restore_entry(moment, with_scene=False)
    keepsake = _File(format=FORMAT, version=VERSION, scene=scene, moment=there, wishes=choices)
    if opened is not moment.scene:
        keepsake = msgspec.structs.replace(keepsake, opened=log.raw_scene(opened))
    if lesson_base is not opened:
        keepsake = msgspec.structs.replace(keepsake, lesson_base=log.raw_scene(lesson_base))
    data = msgspec.json.encode(keepsake)
    for left_out in ({"lesson_base": _NOTHING}, {"opened": _NOTHING}, {"moment": None}):
        if len(data) > MAX_BYTES:
            keepsake = msgspec.structs.replace(keepsake, **left_out)
            data = msgspec.json.encode(keepsake)
    return data


def decode(data: bytes) -> Keepsake:
    """Read a keepsake; nothing in it is trusted.

    Raises:
        SceneError: one sentence that says what is wrong.
    """
    if len(data) > MAX_BYTES + MAX_FILE_BYTES:
        raise SceneError(f"{len(data)} bytes are more than a keepsake may have")
    try:
        keepsake = msgspec.json.decode(data, type=_File)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise SceneError(sentence_of_json(error, data, _File)) from None
    if keepsake.version > VERSION:
        raise SceneError(f"version {keepsake.version} is newer than {VERSION}; a newer softrod can read it")
    scene = decode_scene(bytes(keepsake.scene), "scene", places=False)
    choices, ghost = keepsake.wishes, keepsake.wishes.ghost
    if ghost is not None:
        laws = {"", *CHOICES["force_law"].options}
        if ghost.method not in {REFERENCE, *METHODS} or ghost.law not in laws or ghost.finer not in FINER:
            raise SceneError(f"ghost: there is no {ghost.method!r} with law {ghost.law!r} / {ghost.finer}")
    opened = decode_scene(bytes(keepsake.opened), "scene", places=False) if bytes(keepsake.opened) else scene
    base = bytes(keepsake.lesson_base)
    lesson_base = decode_scene(base, "scene", places=False) if base else opened
    if keepsake.moment is None:
        return Keepsake(sim.Simulation(scene, wait=False).capture(), choices, opened, lesson_base)
    return Keepsake(log.moment_of(keepsake.moment, scene), choices, opened, lesson_base)
